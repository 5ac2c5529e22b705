// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/evaluation/log_evaluation.h"

#include "core/analysis/evaluation/internal/clock_fit.h"
#include "core/analysis/evaluation/internal/offset_search.h"
#include "core/analysis/evaluation/internal/pose_errors.h"
#include "core/analysis/metrics.h"
#include "core/base/percentile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace odo {

namespace {

constexpr std::array alignmentWords{std::pair(LogAlignment::None, std::string_view("none")),
                                    std::pair(LogAlignment::Origin, std::string_view("origin")),
                                    std::pair(LogAlignment::Se2, std::string_view("se2")),
                                    std::pair(LogAlignment::Sim2, std::string_view("sim2"))};

constexpr std::size_t fewestCommon = 3;
constexpr double leastExplained = 0.5;
constexpr double likeBestUnexplained = 4; // another offset may be it
constexpr double sameOffsetS = 0.1;
constexpr double otherLengths = 1.5;

Message chooseItsLog()
{
    return ODO_TEXT("analysis.choose_log_of_run", "choose the log of this run");
}

Message giveOffset()
{
    return ODO_TEXT("analysis.give_log_offset", "give the time offset of the log");
}

std::vector<LogPose> mirrored(std::vector<LogPose> log)
{
    for (LogPose &pose : log) {
        pose.position.y() = -pose.position.y();
        if (pose.headingRad)
            pose.headingRad = -*pose.headingRad;
    }
    return log;
}

class Evaluating
{
public:
    Evaluating(const Profile &profile, const std::vector<LogPose> &log, const EvaluationOptions &options,
               Message subject)
        : m_profile(profile), m_course(profile), m_log(log), m_options(options), m_subject(std::move(subject))
    {
        m_result.alignment = options.alignment;
    }

    Result<LogEvaluation> evaluate()
    {
        using Part = Result<void> (Evaluating::*)();
        for (const Part part : {&Evaluating::findClock, &Evaluating::pair})
            ODO_TRY((this->*part)());
        align();
        measure();
        return std::move(m_result);
    }

private:
    tl::unexpected<Error> undetermined(Message why, Message advice) const
    {
        return fail(ErrorCode::Undetermined, m_subject, std::move(why), std::move(advice));
    }
    tl::unexpected<Error> nothingInCommon() const
    {
        return undetermined(ODO_TEXT("analysis.log_has_no_common_time",
                                     "fewer than %1 of its positions have times at which the robot was "
                                     "measured")(fewestCommon),
                            chooseItsLog());
    }

    tl::unexpected<Error> itsMirrorImage() const
    {
        return undetermined(ODO_TEXT("analysis.log_is_mirrored", "it is the mirror image of the run"),
                            ODO_TEXT("analysis.turn_sign", "change the sign of one of its coordinates"));
    }

    Result<void> findClock()
    {
        if (m_course.isEmpty() || m_log.size() < fewestCommon)
            return nothingInCommon();
        if (m_options.offsetS) {
            m_result.clock.offsetS = *m_options.offsetS;
            m_result.clock.isGiven = true;
            return {};
        }
        if (!tellsTime(m_course))
            return undetermined(
                ODO_TEXT("analysis.motion_gives_no_offset",
                         "the robot never changes its speed or its curvature by more than noise, so any "
                         "time offset fits"),
                giveOffset());
        const std::vector<OffsetCandidate> candidates = findOffsets(m_course, m_log);
        if (candidates.empty() || candidates.front().explained < leastExplained)
            return refuseOtherMotion(candidates.empty() ? 0 : candidates.front().explained);
        return chooseClock(candidates);
    }

    Result<void> refuseOtherMotion(double explained) const
    {
        const auto asMirrored = findOffsets(m_course, mirrored(m_log));
        if (!asMirrored.empty() && asMirrored.front().explained > std::max(leastExplained, 2 * explained))
            return itsMirrorImage();
        return undetermined(
            ODO_TEXT("analysis.log_moves_otherwise",
                     "it moves differently: at no time offset do more than %1 of the "
                     "changes of speed and direction agree")(quantity(100 * explained, 0, "%")),
            chooseItsLog());
    }

