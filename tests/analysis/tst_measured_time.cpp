// SPDX-License-Identifier: GPL-3.0-or-later
// Runs with gaps: what is stated of path, mean speed, stops and laps holds, or is said to be a lower bound.
#include "core/analysis/gate_passages.h"
#include "core/analysis/metrics.h"
#include "tests/analysis/gap_runs.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cstdio>
#include <map>
#include <string>

using namespace odo;
using namespace odo::test;

namespace {

/// How many runs: what is claimed, or with ODOGRAPH_GAP_RUNS=600 more, each miss named (docs/testing.md).
unsigned runCount()
{
    const int told = qEnvironmentVariableIntValue("ODOGRAPH_GAP_RUNS");
    return told > 0 ? unsigned(told) : 60;
}

struct Score
{
    int runs = 0, holds = 0, atLeast = 0;
    double relativeSigma = 0; ///< sum over those that are no lower bounds
    void add(bool isHeld, const Metric &metric)
    {
        ++runs;
        holds += isHeld;
        atLeast += metric.isAtLeast;
        if (!metric.isAtLeast && metric.value > 0)
            relativeSigma += metric.sigma.value_or(0) / metric.value;
    }
    double share() const { return double(holds) / std::max(1, runs); }
};

const Metric &metricOf(const Profile &profile, const char *name)
{
    static const Metric none;
    const auto found = std::ranges::find(profile.metrics, std::string(name), &Metric::name);
    return found == profile.metrics.end() ? none : *found;
}

bool holds(const Metric &metric, double truth)
{
    const double reach = 2 * metric.sigma.value_or(0) + 1e-9;
    return !metric.name.empty() && metric.value - reach <= truth &&
           (metric.isAtLeast || truth <= metric.value + reach);
}

Result<Profile> analysed(const GapRun &run)
{
    const auto raw = samplesOfImported(run.track, estimateImportedNoiseM(run.track));
    AnalysisOptions options = optionsForImported({}, raw);
    options.task.emplace().gates = {
        gateAcross("line", GateRole::StartFinish, {0, -run.course.widthM / 2}, {1, 0}, 0.4)};
    return analyseImported(raw, options);
}

/// A gap that is too long to be bridged is one; in one that is bridged nothing is used.
bool isSaid(const GapRun &run, const Profile &profile)
{
    constexpr double longestBridgedS = 1.5, frameS = 0.04;
    for (const auto &[from, to] : run.gapsS) {
        const bool isGap = std::ranges::any_of(profile.gaps, [from = from, to = to](const TimeSpan &gap) {
            return toSeconds(gap.begin) <= from + frameS && toSeconds(gap.end) >= to - frameS;
        });
        if (to - from > longestBridgedS + frameS && !isGap)
            return false;
        for (const Sample &sample : profile.samples)
            if (toSeconds(sample.time) > from && toSeconds(sample.time) < to && isUsed(sample))
                return false;
    }
    return true;
}

} // namespace

class TestMeasuredTime : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsStatedOfRunsWithGapsHolds()
    {
        const bool isTold = qEnvironmentVariableIsSet("ODOGRAPH_GAP_RUNS");
        std::map<std::string, std::map<std::string, Score>> scores;
        for (unsigned number = 0; number < runCount(); ++number) {
            GapRunMaker maker(number);
            const GapRun run = maker.make();
            const auto profile = analysed(run);
            QVERIFY2(profile, qPrintable(QString::number(number)));
            QVERIFY2(isSaid(run, *profile), qPrintable(QString::number(number)));
            const std::map<std::string, double> truths{{"path_length", run.pathM()},
                                                       {"mean_speed", run.meanSpeedMps()},
                                                       {"duration", run.endS - run.startS},
                                                       {"stops", run.stops},
                                                       {"laps", run.laps}};
            for (const auto &[name, truth] : truths) {
                const Metric &metric = metricOf(*profile, name.c_str());
                const bool isHeld = holds(metric, truth);
                scores[name][gapsAtNames[std::size_t(maker.gapsAt())]].add(isHeld, metric);
                scores[name]["all"].add(isHeld, metric);
                if (!isHeld && isTold)
                    qInfo("run %u, %s: %s %s%.4f +-%.4f, true %.4f", number,
                          gapsAtNames[std::size_t(maker.gapsAt())], name.c_str(),
                          metric.isAtLeast ? "at least " : "", metric.value, metric.sigma.value_or(0), truth);
            }
        }
        for (const auto &[name, kinds] : scores)
            for (const auto &[kind, score] : kinds)
                if (isTold || kind == "all")
                    qInfo("%-12s %-18s held in %3.0f %% of %d, at least in %d, sigma %.1f %%", name.c_str(),
                          kind.c_str(), 100 * score.share(), score.runs, score.atLeast,
                          100 * score.relativeSigma / std::max(1, score.runs - score.atLeast));
        for (const auto &[name, kinds] : scores)
            QVERIFY2(kinds.at("all").share() >= 0.9, name.c_str());
    }
};

ODOGRAPH_TEST(TestMeasuredTime, QCoreApplication)
#include "tst_measured_time.moc"
