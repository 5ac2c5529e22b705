// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/workflow/calibration_media.h"

namespace odo {

class Project;

/// A lens that was measured from a board, on its way to be its camera's newest intrinsics: first its pictures, which takes
/// long, then its rows. Unless it is committed, its destructor leaves nothing behind.
class CalibrationStorage
{
public:
    /// board: as it was found out.
    CalibrationStorage(const std::filesystem::path &mediaFolder, std::string camera, IntrinsicCalibration calibration,
                       const BoardSpec &board);

    /// Writes each picture beside the project that has the source of one of the calibration's. Any thread; long. Errors: Io,
    /// Cancelled.
    Result<void> writePictures(const std::vector<BoardPicture> &pictures, const JobControl &control);
    /// The rows, in one transaction; the camera is made when there is none of that name. The project's thread. Once.
    Result<IntrinsicsRecord> commit(Project &project);

private:
    CalibrationMedia m_media;
    const std::string m_camera;
    IntrinsicsRecord m_record;
};

} // namespace odo
