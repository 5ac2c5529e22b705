// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "ui/record/internal/camera_choice.h"
#include "ui/record/internal/health_watch.h"

#include <QTest>

using namespace odo;

namespace {

CameraDescription device(const std::string &uri, const std::string &kind)
{
    CameraDescription description;
    description.uri = uri;
    description.kind = kind;
    return description;
}

ViewHealth delivering()
{
    ViewHealth view;
    view.state = ViewHealth::State::Delivering;
    view.framesPerSecond = 30;
    view.delivered = 90;
    view.latencyS = 0.012;
    return view;
}

const Error gone = test::saidError(ErrorCode::Unavailable, "camera v4l2:/dev/video0", "it was unplugged",
                                   "plug it in again");

} // namespace

class TestRecordWords : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void proposesCameras();
    void tellsHowAllDo();
    void tellsTheWorstTrouble();
};

void TestRecordWords::proposesCameras()
{
    using Chosen = std::vector<ChosenCamera>;
    const std::vector<CameraDescription> simulated{device("sim:A", "simulated"),
                                                   device("sim:B", "simulated")};
    std::vector<CameraDescription> real = simulated;
    real.push_back(device("v4l2:/dev/video0", "v4l2"));
    real.push_back(device("aravis:x", "aravis"));
    const std::vector<CameraRecord> ab{{1, "A", ""}, {2, "B", ""}};
    QCOMPARE(proposeCameras(ab, simulated, {{"A", "sim:A"}}), (Chosen{{"A", ""}, {"B", ""}}));
    QCOMPARE(proposeCameras({{1, "A", "sim:A"}, {2, "B", "sim:B"}}, real, {}),
             (Chosen{{"A", "sim:A"}, {"B", "sim:B"}}));
    QCOMPARE(proposeCameras(ab, real, {}), (Chosen{{"A", "v4l2:/dev/video0"}, {"B", "aravis:x"}}));
    // What the project tells comes first, then what was chosen before on this machine; no device is two
    // cameras.
    QCOMPARE(proposeCameras({{1, "A", "aravis:x?rate=60"}, {2, "B", ""}}, real, {{"A", "v4l2:/dev/video0"}}),
             (Chosen{{"A", "aravis:x?rate=60"}, {"B", "v4l2:/dev/video0"}}));
    QCOMPARE(proposeCameras(ab, real, {{"A", "aravis:x"}, {"B", "gone"}}),
             (Chosen{{"A", "aravis:x"}, {"B", "v4l2:/dev/video0"}}));
    QCOMPARE(proposeCameras({{1, "A", "sim:B"}, {2, "B", ""}}, simulated, {}),
             (Chosen{{"A", "sim:B"}, {"B", ""}}));
    QVERIFY(proposeCameras({}, simulated, {}).empty());
    QCOMPARE(proposeCameras({}, real, {}), (Chosen{{"A", "v4l2:/dev/video0"}, {"B", "aravis:x"}}));
    QCOMPARE(proposeCameras(ab, {}, {}), (Chosen{{"A", ""}, {"B", ""}}));
    QVERIFY(proposeCameras({}, {}, {}).empty());
    real[2].busy = true;
    QCOMPARE(proposeCameras(ab, real, {{"B", "v4l2:/dev/video0"}}), (Chosen{{"A", "aravis:x"}, {"B", ""}}));
}

void TestRecordWords::tellsHowAllDo()
{
    CaptureHealth health;
    health.views = {delivering(), delivering()};
    health.views[1].lostOnWire = 3;
    health.pairs.pairs = 90;
    health.pairs.p95S = 0.0012;
    const std::vector<WantedCamera> cameras{{"A", "sim:A", std::nullopt, {}},
                                            {"B", "sim:B", std::nullopt, {}}};
    const QList<Fact> facts = healthFacts(health, cameras, {180, 0, 0.038, 0.05});
    QCOMPARE(facts.size(), 4);
    QCOMPARE(facts[0].name, QStringLiteral("Camera A"));
    QVERIFY2(facts[0].value.contains(QStringLiteral("none lost, 12 ms")), qPrintable(facts[0].value));
    QVERIFY(facts[0].value.endsWith(QStringLiteral("not registered")));
    QCOMPARE(facts[1].badge.state, BadgeState::Warning);
    QVERIFY(facts[2].value.startsWith(QStringLiteral("synchronised to 1.2 ms")));
    QCOMPARE(facts[3].value, QStringLiteral("the map is 38 ms behind, no frame skipped"));
    health.disk.recording = true;
    health.disk.bytes = 12'400'000;
    QVERIFY(healthFacts(health, cameras, {}).back().value.startsWith(QStringLiteral("12 MB written")));
    QVERIFY(healthFacts({}, {}, {}).isEmpty());

    // Losses before the run are not the run's.
    QCOMPARE(healthFacts(health, cameras, {}, {}, health)[1].badge.state, BadgeState::Good);
    LivePosition position{};
    position.point.position = {1.234, 0.5};
    position.point.speedMps = 1.1;
    position.point.sigmaSpeedMps = 0.02;
    position.point.valid = true;
    position.sample.views = 3;
    const QList<Fact> robots = healthFacts({}, {}, {}, {{"Red 2", std::nullopt}, {"Blue 1", position}});
    QCOMPARE(robots[0].value, QStringLiteral("no camera sees it"));
    QVERIFY2(robots[1].value.startsWith(QStringLiteral("x 1.23 m, y 0.50 m, 1.10 ±0.02")),
             qPrintable(robots[1].value));
    position.sample.views = 1;
    QVERIFY(healthFacts({}, {}, {}, {{"Blue 1", position}})[0].value.endsWith(
        QStringLiteral("one camera sees it")));
}

void TestRecordWords::tellsTheWorstTrouble()
{
    CaptureHealth health;
    health.views = {delivering(), delivering()};
    const std::vector<WantedCamera> cameras{{"A", "sim:A", std::nullopt, {}},
                                            {"B", "sim:B", std::nullopt, {}}};
    QCOMPARE(warningWords(health, cameras), QString());
    health.pairs.pairs = 30;
    health.pairs.p95S = 0.03;
    QVERIFY(warningWords(health, cameras).contains(QStringLiteral("not synchronised")));
    health.views[0].slow = RecordingWarning{slowCameraError("v4l2:/dev/video2", 12.4, 30), {}};
    QCOMPARE(warningWords(health, cameras),
             QStringLiteral(
                 "Camera A: camera v4l2:/dev/video2: it delivers only 12 frames per second instead of the "
                 "requested 30; give it more light or a shorter exposure, or ask for a lower rate."));
    health.sleep = RecordingWarning{machineSleptError(std::chrono::minutes(3)), {}};
    QCOMPARE(warningWords(health, cameras),
             QStringLiteral("this computer: it slept for 3 min and recorded nothing meanwhile; the recording "
                            "up to then is kept; keep it awake while it records."));
    health.views[1].warning = RecordingWarning{gone, {}};
    QCOMPARE(warningWords(health, cameras),
             QStringLiteral("Camera B: camera v4l2:/dev/video0: it was unplugged; plug it in again."));
    health.disk.warning = RecordingWarning{{ErrorCode::Io, foreignWords("recording"),
                                            foreignWords("the disk is full"), foreignWords("make room")},
                                           {}};
    QCOMPARE(warningWords(health, cameras),
             QStringLiteral("Recording: recording: the disk is full; make room."));
}

ODOGRAPH_TEST(TestRecordWords, QCoreApplication)
#include "tst_record_words.moc"
