// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "tests/support/calling_test.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;

/// Layouts, registration by rings, all cameras together, and the alarm, by the command line alone.
class TestFloorCommands : public QObject, CallingTest
{
    Q_OBJECT

    QByteArray read(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void draw(const SimulatedScene &scene, int camera, const char *name) const
    {
        const auto written = writeImage(SceneRenderer(scene, camera).render(0), path(name).toStdString());
        QVERIFY2(written.has_value(), written ? "" : written.error().message().c_str());
    }

    static constexpr const char *layoutCsv =
        "label,x_mm,y_mm\nO,0,0\nU,3000.3,0\nV,-0.1,2200\nD,3000,2200.7\nE,1100,700\n";

private Q_SLOTS:
    void initTestCase()
    {
        SimulatedScene scene = demoTestbed(3);
        scene.durationS = 0.1;
        scene.floor.markers = {"floor",
                               {{"O", {0, 0}},
                                {"U", {3.0003, 0}},
                                {"V", {-0.0001, 2.2}},
                                {"D", {3, 2.2007}},
                                {"E", {1.1, 0.7}}}};
        scene.floor.markerShape = MarkerShape::Ring;
        draw(scene, 0, "a.png");
        draw(scene, 1, "b.png");
        for (int camera : {0, 1}) {
            const auto written = writeIntrinsics(
                path(camera == 0 ? "a.yaml" : "b.yaml").toStdString(), camera == 0 ? "A" : "B",
                scene.cameras[std::size_t(camera)].view.camera().intrinsics());
            QVERIFY(written.has_value());
        }
        SimulatedScene bumped = scene;
        const FloorView &view = bumped.cameras[1].view;
        RigidTransform turned = view.worldFromCamera();
        turned.rotation =
            Eigen::Quaterniond(Eigen::AngleAxisd(0.006, Eigen::Vector3d::UnitZ())) * turned.rotation;
        bumped.cameras[1].view = FloorView(view.camera(), turned, view.poseCovariance());
        draw(bumped, 1, "bumped.png");
        SimulatedScene kicked = scene;
        kicked.floor.markers.markers[4].pointInWorld.x() += 0.03;
        draw(kicked, 1, "kicked.png");
        write("layout.csv", layoutCsv);
        QCOMPARE(run("new %P").exitStatus, 0);
        QCOMPARE(run("layout add %P floor %/layout.csv").exitStatus, 0);
        QCOMPARE(run("intrinsics import %P A %/a.yaml").exitStatus, 0);
        QCOMPARE(run("intrinsics import %P B %/b.yaml").exitStatus, 0);
    }
    void aLayoutComesOutAsItWentIn()
    {
        QCOMPARE(run("layout export %P floor %/out.csv").exitStatus, 0);
        QCOMPARE(read("out.csv"), QByteArray(layoutCsv));
    }
    void registersByRingsAndListsThem()
    {
        for (const char *line : {"register %P --camera A --layout floor --image %/a.png --json",
                                 "register %P --camera B --layout floor --image %/b.png --json"}) {
            const ProgramRun registered = run(line);
            QVERIFY2(registered.exitStatus == 0, registered.err);
            QVERIFY(registered.json().value(QStringLiteral("rms_px")).toDouble() < 0.2);
            QCOMPARE(registered.json().value(QStringLiteral("markers")).toArray().size(), 5);
        }
        const QJsonArray layouts =
            run("layout list %P --json").json().value(QStringLiteral("layouts")).toArray();
        QCOMPARE(layouts.size(), 1);
        QCOMPARE(layouts[0].toObject().value(QStringLiteral("cameras")).toArray().size(), 2);
        QCOMPARE(run("layout show %P floor --json").json().value(QStringLiteral("markers")).toArray().size(),
                 5);
    }
    /// The largest size that is read, without a board or markers.
    void aLargeImageTakesLittleMemory()
    {
        constexpr int width = 8000, height = 6200;
        write("large.pgm", "P5 8000 6200 255\n" + QByteArray(qsizetype{width} * height, '\x80'));
        for (const char *line :
             {"calibrate %P C %/large.pgm", "register %P --camera C --layout floor --image %/large.pgm"}) {
            const MeasuredRun run = runMeasured(filled(QString::fromLatin1(line)));
            QCOMPARE(run.exitStatus, 1);
            QVERIFY2(run.megabytes < 500 || slowness > 1, qPrintable(QString::number(run.megabytes)));
            QVERIFY2(run.seconds < 20 * slowness, qPrintable(QString::number(run.seconds))); // 10 alone
        }
        QFile::remove(path("large.pgm"));
    }
    void allCamerasTogether()
    {
        const ProgramRun joint = run("register %P --joint --layout floor --tape 1mm --json");
        QVERIFY2(joint.exitStatus == 0, joint.err);
        QCOMPARE(joint.json().value(QStringLiteral("cameras")).toArray().size(), 2);
        QCOMPARE(joint.json().value(QStringLiteral("markers")).toArray().size(), 5);
        QVERIFY(joint.json().value(QStringLiteral("verdict")).toString().contains(QStringLiteral("agree")));
    }
    void theAlarmTellsACameraFromAMarker()
    {
        const ProgramRun still = run("moved %P --camera B --image %/b.png --json");
        QVERIFY2(still.exitStatus == 0, still.err);
        QCOMPARE(still.json().value(QStringLiteral("moved")).toString(), QStringLiteral("nothing"));
        const ProgramRun bumped = run("moved %P --camera B --image %/bumped.png --json");
        QCOMPARE(bumped.exitStatus, 1);
        QCOMPARE(bumped.json().value(QStringLiteral("moved")).toString(), QStringLiteral("camera"));
        const ProgramRun kicked = run("moved %P --camera B --image %/kicked.png --json");
        QCOMPARE(kicked.exitStatus, 1);
        QCOMPARE(kicked.json().value(QStringLiteral("moved")).toString(), QStringLiteral("markers"));
        QVERIFY(kicked.json()
                    .value(QStringLiteral("verdict"))
                    .toString()
                    .contains(QStringLiteral("Marker E has moved")));
    }
    void anOlderRegistrationIsUsedAgain()
    {
        // The first registration is put in force again, and the list says so.
        const QJsonArray revisions =
            run("revisions %P B --json").json().value(QStringLiteral("revisions")).toArray();
        QVERIFY(revisions.size() >= 2);
        const QJsonObject oldest = revisions.last().toObject();
        QCOMPARE(oldest.value(QStringLiteral("kind")).toString(), QStringLiteral("registration"));
        const QByteArray use = "revisions %P B --json --use registration:" +
                               QByteArray::number(oldest.value(QStringLiteral("id")).toInt());
        const ProgramRun chosen = run(use.constData());
        QVERIFY2(chosen.exitStatus == 0, chosen.err);
        QVERIFY(chosen.json()
                    .value(QStringLiteral("revisions"))
                    .toArray()
                    .last()
                    .toObject()
                    .value(QStringLiteral("in_force"))
                    .toBool());
        QCOMPARE(run("revisions %P B --use registration:99").exitStatus, 1);
        QCOMPARE(run("revisions %P B --use 7").exitStatus, 2);
        QCOMPARE(run("reprocess %P nothing").exitStatus, 1);
        const ProgramRun same = run("register %P --camera B --again");
        QCOMPARE(same.exitStatus, 1);
        QVERIFY2(same.err.contains("it already uses that calibration"), same.err);
        QCOMPARE(run("register %P --camera B --again --joint --layout floor").exitStatus, 2);
        const QByteArray back =
            "revisions %P B --use registration:" +
            QByteArray::number(revisions.first().toObject().value(QStringLiteral("id")).toInt());
        QCOMPARE(run(back.constData()).exitStatus, 0);
    }
    void theAxesMoveWithTheCameras()
    {
        write(
            "task.json",
            R"({"template": "free", "gates": [{"name": "start", "role": "start", "from_mm": [0, 0], "to_mm": [0, 500]}]})");
        QCOMPARE(run("task add %P dash %/task.json").exitStatus, 0);
        const ProgramRun moved = run("layout transform %P floor --origin U --turn 90 --json");
        QVERIFY2(moved.exitStatus == 0, moved.err);
        QCOMPARE(moved.json().value(QStringLiteral("tasks")).toArray(),
                 QJsonArray{QStringLiteral("dash")}); // there is no other floor
        QCOMPARE(moved.json().value(QStringLiteral("cameras")).toArray().size(), 2);
        const QJsonObject second = moved.json().value(QStringLiteral("markers")).toArray()[1].toObject();
        QVERIFY(std::abs(second.value(QStringLiteral("x_mm")).toDouble()) < 1e-6);
        // What was carried along is still true: the markers lie where the camera has them.
        QCOMPARE(run("moved %P --camera B --image %/b.png --json").exitStatus, 0);
        const ProgramRun joint = run("register %P --joint --layout floor --json");
        QVERIFY2(joint.exitStatus == 0, joint.err);
        QVERIFY(joint.json().value(QStringLiteral("rms_px")).toDouble() < 0.2);
    }
    void aHintTellsWhichMarkerIsWhich()
    {
        // Four rings of a rectangle look the same turned by a half turn.
        write("four.csv", "label,x_mm,y_mm\nO,0,0\nU,3000,0\nV,0,2200\nD,3000,2200\n");
        SimulatedScene scene = demoTestbed(4);
        scene.floor.markerShape = MarkerShape::Ring;
        draw(scene, 0, "four.png");
        QCOMPARE(run("layout add %P four %/four.csv").exitStatus, 0);
        const ProgramRun asked = run("register %P --camera A --layout four --image %/four.png");
        QCOMPARE(asked.exitStatus, 1);
        QVERIFY2(asked.err.contains("--hint") || asked.err.contains("by hand"), asked.err);
        const Eigen::Vector2d o = *scene.cameras[0].view.pixelFromWorld({0, 0, 0});
        const QByteArray hinted = "register %P --camera A --layout four --image %/four.png --json --hint O=" +
                                  QByteArray::number(std::round(o.x())) + ',' +
                                  QByteArray::number(std::round(o.y()));
        const ProgramRun told = run(hinted.constData());
        QVERIFY2(told.exitStatus == 0, told.err);
        const QJsonArray place = told.json().value(QStringLiteral("camera_position_m")).toArray();
        const Eigen::Vector3d truth = scene.cameras[0].view.cameraInWorld();
        for (int axis = 0; axis < 3; ++axis)
            QVERIFY(std::abs(place[axis].toDouble() - truth[axis]) < 0.02);
    }
    void badCallsFailInOneLine_data()
    {
        beginBadCalls();
        const auto row = addBadCall;
        row("layout drop %P", 2, "'drop' is not known");
        row("layout show %P", 2, "'show' takes 2 arguments");
        row("layout show %P nowhere", 1, "nowhere");
        row("layout transform %P floor --reverse x", 1, "reversing X alone would mirror the floor");
        row("layout transform %P floor --reverse z", 2, "--reverse takes x, y or xy");
        row("layout transform %P floor --origin Q", 1, "it has no marker Q; name one of O, U, V, D and E");
        row("layout transform %P floor --unit ell", 1, "use mm, cm, m or inch");
        row("layout transform %P floor --x-axis O", 2, "takes two");
        row("register %P --joint", 2, "--joint needs --layout");
        row("register %P --joint --layout floor --camera A", 2, "cannot be used together");
        row("register %P --joint --layout floor --tape 0mm", 2, "--tape");
        row("register %P --camera A --layout floor --image %/a.png --hint O=5", 2, "--hint takes LABEL=U,V");
        row("moved %P --camera B", 2, "--camera and --image are needed");
        row("moved %P --camera C --image %/b.png", 1, "C");
        row("moved %P --camera B --image %/nofile.png", 1, "nofile.png");
    }
    void badCallsFailInOneLine() { badCallFailsInOneLine(); }
};

ODOGRAPH_TEST(TestFloorCommands, QCoreApplication)
#include "tst_floor_commands.moc"
