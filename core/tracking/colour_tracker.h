// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/tracking/observation.h"
#include "core/tracking/searched_area.h"
#include "core/video/frame.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace odo {

/// A robot as a tracker needs to know it.
struct TrackTarget
{
    std::string name;
    std::optional<RgbColour> colour; ///< none: of any look
    /// measured by its silhouette; its colour, if it has one, shows which silhouette is its own
    bool wholeOutline = false;
};

/// Where a robot is in a frame, by a person: it is followed from there on, whatever was followed before.
struct RobotSeed
{
    std::size_t target = 0;                          ///< its number
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< in it; luma pixels
};

/// Whether a colour with chroma is given: black, grey and white have none, and such robots are found like
/// those of any look.
bool isFoundByColour(const TrackTarget &target);

/// Follows one or more coloured robots through the frames of one view, on the chroma planes as decoded. The
/// given colour only has to be near what the camera shows: each robot's own look is learned when it is first
/// found, as distinct from the background and the other robots, and followed through changes of light. Feed
/// every frame in order. Not thread-safe; one tracker a view.
class ColourTracker
{
public:
    /// InvalidInput when there is no target, or one without a colour or of one without chroma (black, grey,
    /// white), of which the chroma planes show nothing. area: where in the frames robots are searched.
    static Result<std::unique_ptr<ColourTracker>> create(std::vector<TrackTarget> targets,
                                                         SearchedArea area = {});
    ~ColourTracker();
    ColourTracker(const ColourTracker &) = delete;
    ColourTracker &operator=(const ColourTracker &) = delete;

    /// The part of the next frame, if it is shown at this time, that track() expects to read; nullopt for all
    /// of it (while a robot is searched, and now and then to learn the background). It may reach beyond the
    /// frame.
    std::optional<PixelRect> neededRegion(Nanoseconds time) const;

    /// One observation a target, in the order given. The rest of a frame that was decoded in part is decoded
    /// when it is needed, so that the observations are those of the whole frame. A frame that repeats the one
    /// before it gives the same observations again, marked as such. A frame of another size or format than
    /// the one before it restarts the search. A seed where nothing has the robot's colour has no effect.
    std::vector<Observation> track(const Frame &frame, std::span<const RobotSeed> seeds = {});

    /// Of each target, the share of the first frame that looks like its given colour, 0 to 1: where it is
    /// larger than any robot could be, the floor has that colour too. Empty before that.
    const std::vector<double> &sharesAlike() const;

private:
    struct Impl;
    explicit ColourTracker(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
