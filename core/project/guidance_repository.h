// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace odo {

struct ProjectConnection;

/// One thing that a person gives the tracker of a recording.
struct GuidanceItem
{
    enum class Kind {
        Ignore, ///< an area whose content is no evidence
        Search, ///< an area outside of which nothing is; of several, each
        Point,  ///< where a robot is in a frame, set by hand
        Hidden  ///< frames in which a robot is not visible
    };
    RecordId id = 0;
    RecordId recording = 0;
    RecordId robot = 0; ///< of Point and Hidden; 0: of the view
    Kind kind = Kind::Ignore;
    std::int64_t fromFrame = 0, toFrame = 0; ///< of Point and Hidden, both inside
    std::vector<Eigen::Vector2d> pointsPx;   ///< corners, or the point; luma pixels of upright frames
    double sigmaPx = 0;                      ///< of a Point, in each direction

    bool operator==(const GuidanceItem &) const = default;
};

/// How the note begins of observations that were corrected by hand (ObservationSeries::algorithm).
inline constexpr const char *handNote = "; by hand ";

/// What is refused where it is given: corners of an area, and items of a recording.
constexpr std::size_t mostAreaCorners = 100, mostGuidanceItems = 10'000;

/// What guides the tracker in the trials of a project. Plain synchronous calls on the project's thread, as
/// those of repositories.h.
class GuidanceRepository
{
public:
    explicit GuidanceRepository(ProjectConnection &connection);
    /// Gives it with its id. InvalidInput for an area of fewer than three or too many corners, a point
    /// without σ, frames in the wrong order, a position that is no number, and one item too many.
    Result<GuidanceItem> add(const GuidanceItem &item);
    /// NotFound for an id that is not there.
    Result<void> remove(RecordId item);
    /// Of all recordings of a trial, in the order in which they were given.
    Result<std::vector<GuidanceItem>> of(RecordId trial) const;

private:
    ProjectConnection &m_connection;
};

} // namespace odo
