// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/internal/run_comparison.h"

#include "core/analysis/internal/path_following.h"
#include "core/analysis/quantity_curve.h"
#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr double stepM = 0.01;
constexpr double mostStations = 5000;
constexpr double leastCommonM = 0.05; // runs that share less have nothing to compare
constexpr double pastBeginM = 0.05;
constexpr double reachShare = 0.25, leastReachM = 0.1, mostReachM = 0.5; // of the path's extent

Message chooseRunWithMotion()
{
    return ODO_TEXT("analysis.choose_motion", "choose a run with motion");
}

StationTime stationTime(const Arrival &arrival, const AlignedMoment &aligned)
{
    return {arrival.timeS - aligned.timeS, arrival.ownSigmaS, arrival.commonSigmaS, arrival.speedMps,
            arrival.sigmaSpeedMps,         arrival.offsetM};
}

/// What displaced positions add to the σ of a difference of two times.
double commonSigma(double a, double b, bool isShared)
{
    return isShared ? b - a : std::hypot(a, b);
}

Difference differenceOf(const StationTime &a, const AlignedMoment &zeroA, const StationTime &b,
                        const AlignedMoment &zeroB, bool isShared)
{
    const double own =
        std::hypot(std::hypot(a.ownSigmaS, b.ownSigmaS), std::hypot(zeroA.ownSigmaS, zeroB.ownSigmaS));
    const double common = std::hypot(commonSigma(a.commonSigmaS, b.commonSigmaS, isShared),
                                     commonSigma(zeroA.commonSigmaS, zeroB.commonSigmaS, isShared));
    return {b.timeS - a.timeS, std::hypot(own, common)};
}

/// Whether a run goes further along the path than back.
bool goesForward(const std::vector<PathProgress> &progress)
{
    const auto [low, high] =
        std::minmax_element(progress.begin(), progress.end(),
                            [](const PathProgress &a, const PathProgress &b) { return a.pathM < b.pathM; });
    const double first = progress.front().pathM;
    return high->pathM - first >= first - low->pathM;
}

class Comparing
{
public:
    Comparing(const std::vector<ComparedRun> &runs, const ComparisonOptions &options)
        : m_runs(runs), m_options(options)
    {
        m_comparison.shareCalibration = options.shareCalibration;
        m_comparison.runs.resize(runs.size());
    }

    Result<RunComparison> compare()
    {
        using Part = Result<void> (Comparing::*)();
        for (const Part part : {&Comparing::checkRuns, &Comparing::choosePath, &Comparing::followRuns,
                                &Comparing::chooseMoments, &Comparing::timeStations}) {
            ODO_TRY((this->*part)());
        }
        return std::move(m_comparison);
    }

private:
    tl::unexpected<Error> failure(ErrorCode code, Message why, Message advice) const
    {
        std::vector<Message> names;
        for (std::size_t run = 0; run < m_runs.size(); ++run)
            names.push_back(quoted(run));
        return fail(code, ODO_TEXT("analysis.comparison_of", "comparison of %1")(listed(std::move(names))),
                    std::move(why), std::move(advice));
    }

    const std::vector<Sample> &samples(std::size_t run) const { return m_runs[run].profile->samples; }
    const std::vector<ProfilePoint> &points(std::size_t run) const { return m_runs[run].profile->points; }
    Message quoted(std::size_t run) const { return quotedName(m_runs[run].name); }

    Result<void> checkRuns()
    {
        if (m_runs.size() < 2)
            return takesTwoRuns();
        for (std::size_t run = 0; run < m_runs.size(); ++run) {
            const auto begin = firstMotionS(samples(run), points(run));
            if (!begin)
                return failure(ErrorCode::Undetermined,
                               ODO_TEXT("analysis.no_motion", "the robot does not move in %1")(quoted(run)),
                               chooseRunWithMotion());
            m_beginsS.push_back(*begin);
        }
        return {};
    }

