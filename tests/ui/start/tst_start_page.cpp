// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/start_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/start/internal/setup_steps.h"
#include "ui/start/internal/step_row.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestStartPage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void anEmptyProjectBeginsWithItsClips();
    void stepsAreTickedByWhatIsThere();
    void aProjectThatIsSetUpIsTickedThrough();
    void whatOnlyReadsChangesNothing();
    void theNextStepIsTheFirstThatIsMissing();
    void isNothingMeasuredTells();

private:
    static StepRow *row(const StartPage &page, SetupStep step)
    {
        return page.findChildren<StepRow *>().at(int(step));
    }
    static QPushButton *button(const StartPage &page, const QString &text)
    {
        for (QPushButton *each : page.findChildren<QPushButton *>())
            if (each->text() == text)
                return each;
        return nullptr;
    }
    static bool isPrimary(const StartPage &page, const QString &text)
    {
        return button(page, text)->property("primary").toBool();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

void TestStartPage::init()
{
    m_project.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_project = std::move(*Project::create(m_folder->filePath(QStringLiteral("p.odo")).toStdString(), "New"));
}

void TestStartPage::anEmptyProjectBeginsWithItsClips()
{
    StartPage page(*m_project, false);
    page.refresh();
    QCOMPARE(page.findChildren<StepRow *>().size(), 6);
    for (const StepRow *step : page.findChildren<StepRow *>())
        QVERIFY(!step->isDone() && !step->words().isEmpty());
    QVERIFY(isPrimary(page, QStringLiteral("Import clips…")));
    QVERIFY(button(page, QStringLiteral("Print a mat…"))->isEnabled());
    for (const char *text : {"Find the mat in the clips…", "Track…", "Record", "Report…"})
        QVERIFY2(!button(page, QString::fromUtf8(text))->isEnabled(), text);
    QSignalSpy requested(&page, &StartPage::requested);
    button(page, QStringLiteral("Import clips…"))->click();
    QCOMPARE(requested.size(), 1);
    QCOMPARE(requested[0][0].value<StartPage::Task>(), StartPage::ImportClips);
}

void TestStartPage::stepsAreTickedByWhatIsThere()
{
    StartPage page(*m_project, false);
    RobotRecord robot;
    for (const char *name : {"Red", "Blue"}) {
        robot.name = name;
        QVERIFY(m_project->robots().add(robot));
    }
    QVERIFY(m_project->cameras().add({0, "A", "sim:A"}));
    page.refresh();
    QVERIFY(row(page, SetupStep::Robot)->isDone());
    QCOMPARE(row(page, SetupStep::Robot)->words(), QStringLiteral("Robots: Red, Blue."));
    QVERIFY(row(page, SetupStep::Sources)->isDone());
    QCOMPARE(row(page, SetupStep::Sources)->words(), QStringLiteral("Cameras: A."));
    QVERIFY(button(page, QStringLiteral("Record"))->isEnabled());
    QVERIFY(!row(page, SetupStep::Floor)->isDone());
    // The mat is found in clips; with cameras alone it is the other buttons that help.
    QVERIFY(!button(page, QStringLiteral("Find the mat in the clips…"))->isEnabled());
    QVERIFY(isPrimary(page, QStringLiteral("Print a mat…")));
    QVERIFY(!isPrimary(page, QStringLiteral("Import clips…")));
}

void TestStartPage::aProjectThatIsSetUpIsTickedThrough()
{
    const auto made = storeExample(m_folder->path().toStdString());
    QVERIFY(made);
    const auto project = std::move(*Project::open(*made, Project::Access::ReadWrite));
    StartPage page(*project, false);
    page.refresh();
    for (const SetupStep step : {SetupStep::Sources, SetupStep::Floor, SetupStep::Robot, SetupStep::FirstRun})
        QVERIFY2(row(page, step)->isDone(), qPrintable(row(page, step)->words()));
    QVERIFY2(row(page, SetupStep::Floor)->words().contains(QStringLiteral("mm")),
             qPrintable(row(page, SetupStep::Floor)->words()));
    QVERIFY(isPrimary(page, QStringLiteral("Report…")));
    QVERIFY(!page.newestTrial().isEmpty());
    QVERIFY(row(page, SetupStep::FirstRun)->words().startsWith(page.newestTrial()));
}

void TestStartPage::whatOnlyReadsChangesNothing()
{
    const auto made = storeExample(m_folder->path().toStdString());
    const auto project = std::move(*Project::open(*made, Project::Access::ReadOnly));
    StartPage page(*project, true);
    page.refresh();
    for (const QPushButton *each : page.findChildren<QPushButton *>()) {
        const bool isHarmless =
            each->text() == QStringLiteral("Print a mat…") || each->text() == QStringLiteral("Report…");
        QVERIFY2(each->isEnabled() == isHarmless, qPrintable(each->text()));
    }
}

void TestStartPage::theNextStepIsTheFirstThatIsMissing()
{
    SetupState state;
    QCOMPARE(nextStep(state), SetupStep::Sources);
    state.cameras.push_back({QStringLiteral("A"), {}, false, false, true, false});
    QCOMPARE(nextStep(state), SetupStep::Floor);
    state.cameras.front().isRegistered = true;
    state.cameras.front().floor.text = QStringLiteral("±0.8 mm");
    QCOMPARE(stateOf(SetupStep::Floor, state).words, QStringLiteral("Positions on the floor: A ±0.8 mm."));
    state.cameras.push_back({QStringLiteral("B"), {}, false, false, true, false});
    QCOMPARE(nextStep(state), SetupStep::Floor); // B is not registered
    QCOMPARE(stateOf(SetupStep::Floor, state).words,
             QStringLiteral("Positions on the floor: A ±0.8 mm. Not registered yet: B."));
    state.cameras.back().isRegistered = true;
    QCOMPARE(nextStep(state), SetupStep::Robot); // the lens is optional
    for (int i = 1; i <= 9; ++i)
        state.robots << QString::number(i);
    QCOMPARE(stateOf(SetupStep::Robot, state).words, QStringLiteral("Robots: 1, 2, 3, 4, 5, 6 and 3 more."));
    QCOMPARE(nextStep(state), SetupStep::FirstRun);
    state.newestTrial = QStringLiteral("Trial 1");
    QCOMPARE(stateOf(SetupStep::FirstRun, state).words, QStringLiteral("Trial 1 is not measured yet."));
    state.isMeasured = state.isNewestMeasured = true;
    QCOMPARE(nextStep(state), SetupStep::Report);
}

void TestStartPage::isNothingMeasuredTells()
{
    QVERIFY(*isNothingMeasured(*m_project));
    const auto made = storeExample(m_folder->path().toStdString());
    const auto project = std::move(*Project::open(*made, Project::Access::ReadOnly));
    QVERIFY(!*isNothingMeasured(*project));
}

ODOGRAPH_TEST(TestStartPage, QApplication)
#include "tst_start_page.moc"
