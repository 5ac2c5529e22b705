// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/contradiction_model.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/trajectory/internal/fused_track.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace odo {

namespace {

constexpr std::size_t leastCommonTimes = 20,
                      mostComparedTimes = 72; // that both views saw; more are thinned out
constexpr int speedReach = 2;                 // sightings to either side that a speed is taken over
// of what lasts in all outlines of a view; more than that the fit of a solid leaves open because of a
// contradiction
constexpr double lastingLengthM = 0.5, leastLastingPx = 0.1, mostLastingPx = 0.25;
constexpr double degree = std::numbers::pi / 180;
constexpr std::array rotationScales{0.04 * degree, 0.2 * degree, 1.0 * degree};
constexpr std::array offsetScalesS{0.008, 0.05};
constexpr std::array heightScalesM{0.008, 0.04};
constexpr double clockRateScale = 0.001, freeHeightScaleM = 0.03, clearanceScaleM = 0.005;
constexpr int gaussNewtonSteps = 6, firstSteps = 2;
constexpr std::size_t changePoints = 24, firstChangePoints = 6; // tried along the run
constexpr double edgeShare = 0.04;                              // of the run, where none is tried
constexpr std::size_t rotations = 3;
constexpr double firstDoubt = 3; // nats, by which a first look may miss a cause
constexpr double farLess = 20;   // nats, below the best cause

/// Both views at one time, and what follows from neighbouring ones.
struct Common
{
    std::size_t index = 0; ///< of the time
    double timeS = 0, travelM = 0;
    Eigen::Vector2d velocityMps = Eigen::Vector2d::Zero();
};

/// Noise of the outlines: the stated one times a factor, a part of it slow.
struct OutlineNoise
{
    double scale = 1, slowShare = 0.8, slowLengthM = 0.1;
};

/// With which a first look is taken.
std::vector<OutlineNoise> usualNoises()
{
    return {{0.5, 0.8, 0.1}, {2, 0.8, 0.1}, {8, 0.8, 0.1}};
}

std::vector<OutlineNoise> possibleNoises()
{
    std::vector<OutlineNoise> all;
    for (double scale = 0.25; scale < 100; scale *= 2)
        for (const auto &[share, lengthM] :
             {std::pair(0.3, 0.1), std::pair(0.8, 0.05), std::pair(0.8, 0.1), std::pair(0.9, 0.2)})
            all.push_back({scale, share, lengthM});
    return all;
}

/// Of a factor that is usually about one.
double logPrior(const OutlineNoise &noise)
{
    const double logScale = std::log(noise.scale);
    return -logScale * logScale / 2;
}

/// Two things at once are rarer than one.
constexpr double logRare = -2;

/// A kind of cause with its parameters: rotations of the views, an offset and a rate, a height.
struct CauseModel
{
    ContradictionCause::Kind kind = ContradictionCause::Kind::CameraMoved;
    bool rotatesA = false, rotatesB = false, shiftsTime = false, changesRate = false, raises = false;
    std::optional<double> sinceS; ///< of the rotation
    std::vector<double> scales;   ///< factors of the standard deviations to try
    std::vector<double> sigmas;   ///< of the parameters, at a factor of one

    Eigen::Index size() const { return static_cast<Eigen::Index>(sigmas.size()); }
};

/// A model fitted.
struct CauseFit
{
    CauseModel model;
    Eigen::VectorXd parameters;
    Eigen::MatrixXd covariance; ///< of them
    double logEvidence = 0;
};

struct Positions
{
    Eigen::Vector2d a = Eigen::Vector2d::Zero(), b = Eigen::Vector2d::Zero();
};

/// Where a ray meets the plane after the camera was turned.
Eigen::Vector2d turned(const Eigen::Vector3d &cameraInWorld, const Eigen::Vector3d &rotation,
                       const Eigen::Vector2d &position, double planeM)
{
    const double angle = rotation.norm();
    if (angle == 0)
        return position;
    const Eigen::Vector3d ray = Eigen::AngleAxisd(angle, rotation / angle) *
                                (Eigen::Vector3d(position.x(), position.y(), planeM) - cameraInWorld);
    const Eigen::Vector3d at = cameraInWorld + ray * ((planeM - cameraInWorld.z()) / ray.z());
    return at.head<2>();
}

bool isClear(const Sighting &sighting)
{
    return sighting.seen && !sighting.cut;
}

class PairModel
{
public:
    PairModel(const FloorView &viewA, const FloorView &viewB, std::span<const Sighting> a,
              std::span<const Sighting> b, const PairPriors &priors, std::vector<OutlineNoise> noises,
              bool isFirstLook)
        : m_viewA(viewA), m_viewB(viewB), m_a(a), m_b(b), m_priors(priors), m_noises(std::move(noises)),
          m_isFirstLook(isFirstLook)
    {
        collect();
        if (m_common.size() < leastCommonTimes)
            return;
        const std::size_t step = (m_common.size() + mostComparedTimes - 1) / mostComparedTimes;
        for (std::size_t i = step / 2; i < m_common.size(); i += step)
            m_thin.push_back(i);
        buildStated();
    }

