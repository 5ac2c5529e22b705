// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/evaluation/internal/offset_search.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace odo {

namespace {

constexpr double leastSpanS = 0.25; // noise of a millimetre is 6 mm/s over it
constexpr double stepsInSpan = 3;   // of the track that has fewer
constexpr double stepsPerSpan = 8;
constexpr double clearlyExplained = 0.9; // else noise may hide it, which longer spans smooth
constexpr double mostProducts = 1e8;     // some tenths of a second
constexpr double leastCommonShare = 0.5;
constexpr double leastCommonS = 1;
constexpr double longestLogStepS = 0.5; // is joined by a line; longer ones where it has longer ones as a rule
constexpr double longestInLogSteps = 5;
constexpr double radianAsM = 0.1; // half the track of a small robot: turning by the speed of its wheels
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A track at even times.
struct EvenTrack
{
    double beginS = 0;
    std::vector<Eigen::Vector2d> positions; ///< NaN: not known
    std::vector<double> headings;           ///< NaN: not known
};

/// Speed, bending and turning at even times, m/s.
struct MotionCurves
{
    static constexpr std::size_t count = 3;
    std::array<std::vector<double>, count> values;
    std::size_t known = 0; ///< of the first
};

EvenTrack resampled(const MeasuredCourse &course, double stepS)
{
    EvenTrack track;
    track.beginS = course.firstS();
    const auto count = std::size_t((course.lastS() - course.firstS()) / stepS) + 1;
    for (std::size_t i = 0; i < count; ++i) {
        const auto pose = course.at(course.firstS() + double(i) * stepS);
        track.positions.push_back(pose ? pose->position : Eigen::Vector2d(unknown, unknown));
        track.headings.push_back(pose ? pose->headingRad.value_or(unknown) : unknown);
    }
    return track;
}

EvenTrack resampled(const std::vector<LogPose> &log, double stepS)
{
    EvenTrack track;
    track.beginS = log.front().timeS;
    const double longestS = std::max(longestLogStepS, longestInLogSteps * usualLogStepS(log));
    const auto count = std::size_t((log.back().timeS - log.front().timeS) / stepS) + 1;
    std::size_t next = 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double timeS = log.front().timeS + double(i) * stepS;
        while (next + 1 < log.size() && log[next].timeS < timeS)
            ++next;
        const LogPose &from = log[next - 1], &to = log[next];
        const double lengthS = to.timeS - from.timeS;
        if (lengthS > longestS) {
            track.positions.emplace_back(unknown, unknown);
            track.headings.push_back(unknown);
            continue;
        }
        const double part = (timeS - from.timeS) / lengthS;
        track.positions.push_back((1 - part) * from.position + part * to.position);
        track.headings.push_back(
            from.headingRad && to.headingRad
                ? *from.headingRad +
                      part * std::remainder(*to.headingRad - *from.headingRad, 2 * std::numbers::pi)
                : unknown);
    }
    return track;
}

MotionCurves curvesOf(const EvenTrack &track, std::size_t half, double stepS)
{
    const double spanS = 2 * double(half) * stepS;
    MotionCurves curves;
    for (auto &values : curves.values)
        values.assign(track.positions.size(), unknown);
    for (std::size_t i = half; i + half < track.positions.size(); ++i) {
        const Eigen::Vector2d before = track.positions[i] - track.positions[i - half],
                              behind = track.positions[i + half] - track.positions[i];
        curves.values[0][i] = (before + behind).norm() / spanS;
        const double longer = std::max(before.norm(), behind.norm());
        const double across = before.x() * behind.y() - before.y() * behind.x();
        curves.values[1][i] = longer > 0 ? across / longer / spanS : across;
        curves.values[2][i] =
            radianAsM *
            std::remainder(track.headings[i + half] - track.headings[i - half], 2 * std::numbers::pi) / spanS;
        curves.known += std::isnan(curves.values[0][i]) ? 0 : 1;
    }
    return curves;
}

/// What two curves have in common at one shift.
struct CommonPart
{
    double count = 0, sumA = 0, sumB = 0, squaresA = 0, squaresB = 0, products = 0;

    void add(double a, double b)
    {
        count += 1;
        sumA += a;
        sumB += b;
        squaresA += a * a;
        squaresB += b * b;
        products += a * b;
    }
    double varianceA() const { return count > 0 ? squaresA - sumA * sumA / count : 0; }
    double varianceB() const { return count > 0 ? squaresB - sumB * sumB / count : 0; }
    double covariance() const { return count > 0 ? products - sumA * sumB / count : 0; }
};

