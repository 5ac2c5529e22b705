// SPDX-License-Identifier: GPL-3.0-or-later
// Recording as the command line does it, from the simulated testbed and from files.
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace odo::test;

class TestRecord : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void listsTheSimulatedCameras();
    void recordsTwoCamerasAndTracksThem();
    void aFileThatEndsKeepsWhatThereIs();
    void saysItInWords();
    void badCallsFailInOneLine_data();
    void badCallsFailInOneLine();

private:
    /// % stands for the folder.
    ProgramRun run(const char *line) const
    {
        QStringList arguments = QString::fromUtf8(line).split(u' ');
        arguments.replaceInStrings(QStringLiteral("%"), m_folder.path());
        return runCommand(qEnvironmentVariable("ODOGRAPH_PROGRAM"), arguments);
    }
    QTemporaryDir m_folder;
};

void TestRecord::initTestCase()
{
    QCOMPARE(run("new %/p.odo").exitStatus, 0);
    QCOMPARE(run("robot add %/p.odo blue --colour #1a5fd0").exitStatus, 0);
}

void TestRecord::listsTheSimulatedCameras()
{
    const QJsonArray cameras = run("cameras --json").json().value(QStringLiteral("cameras")).toArray();
    QVERIFY(cameras.size() >= 2);
    const QJsonObject first = cameras[0].toObject();
    QCOMPARE(first.value(QStringLiteral("uri")).toString(), QStringLiteral("sim:A"));
    QCOMPARE(first.value(QStringLiteral("kind")).toString(), QStringLiteral("simulated"));
    for (const char *key : {"name", "serial", "formats", "busy"})
        QVERIFY2(first.contains(QLatin1String(key)), key);
}

void TestRecord::recordsTwoCamerasAndTracksThem()
{
    const ProgramRun recorded =
        run("record %/p.odo --trial live --camera A=sim:A --camera B=sim:B --seconds 1 --robot blue --json");
    QVERIFY2(recorded.exitStatus == 0, recorded.err);
    const QJsonObject answer = recorded.json(), views = answer.value(QStringLiteral("views")).toObject();
    QVERIFY(answer.value(QStringLiteral("duration_s")).toDouble() > 0.5);
    for (const char *name : {"A", "B"}) {
        const QJsonObject view = views.value(QLatin1String(name)).toObject();
        const double frames = view.value(QStringLiteral("frames")).toDouble();
        QVERIFY(frames > 0);
        QCOMPARE(view.value(QStringLiteral("recorded")).toDouble() +
                     view.value(QStringLiteral("lost_by_us")).toDouble(),
                 frames);
        QVERIFY(view.contains(QStringLiteral("lost_on_wire")));
        QVERIFY(view.value(QStringLiteral("latency_p99_ms")).toDouble() >= 0);
    }
    QVERIFY(answer.value(QStringLiteral("pairs")).toInt() > 0);
    QVERIFY(answer.contains(QStringLiteral("unpaired")));
    // Both see one testbed at the same times: what is left is how well their clocks are known.
    QVERIFY(
        answer.value(QStringLiteral("pair_error_ms")).toObject().value(QStringLiteral("median")).toDouble() <
        15);
    QCOMPARE(run("check %/p.odo").exitStatus, 0);
    const ProgramRun tracked = run("track %/p.odo live --json");
    QVERIFY(tracked.exitStatus == 1); // the cameras are not registered
    QVERIFY2(tracked.err.contains("regist"), tracked.err);
}

void TestRecord::aFileThatEndsKeepsWhatThereIs()
{
    const QStringList made =
        QDir(m_folder.filePath(QStringLiteral("p.media"))).entryList({QStringLiteral("live_A*.mkv")});
    QCOMPARE(made.size(), 1);
    const ProgramRun recorded = run(("record %/p.odo --trial again --camera A=file:%/p.media/" +
                                     made.first().toUtf8() + " --seconds 60 --json")
                                        .constData());
    QVERIFY2(recorded.exitStatus == 0, recorded.err);
    QVERIFY2(recorded.err.contains("the video has ended"), recorded.err);
    QVERIFY(recorded.json().value(QStringLiteral("duration_s")).toDouble() > 0.5);
}