    std::vector<FittedCause> fit() const;

private:
    void collect();
    void buildStated();
    Eigen::MatrixXd covariance(const OutlineNoise &noise) const;

    Positions apply(const CauseModel &by, const Eigen::VectorXd &parameters, double timeS,
                    Positions positions, const std::function<Eigen::Vector2d(double)> &laterB,
                    const Eigen::Vector2d &perHeightA, const Eigen::Vector2d &perHeightB) const;
    Eigen::Vector2d offAlone(std::size_t index, bool isA, const CauseModel &by,
                             const Eigen::VectorXd &parameters) const;
    Positions corrected(std::size_t i, const CauseModel &by, const Eigen::VectorXd &parameters) const;
    Eigen::Vector2d at(std::span<const Sighting> view, std::size_t i, double laterS) const;
    Eigen::VectorXd residuals(const CauseModel &by, const Eigen::VectorXd &parameters) const;
    Eigen::MatrixXd slopes(const CauseModel &by, const Eigen::VectorXd &parameters,
                           const Eigen::VectorXd &there) const;
    std::vector<CauseModel> lastingCauses() const;
    std::optional<CauseFit> fitOne(const CauseModel &by) const;
    void addChanges(std::vector<CauseFit> &fits) const;
    PairCorrection correctionOf(const CauseFit &fit) const;
    FittedCause described(const CauseFit &fit, double logEvidence) const;
    void addOff(const CauseFit &fit, FittedCause &fitted) const;
    Eigen::Matrix2d lastingOf(const FloorView &view, const FloorPosition &position) const;
    /// Of a view's position, as it is stated without what the fit of a solid left open.
    Eigen::Matrix2d statedOf(const FloorView &view, const FloorPosition &position) const;
    double medianShiftPx(const FloorView &view, bool isA, const CauseModel &by,
                         const Eigen::VectorXd &parameters) const;

