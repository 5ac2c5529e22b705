// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/workflow/calibration_media.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct RegisterSettings
{
    std::string camera;
    std::string layout;
    std::filesystem::path pixelsFile; ///< label,u,v; or empty
    std::filesystem::path pictureFile; ///< a picture or video in which the markers are looked for, or (with pixelsFile)
                                       ///< which tells the picture's size to a camera without intrinsics; or empty
    std::vector<MarkerPixel> pixels;  ///< picked in a window; instead of pixelsFile
    StoredPicture picture = {};       ///< in which the pixels were picked, where the project has it already
    std::vector<MarkerPixel> hints = {};   ///< markers told by hand, to find the others in the picture (MarkerSearch)
};

/// Registers one camera to the floor by the markers of a layout and stores the registration as its newest one, with the
/// picture in which the markers were seen.
/// Without a picture to look in, the markers are looked for in the camera's newest recording.
class RegisterJob : public Job
{
public:
    explicit RegisterJob(RegisterSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const RegisterSettings &settings() const { return m_settings; }
    const RegistrationRecord &record() const { return m_record; } ///< after run

private:
    Result<void> findInPictures(const JobControl &control);
    Result<CameraModel> cameraModel() const;
    Result<void> keepPicture();

    RegisterSettings m_settings;
    MarkerLayout m_layout;
    bool m_intrinsicsKnown = false;
    Intrinsics m_intrinsics; ///< stored ones, or only the picture's size
    std::optional<Frame> m_seenIn; ///< the picture that the markers were found in
    std::filesystem::path m_mediaFolder;
    std::unique_ptr<CalibrationMedia> m_media;
    RegistrationRecord m_record;
};

/// Registers a camera anew by the pixels and the layout of its registration in force, with the intrinsics in force: what a
/// newer calibration of the lens makes of the same markers, also of a camera that is long gone. NotFound where it is not
/// registered; InvalidInput where the registration was made with those intrinsics, or through another camera. What the last check
/// found stays. Quick.
Result<RegistrationRecord> registerWithLensInForce(Project &project, const std::string &camera);

} // namespace odo
