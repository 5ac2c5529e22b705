// SPDX-License-Identifier: GPL-3.0-or-later
// Where a person points a robot out is kept with the trial and tracked by; what cannot be meant is refused.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/trial_sources.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestPointedOut : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = openStoredExample(m_folder->path().toStdString());
        m_trial = m_project->trials().find("Trial 1").value();
        RobotRecord robot = m_project->robots().find("Red 2").value();
        m_coloured = robot;
        robot.colour.reset();
        QVERIFY(m_project->robots().set(robot));
    }

    void itIsKeptAndReplacedAndTakenBack()
    {
        QCOMPARE(track({}), QString());
        const auto [view, observation] = seen(10);
        const RobotPointer pointer{"Red 2", view.recording.cameraName, toSeconds(observation.time),
                                   observation.ellipse.centrePx};
        QCOMPARE(track({pointer}), QString());
        auto stored = m_project->trials().pointedOut(m_trial.id).value();
        QCOMPARE(stored.size(), std::size_t(1));
        QCOMPARE(stored.front().recording, view.recording.id);
        QCOMPARE(stored.front().frame, observation.frame);
        QVERIFY(stored.front().pixel == observation.ellipse.centrePx);
        QVERIFY(seen(10).second.found);

        const auto later = seen(15).second;
        QCOMPARE(track({{"Red 2", view.recording.cameraName, toSeconds(later.time), later.ellipse.centrePx}}),
                 QString());
        stored = m_project->trials().pointedOut(m_trial.id).value();
        QCOMPARE(stored.size(), std::size_t(1));
        QCOMPARE(stored.front().frame, later.frame);

        QCOMPARE(track({{"Red 2"}}), QString());
        QVERIFY(m_project->trials().pointedOut(m_trial.id)->empty());
    }

    void whatCannotBeMeantIsRefused_data()
    {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("view");
        QTest::addColumn<double>("timeS");
        QTest::addColumn<QPointF>("pixel");
        QTest::addColumn<QString>("why");
        QTest::newRow("robot") << "Nobody"
                               << "A" << 0.5 << QPointF(10, 10) << "is not tracked in trial";
        QTest::newRow("view") << "Red 2"
                              << "Z" << 0.5 << QPointF(10, 10) << "the trial has no such view";
        QTest::newRow("time") << "Red 2"
                              << "A" << 500.0 << QPointF(10, 10) << "the view has no frame at that time";
        QTest::newRow("before") << "Red 2"
                                << "A" << -3.0 << QPointF(10, 10) << "the view has no frame at that time";
        QTest::newRow("outside") << "Red 2"
                                 << "A" << 0.5 << QPointF(10, 1e9) << "the position is outside the frame";
        QTest::newRow("no number") << "Red 2"
                                   << "A" << std::nan("") << QPointF(10, 10)
                                   << "the view has no frame at that time";
        QTest::newRow("nothing there")
            << "Red 2"
            << "A" << 0.5 << QPointF(2, 2) << "no foreground object was found at pixel 2,2 at 0.5";
    }

    void whatCannotBeMeantIsRefused()
    {
        QFETCH(QString, robot);
        QFETCH(QString, view);
        QFETCH(double, timeS);
        QFETCH(QPointF, pixel);
        QFETCH(QString, why);
        const auto before = m_project->analyses().current(m_trial.id)->size();
        const QString words =
            track({{robot.toStdString(), view.toStdString(), timeS, {pixel.x(), pixel.y()}}});
        QVERIFY2(words.contains(why), qPrintable(words));
        QVERIFY(m_project->trials().pointedOut(m_trial.id)->empty());
        QCOMPARE(m_project->analyses().current(m_trial.id)->size(), before);
    }

    void aColouredRobotIsMarkedToo()
    {
        QVERIFY(m_project->robots().set(m_coloured));
        QCOMPARE(track({}), QString());
        const auto [view, observation] = seen(10);
        const RobotPointer pointer{"Red 2", view.recording.cameraName, toSeconds(observation.time),
                                   observation.ellipse.centrePx};
        QCOMPARE(track({pointer}), QString());
        QCOMPARE(m_project->trials().pointedOut(m_trial.id)->size(), std::size_t(1));
        const QString words = track({{"Red 2", "A", 0.5, {10, 10}}});
        QVERIFY2(words.contains(QStringLiteral("no foreground object was found")), qPrintable(words));
    }

    void furtherMarksStay()
    {
        QCOMPARE(track({}), QString());
        const auto markAt = [this](std::size_t frame) {
            const auto [view, observation] = seen(frame);
            return RobotPointer{"Red 2", view.recording.cameraName, toSeconds(observation.time),
                                observation.ellipse.centrePx, true};
        };
        const RobotPointer first = markAt(10), second = markAt(20);
        QCOMPARE(track({first}), QString());
        QCOMPARE(track({second}), QString());
        QCOMPARE(m_project->trials().pointedOut(m_trial.id)->size(), std::size_t(2));
        QCOMPARE(track({second}), QString()); // in the same frame it is replaced
        QCOMPARE(m_project->trials().pointedOut(m_trial.id)->size(), std::size_t(2));
        QVERIFY(m_project->undo());
        QVERIFY(m_project->undo());
        QCOMPARE(m_project->trials().pointedOut(m_trial.id)->size(), std::size_t(1));
    }

private:
    QString track(const std::vector<RobotPointer> &pointers)
    {
        TrackSettings settings;
        settings.robots = {"Red 2"};
        settings.pointers = pointers;
        TrackJob job("Trial 1", settings);
        const auto done = runToEnd(job, *m_project, JobControl());
        return done ? QString() : QString::fromStdString(done.error().message());
    }

    /// What the first view that saw the robot in a frame saw.
    std::pair<RegisteredView, Observation> seen(std::size_t frame)
    {
        const auto views = registeredViews(*m_project, m_trial).value();
        for (const RegisteredView &view : views) {
            const auto series =
                m_project->trials().currentObservations(view.recording.id, m_coloured.id).value();
            if (series && frame < series->observations.size() && series->observations[frame].found)
                return {view, series->observations[frame]};
        }
        return {};
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    TrialRecord m_trial;
    RobotRecord m_coloured;
};

ODOGRAPH_TEST(TestPointedOut, QCoreApplication)
#include "tst_pointed_out.moc"
