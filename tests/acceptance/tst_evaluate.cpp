// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTest>
#include <array>
#include <cmath>
#include <functional>

using namespace odo::test;
using namespace Qt::StringLiterals;

/// A robot's own log on the command line, against a run that was imported as a finished track.
class TestEvaluate : public QObject, CallingTest
{
    Q_OBJECT

    static QByteArray number(double value) { return QByteArray::number(value, 'f', 9); }

    /// Half a metre in front of a turning point, to and fro with another speed each time, for 20 s.
    static double angleAt(double timeS)
    {
        return 0.9 * std::sin(0.7 * timeS) + 0.35 * std::sin(1.9 * timeS + 1);
    }
    /// x, y and heading of the run.
    static std::array<double, 3> poseAt(double timeS)
    {
        const double angle = 1.5 * angleAt(timeS), radius = 0.6 + 0.15 * std::sin(1.1 * timeS);
        return {radius * std::cos(angle), radius * std::sin(angle), angle};
    }
    using Line = std::function<QByteArray(double timeS, double x, double y, double heading)>;
    static QByteArray lines(double rate, const Line &line)
    {
        QByteArray text;
        for (int i = 0; i <= 20 * rate; ++i) {
            const auto [x, y, heading] = poseAt(i / rate);
            text += line(i / rate, x, y, heading);
        }
        return text;
    }
    /// Turned by 0.5 rad and shifted, by a clock that began in 1970, as TUM.
    static QByteArray odometry(double scale)
    {
        return lines(50, [=](double timeS, double x, double y, double heading) {
            const double turned = heading + 0.5, c = std::cos(0.5), s = std::sin(0.5);
            return QByteArray::number(1.7e9 + timeS, 'f', 6) + ' ' + number(scale * (c * x - s * y) + 3) +
                   ' ' + number(scale * (s * x + c * y) - 1) + " 0 0 0 " + number(std::sin(turned / 2)) +
                   ' ' + number(std::cos(turned / 2)) + '\n';
        });
    }
    ProgramRun evaluate(const QStringList &options) const
    {
        return runProgram(QStringList{u"evaluate"_s, m_project, u"run"_s, u"--robot"_s, u"red"_s} + options);
    }
    QJsonObject answer(const QStringList &options) const
    {
        const ProgramRun done = evaluate(options + QStringList{u"--json"_s});
        if (done.exitStatus != 0)
            qWarning("%s", done.err.constData());
        return done.json();
    }
    static bool isNear(const QJsonValue &value, double expected, double tolerance)
    {
        return value.isDouble() && std::abs(value.toDouble() - expected) < tolerance;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(runProgram({u"new"_s, m_project}).exitStatus, 0);
        write("run.csv", "t_s,x_mm,y_mm\n" + lines(60, [](double timeS, double x, double y, double) {
                             return number(timeS) + ',' + number(1000 * x) + ',' + number(1000 * y) + '\n';
                         }));
        QCOMPARE(runProgram({u"import"_s, m_project, u"--trial"_s, u"run"_s, u"--track"_s,
                             u"red="_s + path("run.csv")})
                     .exitStatus,
                 0);
        write("odometry.tum", odometry(1));
        write("scaled.tum", odometry(1.03));
    }

