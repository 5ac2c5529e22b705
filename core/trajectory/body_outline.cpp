// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/body_outline.h"

#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr int searchedAngles = 12;
constexpr double angleStepRad = 0.01; // of the numerical derivative
constexpr double worstMisfit = 4;     // σ of each of the three second moments: not this solid's silhouette
constexpr int placeIterations = 4;

/// The three second moments' differences in units of their σ.
std::optional<Eigen::Vector3d> misfitAt(const FloorView &view, const SolidShape &shape,
                                        const RegionMoments &seen, const Eigen::Vector2d &position,
                                        double angleRad)
{
    const auto model = silhouetteMoments(view, shape, position, angleRad);
    if (!model)
        return std::nullopt;
    const Eigen::Matrix2d difference = seen.covariancePx2 - model->covariancePx2;
    return Eigen::Vector3d(difference(0, 0), difference(1, 1), difference(0, 1)) /
           sigmaOfOutline(seen).covariancePx2;
}

} // namespace

RegionMoments outlineMoments(const Observation &observation)
{
    const Ellipse &ellipse = observation.ellipse;
    const Eigen::Vector2d major(std::cos(ellipse.angleRad), std::sin(ellipse.angleRad));
    const Eigen::Vector2d minor(-major.y(), major.x());
    RegionMoments moments;
    moments.areaPx2 = observation.areaPx;
    moments.centrePx = ellipse.centrePx;
    moments.covariancePx2 = ellipse.semiMajorPx * ellipse.semiMajorPx / 4 * major * major.transpose() +
                            ellipse.semiMinorPx * ellipse.semiMinorPx / 4 * minor * minor.transpose();
    return moments;
}

OutlineSigma sigmaOfOutline(const RegionMoments &outline)
{
    // A circle of radius r that is drawn too wide by e has its area r²π and its moments r²/4 too large by
    // 2e/r.
    const double radius = std::sqrt(std::max(outline.areaPx2, 1.0) / std::numbers::pi);
    const double share = 2 * outlineDoubtPx / radius;
    return {share, share * outline.covariancePx2.trace() / 2};
}

std::optional<double> bestAxis(const FloorView &view, const SolidShape &shape, const RegionMoments &seen,
                               const Eigen::Vector2d &position)
{
    std::optional<double> best;
    double bestCost = HUGE_VAL;
    for (int i = 0; i < searchedAngles; ++i) {
        const double angle = i * std::numbers::pi / searchedAngles;
        const auto residual = misfitAt(view, shape, seen, position, angle);
        if (residual && residual->squaredNorm() < bestCost) {
            best = angle;
            bestCost = residual->squaredNorm();
        }
    }
    return best;
}

std::optional<BodyAxis> axisFromOutline(const FloorView &view, const SolidShape &shape,
                                        const Observation &observation, std::optional<double> guessRad)
{
    if (shape.form == SolidShape::Form::Cylinder)
        return std::nullopt;
    const RegionMoments seen = outlineMoments(observation);
    const auto position = view.floorFromPixel(seen.centrePx, middleHeightM(shape));
    if (!position)
        return std::nullopt;
    const auto misfit = [&](double angle) { return misfitAt(view, shape, seen, *position, angle); };

    const auto guessed = guessRad ? misfit(*guessRad) : std::nullopt;
    const auto start = guessed && guessed->squaredNorm() < 3 * worstMisfit
                           ? guessRad
                           : bestAxis(view, shape, seen, *position);
    if (!start)
        return std::nullopt;
    double best = *start, bestCost = HUGE_VAL, information = 0;
    for (int iteration = 0; iteration < 4; ++iteration) {
        const auto here = misfit(best), before = misfit(best - angleStepRad),
                   behind = misfit(best + angleStepRad);
        if (!here || !before || !behind)
            return std::nullopt;
        const Eigen::Vector3d slope = (*behind - *before) / (2 * angleStepRad);
        information = slope.squaredNorm();
        bestCost = here->squaredNorm();
        if (information < 1e-6)
            break;
        const double step = -slope.dot(*here) / information;
        best += std::clamp(step, -0.15, 0.15);
        if (std::abs(step) < 1e-3)
            break;
    }
    if (bestCost > 3 * worstMisfit * worstMisfit)
        return std::nullopt;
    return BodyAxis{best, 1 / std::sqrt(std::max(information, 1e-6))};
}

std::optional<Eigen::Vector2d> pixelOfBodyMiddle(const FloorView &view, const SolidShape &shape,
                                                 const Eigen::Vector2d &centroidPx, double angleRad)
{
    const double middleM = middleHeightM(shape);
    Eigen::Vector2d pixel = centroidPx;
    for (int iteration = 0; iteration < placeIterations; ++iteration) {
        const auto position = view.floorFromPixel(pixel, middleM);
        if (!position)
            return std::nullopt;
        const auto model = silhouetteMoments(view, shape, *position, angleRad);
        const auto middle = view.pixelFromWorld({position->x(), position->y(), middleM});
        if (!model || !middle)
            return std::nullopt;
        const Eigen::Vector2d next = centroidPx - (model->centrePx - *middle);
        const bool settled = (next - pixel).squaredNorm() < 1e-8;
        pixel = next;
        if (settled)
            break;
    }
    return pixel;
}

} // namespace odo
