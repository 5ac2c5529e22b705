// SPDX-License-Identifier: GPL-3.0-or-later
// From two GigE cameras to a robot's track, by the command line: the simulated testbed is streamed over the
// loopback as raw Bayer pictures, by cameras whose clocks know nothing of one another.
#include "core/exchange/calibration_file.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/gige/raw_painters.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <future>
#include <numbers>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;
using Eigen::Vector2d;

namespace {

constexpr double rate = 20, roundS = 4, radiusM = 0.45, rampS = 0.5, exposureS = 0.008;
constexpr std::int64_t firstFrame = 20; // a second: the robot has its speed
constexpr Nanoseconds phase = 12ms;     // by how much B is later
const char *const addresses[] = {"127.31.5.2", "127.31.5.3"};

} // namespace

class TestRecordGige : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void theyAreListed();
    void aRobotIsMeasured();
    void aCameraThatIsGoneForAWhile();

private:
    void setUpScene();
    void plugIn(std::size_t camera);
    void setUpProject();
    ProgramRun call(const QString &line) const
    {
        QStringList arguments = line.split(u' ', Qt::SkipEmptyParts);
        arguments.replaceInStrings(QStringLiteral("%/"), m_folder.path() + u'/');
        return runProgram(arguments);
    }
    void succeed(const QString &line) const
    {
        const ProgramRun run = call(line);
        QVERIFY2(run.exitStatus == 0, run.err.constData());
    }
    void write(const QString &name, const QByteArray &text) const
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }

    QTemporaryDir m_folder;
    SimulatedScene m_scene = demoTestbed(3);
    SimulatedRobot m_robot;
    const Nanoseconds m_beginning = steadyNow();
    SimulatedGigeCamera::Painter m_painters[2];
    std::unique_ptr<SimulatedGigeCamera> m_cameras[2];
};

void TestRecordGige::setUpScene()
{
    m_robot.name = "red";
    m_robot.colour = *parseColour("#d72328");
    m_robot.motion = makeCircleMotion({1.5, 1.1}, radiusM, 2 * std::numbers::pi * radiusM / roundS, rampS);
    m_scene.robots = {m_robot};
    m_scene.durationS = static_cast<double>(firstFrame) / rate + roundS;
    m_scene.cameras[0].startOffsetS = 0;
    m_scene.cameras[1].startOffsetS = toSeconds(phase);
    for (std::size_t i = 0; i < 2; ++i) {
        m_scene.cameras[i].framesPerSecond = rate;
        m_scene.cameras[i].clockDriftPpm = 0;
        m_scene.cameras[i].sensor.exposureS = exposureS;
        m_painters[i] =
            scenePainter(m_scene, static_cast<int>(i), firstFrame, pixel::bayerRg8, m_beginning + i * phase);
    }
}

void TestRecordGige::plugIn(std::size_t camera)
{
    SimulatedGigeCamera::Settings settings;
    settings.address = addresses[camera];
    settings.serial = camera == 0 ? "GIGE-A" : "GIGE-B";
    settings.sensorWidth = 1280;
    settings.sensorHeight = 720;
    settings.framesPerSecond = rate;
    settings.exposureS = exposureS;
    settings.clockOffsetS = camera == 0 ? 7 : 3600;
    settings.grid = m_beginning + camera * phase - fromSeconds(exposureS / 2);
    settings.deliveryJitterS = 0.005;
    m_cameras[camera] = std::make_unique<SimulatedGigeCamera>(settings, m_painters[camera]);
}

void TestRecordGige::setUpProject()
{
    QByteArray layout = "label,x_mm,y_mm\n";
    for (const Marker &marker : m_scene.floor.markers.markers)
        layout += QByteArray::fromStdString(marker.label) + ',' +
                  QByteArray::number(1000 * marker.pointInWorld.x()) + ',' +
                  QByteArray::number(1000 * marker.pointInWorld.y()) + '\n';
    write(QStringLiteral("layout.csv"), layout);
    succeed(QStringLiteral("new %/p.odo"));
    succeed(QStringLiteral("robot add %/p.odo red --colour #d72328 --height 60mm --size 260x190"));
    succeed(QStringLiteral("layout add %/p.odo floor %/layout.csv"));
    for (int i = 0; i < 2; ++i) {
        const SimulatedCamera &camera = m_scene.cameras[std::size_t(i)];
        const QString name(QChar(u'A' + i));
        QByteArray markers = "label,u,v\n";
        for (const Marker &marker : m_scene.floor.markers.markers) {
            const Vector2d at =
                *camera.view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
            markers += QByteArray::fromStdString(marker.label) + ',' + QByteArray::number(at.x(), 'f', 2) +
                       ',' + QByteArray::number(at.y(), 'f', 2) + '\n';
        }
        write(name + QStringLiteral(".csv"), markers);
        QVERIFY(writeIntrinsics(m_folder.filePath(name + QStringLiteral(".yaml")).toStdString(), camera.name,
                                camera.view.camera().intrinsics()));
        succeed(QStringLiteral("intrinsics import %/p.odo %1 %/%1.yaml").arg(name));
        succeed(QStringLiteral("register %/p.odo --camera %1 --layout floor --pixels %/%1.csv").arg(name));
    }
}

void TestRecordGige::initTestCase()
{
    setUpScene();
    setUpProject();
    plugIn(0);
    plugIn(1);
}