    const FloorView &m_viewA, &m_viewB;
    std::span<const Sighting> m_a, m_b;
    PairPriors m_priors;
    std::vector<Common> m_common;
    std::vector<std::size_t> m_thin; ///< into m_common
    double m_middleS = 0;
    Eigen::MatrixXd m_stated; ///< covariance of the differences, without the outlines' noise
    std::vector<OutlineNoise> m_noises;
    bool m_isFirstLook = false;
    std::vector<Eigen::LLT<Eigen::MatrixXd>> m_roots; ///< for each of them
    std::vector<double> m_logDeterminants;
};

void PairModel::collect()
{
    const std::size_t times = std::min(m_a.size(), m_b.size());
    double travelM = 0;
    for (std::size_t i = 0; i < times; ++i) {
        if (!isClear(m_a[i]) || !isClear(m_b[i]))
            continue;
        m_common.push_back({i, toSeconds(m_a[i].time)});
    }
    for (std::size_t i = 0; i < m_common.size(); ++i) {
        const std::size_t before = m_common[i - std::min<std::size_t>(i, speedReach)].index,
                          behind = m_common[std::min(m_common.size() - 1, i + speedReach)].index;
        const double spanS = toSeconds(m_a[behind].time - m_a[before].time);
        if (spanS > 0)
            m_common[i].velocityMps =
                (m_a[behind].position.pointInWorld - m_a[before].position.pointInWorld +
                 m_b[behind].position.pointInWorld - m_b[before].position.pointInWorld) /
                (2 * spanS);
        if (i > 0)
            travelM += m_common[i].velocityMps.norm() * (m_common[i].timeS - m_common[i - 1].timeS);
        m_common[i].travelM = travelM;
    }
    if (!m_common.empty())
        m_middleS = (m_common.front().timeS + m_common.back().timeS) / 2;
}

/// The square root of a part of a covariance, which two times share by a correlation.
Eigen::Matrix2d rootOf(const Eigen::Matrix2d &covariance)
{
    const Eigen::Matrix2d positive = covariance + Eigen::Matrix2d::Identity() * 1e-14;
    return positive.llt().matrixL();
}

/// What lasts in all outlines of a view, on the floor.
Eigen::Matrix2d PairModel::lastingOf(const FloorView &view, const FloorPosition &position) const
{
    const Eigen::Vector2d &point = position.pointInWorld;
    const auto pixel = view.pixelFromWorld({point.x(), point.y(), m_priors.planeM});
    const auto onePx =
        pixel ? view.locate(*pixel, Eigen::Matrix2d::Identity(), m_priors.planeM) : std::nullopt;
    if (!onePx)
        return Eigen::Matrix2d::Zero();
    const double stated = (position.calibrationCovariance - onePx->calibrationCovariance).trace() /
                          onePx->pixelCovariance.trace();
    return std::clamp(stated, leastLastingPx * leastLastingPx, mostLastingPx * mostLastingPx) *
           onePx->pixelCovariance;
}

Eigen::Matrix2d PairModel::statedOf(const FloorView &view, const FloorPosition &position) const
{
    return position.pixelCovariance + lastingOf(view, position) +
           view.sharedCovariance(position.pointInWorld, position.pointInWorld, m_priors.planeM)
               .value_or(Eigen::Matrix2d::Zero());
}

void PairModel::buildStated()
{
    const auto n = static_cast<Eigen::Index>(m_thin.size());
    m_stated = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::VectorXd byHeight(2 * n), byTime(2 * n);
    std::vector<Eigen::Matrix2d> lasting;
    const auto pointOf = [&](std::span<const Sighting> view, Eigen::Index i) -> const FloorPosition & {
        return view[m_common[m_thin[static_cast<std::size_t>(i)]].index].position;
    };
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) {
            Eigen::Matrix2d shared = Eigen::Matrix2d::Zero();
            for (const auto &[floorView, view] : {std::pair(&m_viewA, m_a), std::pair(&m_viewB, m_b)})
                shared += floorView
                              ->sharedCovariance(pointOf(view, i).pointInWorld, pointOf(view, j).pointInWorld,
                                                 m_priors.planeM)
                              .value_or(Eigen::Matrix2d::Zero());
            m_stated.block<2, 2>(2 * i, 2 * j) = shared;
            m_stated.block<2, 2>(2 * j, 2 * i) = shared.transpose();
        }
        lasting.push_back(rootOf(lastingOf(m_viewA, pointOf(m_a, i)) + lastingOf(m_viewB, pointOf(m_b, i))));
        byHeight.segment<2>(2 * i) =
            pointOf(m_a, i).displacementPerMetreHeight - pointOf(m_b, i).displacementPerMetreHeight;
        byTime.segment<2>(2 * i) = m_common[m_thin[static_cast<std::size_t>(i)]].velocityMps;
    }
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const double wayM = std::abs(m_common[m_thin[static_cast<std::size_t>(i)]].travelM -
                                         m_common[m_thin[static_cast<std::size_t>(j)]].travelM);
            m_stated.block<2, 2>(2 * i, 2 * j) += std::exp(-wayM / lastingLengthM) *
                                                  lasting[static_cast<std::size_t>(i)] *
                                                  lasting[static_cast<std::size_t>(j)].transpose();
        }
    m_stated += m_priors.planeSigmaM * m_priors.planeSigmaM * byHeight * byHeight.transpose() +
                m_priors.offsetSigmaS * m_priors.offsetSigmaS * byTime * byTime.transpose();
    for (const OutlineNoise &noise : m_noises) {
        m_roots.emplace_back(covariance(noise));
        m_logDeterminants.push_back(2 * m_roots.back().matrixLLT().diagonal().array().log().sum());
    }
}

Eigen::MatrixXd PairModel::covariance(const OutlineNoise &noise) const
{
    Eigen::MatrixXd all = m_stated;
    std::vector<Eigen::Matrix2d> roots;
    for (const std::size_t i : m_thin) {
        const std::size_t index = m_common[i].index;
        roots.push_back(rootOf(m_a[index].position.pixelCovariance + m_b[index].position.pixelCovariance));
    }
    for (std::size_t i = 0; i < m_thin.size(); ++i)
        for (std::size_t j = 0; j < m_thin.size(); ++j) {
            const double wayM = std::abs(m_common[m_thin[i]].travelM - m_common[m_thin[j]].travelM);
            const double alike =
                noise.slowShare * std::exp(-wayM / noise.slowLengthM) + (i == j ? 1 - noise.slowShare : 0);
            all.block<2, 2>(Eigen::Index(2 * i), Eigen::Index(2 * j)) +=
                noise.scale * alike * roots[i] * roots[j].transpose();
        }
    return all;
}

