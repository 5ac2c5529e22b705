// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/corrections.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/timeline.h"
#include "ui/views/widgets/spike_list.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

using namespace odo;

class TestSpikeActions : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void offersWhatTheSampleAllows_data();
    void offersWhatTheSampleAllows();
    void nothingWithoutAMeasurement();
    void asksForTheRobotThatIsMeant();
    void asksForAllThatAreChosen();
    void aRunOf194SpikesTakesThreeActions();
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

void TestSpikeActions::asksForAllThatAreChosen()
{
    auto scene = std::make_shared<TrialScene>(*exampleScene({}));
    auto &samples = scene->robots[0].analysis->profile.samples;
    for (const std::size_t i : {10, 12})
        samples[i].flags = flagBit(SampleFlag::Jump);
    samples[11].flags = 0;
    Timeline timeline;
    timeline.setFrameTimes(scene->frameTimes());
    SpikeActions actions(timeline);
    actions.setScene(scene);
    QSignalSpy requested(&actions, &SpikeActions::requested);
    actions.setChosen({samples[10].frame, samples[11].frame, samples[12].frame});
    actions.actions().at(0)->trigger(); // use: the one that is used already is not among them
    const auto request = requested.front().front().value<OverrideRequest>();
    QVERIFY((request.frames == std::vector<std::int64_t>{samples[10].frame, samples[12].frame}));
    QVERIFY(request.word == OverrideRequest::Word::Valid);
    actions.actions().at(1)->trigger(); // mark: a single one
    QVERIFY(requested.back().front().value<OverrideRequest>().frames.empty());
    QCOMPARE(requested.back().front().value<OverrideRequest>().frame, std::optional(samples[11].frame));
    actions.setChosen({});
    timeline.setCurrentFrame(samples[11].frame);
    QVERIFY(!actions.actions().at(0)->isEnabled() && actions.actions().at(1)->isEnabled());
}

/// By reason, and by a range of the time line, as a person would.
void TestSpikeActions::aRunOf194SpikesTakesThreeActions()
{
    constexpr int spikes = 194;
    auto scene = std::make_shared<TrialScene>(*exampleScene({}));
    Profile &profile = scene->robots[0].analysis->profile;
    const Sample first = profile.samples.front();
    profile.samples.clear();
    profile.points.clear();
    profile.spikes.clear();
    for (int i = 0; i < 3 * spikes; ++i) {
        Sample sample = first;
        sample.frame = i;
        sample.time = std::chrono::milliseconds(20 * i);
        sample.position = Eigen::Vector2d(0.001 * i, 0);
        const bool isSpike = i % 3 == 0;
        sample.flags = isSpike ? flagBit(i % 2 == 0 ? SampleFlag::Jump : SampleFlag::LowScore) |
                                     flagBit(SampleFlag::ViewsDisagree)
                               : 0;
        if (isSpike)
            profile.spikes.push_back({i, sample.time, sample.flags, {}});
        profile.samples.push_back(sample);
        profile.points.emplace_back();
    }
    std::vector<Nanoseconds> times;
    for (const Sample &sample : profile.samples)
        times.push_back(sample.time);
    scene->views.front().recording.frameTimes = times;
    Timeline timeline;
    timeline.setFrameTimes(times);
    SpikeActions actions(timeline);
    SpikeList list(timeline);
    connect(&list, &SpikeList::robotChosen, &actions, &SpikeActions::setRobot);
    connect(&list, &SpikeList::samplesChosen, &actions, &SpikeActions::setChosen);
    actions.setScene(scene);
    list.setScene(scene);
    QSignalSpy requested(&actions, &SpikeActions::requested);
    const auto chosenFrames = [&] { return requested.back().front().value<OverrideRequest>().frames.size(); };
    const auto isSpikeRow = [&](int row) {
        return list.table()->model()->index(row, 0).data(SpikeModel::SampleIndexRole).toLongLong() == 0;
    };
    int row = 0;
    while (!isSpikeRow(row))
        ++row;
    list.table()->selectRow(row);            // one
    list.selectActions().front()->trigger(); // all that share a reason with it
    actions.actions().front()->trigger();    // use them
    QCOMPARE(chosenFrames(), std::size_t(spikes));

    timeline.setSelection(TimeSpan{times[90], times[299]}); // dragged
    list.selectActions().back()->trigger();
    actions.actions().front()->trigger();
    QCOMPARE(chosenFrames(), std::size_t(70));
}

ODOGRAPH_TEST(TestSpikeActions, QApplication)
#include "tst_spike_actions.moc"
