// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program.h"
#include "tests/support/real_material.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo::test;

/// Real recordings and calibration sets, by the command line. The folder is ODOGRAPH_REAL_DATA or
/// ../shared/data; its README holds the reference figures that are asserted here.
class TestRealMaterial : public QObject
{
    Q_OBJECT

    QString m_data;
    QTemporaryDir m_folder;

    QString project() const { return m_folder.filePath(QStringLiteral("real.odo")); }
    QString data(const char *name) const { return m_data + u'/' + QString::fromLatin1(name); }

    QStringList images(const char *folder, const char *pattern) const
    {
        QStringList files;
        const QDir dir(data(folder));
        for (const QString &name : dir.entryList({QString::fromLatin1(pattern)}, QDir::Files, QDir::Name))
            files << dir.filePath(name);
        return files;
    }

    static ProgramRun good(const QStringList &arguments)
    {
        const ProgramRun run = runProgram(arguments);
        if (run.exitStatus != 0)
            qWarning("%s", run.err.constData());
        return run;
    }

    QJsonObject calibrated(const char *camera, const QStringList &files, const QStringList &options) const
    {
        const QStringList call{QStringLiteral("calibrate"), project(), QString::fromLatin1(camera)};
        return good(call + files + options + QStringList(QStringLiteral("--json"))).json();
    }

private Q_SLOTS:
    void initTestCase()
    {
        ODOGRAPH_NEED_REAL("cap-two-views");
        m_data = QString::fromStdString(realMaterial().string());
        QCOMPARE(good({QStringLiteral("new"), project()}).exitStatus, 0);
    }

    void theStereoChessboardsGiveThePublishedFocalLength()
    {
        const QJsonObject answer = calibrated("left", images("chessboard-stereo", "left*.jpg"),
                                              {QStringLiteral("--square"), QStringLiteral("25mm")});
        const QJsonObject intrinsics = answer.value(QStringLiteral("intrinsics")).toObject();
        QCOMPARE(answer.value(QStringLiteral("images_used")).toInt(), 13);
        QVERIFY(answer.value(QStringLiteral("rms_px")).toDouble(9) <= 0.25);
        QVERIFY(std::abs(intrinsics.value(QStringLiteral("fx")).toDouble() - 533.52) <= 0.83);
    }

    /// Published by an independent implementation: 99.80 ± 0.14 mm (3 σ).
    void theStereoChessboardsGiveThePublishedDistance()
    {
        const QString file = m_folder.filePath(QStringLiteral("pair.odo"));
        QCOMPARE(good({QStringLiteral("new"), file}).exitStatus, 0);
        const QJsonObject answer =
            good(QStringList{QStringLiteral("calibrate-pair"), file, QStringLiteral("L"), QStringLiteral("R"),
                             QStringLiteral("--square"), QStringLiteral("30mm"), QStringLiteral("--json"),
                             QStringLiteral("--a")} +
                 images("chessboard-stereo", "left*.jpg") + QStringList(QStringLiteral("--b")) +
                 images("chessboard-stereo", "right*.jpg"))
                .json();
        const double baseline = answer.value(QStringLiteral("baseline_mm")).toDouble(),
                     sigma = answer.value(QStringLiteral("sigma_mm")).toDouble(9),
                     rms = answer.value(QStringLiteral("rms_px")).toDouble(9);
        qInfo("%.3f ± %.3f mm, RMS %.3f px", baseline, sigma, rms);
        QCOMPARE(answer.value(QStringLiteral("pairs_used")).toInt(), 13);
        QVERIFY(std::abs(baseline - 99.80) <= 0.15);
        QVERIFY(sigma < 0.25);
        QVERIFY(rms <= 0.25);
    }

