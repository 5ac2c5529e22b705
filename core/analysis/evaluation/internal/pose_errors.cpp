// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/evaluation/internal/pose_errors.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double halfTurnRad = std::numbers::pi;
constexpr double deltaTolerance = 0.1; // as evo's --delta_tol
constexpr double firstStretchM = 0.5, firstStretchShare = 0.25;
constexpr double mirroredShare = 0.25;
constexpr double lastingErrorRad = 5 * halfTurnRad / 180, sigmasForLasting = 5;

Eigen::Vector2d turnedBy(const Eigen::Vector2d &point, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * point.x() - s * point.y(), s * point.x() + c * point.y()};
}

double crossOf(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Distances along the polyline of the measured positions.
std::vector<double> stationsOf(const std::vector<PosePair> &pairs)
{
    std::vector<double> stations(pairs.size(), 0);
    for (std::size_t i = 1; i < pairs.size(); ++i)
        stations[i] = stations[i - 1] + (pairs[i].measured.position - pairs[i - 1].measured.position).norm();
    return stations;
}

/// Σ of what is squared, by its number.
class MeanSquare
{
public:
    void add(double square)
    {
        m_sum += square;
        m_count += 1;
    }
    double root() const { return m_count > 0 ? std::sqrt(m_sum / m_count) : 0; }

private:
    double m_sum = 0, m_count = 0;
};

double offsetVariance(const CoursePose &pose, double sigmaOffsetS)
{
    return pose.velocity.squaredNorm() * sigmaOffsetS * sigmaOffsetS;
}

double headingError(const PosePair &pair, const PlaneSimilarity &transform)
{
    return std::remainder(*pair.log.headingRad + transform.headingRad - *pair.measured.headingRad,
                          2 * halfTurnRad);
}

} // namespace

PlaneSimilarity leastSquaresAlignment(const std::vector<PosePair> &pairs, bool withScale)
{
    Eigen::Vector2d log = Eigen::Vector2d::Zero(), measured = Eigen::Vector2d::Zero();
    for (const PosePair &pair : pairs) {
        log += pair.log.position / double(pairs.size());
        measured += pair.measured.position / double(pairs.size());
    }
    double along = 0, across = 0, squares = 0;
    for (const PosePair &pair : pairs) {
        const Eigen::Vector2d from = pair.log.position - log, to = pair.measured.position - measured;
        along += from.dot(to);
        across += crossOf(from, to);
        squares += from.squaredNorm();
    }
    PlaneSimilarity result;
    result.headingRad = std::atan2(across, along);
    if (withScale && squares > 0)
        result.scale = std::hypot(along, across) / squares;
    result.shiftM = measured - result.scale * turnedBy(log, result.headingRad);
    return result;
}

bool isMirrored(const std::vector<PosePair> &pairs)
{
    std::vector<PosePair> mirrored = pairs;
    for (PosePair &pair : mirrored)
        pair.log.position.y() = -pair.log.position.y();
    const auto left = [](const std::vector<PosePair> &some) {
        return absoluteErrors(some, leastSquaresAlignment(some, true), 0).rmse;
    };
    return left(mirrored) < mirroredShare * left(pairs);
}

OriginAlignment originAlignment(const std::vector<PosePair> &pairs)
{
    const PosePair &first = pairs.front();
    const std::vector<double> stations = stationsOf(pairs);
    const double stretchM = std::min(firstStretchM, firstStretchShare * stations.back());
    double along = 0, across = 0, reachM2 = 0;
    for (std::size_t i = 0; i < pairs.size() && stations[i] <= stretchM; ++i) {
        const Eigen::Vector2d from = pairs[i].log.position - first.log.position,
                              to = pairs[i].measured.position - first.measured.position;
        along += from.dot(to);
        across += crossOf(from, to);
        reachM2 = std::max(reachM2, to.squaredNorm());
    }
    OriginAlignment result;
    result.transform.headingRad = std::atan2(across, along);
    // of a line through the first pose whose positions err alike: √2 of one over the length
    result.sigmaHeadingRad = reachM2 > 0 ? std::sqrt(first.measured.ownVarianceM2 / reachM2) : halfTurnRad;
    if (first.haveHeadings() && first.measured.sigmaHeadingRad < result.sigmaHeadingRad) {
        result.isTurnedByHeading = true;
        result.sigmaHeadingRad = first.measured.sigmaHeadingRad;
        result.transform.headingRad =
            std::remainder(*first.measured.headingRad - *first.log.headingRad, 2 * halfTurnRad);
    }
    result.transform.shiftM =
        first.measured.position - turnedBy(first.log.position, result.transform.headingRad);
    return result;
}