/// A view's position some time later, linear between the common times.
Eigen::Vector2d PairModel::at(std::span<const Sighting> view, std::size_t i, double laterS) const
{
    const double timeS = m_common[i].timeS + laterS;
    std::size_t right = i;
    while (right + 1 < m_common.size() && m_common[right].timeS < timeS)
        ++right;
    while (right > 1 && m_common[right - 1].timeS > timeS)
        --right;
    right = std::max<std::size_t>(right, 1);
    const Eigen::Vector2d &before = view[m_common[right - 1].index].position.pointInWorld,
                          &behind = view[m_common[right].index].position.pointInWorld;
    const double spanS = m_common[right].timeS - m_common[right - 1].timeS;
    return before + (behind - before) * ((timeS - m_common[right - 1].timeS) / spanS);
}

/// What a cause makes of positions; laterB: where the second view saw it so many seconds later.
Positions PairModel::apply(const CauseModel &by, const Eigen::VectorXd &parameters, double timeS,
                           Positions positions, const std::function<Eigen::Vector2d(double)> &laterB,
                           const Eigen::Vector2d &perHeightA, const Eigen::Vector2d &perHeightB) const
{
    Eigen::Index next = 0;
    const bool isAfter = !by.sinceS || timeS >= *by.sinceS;
    const auto rotation = [&]() -> Eigen::Vector3d {
        const Eigen::Vector3d its = parameters.segment<3>(next);
        next += rotations;
        return isAfter ? its : Eigen::Vector3d::Zero();
    };
    if (by.rotatesA)
        positions.a = turned(m_viewA.cameraInWorld(), rotation(), positions.a, m_priors.planeM);
    if (by.rotatesB)
        positions.b = turned(m_viewB.cameraInWorld(), rotation(), positions.b, m_priors.planeM);
    if (by.shiftsTime) {
        double laterS = parameters[next++];
        if (by.changesRate)
            laterS += parameters[next++] * (timeS - m_middleS);
        positions.b = laterB(laterS);
    }
    if (by.raises) {
        positions.a += parameters[next] * perHeightA;
        positions.b += parameters[next] * perHeightB;
    }
    return positions;
}

Positions PairModel::corrected(std::size_t i, const CauseModel &by, const Eigen::VectorXd &parameters) const
{
    const FloorPosition &seenA = m_a[m_common[i].index].position, &seenB = m_b[m_common[i].index].position;
    return apply(
        by, parameters, m_common[i].timeS, {seenA.pointInWorld, seenB.pointInWorld},
        [&](double laterS) { return at(m_b, i, laterS); }, seenA.displacementPerMetreHeight,
        seenB.displacementPerMetreHeight);
}

Eigen::VectorXd PairModel::residuals(const CauseModel &by, const Eigen::VectorXd &parameters) const
{
    Eigen::VectorXd all(2 * Eigen::Index(m_thin.size()));
    for (std::size_t k = 0; k < m_thin.size(); ++k) {
        const Positions positions = corrected(m_thin[k], by, parameters);
        all.segment<2>(Eigen::Index(2 * k)) = positions.a - positions.b;
    }
    return all;
}

Eigen::MatrixXd PairModel::slopes(const CauseModel &by, const Eigen::VectorXd &parameters,
                                  const Eigen::VectorXd &there) const
{
    constexpr double part = 1e-3; // of a standard deviation
    Eigen::MatrixXd all(there.size(), by.size());
    for (Eigen::Index p = 0; p < by.size(); ++p) {
        Eigen::VectorXd moved = parameters;
        const double step = part * by.sigmas[static_cast<std::size_t>(p)];
        moved[p] += step;
        all.col(p) = (residuals(by, moved) - there) / step;
    }
    return all;
}