    /// Hand-held ChArUco boards before webcams, by videos: squares of 54 mm (± 0.2, SD at most 1.1). The
    /// distance in the file (626.4 mm) has no uncertainty; neither have its lens calibrations.
    void theWebcamsTriangulateTheirSquares()
    {
        const QString file = m_folder.filePath(QStringLiteral("webcams.odo"));
        QCOMPARE(good({QStringLiteral("new"), file}).exitStatus, 0);
        for (const char *camera : {"2", "3"})
            QCOMPARE(good({QStringLiteral("intrinsics"), QStringLiteral("import"), file,
                           QString::fromLatin1(camera), data("charuco-four-webcams/camera_array.toml"),
                           QStringLiteral("--entry"), QString::fromLatin1(camera)})
                         .exitStatus,
                     0);
        const QJsonObject answer =
            good({QStringLiteral("calibrate-pair"), file, QStringLiteral("2"), QStringLiteral("3"),
                  QStringLiteral("--square"), QStringLiteral("54mm"), QStringLiteral("--json"),
                  QStringLiteral("--a"), data("charuco-four-webcams/cam_2.mp4"), QStringLiteral("--b"),
                  data("charuco-four-webcams/cam_3.mp4")})
                .json();
        const QJsonObject square = answer.value(QStringLiteral("square_mm")).toObject();
        const double baseline = answer.value(QStringLiteral("baseline_mm")).toDouble(),
                     sigma = answer.value(QStringLiteral("sigma_mm")).toDouble(999);
        qInfo("%.1f ± %.1f mm, squares %.2f ± %.2f mm", baseline, sigma,
              square.value(QStringLiteral("mean")).toDouble(), square.value(QStringLiteral("sd")).toDouble());
        QVERIFY(answer.value(QStringLiteral("pairs_used")).toInt() >= 12);
        QVERIFY(std::abs(square.value(QStringLiteral("mean")).toDouble() - 54) <= 0.2);
        QVERIFY(square.value(QStringLiteral("sd")).toDouble(9) <= 1.1);
        QVERIFY(std::abs(baseline - 626.4) < 3 * sigma && sigma < 0.02 * baseline);
    }

    void sevenPortraitBoardsAreEnoughForThreePercent_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<double>("focal");
        QTest::newRow("A") << QStringLiteral("chessboards-pose2sim/cam03") << 1681.6;
        QTest::newRow("B") << QStringLiteral("chessboards-pose2sim/cam04") << 1675.2;
    }
    void sevenPortraitBoardsAreEnoughForThreePercent()
    {
        QFETCH(QString, folder);
        QFETCH(double, focal);
        const QJsonObject answer = calibrated("portrait", images(folder.toLatin1(), "*.jpg"),
                                              {QStringLiteral("--square"), QStringLiteral("60mm")});
        const double found =
            answer.value(QStringLiteral("intrinsics")).toObject().value(QStringLiteral("fx")).toDouble();
        qInfo("focal length %.1f px, published %.1f px, RMS %.3f px", found, focal,
              answer.value(QStringLiteral("rms_px")).toDouble());
        QCOMPARE(answer.value(QStringLiteral("images_used")).toInt(), 7);
        QVERIFY(std::abs(found - focal) <= 0.03 * focal);
    }

    void theCapIsFollowedInBothViews()
    {
        const QString file = m_folder.filePath(QStringLiteral("walk.odo"));
        const QJsonObject track = trackedCap(file, "cap-two-views", QStringLiteral("1.6m"));
        const QJsonObject cap =
            track.value(QStringLiteral("robots")).toObject().value(QStringLiteral("cap")).toObject();
        QCOMPARE(cap.value(QStringLiteral("frames")).toInt(), 100);
        QVERIFY(cap.value(QStringLiteral("tracked")).toInt() >= 99);
        QVERIFY(track.value(QStringLiteral("warnings")).toArray().isEmpty());
        compareWithReference(file, 150);
    }

    /// With its height free, in the frames of one view alone as well: no sample that is right is flagged.
    void theCapIsTriangulated_data()
    {
        QTest::addColumn<bool>("hasReference");
        QTest::newRow("cap-two-views") << true;
        QTest::newRow("cap-many-people") << false;
    }
    void theCapIsTriangulated()
    {
        QFETCH(bool, hasReference);
        const QString file =
            m_folder.filePath(QString::fromLatin1(QTest::currentDataTag()) + QLatin1String(".odo"));
        const QJsonObject track = trackedCap(file, QTest::currentDataTag(), QStringLiteral("free"));
        const QJsonObject cap =
            track.value(QStringLiteral("robots")).toObject().value(QStringLiteral("cap")).toObject();
        QVERIFY(cap.value(QStringLiteral("tracked")).toInt() >= 99);
        const QJsonObject shown =
            good({QStringLiteral("show"), file, QStringLiteral("walk"), QStringLiteral("--json")}).json();
        const QJsonArray spikes = shown.value(QStringLiteral("robots"))
                                      .toObject()
                                      .value(QStringLiteral("cap"))
                                      .toObject()
                                      .value(QStringLiteral("spikes"))
                                      .toArray();
        QCOMPARE(spikes, QJsonArray());
        QCOMPARE(shown.value(QStringLiteral("verdict")).toObject().value(QStringLiteral("level")).toString(),
                 QStringLiteral("pass"));
        if (hasReference)
            compareWithReference(file, 10);
    }

