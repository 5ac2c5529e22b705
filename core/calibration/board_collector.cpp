// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_collector.h"

#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double mostObliqueDegrees = 65;
constexpr double leastSize = 0.1;
constexpr double leastNews = 0.2; // as ROS's camera_calibration asks of a new image
constexpr Nanoseconds stillFor = std::chrono::milliseconds(500);
constexpr double stillPart = 0.004; // of the image's width
constexpr double sharpOfSpacing = 0.25;

Error refusal(const std::string &source, Message why, Message advice)
{
    return {ErrorCode::Undetermined, nameAlone(source), std::move(why), std::move(advice)};
}

Error refusedAsKnown(const std::string &source, Message standsAsBefore)
{
    return refusal(source, std::move(standsAsBefore),
                   ODO_TEXT("calibration.move_board", "move it elsewhere, turn it or tilt it"));
}

std::optional<Error> faultOf(const CollectedImage &image)
{
    const std::string &source = image.view.source;
    if (image.placement.angleDegrees() > mostObliqueDegrees)
        return refusal(
            source,
            ODO_TEXT("calibration.board_too_oblique", "the board is tilted too far, by %1 degrees")(
                quantity(image.placement.angleDegrees(), 0)),
            ODO_TEXT("calibration.tilt_less", "tilt it by 30 to 45 degrees"));
    if (image.placement.size < leastSize)
        return refusal(source,
                       joined({ODO_TEXT("calibration.board_too_small", "the board is too small"),
                               ODO_TEXT("calibration.board_fills", "it fills %1 of the image")(
                                   quantity(100 * image.placement.size * image.placement.size, 0, "%"))},
                              Join::Colon),
                       ODO_TEXT("calibration.hold_board_closer", "hold it closer to the camera"));
    return std::nullopt;
}

/// Mean distance of neighbouring corners, by the outline.
double spacingPx(const CollectedImage &image)
{
    const auto &outline = image.placement.outline;
    const double around = (outline[1] - outline[0]).norm() + (outline[2] - outline[1]).norm() +
                          (outline[3] - outline[2]).norm() + (outline[0] - outline[3]).norm();
    return around / (2 * std::max(1, image.view.columns + image.view.rows - 2));
}

} // namespace

ImageVerdict BoardCollector::examine(const Frame &frame, const std::string &source)
{
    ImageVerdict answer;
    if (m_widthPx == 0) {
        m_widthPx = frame.format.width;
        m_heightPx = frame.format.height;
    }
    if (frame.format.width != m_widthPx || frame.format.height != m_heightPx) {
        answer.refusal =
            refusal(source, otherSizeThanMost(frame.format.width, frame.format.height, m_widthPx, m_heightPx),
                    ODO_TEXT("calibration.use_one_resolution", "use images of one camera at one resolution"));
        return answer;
    }
    auto view = findBoard(frame, m_spec, source);
    if (!view) {
        answer.refusal = view.error();
        return answer;
    }
    const auto placement = placementOf(*view, m_widthPx, m_heightPx);
    if (!placement) {
        answer.refusal =
            refusal(source, ODO_TEXT("calibration.board_not_flat", "the corners do not match a flat board"),
                    ODO_TEXT("calibration.glue_board_flat", "glue the board onto something stiff and flat"));
        return answer;
    }
    answer.image = CollectedImage{std::move(*view), *placement};
    answer.refusal = faultOf(*answer.image);
    return answer;
}

void BoardCollector::keep(const CollectedImage &image)
{
    m_spec.pattern = image.view.pattern;
    m_spec.columns = image.view.columns;
    m_spec.rows = image.view.rows;
    m_images.push_back(image);
}

const CollectedImage *BoardCollector::sameAs(const CollectedImage &image) const
{
    const auto same = std::ranges::find_if(m_images, [&](const CollectedImage &there) {
        return distanceOf(there.placement, image.placement) < leastNews;
    });
    return same == m_images.end() ? nullptr : &*same;
}

ImageVerdict BoardCollector::offer(const Frame &frame, const std::string &source)
{
    ImageVerdict answer = examine(frame, source);
    if (!answer.image || answer.refusal)
        return answer;
    if (const CollectedImage *known = sameAs(*answer.image)) {
        answer.refusal = refusedAsKnown(source, sameBoardPosition(known->view.source));
        return answer;
    }
    keep(*answer.image);
    answer.kept = true;
    return answer;
}

bool BoardCollector::isStill(const CollectedImage &image, Nanoseconds time)
{
    const std::vector<Eigen::Vector2d> &corners = image.view.pixels;
    double moved = corners.size() == m_stillCorners.size() ? 0 : HUGE_VAL;
    for (std::size_t i = 0; i < corners.size() && moved < HUGE_VAL; ++i)
        moved = std::max(moved, (corners[i] - m_stillCorners[i]).norm());
    if (moved > stillPart * m_widthPx) {
        m_stillCorners = corners;
        m_stillSince = time;
    }
    return time - m_stillSince >= stillFor;
}

ImageVerdict BoardCollector::watch(const Frame &frame, const std::string &source)
{
    ImageVerdict answer = examine(frame, source);
    if (!answer.image || answer.refusal)
        return answer;
    const bool still = isStill(*answer.image, frame.time);
    if (sameAs(*answer.image)) {
        answer.refusal =
            refusedAsKnown(source, ODO_TEXT("calibration.board_stands_as_before",
                                            "the board is in the same position as in an earlier image"));
        return answer;
    }
    if (!still)
        return answer;
    if (answer.image->view.edgeWidthPx > sharpOfSpacing * spacingPx(*answer.image)) {
        answer.refusal =
            refusal(source,
                    joined({ODO_TEXT("calibration.board_not_sharp", "the board is not sharp"),
                            edgesAreWide(answer.image->view.edgeWidthPx)},
                           Join::Colon),
                    ODO_TEXT("calibration.focus_or_light", "focus the camera, or give more light"));
        return answer;
    }
    keep(*answer.image);
    answer.kept = true;
    return answer;
}

std::vector<BoardView> BoardCollector::views() const
{
    std::vector<BoardView> views;
    for (const CollectedImage &image : m_images)
        views.push_back(image.view);
    return views;
}

CollectedImage BoardCollector::remove(std::size_t index)
{
    CollectedImage image = std::move(m_images.at(index));
    m_images.erase(m_images.begin() + static_cast<std::ptrdiff_t>(index));
    return image;
}

void BoardCollector::insert(std::size_t index, CollectedImage image)
{
    const std::size_t at = std::min(index, m_images.size());
    m_images.insert(m_images.begin() + static_cast<std::ptrdiff_t>(at), std::move(image));
}

BoardCoverage BoardCollector::coverage() const
{
    std::vector<BoardPlacement> placements;
    for (const CollectedImage &image : m_images)
        placements.push_back(image.placement);
    return coverageOf(views(), placements, m_widthPx, m_heightPx);
}

} // namespace odo
