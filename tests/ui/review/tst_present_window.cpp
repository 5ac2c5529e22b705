// SPDX-License-Identifier: GPL-3.0-or-later
// The page for the projector: large, with the present speed, and never in the way of Review.
#include "ui/views/present/present_window.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/timeline.h"
#include "ui/review/internal/trial_presentation.h"
#include "ui/review/review_desk.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

class OtherRun : public PresentSource
{
public:
    QWidget *makeMap() override { return new QLabel(QStringLiteral("map")); }
    PresentedRun run() const override
    {
        return {QStringLiteral("Otter"), QStringLiteral("Otter 3"), {}, {{QStringLiteral("Blue 1"), {}, {}}}};
    }
    QString speed(std::size_t) const override { return speedNow; }
    QString speedNow = QStringLiteral("0.70");
};

} // namespace

class TestPresentWindow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { test::beginWithoutSettings(); }

    void showsTeamSpeedAndResults()
    {
        const TrialScenePtr scene = exampleScene({.frames = 90});
        Timeline timeline;
        timeline.setFrameTimes(scene->frameTimes());
        QWidget beside;
        TrialPresentation trial(timeline);
        trial.setScene(scene);
        PresentWindow window(beside);
        window.setSource(&trial);
        window.resize(1280, 720);
        window.show();
        const Profile &profile = scene->robots[0].analysis->profile;
        auto *speed = named<QLabel>(window, "Speed now");
        for (const int frame : {20, 60}) {
            timeline.setCurrentFrame(frame);
            QCOMPARE(speed->text(), QLocale().toString(profile.points[std::size_t(frame)].speedMps, 'f', 2));
        }
        for (const Metric &metric : informativeMetrics(profile.metrics, 4)) {
            QVERIFY(says(window, metricName(metric.name).toUtf8().constData()));
            QVERIFY(says(window, metricNumber(metric).text().toUtf8().constData()));
        }
        const int before = speed->fontInfo().pixelSize();
        QVERIFY(before > 90); // to be read from the back of a room
        window.resize(640, 360);
        QVERIFY(speed->fontInfo().pixelSize() < before);
        timeline.setCurrentFrame(10);
        QTest::keyClick(&window, Qt::Key_Right);
        QCOMPARE(timeline.currentFrame(), qint64(11));
        QTest::keyClick(&window, Qt::Key_Space);
        QVERIFY(timeline.isPlaying());
        QSignalSpy closed(&window, &PresentWindow::closed);
        QTest::keyClick(&window, Qt::Key_Escape);
        QCOMPARE(closed.count(), 1);
    }

    /// Each robot has its speed; nothing needs more room than a small projector has, whatever the names.
    void severalRobotsAndLongNames()
    {
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 60, .robots = 2}));
        scene->trial.teamName = "Team " + std::string(2000, 'w');
        scene->trial.name = std::string(2000, 't');
        Timeline timeline;
        timeline.setFrameTimes(scene->frameTimes());
        QWidget beside;
        TrialPresentation trial(timeline);
        trial.setScene(scene);
        PresentWindow window(beside);
        window.setSource(&trial);
        window.resize(1024, 600);
        window.show();
        QCOMPARE(window.size(), QSize(1024, 600));
        QVERIFY2(window.minimumSizeHint().width() <= 1024 && window.minimumSizeHint().height() <= 600,
                 qPrintable(QStringLiteral("%1×%2")
                                .arg(window.minimumSizeHint().width())
                                .arg(window.minimumSizeHint().height())));
        int speeds = 0;
        for (const QLabel *label : window.findChildren<QLabel *>())
            speeds += label->accessibleName() == QLatin1String("Speed now") ? 1 : 0;
        QCOMPARE(speeds, 2);
        trial.setScene(nullptr);
        QVERIFY(!says(window, "m/s"));
    }

    /// Another run comes, and goes before the window does.
    void showsAnotherSource()
    {
        const TrialScenePtr scene = exampleScene({.frames = 30});
        Timeline timeline;
        timeline.setFrameTimes(scene->frameTimes());
        ReviewDesk desk(timeline);
        desk.setScene(scene);
        desk.show();
        for (QAction *each : desk.viewActions())
            if (each->objectName() == QLatin1String("present"))
                each->trigger();
        const auto *window = desk.findChild<PresentWindow *>();
        QVERIFY(window && says(*window, "Falcon"));
        {
            OtherRun other;
            desk.setPresented(&other);
            QVERIFY(says(*window, "Otter") && says(*window, "0.70") && !says(*window, "Falcon"));
            other.speedNow = QStringLiteral("0.81");
            Q_EMIT other.moved();
            QVERIFY(says(*window, "0.81"));
        }
        QVERIFY(says(*window, "No trial"));
        desk.setPresented(nullptr);
        QVERIFY(says(*window, "Falcon"));
    }

    void isACommandOfReview()
    {
        const TrialScenePtr scene = exampleScene({.frames = 30});
        Timeline timeline;
        timeline.setFrameTimes(scene->frameTimes());
        QPointer<PresentWindow> shown;
        {
            ReviewDesk desk(timeline);
            desk.setScene(scene);
            desk.show();
            QAction *action = nullptr;
            for (QAction *each : desk.viewActions())
                if (each->objectName() == QLatin1String("present"))
                    action = each;
            QVERIFY(action);
            action->trigger();
            shown = desk.findChild<PresentWindow *>();
            QVERIFY(shown && shown->isVisible() && shown->isWindow());
            QTest::keyClick(shown, Qt::Key_Escape);
            QVERIFY(!action->isChecked());
            QTRY_VERIFY(!shown);
            action->trigger();
            shown = desk.findChild<PresentWindow *>();
            QVERIFY(shown && shown->isVisible());
            action->trigger();
            QTRY_VERIFY(!shown);
            action->trigger();
            shown = desk.findChild<PresentWindow *>();
        }
        QVERIFY(!shown); // it goes with the desk
    }
};

ODOGRAPH_TEST(TestPresentWindow, QApplication)
#include "tst_present_window.moc"