    Result<void> choosePath()
    {
        m_comparison.isTasksPath = m_options.task && m_options.task->path.points.size() > 1;
        m_comparison.path =
            m_comparison.isTasksPath ? m_options.task->path : pathOfRun(samples(0), points(0));
        if (m_comparison.path.points.empty())
            return failure(ErrorCode::Undetermined,
                           ODO_TEXT("analysis.little_motion", "the robot hardly moves in %1")(quoted(0)),
                           chooseRunWithMotion());
        m_lengthM = lengthOf(m_comparison.path);
        return {};
    }

    void measureProgress()
    {
        const double reachM = std::clamp(reachShare * extentOf(m_comparison.path), leastReachM, mostReachM);
        for (std::size_t run = 0; run < m_runs.size(); ++run)
            m_comparison.runs[run].progress =
                progressAlong(m_comparison.path, samples(run), points(run), reachM);
    }

    Result<void> followRuns()
    {
        measureProgress();
        for (std::size_t run = 0; run < m_runs.size(); ++run)
            if (m_comparison.runs[run].progress.empty())
                return noCommonStretch(run);
        const bool forward = goesForward(m_comparison.runs[0].progress);
        for (std::size_t run = 1; run < m_runs.size(); ++run)
            if (goesForward(m_comparison.runs[run].progress) != forward)
                return failure(
                    ErrorCode::Undetermined,
                    ODO_TEXT("analysis.other_direction",
                             "%1 runs in the opposite direction to %2")(quoted(run), quoted(0)),
                    ODO_TEXT("analysis.choose_same_direction", "choose runs in the same direction"));
        if (!forward) {
            m_comparison.path = reversed(m_comparison.path);
            measureProgress();
        }
        return {};
    }

    tl::unexpected<Error> noCommonStretch(std::size_t run) const
    {
        return failure(ErrorCode::Undetermined,
                       m_comparison.isTasksPath
                           ? ODO_TEXT("analysis.not_on_tasks_path",
                                      "%1 shares no part of its path with the task's path")(quoted(run))
                           : ODO_TEXT("analysis.nothing_in_common",
                                      "%1 shares no part of its path with %2")(quoted(run), quoted(0)),
                       ODO_TEXT("analysis.choose_same_task", "choose runs of the same task"));
    }

    /// The moments of all runs; the name of the first one without.
    template <class MomentOf>
    std::optional<std::size_t> takeMoments(const MomentOf &momentOf)
    {
        for (std::size_t run = 0; run < m_runs.size(); ++run) {
            const std::optional<AlignedMoment> moment = momentOf(run);
            if (!moment)
                return run;
            m_comparison.runs[run].aligned = *moment;
        }
        return std::nullopt;
    }

    std::optional<std::size_t> takeGates()
    {
        return takeMoments([this](std::size_t run) -> std::optional<AlignedMoment> {
            return m_options.task ? startGateMoment(*m_options.task, samples(run), points(run))
                                  : std::nullopt;
        });
    }

    std::optional<std::size_t> takeOnsets()
    {
        return takeMoments([this](std::size_t run) { return onsetMoment(samples(run), points(run)); });
    }

    Result<void> chooseMoments()
    {
        AlignBy by = m_options.alignBy.value_or(AlignBy::StartGate);
        if (by == AlignBy::StartGate) {
            const auto without = takeGates();
            if (without && m_options.alignBy)
                return failure(
                    ErrorCode::Undetermined,
                    ODO_TEXT("analysis.no_start_gate", "%1 does not pass a start gate")(quoted(*without)),
                    ODO_TEXT("analysis.align_otherwise", "align by motion onset or distance"));
            if (without)
                by = AlignBy::MotionOnset;
        }
        if (by == AlignBy::MotionOnset) {
            const auto without = takeOnsets();
            if (without && m_options.alignBy)
                return failure(
                    ErrorCode::Undetermined,
                    ODO_TEXT("analysis.no_onset",
                             "the robot of %1 is already moving when it is first seen")(quoted(*without)),
                    ODO_TEXT("analysis.align_by_distance", "align by distance"));
            if (without)
                by = AlignBy::Distance;
        }
        m_comparison.alignedBy = by;
        return by == AlignBy::ByHand ? takeHandMoments() : Result<void>();
    }

