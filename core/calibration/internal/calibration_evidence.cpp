// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/calibration_evidence.h"

#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/odd_images.h"
#include "core/calibration/internal/wording.h"

#include <algorithm>

namespace odo {

namespace {

/// Why a view cannot be used and what to do; empty where it can.
Message faultOf(const BoardView &view)
{
    const std::size_t corners = std::min(view.pixels.size(), view.pointsOnBoard.size());
    if (corners < leastCornersOfView || view.pixels.size() != view.pointsOnBoard.size())
        return joined({ODO_TEXT("calibration.too_few_corners",
                                "it has %1 corners of the board, six are needed")(corners),
                       ODO_TEXT("calibration.show_more_of_it", "show more of it")},
                      Join::Colon);
    if (!std::ranges::all_of(view.pixels, [](const auto &p) { return p.allFinite(); }) ||
        !std::ranges::all_of(view.pointsOnBoard, [](const auto &p) { return p.allFinite(); }))
        return joined({ODO_TEXT("calibration.corner_no_number", "a corner of it is not a number"),
                       ODO_TEXT("calibration.find_board_again", "detect the board in it again")},
                      Join::Colon);
    return {};
}

/// The usable views; the others go to `rejected` with a reason.
std::vector<BoardView> usableViews(const std::vector<BoardView> &views, std::vector<RejectedImage> &rejected)
{
    std::vector<BoardView> usable;
    for (const BoardView &view : views) {
        Message fault = faultOf(view);
        if (fault.isEmpty())
            usable.push_back(view);
        else
            rejected.push_back({view.source, std::move(fault)});
    }
    return usable;
}

/// Starts of the models for the same views. dropped: the views that have no pose under any model, ascending,
/// which the starts lack; models under which more views have none than under another are left out.
std::vector<LensStart> startsFor(const std::vector<BoardView> &views, int widthPx, int heightPx,
                                 std::optional<LensModel> model, std::vector<std::size_t> &dropped)
{
    std::vector<LensModel> models{LensModel::Standard, LensModel::Fisheye, LensModel::Rational};
    if (model)
        models = {*model};
    else if (views.size() < leastViewsForHalves)
        models = {LensModel::Standard};
    std::vector<std::vector<std::size_t>> withoutPose(models.size());
    std::vector<std::optional<LensStart>> starts;
    std::size_t fewest = views.size();
    for (std::size_t i = 0; i < models.size(); ++i) {
        // A rational lens begins as a standard one.
        if (models[i] == LensModel::Rational && !model) {
            starts.push_back(starts.front());
            withoutPose[i] = withoutPose.front();
            if (starts.back())
                starts.back()->intrinsics.model = LensModel::Rational;
        } else {
            starts.push_back(startLens(views, widthPx, heightPx, models[i], withoutPose[i]));
        }
        if (starts.back())
            fewest = std::min(fewest, withoutPose[i].size());
    }
    std::vector<LensStart> kept;
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (!starts[i] || withoutPose[i].size() > fewest || (!kept.empty() && withoutPose[i] != dropped))
            continue;
        dropped = withoutPose[i];
        kept.push_back(std::move(*starts[i]));
    }
    return kept;
}

std::vector<BoardView> viewsThatCount(const std::vector<BoardView> &views, const BoardPositions &positions)
{
    std::vector<BoardView> counting;
    for (std::size_t index : positions.counting)
        counting.push_back(views[index]);
    return counting;
}

} // namespace

Message repeatOf(const std::vector<BoardView> &views, const BoardPositions &positions, std::size_t index)
{
    const std::size_t shownBy = positions.shownBy[index];
    return shownBy == index ? Message() : sameBoardPosition(views[shownBy].source);
}

CalibrationEvidence evidenceFrom(const std::vector<BoardView> &views, int widthPx, int heightPx,
                                 std::optional<LensModel> model, IntrinsicCalibration &calibration)
{
    const std::vector<BoardView> usable = usableViews(views, calibration.rejected);
    const BoardPositions positions = positionsIn(usable);
    CalibrationEvidence evidence{viewsThatCount(usable, positions), {}};
    std::vector<std::size_t> dropped;
    if (evidence.views.size() >= leastViews)
        evidence.starts = startsFor(evidence.views, widthPx, heightPx, model, dropped);
    for (std::size_t i = 0; i < usable.size(); ++i) {
        const bool isDropped = std::ranges::any_of(
            dropped, [&](std::size_t index) { return positions.counting[index] == positions.shownBy[i]; });
        Message repeats = repeatOf(usable, positions, i);
        const bool counts = repeats.isEmpty();
        if (isDropped)
            calibration.rejected.push_back(
                {usable[i].source,
                 joined({ODO_TEXT("calibration.corners_not_flat", "its corners do not match a flat board"),
                         ODO_TEXT("calibration.glue_board", "glue the board onto something stiff")},
                        Join::Colon)});
        else
            calibration.images.push_back({usable[i], counts, std::move(repeats), {}, 0, {}, {}, {}});
    }
    for (auto index = dropped.rbegin(); index != dropped.rend(); ++index)
        evidence.views.erase(evidence.views.begin() + static_cast<std::ptrdiff_t>(*index));
    return evidence;
}

void dropOddImages(CalibrationEvidence &evidence, IntrinsicCalibration &calibration,
                   const JobControl &control)
{
    std::vector<CalibrationImage *> used;
    for (CalibrationImage &image : calibration.images) {
        if (image.used)
            used.push_back(&image);
    }
    std::vector<OddImage> odd = oddImages(evidence.views, evidence.starts, control);
    for (auto image = odd.rbegin(); image != odd.rend(); ++image) {
        used[image->view]->used = false;
        used[image->view]->contradicts = std::move(image->reason);
        const auto at = static_cast<std::ptrdiff_t>(image->view);
        evidence.views.erase(evidence.views.begin() + at);
        for (LensStart &start : evidence.starts)
            start.cameraFromBoard.erase(start.cameraFromBoard.begin() + at);
    }
}

} // namespace odo
