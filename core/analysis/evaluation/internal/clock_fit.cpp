// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/evaluation/internal/clock_fit.h"

#include "core/analysis/evaluation/internal/log_stretch.h"
#include "core/analysis/evaluation/internal/offset_search.h"
#include "core/base/percentile.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double stretchS = 2, stretchInLogSteps = 20;
constexpr std::size_t fewestInStretch = 6, fewestForRate = 4;
constexpr double groupS = 0.01; // positions within it say as much as their mean
constexpr int mostRounds = 40, patientRounds = 20;
constexpr double mostStepS = 0.25, smallStepS = 1e-7, smallScaleStep = 1e-7, smallStepSigmas = 0.1;
constexpr double correlatedS = 0.5;
constexpr double sigmasForRate = 3.5, largestRate = 0.0225, mostOfRate = 0.4;
constexpr double misfit = 16, sigmasForBetter = 4;
constexpr double clearOfNoise = 4; // chance does not give that in half a second of independent noise
constexpr double relevantShare = 0.25;

/// The means of neighbours.
std::vector<LogPose> meansOfNeighbours(const std::vector<LogPose> &log)
{
    std::vector<LogPose> means;
    for (std::size_t from = 0, to = 0; from < log.size(); from = to) {
        LogPose mean;
        for (; to < log.size() && log[to].timeS < log[from].timeS + groupS; ++to) {
            mean.timeS += log[to].timeS;
            mean.position += log[to].position;
        }
        mean.timeS /= double(to - from);
        mean.position /= double(to - from);
        means.push_back(mean);
    }
    return means;
}

/// All stretches under a clock and a scale.
class ClockSystem
{
public:
    ClockSystem(const MeasuredCourse &course, const std::vector<LogPose> &log)
        : m_course(course), m_log(meansOfNeighbours(log)), m_stepS(usualLogStepS(m_log)),
          m_stretchS(std::max(stretchS, stretchInLogSteps * m_stepS))
    {
    }

    void linearise(const LogClock &clock, double scale)
    {
        m_stretches.clear();
        std::vector<TimedPair> pairs;
        std::size_t number = 0;
        const auto finish = [&] {
            if (pairs.size() >= fewestInStretch) {
                m_stretches.push_back(stretchOf(pairs, clock.middleS, scale));
            }
            pairs.clear();
        };
        for (const LogPose &pose : m_log) {
            const auto its = std::size_t((pose.timeS - m_log.front().timeS) / m_stretchS);
            if (its != number)
                finish();
            number = its;
            if (const auto measured = m_course.at(clock.trialTimeS(pose.timeS)))
                pairs.push_back({pose.timeS, pose.position, *measured});
        }
        finish();
    }

    /// Those that fit worse than usual are trusted less, by the inverse of their variance and the usual one.
    void weigh()
    {
        std::vector<double> variances;
        for (const LogStretch &stretch : m_stretches)
            if (stretch.relevance() > relevantShare)
                variances.push_back(stretch.variance());
        const double usual = median(std::move(variances));
        for (LogStretch &stretch : m_stretches)
            if (usual > 0)
                stretch.trust = 2 * usual / (usual + stretch.variance());
    }

    const std::vector<LogStretch> &stretches() const { return m_stretches; }
    double stepS() const { return m_stepS; }
    /// Of the log's clock, half-way between the first and the last time in common.
    std::optional<double> middleS() const
    {
        if (m_stretches.empty())
            return std::nullopt;
        return (m_stretches.front().timesS.front() + m_stretches.back().timesS.back()) / 2;
    }

private:
    const MeasuredCourse &m_course;
    std::vector<LogPose> m_log;
    double m_stepS, m_stretchS;
    std::vector<LogStretch> m_stretches;
};

/// The normal equations of some of the columns.
struct Normal
{
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero(); ///< 1 where a parameter is not fitted
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    Eigen::Vector3d noise = Eigen::Vector3d::Zero(); ///< in its diagonal
};

Normal normalOf(const std::vector<LogStretch> &stretches, bool withRate)
{
    Normal normal;
    for (const LogStretch &stretch : stretches) {
        const double weight = stretch.weight();
        normal.information += weight * stretch.information();
        normal.right -= weight * stretch.columns.transpose() * stretch.left;
        normal.noise += weight * Eigen::Vector3d(stretch.noise, stretch.noiseOfRate, 0);
    }
    if (!withRate) {
        normal.information.row(1).setZero();
        normal.information.col(1).setZero();
        normal.information(1, 1) = 1;
        normal.right[1] = normal.noise[1] = 0;
    }
    return normal;
}