/// nullopt where it diverges.
std::optional<CauseFit> PairModel::fitOne(const CauseModel &by) const
{
    CauseFit fit{by, Eigen::VectorXd::Zero(by.size()), {}, -HUGE_VAL};
    Eigen::VectorXd &parameters = fit.parameters;
    const auto found = std::ranges::find_if(m_noises, [](const OutlineNoise &noise) {
        return noise.scale >= 2 && noise.slowShare == 0.8 && noise.slowLengthM == 0.1;
    });
    const auto usual = static_cast<std::size_t>(found - m_noises.begin());
    Eigen::VectorXd misfit = residuals(by, parameters);
    const double widest = by.scales.back();
    Eigen::VectorXd precision(by.size());
    for (Eigen::Index p = 0; p < by.size(); ++p)
        precision[p] = 1 / std::pow(widest * by.sigmas[static_cast<std::size_t>(p)], 2);
    Eigen::MatrixXd slope;
    for (int step = 0; step < (m_isFirstLook ? firstSteps : gaussNewtonSteps); ++step) {
        slope = slopes(by, parameters, misfit);
        const Eigen::MatrixXd weighted = m_roots[usual].solve(slope);
        Eigen::MatrixXd normal = weighted.transpose() * slope;
        normal.diagonal() += precision;
        const Eigen::VectorXd change =
            normal.ldlt().solve(weighted.transpose() * misfit + precision.cwiseProduct(parameters));
        parameters -= change;
        misfit = residuals(by, parameters);
        if (!misfit.allFinite() || !parameters.allFinite())
            return std::nullopt;
    }
    slope = slopes(by, parameters, misfit);
    const Eigen::VectorXd straight = misfit - slope * parameters; // of a linear model, at no cause
    for (std::size_t k = 0; k < m_noises.size(); ++k) {
        const Eigen::MatrixXd weighted = m_roots[k].solve(slope);
        const Eigen::VectorXd pull = weighted.transpose() * straight;
        const Eigen::MatrixXd information = weighted.transpose() * slope;
        const double whole = straight.dot(m_roots[k].solve(straight));
        for (const double scale : by.scales) {
            Eigen::MatrixXd normal = information;
            double logPriorDeterminant = 0;
            for (Eigen::Index p = 0; p < by.size(); ++p) {
                const double sigma = scale * by.sigmas[static_cast<std::size_t>(p)];
                normal(p, p) += 1 / (sigma * sigma);
                logPriorDeterminant += 2 * std::log(sigma);
            }
            const Eigen::LLT<Eigen::MatrixXd> root(normal);
            const Eigen::VectorXd estimate = -root.solve(pull);
            const double chiSquared = whole + estimate.dot(pull);
            const double logDeterminant = m_logDeterminants[k] + logPriorDeterminant +
                                          2 * root.matrixLLT().diagonal().array().log().sum();
            const double evidence = -(chiSquared + logDeterminant) / 2 + logPrior(m_noises[k]) -
                                    std::log(double(by.scales.size()));
            if (evidence > fit.logEvidence) {
                fit.logEvidence = evidence;
                parameters = estimate;
                fit.covariance = root.solve(Eigen::MatrixXd::Identity(by.size(), by.size()));
            }
        }
    }
    return fit;
}

std::vector<CauseModel> PairModel::lastingCauses() const
{
    using Kind = ContradictionCause::Kind;
    std::vector<CauseModel> all;
    const std::vector<double> rotation(rotations, 1.0);
    const std::vector<double> rotationSizes(rotationScales.begin(), rotationScales.end());
    const auto add = [&](CauseModel one) {
        // a height that was estimated from these positions has taken up what it could, and so has the
        // clearance under a robot whose height is given
        if (!one.raises) {
            one.raises = true;
            one.sigmas.push_back((m_priors.isHeightGiven ? clearanceScaleM : freeHeightScaleM) /
                                 one.scales[one.scales.size() / 2]);
        }
        all.push_back(std::move(one));
    };
    add({Kind::CameraMoved, true, false, false, false, false, {}, rotationSizes, rotation});
    add({Kind::CameraMoved, false, true, false, false, false, {}, rotationSizes, rotation});
    add({Kind::CamerasMoved,
         true,
         true,
         false,
         false,
         false,
         {},
         rotationSizes,
         std::vector<double>(2 * rotations, 1.0)});
    add({Kind::Offset,
         false,
         false,
         true,
         false,
         false,
         {},
         std::vector<double>(offsetScalesS.begin(), offsetScalesS.end()),
         {1.0}});
    add({Kind::ClockRate,
         false,
         false,
         true,
         true,
         false,
         {},
         std::vector<double>(offsetScalesS.begin(), offsetScalesS.end()),
         {1.0, clockRateScale / offsetScalesS.back()}});
    if (m_priors.isHeightGiven)
        add({Kind::Height,
             false,
             false,
             false,
             false,
             true,
             {},
             std::vector<double>(heightScalesM.begin(), heightScalesM.end()),
             {1.0}});
    return all;
}

