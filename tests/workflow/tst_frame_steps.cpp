// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/frame_steps.h"
#include "tests/support/registered_test.h"
#include "tests/synchronisation/frame_faults.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// A view with one robot, whose height is known, as it was tracked.
struct Trial
{
    explicit Trial(const FaultyView &faulty)
    {
        RegisteredView &view = views.emplace_back();
        view.recording.cameraName = "A";
        view.recording.frameTimes = faulty.frameTimes;
        view.floorView = cameraA();
        robots.emplace_back().heightM = 0.06;
        robots.front().heightMode = RobotRecord::Height::Given;
        tracked.emplace_back().series.push_back({1, 1, "colour-ellipse 1", faulty.observations});
        tracked.front().fileTimes = faulty.frameTimes;
    }
    std::vector<RegisteredView> views;
    std::vector<RobotRecord> robots;
    std::vector<TrackedView> tracked;
};

FrameStep stepOf(FrameStep::Kind kind, std::int64_t frames, std::int64_t frame)
{
    FrameStep step;
    step.kind = kind;
    step.frames = frames;
    step.frame = frame;
    step.leapM = 0.25;
    return step;
}

} // namespace

class TestFrameSteps : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void lostFramesGetTheirTimesBack()
    {
        const FaultyView faulty = FrameFaultDrawer(FrameFault::Lost, 7001).draw();
        Trial trial(faulty);
        const auto changed = correctFrameTimes(trial.views, trial.robots, trial.tracked);
        QCOMPARE(changed.size(), std::size_t(1));
        QCOMPARE(changed.front().frameTimes, trial.views.front().recording.frameTimes);
        for (std::size_t i = 0; i < faulty.takenS.size(); ++i) {
            QVERIFY(std::abs(toSeconds(changed.front().frameTimes[i]) - faulty.takenS[i]) < 1e-6);
            QCOMPARE(trial.tracked.front().series.front().observations[i].time,
                     changed.front().frameTimes[i]);
        }
        const auto noted = notedSteps(trial.tracked.front().series.front());
        QCOMPARE(noted.size(), faulty.steps.size());
        for (std::size_t i = 0; i < noted.size(); ++i) {
            QCOMPARE(noted[i].frame, faulty.steps[i].frame);
            QCOMPARE(noted[i].frames, faulty.steps[i].lost);
        }
    }

    void doubledFramesAreMarked()
    {
        const FaultyView faulty = FrameFaultDrawer(FrameFault::Doubled, 7001).draw();
        Trial trial(faulty);
        const auto changed = correctFrameTimes(trial.views, trial.robots, trial.tracked);
        QCOMPARE(changed.size(), std::size_t(1));
        QVERIFY(std::ranges::is_sorted(changed.front().frameTimes, std::less_equal<>()));
        for (std::size_t i = 0; i < faulty.takenS.size(); ++i) {
            QVERIFY(std::abs(toSeconds(changed.front().frameTimes[i]) - faulty.takenS[i]) < 0.001);
            QCOMPARE(trial.tracked.front().series.front().observations[i].duplicateFrame,
                     i > 0 && faulty.takenS[i] == faulty.takenS[i - 1]);
        }
    }

    /// Of a robot that is so slow that it might have stopped.
    void aBriefStopIsNotedAndNothingCorrected()
    {
        int noted = 0;
        for (unsigned seed = 7001; seed <= 7020; ++seed) {
            Trial trial(FrameFaultDrawer(FrameFault::Doubled, seed).draw());
            const auto stamped = trial.views.front().recording.frameTimes;
            correctFrameTimes(trial.views, trial.robots, trial.tracked);
            const auto steps = notedSteps(trial.tracked.front().series.front());
            noted += int(std::ranges::count(steps, FrameStep::Kind::Stood, &FrameStep::kind));
            if (std::ranges::none_of(
                    steps, [](const FrameStep &step) { return step.kind == FrameStep::Kind::Doubled; }))
                QCOMPARE(trial.views.front().recording.frameTimes, stamped);
        }
        QVERIFY(noted >= 3);
    }

    /// The times are right by then, and still the run's page says that they were not.
    void whatWasCorrectedBeforeIsNotedAgain()
    {
        for (const FrameFault fault : {FrameFault::Lost, FrameFault::Doubled}) {
            const FaultyView faulty = FrameFaultDrawer(fault, 7001).draw();
            Trial trial(faulty);
            correctFrameTimes(trial.views, trial.robots, trial.tracked);
            const auto first = notedSteps(trial.tracked.front().series.front());
            trial.tracked.front().series.front().algorithm = "colour-ellipse 1";
            QVERIFY(correctFrameTimes(trial.views, trial.robots, trial.tracked).empty());
            const auto again = notedSteps(trial.tracked.front().series.front());
            QCOMPARE(again.size(), first.size());
            for (std::size_t i = 0; i < again.size(); ++i) {
                QCOMPARE(again[i].frame, first[i].frame);
                QCOMPARE(again[i].frames, first[i].frames);
                QVERIFY(again[i].kind == first[i].kind);
            }
        }
    }

    void aConvertedVideoIsSaid()
    {
        Trial trial(FrameFaultDrawer(FrameFault::Converted, 7004).draw());
        QCOMPARE(correctFrameTimes(trial.views, trial.robots, trial.tracked).size(), std::size_t(1));
        const auto said = frameStepWarnings("run", trial.views, trial.tracked);
        QCOMPARE(said.size(), std::size_t(1));
        QCOMPARE(
            said.front().english(),
            std::string("view 'A' in trial 'run': one frame in 5 repeats the one before, because the video "
                        "was converted to a higher frame rate; its frames were given the times at which "
                        "they were taken"));
        trial.tracked.front().series.front().algorithm = "colour-ellipse 1";
        QVERIFY(correctFrameTimes(trial.views, trial.robots, trial.tracked).empty());
        QCOMPARE(notedSteps(trial.tracked.front().series.front()).size(), std::size_t(1));
    }

    void anInterlacedVideoIsSaid()
    {
        Trial trial(FrameFaultDrawer(FrameFault::None, 7001).draw());
        trial.tracked.front().interlace = Interlace::Whole;
        QVERIFY(correctFrameTimes(trial.views, trial.robots, trial.tracked).empty());
        const auto said = frameStepWarnings("run", trial.views, trial.tracked);
        QCOMPARE(said.size(), std::size_t(1));
        QVERIFY2(said.front().english().starts_with("view 'A' in trial 'run': it is interlaced, but was "),
                 said.front().english().c_str());
        trial.tracked.front().series.front().algorithm = "colour-ellipse 1";
        trial.tracked.front().interlace = Interlace::Fields;
        QVERIFY(correctFrameTimes(trial.views, trial.robots, trial.tracked).empty());
        const auto byFields = frameStepWarnings("run", trial.views, trial.tracked);
        QCOMPARE(byFields.size(), std::size_t(1));
        QVERIFY2(byFields.front().english().starts_with("view 'A' in trial 'run': it is interlaced: each "),
                 byFields.front().english().c_str());
    }

    void soundFramesAndUnregisteredViewsAreLeftAlone()
    {
        Trial sound(FrameFaultDrawer(FrameFault::None, 7001).draw());
        QVERIFY(correctFrameTimes(sound.views, sound.robots, sound.tracked).empty());
        QCOMPARE(sound.tracked.front().series.front().algorithm, std::string("colour-ellipse 1"));
        QVERIFY(frameStepWarnings("run", sound.views, sound.tracked).empty());
        Trial unregistered(FrameFaultDrawer(FrameFault::Lost, 7001).draw());
        unregistered.views.front().floorView.reset();
        QVERIFY(correctFrameTimes(unregistered.views, unregistered.robots, unregistered.tracked).empty());
    }

    void eachIsSaidAndManyAreCounted()
    {
        RecordingRecord view;
        view.cameraName = "A";
        for (int i = 0; i < 100; ++i)
            view.frameTimes.push_back(std::chrono::milliseconds(100 * i));
        const auto said = [&](const std::vector<FrameStep> &steps) {
            std::vector<std::string> words;
            for (const Message &sentence : stepSentences("run", view, steps))
                words.push_back(sentence.english());
            return words;
        };
        QCOMPARE(said({stepOf(FrameStep::Kind::Lost, 6, 34)}),
                 std::vector<std::string>{
                     "view 'A' in trial 'run': after 3.30 s 6 frames are missing that its time stamps do not "
                     "show: the robot moves too far; later times were corrected"});
        QCOMPARE(said({stepOf(FrameStep::Kind::Doubled, 1, 34)}),
                 std::vector<std::string>{
                     "view 'A' in trial 'run': after 3.20 s a frame repeats the one before, and its time "
                     "stamps count it as time; later times were corrected"});
        QCOMPARE(
            said({stepOf(FrameStep::Kind::Stood, 2, 34)}),
            std::vector<std::string>{
                "view 'A' in trial 'run': after 3.10 s the robot rests for 2 frames and then goes on at the "
                "same "
                "speed: either the frames repeat the one before and later times are too late, or the robot "
                "stopped; times were not corrected"});
        QCOMPARE(
            said({stepOf(FrameStep::Kind::Leap, 0, 34)}),
            std::vector<std::string>{
                "view 'A' in trial 'run': after 3.30 s the robot is suddenly 250 mm away: frames are "
                "missing for an unknown time, or another object was tracked; nothing was measured across "
                "it"});
        QCOMPARE(
            said({stepOf(FrameStep::Kind::Frozen, 4, 34)}),
            std::vector<std::string>{"view 'A' in trial 'run': after 2.90 s 4 frames show the same image "
                                     "while the robot went on; they were not measured"});
        std::vector<FrameStep> many;
        for (int i = 1; i < 9; ++i)
            many.push_back(stepOf(FrameStep::Kind::Lost, 1, 10 * i));
        QCOMPARE(said(many).size(), std::size_t(4));
        QCOMPARE(said(many).back(), std::string("view 'A' in trial 'run': up to 7.90 s its frames are wrong "
                                                "at 5 more moments in the same way"));
        QVERIFY(said({stepOf(FrameStep::Kind::Lost, 6, 3400)}).size() == 1); // beyond the frames
    }
};

ODOGRAPH_TEST(TestFrameSteps, QCoreApplication)
#include "tst_frame_steps.moc"
