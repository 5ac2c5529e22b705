// SPDX-License-Identifier: GPL-3.0-or-later
// Revisions of a camera, trials that point to them, and what measuring again with others changes.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/camera_position_job.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/track/reanalysis.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/ui/support/stored_example.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

ProfilePoint pointAt(double x, double y)
{
    ProfilePoint point{};
    point.position = {x, y};
    point.velocity = point.acceleration = Eigen::Vector2d::Zero();
    point.valid = true;
    return point;
}

} // namespace

class TestRevisions : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    int m_projects = 0;

    /// A copy of a registration with the whole world moved along X, for every camera.
    void registerMoved(double byM)
    {
        const auto cameras = m_project->cameras().all();
        for (const CameraRecord &camera : *cameras) {
            RegistrationRecord record = *m_project->cameras().currentRegistration(camera.id).value();
            record.registration.worldFromCamera.translation.x() += byM;
            record.registration.verdict = foreignWords("moved");
            QVERIFY(m_project->cameras().addRegistration(record));
        }
    }
    RecordId current(const char *camera)
    {
        return m_project->cameras().currentRegistration(m_project->cameras().find(camera)->id).value()->id;
    }

private Q_SLOTS:
    void init()
    {
        const QString folder = m_folder.filePath(QString::number(++m_projects));
        QVERIFY(QDir().mkpath(folder));
        m_project = openStoredExample(folder.toStdString());
    }

    void listsWhatThereIs()
    {
        registerMoved(0.01);
        const auto revisions = revisionsOf(*m_project, "A");
        QVERIFY(revisions);
        QCOMPARE(revisions->size(), std::size_t(3));
        const Revision &calibration = revisions->at(0), &newest = revisions->at(1), &older = revisions->at(2);
        QVERIFY(calibration.kind == Revision::Kind::Calibration && calibration.isCurrent);
        QCOMPARE(calibration.evidence, 3);
        QVERIFY(newest.kind == Revision::Kind::Registration && newest.isCurrent && newest.trials.empty());
        QVERIFY(!older.isCurrent);
        QCOMPARE(older.trials, (std::vector<std::string>{"Trial 1", "Trial 2"}));
        QCOMPARE(calibration.trials, older.trials); // it was made with that lens
        QVERIFY(contains(older.origin.english(), "layout 'floor', lens calibration "));
        QVERIFY(contains(revisionsOf(*m_project, "Q").error().message(), "'Q'"));
    }

    void anOlderOneIsPutInForceUntilTheNext()
    {
        const RecordId first = current("A");
        registerMoved(0.01);
        const RecordId second = current("A");
        QVERIFY(second != first);
        QVERIFY(chooseRevision(*m_project, "A", Revision::Kind::Registration, first));
        QCOMPARE(current("A"), first);
        QVERIFY2(current("B") != first, "the other camera keeps its own");
        QVERIFY(
            contains(chooseRevision(*m_project, "B", Revision::Kind::Registration, first).error().message(),
                     "camera 'B' has no such number"));
        registerMoved(0.02);
        QVERIFY(current("A") > second);
    }

    void lensesAreChosenInTheSameWay()
    {
        const RecordId camera = m_project->cameras().find("A")->id;
        IntrinsicsRecord record = *m_project->cameras().currentIntrinsics(camera).value();
        const RecordId first = record.id;
        record.calibration.intrinsics.fxPx += 1;
        QVERIFY(m_project->cameras().addIntrinsics(record));
        QVERIFY(m_project->cameras().currentIntrinsics(camera).value()->id != first);
        const auto cameraRecord = *m_project->cameras().get(camera);
        const auto warnings = *calibrationWarnings(*m_project, cameraRecord, record.made);
        QVERIFY(std::ranges::any_of(warnings, [](const Message &each) {
            return each.english().find("another lens calibration") != std::string::npos;
        }));
        QVERIFY(chooseRevision(*m_project, "A", Revision::Kind::Calibration, first));
        QCOMPARE(m_project->cameras().currentIntrinsics(camera).value()->id, first);
        QVERIFY(calibrationWarnings(*m_project, cameraRecord, record.made)->size() < warnings.size());
    }

    void aNewerLensIsTakenWithTheSameMarkers()
    {
        QVERIFY(contains(registerWithCurrentIntrinsics(*m_project, "A").error().message(),
                         "it already uses that calibration"));
        const RecordId camera = m_project->cameras().find("A")->id, before = current("A");
        const RegistrationRecord old = *m_project->cameras().registration(before);
        IntrinsicsRecord lens = *m_project->cameras().currentIntrinsics(camera).value();
        lens.calibration.intrinsics.fxPx *= 1.01; // a camera of a longer lens stands farther away
        lens.calibration.intrinsics.fyPx *= 1.01;
        const auto newer = m_project->cameras().addIntrinsics(lens);
        QVERIFY(m_project->cameras().addCheck(
            before, {lens.made, RegistrationCheck::Outcome::CameraMoved, 6, 0.014, foreignWords("moved")}));
        const auto registered = registerWithCurrentIntrinsics(*m_project, "A");
        QVERIFY2(registered.has_value(), registered ? "" : registered.error().message().c_str());
        QCOMPARE(current("A"), registered->id);
        QCOMPARE(registered->intrinsics, newer->id);
        QCOMPARE(registered->layout, old.layout);
        QVERIFY2(registered->lastCheck &&
                     registered->lastCheck->outcome == RegistrationCheck::Outcome::CameraMoved,
                 "old markers do not tell that the camera stands again where it stood");
        QCOMPARE(registered->pixels.size(), old.pixels.size());
        const auto heightOf = [](const RegistrationRecord &record) {
            return record.registration.worldFromCamera.translation.z();
        };
        QVERIFY2(heightOf(*registered) > heightOf(old), qPrintable(QString::number(heightOf(*registered))));
        QCOMPARE(*outdatedTrials(*m_project), (std::vector<std::string>{"Trial 1", "Trial 2"}));
        QVERIFY(!registerWithCurrentIntrinsics(*m_project, "Q"));
    }

    void trialsKnowThatTheyAreOutdated()
    {
        QVERIFY(outdatedTrials(*m_project)->empty());
        const RecordId first = current("A");
        registerMoved(0.01);
        QCOMPARE(*outdatedTrials(*m_project), (std::vector<std::string>{"Trial 1", "Trial 2"}));
        QVERIFY(chooseRevision(*m_project, "A", Revision::Kind::Registration, first));
        QVERIFY2(!outdatedTrials(*m_project)->empty(), "B's is still another");
    }

    void tellsWhatMeasuringAgainChangesBeforeItIsKept()
    {
        ReprocessJob baseline("Trial 1"); // the example's own curves are drawn, not measured
        auto done = runToEnd(baseline, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        QVERIFY(baseline.keep(*m_project));
        registerMoved(0.01);
        const RecordId trial = m_project->trials().find("Trial 1")->id;
        const RecordId before = m_project->analyses().current(trial)->front().id;
        ReprocessJob job("Trial 1");
        done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        QCOMPARE(m_project->analyses().current(trial)->front().id, before); // nothing is stored yet
        QCOMPARE(job.robots().size(), std::size_t(1));
        const ProfileChange &change = job.robots().front().change;
        QVERIFY(change.compared > 10);
        // The same world, moved: every place by as much, and lengths and speeds by nothing. What is left are
        // rounding and, where the smoother weighs by σ, its last digits.
        QVERIFY2(std::abs(change.largestShiftM - 0.01) < 1e-5, change.words.english().c_str());
        QVERIFY2(std::abs(change.rmsShiftM - 0.01) < 1e-5, change.words.english().c_str());
        for (const MetricChange &metric : change.metrics)
            if (metric.name == "path_length")
                QVERIFY(metric.before && metric.after && std::abs(*metric.before - *metric.after) < 1e-4);
        QVERIFY(contains(change.words.english(), "Positions change by 10.0 mm RMS, at most by 10.0 mm"));
        QVERIFY(job.keep(*m_project));
        QVERIFY(m_project->analyses().current(trial)->front().id != before);
        QCOMPARE(*outdatedTrials(*m_project), std::vector<std::string>{"Trial 2"});
    }

    void aTrialThatWasNeverTrackedHasItsSentence()
    {
        ReprocessJob job("Trial 3");
        QVERIFY(contains(runToEnd(job, *m_project, {}).error().message(),
                         "it has not been tracked yet, so it cannot be reanalysed"));
        ReprocessJob none("Trial 9");
        QCOMPARE(runToEnd(none, *m_project, {}).error().code, ErrorCode::NotFound);
        const JobControl control;
        control.cancel.cancel();
        ReprocessJob given("Trial 1");
        QCOMPARE(runToEnd(given, *m_project, control).error().code, ErrorCode::Cancelled);
    }

    void comparesPlacesAndFigures()
    {
        Profile before, after;
        for (int i = 0; i < 4; ++i) {
            Sample sample;
            sample.frame = i;
            sample.time = fromSeconds(0.1 * i);
            before.samples.push_back(sample);
            before.points.push_back(pointAt(i, 0));
            after.samples.push_back(sample);
            after.points.push_back(pointAt(i, i == 2 ? 0.003 : 0));
        }
        after.points[3].valid = false; // a place that only one has is none to compare
        before.metrics = {{"duration", "s", 3, 0.1}, {"old", "1", 1, {}}};
        after.metrics = {{"duration", "s", 4, {}}, {"new", "1", 2, {}}};
        const ProfileChange change = changeBetween(before, after);
        QCOMPARE(change.compared, std::size_t(3));
        QVERIFY(std::abs(change.largestShiftM - 0.003) < 1e-12);
        QVERIFY(std::abs(change.rmsShiftM - 0.003 / std::sqrt(3.0)) < 1e-12);
        QCOMPARE(change.largestAt, fromSeconds(0.2));
        QCOMPARE(change.metrics.size(), std::size_t(3));
        QCOMPARE(change.metrics[0].after.value(), 4.0);
        QCOMPARE(change.metrics[0].sigma.value(), 0.1);
        QVERIFY(!change.metrics[1].after && !change.metrics[2].before);
        QVERIFY(
            contains(changeBetween({}, {}).words.english(), "The two analyses have no position in common"));
    }

    void checksAreKeptWithTheRegistrationTheyWereMadeOf()
    {
        const RecordId registration = current("A");
        QVERIFY(m_project->cameras().addCheck(registration, {Instant(std::chrono::milliseconds(5)),
                                                             RegistrationCheck::Outcome::Still, 0.2, 0.001,
                                                             foreignWords("still")}));
        QVERIFY(keepUndetermined(
            *m_project, "A", test::saidError(ErrorCode::Undetermined, "whether", "none was found", "look")));
        const auto last = m_project->cameras().registration(registration)->lastCheck;
        QVERIFY(last && last->outcome == RegistrationCheck::Outcome::Undetermined); // the newest
        QVERIFY(contains(last->words.english(), "none was found"));
        registerMoved(0.01);
        QVERIFY2(!m_project->cameras().registration(current("A"))->lastCheck,
                 "a new registration was not checked");
        QVERIFY(!m_project->cameras().addCheck(999, {}).has_value());
    }
};

ODOGRAPH_TEST(TestRevisions, QCoreApplication)
#include "tst_revisions.moc"