/// The residuals' autocovariance at whole steps, up to correlatedS, tapered to stay positive.
std::vector<double> autocovariance(const std::vector<LogStretch> &stretches, double stepS)
{
    const auto lags = std::size_t(std::ceil(correlatedS / std::max(stepS, 1e-6))) + 1;
    std::vector<double> sums(lags, 0), counts(lags, 0);
    for (const LogStretch &stretch : stretches) {
        const double share = stretch.freedom() / double(stretch.left.size());
        for (std::size_t i = 0; i < stretch.timesS.size(); ++i)
            for (std::size_t j = i; j < stretch.timesS.size(); ++j) {
                const auto lag = std::size_t(std::lround((stretch.timesS[j] - stretch.timesS[i]) / stepS));
                if (lag >= lags)
                    break;
                sums[lag] += stretch.trust * stretch.left.segment<2>(Eigen::Index(2 * i))
                                                 .dot(stretch.left.segment<2>(Eigen::Index(2 * j)));
                counts[lag] += 2 * share;
            }
    }
    for (std::size_t lag = 0; lag < lags; ++lag)
        sums[lag] = counts[lag] > 0 ? sums[lag] / counts[lag] * (1 - double(lag) / double(lags)) : 0;
    return sums;
}

/// Σ over pairs of rows of column · autocovariance · column.
Eigen::Matrix3d scatterOf(const std::vector<LogStretch> &stretches, double stepS)
{
    const std::vector<double> covariance = autocovariance(stretches, stepS);
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const LogStretch &stretch : stretches)
        for (std::size_t i = 0; i < stretch.timesS.size(); ++i)
            for (std::size_t j = i; j < stretch.timesS.size(); ++j) {
                const auto lag = std::size_t(std::lround((stretch.timesS[j] - stretch.timesS[i]) / stepS));
                if (lag >= covariance.size())
                    break;
                const Eigen::Matrix3d product =
                    stretch.columns.middleRows<2>(Eigen::Index(2 * i)).transpose() *
                    stretch.columns.middleRows<2>(Eigen::Index(2 * j));
                scatter += stretch.weight() * stretch.relevance() * covariance[lag] *
                           (i == j ? product : Eigen::Matrix3d(product + product.transpose()));
            }
    return scatter;
}

/// The scatter of what each stretch says, as if it had no part in the fit (as a jackknife): whatever their
/// residuals share within.
Eigen::Matrix3d scatterBetween(const std::vector<LogStretch> &stretches, const Eigen::Matrix3d &inverse,
                               bool withRate)
{
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const LogStretch &stretch : stretches) {
        ClockColumns columns = stretch.columns;
        if (!withRate)
            columns.col(1).setZero();
        const Eigen::Matrix3d part =
            Eigen::Matrix3d::Identity() - stretch.weight() * columns.transpose() * columns * inverse;
        const Eigen::Vector3d says = part.completeOrthogonalDecomposition().solve(
            stretch.weight() * columns.transpose() * stretch.left);
        scatter += says * says.transpose();
    }
    return scatter;
}

/// The covariance of the parameters; nullopt where noise alone is as much information.
std::optional<Eigen::Matrix3d> covarianceOf(const ClockSystem &system, bool withRate)
{
    const Normal normal = normalOf(system.stretches(), withRate);
    Eigen::Matrix3d known = normal.information;
    known.diagonal() -= normal.noise;
    const Eigen::LDLT<Eigen::Matrix3d> solver(known);
    if (solver.info() != Eigen::Success || !solver.isPositive())
        return std::nullopt;
    const Eigen::Matrix3d inverse = solver.solve(Eigen::Matrix3d::Identity());
    Eigen::Matrix3d scatter = scatterOf(system.stretches(), system.stepS());
    if (!withRate) {
        scatter.row(1).setZero();
        scatter.col(1).setZero();
    }
    const Eigen::Matrix3d within = inverse * scatter * inverse,
                          between = inverse * scatterBetween(system.stretches(), inverse, withRate) * inverse;
    return Eigen::Matrix3d(within.cwiseMax(between)); // of which the diagonal counts
}

/// How much of what is known of the rate, once offset and scale are fitted, comes from the stretch that says
/// most. In a single one, an odometry that errs looks like a clock that does: round a circle a change of rate
/// is one of curvature and scale.
double largestPartOfRate(const std::vector<LogStretch> &stretches)
{
    const Eigen::Matrix3d inverse =
        normalOf(stretches, true).information.completeOrthogonalDecomposition().pseudoInverse();
    double largest = 0, all = 0;
    for (const LogStretch &stretch : stretches) {
        const double its = stretch.weight() * (stretch.columns * inverse.col(1)).squaredNorm();
        largest = std::max(largest, its);
        all += its;
    }
    return all > 0 ? largest / all : 1;
}