    Result<void> takeHandMoments()
    {
        if (m_options.handTimesS.size() != m_runs.size())
            return failure(
                ErrorCode::InvalidInput,
                ODO_TEXT("analysis.moments_missing", "aligning runs by hand needs a moment in each run"),
                ODO_TEXT("analysis.tell_moments", "enter one for each run"));
        for (std::size_t run = 0; run < m_runs.size(); ++run) {
            const double timeS = m_options.handTimesS[run];
            if (!(timeS >= toSeconds(samples(run).front().time) &&
                  timeS <= toSeconds(samples(run).back().time)))
                return failure(
                    ErrorCode::InvalidInput,
                    ODO_TEXT("analysis.moment_outside",
                             "the moment entered for %1 is outside that run")(quoted(run)),
                    ODO_TEXT("analysis.tell_moment_inside", "enter one between its first and last frame"));
            m_comparison.runs[run].aligned = handMoment(timeS, samples(run));
        }
        return {};
    }

    /// Puts the runs into the same lap of a closed path, by where they are at the same moment.
    void shiftLaps()
    {
        const AlignBy by = m_comparison.alignedBy;
        const bool byMoment = by == AlignBy::StartGate || by == AlignBy::ByHand;
        double firstM = 0;
        for (std::size_t run = 0; run < m_runs.size(); ++run) {
            RunOnPath &on = m_comparison.runs[run];
            const double atM = on.distanceAtTime(byMoment ? on.aligned.timeS : m_beginsS[run]);
            if (run == 0)
                firstM = m_comparison.path.closed ? std::remainder(atM, m_lengthM) : atM;
            if (m_comparison.path.closed)
                on.lapShiftM = m_lengthM * std::round((firstM - atM) / m_lengthM);
            for (PathProgress &position : on.progress)
                position.pathM += on.lapShiftM;
            on.arrivals =
                FirstArrivals(on.progress, by == AlignBy::StartGate ? on.aligned.timeS : m_beginsS[run]);
        }
    }

    double beginOfAll() const
    {
        double beginM = -std::numeric_limits<double>::infinity();
        for (const RunOnPath &run : m_comparison.runs)
            beginM = std::max(beginM, m_comparison.alignedBy == AlignBy::StartGate
                                          ? run.distanceAtTime(run.aligned.timeS)
                                          : run.arrivals.firstM());
        // What a robot drives before the path begins is not along it.
        return m_comparison.path.closed ? beginM : std::max(0.0, beginM);
    }

    /// Times the runs from their arrival at one position.
    Result<void> alignByPosition()
    {
        double stationM = m_options.stationM.value_or(m_comparison.originM + pastBeginM);
        if (m_options.stationM && m_comparison.path.closed)
            stationM += m_lengthM * std::max(0.0, std::ceil((m_comparison.originM - stationM) / m_lengthM));
        for (std::size_t run = 0; run < m_runs.size(); ++run) {
            const auto arrival = m_comparison.runs[run].arrivals.at(stationM);
            if (!arrival && !m_options.stationM)
                return noCommonStretch(run);
            if (!arrival)
                return failure(
                    ErrorCode::Undetermined,
                    ODO_TEXT("analysis.not_seen_there",
                             "%1 was not seen at the position used for alignment")(quoted(run)),
                    ODO_TEXT("analysis.choose_common_place", "choose a position that both runs pass"));
            m_comparison.runs[run].aligned = {arrival->timeS, arrival->ownSigmaS, arrival->commonSigmaS};
        }
        return {};
    }

