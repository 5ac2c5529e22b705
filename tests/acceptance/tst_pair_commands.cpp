// SPDX-License-Identifier: GPL-3.0-or-later
// `locate` and `calibrate-pair` by the command line alone: two cameras 160 mm apart, of known lens and pose.
#include "core/exchange/calibration_file.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QJsonArray>
#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using namespace odo::test;

class TestPairCommands : public QObject, CallingTest
{
    Q_OBJECT

    const MarkerLayout m_layout{"floor",
                                {{"O", {0, 0}},
                                 {"U", {2.4, 0}},
                                 {"V", {0, 1.6}},
                                 {"D", {2.4, 1.6}},
                                 {"E", {1.1, 0.5}},
                                 {"F", {1.7, 1.2}}}};
    static Intrinsics lens(double focalPx, double centrePx)
    {
        return {640, 360, focalPx, focalPx + 1, centrePx, 178, LensModel::Standard, {-0.1, 0.02, 0, 0}, {}};
    }
    const CameraModel m_a = CameraModel::create(lens(560, 322)).value();
    const CameraModel m_b = CameraModel::create(lens(548, 317)).value();
    const RigidTransform m_bFromA{
        Eigen::Quaterniond(Eigen::AngleAxisd(0.12, Eigen::Vector3d(0.1, 1, 0).normalized())),
        {-0.158, 0.01, 0.024}};
    const RigidTransform m_worldFromA =
        simulatedView({1.1, -1.9, 1.7}, {1.2, 0.7, 0}, 640, 360, 560).worldFromCamera();

    void draw(const CameraModel &camera, const RigidTransform &cameraFromBoard, const QString &name,
              unsigned seed) const
    {
        SimulatedBoard board;
        board.cameraFromBoard = cameraFromBoard;
        const auto written =
            writeImage(renderBoard(camera, board, 1, seed), path(qPrintable(name)).toStdString());
        QVERIFY2(written.has_value(), written ? "" : written.error().message().c_str());
    }
    FloorView view(const CameraModel &camera, const RigidTransform &worldFromCamera) const
    {
        return FloorView(camera, worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    }
    /// label,u,v of points of the floor, as a camera sees them with a little noise.
    void writePixels(const char *name, const FloorView &view, const MarkerLayout &points, double heightM,
                     double noisePx) const
    {
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 1);
        QByteArray text = "label,u,v\n";
        for (const Marker &marker : points.markers) {
            const auto pixel =
                view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), heightM});
            QVERIFY(pixel.has_value());
            text += QByteArray::fromStdString(marker.label) + ',' +
                    QByteArray::number(pixel->x() + noisePx * noise(random), 'f', 4) + ',' +
                    QByteArray::number(pixel->y() + noisePx * noise(random), 'f', 4) + '\n';
        }
        write(name, text);
    }
    QByteArray read(const char *name) const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static double number(const QJsonObject &object, const char *name)
    {
        return object.value(QLatin1String(name)).toDouble(1e9);
    }

