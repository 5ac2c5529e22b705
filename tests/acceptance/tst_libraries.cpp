// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"

#include <QFileInfo>
#include <QProcess>
#include <QTest>

/// OpenCV's highgui and videoio bring Qt 5 and some 245 shared libraries into a Qt 6 program; imgcodecs
/// brings GDAL, and with it 75 libraries for which each start took three times as long.
class TestLibraries : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void programLoadsOnlyWhatItUses();
};

void TestLibraries::programLoadsOnlyWhatItUses()
{
    const QString program = qEnvironmentVariable("ODOGRAPH_PROGRAM");
    QVERIFY2(QFileInfo(program).isExecutable(), qPrintable(program));
    QProcess ldd;
    ldd.start(QStringLiteral("ldd"), {program});
    QVERIFY(ldd.waitForFinished());
    QCOMPARE(ldd.exitCode(), 0);
    const QString libraries = QString::fromUtf8(ldd.readAllStandardOutput());
    QVERIFY(libraries.contains(QStringLiteral("libQt6Core.so")));
    QVERIFY(libraries.contains(QStringLiteral("libopencv_core.so")));
    QVERIFY(!libraries.contains(QStringLiteral("not found")));
    for (const QString &unwanted :
         {QStringLiteral("libQt5"), QStringLiteral("opencv_highgui"), QStringLiteral("opencv_videoio"),
          QStringLiteral("opencv_imgcodecs"), QStringLiteral("libgdal")})
        QVERIFY2(!libraries.contains(unwanted), qPrintable(unwanted));
}

ODOGRAPH_TEST(TestLibraries, QCoreApplication)
#include "tst_libraries.moc"
