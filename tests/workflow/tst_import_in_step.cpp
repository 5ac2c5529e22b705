// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/workflow/import/import_trial_job.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;

using Sync = SyncBy;

/// Import puts each view in step with the first one: as it is told, or from a flash of light in rendered
/// videos of cameras that nothing else is known of. (From the motion: tests/acceptance.)
class TestImportInStep : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void findsAFlash();
    void eachViewInItsOwnWay();
    void saysWhatToDoWithoutAFlash();
    void refusesStepsOfOtherNumber();

private:
    std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    ImportSettings settings(const std::string &trial, std::vector<const char *> files) const;

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    double m_offsetS = 0;
};

void TestImportInStep::initTestCase()
{
    SimulatedScene scene = demoTestbed(3);
    scene.durationS = 3;
    scene.lights = {{1.4, 1.207, 0.5}};
    scene.cameras[1].startOffsetS = 0.4137;
    scene.cameras[1].framesPerSecond = 25;
    m_offsetS = frameSceneTime(scene, 1, 0) - frameSceneTime(scene, 0, 0);
    QVERIFY(renderVideo(scene, 0, path("a.mkv"), {}, {}));
    QVERIFY(renderVideo(scene, 1, path("b.mkv"), {}, {}));
    for (const char *same : {"b2.mkv", "b3.mkv"})
        std::filesystem::copy_file(path("b.mkv"), path(same));
    scene.lights.clear();
    QVERIFY(renderVideo(scene, 1, path("dull.mkv"), {}, {}));
    auto project = Project::create(path("class.odo"), "Class");
    QVERIFY(project);
    m_project = std::move(*project);
}

ImportSettings TestImportInStep::settings(const std::string &trial, std::vector<const char *> files) const
{
    ImportSettings result;
    result.trial = trial;
    char camera = 'A';
    for (const char *file : files)
        result.videos.emplace_back(std::string(1, camera++), path(file));
    return result;
}

void TestImportInStep::findsAFlash()
{
    ImportTrialJob job(settings("flash", {"a.mkv", "b.mkv"}));
    const auto done = runToEnd(job, *m_project, {});
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    const auto trial = m_project->trials().find("flash");
    QCOMPARE(trial->syncMethod, std::string("flash"));
    QVERIFY2(
        std::abs(trial->syncOffsetS - m_offsetS) < 3 * trial->syncOffsetSigmaS &&
            trial->syncOffsetSigmaS < 0.02,
        qPrintable(
            QStringLiteral("%1 +- %2").arg(trial->syncOffsetS - m_offsetS).arg(trial->syncOffsetSigmaS)));
    QCOMPARE(trial->syncScore, 1.0);
    const auto views = m_project->trials().recordings(trial->id);
    QCOMPARE((*views)[0].syncMethod, std::string());
    QCOMPARE((*views)[1].syncMethod, std::string("flash"));
    QCOMPARE((*views)[1].startOffsetS, trial->syncOffsetS);
    QCOMPARE((*views)[1].startOffsetSigmaS, trial->syncOffsetSigmaS);
    QVERIFY2(job.warnings().front().english().find("'B': measured by a flash of light to only ±") !=
                 std::string::npos,
             job.warnings().front().english().c_str());
}

void TestImportInStep::eachViewInItsOwnWay()
{
    ImportSettings mixed = settings("mixed", {"a.mkv", "b.mkv", "b2.mkv", "b3.mkv"});
    mixed.steps = {{Sync::Given, 0.25}, {Sync::Automatic, 0}, {Sync::None, 0}};
    ImportTrialJob job(std::move(mixed));
    const auto done = runToEnd(job, *m_project, {});
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    const auto trial = m_project->trials().find("mixed");
    QCOMPARE(trial->syncMethod, std::string("told"));
    const auto views = m_project->trials().recordings(trial->id);
    QCOMPARE((*views)[1].syncMethod, std::string("told"));
    QCOMPARE((*views)[1].startOffsetS, 0.25);
    QCOMPARE((*views)[2].syncMethod, std::string("flash"));
    QVERIFY(std::abs((*views)[2].startOffsetS - m_offsetS) < 0.03 && (*views)[2].startOffsetSigmaS > 0.002);
    QCOMPARE((*views)[3].syncMethod, std::string("none"));
    QCOMPARE((*views)[3].startOffsetS, 0.0);
}

void TestImportInStep::saysWhatToDoWithoutAFlash()
{
    ImportTrialJob job(settings("dull", {"a.mkv", "dull.mkv"}));
    const auto done = runToEnd(job, *m_project, {});
    QVERIFY2(done, done ? "" : done.error().message().c_str());
    QCOMPARE(m_project->trials().find("dull")->syncMethod, std::string("open"));
    QCOMPARE(job.warnings().front().english(),
             std::string("synchronisation of view 'B': camera 'A' is not registered to the floor, only "
                         "one of the views shows a flash of light, and view 'A' has no sound; tracking "
                         "tries again; flash the room lights or clap twice while both cameras record, or "
                         "give --sync SECONDS"));
}

void TestImportInStep::refusesStepsOfOtherNumber()
{
    ImportSettings wrong = settings("wrong", {"a.mkv", "b.mkv", "b2.mkv"});
    wrong.steps = {{Sync::Given, 0.25}};
    ImportTrialJob job(std::move(wrong));
    const auto done = runToEnd(job, *m_project, {});
    QVERIFY(!done);
    QVERIFY2(done.error().message().find("the number of views is 3, the number of offsets 1") !=
                 std::string::npos,
             done.error().message().c_str());
    QVERIFY(!m_project->trials().find("wrong"));
}

ODOGRAPH_TEST(TestImportInStep, QCoreApplication)
#include "tst_import_in_step.moc"