    void answersAsPromised()
    {
        const QByteArray before = fileHash(m_project);
        const QJsonObject json = answer({u"--log"_s, path("odometry.tum")});
        QCOMPARE(json[u"aligned_by"_s].toString(), u"se2"_s);
        QVERIFY(isNear(json[u"time_offset_s"_s], -1.7e9, 1e-3));
        QVERIFY(json[u"time_offset_sigma_s"_s].toDouble() > 0 &&
                json[u"time_offset_sigma_s"_s].toDouble() < 2e-3);
        QCOMPARE(json[u"samples"_s].toInt() + json[u"left_out"_s][u"outside"_s].toInt(), 1001);
        QCOMPARE(json[u"format"_s].toString(), u"tum"_s);
        const QJsonObject ape = json[u"ape_m"_s].toObject();
        for (const QString &key : {u"rmse"_s, u"mean"_s, u"median"_s, u"std"_s, u"min"_s, u"max"_s})
            QVERIFY2(isNear(ape[key], 0, 0.002), qPrintable(key));
        QCOMPARE(json[u"rpe_m"_s][u"delta"_s].toDouble(), 1.0);
        QVERIFY(isNear(json[u"rpe_m"_s][u"rmse"_s], 0, 0.003));
        QVERIFY(json[u"heading_deg"_s][u"rmse"_s].isNull()); // a track without headings
        const QJsonObject transform = json[u"transform"_s].toObject();
        QVERIFY(isNear(transform[u"heading_rad"_s], -0.5, 1e-3));
        QCOMPARE(transform[u"scale"_s].toDouble(), 1.0);
        // it takes the log's (3, −1) to the floor's origin
        QVERIFY(isNear(transform[u"x_m"_s], -3 * std::cos(0.5) + std::sin(0.5), 2e-3));
        QVERIFY(isNear(transform[u"y_m"_s], 3 * std::sin(0.5) + std::cos(0.5), 2e-3));
        QVERIFY(json[u"drift_percent"_s].toDouble() < 0.2);
        QCOMPARE(fileHash(m_project), before);
    }

    void aligns_data()
    {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("leastRmseM");
        QTest::addColumn<double>("mostRmseM");
        QTest::newRow("none") << 1.0 << 2.0 << 5.0;
        QTest::newRow("origin") << 1.0 << 0.005 << 0.05;
        QTest::newRow("se2") << 1.0 << 0.005 << 0.03;
        QTest::newRow("sim2") << 1 / 1.03 << 0.0 << 0.002;
    }
    void aligns()
    {
        QFETCH(double, scale);
        QFETCH(double, leastRmseM);
        QFETCH(double, mostRmseM);
        const QString how = QString::fromLatin1(QTest::currentDataTag());
        const QJsonObject json = answer({u"--log"_s, path("scaled.tum"), u"--align"_s, how});
        QCOMPARE(json[u"aligned_by"_s].toString(), how);
        QVERIFY(isNear(json[u"transform"_s][u"scale"_s], scale, 1e-3));
        const double rmse = json[u"ape_m"_s][u"rmse"_s].toDouble();
        QVERIFY2(rmse >= leastRmseM && rmse < mostRmseM, qPrintable(QString::number(rmse)));
    }

    /// A clock in milliseconds, positions in millimetres; a file that says neither is asked about.
    void readsLogsAsTracksAreRead()
    {
        write("ms.csv", "stamp_ms,x_mm,y_mm\n" + lines(20, [](double timeS, double x, double y, double) {
                            return number(1000 * timeS + 5000) + ',' + number(1000 * x) + ',' +
                                   number(1000 * y) + '\n';
                        }));
        const QJsonObject json = answer({u"--log"_s, path("ms.csv"), u"--delta"_s, u"500"_s});
        QVERIFY(isNear(json[u"time_offset_s"_s], -5, 2e-3));
        QVERIFY(isNear(json[u"ape_m"_s][u"rmse"_s], 0, 0.002));
        QCOMPARE(json[u"rpe_m"_s][u"delta"_s].toDouble(), 0.5);
        QCOMPARE(json[u"rpe_m"_s][u"of"_s].toString(), u"displacements"_s);

        write("bare.csv", "t,x,y\n" + lines(20, [](double timeS, double x, double y, double) {
                              return number(timeS) + ',' + number(1000 * x) + ',' + number(1000 * y) + '\n';
                          }));
        const ProgramRun asked = evaluate({u"--log"_s, path("bare.csv")});
        QCOMPARE(asked.exitStatus, 1);
        QVERIFY2(asked.err.contains("give their unit, likely --unit mm"), asked.err.constData());
        QCOMPARE(evaluate({u"--log"_s, path("bare.csv"), u"--unit"_s, u"mm"_s}).exitStatus, 0);
    }