ErrorStatistics absoluteErrors(const std::vector<PosePair> &pairs, const PlaneSimilarity &transform,
                               double sigmaOffsetS, const OriginAlignment *origin)
{
    std::vector<double> errors;
    MeanSquare measurement;
    const auto ofAlignment = [&](const PosePair &pair) {
        const double turnedM =
            origin->sigmaHeadingRad * (pair.measured.position - pairs.front().measured.position).norm();
        return pairs.front().measured.ownVarianceM2 + turnedM * turnedM;
    };
    for (const PosePair &pair : pairs) {
        errors.push_back((transform(pair.log.position) - pair.measured.position).norm());
        measurement.add(pair.measured.varianceM2 + offsetVariance(pair.measured, sigmaOffsetS) +
                        (origin ? ofAlignment(pair) : 0));
    }
    ErrorStatistics statistics = statisticsOf(std::move(errors));
    statistics.measurementSigma = measurement.root();
    return statistics;
}

std::vector<PathStep> stepsOf(const std::vector<PosePair> &pairs, double deltaM)
{
    const std::vector<double> stations = stationsOf(pairs);
    std::vector<PathStep> steps;
    for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
        const auto begin = stations.begin() + std::ptrdiff_t(i) + 1;
        auto nearest = std::lower_bound(begin, stations.end(), stations[i] + deltaM);
        const auto miss = [&](auto at) { return std::abs(*at - stations[i] - deltaM); };
        if (nearest != begin) {
            // of several at one distance the first
            const auto before = std::lower_bound(begin, nearest, *(nearest - 1));
            if (nearest == stations.end() || miss(before) <= miss(nearest))
                nearest = before;
        }
        const auto to = std::size_t(nearest - stations.begin());
        if (miss(nearest) <= deltaTolerance * deltaM && pairs[i].measured.piece == pairs[to].measured.piece)
            steps.push_back({i, to});
    }
    return steps;
}

std::optional<ErrorStatistics> relativeErrors(const std::vector<PosePair> &pairs,
                                              const std::vector<PathStep> &steps,
                                              const PlaneSimilarity &transform, bool byHeadings,
                                              double scaleSigma, double sigmaOffsetS)
{
    std::vector<double> errors;
    MeanSquare measurement;
    for (const PathStep &step : steps) {
        const PosePair &from = pairs[step.from], &to = pairs[step.to];
        if (byHeadings && !from.haveHeadings())
            continue;
        Eigen::Vector2d own = transform.scale * (to.log.position - from.log.position),
                        seen = to.measured.position - from.measured.position;
        double variance =
            from.measured.ownVarianceM2 + to.measured.ownVarianceM2 +
            scaleSigma * scaleSigma * seen.squaredNorm() +
            (to.measured.velocity - from.measured.velocity).squaredNorm() * sigmaOffsetS * sigmaOffsetS;
        if (byHeadings) {
            own = turnedBy(own, -*from.log.headingRad);
            seen = turnedBy(seen, -*from.measured.headingRad);
            variance += seen.squaredNorm() * from.measured.sigmaHeadingRad * from.measured.sigmaHeadingRad;
        } else {
            own = turnedBy(own, transform.headingRad);
        }
        errors.push_back((own - seen).norm());
        measurement.add(variance);
    }
    if (errors.empty())
        return std::nullopt;
    ErrorStatistics statistics = statisticsOf(std::move(errors));
    statistics.measurementSigma = measurement.root();
    return statistics;
}

std::optional<ErrorStatistics> headingErrors(const std::vector<PosePair> &pairs,
                                             const PlaneSimilarity &transform, const OriginAlignment *origin)
{
    std::vector<double> errors;
    MeanSquare measurement;
    const double sigmaOfAlignment = origin ? origin->sigmaHeadingRad : 0;
    for (const PosePair &pair : pairs) {
        if (!pair.haveHeadings())
            continue;
        errors.push_back(std::abs(headingError(pair, transform)));
        measurement.add(pair.measured.sigmaHeadingRad * pair.measured.sigmaHeadingRad +
                        sigmaOfAlignment * sigmaOfAlignment);
    }
    if (errors.empty())
        return std::nullopt;
    ErrorStatistics statistics = statisticsOf(std::move(errors));
    statistics.measurementSigma = measurement.root();
    return statistics;
}

std::optional<double> lastingHeadingError(const std::vector<PosePair> &pairs,
                                          const PlaneSimilarity &transform)
{
    std::vector<double> differences, scatter;
    MeanSquare measurement;
    Eigen::Vector2d directions = Eigen::Vector2d::Zero();
    for (const PosePair &pair : pairs) {
        if (!pair.haveHeadings())
            continue;
        differences.push_back(headingError(pair, transform));
        directions += Eigen::Vector2d(std::cos(differences.back()), std::sin(differences.back()));
        measurement.add(pair.measured.sigmaHeadingRad * pair.measured.sigmaHeadingRad);
    }
    if (differences.empty())
        return std::nullopt;
    const double middle = std::atan2(directions.y(), directions.x());
    for (const double difference : differences)
        scatter.push_back(std::abs(std::remainder(difference - middle, 2 * halfTurnRad)));
    const double least =
        std::max({lastingErrorRad, sigmasForLasting * measurement.root(), 2 * median(std::move(scatter))});
    return std::abs(middle) > least ? std::optional(middle) : std::nullopt;
}

} // namespace odo
