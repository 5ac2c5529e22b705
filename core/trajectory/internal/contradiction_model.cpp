// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/contradiction_model.h"

#include "core/base/percentile.h"
#include "core/trajectory/internal/cause_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double firstDoubt = 3; // nats, by which a first look may miss a cause
constexpr double farLess = 20;   // nats, below the best cause

/// By how many pixels a cause shifts what a view sees.
double medianShiftPx(const ComparedPair &pair, bool isA, const CauseFit &fit)
{
    const FloorView &view = isA ? pair.viewA() : pair.viewB();
    std::vector<double> shifts;
    CauseModel alone = fit.model;
    alone.raises = false;
    for (const std::size_t i : pair.compared()) {
        const CommonTime &common = pair.common()[i];
        if (alone.sinceS && common.timeS < *alone.sinceS)
            continue;
        const PairPositions positions = pair.corrected(i, alone, fit.parameters);
        const Eigen::Vector2d &from = (isA ? pair.a() : pair.b())[common.index].position.pointInWorld;
        const Eigen::Vector2d &to = isA ? positions.a : positions.b;
        const auto before = view.pixelFromWorld({from.x(), from.y(), pair.priors().planeM}),
                   after = view.pixelFromWorld({to.x(), to.y(), pair.priors().planeM});
        if (before && after)
            shifts.push_back((*after - *before).norm());
    }
    return shifts.empty() ? 0 : upperMedian(std::move(shifts));
}

ContradictionCause causeOf(const ComparedPair &pair, const CauseFit &fit)
{
    using Kind = ContradictionCause::Kind;
    ContradictionCause cause;
    cause.kind = fit.model.kind;
    switch (cause.kind) {
    case Kind::CameraMoved:
        cause.view = fit.model.rotatesA ? 0 : 1;
        cause.size = medianShiftPx(pair, fit.model.rotatesA, fit);
        break;
    case Kind::CamerasMoved:
        cause.otherView = 1;
        cause.size = std::max(medianShiftPx(pair, true, fit), medianShiftPx(pair, false, fit));
        break;
    case Kind::Offset:
    case Kind::Height:
        cause.view = 1;
        cause.size = fit.parameters[0];
        break;
    case Kind::ClockRate:
        cause.view = 1;
        cause.size = fit.parameters[1];
        break;
    }
    return cause;
}

/// Variance of the fused position as stated, both coordinates together.
double fusedVariance(const ComparedPair &pair, const FloorPosition &a, const FloorPosition &b)
{
    const Eigen::Matrix2d ofA = pair.statedOf(pair.viewA(), a).inverse(),
                          ofB = pair.statedOf(pair.viewB(), b).inverse(), joint = (ofA + ofB).inverse();
    const Eigen::Vector2d perHeight =
        joint * (ofA * a.displacementPerMetreHeight + ofB * b.displacementPerMetreHeight);
    const double planeSigmaM = pair.priors().planeSigmaM;
    return joint.trace() + planeSigmaM * planeSigmaM * perHeight.squaredNorm();
}

/// Sets by what a cause moves the position at each time, and how well that is known.
class OffByCause
{
public:
    OffByCause(const ComparedPair &pair, const CauseFit &fit, FittedCause &fitted)
        : m_pair(pair), m_fit(fit), m_fitted(fitted)
    {
        const std::size_t times = pair.a().size();
        fitted.offM.assign(times, Eigen::Vector2d::Zero());
        fitted.offCovarianceM2.assign(times, Eigen::Matrix2d::Zero());
        fitted.sigmaM.assign(times, 0);
        std::size_t next = 0; // of the common times
        for (std::size_t index = 0; index < times; ++index) {
            if (next < pair.common().size() && pair.common()[next].index == index)
                setCommon(next++);
            else if (pair.a()[index].seen || pair.b()[index].seen)
                setAlone(index);
        }
        fitted.significance = m_variances > 0 ? std::sqrt(m_squares / m_variances) : 0;
    }

private:
    template <class Off>
    void set(std::size_t index, const Off &off)
    {
        constexpr double part = 1e-2; // of a standard deviation
        const CauseModel &model = m_fit.model;
        const Eigen::Vector2d here = off(m_fit.parameters);
        Eigen::Matrix<double, 2, Eigen::Dynamic> slope(2, model.size());
        for (Eigen::Index p = 0; p < model.size(); ++p) {
            Eigen::VectorXd moved = m_fit.parameters;
            const double step = part * model.sigmas[static_cast<std::size_t>(p)] * model.scales.front();
            moved[p] += step;
            slope.col(p) = (off(moved) - here) / step;
        }
        m_fitted.offM[index] = here;
        m_fitted.offCovarianceM2[index] = slope * m_fit.covariance * slope.transpose();
    }
    void setAlone(std::size_t index)
    {
        const bool isA = isClear(m_pair.a()[index]) || !m_pair.b()[index].seen;
        set(index, [&](const Eigen::VectorXd &by) { return m_pair.offAlone(index, isA, m_fit.model, by); });
    }
    void setCommon(std::size_t i)
    {
        const CommonTime &common = m_pair.common()[i];
        const FloorPosition &a = m_pair.a()[common.index].position, &b = m_pair.b()[common.index].position;
        // of two that are widened by as much, each weighs half
        set(common.index, [&](const Eigen::VectorXd &by) -> Eigen::Vector2d {
            const PairPositions positions = m_pair.corrected(i, m_fit.model, by);
            return (positions.a - a.pointInWorld + positions.b - b.pointInWorld) / 2;
        });
        const double variance = fusedVariance(m_pair, a, b);
        m_fitted.sigmaM[common.index] = std::sqrt(variance);
        if (m_fit.model.sinceS && common.timeS < *m_fit.model.sinceS)
            return;
        m_squares += m_fitted.offM[common.index].squaredNorm();
        m_variances += variance;
    }

    const ComparedPair &m_pair;
    const CauseFit &m_fit;
    FittedCause &m_fitted;
    double m_squares = 0, m_variances = 0; ///< of offM and sigmaM, while the cause is there
};

FittedCause described(const ComparedPair &pair, const CauseFit &fit, double logEvidence)
{
    FittedCause fitted;
    fitted.correction = correctionBy(fit.model, fit.parameters, pair.middleS());
    fitted.logEvidence = logEvidence;
    fitted.cause = causeOf(pair, fit);
    fitted.cause.since = fitted.correction.since;
    OffByCause(pair, fit, fitted);
    return fitted;
}

std::vector<FittedCause> causesOf(const ComparedPair &pair, bool isFirstLook)
{
    const PairErrors errors(pair, noisesToTry(isFirstLook));
    const double none = errors.logEvidence(pair.residuals({}, Eigen::VectorXd::Zero(0)));
    const std::vector<CauseFit> fits = fitAllCauses(pair, errors, isFirstLook);
    std::vector<FittedCause> causes;
    if (isFirstLook && !fits.empty() && fits.front().logEvidence < none - firstDoubt)
        return causes;
    for (const CauseFit &one : fits)
        if (one.logEvidence > fits.front().logEvidence - farLess)
            causes.push_back(described(pair, one, one.logEvidence - none));
    return causes;
}

} // namespace

std::vector<FittedCause> fitCauses(const FloorView &viewA, const FloorView &viewB,
                                   std::span<const Sighting> a, std::span<const Sighting> b,
                                   const PairPriors &priors)
{
    const ComparedPair pair(viewA, viewB, a, b, priors);
    if (pair.compared().empty())
        return {};
    // most views agree, and that is seen at once
    if (causesOf(pair, true).empty())
        return {};
    return causesOf(pair, false);
}

} // namespace odo