private Q_SLOTS:
    void initTestCase()
    {
        QByteArray csv = "label,x_mm,y_mm\n";
        for (const Marker &marker : m_layout.markers)
            csv += QByteArray::fromStdString(marker.label) + ',' +
                   QByteArray::number(1e3 * marker.pointInWorld.x()) + ',' +
                   QByteArray::number(1e3 * marker.pointInWorld.y()) + '\n';
        write("layout.csv", csv);
        writePixels("pixels.csv", view(m_a, m_worldFromA), m_layout, 0, 0.15);
        QVERIFY(writeIntrinsics(path("a.yaml").toStdString(), "A", m_a.intrinsics()));
        QCOMPARE(good("new %P").exitStatus, 0);
        QCOMPARE(good("layout add %P floor %/layout.csv").exitStatus, 0);
        QCOMPARE(good("camera add %P A").exitStatus, 0);
        int drawn = 0;
        for (const RigidTransform &pose : heldBoardPoses(m_a, SimulatedBoard(), 24, 5)) {
            // Those that B sees as well.
            const RigidTransform byB = m_bFromA * pose;
            bool isSeen = true;
            for (const double x : {-0.05, 0.25})
                for (const double y : {-0.05, 0.175}) {
                    const auto pixel = m_b.project(byB * Eigen::Vector3d(x, y, 0));
                    isSeen = isSeen && pixel && pixel->x() > 5 && pixel->x() < 634 && pixel->y() > 5 &&
                             pixel->y() < 354;
                }
            if (!isSeen)
                continue;
            ++drawn;
            draw(m_a, pose, QStringLiteral("left%1.png").arg(drawn), unsigned(drawn));
            draw(m_b, byB, QStringLiteral("right%1.png").arg(drawn), unsigned(100 + drawn));
        }
        qInfo("%d pairs", drawn);
        QVERIFY(drawn >= 8);
        m_count = drawn;
    }

    QString files(const char *side) const
    {
        QStringList names;
        for (int i = 1; i <= m_count; ++i)
            names << QStringLiteral("%/%1%2.png").arg(QLatin1String(side)).arg(i);
        return names.join(u' ');
    }

    void locatesNothingUnregistered()
    {
        const ProgramRun run = this->run("locate %P A --pixels %/pixels.csv");
        QCOMPARE(run.exitStatus, 1);
        QVERIFY2(run.err.contains("camera 'A': it is not registered to the floor; register it first"),
                 run.err);
    }

    void findsTheRelationAndCalibratesBoth()
    {
        const ProgramRun run = this->run(QStringLiteral("calibrate-pair %P A B --square 25mm --a ") +
                                         files("left") + QStringLiteral(" --json --b ") + files("right"));
        QVERIFY2(run.exitStatus == 0, run.err);
        const QJsonObject json = run.json();
        const double baseline = number(json, "baseline_mm"), sigma = number(json, "sigma_mm");
        const double truth = 1e3 * m_bFromA.translation.norm();
        qInfo("%.2f ± %.2f mm, truly %.2f mm; RMS %.3f px", baseline, sigma, truth, number(json, "rms_px"));
        QVERIFY(std::abs(baseline - truth) < 3.5 * sigma && sigma < 2);
        QVERIFY(number(json, "rms_px") < 0.25);
        QCOMPARE(json.value(QStringLiteral("pairs_used")).toInt(), m_count);
        const QJsonObject square = json.value(QStringLiteral("square_mm")).toObject();
        QVERIFY(std::abs(number(square, "mean") - 25) < 0.1 && number(square, "sd") < 1);
        QCOMPARE(json.value(QStringLiteral("calibrated")).toArray().size(), 2);
        QVERIFY(!json.contains(QStringLiteral("registered")));
        for (const char *line : {"revisions %P A --json", "revisions %P B --json"})
            QCOMPARE(good(line).json().value(QStringLiteral("revisions")).toArray().size(), 1);
    }

    void aMissingImageShiftsNothing()
    {
        QString left = files("left"), right = files("right");
        left.remove(QStringLiteral("%/left3.png "));
        right.remove(QStringLiteral("%/right5.png "));
        const ProgramRun run = this->run(QStringLiteral("calibrate-pair %P A B --a ") + left +
                                         QStringLiteral(" --b ") + right + QStringLiteral(" --json"));
        QVERIFY2(run.exitStatus == 0, run.err);
        QCOMPARE(run.json().value(QStringLiteral("pairs_used")).toInt(), m_count - 2);
        const QJsonArray rejected = run.json().value(QStringLiteral("pairs_rejected")).toArray();
        QCOMPARE(rejected.size(), 2);
        QCOMPARE(rejected[0].toObject().value(QStringLiteral("a")).toString(), QStringLiteral("left5.png"));
        QCOMPARE(rejected[1].toObject().value(QStringLiteral("b")).toString(), QStringLiteral("right3.png"));
        QCOMPARE(rejected[0].toObject().value(QStringLiteral("reason")).toString(),
                 QStringLiteral("the other camera has no file of its number"));
        QCOMPARE(run.json().value(QStringLiteral("calibrated")).toArray().size(), 0); // they have intrinsics
    }

    void theOtherCameraJoinsTheFloor()
    {
        QCOMPARE(good("register %P --camera A --layout floor --pixels %/pixels.csv").exitStatus, 0);
        const QString call = QStringLiteral("calibrate-pair %P A B --a ") + files("left") +
                             QStringLiteral(" --b ") + files("right") + QStringLiteral(" --json");
        const ProgramRun run = this->run(call);
        QVERIFY2(run.exitStatus == 0, run.err);
        const QJsonObject registered = run.json().value(QStringLiteral("registered")).toObject();
        QCOMPARE(registered.value(QStringLiteral("camera")).toString(), QStringLiteral("B"));
        QCOMPARE(registered.value(QStringLiteral("through")).toString(), QStringLiteral("A"));
        QCOMPARE(registered.value(QStringLiteral("layout")).toString(), QStringLiteral("B through A"));
        // What B then says of the floor holds, within its σ.
        writePixels("by_b.csv", view(m_b, m_worldFromA * m_bFromA.inverse()), m_layout, 0, 0);
        const ProgramRun located = this->run("locate %P B --pixels %/by_b.csv --json");
        QVERIFY2(located.exitStatus == 0, located.err);
        for (const QJsonValue &value : located.json().value(QStringLiteral("points")).toArray()) {
            const QJsonObject point = value.toObject();
            for (const Marker &marker : m_layout.markers) {
                if (QString::fromStdString(marker.label) != point.value(QStringLiteral("label")).toString())
                    continue;
                const double dx = number(point, "x_mm") - 1e3 * marker.pointInWorld.x(),
                             dy = number(point, "y_mm") - 1e3 * marker.pointInWorld.y();
                QVERIFY2(std::abs(dx) < 4 * number(point, "sigma_x_mm") &&
                             std::abs(dy) < 4 * number(point, "sigma_y_mm"),
                         qPrintable(QStringLiteral("%1: %2 %3")
                                        .arg(QString::fromStdString(marker.label))
                                        .arg(dx)
                                        .arg(dy)));
                QVERIFY(number(point, "sigma_x_mm") < 60);
            }
        }
        // Now both are registered: they agree with the pair.
        const QJsonObject difference =
            this->run(call).json().value(QStringLiteral("registrations_differ")).toObject();
        QVERIFY(number(difference, "distance_mm") < 1);
        QCOMPARE(difference.value(QStringLiteral("significant")).toBool(true), false);
    }

    void locatesOnTheFloorAndAboveIt_data()
    {
        QTest::addColumn<double>("heightM");
        QTest::newRow("floor") << 0.0;
        QTest::newRow("0.25 m up") << 0.25;
    }
    void locatesOnTheFloorAndAboveIt()
    {
        QFETCH(double, heightM);
        const MarkerLayout points{"", {{"p", {0.4, 0.3}}, {"q, 2", {1.9, 1.1}}, {"r", {1.2, 0.9}}}};
        writePixels("points.csv", view(m_a, m_worldFromA), points, heightM, 0);
        QByteArray text = read("points.csv");
        text.replace("q, 2", "\"q, 2\"").append("sky,320,-900\n");
        write("points.csv", text);
        const QByteArray height = QByteArray::number(1e3 * heightM);
        const QString call = QStringLiteral("locate %P A --pixels %/points.csv --height ") +
                             QString::fromLatin1(height) + QStringLiteral("mm");
        const ProgramRun run = this->run(call + QStringLiteral(" --json"));
        QVERIFY2(run.exitStatus == 0, run.err);
        QCOMPARE(run.json().value(QStringLiteral("camera")).toString(), QStringLiteral("A"));
        QCOMPARE(run.json().value(QStringLiteral("registration")).toInt(), 1);
        const QJsonArray located = run.json().value(QStringLiteral("points")).toArray();
        QCOMPARE(located.size(), 4);
        for (int i = 0; i < 3; ++i) {
            const QJsonObject point = located[i].toObject();
            const Eigen::Vector2d &truth = points.markers[std::size_t(i)].pointInWorld;
            QVERIFY(std::abs(number(point, "x_mm") - 1e3 * truth.x()) < 4 * number(point, "sigma_x_mm"));
            QVERIFY(std::abs(number(point, "y_mm") - 1e3 * truth.y()) < 4 * number(point, "sigma_y_mm"));
            QVERIFY(number(point, "sigma_x_mm") > 0.3 && number(point, "sigma_x_mm") < 30);
        }
        const QJsonObject sky = located[3].toObject();
        for (const char *name : {"x_mm", "y_mm", "sigma_x_mm", "sigma_y_mm"})
            QVERIFY(sky.value(QLatin1String(name)).isNull());
        // The table says the same, on standard output and in a file.
        const ProgramRun printed = this->run(call);
        QCOMPARE(printed.exitStatus, 0);
        QVERIFY(printed.out.startsWith("label,u,v,x_mm,y_mm,sigma_x_mm,sigma_y_mm\np,"));
        QVERIFY(printed.out.contains("\n\"q, 2\",") && printed.out.endsWith("\nsky,320,-900,,,,\n"));
        QVERIFY2(printed.err.contains("outside the image of 640×360: sky"), printed.err);
        QCOMPARE(this->run(call + QStringLiteral(" -o %/out.csv")).exitStatus, 0);
        QCOMPARE(read("out.csv"), printed.out);
        QFile::remove(path("out.csv"));
    }

    void badCallsFailInOneLine_data()
    {
        beginBadCalls();
        const auto row = addBadCall;
        row("locate %P A", 2, "--pixels is missing");
        row("locate %P C --pixels %/pixels.csv", 1, "C");
        row("locate %P A --pixels %/nofile.csv", 1, "nofile.csv");
        row("locate %P A --pixels %/layout.csv", 1, "label,u,v");
        row("locate %P A --pixels %/pixels.csv --height -5mm", 2, "not a length from 0 to 1 km");
        row("locate %P A --pixels %/pixels.csv --height 5m", 1, "give a height below the camera");
        row("locate %P A --pixels %/pixels.csv -o %/pixels.csv", 2, "pixels.csv");
        row("locate %P A --pixels %/pixels.csv -o %P", 2, "class.odo");
        row("locate %P A --pixels %/pixels.csv --json -o -", 2, "-o - and --json");
        row("calibrate-pair %P A B --a %/left1.png", 2, "--b is missing");
        row("calibrate-pair %P A --a %/left1.png --b %/right1.png", 2, "an argument is missing");
        row("calibrate-pair %P A A --a %/left1.png --b %/right1.png", 1, "both are the same camera");
        row("calibrate-pair %P A B --a %/left1.png --b %/left1.png", 1, "'left1.png' is given twice");
        row("calibrate-pair %P A B --a %/left1.png --b %/right1.png %/layout.csv", 1,
            "1 files of the first camera cannot be paired with 2");
        row("calibrate-pair %P A B --a %/left1.png --b %/right1.png", 1,
            "the board looks the same when turned by half");
        row("calibrate-pair %P A B --a %/left1.png --b %/nofile1.png", 1, "nofile1.png");
        row("calibrate-pair %P A B --board 2x2 --a %/left1.png --b %/right1.png", 2, "--board counts");
        row("calibrate-pair %P A B --a %/layout.csv --b %/pixels.csv", 1, "none of 0 pairs can be used");
    }
    void badCallsFailInOneLine() { badCallFailsInOneLine(); }

private:
    int m_count = 0;
};

ODOGRAPH_TEST(TestPairCommands, QCoreApplication)
#include "tst_pair_commands.moc"
