// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"
#include "core/project/project.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

/// Tasks on the command line: added, listed, given to trials, and what they measure, against a known circle.
class TestTasks : public QObject, CallingTest
{
    Q_OBJECT

    static QJsonObject robotOf(const ProgramRun &run)
    {
        return run.json().value(QStringLiteral("robots")).toObject().value(QStringLiteral("red")).toObject();
    }
    static double at(const QJsonObject &object, const char *key)
    {
        return object.value(QString::fromLatin1(key)).toDouble(1e9);
    }

private Q_SLOTS:
    void initTestCase()
    {
        // Anticlockwise round (1.5 m, 1.1 m) with 0.5 m at 1 m/s, after a ramp of 0.5 s: 2·(t − 0.25 s) rad.
        SimulatedScene scene = demoTestbed(3);
        scene.durationS = 2.0;
        SimulatedRobot robot;
        robot.name = "red";
        robot.colour = *parseColour("#d72328");
        robot.motion = makeCircleMotion({1.5, 1.1}, 0.5, 1.0, 0.5);
        scene.robots.push_back(robot);
        for (const int camera : {0, 1}) {
            const auto file =
                m_folder.filePath(camera == 0 ? QStringLiteral("a.mkv") : QStringLiteral("b.mkv"));
            QVERIFY(renderVideo(scene, camera, file.toStdString(), {}, {}).has_value());
            const auto lens =
                m_folder.filePath(camera == 0 ? QStringLiteral("a.yaml") : QStringLiteral("b.yaml"));
            const SimulatedCamera &simulated = scene.cameras[std::size_t(camera)];
            QVERIFY(writeIntrinsics(lens.toStdString(), simulated.name, simulated.view.camera().intrinsics())
                        .has_value());
        }
        write("layout.csv", "label,x_mm,y_mm\nO,0,0\nU,3000,0\nV,0,2200\nD,3000,2200\n");
        // From the centre outwards a gate is passed anticlockwise only from its right to its left.
        write("quarter.json",
              "{\"template\": \"circle\",\n"
              " \"gates\": [\n"
              "  {\"name\": \"begin\", \"role\": \"start\", \"from_mm\": [2200, 1800], \"to_mm\": [1500, "
              "1100]},\n"
              "  {\"name\": \"wrong way\", \"role\": \"split\", \"from_mm\": [1500, 1100], \"to_mm\": [2200, "
              "1800]},\n"
              "  {\"name\": \"end\", \"role\": \"finish\", \"from_mm\": [1500, 1900], \"to_mm\": [1500, "
              "1100]}],\n"
              " \"reference_path\": {\"circle\": {\"centre_mm\": [1500, 1100], \"radius_mm\": 480}}}\n");
        write("slow.json", "{\"limits\": {\"speed_mm_s\": 300}}");
        write(
            "bad.json",
            "{\"gates\": [\n{\"name\": \"a\", \"role\": \"goal\", \"from_mm\": [0, 0], \"to_mm\": [1, 1]}]}");
        for (const char *line :
             {"new %P --title Lesson", "robot add %P red --colour #d72328 --height 60mm --size 260x190",
              "layout add %P floor %/layout.csv", "intrinsics import %P A %/a.yaml",
              "intrinsics import %P B %/b.yaml", "register %P --camera A --layout floor --video %/a.mkv",
              "register %P --camera B --layout floor --video %/b.mkv"})
            QCOMPARE(good(line).exitStatus, 0);
    }

    void aTaskIsAddedAndListed()
    {
        const ProgramRun added = good("task add %P quarter %/quarter.json");
        QCOMPARE(added.exitStatus, 0);
        QVERIFY(added.out.contains("3 gates, reference path"));
        const QJsonArray tasks = good("task list %P --json").json().value(QStringLiteral("tasks")).toArray();
        QCOMPARE(tasks.size(), 1);
        const QJsonObject task = tasks[0].toObject();
        QCOMPARE(task.value(QStringLiteral("name")).toString(), QStringLiteral("quarter"));
        QCOMPARE(task.value(QStringLiteral("gates")).toArray().size(), 3);
        // What is listed can be read back.
        write("again.json", QJsonDocument(task).toJson());
        const ProgramRun again = good("task add %P again %/again.json --json");
        QCOMPARE(again.exitStatus, 0);
        for (const char *part : {"template", "gates", "reference_path", "limits"})
            QCOMPARE(again.json().value(QString::fromLatin1(part)), task.value(QString::fromLatin1(part)));
    }

