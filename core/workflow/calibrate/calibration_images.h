// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/files/temporary.h"
#include "core/project/records.h"
#include "core/video/frame.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace odo {

/// An image of a board to be stored in the project.
struct BoardImage
{
    std::string source;             ///< as BoardView::source
    std::vector<unsigned char> png; ///< grey
};

/// Writes images into "<name>.media/calibration". What was written is removed again by the destructor unless
/// it is kept, so that a calibration or registration that cannot be stored leaves nothing. At most 200 MB a
/// calibration: what is beyond is not kept, its corners are.
class CalibrationMedia
{
public:
    explicit CalibrationMedia(const std::filesystem::path &mediaFolder);
    ~CalibrationMedia();
    CalibrationMedia(const CalibrationMedia &) = delete;
    CalibrationMedia &operator=(const CalibrationMedia &) = delete;

    /// Whole and on the disk when it returns. An empty path where the limit is reached. Error Io.
    Result<StoredImage> write(const std::string &name, const std::vector<unsigned char> &png);
    /// A camera's image of the floor, in colour. Long. Error Io.
    Result<StoredImage> writeFloor(const std::string &camera, const Frame &frame);
    void keep();

private:
    std::filesystem::path m_mediaFolder, m_folder;
    std::vector<ClaimedFile> m_files; ///< that are not kept
    std::size_t m_bytes = 0;
};

/// By its first bytes, or by the ending of its name where those are of no kind that is known.
bool isStillImage(const std::filesystem::path &file);

/// One image of a file, whole: of a video the frame of this index, of a still its only one. Errors: neither
/// an image nor a video; NotFound for a frame that it does not have.
Result<Frame> imageOf(const std::filesystem::path &file, std::int64_t frame);

/// Gives the images of a file one after another, named "file" or "file@frame": one for a still, every step-th
/// for a video, each upright. Stops early when visit returns false. Errors: neither an
/// image nor a video; Cancelled.
Result<void> visitImages(const std::filesystem::path &file, int videoStep,
                         const std::function<bool(const Frame &, const std::string &)> &visit,
                         const CancelToken &cancel);

/// The progress message of a job that detects markers in such an image.
Message detectingMarkersIn(const std::string &name);

} // namespace odo