void TestRecordGige::theyAreListed()
{
    const ProgramRun run = call(QStringLiteral("cameras --json"));
    QCOMPARE(run.exitStatus, 0);
    QStringList uris;
    for (const QJsonValue &camera : run.json().value(QStringLiteral("cameras")).toArray()) {
        if (camera[QStringLiteral("kind")].toString() == QStringLiteral("aravis"))
            uris << camera[QStringLiteral("uri")].toString();
    }
    QVERIFY(uris.contains(QStringLiteral("aravis:GIGE-A")) && uris.contains(QStringLiteral("aravis:GIGE-B")));
    const ProgramRun refused =
        call(QStringLiteral("record %/p.odo --trial x --camera A=aravis:127.31.5.99 --robot red"));
    QCOMPARE(refused.exitStatus, 1);
    QVERIFY2(refused.err.startsWith("odograph: camera aravis:127.31.5.99: it does not answer; ") &&
                 refused.err.count('\n') == 1,
             refused.err.constData());
}

void TestRecordGige::aRobotIsMeasured()
{
    const ProgramRun recorded = call(
        QStringLiteral("record %/p.odo --trial run --camera A=aravis:127.31.5.2 --camera B=aravis:GIGE-B "
                       "--seconds 5 --robot red --json"));
    QVERIFY2(recorded.exitStatus == 0, recorded.err.constData());
    const QJsonObject answer = recorded.json(), views = answer.value(QStringLiteral("views")).toObject();
    for (const char *name : {"A", "B"}) {
        const QJsonObject view = views.value(QLatin1String(name)).toObject();
        // 100 on a machine that has the time.
        QVERIFY2(view.value(QStringLiteral("frames")).toDouble() > 60, recorded.out.constData());
        QVERIFY2(view.value(QStringLiteral("lost_on_wire")).toDouble() <= 20, recorded.out.constData());
    }
    QVERIFY2(answer.value(QStringLiteral("pairs")).toInt() > 55, recorded.out.constData());
    // B is 12 ms later than A; their clocks are an hour apart.
    const double apartMs =
        answer.value(QStringLiteral("pair_error_ms")).toObject().value(QStringLiteral("median")).toDouble();
    QVERIFY2(std::abs(apartMs - 12) < 1, qPrintable(QString::number(apartMs)));

    succeed(QStringLiteral("track %/p.odo run --json"));
    succeed(QStringLiteral("export %/p.odo run -o %/track.csv"));
    QFile csv(m_folder.filePath(QStringLiteral("track.csv")));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> names = csv.readLine().trimmed().split(',');
    std::vector<std::pair<double, Vector2d>> places;
    while (!csv.atEnd()) {
        const QList<QByteArray> cells = csv.readLine().trimmed().split(',');
        const auto number = [&](const char *name) { return cells.value(names.indexOf(name)).toDouble(); };
        if (!cells.value(names.indexOf("x_mm")).isEmpty())
            places.emplace_back(number("t_s"), Vector2d(number("x_mm"), number("y_mm")));
    }
    QVERIFY(places.size() > 55);
    // When the recording began is not known here; where on its circle the robot was then is looked for.
    const auto rmsMm = [&](double beginS) {
        double squares = 0;
        for (const auto &[timeS, place] : places) {
            const double sceneS = static_cast<double>(firstFrame) / rate + std::fmod(beginS + timeS, roundS);
            squares += (place - 1000 * m_robot.motion->at(sceneS).position).squaredNorm();
        }
        return std::sqrt(squares / static_cast<double>(places.size()));
    };
    double best = 1e9;
    for (double beginS = 0; beginS < roundS; beginS += 0.001)
        best = std::min(best, rmsMm(beginS));
    qInfo("pairs %.2f ms apart, RMS %.2f mm", apartMs, best);
    QVERIFY2(best < 5, qPrintable(QString::number(best))); // as with recordings that were rendered to files
}

void TestRecordGige::aCameraThatIsGoneForAWhile()
{
    auto recording = std::async(std::launch::async, [this] {
        return call(QStringLiteral("record %/p.odo --trial gap --camera A=aravis:127.31.5.2 --camera "
                                   "B=aravis:127.31.5.3 --seconds 8 --robot red --json"));
    });
    QTRY_VERIFY_WITH_TIMEOUT(m_cameras[1]->frames > 40 && m_cameras[0]->frames > 40, 20000);
    const std::uint64_t sent = m_cameras[1]->frames;
    QTRY_VERIFY(m_cameras[1]->frames > sent + 30);
    m_cameras[1].reset();
    const Nanoseconds pulled = steadyNow();
    QTRY_VERIFY(steadyNow() - pulled > 1500ms);
    plugIn(1);
    const ProgramRun recorded = recording.get();
    QVERIFY2(recorded.exitStatus == 0, recorded.err.constData());
    QVERIFY2(recorded.err.contains("it does not answer"), recorded.err.constData()); // it is told, and why
    const QJsonObject views = recorded.json().value(QStringLiteral("views")).toObject();
    const auto frames = [&](const char *name) {
        return views.value(QLatin1String(name)).toObject().value(QStringLiteral("recorded")).toDouble();
    };
    QVERIFY2(frames("A") > 0.7 * 8 * rate, recorded.out.constData()); // noticed nothing
    QVERIFY2(frames("B") > 0.3 * 8 * rate && frames("B") < frames("A") - 15, recorded.out.constData());
    succeed(QStringLiteral("track %/p.odo gap --json"));
    succeed(QStringLiteral("check %/p.odo"));
}

ODOGRAPH_TEST(TestRecordGige, QCoreApplication)
#include "tst_record_gige.moc"
