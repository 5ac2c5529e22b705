// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_detection.h"

#include "core/calibration/charuco_detection.h"
#include "core/calibration/checkerboard_detection.h"
#include "core/calibration/luma_matrix.h"

#include <opencv2/core.hpp>

namespace odo {

tl::unexpected<Error> refuseBoard(const std::string &source, std::string why, std::string advice)
{
    return fail(ErrorCode::Undetermined, source, std::move(why), std::move(advice));
}

Result<BoardView> findBoard(const Frame &frame, const BoardSpec &spec, const std::string &source)
{
    if (frame.y.data == nullptr || frame.y.width < 32 || frame.y.height < 32)
        return fail(ErrorCode::Undetermined, source, "the picture is too small to hold a board",
                    "use a picture of the camera");
    const bool told = spec.columns != 0 || spec.rows != 0;
    if (told && (spec.columns < 3 || spec.rows < 3))
        return fail(ErrorCode::InvalidInput, source,
                    "a board of " + std::to_string(spec.columns) + "x" + std::to_string(spec.rows) +
                        " inner corners is too small",
                    "give 3x3 at least, like 9x6, or leave the size out");
    if (!(spec.squareM > 0))
        return fail(ErrorCode::InvalidInput, source, "the squares have no size", "give it like 25mm");
    try {
        const cv::Mat luma = lumaMatrix(frame);
        if (spec.pattern == BoardPattern::Checkerboard)
            return findCheckerboard(luma, spec, source);
        auto charuco = findCharucoBoard(luma, spec, source);
        if (charuco || spec.pattern)
            return charuco;
        return findCheckerboard(luma, spec, source);
    } catch (const cv::Exception &exception) {
        return fail(ErrorCode::Internal, source, exception.what(), "use another picture");
    }
}

} // namespace odo
