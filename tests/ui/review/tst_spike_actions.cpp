// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/corrections.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>

using namespace odo;

Q_DECLARE_METATYPE(odo::OverrideRequest)

class TestSpikeActions : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void offersWhatTheSampleAllows_data();
    void offersWhatTheSampleAllows();
    void nothingWithoutAMeasurement();
    void asksForTheRobotThatIsMeant();
};

void TestSpikeActions::offersWhatTheSampleAllows_data()
{
    QTest::addColumn<uint>("flags");
    QTest::addColumn<QList<bool>>("enabled"); // use, mark, automatic
    const uint jump = flagBit(SampleFlag::Jump), hand = flagBit(SampleFlag::ByHand);
    QTest::newRow("good") << 0u << QList<bool>{false, true, false};
    QTest::newRow("views disagree, used all the same")
        << flagBit(SampleFlag::ViewsDisagree) << QList<bool>{false, true, false};
    QTest::newRow("spike") << jump << QList<bool>{true, false, false};
    QTest::newRow("spike by hand") << (jump | hand) << QList<bool>{true, false, true};
    QTest::newRow("used by hand") << hand << QList<bool>{false, true, true};
}

void TestSpikeActions::offersWhatTheSampleAllows()
{
    QFETCH(uint, flags);
    QFETCH(QList<bool>, enabled);
    auto scene = std::make_shared<TrialScene>(*exampleScene({}));
    Sample &sample = scene->robots[0].analysis->profile.samples[10];
    sample.flags = flags;
    Timeline timeline;
    timeline.setFrameTimes(scene->frameTimes());
    SpikeActions actions(timeline);
    actions.setScene(scene);
    timeline.setCurrentFrame(sample.frame);
    for (int i = 0; i < 3; ++i)
        QCOMPARE(actions.actions().at(i)->isEnabled(), enabled.at(i));
    QSignalSpy requested(&actions, &SpikeActions::requested);
    actions.actions().at(enabled.at(0) ? 0 : 1)->trigger();
    QCOMPARE(requested.size(), 1);
    const auto request = requested.front().front().value<OverrideRequest>();
    QCOMPARE(request.frame, std::optional(sample.frame));
    QCOMPARE(request.trial, scene->trial.name);
    QVERIFY(request.word == (enabled.at(0) ? OverrideRequest::Word::Valid : OverrideRequest::Word::Spike));
}

void TestSpikeActions::nothingWithoutAMeasurement()
{
    auto scene = std::make_shared<TrialScene>(*exampleScene({}));
    scene->robots[0].analysis->profile.samples[10].position.reset();
    Timeline timeline;
    SpikeActions actions(timeline);
    const auto none = [&actions] {
        return std::ranges::none_of(actions.actions(),
                                    [](const QAction *action) { return action->isEnabled(); });
    };
    QVERIFY(none());
    timeline.setFrameTimes(scene->frameTimes());
    actions.setScene(scene);
    timeline.setCurrentFrame(scene->robots[0].analysis->profile.samples[10].frame);
    QVERIFY(none());
    scene = std::make_shared<TrialScene>(*scene);
    scene->robots[0].analysis.reset();
    actions.setScene(scene);
    QVERIFY(none());
    actions.setScene(nullptr);
    QVERIFY(none());
}

void TestSpikeActions::asksForTheRobotThatIsMeant()
{
    auto scene = std::make_shared<TrialScene>(*exampleScene({}));
    scene->robots.push_back(scene->robots.front());
    scene->robots.back().robot.name = "Second";
    Timeline timeline;
    timeline.setFrameTimes(scene->frameTimes());
    SpikeActions actions(timeline);
    actions.setScene(scene);
    timeline.setCurrentFrame(scene->robots[0].analysis->profile.samples[5].frame);
    QSignalSpy requested(&actions, &SpikeActions::requested);
    actions.setRobot(scene->robots.size() - 1);
    actions.actions().at(1)->trigger();
    QCOMPARE(requested.front().front().value<OverrideRequest>().robot, std::string("Second"));
    actions.setRobot(99); // of a list that is not up to date: nobody is asked
    actions.actions().at(1)->trigger();
    QCOMPARE(requested.size(), 1);
}

ODOGRAPH_TEST(TestSpikeActions, QApplication)
#include "tst_spike_actions.moc"
