// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/outlier_corners.h"

#include "core/base/percentile.h"
#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/plane_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace odo {

namespace {

constexpr double cornerOutliers = 5, leastPx = 0.1;
constexpr std::size_t leastTogether = 3;
constexpr double manyOfRow = 1.0 / 3;
constexpr double restTimes = 1.5; // the usual distance, of the rest of an image with misread corners

/// Splits marked corners into groups connected by steps of two squares at most.
std::vector<std::vector<std::size_t>> groupsOf(const BoardView &view, std::vector<std::size_t> marks)
{
    const double reachM = 2.1 * squareSideM(view);
    std::vector<std::vector<std::size_t>> groups;
    while (!marks.empty()) {
        std::vector<std::size_t> group{marks.back()};
        marks.pop_back();
        for (std::size_t next = 0; next < group.size(); ++next) {
            const auto near = std::partition(marks.begin(), marks.end(), [&](std::size_t mark) {
                return (view.pointsOnBoard[mark] - view.pointsOnBoard[group[next]]).norm() > reachM;
            });
            group.insert(group.end(), near, marks.end());
            marks.erase(near, marks.end());
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

/// RMS of the corners that are not marked, the pose fitted to them; infinite where they have none.
double restPx(const BoardView &view, const std::vector<std::size_t> &marks, const LensFit &fit,
              const RigidTransform &cameraFromBoard)
{
    const auto pose = fitPose(withoutCorners({view}, {marks}).front(), fit, cameraFromBoard);
    return pose ? pose->rmsPx() : std::numeric_limits<double>::infinity();
}

/// The marks with all corners of those outer rows and columns of which many are marked: what moves some of
/// them, such as a narrower outer square, moves the others by less.
std::vector<std::size_t> withOuterRows(const BoardView &view, const std::vector<std::size_t> &marks)
{
    Eigen::AlignedBox2d board;
    for (const Eigen::Vector2d &point : view.pointsOnBoard)
        board.extend(point);
    std::vector<std::size_t> all = marks;
    for (const Eigen::Index axis : {0, 1}) {
        for (const double edge : {board.min()[axis], board.max()[axis]}) {
            std::vector<std::size_t> row;
            for (std::size_t i = 0; i < view.pointsOnBoard.size(); ++i)
                if (std::abs(view.pointsOnBoard[i][axis] - edge) < 1e-6)
                    row.push_back(i);
            const auto marked = std::ranges::count_if(
                row, [&](std::size_t i) { return std::ranges::binary_search(marks, i); });
            if (double(marked) >= manyOfRow * double(row.size()))
                all.insert(all.end(), row.begin(), row.end());
        }
    }
    std::ranges::sort(all);
    const auto twice = std::ranges::unique(all);
    all.erase(twice.begin(), twice.end());
    return all;
}

} // namespace

double medianSigmaPx(const LensFit &fit)
{
    std::vector<double> distances;
    for (const auto &residuals : fit.residualsPx) {
        for (const Eigen::Vector2d &residual : residuals)
            distances.push_back(residual.norm());
    }
    return distances.empty() ? 0 : upperMedian(std::move(distances)) / medianOfRayleigh;
}

double robustSigmaPx(const LensFit &fit)
{
    double values = 0;
    for (const auto &residuals : fit.residualsPx)
        values += 2.0 * static_cast<double>(residuals.size());
    const double fitted =
        4.0 + static_cast<double>(fit.intrinsics.distortion.size() + 6 * fit.residualsPx.size());
    return medianSigmaPx(fit) * std::sqrt(values / std::max(1.0, values - fitted));
}

double outlierLimitPx(double sigmaPx)
{
    return std::max(leastPx, cornerOutliers * sigmaPx);
}

CornerMarks cornersBeyond(const LensFit &fit, double limitPx)
{
    CornerMarks marks(fit.residualsPx.size());
    for (std::size_t view = 0; view < marks.size(); ++view) {
        for (std::size_t i = 0; i < fit.residualsPx[view].size(); ++i) {
            if (fit.residualsPx[view][i].norm() > limitPx)
                marks[view].push_back(i);
        }
    }
    return marks;
}

CornerMarks outlyingCorners(const std::vector<BoardView> &views, const LensFit &fit,
                            const JobControl &control)
{
    const double limitPx = outlierLimitPx(robustSigmaPx(fit));
    CornerMarks marks = cornersBeyond(fit, limitPx);
    if (countOf(marks) == 0)
        return marks;
    const auto robust =
        fitIntrinsics(views, {fit.intrinsics, fit.cameraFromBoard, fit.print},
                      {.cauchyPx = 2 * limitPx / cornerOutliers, .freePrint = fit.estimatesPrint()}, control);
    return robust ? cornersBeyond(*robust, outlierLimitPx(robustSigmaPx(*robust))) : marks;
}

CornerMarks misreadCorners(const std::vector<BoardView> &views, const LensFit &fit, const CornerMarks &marks)
{
    CornerMarks misread(marks.size());
    const double mostPx = restTimes * std::sqrt(2.0) * std::max(robustSigmaPx(fit), leastPx / cornerOutliers);
    for (std::size_t view = 0; view < marks.size(); ++view) {
        if (views[view].pixels.size() < marks[view].size() + leastCornersOfView)
            continue;
        const bool isRestFlat = 2 * marks[view].size() < views[view].pixels.size() &&
                                restPx(views[view], marks[view], fit, fit.cameraFromBoard[view]) < mostPx;
        if (isRestFlat) {
            misread[view] = withOuterRows(views[view], marks[view]);
            continue;
        }
        for (const auto &group : groupsOf(views[view], marks[view])) {
            if (group.size() < leastTogether)
                misread[view].insert(misread[view].end(), group.begin(), group.end());
        }
        std::ranges::sort(misread[view]);
    }
    return misread;
}

std::size_t countOf(const CornerMarks &marks)
{
    std::size_t count = 0;
    for (const auto &list : marks)
        count += list.size();
    return count;
}

std::vector<BoardView> withoutCorners(const std::vector<BoardView> &views, const CornerMarks &marks)
{
    std::vector<BoardView> kept = views;
    for (std::size_t view = 0; view < views.size(); ++view) {
        for (auto index = marks[view].rbegin(); index != marks[view].rend(); ++index) {
            kept[view].pixels.erase(kept[view].pixels.begin() + static_cast<std::ptrdiff_t>(*index));
            kept[view].pointsOnBoard.erase(kept[view].pointsOnBoard.begin() +
                                           static_cast<std::ptrdiff_t>(*index));
        }
    }
    return kept;
}

} // namespace odo