private:
    /// A project of a person in a cap before two cameras; what tracking answers.
    QJsonObject trackedCap(const QString &file, const char *folder, const QString &height) const
    {
        const auto run = [](const QStringList &arguments) { return good(arguments).exitStatus == 0; };
        const auto in = [&](const char *name) { return data(folder) + u'/' + QLatin1String(name); };
        bool isMade =
            run({QStringLiteral("new"), file}) && run({QStringLiteral("layout"), QStringLiteral("add"), file,
                                                       QStringLiteral("floor"), in("layout.csv")});
        for (const QString &camera : {QStringLiteral("A"), QStringLiteral("B")})
            isMade = isMade &&
                     run({QStringLiteral("intrinsics"), QStringLiteral("import"), file, camera,
                          data("cap-two-views/") + camera + QStringLiteral(".yaml")}) &&
                     run({QStringLiteral("register"), file, QStringLiteral("--camera"), camera,
                          QStringLiteral("--layout"), QStringLiteral("floor"), QStringLiteral("--pixels"),
                          in("pixels_") + camera + QStringLiteral(".csv")});
        isMade = isMade &&
                 run({QStringLiteral("robot"), QStringLiteral("add"), file, QStringLiteral("cap"),
                      QStringLiteral("--colour"), QStringLiteral("#2c717a"), QStringLiteral("--height"),
                      height}) &&
                 run({QStringLiteral("import"), file, QStringLiteral("--trial"), QStringLiteral("walk"),
                      QStringLiteral("--video"), QStringLiteral("A=") + in("A.mp4"),
                      QStringLiteral("--video"), QStringLiteral("B=") + in("B.mp4"), QStringLiteral("--sync"),
                      QStringLiteral("0"), QStringLiteral("--robot"), QStringLiteral("cap")});
        return isMade
                   ? good({QStringLiteral("track"), file, QStringLiteral("walk"), QStringLiteral("--json")})
                         .json()
                   : QJsonObject();
    }

    void compareWithReference(const QString &file, double mostMm)
    {
        const QString out = m_folder.filePath(QStringLiteral("cap.csv"));
        QCOMPARE(good({QStringLiteral("export"), file, QStringLiteral("walk"), QStringLiteral("-o"), out,
                       QStringLiteral("--force")})
                     .exitStatus,
                 0);
        const auto rows = [](const QString &name) {
            QFile table(name);
            QList<QList<QByteArray>> all;
            if (table.open(QIODevice::ReadOnly)) {
                for (const QByteArray &line : table.readAll().trimmed().split('\n').mid(1))
                    all << line.trimmed().split(',');
            }
            return all;
        };
        const auto measured = rows(out), reference = rows(data("cap-two-views/reference.csv"));
        QCOMPARE(measured.size(), 100);
        double sum = 0;
        int compared = 0;
        for (const auto &row : measured) {
            if (row.at(1).isEmpty())
                continue;
            for (const auto &truth : reference) {
                if (std::abs(truth.at(0).toDouble() - row.at(0).toDouble()) > 0.002)
                    continue;
                sum += std::pow(row.at(1).toDouble() - truth.at(1).toDouble(), 2) +
                       std::pow(row.at(2).toDouble() - truth.at(2).toDouble(), 2);
                ++compared;
            }
        }
        const double rmsMm = std::sqrt(sum / compared);
        qInfo("cap: %.1f mm RMS on the floor over %d frames", rmsMm, compared);
        QVERIFY(compared >= 95);
        QVERIFY(rmsMm <= mostMm);
    }

private Q_SLOTS:
    void charucoStillsAreRefusedForBeingTooFew()
    {
        const ProgramRun run =
            runProgram({QStringLiteral("calibrate"), project(), QStringLiteral("still"),
                        data("charuco-stills/choriginal.jpg"), QStringLiteral("--pattern"),
                        QStringLiteral("charuco"), QStringLiteral("--square"), QStringLiteral("40mm")});
        QCOMPARE(run.exitStatus, 1);
        QVERIFY2(run.err.contains("three"), run.err);
    }
};

ODOGRAPH_TEST(TestRealMaterial, QCoreApplication)
#include "tst_real_material.moc"