/// The rows' number, less for what neighbours share.
double independentRows(const ClockSystem &system)
{
    const std::vector<double> covariance = autocovariance(system.stretches(), system.stepS());
    double alike = 1, rows = 0;
    for (std::size_t lag = 1; lag < covariance.size() && covariance[lag] > 0; ++lag)
        alike += 2 * covariance[lag] / covariance.front();
    for (const LogStretch &stretch : system.stretches())
        rows += stretch.freedom();
    return rows / alike;
}

/// Gauss–Newton from a guess; nullopt where it does not converge.
std::optional<LogClockFit> refined(ClockSystem &system, LogClockFit fit, bool withRate)
{
    fit.leftM2.clear();
    for (int round = 0; round < mostRounds; ++round) {
        system.linearise(fit.clock, fit.scale);
        if (system.stretches().empty())
            return std::nullopt;
        system.weigh();
        const Normal normal = normalOf(system.stretches(), withRate);
        const Eigen::Vector3d step = normal.information.completeOrthogonalDecomposition().solve(normal.right);
        if (!step.allFinite())
            return std::nullopt;
        const double shortened = std::min(1.0, mostStepS / std::max(std::abs(step[0]), 1e-12));
        fit.clock.offsetS += shortened * step[0];
        fit.clock.rate += shortened * step[1];
        fit.scale *= std::exp(std::clamp(shortened * step[2], -0.5, 0.5));
        const bool isSmall = std::abs(step[0]) < smallStepS && std::abs(step[2]) < smallScaleStep;
        if (!isSmall && round < patientRounds)
            continue;
        const auto covariance = covarianceOf(system, withRate);
        if (!covariance)
            return std::nullopt;
        fit.clock.sigmaOffsetS = std::sqrt((*covariance)(0, 0));
        fit.clock.sigmaRate = std::sqrt((*covariance)(1, 1));
        // A pose at an end of the run may come and go.
        if (isSmall || std::abs(step[0]) < smallStepSigmas * fit.clock.sigmaOffsetS) {
            for (const LogStretch &stretch : system.stretches())
                fit.leftM2.push_back(stretch.variance());
            fit.independent = independentRows(system);
            return fit;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<LogClockFit> fitClock(const MeasuredCourse &course, const std::vector<LogPose> &log,
                                    const LogClock &guess, double scale)
{
    ClockSystem system(course, log);
    LogClockFit start;
    start.clock = guess;
    start.scale = scale;
    system.linearise(start.clock, start.scale);
    const auto middleS = system.middleS();
    if (!middleS)
        return std::nullopt;
    start.clock.offsetS += start.clock.rate * (*middleS - start.clock.middleS);
    start.clock.middleS = *middleS;
    const auto steady = refined(system, start, false);
    if (!steady || steady->leftM2.size() < fewestForRate)
        return steady;
    const auto changing = refined(system, *steady, true);
    if (!changing || !(std::abs(changing->clock.rate) < largestRate) ||
        largestPartOfRate(system.stretches()) > mostOfRate)
        return steady;
    if (std::abs(changing->clock.rate) > sigmasForRate * changing->clock.sigmaRate)
        return changing;
    LogClockFit without = *steady;
    without.clock.sigmaRate = changing->clock.sigmaRate;
    return without;
}

double meanLeftM2(const LogClockFit &fit, double usualM2)
{
    double sum = 0;
    for (const double left : fit.leftM2)
        sum += std::min(left, misfit * usualM2);
    return sum / double(fit.leftM2.size());
}

bool fitsAlike(const LogClockFit &best, const LogClockFit &other)
{
    const double usual = median(best.leftM2);
    const double sigma = std::sqrt(2 / best.independent + 2 / other.independent);
    return meanLeftM2(other, usual) < (1 + sigmasForBetter * sigma) * meanLeftM2(best, usual);
}

bool tellsTime(const MeasuredCourse &course)
{
    std::vector<LogPose> itself;
    for (const RunInstant &instant : course.instants())
        itself.push_back({instant.timeS, instant.point->position});
    ClockSystem system(course, itself);
    system.linearise({}, 1);
    const auto &stretches = system.stretches();
    return std::ranges::any_of(stretches, [](const LogStretch &stretch) {
        return stretch.columns.col(0).squaredNorm() > clearOfNoise * stretch.noise;
    });
}

} // namespace odo
