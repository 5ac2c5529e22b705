// SPDX-License-Identifier: GPL-3.0-or-later
// A robot is pointed out in a picture of Review, by a click or by the mouse's menu.
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"
#include "ui/review/corrections.h"
#include "ui/views/image/image_overlay.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>

using namespace odo;

class TestRobotPointing : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void offersRobotsOfAnyLook()
    {
        auto scene = std::make_shared<TrialScene>(*exampleScene({}));
        for (std::size_t r = 0; r < scene->robots.size(); ++r) {
            scene->robots[r].robot.colour.reset();
            scene->robots[r].robot.id = RecordId(r + 1);
        }
        scene->robots.front().robot.name = "Rover & co.";
        scene->pointedOut = {{scene->robots.front().robot.id, 1, 5, {3, 4}}};
        Timeline timeline;
        timeline.setFrameTimes(scene->frameTimes());
        RobotPointing pointing(timeline);
        QVERIFY(!pointing.action()->isEnabled());
        pointing.setScene(scene);
        QVERIFY(pointing.action()->isEnabled());
        timeline.setCurrentFrame(10);
        pointing.action()->setChecked(true);

        RobotPointer told;
        QString trial;
        connect(&pointing, &RobotPointing::requested, this,
                [&](const QString &name, const RobotPointer &pointer) {
                    trial = name;
                    told = pointer;
                });
        QMenu menu;
        pointing.fill(menu, 1, {123, 45});
        // with a line, and what takes the first one's back
        QCOMPARE(menu.actions().size(), qsizetype(scene->robots.size() + 2));
        QCOMPARE(menu.actions().front()->text(), QStringLiteral("This is Rover && co.: track it again"));
        menu.actions().front()->trigger();
        QCOMPARE(trial, QString::fromStdString(scene->trial.name));
        QCOMPARE(told.robot, std::string("Rover & co."));
        QCOMPARE(told.view, scene->views[1].camera);
        QCOMPARE(told.timeS, toSeconds(timeline.currentTime()));
        QVERIFY((told.pixel == Eigen::Vector2d(123, 45)));
        QVERIFY(told.isFurther); // earlier marks stay
        QVERIFY(!pointing.action()->isChecked());
        QCOMPARE(menu.actions().back()->text(), QStringLiteral("Find Rover && co. automatically"));
        menu.actions().back()->trigger();
        QVERIFY(told.view.empty());
    }

    void nothingForImported()
    {
        auto scene = std::make_shared<TrialScene>(*exampleScene({}));
        Timeline timeline;
        timeline.setFrameTimes(scene->frameTimes());
        RobotPointing pointing(timeline);
        const auto offered = [&] {
            pointing.setScene(scene);
            QMenu menu;
            pointing.fill(menu, 0, {1, 1});
            return pointing.action()->isEnabled() || !menu.isEmpty();
        };
        QVERIFY(offered());
        scene->imported.resize(1);
        QVERIFY(!offered());
        scene.reset();
        QVERIFY(!offered());
    }

    void aPixelIsFoundAgain()
    {
        const QRectF fitted = fittedRect({1280, 720}, {400, 300}, 1);
        const QPointF pixel(321.5, 12.25), there = fromImagePixel(pixel, {1280, 720}, fitted);
        const QPointF back = toImagePixel(there, {1280, 720}, fitted);
        QVERIFY(qAbs(back.x() - pixel.x()) < 1e-9 && qAbs(back.y() - pixel.y()) < 1e-9);
    }
};

ODOGRAPH_TEST(TestRobotPointing, QApplication)
#include "tst_robot_pointing.moc"
