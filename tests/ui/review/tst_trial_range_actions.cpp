// SPDX-License-Identifier: GPL-3.0-or-later
// The range of a trial, set in Review: by commands, by the handles of the time line, and undone. The
// example's trial has 30 frames at 30 a second.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/models/timeline.h"
#include "ui/review/range_actions.h"
#include "ui/review/review_page.h"
#include "ui/views/charts/timeline_bar.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTrialRangeActions : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
    std::unique_ptr<ReviewPage> m_page;
    std::string m_refusal;

    QAction *action(const char *name) const
    {
        for (QAction *one : m_page->range().actions())
            if (one->objectName() == QLatin1String(name))
                return one;
        qFatal("no such action");
    }
    std::optional<TimeSpan> stored() const { return m_project->trials().find("Trial 1")->range; }
    /// Triggers, and waits for the trial with its new range.
    void set(const char *name) const
    {
        QSignalSpy shown(m_page.get(), &ReviewPage::trialShown);
        action(name)->trigger();
        QVERIFY(shown.wait());
    }
    TimeSpan frames(std::size_t from, std::size_t to) const
    {
        const std::vector<Nanoseconds> &times = m_page->scene()->frameTimes();
        return {times.at(from), times.at(to)};
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        m_project = openStoredExample(m_folder.path().toStdString());
    }
    void init()
    {
        m_page = std::make_unique<ReviewPage>(*m_project);
        connect(m_page.get(), &ReviewPage::rangeRequested, m_page.get(),
                [this](const QString &trial, const RangeChoice &range) {
                    RangeJob job(trial.toStdString(), range);
                    const auto done = runToEnd(job, *m_project, JobControl());
                    m_refusal = done ? std::string() : done.error().message();
                    m_page->refresh();
                });
        m_page->resize(1200, 800);
        m_page->refresh();
        QTRY_VERIFY(m_page->scene());
    }
    void cleanup()
    {
        m_page.reset();
        QVERIFY(!stored());
    }

    void startAndEndAreSetAtTheCursorAndUndone()
    {
        QVERIFY(!action("wholeRun")->isEnabled());
        m_page->timeline().setCurrentFrame(6);
        set("trialStart");
        QVERIFY(stored() == frames(6, 29));
        m_page->timeline().setCurrentFrame(20);
        set("trialEnd");
        QVERIFY(stored() == frames(6, 20));
        const AnalysisRecord &analysis = *m_page->scene()->robots.front().analysis;
        QCOMPARE(analysis.profile.samples.size(), std::size_t(15));
        QCOMPARE(analysis.outside.before.samples.size(), std::size_t(6));
        QCOMPARE(m_page->timeline().frameCount(), qint64(30)); // the time line stays whole
        m_page->timeline().setCurrentFrame(25);
        set("trialStart"); // behind its end: up to the end of the trial
        QVERIFY(stored() == frames(25, 29));
        for (int i = 0; i < 3; ++i)
            QVERIFY(m_project->undo());
    }

    void wholeRunRemovesIt()
    {
        m_page->timeline().setCurrentFrame(6);
        set("trialStart");
        QVERIFY(action("wholeRun")->isEnabled());
        set("wholeRun");
        QVERIFY(!stored() && !action("wholeRun")->isEnabled());
        m_page->timeline().setCurrentFrame(6);
        set("trialStart");
        m_page->timeline().setCurrentFrame(0);
        set("trialStart"); // from the first frame to the last
    }

    void anImpossibleRangeIsRefusedInWords()
    {
        m_page->timeline().setCurrentFrame(0);
        action("trialEnd")->trigger();
        QVERIFY2(m_refusal.find("is not before its end") != std::string::npos, m_refusal.c_str());
    }

    void aHandleIsDragged()
    {
        auto *slider = m_page->findChild<TimeSlider *>();
        QVERIFY(slider);
        const auto at = [&](std::size_t frame) {
            return QPoint(int(std::lround(slider->xOf(m_page->scene()->frameTimes().at(frame)))), 27);
        };
        m_page->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_page.get()));
        QSignalSpy shown(m_page.get(), &ReviewPage::trialShown);
        QTest::mousePress(slider, Qt::LeftButton, {}, at(0));
        QTest::mouseMove(slider, at(10));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, at(10));
        QVERIFY(shown.wait());
        QVERIFY(stored() == frames(10, 29));
        QTest::mousePress(slider, Qt::LeftButton, {}, at(29));
        QTest::mouseMove(slider, at(22));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, at(22));
        QVERIFY(shown.wait());
        QVERIFY(stored() == frames(10, 22));
        QTest::mousePress(slider, Qt::LeftButton, {}, at(22)); // and let go where it was
        QTest::mouseRelease(slider, Qt::LeftButton, {}, at(22));
        QVERIFY(stored() == frames(10, 22));
        set("wholeRun");
    }

    void withoutATrackMotionIsNotOffered()
    {
        QVERIFY(action("trialMotion")->isEnabled());
        QVERIFY(m_page->showTrial(QStringLiteral("Trial 3")));
        QTRY_COMPARE(m_page->scene()->trial.name, std::string("Trial 3"));
        QVERIFY(!action("trialMotion")->isEnabled() && action("trialStart")->isEnabled());
    }
};

ODOGRAPH_TEST(TestTrialRangeActions, QApplication)
#include "tst_trial_range_actions.moc"
