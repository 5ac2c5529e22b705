// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/board_detection.h"
#include "core/project/records.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// What the errors of a camera's calibration are about.
Message calibrationOf(const std::string &camera);

/// Intrinsics from a board that become their camera's newest: first the images, a long step, then the rows.
/// Unless it is committed, its destructor leaves nothing behind.
class CalibrationStorage
{
public:
    /// board: as it was found out.
    CalibrationStorage(const std::filesystem::path &mediaFolder, std::string camera,
                       IntrinsicCalibration calibration, const BoardSpec &board);

    /// Writes each image beside the project that has the source of one of the calibration's. Any thread;
    /// long. Errors: Io, Cancelled.
    Result<void> writeImages(const std::vector<BoardImage> &images, const JobControl &control);
    /// The rows, in one transaction; the camera is made when there is none of that name. The project's
    /// thread. Once.
    Result<IntrinsicsRecord> commit(Project &project);

private:
    CalibrationMedia m_media;
    const std::string m_camera;
    IntrinsicsRecord m_record;
};

struct CalibrateSettings
{
    std::string camera;                       ///< made when the project has none of that name
    std::vector<std::filesystem::path> files; ///< images and videos of the board
    BoardSpec board;
    std::optional<LensModel> model; ///< nullopt: the one that predicts best
};

/// Finds the board in images, computes a camera's intrinsics and stores them as its newest ones. Of a video
/// it takes two frames a second at 30 frames/s, until the board was in sixty positions. An image that shows
/// the board in the same position as one before is not kept, only its corners.
class CalibrateJob : public Job
{
public:
    explicit CalibrateJob(CalibrateSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const CalibrateSettings &settings() const { return m_settings; }
    const IntrinsicCalibration &calibration() const { return m_calibration; } ///< after run

private:
    Result<void> searchFile(const std::filesystem::path &file, const JobControl &control);
    void searchImage(const Frame &frame, const std::string &name);

    CalibrateSettings m_settings;
    std::vector<BoardView> m_views;
    std::vector<std::size_t> m_positions; ///< views that repeat none before them
    std::vector<BoardImage> m_images;     ///< of those
    std::vector<RejectedImage> m_rejected;
    int m_widthPx = 0, m_heightPx = 0;
    IntrinsicCalibration m_calibration;
    std::filesystem::path m_mediaFolder;
    std::unique_ptr<CalibrationStorage> m_storage;
};

} // namespace odo
