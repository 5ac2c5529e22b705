// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody tries first with the demo lesson: a team's robot is recorded before the simulated cameras,
// which show it, and tracked.
#include "core/simulation/demo_testbed.h"
#include "tests/support/demo_lesson.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;

namespace {

struct Place
{
    double timeS;
    Eigen::Vector2d positionM;
};

/// How far the places are from where a circling robot is, at most, and the mean of their squares. The
/// recording begins at an unknown time of the scene, which is the one at which they fit best: the program
/// starts with the scene, so within its first seconds.
struct Errors
{
    double worstM = 1e9, rmsM = 1e9;
};
Errors errorsOf(const std::vector<Place> &places, const Motion &motion)
{
    Errors best;
    for (double startS = 0; startS < 8; startS += 0.0005) { // half a millimetre at 1.1 m/s
        Errors errors{0, 0};
        for (const Place &place : places) {
            const double error = (place.positionM - motion.at(startS + place.timeS).position).norm();
            errors.worstM = std::max(errors.worstM, error);
            errors.rmsM += error * error / double(places.size());
            if (errors.rmsM > best.rmsM * best.rmsM)
                break;
        }
        errors.rmsM = std::sqrt(errors.rmsM);
        if (errors.rmsM < best.rmsM)
            best = errors;
    }
    return best;
}

} // namespace

class TestFirstRecording : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void theRobotsThatAreUpAreFound_data();
    void theRobotsThatAreUpAreFound();

private:
    QString project() const { return m_folder.filePath(QStringLiteral("demo.odo")); }
    QByteArray record(const QString &trial, const QStringList &robots) const;
    std::vector<Place> paletteIndicesOf(const QString &trial, const QString &robot) const;

    QTemporaryDir m_folder;
};

void TestFirstRecording::initTestCase()
{
    const QString problem = provideDemoLesson(m_folder.path());
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
}

/// What went wrong, or nothing.
QByteArray TestFirstRecording::record(const QString &trial, const QStringList &robots) const
{
    QStringList call{QStringLiteral("record"),    project(),
                     QStringLiteral("--trial"),   trial,
                     QStringLiteral("--camera"),  QStringLiteral("A=sim:A"),
                     QStringLiteral("--camera"),  QStringLiteral("B=sim:B"),
                     QStringLiteral("--seconds"), QStringLiteral("5")};
    for (const QString &robot : robots)
        call << QStringLiteral("--robot") << robot;
    const ProgramRun run = runProgram(call);
    return run.exitStatus == 0 ? QByteArray() : run.err;
}

/// In each frame in which the robot was measured.
std::vector<Place> TestFirstRecording::paletteIndicesOf(const QString &trial, const QString &robot) const
{
    const QString table = m_folder.filePath(QStringLiteral("run.csv"));
    const ProgramRun run = runProgram({QStringLiteral("export"), project(), trial, QStringLiteral("-o"),
                                       table, QStringLiteral("--robot"), robot});
    QFile file(table);
    std::vector<Place> places;
    if (run.exitStatus != 0 || !file.open(QIODevice::ReadOnly))
        return places;
    const QList<QByteArray> header = file.readLine().trimmed().split(',');
    const qsizetype x = header.indexOf("raw_x_mm"), y = header.indexOf("raw_y_mm");
    while (!file.atEnd()) {
        const QList<QByteArray> cells = file.readLine().trimmed().split(',');
        if (!cells[x].isEmpty())
            places.push_back(
                {cells[0].toDouble(), Eigen::Vector2d(cells[x].toDouble(), cells[y].toDouble()) / 1000});
    }
    return places;
}

void TestFirstRecording::theRobotsThatAreUpAreFound_data()
{
    QTest::addColumn<QStringList>("named");
    QTest::addColumn<QStringList>("robots");
    const auto row = [](const char *name, const QStringList &robots) {
        QTest::newRow(name) << robots << robots;
    };
    row("Falcon", {QStringLiteral("Red 2")});
    row("Heron", {QStringLiteral("Rover 4")});
    if (!qEnvironmentVariableIsSet("ODOGRAPH_ALL_TEAMS"))
        return;
    row("Lynx", {QStringLiteral("Green 3")});
    row("Otter", {QStringLiteral("Blue 1")});
    row("two at once", {QStringLiteral("Rover 4"), QStringLiteral("Green 3")});
    QTest::newRow("nobody: all the project has")
        << QStringList()
        << QStringList{QStringLiteral("Red 2"), QStringLiteral("Blue 1"), QStringLiteral("Rover 4"),
                       QStringLiteral("Green 3")};
}

void TestFirstRecording::theRobotsThatAreUpAreFound()
{
    QFETCH(QStringList, named);
    QFETCH(QStringList, robots);
    const QString trial = QStringLiteral("first of ") + QString::fromUtf8(QTest::currentDataTag());
    const QByteArray problem = record(trial, named);
    QVERIFY2(problem.isEmpty(), problem);
    const ProgramRun track =
        runProgram({QStringLiteral("track"), project(), trial, QStringLiteral("--json")});
    QVERIFY2(track.exitStatus == 0, track.err);
    const std::vector<SimulatedRobot> shown =
        circlingRobots(std::vector<RobotAppearance>(std::size_t(robots.size())));
    for (qsizetype i = 0; i < robots.size(); ++i) {
        const QJsonObject tracked =
            track.json().value(QStringLiteral("robots")).toObject().value(robots[i]).toObject();
        const double frames = tracked.value(QStringLiteral("frames")).toDouble();
        const std::vector<Place> places = paletteIndicesOf(trial, robots[i]);
        const Errors errors = errorsOf(places, *shown[std::size_t(i)].motion);
        qInfo("%s: %.0f frames, %zu measured, RMS %.2f mm, worst %.2f mm", qPrintable(robots[i]), frames,
              places.size(), 1e3 * errors.rmsM, 1e3 * errors.worstM);
        // 150, of which a busy machine loses some; those that are there must have the robot.
        QVERIFY(frames >= 60 && double(places.size()) >= 0.99 * frames);
        QVERIFY(errors.worstM <= 0.01);
        QCOMPARE(tracked.value(QStringLiteral("spikes")).toInt(), 0);
    }
}

ODOGRAPH_TEST(TestFirstRecording, QCoreApplication)
#include "tst_first_recording.moc"
