// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_collector.h"

#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <cmath>
#include <tuple>

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

Error BoardCollector::refusedForSize(const std::string &source, const Frame &frame) const
{
    return refusal(source, otherSizeThanMost(frame.format.width, frame.format.height, m_widthPx, m_heightPx),
                   ODO_TEXT("calibration.use_one_resolution", "use images of one camera at one resolution"));
}

bool BoardCollector::isOfSize(const Frame &frame) const
{
    return m_widthPx == 0 || (frame.format.width == m_widthPx && frame.format.height == m_heightPx);
}

ImageVerdict BoardCollector::examine(const Frame &frame, const std::string &source, const BoardSpec &spec,
                                     const std::optional<BoardKind> &likely) const
{
    ImageVerdict answer;
    const int widthPx = frame.format.width, heightPx = frame.format.height;
    auto view = findBoardForVote(frame, spec, likely, source);
    if (!view) {
        answer.refusal = isOfSize(frame) ? view.error() : refusedForSize(source, frame);
        return answer;
    }
    const auto placement = placementOf(*view, widthPx, heightPx);
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

/// What most votes say; drops the images of another board.
void BoardCollector::count()
{
    const auto before = std::tuple(m_kind, m_widthPx, m_heightPx);
    const auto sameSize = [](const Vote &one, const Vote &other) {
        return one.widthPx == other.widthPx && one.heightPx == other.heightPx;
    };
    const Vote &most = *std::ranges::max_element(m_votes, {}, [&](const Vote &vote) {
        return std::ranges::count_if(m_votes, [&](const Vote &other) { return sameSize(vote, other); });
    });
    std::vector<BoardView> views;
    for (const Vote &vote : m_votes) {
        if (sameSize(vote, most))
            views.push_back(vote.image.view);
    }
    m_widthPx = most.widthPx;
    m_heightPx = most.heightPx;
    m_kind = votedBoard(views, m_widthPx, m_heightPx);
    m_likely = likelyBoard(views, m_widthPx, m_heightPx);
    if (before == std::tuple(m_kind, m_widthPx, m_heightPx))
        return;
    ++m_changes;
    m_images.clear();
}

void BoardCollector::keep(ImageVerdict &answer, const Frame &frame)
{
    m_votes.push_back({*answer.image, frame.format.width, frame.format.height});
    count();
    keepOfBoard(answer, frame);
    answer.isOther = !answer.kept;
}

void BoardCollector::keepOfBoard(ImageVerdict &answer, const Frame &frame)
{
    const std::string source = answer.image->view.source;
    if (!isOfSize(frame)) {
        answer.refusal = refusedForSize(source, frame);
        return;
    }
    if (!(kindOf(answer.image->view) == m_kind))
        answer = examine(frame, source, spec(), std::nullopt);
    if (!answer.image || answer.refusal)
        return;
    if (const CollectedImage *known = sameAs(*answer.image, frame)) {
        answer.refusal = refusedAsKnown(source, sameBoardPosition(known->view.source));
        return;
    }
    m_images.push_back(*answer.image);
    answer.kept = true;
}

const CollectedImage *BoardCollector::sameAs(const CollectedImage &image, const Frame &frame) const
{
    const auto isSame = [&](const CollectedImage &there) {
        return distanceOf(there.placement, image.placement) < leastNews;
    };
    if (kindOf(image.view) == m_kind && isOfSize(frame)) {
        const auto same = std::ranges::find_if(m_images, isSame);
        return same == m_images.end() ? nullptr : &*same;
    }
    const auto same = std::ranges::find_if(m_votes, [&](const Vote &vote) {
        return kindOf(vote.image.view) == kindOf(image.view) && vote.widthPx == frame.format.width &&
               vote.heightPx == frame.format.height && isSame(vote.image);
    });
    return same == m_votes.end() ? nullptr : &same->image;
}

ImageVerdict BoardCollector::offer(const Frame &frame, const std::string &source)
{
    ImageVerdict answer = examine(frame, source, m_asked, isOfSize(frame) ? m_likely : std::nullopt);
    if (!answer.image || answer.refusal)
        return answer;
    if (const CollectedImage *known = sameAs(*answer.image, frame))
        answer.refusal = refusedAsKnown(source, sameBoardPosition(known->view.source));
    else
        keep(answer, frame);
    return answer;
}

ImageVerdict BoardCollector::offerAgain(const Frame &frame, const std::string &source)
{
    ImageVerdict answer = examine(frame, source, spec(), std::nullopt);
    if (answer.image && !answer.refusal)
        keepOfBoard(answer, frame);
    return answer;
}

bool BoardCollector::isStill(const CollectedImage &image, const Frame &frame)
{
    const std::vector<Eigen::Vector2d> &corners = image.view.pixels;
    double moved = corners.size() == m_stillCorners.size() ? 0 : HUGE_VAL;
    for (std::size_t i = 0; i < corners.size() && moved < HUGE_VAL; ++i)
        moved = std::max(moved, (corners[i] - m_stillCorners[i]).norm());
    if (moved > stillPart * frame.format.width) {
        m_stillCorners = corners;
        m_stillSince = frame.time;
    }
    return frame.time - m_stillSince >= stillFor;
}

ImageVerdict BoardCollector::watch(const Frame &frame, const std::string &source)
{
    ImageVerdict answer = examine(frame, source, m_asked, isOfSize(frame) ? m_likely : std::nullopt);
    if (!answer.image || answer.refusal)
        return answer;
    const bool still = isStill(*answer.image, frame);
    if (sameAs(*answer.image, frame)) {
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
    keep(answer, frame);
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
    std::erase_if(m_votes, [&](const Vote &vote) { return vote.image.view.source == image.view.source; });
    m_images.erase(m_images.begin() + static_cast<std::ptrdiff_t>(index));
    return image;
}

void BoardCollector::insert(std::size_t index, CollectedImage image)
{
    const std::size_t at = std::min(index, m_images.size());
    m_votes.push_back({image, m_widthPx, m_heightPx});
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