    Result<void> chooseClock(const std::vector<OffsetCandidate> &candidates)
    {
        const double mostUnexplained = likeBestUnexplained * (1 - candidates.front().explained);
        std::vector<LogClockFit> fits;
        for (const OffsetCandidate &candidate : candidates) {
            if (1 - candidate.explained > mostUnexplained)
                continue;
            LogClock guess;
            guess.offsetS = candidate.offsetS;
            if (auto fit = fitClock(m_course, m_log, guess, candidate.scale))
                fits.push_back(*fit);
        }
        if (fits.empty())
            return undetermined(
                ODO_TEXT("analysis.offset_not_found",
                         "too little of its motion is also in the run to find the time offset"),
                giveOffset());
        double usualM2 = std::numeric_limits<double>::max();
        for (const LogClockFit &fit : fits)
            usualM2 = std::min(usualM2, median(fit.leftM2));
        const auto best = std::ranges::min_element(
            fits, {}, [&](const LogClockFit &fit) { return meanLeftM2(fit, usualM2); });
        m_result.clock = best->clock;
        for (const LogClockFit &other : fits)
            if (std::abs(offsetAtMiddle(other) - best->clock.offsetS) > sameOffsetS &&
                fitsAlike(*best, other))
                return undetermined(
                    ODO_TEXT("analysis.offset_is_ambiguous",
                             "its motion repeats itself: time offsets %1 apart agree equally well")(
                        quantity(std::abs(offsetAtMiddle(other) - best->clock.offsetS), 2, "s")),
                    giveOffset());
        if (!(best->clock.sigmaOffsetS < largestOffsetSigmaS))
            return undetermined(
                ODO_TEXT("analysis.offset_is_uncertain",
                         "its time offset is known only to ±%1")(quantity(best->clock.sigmaOffsetS, 2, "s")),
                giveOffset());
        return {};
    }

    /// Of another fit, at the time of the chosen one.
    double offsetAtMiddle(const LogClockFit &other) const
    {
        return other.clock.trialTimeS(m_result.clock.middleS) - m_result.clock.middleS;
    }

    Result<void> pair()
    {
        for (const LogPose &pose : m_log) {
            const double timeS = m_result.clock.trialTimeS(pose.timeS);
            if (timeS < m_course.firstS() || timeS > m_course.lastS())
                ++m_result.outside;
            else if (const auto measured = m_course.at(timeS))
                m_pairs.push_back({timeS, pose, *measured});
            else
                ++m_result.inGaps;
        }
        if (m_pairs.size() < fewestCommon)
            return nothingInCommon();
        if (isMirrored(m_pairs))
            return itsMirrorImage();
        if (m_result.clock.isGiven)
            m_result.clock.middleS = (m_pairs.front().log.timeS + m_pairs.back().log.timeS) / 2;
        m_result.pathM = m_course.pathBetween(m_pairs.front().timeS, m_pairs.back().timeS);
        if (!(m_result.pathM > 0))
            return undetermined(
                ODO_TEXT("analysis.still_in_common_time", "the robot does not move in the common time"),
                chooseItsLog());
        return {};
    }

    /// A displacement of all measured positions along the motion looks like an offset of the time.
    double sigmaOfCommonPart() const
    {
        double variance = 0, speeds = 0, squares = 0;
        for (const PosePair &pair : m_pairs) {
            variance += (pair.measured.varianceM2 - pair.measured.ownVarianceM2) / 2 / double(m_pairs.size());
            speeds += pair.measured.velocity.norm();
            squares += pair.measured.velocity.squaredNorm();
        }
        return squares > 0 ? std::sqrt(variance) * speeds / squares : 0;
    }

    void align()
    {
        m_origin = originAlignment(m_pairs);
        switch (m_options.alignment) {
        case LogAlignment::None:
            break;
        case LogAlignment::Origin:
            m_result.transform = m_origin.transform;
            m_result.isTurnedByHeading = m_origin.isTurnedByHeading;
            break;
        case LogAlignment::Se2:
            m_result.transform = leastSquaresAlignment(m_pairs, false);
            break;
        case LogAlignment::Sim2:
            m_result.transform = leastSquaresAlignment(m_pairs, true);
            break;
        }
    }

    void measure()
    {
        const double sigmaOffsetS = m_result.clock.sigmaOffsetS;
        const OriginAlignment *origin = m_options.alignment == LogAlignment::Origin ? &m_origin : nullptr;
        m_result.ape = absoluteErrors(m_pairs, m_result.transform, sigmaOffsetS, origin);
        const auto withHeadings = std::ranges::count_if(m_pairs, &PosePair::haveHeadings);
        m_result.isRpeOfPoses = 2 * std::size_t(withHeadings) > m_pairs.size();
        m_result.rpe = relativeErrors(m_pairs, stepsOf(m_pairs, m_options.deltaM), m_result.transform,
                                      m_result.isRpeOfPoses,
                                      sigmaOfScale(m_profile.samples, m_profile.points), sigmaOffsetS);
        m_result.heading = headingErrors(m_pairs, m_result.transform, origin);
        measureDrift();
        remark();
        if (!m_result.clock.isGiven) // what is common to all positions is in their own uncertainty already
            m_result.clock.sigmaOffsetS = std::hypot(sigmaOffsetS, sigmaOfCommonPart());
    }