void PairModel::addChanges(std::vector<CauseFit> &fits) const
{
    const double beginS = m_common.front().timeS, spanS = m_common.back().timeS - beginS;
    for (const CauseModel &one : lastingCauses()) {
        if (one.kind != ContradictionCause::Kind::CameraMoved)
            continue;
        std::optional<CauseFit> best;
        const auto tryAt = [&](double share) {
            CauseModel from = one;
            from.sinceS = beginS + share * spanS;
            auto fit = fitOne(from);
            if (fit && (!best || fit->logEvidence > best->logEvidence))
                best = std::move(fit);
        };
        const std::size_t points = m_isFirstLook ? firstChangePoints : changePoints;
        for (std::size_t k = 0; k < points; ++k)
            tryAt(edgeShare + (1 - 2 * edgeShare) * double(k) / double(points - 1));
        if (!best)
            continue;
        if (m_isFirstLook) {
            fits.push_back(std::move(*best));
            continue;
        }
        const double around = (*best->model.sinceS - beginS) / spanS, step = 1.0 / double(changePoints);
        for (const double beside : {-0.75, -0.5, -0.25, 0.25, 0.5, 0.75})
            tryAt(around + beside * step);
        best->logEvidence -= std::log(double(changePoints));
        fits.push_back(std::move(*best));
    }
}

PairCorrection PairModel::correctionOf(const CauseFit &fit) const
{
    const CauseModel &by = fit.model;
    PairCorrection correction;
    Eigen::Index next = 0;
    for (const auto &[turns, its] :
         {std::pair(by.rotatesA, &correction.turnA), std::pair(by.rotatesB, &correction.turnB)}) {
        if (!turns)
            continue;
        *its = fit.parameters.segment<3>(next);
        next += rotations;
    }
    if (by.sinceS)
        correction.since = fromSeconds(*by.sinceS);
    correction.aboutS = m_middleS;
    if (by.shiftsTime)
        correction.laterS = fit.parameters[next++];
    if (by.changesRate)
        correction.laterPerS = fit.parameters[next++];
    if (by.kind == ContradictionCause::Kind::Height)
        correction.raiseM = fit.parameters[next];
    return correction;
}

double PairModel::medianShiftPx(const FloorView &view, bool isA, const CauseModel &by,
                                const Eigen::VectorXd &parameters) const
{
    std::vector<double> shifts;
    for (const std::size_t i : m_thin) {
        if (by.sinceS && m_common[i].timeS < *by.sinceS)
            continue;
        CauseModel alone = by;
        alone.raises = false;
        const Positions positions = corrected(i, alone, parameters);
        const Eigen::Vector2d &from =
            isA ? m_a[m_common[i].index].position.pointInWorld : m_b[m_common[i].index].position.pointInWorld;
        const Eigen::Vector2d &to = isA ? positions.a : positions.b;
        const auto before = view.pixelFromWorld({from.x(), from.y(), m_priors.planeM}),
                   after = view.pixelFromWorld({to.x(), to.y(), m_priors.planeM});
        if (before && after)
            shifts.push_back((*after - *before).norm());
    }
    return shifts.empty() ? 0 : upperMedian(std::move(shifts));
}

FittedCause PairModel::described(const CauseFit &fit, double logEvidence) const
{
    using Kind = ContradictionCause::Kind;
    const CauseModel &by = fit.model;
    const Eigen::VectorXd &parameters = fit.parameters;
    FittedCause fitted;
    fitted.correction = correctionOf(fit);
    fitted.logEvidence = logEvidence;
    fitted.cause.kind = by.kind;
    fitted.cause.since = fitted.correction.since;
    switch (by.kind) {
    case Kind::CameraMoved:
        fitted.cause.view = by.rotatesA ? 0 : 1;
        fitted.cause.size = medianShiftPx(by.rotatesA ? m_viewA : m_viewB, by.rotatesA, by, parameters);
        break;
    case Kind::CamerasMoved:
        fitted.cause.otherView = 1;
        fitted.cause.size = std::max(medianShiftPx(m_viewA, true, by, parameters),
                                     medianShiftPx(m_viewB, false, by, parameters));
        break;
    case Kind::Offset:
    case Kind::Height:
        fitted.cause.view = 1;
        fitted.cause.size = parameters[0];
        break;
    case Kind::ClockRate:
        fitted.cause.view = 1;
        fitted.cause.size = parameters[1];
        break;
    }
    addOff(fit, fitted);
    return fitted;
}

