// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QProcess>
#include <QTest>
#include <csignal>

using namespace odo;
using namespace odo::test;

/// `certificate` as scripts call it, of a set-up that was registered by pixels alone.
class TestCertificateCommand : public QObject, CallingTest
{
    Q_OBJECT

    void registerCamera(const char *name, const FloorView &view) const
    {
        QByteArray pixels = "label,u,v\n";
        for (const Marker &marker : demoTestbed(1).floor.markers.markers) {
            const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
            pixels += QByteArray::fromStdString(marker.label) + ',' + QByteArray::number(pixel->x(), 'f', 3) +
                      ',' + QByteArray::number(pixel->y(), 'f', 3) + '\n';
        }
        write("pixels.csv", pixels);
        QVERIFY(writeIntrinsics(path("camera.yaml").toStdString(), name, view.camera().intrinsics()));
        good(qPrintable(QStringLiteral("intrinsics import %P %1 %/camera.yaml").arg(QLatin1String(name))));
        good(qPrintable(QStringLiteral("register %P --camera %1 --layout floor --pixels %/pixels.csv")
                            .arg(QLatin1String(name))));
    }
    static FloorView viewFrom(const Eigen::Vector3d &position)
    {
        return simulatedView(position, {1.5, 0.75, 0}, 640, 360, 480);
    }
    static bool isPdf(const QString &file)
    {
        QFile pdf(file);
        return pdf.open(QIODevice::ReadOnly) && pdf.read(5) == "%PDF-" &&
               pdf.readAll().trimmed().endsWith("%%EOF");
    }

private Q_SLOTS:
    void initTestCase()
    {
        good("new %P --title Hall");
        write("layout.csv", "label,x_mm,y_mm\nO,0,0\nU,3000,0\nV,0,2200\nD,3000,2200\n");
        good("layout add %P floor %/layout.csv");
        registerCamera("A", viewFrom({-0.9, -1.55, 2.0}));
        registerCamera("B", viewFrom({3.9, -1.55, 2.0}));
        good("robot add %P Red --colour #d72328 --height 60mm --size 260x190");
    }

    void figuresAndPages()
    {
        const QByteArray before = fileHash(m_project);
        const ProgramRun done = run("certificate %P -o %/certificate.pdf --json");
        QVERIFY2(done.exitStatus == 0, done.err);
        QVERIFY(isPdf(path("certificate.pdf")));
        const QJsonObject json = done.json();
        for (const char *key : {"mm", "mm_s", "mm_s2", "coverage"})
            QVERIFY2(json.value(QLatin1String(key)).isDouble(), key);
        // Half the demo's resolution; see workflow/tst_certificate for the bounds.
        QVERIFY(json.value(QLatin1String("mm")).toDouble() < 8);
        QVERIFY(json.value(QLatin1String("mm_s")).toDouble() < 40);
        QVERIFY(json.value(QLatin1String("coverage")).toDouble() > 0.7);
        QVERIFY(json.value(QLatin1String("coverage")).toDouble() <= 1);
        QCOMPARE(json.value(QLatin1String("position_mm")).toObject().value(QLatin1String("rms")),
                 json.value(QLatin1String("mm")));
        QCOMPARE(json.value(QLatin1String("cameras")).toArray().size(), 2);
        QCOMPARE(json.value(QLatin1String("robot")).toObject().value(QLatin1String("name")).toString(),
                 QStringLiteral("Red"));
        QCOMPARE(json.value(QLatin1String("file")).toString(), path("certificate.pdf"));
        QCOMPARE(fileHash(m_project), before);
        QVERIFY(!QFile::exists(path("class.media")));
    }

    void badCalls_data()
    {
        beginBadCalls();
        addBadCall("certificate %P", 2, "-o is missing");
        addBadCall("certificate %P -o %P", 2, "project");
        addBadCall("certificate %P -o %/layout.csv", 2, "another kind");
        addBadCall("certificate %P -o %/c.pdf --task Circle", 1, "Circle");
        addBadCall("certificate %P -o %/c.pdf --robot Nobody", 1, "Nobody");
        addBadCall("certificate %/none.odo -o %/c.pdf", 1, "none.odo");
    }
    void badCalls() { badCallFailsInOneLine(); }

    void aProjectWithoutCameras()
    {
        good("new %/empty.odo");
        const ProgramRun done = run("certificate %/empty.odo -o %/c.pdf");
        QCOMPARE(done.exitStatus, 1);
        QCOMPARE(done.err, QByteArray("odograph: certificate: no camera is registered to the floor; register "
                                      "the cameras first\n"));
        QVERIFY(!QFile::exists(path("c.pdf")));
    }

    void anInterruptEndsIt()
    {
        const QString temporary = path("temporary");
        QVERIFY(QDir().mkpath(temporary));
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("TMPDIR"), temporary);
        program.setProcessEnvironment(environment);
        program.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                      {QStringLiteral("certificate"), m_project, QStringLiteral("-o"), path("c.pdf")});
        QVERIFY(program.waitForStarted());
        const auto isRendering = [&] {
            return QDirIterator(temporary, {QStringLiteral("*.mkv")}, QDir::Files | QDir::Hidden,
                                QDirIterator::Subdirectories)
                .hasNext();
        };
        QVERIFY(QTest::qWaitFor(isRendering, 60'000));
        ::kill(pid_t(program.processId()), SIGINT);
        QVERIFY(program.waitForFinished(60'000));
        QCOMPARE(program.exitCode(), 130);
        QCOMPARE(program.readAllStandardError(),
                 QByteArray("odograph: certificate: cancelled; nothing was changed\n"));
        QVERIFY(!QFile::exists(path("c.pdf")));
        QCOMPARE(QDir(temporary).entryList({QStringLiteral(".odograph-*")}, QDir::AllEntries | QDir::Hidden),
                 QStringList());
    }
};

ODOGRAPH_TEST(TestCertificateCommand, QCoreApplication)
#include "tst_certificate.moc"
