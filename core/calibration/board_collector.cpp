// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_collector.h"

#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double mostObliqueDegrees = 65;
constexpr double leastSize = 0.1;
constexpr double leastNews = 0.2; // as ROS's camera_calibration asks of a new picture
constexpr Nanoseconds stillFor = std::chrono::milliseconds(500);
constexpr double stillPart = 0.004; // of the picture's width
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

std::optional<Error> faultOf(const CollectedPicture &picture)
{
    const std::string &source = picture.view.source;
    if (picture.placement.angleDegrees() > mostObliqueDegrees)
        return refusal(
            source,
            ODO_TEXT("calibration.board_too_oblique", "the board is seen too obliquely, at %1 degrees")(
                quantity(picture.placement.angleDegrees(), 0)),
            ODO_TEXT("calibration.tilt_less", "tilt it by 30 to 45 degrees"));
    if (picture.placement.size < leastSize)
        return refusal(source,
                       joined({ODO_TEXT("calibration.board_too_small", "the board is too small"),
                               ODO_TEXT("calibration.board_fills", "it fills %1 of the picture")(
                                   quantity(100 * picture.placement.size * picture.placement.size, 0, "%"))},
                              Join::Colon),
                       ODO_TEXT("calibration.hold_board_closer", "hold it closer to the camera"));
    return std::nullopt;
}

/// Mean distance of neighbouring corners, by the outline.
double spacingPx(const CollectedPicture &picture)
{
    const auto &outline = picture.placement.outline;
    const double around = (outline[1] - outline[0]).norm() + (outline[2] - outline[1]).norm() +
                          (outline[3] - outline[2]).norm() + (outline[0] - outline[3]).norm();
    return around / (2 * std::max(1, picture.view.columns + picture.view.rows - 2));
}

} // namespace

PictureAnswer BoardCollector::look(const Frame &frame, const std::string &source)
{
    PictureAnswer answer;
    if (m_widthPx == 0) {
        m_widthPx = frame.format.width;
        m_heightPx = frame.format.height;
    }
    if (frame.format.width != m_widthPx || frame.format.height != m_heightPx) {
        answer.refusal = refusal(
            source, otherSizeThanFirst(frame.format, m_widthPx, m_heightPx),
            ODO_TEXT("calibration.use_one_resolution", "use pictures of one camera at one resolution"));
        return answer;
    }
    auto view = findBoard(frame, m_spec, source);
    if (!view) {
        answer.refusal = view.error();
        return answer;
    }
    const auto placement = placementOf(*view, m_widthPx, m_heightPx);
    if (!placement) {
        answer.refusal = refusal(
            source, ODO_TEXT("calibration.board_not_flat", "the corners do not lie as on a flat board"),
            ODO_TEXT("calibration.glue_board_flat", "glue the board onto something stiff and flat"));
        return answer;
    }
    answer.picture = CollectedPicture{std::move(*view), *placement};
    answer.refusal = faultOf(*answer.picture);
    return answer;
}

void BoardCollector::keep(const CollectedPicture &picture)
{
    m_spec.pattern = picture.view.pattern;
    m_spec.columns = picture.view.columns;
    m_spec.rows = picture.view.rows;
    m_pictures.push_back(picture);
}

PictureAnswer BoardCollector::offer(const Frame &frame, const std::string &source)
{
    PictureAnswer answer = look(frame, source);
    if (!answer.picture || answer.refusal)
        return answer;
    for (const CollectedPicture &there : m_pictures) {
        if (distanceOf(there.placement, answer.picture->placement) >= leastNews)
            continue;
        answer.refusal =
            refusedAsKnown(source, ODO_TEXT("calibration.board_stands_as_in",
                                            "the board stands as in %1 already")(there.view.source));
        return answer;
    }
    keep(*answer.picture);
    answer.kept = true;
    return answer;
}

bool BoardCollector::isStill(const CollectedPicture &picture, Nanoseconds time)
{
    const std::vector<Eigen::Vector2d> &corners = picture.view.pixels;
    double moved = corners.size() == m_stillCorners.size() ? 0 : HUGE_VAL;
    for (std::size_t i = 0; i < corners.size() && moved < HUGE_VAL; ++i)
        moved = std::max(moved, (corners[i] - m_stillCorners[i]).norm());
    if (moved > stillPart * m_widthPx) {
        m_stillCorners = corners;
        m_stillSince = time;
    }
    return time - m_stillSince >= stillFor;
}

PictureAnswer BoardCollector::watch(const Frame &frame, const std::string &source)
{
    PictureAnswer answer = look(frame, source);
    if (!answer.picture || answer.refusal)
        return answer;
    const bool still = isStill(*answer.picture, frame.time);
    for (const CollectedPicture &there : m_pictures) {
        if (distanceOf(there.placement, answer.picture->placement) < leastNews) {
            answer.refusal =
                refusedAsKnown(source, ODO_TEXT("calibration.board_stands_as_before",
                                                "the board stands as in a picture already taken"));
            return answer;
        }
    }
    if (!still)
        return answer;
    if (answer.picture->view.edgeWidthPx > sharpOfSpacing * spacingPx(*answer.picture)) {
        answer.refusal =
            refusal(source,
                    joined({ODO_TEXT("calibration.board_not_sharp", "the board is not sharp"),
                            edgesAreWide(answer.picture->view.edgeWidthPx)},
                           Join::Colon),
                    ODO_TEXT("calibration.focus_or_light", "focus the camera, or give more light"));
        return answer;
    }
    keep(*answer.picture);
    answer.kept = true;
    return answer;
}

std::vector<BoardView> BoardCollector::views() const
{
    std::vector<BoardView> views;
    for (const CollectedPicture &picture : m_pictures)
        views.push_back(picture.view);
    return views;
}

CollectedPicture BoardCollector::remove(std::size_t index)
{
    CollectedPicture picture = std::move(m_pictures.at(index));
    m_pictures.erase(m_pictures.begin() + static_cast<std::ptrdiff_t>(index));
    return picture;
}

void BoardCollector::insert(std::size_t index, CollectedPicture picture)
{
    const std::size_t at = std::min(index, m_pictures.size());
    m_pictures.insert(m_pictures.begin() + static_cast<std::ptrdiff_t>(at), std::move(picture));
}

BoardCoverage BoardCollector::coverage() const
{
    std::vector<BoardPlacement> placements;
    for (const CollectedPicture &picture : m_pictures)
        placements.push_back(picture.placement);
    return coverageOf(views(), placements, m_widthPx, m_heightPx);
}

} // namespace odo