/// By what a view's position is off at a time at which the other one does not see it.
Eigen::Vector2d PairModel::offAlone(std::size_t index, bool isA, const CauseModel &by,
                                    const Eigen::VectorXd &parameters) const
{
    const std::span<const Sighting> seen = isA ? m_a : m_b;
    const Sighting &here = seen[index];
    Positions positions{here.position.pointInWorld, here.position.pointInWorld};
    const std::size_t before = index - std::min<std::size_t>(index, speedReach),
                      behind = std::min(seen.size() - 1, index + speedReach);
    const double spanS = toSeconds(seen[behind].time - seen[before].time);
    const bool isKnown = seen[before].seen && seen[behind].seen && spanS > 0;
    const Eigen::Vector2d velocityMps =
        isKnown ? Eigen::Vector2d((seen[behind].position.pointInWorld - seen[before].position.pointInWorld) /
                                  spanS)
                : Eigen::Vector2d(Eigen::Vector2d::Zero());
    const auto later = [&](double byS) { return here.position.pointInWorld + byS * velocityMps; };
    const Positions is =
        apply(by, parameters, toSeconds(here.time), positions, later,
              here.position.displacementPerMetreHeight, here.position.displacementPerMetreHeight);
    return (isA ? is.a : is.b) - here.position.pointInWorld;
}

void PairModel::addOff(const CauseFit &fit, FittedCause &fitted) const
{
    constexpr double part = 1e-2; // of a standard deviation
    fitted.offM.assign(m_a.size(), Eigen::Vector2d::Zero());
    fitted.offCovarianceM2.assign(m_a.size(), Eigen::Matrix2d::Zero());
    fitted.sigmaM.assign(m_a.size(), 0);
    const auto add = [&](std::size_t index, const auto &off) {
        const Eigen::Vector2d here = off(fit.parameters);
        Eigen::Matrix<double, 2, Eigen::Dynamic> slope(2, fit.model.size());
        for (Eigen::Index p = 0; p < fit.model.size(); ++p) {
            Eigen::VectorXd moved = fit.parameters;
            const double step =
                part * fit.model.sigmas[static_cast<std::size_t>(p)] * fit.model.scales.front();
            moved[p] += step;
            slope.col(p) = (off(moved) - here) / step;
        }
        fitted.offM[index] = here;
        fitted.offCovarianceM2[index] = slope * fit.covariance * slope.transpose();
    };
    double squares = 0, variances = 0;
    std::size_t next = 0; // of m_common
    for (std::size_t index = 0; index < m_a.size(); ++index) {
        if (next == m_common.size() || m_common[next].index != index) {
            const bool isA = isClear(m_a[index]) || !m_b[index].seen;
            if (m_a[index].seen || m_b[index].seen)
                add(index, [&](const Eigen::VectorXd &by) { return offAlone(index, isA, fit.model, by); });
            continue;
        }
        const std::size_t i = next++;
        const FloorPosition &a = m_a[index].position, &b = m_b[index].position;
        // of two that are widened by as much, each weighs half
        add(index, [&](const Eigen::VectorXd &by) -> Eigen::Vector2d {
            const Positions positions = corrected(i, fit.model, by);
            return (positions.a - a.pointInWorld + positions.b - b.pointInWorld) / 2;
        });
        const Eigen::Matrix2d ofA = statedOf(m_viewA, a).inverse(), ofB = statedOf(m_viewB, b).inverse(),
                              joint = (ofA + ofB).inverse();
        const double variance =
            joint.trace() +
            m_priors.planeSigmaM * m_priors.planeSigmaM *
                (joint * (ofA * a.displacementPerMetreHeight + ofB * b.displacementPerMetreHeight))
                    .squaredNorm();
        fitted.sigmaM[index] = std::sqrt(variance);
        if (fit.model.sinceS && m_common[i].timeS < *fit.model.sinceS)
            continue;
        squares += fitted.offM[index].squaredNorm();
        variances += variance;
    }
    fitted.significance = variances > 0 ? std::sqrt(squares / variances) : 0;
}

std::vector<FittedCause> PairModel::fit() const
{
    if (m_thin.empty())
        return {};
    const Eigen::VectorXd seen = residuals({}, Eigen::VectorXd::Zero(0));
    double none = -HUGE_VAL; // log evidence of errors as stated
    for (std::size_t k = 0; k < m_noises.size(); ++k)
        none = std::max(none, -(seen.dot(m_roots[k].solve(seen)) + m_logDeterminants[k]) / 2 +
                                  logPrior(m_noises[k]));
    std::vector<CauseFit> fits;
    for (const CauseModel &one : lastingCauses()) {
        auto fitted = fitOne(one);
        if (!fitted)
            continue;
        if (one.changesRate || (one.rotatesA && one.rotatesB))
            fitted->logEvidence += logRare;
        fits.push_back(std::move(*fitted));
    }
    addChanges(fits);
    std::ranges::sort(fits, std::greater(), &CauseFit::logEvidence);
    std::vector<FittedCause> causes;
    if (m_isFirstLook && !fits.empty() && fits.front().logEvidence < none - firstDoubt)
        return causes;
    for (const CauseFit &one : fits)
        if (one.logEvidence > fits.front().logEvidence - farLess)
            causes.push_back(described(one, one.logEvidence - none));
    return causes;
}

} // namespace