/// Index i of the first belongs to i − shift of the second.
CommonPart commonAt(const std::vector<double> &first, const std::vector<double> &second, std::ptrdiff_t shift)
{
    CommonPart common;
    const auto begin = std::max<std::ptrdiff_t>(0, shift);
    const auto end = std::min(std::ptrdiff_t(first.size()), std::ptrdiff_t(second.size()) + shift);
    for (std::ptrdiff_t i = begin; i < end; ++i) {
        const double a = first[std::size_t(i)], b = second[std::size_t(i - shift)];
        if (!std::isnan(a) && !std::isnan(b))
            common.add(a, b);
    }
    return common;
}

/// The agreement at each shift from the lowest on.
class ShiftSearch
{
public:
    ShiftSearch(const MotionCurves &measured, const MotionCurves &log, double stepS)
        : m_measured(measured), m_log(log),
          m_leastCommon(
              std::max(leastCommonShare * double(std::min(measured.known, log.known)), leastCommonS / stepS))
    {
    }

    OffsetCandidate at(std::ptrdiff_t shift) const
    {
        OffsetCandidate candidate;
        double covariance = 0, varianceA = 0, varianceB = 0;
        for (std::size_t curve = 0; curve < MotionCurves::count; ++curve) {
            const CommonPart common = commonAt(m_measured.values[curve], m_log.values[curve], shift);
            if (curve == 0 && common.count < m_leastCommon)
                return candidate;
            covariance += common.covariance();
            varianceA += common.varianceA();
            varianceB += common.varianceB();
        }
        if (!(covariance > 0) || !(varianceA > 0) || !(varianceB > 0))
            return candidate;
        candidate.explained = covariance * covariance / (varianceA * varianceB);
        candidate.scale = std::sqrt(varianceA / varianceB);
        return candidate;
    }

private:
    const MotionCurves &m_measured, &m_log;
    double m_leastCommon;
};

} // namespace

namespace {

std::vector<OffsetCandidate> findOffsets(const MeasuredCourse &course, const std::vector<LogPose> &log,
                                         double spanS)
{
    const double courseS = course.lastS() - course.firstS(), logS = log.back().timeS - log.front().timeS;
    const double stepS = std::max(spanS / stepsPerSpan, std::sqrt(courseS * logS / mostProducts));
    const auto half = std::size_t(std::max(1.0, std::round(spanS / stepS / 2)));
    const EvenTrack evenCourse = resampled(course, stepS), evenLog = resampled(log, stepS);
    const MotionCurves measured = curvesOf(evenCourse, half, stepS), own = curvesOf(evenLog, half, stepS);
    const ShiftSearch search(measured, own, stepS);
    const auto lowest = -std::ptrdiff_t(evenLog.positions.size()),
               highest = std::ptrdiff_t(evenCourse.positions.size());
    std::vector<OffsetCandidate> all;
    for (std::ptrdiff_t shift = lowest; shift <= highest; ++shift) {
        OffsetCandidate candidate = search.at(shift);
        candidate.offsetS = evenCourse.beginS - evenLog.beginS + double(shift) * stepS;
        all.push_back(candidate);
    }
    std::vector<OffsetCandidate> peaks;
    for (std::size_t i = 1; i + 1 < all.size(); ++i)
        if (all[i].explained > 0 && all[i].explained >= all[i - 1].explained &&
            all[i].explained > all[i + 1].explained)
            peaks.push_back(all[i]);
    std::ranges::sort(peaks, std::ranges::greater(), &OffsetCandidate::explained);
    std::vector<OffsetCandidate> best;
    for (const OffsetCandidate &peak : peaks) {
        const bool isNear = std::ranges::any_of(best, [&](const OffsetCandidate &other) {
            return std::abs(other.offsetS - peak.offsetS) < spanS;
        });
        if (!isNear && best.size() < mostCandidates)
            best.push_back(peak);
    }
    return best;
}

} // namespace

double usualLogStepS(const std::vector<LogPose> &log)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < log.size(); ++i)
        steps.push_back(log[i].timeS - log[i - 1].timeS);
    return steps.empty() ? 0 : upperMedian(std::move(steps));
}

std::vector<OffsetCandidate> findOffsets(const MeasuredCourse &course, const std::vector<LogPose> &log)
{
    const double shortestS = std::max(leastSpanS, stepsInSpan * std::max(course.stepS(), usualLogStepS(log)));
    std::vector<OffsetCandidate> best;
    for (const double factor : {1, 2, 4}) {
        std::vector<OffsetCandidate> its = findOffsets(course, log, factor * shortestS);
        if (best.empty() || (!its.empty() && its.front().explained > best.front().explained))
            best = std::move(its);
        if (!best.empty() && best.front().explained > clearlyExplained)
            break;
    }
    return best;
}

} // namespace odo
