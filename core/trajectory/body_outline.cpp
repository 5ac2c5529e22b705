// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/body_outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double angleStepRad = 0.01; // of the numerical derivative
constexpr double longestStepRad = 0.05, leastInformation = 1;
constexpr int mostIterations = 3;
constexpr int aboutSteps = 8;
constexpr double aboutStepRad = 0.025;
constexpr double worstMisfit = 4; // σ of each of the three second moments: not this solid's silhouette
constexpr int placeIterations = 4;

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

OutlineDifferences outlineDifferences(const RegionMoments &seen, const RegionMoments &model, const OutlineSigma &sigma, double centroidSigmaPx)
{
    const Eigen::Vector2d place = (seen.centrePx - model.centrePx) / centroidSigmaPx;
    const Eigen::Matrix2d spread = (seen.covariancePx2 - model.covariancePx2) / sigma.covariancePx2;
    OutlineDifferences differences;
    differences << place, std::log(seen.areaPx2 / model.areaPx2) / sigma.areaShare, spread(0, 0), spread(1, 1), spread(0, 1);
    return differences;
}

OutlineMisfit::OutlineMisfit(const FloorView &view, const SolidShape &shape, const RegionMoments &seen,
                             const Eigen::Vector2d &position)
    : m_view(&view), m_shape(&shape), m_seen(seen), m_position(position),
      m_sigmaPx2(sigmaOfOutline(seen).covariancePx2)
{
}

std::optional<OutlineMisfit> OutlineMisfit::create(const FloorView &view, const SolidShape &shape,
                                                   const RegionMoments &seen)
{
    const auto position = view.floorFromPixel(seen.centrePx, middleHeightM(shape));
    if (!position)
        return std::nullopt;
    return OutlineMisfit(view, shape, seen, *position);
}

std::optional<Eigen::Vector3d> OutlineMisfit::at(double angleRad) const
{
    const auto model = silhouetteMoments(*m_view, *m_shape, m_position, angleRad);
    if (!model)
        return std::nullopt;
    const Eigen::Matrix2d difference = m_seen.covariancePx2 - model->covariancePx2;
    return Eigen::Vector3d(difference(0, 0), difference(1, 1), difference(0, 1)) / m_sigmaPx2;
}

std::optional<BodyAxis> axisAbout(const OutlineMisfit &misfit, double angleRad)
{
    double weights = 0, mean = 0, squares = 0, leastCost = HUGE_VAL;
    for (int i = -aboutSteps; i <= aboutSteps; ++i) {
        const double turn = i * aboutStepRad;
        const auto residual = misfit.at(angleRad + turn);
        if (!residual)
            return std::nullopt;
        const double cost = residual->squaredNorm(), weight = std::exp(-cost / 2);
        leastCost = std::min(leastCost, cost);
        weights += weight;
        mean += weight * turn;
        squares += weight * turn * turn;
    }
    if (leastCost > 3 * worstMisfit * worstMisfit || !(weights > 0))
        return std::nullopt;
    mean /= weights;
    return BodyAxis{angleRad + mean,
                    std::sqrt(std::max(squares / weights - mean * mean, aboutStepRad * aboutStepRad / 4))};
}

std::optional<BodyAxis> axisNear(const OutlineMisfit &misfit, double angleRad)
{
    double information = 0, cost = 0;
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        const auto here = misfit.at(angleRad), before = misfit.at(angleRad - angleStepRad),
                   behind = misfit.at(angleRad + angleStepRad);
        if (!here || !before || !behind)
            return std::nullopt;
        const Eigen::Vector3d slope = (*behind - *before) / (2 * angleStepRad);
        information = slope.squaredNorm();
        cost = here->squaredNorm();
        if (information < leastInformation)
            break;
        const double step = -slope.dot(*here) / information;
        angleRad += std::clamp(step, -longestStepRad, longestStepRad);
        if (std::abs(step) < 1e-3)
            break;
    }
    if (cost > 3 * worstMisfit * worstMisfit)
        return std::nullopt;
    return BodyAxis{angleRad, 1 / std::sqrt(std::max(information, leastInformation))};
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