std::vector<FittedCause> fitCauses(const FloorView &viewA, const FloorView &viewB,
                                   std::span<const Sighting> a, std::span<const Sighting> b,
                                   const PairPriors &priors)
{
    // most views agree, and that is seen at once
    const auto first = PairModel(viewA, viewB, a, b, priors, usualNoises(), true).fit();
    if (first.empty())
        return {};
    return PairModel(viewA, viewB, a, b, priors, possibleNoises(), false).fit();
}

std::vector<ViewTrack> correctedViews(const ViewTrack &a, const ViewTrack &b,
                                      const PairCorrection &correction)
{
    std::vector<ViewTrack> views{a, b};
    views[1].startOffset -= fromSeconds(correction.laterS - correction.laterPerS * correction.aboutS);
    views[1].clockRate += correction.laterPerS;
    const std::array turns{correction.turnA, correction.turnB};
    for (std::size_t v = 0; v < turns.size(); ++v) {
        if (turns[v].isZero())
            continue;
        if (correction.since) {
            views.push_back(views[v]);
            for (std::size_t before = 0; before < 2; ++before)
                for (Observation &one : before == 1 ? views.back().observations : views[v].observations)
                    one.found = one.found && (timeOf(views[v], one) < *correction.since) == (before == 1);
        }
        RigidTransform pose = views[v].floorView->worldFromCamera();
        pose.rotation = Eigen::AngleAxisd(turns[v].norm(), turns[v].normalized()) * pose.rotation;
        views[v].floorView =
            FloorView(views[v].floorView->camera(), pose, views[v].floorView->poseCovariance());
    }
    return views;
}

namespace {

/// At times so much later; between two that are seen.
std::vector<Sighting> shifted(const std::vector<Sighting> &sightings, const PairCorrection &correction)
{
    std::vector<Sighting> all = sightings;
    std::size_t right = 1;
    for (Sighting &one : all) {
        const double timeS = toSeconds(one.time),
                     wantedS = timeS - correction.laterS - correction.laterPerS * (timeS - correction.aboutS);
        while (right + 1 < sightings.size() && toSeconds(sightings[right].time) < wantedS)
            ++right;
        while (right > 1 && toSeconds(sightings[right - 1].time) > wantedS)
            --right;
        const Sighting &before = sightings[right - 1], &behind = sightings[right];
        const double share =
            (wantedS - toSeconds(before.time)) / std::max(1e-9, toSeconds(behind.time - before.time));
        const bool isBetween = before.seen && behind.seen && share >= 0 && share <= 1;
        const Nanoseconds time = one.time;
        one = share < 0.5 ? before : behind;
        one.time = time;
        one.seen = isBetween;
        if (isBetween)
            one.position.pointInWorld =
                (1 - share) * before.position.pointInWorld + share * behind.position.pointInWorld;
    }
    return all;
}

} // namespace

std::vector<std::vector<Sighting>> withoutCorrection(std::vector<std::vector<Sighting>> corrected,
                                                     const FloorView &viewA, const FloorView &viewB,
                                                     const PairCorrection &correction, double planeM)
{
    const std::array turns{std::pair(&viewA, correction.turnA), std::pair(&viewB, correction.turnB)};
    std::size_t earlier = turns.size();
    for (std::size_t v = 0; v < turns.size(); ++v) {
        const auto &[view, turn] = turns[v];
        if (turn.isZero())
            continue;
        for (Sighting &one : corrected[v])
            one.position.pointInWorld =
                turned(view->cameraInWorld(), -turn, one.position.pointInWorld, planeM);
        if (!correction.since)
            continue;
        for (std::size_t i = 0; i < corrected[v].size(); ++i)
            if (corrected[v][i].time < *correction.since)
                corrected[v][i] = corrected[earlier][i];
        ++earlier;
    }
    corrected.resize(turns.size());
    if ((correction.laterS != 0 || correction.laterPerS != 0) && corrected[1].size() > 1)
        corrected[1] = shifted(corrected[1], correction);
    return corrected;
}

} // namespace odo