    void saysItInWords()
    {
        const ProgramRun done = evaluate({u"--log"_s, path("scaled.tum"), u"--delta"_s, u"0.5m"_s});
        QCOMPARE(done.exitStatus, 0);
        QVERIFY2(done.out.startsWith("red in trial run by its own log: "), done.out.constData());
        for (const char *part : {" of 1001 positions compared", "\nTime offset: -1700000000.00",
                                 "\nAligned by se2: turned by -28.6", "\nAbsolute error: rms ",
                                 "\nRelative error over 0.5 m (", "\nHeading error: not known", "\nDrift: "})
            QVERIFY2(done.out.contains(part), done.out.constData());
        const ProgramRun fine = evaluate({u"--log"_s, path("odometry.tum")});
        QVERIFY(fine.out.contains("(not significant: within the uncertainty of the measurement)"));
    }

    void refuses_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("says");
        const QString log = path("odometry.tum");
        QTest::newRow("no log") << QStringList{} << 2 << QByteArray("--log");
        QTest::newRow("alignment") << QStringList{u"--log"_s, log, u"--align"_s, u"se3"_s} << 2
                                   << QByteArray("--align is none, origin, se2 or sim2");
        QTest::newRow("delta") << QStringList{u"--log"_s, log, u"--delta"_s, u"0"_s} << 2
                               << QByteArray("--delta '0' is not a length above zero");
        QTest::newRow("offset") << QStringList{u"--log"_s, log, u"--offset"_s, u"soon"_s} << 2
                                << QByteArray("--offset 'soon' is not a number");
        QTest::newRow("no file") << QStringList{u"--log"_s, path("none.tum")} << 1 << QByteArray("none.tum");
        QTest::newRow("no common time")
            << QStringList{u"--log"_s, log, u"--offset"_s, u"0"_s} << 1
            << QByteArray("fewer than 3 of its positions have times at which the robot was measured; choose "
                          "the log of this run");
        write("straight.tum", lines(20, [](double timeS, double, double, double) {
                  return number(timeS) + ' ' + number(0.2 * timeS) + " 0 0 0 0 0 1\n";
              }));
        QTest::newRow("another run") << QStringList{u"--log"_s, path("straight.tum")} << 1
                                     << QByteArray("it moves differently: at no time offset do more than ");
    }
    void refuses()
    {
        QFETCH(QStringList, options);
        QFETCH(int, status);
        QFETCH(QByteArray, says);
        const ProgramRun done = evaluate(options);
        QCOMPARE(done.exitStatus, status);
        QVERIFY2(done.err.contains(says), done.err.constData());
        QCOMPARE(done.err.count('\n'), 1);
        QVERIFY(done.out.isEmpty());
        if (status == 2)
            return;
        const ProgramRun asJson = evaluate(options + QStringList{u"--json"_s});
        QVERIFY(asJson.json().contains(u"error"_s));
    }

    /// On a straight run the offset is asked for, and then taken.
    void asksForTheOffset()
    {
        write("even.csv", "t_s,x_mm,y_mm\n" + lines(60, [](double timeS, double, double, double) {
                              return number(timeS) + ',' + number(200 * timeS) + ",0\n";
                          }));
        QCOMPARE(runProgram({u"import"_s, m_project, u"--trial"_s, u"even"_s, u"--track"_s,
                             u"red="_s + path("even.csv")})
                     .exitStatus,
                 0);
        const QStringList call{u"evaluate"_s, m_project,  u"even"_s,           u"--robot"_s,
                               u"red"_s,      u"--log"_s, path("straight.tum")};
        const ProgramRun refused = runProgram(call);
        QCOMPARE(refused.exitStatus, 1);
        QVERIFY2(refused.err.contains("so any time offset fits; give what is added to its times to have the "
                                      "trial's, like --offset -12.5 (seconds)"),
                 refused.err.constData());
        const ProgramRun taken = runProgram(call + QStringList{u"--offset"_s, u"0.5"_s, u"--json"_s});
        QCOMPARE(taken.exitStatus, 0);
        QCOMPARE(taken.json()[u"time_offset_s"_s].toDouble(), 0.5);
        QVERIFY(taken.json()[u"time_offset_sigma_s"_s].isNull());
    }
};

ODOGRAPH_TEST(TestEvaluate, QCoreApplication)
#include "tst_evaluate.moc"
