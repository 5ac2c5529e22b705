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

/// Finds the board in images, computes a camera's intrinsics and stores them as its newest ones. What the
/// board is, how large the images are and which way up they are, most of the images decide; the others are
/// searched again for that board, turned, or named with the reason. Of a video it takes the sharpest frame of
/// each quarter of a second, and of those the sixty that differ most in position and tilt. An image that
/// shows the board in the same position as one before is not kept, only its corners.
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
    /// An image that was read, with its board or the reason why it has none.
    struct Searched
    {
        std::string name;
        std::filesystem::path still; ///< empty: a frame of a video
        int widthPx = 0, heightPx = 0, orientation = 1;
        std::optional<BoardView> view;
        Message reason;
    };

    Result<void> searchFile(const std::filesystem::path &file, const JobControl &control);
    void searchClip(const std::filesystem::path &file, std::size_t first);
    void searchImage(const Frame &frame, const std::string &name, const std::filesystem::path &still);
    void take(Searched &image, const Frame &frame, Result<BoardView> view);
    void searchAgain(Searched &image, const BoardSpec &spec, int orientation);
    void settle(const JobControl &control);
    void settleOrientation(const JobControl &control);
    void settleSize();
    void settleBoard(const JobControl &control);
    void collect();
    std::vector<BoardView> viewsOfSize() const;
    Error noBoard() const;

    CalibrateSettings m_settings;
    std::vector<Searched> m_searched;
    std::vector<RejectedImage> m_rejected; ///< what could not be read, and frames of videos by reason
    std::vector<BoardView> m_views;
    std::vector<BoardImage>
        m_images; ///< of the views that repeat no position before them, and of some others
    int m_widthPx = 0, m_heightPx = 0;
    IntrinsicCalibration m_calibration;
    std::filesystem::path m_mediaFolder;
    std::unique_ptr<CalibrationStorage> m_storage;
};

} // namespace odo
