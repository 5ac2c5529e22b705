// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/found_widgets.h"
#include "ui/main_window/help/help_actions.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestLesson : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void aStepIsDoneByWhatHappensAfterItsBeginning()
    {
        int things = 5;
        const auto doOne = [&things] { return [&things, before = things] { return things > before; }; };
        Lesson lesson;
        QSignalSpy changed(&lesson, &Lesson::changed);
        lesson.start({{QStringLiteral("a"), {}, doOne},
                      {QStringLiteral("b"), {}, doOne},
                      {QStringLiteral("c"), {}, {}}});
        QVERIFY(lesson.isRunning() && !lesson.isDone());
        lesson.poll();
        QVERIFY(!lesson.isDone());
        ++things;
        lesson.poll();
        QVERIFY(lesson.isDone());
        lesson.next();
        QCOMPARE(lesson.step().title, QStringLiteral("b"));
        lesson.poll();
        QVERIFY(!lesson.isDone()); // what was done before does not count
        lesson.next();             // skipped
        QVERIFY(lesson.isDone());  // nothing to do but read
        lesson.next();
        QVERIFY(!lesson.isRunning());
        lesson.poll(); // nothing happens
        QCOMPARE(changed.size(), 5);
    }
    void anEmptyLessonDoesNotRun()
    {
        Lesson lesson;
        lesson.start({});
        QVERIFY(!lesson.isRunning());
    }
    void theFirstLessonFollowsWhatIsDone();
};

void TestLesson::theFirstLessonFollowsWhatIsDone()
{
    QSettings().clear();
    QTemporaryDir folder;
    const auto made = storeExample(folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    MainWindow window;
    window.show();
    QVERIFY(window.openProject(*made));
    QTRY_VERIFY(!window.workspace().isBusy() && window.isSettled());
    auto *bar = window.findChild<LessonBar *>();
    QVERIFY(bar->isHidden());
    window.findChild<QAction *>(QStringLiteral("lesson"))->trigger();
    QVERIFY(bar->isVisible());
    Lesson &lesson = window.findChild<HelpActions *>()->lesson();
    Timeline &timeline = window.findChild<ReviewPage *>()->timeline();
    QCOMPARE(lesson.step().title, QStringLiteral("Play a run"));
    timeline.play();
    QTRY_VERIFY(lesson.isDone());
    timeline.pause();
    QTest::keyClick(test::button(*bar, "Next"), Qt::Key_Space);
    timeline.setCurrentFrame(timeline.currentFrame() > 15 ? 0 : 29);
    QVERIFY(lesson.isDone());
    while (lesson.step().title != QStringLiteral("Compare two runs"))
        lesson.next();
    QVERIFY(!lesson.isDone());
    window.showMode(MainWindow::Mode::Compare);
    QTRY_VERIFY(lesson.isDone());
    lesson.next();
    window.showMode(MainWindow::Mode::History);
    QTRY_VERIFY(lesson.isDone());
    lesson.next();
    QTest::keyClick(test::button(*bar, "Finish"), Qt::Key_Space);
    QVERIFY(bar->isHidden());
    window.findChild<QAction *>(QStringLiteral("lesson"))->trigger();
    QTest::keyClick(test::button(*bar, "Leave the lesson"), Qt::Key_Space);
    QVERIFY(bar->isHidden());
}

ODOGRAPH_TEST(TestLesson, QApplication)
#include "tst_lesson.moc"
