// SPDX-License-Identifier: GPL-3.0-or-later
// The range of a trial: what of its time its results are of. Its raw measurements stay whole.
#include "core/workflow/trials/trial_range.h"

#include "core/exchange/track_export.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/verdict_repository.h"
#include "core/workflow/compare/compare_trials.h"
#include "core/workflow/import/import_tracks_job.h"
#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/trials/trial_changes.h"
#include "core/workflow/trials/trial_copy.h"
#include "core/workflow/trials/trial_table_reading.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/project_content.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>

using namespace odo;

namespace {

constexpr double rateHz = 30, driveS = 8, standingS = 1, carriedS = 1.5, radiusM = 0.6;

/// How far the robot has come: it takes a second to reach 0.9 m/s, and a second to stop.
double travelledM(double t)
{
    constexpr double fastestMps = 0.9, rampS = 1;
    const double s = std::clamp(t, 0.0, driveS);
    const auto ramp = [](double x) { return fastestMps * x * x / (2 * rampS); };
    if (s <= rampS)
        return ramp(s);
    if (s <= driveS - rampS)
        return ramp(rampS) + fastestMps * (s - rampS);
    return ramp(rampS) + fastestMps * (driveS - 2 * rampS) + ramp(rampS) - ramp(driveS - s);
}

/// Where it is: on a circle; a hand then carries it off, within half a second at 2.5 m/s.
Eigen::Vector2d positionAt(double t, bool isCarriedOff)
{
    const double angle = travelledM(t) / radiusM;
    Eigen::Vector2d at(radiusM * std::cos(angle), radiusM * std::sin(angle));
    if (const double since = t - driveS; isCarriedOff && since > 0)
        at += Eigen::Vector2d(1, -0.4).normalized() *
              (since < 0.5 ? 2.5 * since * since : 2.5 * (since - 0.25));
    return at;
}

/// The drive with its rest before and what comes after; its noise of 2 mm is the same however much of it
/// there is.
QByteArray track(double beforeS, double afterS, bool isCarriedOff)
{
    const int before = int(std::lround(beforeS * rateHz)), drive = int(driveS * rateHz),
              after = int(std::lround(afterS * rateHz));
    QByteArray text = "t_s,x_mm,y_mm\n";
    std::mt19937 random(11), other(12);
    std::normal_distribution<double> noise(0, 2), otherNoise(0, 2);
    for (int i = -before; i <= drive + after; ++i) {
        const bool isClean = i >= 0 && i <= drive;
        const Eigen::Vector2d at = 1000 * positionAt(i / rateHz, isCarriedOff);
        const auto draw = [&] { return isClean ? noise(random) : otherNoise(other); };
        text += QByteArray::number((i + before) / rateHz, 'f', 9) + ',' +
                QByteArray::number(at.x() + draw(), 'f', 4) + ',' +
                QByteArray::number(at.y() + draw(), 'f', 4) + '\n';
    }
    return text;
}

const Metric &metricOf(const AnalysisRecord &analysis, const std::string &name)
{
    static const Metric none;
    const auto found = std::ranges::find(analysis.profile.metrics, name, &Metric::name);
    return found == analysis.profile.metrics.end() ? none : *found;
}

/// Metrics of which the second differs by more than one σ of the first.
QStringList apart(const AnalysisRecord &clean, const AnalysisRecord &other)
{
    QStringList names;
    for (const Metric &metric : clean.profile.metrics) {
        const Metric &its = metricOf(other, metric.name);
        if (its.name.empty() || std::abs(its.value - metric.value) > metric.sigma.value_or(0) + 1e-9)
            names << QStringLiteral("%1 %2 ±%3, but %4")
                         .arg(QString::fromStdString(metric.name))
                         .arg(metric.value)
                         .arg(metric.sigma.value_or(0))
                         .arg(its.value);
    }
    return names;
}

bool areSame(const std::vector<Metric> &a, const std::vector<Metric> &b)
{
    return std::ranges::equal(a, b, [](const Metric &one, const Metric &other) {
        return one.name == other.name && one.value == other.value && one.sigma == other.sigma &&
               one.isAtLeast == other.isAtLeast;
    });
}

std::string line(const Result<TrialRecord> &failed)
{
    return failed ? "nothing failed" : failed.error().message();
}

} // namespace

