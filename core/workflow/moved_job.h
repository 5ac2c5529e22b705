// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/moved_check.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <optional>
#include <string>

namespace odo {

struct MovedSettings
{
    std::string camera;
    std::filesystem::path pictureFile; ///< a picture or video of the camera as it stands now; or empty:
    std::optional<Frame> frame;        ///< the same, from a live camera
};

/// Looks whether a camera still stands where it was registered, by its markers in a newer picture. Stores nothing.
/// NotFound where the camera is not registered, Undetermined where fewer than two markers are found again.
class MovedJob : public Job
{
public:
    explicit MovedJob(MovedSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const MovedCheck &check() const { return m_check; } ///< after run

private:
    Result<Frame> picture() const;

    MovedSettings m_settings;
    std::optional<FloorView> m_view;
    MarkerLayout m_layout;
    std::vector<MarkerPixel> m_stored;
    double m_fitPx = 0;
    MovedCheck m_check;
};

} // namespace odo