    Result<void> timeStations()
    {
        shiftLaps();
        for (std::size_t run = 0; run < m_runs.size(); ++run)
            if (m_comparison.runs[run].arrivals.isEmpty())
                return noCommonStretch(run);
        m_comparison.originM = beginOfAll();
        if (m_comparison.alignedBy == AlignBy::Distance)
            ODO_TRY(alignByPosition());
        layStations();
        for (RunOnPath &run : m_comparison.runs)
            for (const double pathM : m_comparison.distancesM) {
                const auto arrival = run.arrivals.at(pathM);
                run.stations.push_back(arrival ? std::optional(stationTime(*arrival, run.aligned))
                                               : std::nullopt);
            }
        return checkCommonStretch();
    }

    void layStations()
    {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const RunOnPath &run : m_comparison.runs) {
            low = std::min(low, run.arrivals.firstM());
            high = std::max(high, run.arrivals.lastM());
        }
        const double originM = m_comparison.originM;
        if (m_comparison.alignedBy == AlignBy::StartGate)
            low = originM; // what lies before the start is no part of the run
        if (!m_comparison.path.closed) {
            low = std::max(0.0, low);
            high = std::min(m_lengthM, high);
        }
        const double step = stepM * std::max(1.0, std::ceil((high - low) / stepM / mostStations));
        constexpr double rounding = 1e-9;
        for (double i = std::ceil((low - originM) / step - rounding); originM + i * step <= high + rounding;
             i += 1)
            m_comparison.distancesM.push_back(originM + i * step);
    }

    Result<void> checkCommonStretch() const
    {
        const std::vector<double> &distances = m_comparison.distancesM;
        for (std::size_t run = 1; run < m_runs.size(); ++run) {
            double commonM = 0;
            for (std::size_t i = 1; i < distances.size(); ++i)
                if (m_comparison.runs[0].stations[i] && m_comparison.runs[run].stations[i])
                    commonM += distances[i] - distances[i - 1];
            if (commonM < leastCommonM)
                return noCommonStretch(run);
        }
        return {};
    }

    const std::vector<ComparedRun> &m_runs;
    const ComparisonOptions &m_options;
    RunComparison m_comparison;
    std::vector<double> m_beginsS; ///< when each run begins to move
    double m_lengthM = 0;          ///< of the path
};

} // namespace

double RunOnPath::distanceAtTime(double timeS) const
{
    const auto after =
        std::lower_bound(progress.begin(), progress.end(), timeS,
                         [](const PathProgress &each, double wanted) { return each.timeS < wanted; });
    if (after == progress.begin())
        return progress.front().pathM;
    if (after == progress.end())
        return progress.back().pathM;
    const PathProgress &before = *(after - 1);
    const double part = (timeS - before.timeS) / (after->timeS - before.timeS);
    return before.pathM + part * (after->pathM - before.pathM);
}

bool Difference::isSignificant() const
{
    return std::abs(value) > coverage95 * sigma;
}

std::optional<Difference> RunComparison::timeDifference(std::size_t run, std::size_t station) const
{
    const auto &a = runs.front().stations[station], &b = runs[run].stations[station];
    if (!a || !b)
        return std::nullopt;
    return differenceOf(*a, runs.front().aligned, *b, runs[run].aligned, shareCalibration);
}

std::optional<Difference> RunComparison::timeDifferenceAt(std::size_t run, double pathM) const
{
    const auto a = runs.front().arrivals.at(pathM), b = runs[run].arrivals.at(pathM);
    if (!a || !b)
        return std::nullopt;
    return differenceOf(stationTime(*a, runs.front().aligned), runs.front().aligned,
                        stationTime(*b, runs[run].aligned), runs[run].aligned, shareCalibration);
}

Message comparisonSubject()
{
    return ODO_TEXT("analysis.comparison", "comparison");
}

tl::unexpected<Error> takesTwoRuns()
{
    return fail(ErrorCode::InvalidInput, comparisonSubject(),
                ODO_TEXT("analysis.takes_two_runs", "it needs two runs"),
                ODO_TEXT("analysis.choose_another_run", "choose another run as well"));
}

Result<RunComparison> compareRuns(const std::vector<ComparedRun> &runs, const ComparisonOptions &options)
{
    return Comparing(runs, options).compare();
}

} // namespace odo