class TestTrialRange : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;

    void import(const char *trial, const QByteArray &text)
    {
        QFile file(m_folder->filePath(QStringLiteral("track.csv")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no test file");
        file.close();
        ImportTracksSettings settings;
        settings.trial = trial;
        settings.tracks = {{"red", file.fileName().toStdString()}};
        ImportTracksJob job(settings);
        if (const auto done = runToEnd(job, *m_project, JobControl()); !done)
            qFatal("%s", done.error().message().c_str());
    }
    TrialRecord trial(const char *name = "run") const { return *m_project->trials().find(name); }
    AnalysisRecord analysis(const char *name = "run") const
    {
        return m_project->analyses().current(trial(name).id)->at(0);
    }
    Result<TrialRecord> setRange(const RangeChoice &range, const char *name = "run")
    {
        return editTrial(*m_project, trial(name).id, {.range = range});
    }
    std::string problems() const
    {
        const auto found = m_project->check(true).value();
        return found.empty() ? std::string() : found.front().what.english();
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(
            *Project::create(m_folder->filePath(QStringLiteral("class.odo")).toStdString(), "class"));
        import("clean", track(0, 0, false));
        import("run", track(standingS, carriedS, true));
    }

    /// 1 s of standing before and 1.5 s of being carried off: without a range top speed and path are far off,
    /// with it every metric is that of the clean run within its σ.
    void figuresOfTheCleanRun()
    {
        QVERIFY(metricOf(analysis(), "max_speed").value > 2);
        QVERIFY(metricOf(analysis(), "path_length").value > 9);
        const auto done = setRange(RangeSeconds{standingS, standingS + driveS});
        QVERIFY2(done, line(done).c_str());
        const QStringList differing = apart(analysis("clean"), analysis());
        QVERIFY2(differing.isEmpty(), qPrintable(differing.join(u'\n')));
        QVERIFY(analysis().profile.samples.front().time == fromSeconds(standingS));
        QCOMPARE(problems(), std::string());
    }

    /// By motion without a hand: a rest before and after.
    void figuresOfTheCleanRunByMotion()
    {
        import("rest", track(standingS, carriedS, false));
        const auto done = setRange(RangeOfMotion(), "rest");
        QVERIFY2(done, line(done).c_str());
        QVERIFY(toSeconds(done->range->begin) > 0.7 && toSeconds(done->range->begin) <= 1.1);
        QVERIFY(toSeconds(done->range->end) > 8.8 && toSeconds(done->range->end) < 9.4);
        const QStringList differing = apart(analysis("clean"), analysis("rest"));
        QVERIFY2(differing.isEmpty(), qPrintable(differing.join(u'\n')));
    }

    void rawMeasurementsStayAndNoneRestores()
    {
        const RecordId robot = m_project->robots().find("red")->id;
        const auto raw = [&] { return m_project->trials().currentImportedTrack(trial().id, robot)->value(); };
        const ImportedTrack before = raw();
        const AnalysisRecord whole = analysis();
        QVERIFY(setRange(RangeSeconds{2, 5}));
        const AnalysisRecord part = analysis();
        QVERIFY(part.id != whole.id && part.range == trial().range);
        QVERIFY(part.profile.samples.size() < whole.profile.samples.size());
        const ImportedTrack after = raw();
        QVERIFY(std::ranges::equal(before.samples, after.samples, [](const Sample &a, const Sample &b) {
            return a.time == b.time && a.position == b.position && a.covariance == b.covariance &&
                   a.flags == b.flags;
        }));
        QVERIFY(setRange(RangeSeconds{1, 4})); // of the whole run again, not of the part
        QVERIFY(setRange(WholeRun()));
        const AnalysisRecord again = analysis();
        QVERIFY(!again.range && areSame(again.profile.metrics, whole.profile.metrics));
        QCOMPARE(again.profile.samples.size(), whole.profile.samples.size());
        QCOMPARE(again.profile.spikes.size(), whole.profile.spikes.size());
        QVERIFY(again.profile.meanViewDisagreementM == whole.profile.meanViewDisagreementM);
        QCOMPARE(problems(), std::string());
    }

    void isOneChangeAndUndone()
    {
        const AnalysisRecord whole = analysis();
        QVERIFY(setRange(RangeSeconds{2, 5}));
        QCOMPARE(m_project->changes()->front().words.english(), std::string("set the range of run"));
        QVERIFY(trial().range == (TimeSpan{fromSeconds(2), fromSeconds(5)}));
        const AnalysisRecord part = analysis();
        const std::size_t count = m_project->changes()->size();
        QVERIFY(setRange(RangeSeconds{2, 5})); // it has it already
        QCOMPARE(m_project->changes()->size(), count);
        QVERIFY(m_project->undo());
        QVERIFY(!trial().range && analysis().id == whole.id);
        QVERIFY(m_project->redo());
        QVERIFY(analysis().id == part.id && areSame(analysis().profile.metrics, part.profile.metrics));
        QVERIFY(setRange(WholeRun()));
        QCOMPARE(m_project->changes()->front().words.english(), std::string("remove the range of run"));
        QCOMPARE(problems(), std::string());
    }

    void refusals()
    {
        const QStringList before = contentOf(*m_project);
        const auto saysOf = [&](const RangeChoice &range) { return line(setRange(range)); };
        QCOMPARE(
            saysOf(RangeSeconds{5, 2}),
            std::string("range of trial 'run': its start 5.000 s is not before its end 2.000 s; give the "
                        "start first, then a later end"));
        QCOMPARE(saysOf(RangeSeconds{2, 2}).substr(0, 40),
                 std::string("range of trial 'run': its start 2.000 s "));
        QCOMPARE(
            saysOf(RangeSeconds{-1, 2}),
            std::string("range of trial 'run': -1.000 s to 2.000 s is not within the trial's time; choose "
                        "a range from 0 to 10.500 s"));
        QCOMPARE(saysOf(RangeSeconds{2, 11}).substr(0, 42),
                 std::string("range of trial 'run': 2.000 s to 11.000 s "));
        QCOMPARE(
            saysOf(RangeSeconds{2.001, 2.002}),
            std::string("range of trial 'run': it contains no sample of robot 'red' (2.001 s to 2.002 s); "
                        "choose another range"));
        QCOMPARE(setRange(RangeSeconds{5, 2}).error().code, ErrorCode::WrongCall);
        QCOMPARE(setRange(RangeSeconds{2, 11}).error().code, ErrorCode::InvalidInput);
        QCOMPARE(contentOf(*m_project), before);
    }

    void motionOfWhatNeverMoves()
    {
        QByteArray text = "t_s,x_mm,y_mm\n";
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 2);
        for (int i = 0; i < 200; ++i)
            text += QByteArray::number(i / rateHz, 'f', 6) + ',' + QByteArray::number(noise(random), 'f', 3) +
                    ',' + QByteArray::number(noise(random), 'f', 3) + '\n';
        import("parked", text);
        QCOMPARE(
            line(setRange(RangeOfMotion(), "parked")),
            std::string("range of trial 'parked': no robot moves in it; give its start and end in seconds"));
        const auto copied = copyTrial(*m_project, "run");
        QVERIFY(copied);
        QCOMPARE(line(setRange(RangeOfMotion(), "run copy")),
                 std::string("range of trial 'run copy': it has not been tracked yet; track it first"));
    }

    void aCopyHasItToo()
    {
        QVERIFY(setRange(RangeSeconds{2, 5}));
        const auto copied = copyTrial(*m_project, "run");
        QVERIFY(copied && copied->range == trial().range);
        TrackSettings again;
        again.again = true;
        TrackJob job("run copy", again);
        QVERIFY(runToEnd(job, *m_project, JobControl()));
        const AnalysisRecord its = analysis("run copy");
        QVERIFY(its.range == trial().range);
        QVERIFY(areSame(its.profile.metrics, analysis().profile.metrics));
        QCOMPARE(job.outcome().robots.front().frames, std::int64_t(its.profile.samples.size()));
        QCOMPARE(problems(), std::string());
    }

    void aReanalysisAndACorrectionKeepIt()
    {
        QVERIFY(setRange(RangeSeconds{2, 5}));
        const std::vector<Metric> before = analysis().profile.metrics;
        ReprocessJob reprocess("run");
        QVERIFY(runToEnd(reprocess, *m_project, JobControl()));
        QVERIFY(reprocess.robots().front().change.largestShiftM < 1e-12);
        QVERIFY(reprocess.keep(*m_project));
        QVERIFY(analysis().range == trial().range && areSame(analysis().profile.metrics, before));
        OverrideJob spike({"run", "", 1.5, {}, OverrideRequest::Word::Spike}); // outside of it
        const auto done = runToEnd(spike, *m_project, JobControl());
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QVERIFY(hasFlag(spike.outcome().flags, SampleFlag::ByHand));
        QVERIFY(analysis().range == trial().range && analysis().options.overrides.size() == 1);
        QCOMPARE(problems(), std::string());
    }

    /// What lists, tables and comparisons read is of the range.
    void listsAndTablesFollow()
    {
        QVERIFY(setRange(RangeSeconds{standingS, standingS + driveS}));
        const double path = metricOf(analysis(), "path_length").value;
        const auto listed = m_project->analyses().trialMetrics("path_length", Instant::min(), Instant::max());
        const auto its = std::ranges::find(*listed, trial().id, &TrialMetric::trial);
        QVERIFY(its != listed->end() && its->metric.value == path);
        TrialTableChoice choice;
        choice.metrics = {"path_length"};
        const auto table = readTrialTable(*m_project, choice);
        const auto row = std::ranges::find(table->rows, std::string("run"),
                                           [](const TrialTableRow &one) { return one.trial.name; });
        QVERIFY(row->metrics.front()->value == path);
        CompareSettings settings;
        settings.runs = {{"clean", ""}, {"run", ""}};
        const auto trials = readComparedTrials(*m_project, settings);
        QVERIFY2(trials, trials ? "" : trials.error().message().c_str());
        const auto compared = compareTrials(*trials, settings);
        QVERIFY2(compared, compared ? "" : compared.error().message().c_str());
        for (const MetricDifference &difference : compared->metrics.front())
            QVERIFY2(!difference.difference || !difference.difference->isSignificant(),
                     difference.name.c_str());
    }

    void exportsItsSamplesAlone()
    {
        const auto rows = [&] {
            const std::string text = wholeText(
                [&](const TextSink &sink) { return writeTrackCsv(analysis(), CsvStyle::Analysis, sink); });
            QStringList lines = QString::fromStdString(text).split(u'\n', Qt::SkipEmptyParts);
            lines.removeFirst();
            return lines;
        };
        const QStringList whole = rows();
        QVERIFY(setRange(RangeSeconds{2, 5}));
        const QStringList part = rows();
        QCOMPARE(part.size(), 91);              // 3 s at 30/s, and one
        for (int i = 0; i < part.size(); ++i) { // times and measurements are those of before
            const QStringList now = part[i].split(u','), before = whole[60 + i].split(u',');
            QCOMPARE(now[0], before[0]);
            QCOMPARE(now.mid(13), before.mid(13));
        }
        QVERIFY(part.front().startsWith(QStringLiteral("2,")));
    }

    /// The check names analyses that are not of the trial's range; setting it measures them.
    void analysesOfAnotherRangeAreNamed()
    {
        const RecordId before = analysis().id;
        QVERIFY(m_project->trials().setRange(trial().id, TimeSpan{fromSeconds(2), fromSeconds(5)}));
        QCOMPARE(problems(), std::string("the trial's range has changed since robot 'red' was analysed"));
        QVERIFY(setRange(RangeSeconds{2, 5})); // which measures it
        QVERIFY(analysis().id != before);
        QCOMPARE(problems(), std::string());
    }
};

ODOGRAPH_TEST(TestTrialRange, QCoreApplication)
#include "tst_trial_range.moc"