    void measureDrift()
    {
        const PosePair &first = m_pairs.front(), &last = m_pairs.back();
        const double apartM = (m_origin.transform(last.log.position) - last.measured.position).norm();
        const double turnedM =
            (last.measured.position - first.measured.position).norm() * m_origin.sigmaHeadingRad;
        const double scaledM = (last.measured.position - first.measured.position).norm() *
                               sigmaOfScale(m_profile.samples, m_profile.points);
        const double lateM =
            (last.measured.velocity - first.measured.velocity).norm() * m_result.clock.sigmaOffsetS;
        const double variance = first.measured.ownVarianceM2 + last.measured.ownVarianceM2 +
                                turnedM * turnedM + scaledM * scaledM + lateM * lateM;
        m_result.driftPercent = 100 * apartM / m_result.pathM;
        m_result.sigmaDriftPercent = 100 * std::sqrt(variance) / m_result.pathM;
    }

    void remark()
    {
        const double scale = leastSquaresAlignment(m_pairs, true).scale;
        if (scale > otherLengths || scale < 1 / otherLengths)
            m_result.remarks.push_back(
                ODO_TEXT("analysis.log_has_other_lengths",
                         "the log's lengths are %1 times the measured ones: its unit may be wrong")(
                    quantity(1 / scale, scale > 1 ? 3 : 1)));
        if (const auto error = lastingHeadingError(m_pairs, m_result.transform))
            m_result.remarks.push_back(ODO_TEXT(
                "analysis.log_has_other_front",
                "the log's heading is %1 from the measured one throughout: its front or its axes may "
                "differ")(quantity(std::abs(*error) * 180 / std::acos(-1.0), 0, "°")));
        if (!m_result.rpe)
            m_result.remarks.push_back(
                ODO_TEXT("analysis.no_step_of_delta",
                         "no stretch of %1 was measured without a gap, so there is no relative error")(
                    quantity(m_options.deltaM, 3, "m")));
    }

    const Profile &m_profile;
    const MeasuredCourse m_course;
    const std::vector<LogPose> &m_log;
    const EvaluationOptions m_options;
    const Message m_subject;
    std::vector<PosePair> m_pairs;
    OriginAlignment m_origin;
    LogEvaluation m_result;
};

} // namespace

std::string_view wordOf(LogAlignment alignment)
{
    return std::ranges::find(alignmentWords, alignment, &decltype(alignmentWords)::value_type::first)->second;
}

std::optional<LogAlignment> logAlignmentOf(std::string_view word)
{
    const auto found = std::ranges::find(alignmentWords, word, &decltype(alignmentWords)::value_type::second);
    return found == alignmentWords.end() ? std::nullopt : std::optional(found->first);
}

Eigen::Vector2d PlaneSimilarity::operator()(const Eigen::Vector2d &point) const
{
    const double c = std::cos(headingRad), s = std::sin(headingRad);
    return shiftM + scale * Eigen::Vector2d(c * point.x() - s * point.y(), s * point.x() + c * point.y());
}

bool ErrorStatistics::isWithinUncertainty() const
{
    return rmse <= std::sqrt(std::log(20.0)) * measurementSigma;
}

ErrorStatistics statisticsOf(std::vector<double> errors)
{
    ErrorStatistics statistics;
    statistics.count = errors.size();
    if (errors.empty())
        return statistics;
    const auto count = double(errors.size());
    double sum = 0, squares = 0, apart = 0;
    for (const double error : errors) {
        sum += error;
        squares += error * error;
    }
    statistics.mean = sum / count;
    for (const double error : errors)
        apart += (error - statistics.mean) * (error - statistics.mean);
    statistics.rmse = std::sqrt(squares / count);
    statistics.std = std::sqrt(apart / count);
    const auto [least, most] = std::ranges::minmax(errors);
    statistics.least = least;
    statistics.most = most;
    statistics.median = median(std::move(errors));
    return statistics;
}

Result<LogEvaluation> evaluateLog(const Profile &measured, const std::vector<LogPose> &log,
                                  const EvaluationOptions &options, const Message &subject)
{
    return Evaluating(measured, log, options, subject).evaluate();
}

} // namespace odo