void TestRecord::saysItInWords()
{
    const ProgramRun recorded =
        run("record %/p.odo --trial words --camera A=sim:A --camera B=sim:B --seconds 0.5");
    QVERIFY2(recorded.exitStatus == 0, recorded.err);
    const QString words = QString::fromUtf8(recorded.out);
    static const QRegularExpression sentences(
        QStringLiteral("^Trial words recorded: [\\d.]+ s\\.\nView A: \\d+ frames, [\\d.]+ a second, "
                       "(none|\\d+) lost\\.\nView B: .*\n"
                       "The views are synchronised to ([\\d.]+) ms; at 2 m/s that is ([\\d.]+) mm, which the "
                       "analysis takes into account\\.\n$"));
    const QRegularExpressionMatch match = sentences.match(words);
    QVERIFY2(match.hasMatch(), qPrintable(words));
    QVERIFY(std::abs(match.captured(3).toDouble() - 2 * match.captured(2).toDouble()) <
            0.16); // each rounded to a tenth
    QCOMPARE(run("record %/p.odo --recover").out, QByteArray("No recording is left that was cut off.\n"));
}

void TestRecord::badCallsFailInOneLine_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("words");
    const auto row = [](const char *line, int status, const char *words) {
        QTest::newRow(line) << QByteArray(line) << status << QByteArray(words);
    };
    row("record %/p.odo --trial x", 2, "--camera is missing");
    row("record %/p.odo --camera A=sim:A", 2, "--trial is missing");
    row("record %/p.odo --trial x --camera sim:A", 2, "--camera");
    row("record %/p.odo --trial x --camera A=sim:A --seconds 0", 2, "--seconds is a number above zero");
    row("record %/p.odo --trial x --camera A=sim:A --seconds 1e30", 2, "at most 86,400 (a day)");
    row("record %/p.odo --trial x --camera A=sim:A --pre-roll 31", 2,
        "--pre-roll is a number of seconds from 0 to 30");
    row("record %/p.odo --trial x --camera A=sim:A --start-on noise", 2,
        "--start-on is motion, gate, zone:NAME (entered) or leave:NAME");
    row("record %/p.odo --trial x --camera A=sim:A --stop-on zone:", 2,
        "--stop-on is motion, motion:SECONDS");
    row("record %/p.odo --trial x --camera A=sim:A --stop-on 5 --seconds 5", 2, "give one of them");
    row("record %/p.odo --trial x --camera A=sim:A --start-on gate", 1, "gates and zones are a task's");
    row("record %/p.odo --trial x --camera A=sim:A --start-on gate --task none", 1, "none");
    row("record %/p.odo --trial x --camera A=sim:A --start-on motion", 1,
        "none of its cameras is registered to the floor");
    row("record %/p.odo --trial x --camera A=sim:Z", 1, "simulated camera Z does not exist");
    row("record %/p.odo --trial x --camera A=usb:0", 1, "no kind of camera has an address like this");
    row("record %/p.odo --trial x --camera A=sim:A --camera B=sim:A", 1, "was given twice");
    row("record %/p.odo --trial x --camera A=sim:A --robot none", 1, "none");
    row("record %/p.odo --trial live --camera A=sim:A", 1, "already has a trial of that name");
    row("record %/p.odo --trial x --camera A=file:%/none.mkv", 1, "none.mkv");
    row("record %/p.odo --trial x --camera A=sim:A --ssl-vision robots.example:1", 1,
        "it is not an IPv4 address with a port; write it like 224.5.23.2:10006");
    row("record --ssl-vision %/p.odo --trial x --camera A=sim:A", 1,
        "none of its cameras is registered to the floor");
    row("record %/p.odo --trial x --camera A=sim:A --ssl-vision", 1,
        "none of its cameras is registered to the floor");
}

void TestRecord::badCallsFailInOneLine()
{
    QFETCH(QByteArray, line);
    QFETCH(int, status);
    QFETCH(QByteArray, words);
    const auto media = [this] {
        return QDir(m_folder.filePath(QStringLiteral("p.media"))).entryList(QDir::Files);
    };
    const QStringList before = media();
    const ProgramRun failed = run(line.constData());
    QCOMPARE(failed.exitStatus, status);
    QVERIFY2(failed.err.startsWith("odograph: ") && failed.err.contains(words), failed.err);
    QCOMPARE(failed.err.trimmed().count('\n'), 0);
    QCOMPARE(media(), before);
}

ODOGRAPH_TEST(TestRecord, QCoreApplication)
#include "tst_record.moc"
