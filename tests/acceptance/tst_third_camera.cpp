// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

/// Camera C sees no marker, only floor that B sees as well; B sees the markers. C alone tracks the robot to
/// where it is, within what it states.
class TestThirdCamera : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    SimulatedScene m_scene = demoTestbed(5);
    std::mt19937 m_random{11};

    QString path(const QString &name) const { return m_folder.filePath(name); }

    bool call(const QString &line, const char *refusal = nullptr) const
    {
        QStringList arguments = line.split(u' ', Qt::SkipEmptyParts);
        arguments.replaceInStrings(QStringLiteral("%/"), m_folder.path() + u'/');
        const ProgramRun run = runProgram(arguments);
        const bool asWanted =
            refusal ? run.exitStatus != 0 && run.err.contains(refusal) && run.err.count('\n') == 1
                    : run.exitStatus == 0;
        if (!asWanted)
            qWarning("%s: %s", qPrintable(line), run.err.constData());
        else if (line.startsWith(QStringLiteral("register")))
            qInfo("%s", refusal ? run.err.constData() : run.out.constData());
        return asWanted;
    }

    void write(const QString &name, const QByteArray &text) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }

    QByteArray pixel(int camera, const Vector2d &place)
    {
        std::normal_distribution<double> noise(0, 0.3);
        const Vector2d at =
            *m_scene.cameras[std::size_t(camera)].view.pixelFromWorld({place.x(), place.y(), 0});
        return ',' + QByteArray::number(at.x() + noise(m_random)) + ',' +
               QByteArray::number(at.y() + noise(m_random));
    }

    void writePoints()
    {
        QByteArray markers = "label,u,v\n", pairs = "label,u,v,through_u,through_v\n";
        for (const Marker &marker : m_scene.floor.markers.markers)
            markers += QByteArray::fromStdString(marker.label) + pixel(1, marker.pointInWorld) + '\n';
        const Vector2d corners[] = {{0.5, 0.5}, {2.5, 0.5}, {0.5, 2.0}, {2.5, 2.0}, {1.5, 1.0}, {1.0, 1.5}};
        char label = 'a';
        for (const Vector2d &corner : corners)
            pairs += label++ + pixel(2, corner) + pixel(1, corner) + '\n';
        write(QStringLiteral("markers.csv"), markers);
        write(QStringLiteral("pairs.csv"), pairs);
        write(QStringLiteral("three.csv"), pairs.left(pairs.indexOf("\nd") + 1));
        write(QStringLiteral("double.csv"), QByteArray(pairs).replace("\nb", "\na"));
    }

private Q_SLOTS:
    void aCameraThroughAnotherMeasuresTheSame();
};

void TestThirdCamera::aCameraThroughAnotherMeasuresTheSame()
{
    m_scene.durationS = 3;
    SimulatedCamera third = m_scene.cameras[1];
    third.name = 'C';
    third.startOffsetS = 0;
    third.view = simulatedView({1.6, 4.2, 2.0}, {1.5, 1.2, 0}, 1280, 720, 900);
    m_scene.cameras.push_back(third);
    SimulatedRobot robot;
    robot.name = "red";
    robot.colour = *parseColour("#d72328");
    robot.motion = makeCircleMotion({1.5, 1.2}, 0.45, 0.7, 0.5);
    m_scene.robots.push_back(robot);
    QVERIFY(renderVideo(m_scene, 2, path(QStringLiteral("c.mkv")).toStdString(), {}, {}).has_value());
    for (int i = 1; i < 3; ++i) {
        const SimulatedCamera &camera = m_scene.cameras[std::size_t(i)];
        QVERIFY(
            writeIntrinsics(path(i == 1 ? QStringLiteral("B.yaml") : QStringLiteral("C.yaml")).toStdString(),
                            camera.name, camera.view.camera().intrinsics()));
    }
    QByteArray layout = "label,x_mm,y_mm\n";
    for (const Marker &marker : m_scene.floor.markers.markers)
        layout += QByteArray::fromStdString(marker.label) + ',' +
                  QByteArray::number(1000 * marker.pointInWorld.x()) + ',' +
                  QByteArray::number(1000 * marker.pointInWorld.y()) + '\n';
    write(QStringLiteral("layout.csv"), layout);
    writePoints();

    const auto s = [](const char *text) { return QString::fromLatin1(text); };
    QVERIFY(call(s("new %/t.odo")));
    QVERIFY(call(s("robot add %/t.odo red --colour #d72328 --height 60mm --size 260x190")));
    QVERIFY(call(s("intrinsics import %/t.odo B %/B.yaml")) &&
            call(s("intrinsics import %/t.odo C %/C.yaml")));
    QVERIFY(call(s("layout add %/t.odo floor %/layout.csv")));
    const QString registerC = s("register %/t.odo --camera C --through ");
    QVERIFY(call(registerC + s("B --pixels %/pairs.csv"), "camera 'B' is not registered; register it first"));
    QVERIFY(call(s("register %/t.odo --camera B --layout floor --pixels %/markers.csv")));
    QVERIFY(call(registerC + s("C --pixels %/pairs.csv"), "via itself"));
    QVERIFY(call(registerC + s("X --pixels %/pairs.csv"), "'X'"));
    QVERIFY(call(registerC + s("B --pixels %/three.csv"), "the same four points"));
    QVERIFY(call(registerC + s("B --pixels %/double.csv"), "line 2 already has the label 'a'"));
    QVERIFY(call(registerC + s("B --pixels %/pairs.csv --layout floor"), "cannot be used together"));
    QVERIFY(call(registerC + s("B --pixels %/pairs.csv --json")));
    // Again, as after picking better points: the first layout stays.
    QVERIFY(call(registerC + s("B --pixels %/pairs.csv --json")));

    QVERIFY(call(s("import %/t.odo --trial run --video C=%/c.mkv --robot red --sync none")));
    QVERIFY(call(s("track %/t.odo run --json")) && call(s("export %/t.odo run -o %/track.csv")));
    QFile csv(path(s("track.csv")));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> names = csv.readLine().trimmed().split(',');
    const auto at = [&](const char *name) { return int(names.indexOf(name)); };
    int rows = 0, inside = 0;
    double squares = 0;
    while (!csv.atEnd()) {
        const QList<QByteArray> cells = csv.readLine().trimmed().split(',');
        const auto number = [&](const char *name) { return cells.value(at(name)).toDouble(); };
        const Vector2d truth =
            1000 * robot.motion->at(frameSceneTime(m_scene, 2, 0) + number("t_s")).position;
        const Vector2d error = Vector2d(number("x_mm"), number("y_mm")) - truth;
        squares += error.squaredNorm();
        inside +=
            std::abs(error.x()) < 3 * number("sigma_x_mm") && std::abs(error.y()) < 3 * number("sigma_y_mm");
        ++rows;
    }
    QVERIFY(rows >= 88);
    const double rmsMm = std::sqrt(squares / rows);
    qInfo("RMS %.2f mm, within 3 sigma %d of %d", rmsMm, inside, rows);
    QVERIFY(rmsMm < 8);
    QVERIFY(inside >= 0.95 * rows);
}

ODOGRAPH_TEST(TestThirdCamera, QCoreApplication)
#include "tst_third_camera.moc"
