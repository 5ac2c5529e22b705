// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/registration_checks.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <optional>
#include <string>

namespace odo {

struct CameraPositionSettings
{
    std::string camera;
    std::filesystem::path imageFile; ///< a current image or video from the camera; or empty:
    std::string liveUri;             ///< address of the camera that takes it now
};

/// Checks whether a camera has moved since its registration, by its markers in a newer image, and keeps the
/// outcome with the registration. NotFound where the camera is not registered, Undetermined where fewer than
/// two markers are found again (see keepUndetermined).
class CameraPositionJob : public Job
{
public:
    explicit CameraPositionJob(CameraPositionSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const CameraPositionCheck &check() const { return m_check; } ///< after run

private:
    Result<Frame> image(const JobControl &control) const;

    CameraPositionSettings m_settings;
    RecordId m_registration = 0;
    std::optional<FloorView> m_view;
    MarkerLayout m_layout;
    std::vector<MarkerPixel> m_stored;
    double m_fitPx = 0;
    CameraPositionCheck m_check;
};

/// Keeps with a camera's current registration that its movement could not be determined: the failure of
/// CameraPositionJob.
Result<void> keepUndetermined(Project &project, const std::string &camera, const Error &error);

} // namespace odo
