// SPDX-License-Identifier: GPL-3.0-or-later
// The stored example's trial is sound; each test spoils one thing of it in memory.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/trial_verdict.h"
#include "core/workflow/trial_sources.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;

namespace {

struct Example
{
    QTemporaryDir folder;
    std::unique_ptr<Project> project = openStoredExample(folder.path().toStdString());
    TrialRecord trial = project->trials().find("Trial 1").value();
    std::vector<RecordingRecord> recordings = project->trials().recordings(trial.id).value();
    std::vector<AnalysisRecord> analyses = project->analyses().current(trial.id).value();

    Profile &profile() { return analyses.front().profile; }
    TrialVerdict verdict()
    {
        return verdictOn(*project, trial, {&recordings[0], &recordings[1]}, analyses).value();
    }
    /// The check with a code, of which there is one.
    TrialCheck check(const std::string &code)
    {
        const TrialVerdict all = verdict();
        const auto found = std::ranges::find(all.checks, code, &TrialCheck::code);
        return found == all.checks.end() ? TrialCheck() : *found;
    }
};

} // namespace

class TestTrialVerdict : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aSoundTrialPasses()
    {
        Example example;
        example.profile().spikes.clear();
        const TrialVerdict verdict = example.verdict();
        QStringList codes;
        for (const TrialCheck &check : verdict.checks) {
            codes << QString::fromStdString(check.code);
            QVERIFY2(check.level == CheckLevel::Pass, check.text.english().c_str());
        }
        QCOMPARE(codes, (QStringList{QStringLiteral("results_intact"), QStringLiteral("time_measured"),
                                     QStringLiteral("few_spikes"), QStringLiteral("positions_precise"),
                                     QStringLiteral("motion_possible"), QStringLiteral("name_known"),
                                     QStringLiteral("frames_regular"), QStringLiteral("frames_decoded"),
                                     QStringLiteral("lens_known"), QStringLiteral("camera_still"),
                                     QStringLiteral("views_agree"), QStringLiteral("synchronised")}));
        QVERIFY(verdict.level() == CheckLevel::Pass);
    }

    void withoutAnAnalysisThereIsNone()
    {
        Example example;
        example.analyses.clear();
        QVERIFY(example.verdict().checks.empty());
    }

    void gapsAreDoubtfulAndLongOnesBad()
    {
        using namespace std::chrono_literals;
        Example example;
        example.profile().gaps = {{2s, 4s}};
        example.profile().measuredS = 8;
        QVERIFY(example.check("time_measured").level == CheckLevel::Doubtful);
        QCOMPARE(example.check("time_measured").text.english(),
                 "robot '" + example.analyses.front().robotName +
                     "' in trial 'Trial 1': 8.0 s of 10.0 s were measured; lengths, times and maxima are at "
                     "least as large as stated");
        example.profile().measuredS = 1;
        QVERIFY(example.check("time_measured").level == CheckLevel::Bad);
        QVERIFY(example.verdict().level() == CheckLevel::Bad);
    }

    /// It was still moving when it was seen last, a third of the run before the end.
    void whatWasMissedAtTheEnd()
    {
        Example example;
        Profile &profile = example.profile();
        for (Sample &sample : profile.samples)
            sample.time *= 8;
        const double wholeS = toSeconds(profile.samples.back().time - profile.samples.front().time);
        profile.measuredS = wholeS * 2 / 3;
        QVERIFY(wholeS - profile.measuredS > 1.5);
        const auto duration = std::ranges::find(profile.metrics, "duration", &Metric::name);
        duration->isAtLeast = false;
        QVERIFY(example.check("time_measured").level == CheckLevel::Pass); // it was at rest
        duration->isAtLeast = true;
        QVERIFY(example.check("time_measured").level == CheckLevel::Doubtful);
        profile.measuredS = wholeS / 3;
        QVERIFY(example.check("time_measured").level == CheckLevel::Bad);
        profile.measuredS = wholeS - 1.4;
        QVERIFY(example.check("time_measured").level == CheckLevel::Pass);
    }

    void manySpikes()
    {
        Example example;
        const std::size_t used = std::ranges::count_if(example.profile().samples, isUsed);
        example.profile().spikes.assign(used / 10, {});
        QVERIFY(example.check("few_spikes").level == CheckLevel::Doubtful);
        example.profile().spikes.assign(used / 2, {});
        QVERIFY(example.check("few_spikes").level == CheckLevel::Bad);
    }

    /// Nothing checks the other view where it should have been seen.
    void aViewThatHardlyFindsTheRobot()
    {
        Example example;
        QVERIFY(example.check("views_agree").level == CheckLevel::Pass);
        std::size_t at = 0;
        for (Sample &sample : example.profile().samples)
            if (++at % 4 != 0)
                sample.views &= ~2U;
        QVERIFY(example.check("views_agree").level == CheckLevel::Doubtful);
        QCOMPARE(
            example.check("views_agree").text.english(),
            "view 'B' in trial 'Trial 1': it found robot '" + example.analyses.front().robotName +
                "' in only 21 % of the frames in which it should be visible, and the other positions are "
                "not checked by a second view");
    }

    /// By the σ of half of the positions, and the floor that they cover.
    void largeErrors()
    {
        Example example;
        std::vector<ProfilePoint> &points = example.profile().points;
        const auto set = [&](double sigmaM, double extentM) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                points[i].valid = true;
                points[i].position = {extentM * double(i) / double(points.size() - 1), 0};
                points[i].sigmaXM = i % 3 == 0 ? 1 : sigmaM;
                points[i].sigmaYM = 0.001;
            }
            return example.check("positions_precise").level;
        };
        QVERIFY(set(0.075, 2) == CheckLevel::Pass);
        QVERIFY(set(0.085, 2) == CheckLevel::Doubtful);
        QCOMPARE(example.check("positions_precise").text.english(),
                 "robot '" + example.analyses.front().robotName +
                     "' in trial 'Trial 1': its positions are known to ±85 mm only, in a run over 2.0 m");
        QVERIFY(set(0.19, 2) == CheckLevel::Doubtful);
        QVERIFY(set(0.21, 2) == CheckLevel::Bad);
        QVERIFY(set(0.009, 0.05) == CheckLevel::Pass); // what hardly moves
        QVERIFY(set(0.045, 0) == CheckLevel::Doubtful);
        QVERIFY(set(0.055, 0) == CheckLevel::Bad);
    }

    void timeStampsThatJump()
    {
        Example example;
        std::vector<Nanoseconds> &times = example.recordings.front().frameTimes;
        for (std::size_t i = times.size() / 2; i < times.size(); ++i)
            times[i] += std::chrono::seconds(10);
        QVERIFY(example.check("frames_regular").level == CheckLevel::Doubtful);
    }

    /// What tracking noted of a moment is said, and not that time is missing there once more.
    void missingFramesAreSaidOnce()
    {
        Example example;
        RecordingRecord &view = example.recordings.front();
        const std::size_t middle = view.frameTimes.size() / 2;
        for (std::size_t i = middle; i < view.frameTimes.size(); ++i)
            view.frameTimes[i] += std::chrono::seconds(1);
        auto series =
            example.project->trials().currentObservations(view.id, example.analyses.front().robot).value();
        QVERIFY(series);
        series->algorithm += "; lost 30 before " + std::to_string(middle) + " (0.500 m)";
        QVERIFY(example.project->trials().addObservations(*series));
        const TrialVerdict verdict = example.verdict();
        std::vector<std::string> said;
        for (const TrialCheck &check : verdict.checks)
            if (check.code == "frames_regular")
                said.push_back(check.text.english());
        QCOMPARE(said.size(), std::size_t(1));
        QVERIFY2(said.front().find("30 frames are missing") != std::string::npos, said.front().c_str());
    }

    /// There is no sample for a frame that could not be decoded.
    /// A tracked view has an observation for each frame but the damaged ones; those of any view count.
    void damagedFrames()
    {
        Example example;
        std::vector<Nanoseconds> &times = example.recordings[1].frameTimes;
        const std::size_t frames = times.size();
        const auto addFrames = [&](std::size_t more) {
            for (std::size_t i = 0; i < more; ++i)
                times.push_back(times.back() + std::chrono::milliseconds(33));
        };
        addFrames(5);
        QVERIFY(example.check("frames_decoded").level == CheckLevel::Doubtful);
        addFrames(frames);
        QVERIFY(example.check("frames_decoded").level == CheckLevel::Bad);
    }

    void viewsThatAreNotSynchronised()
    {
        Example example;
        example.recordings[1].syncMethod = "none";
        QVERIFY(example.check("synchronised").level == CheckLevel::Bad);
        example.recordings[1].syncMethod = "auto";
        example.recordings[1].startOffsetSigmaS = 0.02;
        QVERIFY(example.check("synchronised").level == CheckLevel::Doubtful);
    }

    void aContradictionIsDoubtfulIfItIsExplained()
    {
        Example example;
        example.profile().contradiction =
            ViewsContradiction{{{ContradictionCause::Kind::CameraMoved, 1, 0, 3, {}}}, 0.02};
        QVERIFY(example.check("views_agree").level == CheckLevel::Doubtful);
        example.profile().contradiction->apartM = 0.3;
        QVERIFY(example.check("views_agree").level == CheckLevel::Bad);
        example.profile().contradiction = std::nullopt;
        for (Sample &sample : example.profile().samples) {
            sample.viewDisagreementM = 0.05;
            sample.flags |= flagBit(SampleFlag::ViewsDisagree);
        }
        QVERIFY(example.check("views_agree").level == CheckLevel::Bad);
    }

    void impossibleSpeeds()
    {
        Example example;
        for (Metric &metric : example.profile().metrics)
            if (metric.name == "max_speed")
                metric.value = 300;
        QVERIFY(example.check("motion_possible").level == CheckLevel::Doubtful);
    }

    void changedResults()
    {
        Example example;
        example.analyses.front().proof = AnalysisRecord::Proof::Broken;
        QVERIFY(example.check("results_intact").level == CheckLevel::Bad);
    }

    /// Nothing is measured from another file than the one that was added.
    void aReplacedRecordingIsNamed()
    {
        const QTemporaryDir folder;
        RegisteredView view;
        view.file = folder.filePath(QStringLiteral("a.mkv")).toStdString();
        view.recording.cameraName = "A";
        const auto write = [&](const char *content) { std::ofstream(view.file) << content; };
        write("abc");
        view.recording.bytes = 3;
        view.recording.sha256 =
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"; // FIPS 180-4
        QVERIFY(checkRecordings({view}, {}));
        write("abd");
        auto changed = checkRecordings({view}, {});
        QVERIFY(!changed);
        QCOMPARE(changed.error().message(),
                 std::string("recording of view 'A': its file has changed since it was "
                             "added; restore the original file, or import this one "
                             "as another trial"));
        write("abcd");
        changed = checkRecordings({view}, {});
        QVERIFY(!changed);
        QCOMPARE(changed.error().why.english(),
                 std::string("its file has 4 bytes, but had 3 when it was added"));
        std::filesystem::remove(view.file);
        QVERIFY(checkRecordings({view}, {})); // its reader says so
    }
};

ODOGRAPH_TEST(TestTrialVerdict, QCoreApplication)
#include "tst_trial_verdict.moc"