    void aTrialIsMeasuredByItsTask()
    {
        QCOMPARE(good("import %P --trial run1 --video A=%/a.mkv --video B=%/b.mkv --sync 0 --task quarter "
                      "--robot red")
                     .exitStatus,
                 0);
        QCOMPARE(good("list %P --json")
                     .json()
                     .value(QStringLiteral("trials"))
                     .toArray()[0]
                     .toObject()
                     .value(QStringLiteral("task"))
                     .toString(),
                 QStringLiteral("quarter"));
        const ProgramRun tracked = good("track %P run1 --json");
        const QJsonObject robot = robotOf(tracked);
        const QJsonArray gates = robot.value(QStringLiteral("gates")).toArray();
        QCOMPARE(gates.size(), 2);
        // At an eighth and at a quarter of a turn.
        const double first = 0.25 + M_PI / 8, second = 0.25 + M_PI / 4;
        QVERIFY(std::abs(at(gates[0].toObject(), "time_s") - first) < 0.005);
        QVERIFY(std::abs(at(gates[1].toObject(), "time_s") - second) < 0.005);
        QVERIFY(at(gates[0].toObject(), "sigma_s") > 0 && at(gates[0].toObject(), "sigma_s") < 0.05);
        const QJsonArray laps = robot.value(QStringLiteral("laps")).toArray();
        QCOMPARE(laps.size(), 1);
        QVERIFY(std::abs(at(laps[0].toObject(), "time_s") - M_PI / 8) < 0.005);
        const QJsonObject path = robot.value(QStringLiteral("path")).toObject();
        QVERIFY2(std::abs(at(path, "mean_mm") - 20) < 3, qPrintable(QString::number(at(path, "mean_mm"))));
        QVERIFY(at(path, "bias_mm") < 0); // outside of an anticlockwise circle is right of it
        QVERIFY(at(path, "sigma_rms_mm") > 0 && at(path, "sigma_max_mm") > 0);
        // 2·1.75 rad of 2π, whatever the radius.
        QVERIFY(std::abs(at(path, "completed") - 3.5 / (2 * M_PI)) < 0.03);

        const QJsonObject shown = robotOf(good("show %P run1 --json"));
        for (const char *part : {"gates", "laps", "path"})
            QCOMPARE(shown.value(QString::fromLatin1(part)), robot.value(QString::fromLatin1(part)));
        const QByteArray text = good("show %P run1").out;
        for (const char *words :
             {"gate begin at 0.6", "gate end at 1.0", "run 1: 0.3", "cross_track_rms", "gate_time"})
            QVERIFY2(text.contains(words), words);
        QVERIFY(good("track %P run1 --again").out.contains("gate time 0.3"));
        QCOMPARE(good("check %P").exitStatus, 0);
    }

    void aTaskIsGivenLaterWithoutDecoding()
    {
        QCOMPARE(good("import %P --trial later --video A=%/a.mkv --video B=%/b.mkv --sync 0 --robot red")
                     .exitStatus,
                 0);
        const QJsonObject before = robotOf(good("track %P later --json"));
        QVERIFY(before.value(QStringLiteral("gates")).toArray().isEmpty());
        QVERIFY(!before.contains(QStringLiteral("path")));
        QCOMPARE(good("task set %P later quarter").exitStatus, 0);
        QCOMPARE(
            robotOf(good("track %P later --again --json")).value(QStringLiteral("gates")).toArray().size(),
            2);
    }

    void limitsThatTheRobotBreaksAllTheTimeAreLeftOutAndSaid()
    {
        QCOMPARE(good("task add %P slow %/slow.json").exitStatus, 0);
        QCOMPARE(good("task set %P run1 slow").exitStatus, 0);
        const ProgramRun tracked = good("track %P run1 --again --json");
        QCOMPARE(tracked.exitStatus, 0);
        QVERIFY(at(robotOf(tracked), "max_speed_m_s") > 0.9);
        const QString warning = tracked.json().value(QStringLiteral("warnings")).toArray().at(0).toString();
        QVERIFY2(warning.startsWith(QStringLiteral("robot 'red' in trial 'run1': ")) &&
                     warning.endsWith(QStringLiteral(
                         "exceed the limits of task 'slow', so the limits were ignored; give the "
                         "task the limits of its fastest robot")),
                 qPrintable(warning));
    }

    /// What changed the project from outside of the window, in its order.
    void everyCommandIsToldInTheListOfChanges()
    {
        const auto project = Project::open(m_project.toStdString(), Project::Access::ReadOnly);
        QVERIFY(project.has_value());
        QStringList told;
        const auto changes = (*project)->changes();
        QVERIFY(changes.has_value());
        for (const ChangeEntry &entry : *changes)
            told.prepend(QString::fromStdString(entry.words.english()));
        const QStringList expected{QStringLiteral("add robot red"),
                                   QStringLiteral("add layout floor"),
                                   QStringLiteral("import the lens calibration of camera A from a.yaml"),
                                   QStringLiteral("register camera A"),
                                   QStringLiteral("add task quarter"),
                                   QStringLiteral("import trial run1"),
                                   QStringLiteral("track run1"),
                                   QStringLiteral("reanalyse run1"),
                                   QStringLiteral("give later the task quarter"),
                                   QStringLiteral("give run1 the task slow")};
        qsizetype place = 0;
        for (const QString &words : expected) {
            const qsizetype next = told.indexOf(words, place);
            QVERIFY2(next >= 0, qPrintable(words + QStringLiteral(" in ") + told.join(QStringLiteral(", "))));
            if (!words.startsWith(QLatin1String("register")) &&
                !words.startsWith(QLatin1String("import the lens")))
                place = next;
        }
    }

    void badCallsFailInOneLine_data()
    {
        beginBadCalls();
        const auto row = addBadCall;
        row("task", 2, "an argument is missing");
        row("task paint %P", 2, "give add P.odo NAME task.json, list P.odo, or set P.odo TRIAL NAME");
        row("task add %P name", 2, "give add P.odo NAME task.json");
        row("task add %P quarter %/quarter.json", 1,
            "task 'quarter': the project already has a task of that name");
        row("task add %P bad %/bad.json", 1,
            "bad.json:2: role 'goal': gates have no such role; use start, finish");
        row("task add %P none %/none.json", 1, "none.json");
        row("task set %P run1 unknown", 1, "task 'unknown': the project has no such task; it has 'quarter'");
        row("task set %P nowhere quarter", 1, "trial 'nowhere': the project has no such trial");
        row("import %P --trial new --video A=%/a.mkv --task unknown", 1,
            "task 'unknown': the project has no such task");
    }
    void badCallsFailInOneLine() { badCallFailsInOneLine(); }
};

ODOGRAPH_TEST(TestTasks, QCoreApplication)
#include "tst_tasks.moc"
