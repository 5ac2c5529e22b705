// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/timeline.h"

#include "tests/support/registered_test.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QSignalSpy>
#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

class TestTimeline : public QObject
{
    Q_OBJECT
    Nanoseconds m_now{0};

    std::unique_ptr<Timeline> tenFrames()
    {
        m_now = 0ns;
        auto timeline = std::make_unique<Timeline>([this] { return m_now; });
        std::vector<Nanoseconds> times;
        for (int i = 0; i < 10; ++i)
            times.push_back(i * 100ms);
        timeline->setFrameTimes(times);
        return timeline;
    }
    void pass(Timeline &timeline, Nanoseconds time)
    {
        m_now += time;
        timeline.tick();
    }

private Q_SLOTS:
    void isHarmlessWhenEmpty()
    {
        Timeline timeline;
        timeline.play();
        timeline.step(3);
        timeline.setCurrentTime(1s);
        timeline.tick();
        QCOMPARE(timeline.currentFrame(), 0);
        QCOMPARE(timeline.currentTime(), Nanoseconds(0));
        QVERIFY(!timeline.isPlaying());
        QVERIFY(!timeline.action(Timeline::Command::PlayPause)->isEnabled());
    }
    void goesToTheNearestFrame()
    {
        const auto timeline = tenFrames();
        QSignalSpy changes(timeline.get(), &Timeline::currentChanged);
        timeline->setCurrentTime(349ms);
        QCOMPARE(timeline->currentFrame(), 3);
        timeline->setCurrentTime(351ms);
        QCOMPARE(timeline->currentFrame(), 4);
        timeline->setCurrentTime(-5s);
        QCOMPARE(timeline->currentFrame(), 0);
        timeline->setCurrentTime(5s);
        QCOMPARE(timeline->currentTime(), Nanoseconds(900ms));
        QCOMPARE(changes.count(), 4);
        timeline->setCurrentFrame(9); // where it is already
        QCOMPARE(changes.count(), 4);
    }
    void playsByTheClock()
    {
        const auto timeline = tenFrames();
        timeline->play();
        pass(*timeline, 99ms);
        QCOMPARE(timeline->currentFrame(), 0);
        pass(*timeline, 2ms);
        QCOMPARE(timeline->currentFrame(), 1);
        pass(*timeline, 400ms); // a late tick skips frames, it does not slow down
        QCOMPARE(timeline->currentFrame(), 5);
    }
    void playsSlowerFasterAndBackwards()
    {
        const auto timeline = tenFrames();
        timeline->setRate(0.1);
        timeline->play();
        pass(*timeline, 990ms);
        QCOMPARE(timeline->currentFrame(), 0);
        pass(*timeline, 20ms);
        QCOMPARE(timeline->currentFrame(), 1);
        timeline->setRate(100); // kept within the fastest
        QCOMPARE(timeline->rate(), Timeline::fastestRate);
        pass(*timeline, 50ms);
        QCOMPARE(timeline->currentFrame(), 5);
        timeline->setRate(-1);
        pass(*timeline, 200ms);
        QCOMPARE(timeline->currentFrame(), 3);
        timeline->setRate(0); // no rate at all
        QCOMPARE(timeline->rate(), -1.0);
    }
    void stopsAtTheEndAndStartsOver()
    {
        const auto timeline = tenFrames();
        timeline->setCurrentFrame(8);
        timeline->play();
        pass(*timeline, 150ms); // the last frame has its time as well
        QCOMPARE(timeline->currentFrame(), 9);
        QVERIFY(timeline->isPlaying());
        pass(*timeline, 100ms);
        QCOMPARE(timeline->currentFrame(), 9);
        QVERIFY(!timeline->isPlaying());
        timeline->play();
        QCOMPARE(timeline->currentFrame(), 0);
    }
    void loops()
    {
        const auto timeline = tenFrames();
        timeline->setLooping(true);
        QVERIFY(timeline->action(Timeline::Command::Loop)->isChecked());
        timeline->play();
        pass(*timeline, 1250ms);
        QCOMPARE(timeline->currentFrame(), 2);
        QVERIFY(timeline->isPlaying());
        timeline->setRate(-1);
        pass(*timeline, 300ms);
        QCOMPARE(timeline->currentFrame(), 9);
    }
    void loopsOverTheSelection()
    {
        const auto timeline = tenFrames();
        timeline->setSelection(TimeSpan{220ms, 480ms}); // to frames 2 and 5
        QCOMPARE(timeline->selection()->begin, Nanoseconds(200ms));
        QCOMPARE(timeline->selection()->end, Nanoseconds(500ms));
        timeline->setLooping(true);
        timeline->setCurrentFrame(4);
        timeline->play();
        pass(*timeline, 190ms);
        QCOMPARE(timeline->currentFrame(), 5); // the last one has its time as well
        pass(*timeline, 20ms);
        QCOMPARE(timeline->currentFrame(), 2);
        timeline->setRate(-1);
        pass(*timeline, 50ms);
        QCOMPARE(timeline->currentFrame(), 5);
        timeline->setCurrentFrame(9); // outside: played into it
        timeline->setRate(1);
        pass(*timeline, 10ms);
        QVERIFY(timeline->currentFrame() >= 2 && timeline->currentFrame() <= 5);
        timeline->setLooping(false); // it plays on beyond it
        timeline->setCurrentFrame(5);
        pass(*timeline, 110ms);
        QCOMPARE(timeline->currentFrame(), 6);
    }
    void selectionIsMadeByKeys()
    {
        const auto timeline = tenFrames();
        QSignalSpy changes(timeline.get(), &Timeline::selectionChanged);
        QAction *begin = timeline->action(Timeline::Command::SelectionBegin),
                *end = timeline->action(Timeline::Command::SelectionEnd),
                *clear = timeline->action(Timeline::Command::ClearSelection);
        QVERIFY(!clear->isEnabled());
        timeline->setCurrentFrame(3);
        begin->trigger();
        QCOMPARE(*timeline->selection(), (TimeSpan{300ms, 900ms})); // to the end
        timeline->setCurrentFrame(6);
        end->trigger();
        QCOMPARE(*timeline->selection(), (TimeSpan{300ms, 600ms}));
        timeline->setCurrentFrame(8);
        begin->trigger(); // behind its end: a new one
        QCOMPARE(*timeline->selection(), (TimeSpan{800ms, 900ms}));
        timeline->setCurrentFrame(2);
        end->trigger();
        QCOMPARE(*timeline->selection(), (TimeSpan{0ms, 200ms}));
        QCOMPARE(changes.count(), 4);
        QVERIFY(clear->isEnabled());
        clear->trigger();
        QVERIFY(!timeline->selection() && !clear->isEnabled());
        timeline->setCurrentFrame(0);
        end->trigger(); // of a single frame: none
        QVERIFY(!timeline->selection());
    }
    void selectionIsKeptInOrderAndInside()
    {
        const auto timeline = tenFrames();
        timeline->setSelection(TimeSpan{5s, -1s});
        QCOMPARE(*timeline->selection(), (TimeSpan{0ms, 900ms}));
        timeline->setSelection(TimeSpan{310ms, 290ms});
        QVERIFY(!timeline->selection());
        timeline->setSelection(TimeSpan{100ms, 300ms});
        QSignalSpy changes(timeline.get(), &Timeline::selectionChanged);
        timeline->setFrameTimes({0ms, 100ms});
        QVERIFY(!timeline->selection());
        QCOMPARE(changes.count(), 1);
        Timeline empty;
        empty.setSelection(TimeSpan{0ms, 1s});
        empty.action(Timeline::Command::SelectionBegin)->trigger();
        QVERIFY(!empty.selection());
    }
    void everyActionHasWords()
    {
        const Timeline timeline;
        for (const QAction *action : timeline.actions())
            QVERIFY2(!action->text().isEmpty(), qPrintable(action->objectName()));
    }
    void stepsAndSkips()
    {
        const auto timeline = tenFrames();
        timeline->play();
        timeline->step(1);
        QVERIFY(!timeline->isPlaying());
        QCOMPARE(timeline->currentFrame(), 1);
        timeline->step(-5);
        QCOMPARE(timeline->currentFrame(), 0);
        timeline->skip(500ms);
        QCOMPARE(timeline->currentFrame(), 5);
        timeline->skip(-10ms); // less than a frame is one frame
        QCOMPARE(timeline->currentFrame(), 4);
    }
    void shuttles()
    {
        const auto timeline = tenFrames();
        const auto trigger = [&](Timeline::Command command) { timeline->action(command)->trigger(); };
        trigger(Timeline::Command::ShuttleForward);
        QVERIFY(timeline->isPlaying());
        QCOMPARE(timeline->rate(), 1.0);
        trigger(Timeline::Command::ShuttleForward);
        QCOMPARE(timeline->rate(), 2.0);
        trigger(Timeline::Command::ShuttleBack);
        QCOMPARE(timeline->rate(), -1.0);
        trigger(Timeline::Command::ShuttleStop);
        QVERIFY(!timeline->isPlaying());
        QCOMPARE(timeline->rate(), 1.0);
    }
    void goesFrameByFrameWhileStopIsHeld()
    {
        const auto timeline = tenFrames();
        timeline->setCurrentFrame(5);
        const auto key = [](QEvent::Type type, int which, bool repeats = false) {
            QObject someWidget;
            QKeyEvent event(type, which, Qt::NoModifier, {}, repeats);
            QCoreApplication::sendEvent(&someWidget, &event);
        };
        const auto trigger = [&](Timeline::Command command) { timeline->action(command)->trigger(); };
        key(QEvent::ShortcutOverride, Qt::Key_K);
        trigger(Timeline::Command::ShuttleStop);
        trigger(Timeline::Command::ShuttleForward);
        trigger(Timeline::Command::ShuttleForward);
        QVERIFY(!timeline->isPlaying());
        QCOMPARE(timeline->currentFrame(), 7);
        key(QEvent::KeyRelease, Qt::Key_K, true); // a key that is held repeats
        key(QEvent::KeyRelease, Qt::Key_L);       // of another key
        trigger(Timeline::Command::ShuttleBack);
        QCOMPARE(timeline->currentFrame(), 6);
        QCOMPARE(timeline->rate(), 1.0);
        key(QEvent::KeyRelease, Qt::Key_K);
        trigger(Timeline::Command::ShuttleForward);
        QVERIFY(timeline->isPlaying());
        // Another key may be that of Stop, and its release may go elsewhere.
        timeline->action(Timeline::Command::ShuttleStop)->setShortcut(Qt::Key_F4);
        key(QEvent::KeyPress, Qt::Key_K);
        trigger(Timeline::Command::ShuttleBack);
        QVERIFY(timeline->isPlaying());
        key(QEvent::KeyPress, Qt::Key_F4);
        trigger(Timeline::Command::ShuttleBack);
        QVERIFY(!timeline->isPlaying());
        QObject window;
        QEvent away(QEvent::WindowDeactivate);
        QCoreApplication::sendEvent(&window, &away);
        trigger(Timeline::Command::ShuttleBack);
        QVERIFY(timeline->isPlaying());
    }
    void hasTheKeysPeopleKnow_data()
    {
        QTest::addColumn<int>("command");
        QTest::addColumn<QKeySequence>("key");
        QTest::addColumn<int>("frame"); ///< from frame 5
        using Command = Timeline::Command;
        QTest::newRow("left") << int(Command::PreviousFrame) << QKeySequence(Qt::Key_Left) << 4;
        QTest::newRow("right") << int(Command::NextFrame) << QKeySequence(Qt::Key_Right) << 6;
        QTest::newRow("shift left") << int(Command::BackOneSecond) << QKeySequence(Qt::SHIFT | Qt::Key_Left)
                                    << 0;
        QTest::newRow("shift right") << int(Command::ForwardOneSecond)
                                     << QKeySequence(Qt::SHIFT | Qt::Key_Right) << 9;
        QTest::newRow("home") << int(Command::First) << QKeySequence(Qt::Key_Home) << 0;
        QTest::newRow("end") << int(Command::Last) << QKeySequence(Qt::Key_End) << 9;
        QTest::newRow("space") << int(Command::PlayPause) << QKeySequence(Qt::Key_Space) << 5;
        QTest::newRow("k") << int(Command::ShuttleStop) << QKeySequence(Qt::Key_K) << 5;
    }
    void hasTheKeysPeopleKnow()
    {
        QFETCH(int, command);
        QFETCH(QKeySequence, key);
        QFETCH(int, frame);
        const auto timeline = tenFrames();
        timeline->setCurrentFrame(5);
        QAction *action = timeline->action(Timeline::Command(command));
        QCOMPARE(action->shortcut(), key);
        QVERIFY(!action->objectName().isEmpty());
        action->trigger();
        QCOMPARE(timeline->currentFrame(), qint64(frame));
    }
    void aNewRangeStopsAndStartsAtTheFirstFrame()
    {
        const auto timeline = tenFrames();
        timeline->setCurrentFrame(7);
        timeline->play();
        QSignalSpy ranges(timeline.get(), &Timeline::rangeChanged);
        timeline->setFrameTimes({0ns, 1s});
        QCOMPARE(ranges.count(), 1);
        QVERIFY(!timeline->isPlaying());
        QCOMPARE(timeline->currentFrame(), 0);
        QCOMPARE(timeline->endTime(), Nanoseconds(1s));
    }
};

ODOGRAPH_TEST(TestTimeline, QApplication)
#include "tst_timeline.moc"
