// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/record/record_trial.h"
#include "tests/support/datagram_receiver.h"
#include "tests/support/protobuf_decoder.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <numbers>

using namespace odo;
using namespace odo::test;

class TestRecordTrial : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(
            *Project::create(m_folder->filePath(QStringLiteral("p.odo")).toStdString(), "Recording"));
    }
    void cleanup() { m_project.reset(); }

    /// Half a second, and what the camera saw in the second before; the files' hashes are there at once.
    void thePreRollIsRecordedToo()
    {
        const RecordSettings settings{
            .trial = "run", .cameras = {{"A", "sim:A"}}, .seconds = 0.5, .preRollS = 1, .robots = {}};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY2(recorded, recorded ? "" : recorded.error().message().c_str());
        const auto trial = m_project->trials().find("run");
        QVERIFY(trial && !trial->unfinished);
        QVERIFY2(trial->durationS > 1.2,
                 qPrintable(QString::number(trial->durationS))); // a picture or two at each end
        QVERIFY(!m_project->trials().recordings(trial->id)->front().sha256.empty());
        QVERIFY(m_project->check(true)->empty());
    }

    /// Five seconds before the button, and half a one after it, from the cameras of the program. Their
    /// numbers go on over the seam; a busy machine paints fewer frames, which the cameras' own count shows.
    /// (capture/tst_capture_session has the exact numbers of cameras that lose none.)
    void fiveSecondsBeforeAreWhole()
    {
        const RecordSettings settings{.trial = "run",
                                      .cameras = {{"A", "sim:A"}, {"B", "sim:B"}},
                                      .seconds = 0.5,
                                      .preRollS = 5,
                                      .robots = {}};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY2(recorded, recorded ? "" : recorded.error().message().c_str());
        for (const ViewRecording &view : (*recorded)->outcome().views) {
            const std::vector<RawTime> &frames = view.times.frames;
            const std::uint64_t numbers = frames.back().sequence - frames.front().sequence + 1;
            qInfo("%zu frames of %d numbers, %d lost", frames.size(), int(numbers),
                  int(view.lostByUs + view.lostOnWire));
            QCOMPARE(frames.size() + view.lostByUs + view.lostOnWire, numbers);
            QCOMPARE(view.frames, frames.size() + view.lostByUs);
            for (std::size_t i = 1; i < frames.size(); ++i)
                QVERIFY(frames[i].sequence > frames[i - 1].sequence);
            QVERIFY(!view.keptOnlyFrom);
        }
        // From the first frame that arrived in these five seconds: one interval, and what a frame takes.
        const double startS = std::stod((*recorded)->trial().variables.at(startVariable));
        QVERIFY2(startS > 4.8 && startS < 5.1, qPrintable(QString::number(startS)));
        QVERIFY((*recorded)->trial().durationS > 5.3);
    }

    /// The file is removed as soon as the first words say that it records.
    void whatIsRecordedIntoAFileThatIsTakenAwayIsRescued()
    {
        const std::filesystem::path file = m_project->file();
        QStringList told;
        const RecordSettings settings{
            .trial = "run",
            .cameras = {{"A", "sim:A"}},
            .seconds = 1,
            .robots = {},
            .warn = [&](const Message &words) { told << QString::fromStdString(words.english()); }};
        JobControl control;
        control.progress = [&](double, const Message &text) {
            if (text.english() == "recording")
                std::filesystem::remove(file);
        };
        const auto recorded = recordTrial(*m_project, settings, control);
        QVERIFY2(recorded, recorded ? "" : recorded.error().message().c_str());
        QCOMPARE(told,
                 QStringList(QStringLiteral("the project file was deleted, renamed or replaced; recording "
                                            "continues, and its contents will be saved at the end")));
        const std::filesystem::path rescued = file.parent_path() / "p (rescued).odo";
        QCOMPARE((*recorded)->warnings().back().english(),
                 "the project file was deleted, renamed or replaced; its contents were saved in '" +
                     rescued.string() + "', the project from now on");
        const auto project = Project::open(rescued, Project::Access::ReadOnly);
        QVERIFY(project);
        const auto trial = (*project)->trials().find("run");
        QVERIFY(trial && !trial->unfinished && trial->durationS > 0.5);
        QVERIFY((*project)->check(true)->empty());
    }

    /// The simulated robot's place while it is recorded, by a packet of the network: on its circle.
    void livePositionsAreSent()
    {
        addTestbed();
        const DatagramReceiver receiver(true);
        RecordSettings settings{
            .trial = "run", .cameras = {{"A", "sim:A"}, {"B", "sim:B"}}, .seconds = 2, .robots = {"driver"}};
        settings.broadcast = BroadcastTarget{.port = receiver.port};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY2(recorded, recorded ? "" : recorded.error().message().c_str());
        const auto packet = decodeMessage(receiver.next());
        QVERIFY(packet && packet->first(1)); // none is sent where the cameras are too slow for a position
        const auto frame = decodeMessage(packet->first(1)->bytes);
        QVERIFY(frame && frame->fields.count(6) + frame->fields.count(7) == 1);
        const auto robot = decodeMessage((frame->first(6) ? frame->first(6) : frame->first(7))->bytes);
        const Eigen::Vector2d fromMiddle(robot->first(3)->shortReal() - 1500.0,
                                         robot->first(4)->shortReal() - 1100.0);
        // Some millimetres of the centre, some of a filter that has just begun.
        QVERIFY2(std::abs(fromMiddle.norm() - 750) < 40, qPrintable(QString::number(fromMiddle.norm())));
    }

    /// It circles all the time, so motion starts a run at once; and a second later it ends.
    void motionStartsARun()
    {
        addTestbed();
        const RecordSettings settings{.trial = "run",
                                      .cameras = {{"A", "sim:A"}, {"B", "sim:B"}},
                                      .seconds = 1,
                                      .robots = {},
                                      .start = RunTrigger{RunTrigger::Kind::Motion},
                                      .stop = RunTrigger{RunTrigger::Kind::Motion, {}, usualRest}};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY2(recorded, recorded ? "" : recorded.error().message().c_str());
        const TrialRecord trial = (*recorded)->trial();
        // The second before, as far as the cameras ran already, and the one after it.
        QVERIFY2(trial.durationS > 1.2 && trial.durationS < 3, qPrintable(QString::number(trial.durationS)));
        QVERIFY(trial.variables.contains(startVariable));
    }

    /// The left half of the circle: the robot leaves and enters it once in each round of 4.3 s.
    void aZoneStartsAndEndsARun()
    {
        addTestbed();
        TaskRecord task;
        task.name = "Halves";
        task.task.zones = {rectangularZone("Left", ZoneRule::StayInside, {0.5, 0.1}, {1.5, 2.1})};
        QVERIFY(m_project->tasks().add(task));
        RecordSettings settings{.trial = "run",
                                .cameras = {{"A", "sim:A"}, {"B", "sim:B"}},
                                .seconds = 20,
                                .preRollS = 0.5,
                                .robots = {"driver"},
                                .task = "Halves",
                                .start = RunTrigger{RunTrigger::Kind::Exit, "Left"},
                                .stop = RunTrigger{RunTrigger::Kind::Entry, "Left"}};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY2(recorded, recorded ? "" : recorded.error().message().c_str());
        const TrialRecord trial = (*recorded)->trial();
        QCOMPARE(trial.task, std::string("Halves"));
        // A second before, half a round at 1.1 m/s, and a second after; the rest is the checks' interval and
        // a busy machine's.
        const double half = std::numbers::pi * 0.75 / 1.1;
        QVERIFY2(std::abs(trial.durationS - (1 + half + 1)) < 0.7,
                 qPrintable(QString::number(trial.durationS)));
        const double startS = std::stod(trial.variables.at(startVariable));
        QVERIFY2(startS > 0.8 && startS < 1.1, qPrintable(QString::number(startS)));

        settings.trial = "other";
        settings.start->zone = "Right";
        const auto refused = recordTrial(*m_project, settings, {});
        QVERIFY(!refused);
        QCOMPARE(
            refused.error().message(),
            std::string("recording of trial 'other': task 'Halves' has no zone 'Right'; give the name of "
                        "one of its zones"));
        settings.start = RunTrigger{RunTrigger::Kind::Gate};
        QCOMPARE(recordTrial(*m_project, settings, {}).error().why.english(),
                 std::string("task 'Halves' has no start gate"));
    }

    /// Nothing ever passes; whoever stops waiting leaves nothing behind.
    void waitingIsCancelled()
    {
        addTestbed();
        TaskRecord task;
        task.name = "Far";
        task.task.zones = {rectangularZone("Far", ZoneRule::StayInside, {8, 8}, {9, 9})};
        QVERIFY(m_project->tasks().add(task));
        const RecordSettings settings{.trial = "run",
                                      .cameras = {{"A", "sim:A"}},
                                      .robots = {"driver"},
                                      .task = "Far",
                                      .start = RunTrigger{RunTrigger::Kind::Entry, "Far"}};
        JobControl control;
        control.progress = [&](double, const Message &text) {
            if (text.english() == "waiting for the start")
                control.cancel.cancel();
        };
        const auto recorded = recordTrial(*m_project, settings, control);
        QVERIFY(!recorded);
        QCOMPARE(recorded.error().code, ErrorCode::Cancelled);
        QVERIFY(m_project->trials().all()->empty());
    }

    void nothingIsSentWithoutARegistration()
    {
        RecordSettings settings{.trial = "run", .cameras = {{"A", "sim:A"}}, .seconds = 1, .robots = {}};
        settings.broadcast = BroadcastTarget();
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY(!recorded);
        QCOMPARE(recorded.error().message(),
                 std::string("recording of trial 'run': none of its cameras is registered to the floor, so "
                             "there are no live positions "
                             "to send; run odograph register for one of them, or leave --ssl-vision out"));
        QVERIFY(m_project->trials().all()->empty());
    }

    void whatCannotBeDoneIsRefused_data()
    {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<double>("preRollS");
        QTest::addColumn<QByteArray>("why");
        QTest::newRow("no time") << 0.0 << 0.0
                                 << QByteArray("the duration must be above zero and at most a day");
        QTest::newRow("more than is kept")
            << 1.0 << 60.0 << QByteArray("the pre-roll must be from 0 s to 30 s");
        QTest::newRow("no number") << 1.0 << std::nan("")
                                   << QByteArray("the pre-roll must be from 0 s to 30 s");
    }
    void whatCannotBeDoneIsRefused()
    {
        QFETCH(double, seconds);
        QFETCH(double, preRollS);
        QFETCH(QByteArray, why);
        const RecordSettings settings{.trial = "run",
                                      .cameras = {{"A", "sim:A"}},
                                      .seconds = seconds,
                                      .preRollS = preRollS,
                                      .robots = {}};
        const auto recorded = recordTrial(*m_project, settings, {});
        QVERIFY(!recorded);
        QCOMPARE(recorded.error().why.english(), why.toStdString());
        QVERIFY(m_project->trials().all()->empty());
    }

private:
    /// Registers both simulated cameras by the true markers, and adds the robot that circles before them.
    void addTestbed()
    {
        const SimulatedScene testbed = demoTestbed(1);
        const RecordId layout = m_project->layouts().add(testbed.floor.markers)->id;
        for (const SimulatedCamera &camera : testbed.cameras) {
            RegistrationRecord record;
            record.layout = layout;
            record.assumedIntrinsics = camera.view.camera().intrinsics();
            for (const Marker &marker : testbed.floor.markers.markers)
                record.pixels.push_back(
                    {marker.label,
                     *camera.view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0})});
            record.registration =
                *registerFloor(testbed.floor.markers, record.pixels, camera.view.camera(), true);
            QVERIFY(storeRegistration(*m_project, camera.name, record));
        }
        for (const DemoTrial &trial : demoTrials()) {
            if (trial.trial != "circle")
                continue;
            RobotRecord robot;
            robot.name = "driver";
            robot.colour = trial.scene.robots.front().colour;
            robot.heightMode = RobotRecord::Height::Given;
            robot.heightM = trial.scene.robots.front().heightM;
            QVERIFY(m_project->robots().add(robot));
        }
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestRecordTrial, QCoreApplication)
#include "tst_record_trial.moc"
