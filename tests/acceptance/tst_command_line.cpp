// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "tests/support/calling_test.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// Every subcommand with a good call and with bad ones: the answer, the exit status, the one-line error, and
/// that a failed call leaves the project's file as it was.
class TestCommandLine : public QObject, CallingTest
{
    Q_OBJECT

    void renderTestVideos() const
    {
        SimulatedScene scene = demoTestbed(3);
        scene.durationS = 2.0;
        SimulatedRobot robot;
        robot.name = "red";
        robot.colour = *parseColour("#d72328");
        robot.motion = makeCircleMotion({1.5, 1.1}, 0.5, 1.0, 0.5);
        scene.robots.push_back(robot);
        const auto render = [&](const SimulatedScene &s, int camera, const char *name) {
            const auto done = renderVideo(s, camera, path(name).toStdString(), {}, {});
            QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        };
        render(scene, 0, "a.mkv");
        render(scene, 1, "b.mkv");
        SimulatedScene hidden = scene; // a robot that is taken away after 1.2 s
        hidden.occluders = {{*parseColour("#5c646e"), {-0.3, 0.2}, {3.3, 0.2}, 2.5, 1.2},
                            {*parseColour("#5c646e"), {-0.3, 0.21}, {3.3, 0.21}, 2.5, 1.2}};
        render(hidden, 0, "leaving.mkv");
        scene.durationS = 1.0;
        render(scene, 1, "short.mkv");
        scene.cameras[1].framesPerSecond = 15;
        render(scene, 1, "slow.mkv");
        scene.robots.clear();
        scene.durationS = 0.5;
        render(scene, 0, "empty.mkv");
    }

    QJsonObject shownRobot() const
    {
        return good("show %P run1 --json")
            .json()
            .value(QStringLiteral("robots"))
            .toObject()
            .value(QStringLiteral("red"))
            .toObject();
    }

    /// Round trip of a flag set by hand, with the videos away: nothing may be decoded for it.
    void aPersonOverrulesTheProgram() const
    {
        const QString media = path("class.media");
        QVERIFY(QDir().rename(media, media + QStringLiteral(".gone")));
        const ProgramRun again = good("track %P run1 --again --json");
        // Of the stored observations: the tracker's own differ from them in the last bit.
        const QJsonObject before = shownRobot();
        const ProgramRun spike = good("flag %P run1 --time 1.01 --spike --json");
        const ProgramRun kept = good("track %P run1 --again --robot red");
        const QJsonObject judged = shownRobot();
        const ProgramRun valid = good("flag %P run1 --robot red --frame 30 --valid --json");
        const ProgramRun cleared = good("flag %P run1 --frame 30 --clear");
        QVERIFY(QDir().rename(media + QStringLiteral(".gone"), media));
        QCOMPARE(again.exitStatus, 0);
        QCOMPARE(spike.exitStatus, 0);
        QCOMPARE(spike.json().value(QStringLiteral("frame")).toInt(), 30);
        QCOMPARE(spike.json().value(QStringLiteral("used")).toBool(), false);
        QVERIFY(spike.json().value(QStringLiteral("flags")).toString().contains(QStringLiteral("by_hand")));
        QCOMPARE(kept.exitStatus, 0);
        const auto spikes = [](const QJsonObject &robot) {
            return robot.value(QStringLiteral("spikes")).toArray().size();
        };
        QCOMPARE(spikes(judged), spikes(before) + 1);
        QCOMPARE(judged.value(QStringLiteral("provenance"))
                     .toObject()
                     .value(QStringLiteral("overrules"))
                     .toArray()
                     .size(),
                 1);
        QCOMPARE(valid.json().value(QStringLiteral("used")).toBool(), true);
        QCOMPARE(cleared.exitStatus, 0);
        QCOMPARE(shownRobot().value(QStringLiteral("metrics")).toArray(),
                 before.value(QStringLiteral("metrics")).toArray());
    }

private Q_SLOTS:
    void initTestCase()
    {
        renderTestVideos();
        write("layout.csv", "label,x_mm,y_mm\nO,0,0\nU,3000,0\nV,0,2200\nD,3000,2200\n");
        write("three.csv", "label,u,v\nO,100,600\nU,1100,650\nV,300,200\n");
        write("collinear.csv", "label,u,v\nO,100,600\nU,300,600\nV,500,600\nD,700,600\n");
        write("doubled.csv", "label,u,v\nO,100,600\nO,1100,650\nV,300,200\nD,900,210\n");
        write("mirrored.csv", "label,u,v\nO,1100,650\nU,100,600\nV,900,210\nD,300,200\n");
        write("broken.csv", "label,u,v\nO,100\n");
        write("novideo.mkv", "this is no video");
        write("playlist.mkv", "#EXTM3U\n#EXT-X-TARGETDURATION:5\n#EXTINF:5,\na.mkv\n#EXT-X-ENDLIST\n");
        write("broken.yaml", "image_width: 640\ncamera_matrix: [[[[\n");
        write("foreign.odo", "not a database");
        QVERIFY(writeImage(SceneRenderer(demoTestbed(1), 0).render(0), path("noboard.png").toStdString())
                    .has_value());
    }

    void errorsAreJsonWhereItIsAsked_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("code");
        const auto add = [](const char *line, int status, const char *code) {
            QTest::newRow(line) << QString::fromLatin1(line) << status << QString::fromLatin1(code);
        };
        add("list %/none.odo --json", 1, "not_found");
        add("list %/foreign.odo --json", 1, "invalid_input");
        add("list --json", 2, "wrong_call");
        add("list --json --what", 2, "wrong_call");
        add("bogus --json", 2, "wrong_call");
        add("new %/foreign.odo --json", 1, "already_exists");
        add("new %/no/p.odo --json", 1, "not_found");
    }
    void errorsAreJsonWhereItIsAsked()
    {
        QFETCH(QString, line);
        QFETCH(int, status);
        QFETCH(QString, code);
        const ProgramRun failed = run(line);
        QCOMPARE(failed.exitStatus, status);
        QCOMPARE(failed.json().keys(), QStringList{QStringLiteral("error")});
        const QJsonObject error = failed.json().value(QStringLiteral("error")).toObject();
        QCOMPARE(error.value(QStringLiteral("code")).toString(), code);
        QCOMPARE(failed.err, "odograph: " + error.value(QStringLiteral("text")).toString().toUtf8() + '\n');
        QVERIFY(error.value(QStringLiteral("arguments")).isObject());
    }

    void standardFilesMayBeClosed()
    {
        const auto shell = [](const char *line, const QString &file) {
            return runCommand(QStringLiteral("/bin/sh"),
                              {QStringLiteral("-c"), QString::fromLatin1(line), file});
        };
        QCOMPARE(run("new %/closed.odo").exitStatus, 0);
        const QString file = path("closed.odo");
        for (const char *line :
             {"\"$ODOGRAPH_PROGRAM\" list \"$0\" >&-", "\"$ODOGRAPH_PROGRAM\" list \"$0\" >&- <&-",
              "\"$ODOGRAPH_PROGRAM\" --version >&-"}) {
            const ProgramRun failed = shell(line, file);
            QCOMPARE(failed.exitStatus, 1);
            QCOMPARE(failed.err,
                     QByteArray("odograph: the output: it could not be written (Bad file descriptor); the "
                                "command succeeded; free some disk space and repeat it\n"));
        }
        QCOMPARE(shell("\"$ODOGRAPH_PROGRAM\" list \"$0\" 2>&- <&-", file).exitStatus, 0);
        QCOMPARE(shell("\"$ODOGRAPH_PROGRAM\" list \"$0.none\" >&- 2>&- <&-", file).exitStatus, 1);
    }

    void projectsTakeNoPlaceOfOthers()
    {
        QCOMPARE(run("new %/place.odo").exitStatus, 0);
        QVERIFY(QDir().mkpath(path("place.media")));
        for (const char *line : {"new %/place.odo-wal", "new %/place.odo.lock", "new %/place.odo.bak-1",
                                 "new %/place.media/inner.odo", "new %/.odograph-aaaaaaaaaaaa.part",
                                 "demo %/place.media/new/demo"}) {
            const ProgramRun refused = run(line);
            QVERIFY2(refused.exitStatus == 2 && refused.err.count('\n') == 1, refused.err);
        }
        QVERIFY(QDir(path("place.media")).isEmpty());
    }

    void aWholeLessonWorks()
    {
        QCOMPARE(good("new %P --title Lesson").exitStatus, 0);
        QCOMPARE(good("robot add %P red --colour #d72328 --height 60mm --size 260x190").exitStatus, 0);
        // The same robot, its colour taken from the picture: the camera shows it dimmer, of the same hue.
        const auto pixel = demoTestbed(3).cameras[0].view.pixelFromWorld({2.0, 1.1, 0.03});
        const QString box = QStringLiteral("%1,%2,90,60").arg(int(pixel->x()) - 45).arg(int(pixel->y()) - 30);
        const ProgramRun picked = runProgram(
            filled(QStringLiteral("robot add %P picked --pick %/a.mkv --frame 3 --json --box ")) << box);
        QVERIFY2(picked.exitStatus == 0, picked.err);
        const auto colour =
            parseColour(picked.json().value(QStringLiteral("colour")).toString().toStdString());
        QVERIFY(colour && colour->red > 170 && colour->red <= 220 && colour->green < 60 && colour->blue < 60);
        QCOMPARE(good("camera add %P A --device file:a.mkv").exitStatus, 0);
        QCOMPARE(good("layout add %P floor %/layout.csv").exitStatus, 0);
        const ProgramRun registered = good("register %P --camera A --layout floor --video %/a.mkv --json");
        QCOMPARE(registered.exitStatus, 0);
        const QJsonObject registration = registered.json();
        QCOMPARE(registration.value(QStringLiteral("markers")).toArray().size(), 4);
        QVERIFY(
            registration.value(QStringLiteral("verdict")).toString().contains(QStringLiteral("distortion")));
        QCOMPARE(good("register %P --camera B --layout floor --video %/b.mkv").exitStatus, 0);

        const ProgramRun imported = good("import %P --trial run1 --video A=%/a.mkv --video B=%/b.mkv --sync "
                                         "0 --team Falcon --robot red --json");
        QCOMPARE(imported.exitStatus, 0);
        QCOMPARE(imported.json()
                     .value(QStringLiteral("views"))
                     .toObject()
                     .value(QStringLiteral("A"))
                     .toObject()
                     .value(QStringLiteral("frames"))
                     .toInt(),
                 60);
        QCOMPARE(imported.json()
                     .value(QStringLiteral("sync"))
                     .toObject()
                     .value(QStringLiteral("method"))
                     .toString(),
                 QStringLiteral("told"));

        const ProgramRun tracked = good("track %P run1 --json");
        QCOMPARE(tracked.exitStatus, 0);
        const QJsonObject robot =
            tracked.json().value(QStringLiteral("robots")).toObject().value(QStringLiteral("red")).toObject();
        QCOMPARE(robot.value(QStringLiteral("frames")).toInt(), 60);
        QVERIFY(robot.value(QStringLiteral("tracked")).toInt() >= 58);
        QVERIFY(tracked.json().value(QStringLiteral("warnings")).toArray().isEmpty());
        // One metre a second on the circle; the camera's lens is not known here, so only a rough figure can
        // be had.
        QVERIFY(std::abs(robot.value(QStringLiteral("max_speed_m_s")).toDouble() - 1.0) < 0.1);
        for (const char *smoother : {"savgol", "tracker", "none", "rts"})
            QCOMPARE(
                good((QByteArray("track %P run1 --robot red --smoother ") + smoother).constData()).exitStatus,
                0);

        aPersonOverrulesTheProgram();
        QCOMPARE(good("list %P --json").json().value(QStringLiteral("trials")).toArray().size(), 1);
        QCOMPARE(good("show %P run1 --json").json().value(QStringLiteral("team")).toString(),
                 QStringLiteral("Falcon"));
        for (const char *format : {"csv", "tum", "json", "tracker"})
            QCOMPARE(good((QByteArray("export %P run1 -o %/out.txt --force --format ") + format).constData())
                         .exitStatus,
                     0);
        const QJsonObject video =
            good("export %P run1 -o %/run1.mp4 --format video --speed 0.5 --size 640x360 --theme dark --json")
                .json();
        QVERIFY(video.value(QStringLiteral("frames")).toInt() >= 58);
        QVERIFY(QFileInfo(m_folder.filePath(QStringLiteral("run1.mp4"))).size() > 10'000);
        QCOMPARE(good("check %P").exitStatus, 0);
        QCOMPARE(good("snapshot %P run1 -o %/run1.png --size 1000x700").exitStatus, 0);
        QCOMPARE(good("target tags -o %/tags.pdf --labels O,U,V,D,C --json")
                     .json()
                     .value(QStringLiteral("sheets"))
                     .toInt(),
                 5);
        // closed to a single file
        QVERIFY(QDir(m_folder.path()).entryList({QStringLiteral("class.odo-*")}).isEmpty());
    }

    void unequalViewsAreImportedWithAWarning()
    {
        const ProgramRun shorter =
            good("import %P --trial uneven --video A=%/a.mkv --video B=%/short.mkv --sync none --json");
        QCOMPARE(shorter.exitStatus, 0);
        QVERIFY2(shorter.err.contains("in common"), shorter.err);
        QVERIFY(!shorter.json().isEmpty()); // the warning did not spoil standard output
        const ProgramRun slower =
            good("import %P --trial slower --video A=%/a.mkv --video B=%/slow.mkv --sync none");
        QCOMPARE(slower.exitStatus, 0);
        QVERIFY2(slower.err.contains("frames/s"), slower.err);
        QCOMPARE(good("track %P slower --robot red").exitStatus, 0); // joined by time, not by frame
        const ProgramRun set = good("trial set %P slower --sync 0.25 --note moved --json");
        QCOMPARE(set.exitStatus, 0);
        const QJsonObject sync = set.json()[QStringLiteral("sync")].toObject();
        QCOMPARE(sync[QStringLiteral("method")].toString(), QStringLiteral("told"));
        QCOMPARE(sync[QStringLiteral("offset_s")].toDouble(), 0.25);
        QCOMPARE(set.json()[QStringLiteral("notes")].toString(), QStringLiteral("moved"));
        // both are one change, and neither is made where one fails
        QCOMPARE(runProgram(filled(QStringLiteral("trial set %P slower --sync 0.3 --name run1"))).exitStatus,
                 1);
        const QJsonObject shown = good("show %P slower --json").json()[QStringLiteral("sync")].toObject();
        QCOMPARE(shown[QStringLiteral("offset_s")].toDouble(), 0.25);
    }

    void aRobotThatCannotBeFollowedIsSaid()
    {
        QCOMPARE(good("import %P --trial leaving --video A=%/leaving.mkv --robot red").exitStatus, 0);
        const ProgramRun tracked = good("track %P leaving --json");
        QCOMPARE(tracked.exitStatus, 0);
        const QJsonArray warnings = tracked.json().value(QStringLiteral("warnings")).toArray();
        QCOMPARE(warnings.size(), 1);
        const QString sentence = warnings.first().toString();
        QVERIFY2(sentence.startsWith(
                     QStringLiteral("robot 'red' in trial 'leaving': no view sees it after 1.2 s")) &&
                     sentence.contains(QStringLiteral("; move or add a camera to cover the whole task")),
                 qPrintable(sentence));
        QCOMPARE(tracked.err, "odograph: " + sentence.toUtf8() + '\n');
        QCOMPARE(good("show %P leaving --json").json().value(QStringLiteral("warnings")).toArray(), warnings);

        QCOMPARE(good("robot add %P dull --colour #b5a898").exitStatus, 0);
        const ProgramRun dull = runProgram(filled(QStringLiteral("track %P leaving --robot dull")));
        QVERIFY2(dull.exitStatus == 1 && dull.err.count('\n') == 1, dull.err);
        QVERIFY2(
            dull.err.contains("robot 'dull' in trial 'leaving': its colour #b5a898 is also the floor's (") &&
                dull.err.contains("; put a plate of another colour on it, or set its true colour"),
            dull.err);
        QCOMPARE(good("robot add %P absent --colour #20c040").exitStatus, 0);
        const ProgramRun absent =
            runProgram(filled(QStringLiteral("track %P leaving --robot red --robot absent")));
        QCOMPARE(absent.exitStatus, 1);
        QCOMPARE(absent.err,
                 QByteArray("odograph: robot 'absent' in trial 'leaving': the robot was not found in any "
                            "frame of A; track only the robots that are in view (--robot)\n"));
    }

    void badCallsFailInOneLine_data()
    {
        beginBadCalls();
        const auto row = addBadCall;
        row("nonsense", 2, "neither a command nor a project");
        row("new", 2, "an argument is missing");
        row("new %P", 1, "already exists");
        row("new %/nowhere/x.odo", 1, "nowhere");
        row("new %/x.odo --title=", 1, "title of the project: it is empty; give the project a title");
        row("new %/x.odo --title=T\u202eitle", 1, "it holds an invisible character, U+202E");
        row("new %/x.odo --title=two\nlines", 1, "it holds a line break");
        row("demo", 2, "an argument is missing");
        row("demo %/a.mkv", 1, "demo");
        row("robot add %P blue --colour red", 2, "#rrggbb");
        row("robot add %P blue --colour #0000ff --height tall", 2, "not a length");
        row("robot add %P blue --colour #0000ff --size 26", 2, "AxB");
        row("robot add %P blue --reference 20", 2,
            "--reference '20' is not of the form FORWARD,LEFT, two numbers in millimetres");
        row("robot add %P blue --reference 20,x", 2, "two numbers in millimetres");
        row("robot add %P blue --reference 0,-10001", 1,
            "its reference point is more than 10 m from its centre");
        row("robot add %P blue --height free --reference 1,0", 1,
            "needs a heading, but a robot of changing height has none");
        row("robot add %P blue --colour #0000ff --pick %/a.mkv", 2, "two colours");
        row("robot add %P blue --pick %/a.mkv", 2, "--pick needs --box");
        row("robot add %P blue --pick %/a.mkv --box 1,2,3", 2, "not of the form x,y,w,h");
        row("robot add %P blue --pick %/a.mkv --box 1,2,3,-4", 2, "not of the form x,y,w,h");
        row("robot add %P blue --pick %/a.mkv --box 600,400,60,60 --frame one", 2, "not a whole number");
        row("robot add %P blue --pick %/a.mkv --box 600,400,60,60 --frame 60", 1, "choose one from 0 to 59");
        row("robot add %P blue --pick %/a.mkv --box 40,40,60,60", 1,
            "no colour that differs from the floor around it");
        row("robot add %P blue --pick %/nofile.mkv --box 600,400,60,60", 1, "the file does not exist");
        row("robot add %P red --colour #0000ff", 1, "red");
        row("robot drop %P red", 2, "not known");
        row("robot add %/missing.odo red --colour #0000ff", 1, "missing.odo");
        row("robot add %/foreign.odo red --colour #0000ff", 1, "foreign.odo");
        row("camera add %P A", 1, "A");
        row("camera add %P", 2, "an argument is missing");
        row("calibrate %P A %/nofile.png", 1, "the file does not exist");
        row("calibrate %P A %/noboard.png", 1, "board");
        row("calibrate %P A %/noboard.png --board 9", 2, "AxB");
        row("calibrate %P A %/noboard.png --square 0mm", 2, "length above zero");
        row("calibrate %P A %/noboard.png --model wide", 2, "standard, rational or fisheye");
        row("calibrate %P A %/novideo.mkv", 1, "calibration of camera 'A'");
        row("intrinsics import %P A %/broken.yaml", 1, "broken.yaml");
        row("intrinsics import %P A %/nofile.yaml", 1, "nofile.yaml");
        row("intrinsics export %P A %/out.yaml", 1, "never calibrated");
        row("intrinsics export %P nobody %/out.yaml", 1, "nobody");
        row("intrinsics move %P A %/out.yaml", 2, "neither import nor export");
        row("layout add %P floor %/layout.csv", 1, "floor");
        row("layout add %P other %/nofile.csv", 1, "nofile.csv");
        row("layout add %P other %/broken.csv", 1, "broken.csv");
        row("register %P --camera A", 2, "--layout is missing");
        row("register %P --camera A --layout nowhere --pixels %/three.csv", 1, "nowhere");
        row("register %P --camera A --layout floor --pixels %/three.csv", 1, "four");
        row("register %P --camera A --layout floor --pixels %/collinear.csv", 1, "line");
        row("register %P --camera A --layout floor --pixels %/doubled.csv", 1, "'O'");
        row("register %P --camera A --layout floor --pixels %/mirrored.csv", 1, "mirror");
        row("register %P --camera A --layout floor --pixels %/broken.csv", 1, "broken.csv:2");
        row("register %P --camera A --layout floor --image %/nofile.png", 1, "nofile.png");
        row("import %P --trial run1 --video A=%/a.mkv", 1, "already has a trial of that name");
        row("import %P --trial run2", 2, "--video");
        row("import %P --trial run2 --video %/a.mkv", 2, "NAME=VALUE");
        row("import %P --trial run2 --video A=%/nofile.mkv", 1, "the file does not exist");
        row("import %P --trial run2 --video A=%/novideo.mkv", 1, "novideo.mkv");
        row("import %P --trial run2 --video A=%/playlist.mkv", 1, "playlist.mkv");
        row("import %P --trial run2 --video A=%/a.mkv --video A=%/b.mkv", 1, "two videos");
        row("import %P --trial run2 --video A=%/a.mkv --video B=%/b.mkv --sync 100", 1, "do not overlap");
        row("import %P --trial run2 --video A=%/a.mkv --sync soon", 2, "--sync");
        row("import %P --trial run2 --video A=%/a.mkv --sync 1e300", 2,
            "--sync takes seconds from -3600 to 3600");
        row("import %P --trial run2 --video A=%/a.mkv --video B=%/b.mkv --sync=-3601", 2,
            "--sync takes seconds from -3600 to 3600");
        row("compare %P run1 run1 --align 1e300", 2, "--align takes seconds from -3600 to 3600");
        row("layout transform %P floor --turn 1e300", 2, "--turn takes degrees from -360 to 360");
        row("flag %P run1 --time 1e300 --spike", 2, "--time takes seconds");
        row("calibrate %P A %/noboard.png --board 1e300x1e300", 2, "up to 1,000,000");
        row("import %P --trial run2 --video A=%/a.mkv --video B=%/b.mkv --video C=%/b.mkv --sync 0.1", 1,
            "give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto");
        row("import %P --trial run2 --video A=%/a.mkv --robot blue", 1, "blue");
        row("import %P --trial run2 --video A=%/a.mkv --rate 0", 2, "--rate");
        row("trial set %P run1 --sync 100", 1, "do not overlap");
        row("trial set %P run1 --sync soon", 2, "--sync is auto, motion, flash, audio, none or seconds");
        row("trial set %P run1 --sync 0.1,0.2", 1, "the number of views is 2, the number of offsets 2");
        row("trial set %P run1 --sync flash", 1, "shows a flash of light");
        row("track %P run1 --robot blue", 1, "blue");
        row("track %P nowhere", 1, "nowhere");
        row("track %P run1 --smoother magic", 2, "--smoother");
        row("track %P", 2, "an argument is missing");
        row("track %P uneven --again --robot red", 1, "not been tracked yet");
        row("flag %P run1 --time 1", 2, "--spike");
        row("flag %P run1 --time 1 --spike --valid", 2, "--spike");
        row("flag %P run1 --spike", 2, "--time");
        row("flag %P run1 --time 1 --frame 3 --spike", 2, "--time");
        row("flag %P run1 --time soon --spike", 2, "--time");
        row("flag %P run1 --frame 3.5 --spike", 2, "whole number");
        row("flag %P run1 --time 77 --spike", 1, "this frame does not exist");
        row("flag %P run1 --frame 60 --valid", 1, "from 0 to 59");
        row("flag %P run1 --frame 12 --clear", 1, "no manual override");
        row("flag %P run1 --robot blue --frame 12 --spike", 1, "blue");
        row("flag %P uneven --frame 12 --spike", 1, "not been tracked yet");
        row("flag %P nowhere --frame 12 --spike", 1, "nowhere");
        row("list %/missing.odo", 1, "missing.odo");
        row("list %P --colour x", 2, "colour");
        row("show %P nowhere", 1, "nowhere");
        row("export %P run1", 2, "-o");
        row("export %P run1 -o %/nowhere/out.csv", 1, "nowhere");
        row("export %P run1 -o %/out.csv --format xls", 2, "--format");
        for (const char *format : {"csv", "json", "tum", "tracker", "video"})
            row((QByteArray("export %P run1 -o %/new.odo --format ") + format).constData(), 2,
                "only projects have a name ending in .odo; choose another name");
        row("snapshot %P run1 -o %/new.ODO", 2, "only projects have a name ending in .odo");
        row("layout export %P floor %/new.odo", 2, "only projects have a name ending in .odo");
        row("export %P run1 -o - --format video", 2, "a video needs a file");
        row("export %P run1 -o - --json", 2, "--json");
        row("export %P run1 -o %/out.csv --robot blue", 1, "blue");
        row("export %P uneven -o %/out.csv", 1, "track");
        row("export %P run1 -o %/out.mp4 --format video --speed 2", 2, "--speed");
        row("export %P run1 -o %/out.mp4 --format video --size 641x360", 2, "--size");
        row("export %P run1 -o %/out.mp4 --format video --theme pink", 2, "--theme");
        row("export %P run1 -o %/out.avi --format video", 1, ".mp4");
        row("export %P nothing -o %/out.mp4 --format video", 1, "nothing");
        row("snapshot %P run1", 2, "-o is missing");
        row("snapshot %P nowhere -o %/x.png", 1, "nowhere");
        row("snapshot %P run1 -o %/x.png --size 10x10", 2, "--size");
        row("snapshot %P run1 -o %/x.png --size 4001x4000", 2, "from 200x200 to 4000x4000");
        row("snapshot %P run1 -o %/nowhere/x.png", 1, "x.png");
        row("snapshot %P run1 -o %/x.png --mode dance", 2, "--mode");
        row("snapshot %P run1 -o %/x.txt", 2, ".png or .jpg");
        row("target checkerboard", 2, "-o is missing");
        row("target hexagon -o %/t.pdf", 2, "hexagon");
        row("target tags -o %/t.pdf --size 300mm", 1, "do not fit");
        row("check %/foreign.odo", 1, "foreign.odo");
    }

    void badCallsFailInOneLine() { badCallFailsInOneLine(); }

    /// And counts of one are singular.
    void answersGiveWhatIsStored()
    {
        const QString own = path("own.odo");
        const auto answer = [](const QStringList &arguments) {
            return QString::fromUtf8(runProgram(arguments).out).trimmed();
        };
        QCOMPARE(runProgram({u"new"_s, own}).exitStatus, 0);
        QCOMPARE(answer({u"robot"_s, u"add"_s, own, u"  trim me  "_s, u"--colour"_s, u"#0000ff"_s}),
                 u"Robot trim me added, colour #0000ff."_s);
        QCOMPARE(answer({u"camera"_s, u"add"_s, own, u" A "_s}), u"Camera A added."_s);
        QCOMPARE(answer({u"layout"_s, u"add"_s, own, u" floor "_s, path("layout.csv")}),
                 u"Layout floor has 4 markers."_s);
        QVERIFY(QDir().mkpath(path("own.media")));
        QFile stray(path("own.media/stray.txt"));
        QVERIFY(stray.open(QIODevice::WriteOnly));
        stray.close();
        const ProgramRun check = runProgram({u"check"_s, own});
        QCOMPARE(check.exitStatus, 1);
        QVERIFY2(check.err.contains(": 1 problem found; "), check.err.constData());
    }

    void anExportToStandardOutputIsTheFile()
    {
        for (const char *format : {"csv", "json", "tum", "tracker"}) {
            QCOMPARE(good((QByteArray("export %P run1 --force -o %/out.txt --format ") + format).constData())
                         .exitStatus,
                     0);
            const ProgramRun printed =
                good((QByteArray("export %P run1 -o - --format ") + format).constData());
            QCOMPARE(printed.exitStatus, 0);
            QVERIFY2(printed.err.isEmpty(), printed.err);
            QFile file(path("out.txt"));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(printed.out, file.readAll());
        }
        QVERIFY(!QFile::exists(QStringLiteral("-")));
    }

    void aRobotThatIsNotThereIsNotFound()
    {
        QCOMPARE(good("import %P --trial nobody --video A=%/empty.mkv --robot red").exitStatus, 0);
        const ProgramRun run = runProgram(filled(QStringLiteral("track %P nobody")));
        QCOMPARE(run.exitStatus, 1);
        QVERIFY2(run.err.contains("red"), run.err);
    }

    void aLostVideoIsNamed()
    {
        const QString media = path("class.media/uneven_A.mkv");
        QVERIFY(QFile::rename(media, media + QStringLiteral(".gone")));
        const ProgramRun run = runProgram(filled(QStringLiteral("track %P uneven --robot red")));
        QVERIFY(QFile::rename(media + QStringLiteral(".gone"), media));
        QCOMPARE(run.exitStatus, 1);
        QVERIFY2(run.err.contains("uneven_A.mkv"), run.err);
    }

    void aNewerProjectIsRefusedAndLeftAlone()
    {
        const QString newer = path("newer.odo");
        QVERIFY(QFile::copy(m_project, newer));
        // user_version: big-endian at offset 60 of the header (SQLite file format, section 1.3).
        QFile file(newer);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.seek(60));
        QCOMPARE(file.write(QByteArray::fromHex("000f4240")), 4);
        file.close();
        const QByteArray before = fileHash(newer);
        for (const char *line :
             {"list %/newer.odo", "track %/newer.odo run1", "robot add %/newer.odo x --colour #000001"}) {
            const ProgramRun run = runProgram(filled(QString::fromLatin1(line)));
            QCOMPARE(run.exitStatus, 1);
            QVERIFY2(run.err.contains("newer"), run.err);
            QCOMPARE(fileHash(newer), before);
        }
    }

    void aReadOnlyFolderIsSaid()
    {
        // Rights do not bind root, a file system mounted read-only does; a mount name space of its own keeps
        // it to this test. Where neither can be had the program cannot be shown a read-only folder.
        const QString folder = path("readonly");
        QVERIFY(QDir().mkpath(folder));
        QVERIFY(QFile::copy(m_project, folder + QStringLiteral("/class.odo")));
        const auto run = [&](const QString &line) {
            QString call =
                QStringLiteral(
                    "mount --bind \"$0\" \"$0\" && mount -o remount,bind,ro \"$0\" || exit 99; exec ") +
                qEnvironmentVariable("ODOGRAPH_PROGRAM") + u' ' +
                QString(line).replace(QStringLiteral("%R"), folder);
            return runCommand(QStringLiteral("unshare"), {QStringLiteral("-m"), QStringLiteral("sh"),
                                                          QStringLiteral("-c"), call, folder});
        };
        const ProgramRun list = run(QStringLiteral("list %R/class.odo --json"));
        if (list.exitStatus == 99 || list.exitStatus == -1 || list.err.contains("unshare"))
            QSKIP("no mount name space of its own here");
        QCOMPARE(list.exitStatus, 0); // looking is allowed
        QCOMPARE(list.json().value(QStringLiteral("title")).toString(), QStringLiteral("Lesson"));
        const QByteArray before = fileHash(folder + QStringLiteral("/class.odo"));
        for (const char *line :
             {"new %R/other.odo", "robot add %R/class.odo x --colour '#000001'", "track %R/class.odo run1",
              "demo %R/demo", "export %R/class.odo run1 -o %R/out.csv"}) {
            const ProgramRun refused = run(QString::fromLatin1(line));
            QVERIFY2(refused.exitStatus == 1, line);
            QVERIFY2(refused.err.startsWith("odograph: ") && refused.err.count('\n') == 1, refused.err);
        }
        QCOMPARE(fileHash(folder + QStringLiteral("/class.odo")), before);
        QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden),
                 QStringList(QStringLiteral("class.odo")));
    }

    /// Another name would be used in its place.
    void aNameThatIsNotUtf8IsRefused_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::newRow("project") << QStringLiteral("list $'%1/caf\\xe9/P.odo'");
        QTest::newRow("new project") << QStringLiteral("new $'%1/n\\xe9.odo'");
        QTest::newRow("output") << QStringLiteral("export %1/class.odo run1 -o $'%1/o\\xe9.csv'");
        QTest::newRow("window") << QStringLiteral("$'%1/caf\\xe9/P.odo'");
    }
    void aNameThatIsNotUtf8IsRefused()
    {
        QFETCH(QString, arguments);
        const QStringList before = QDir(m_folder.path()).entryList();
        const ProgramRun run = runCommand(QStringLiteral("bash"),
                                          {QStringLiteral("-c"), QStringLiteral("\"$ODOGRAPH_PROGRAM\" ") +
                                                                     arguments.arg(m_folder.path())});
        QCOMPARE(run.exitStatus, 2);
        QVERIFY2(run.err.endsWith("': it is not valid UTF-8; rename the file or folder\n") &&
                     run.err.count('\n') == 1,
                 run.err);
        QVERIFY2(run.err.contains("\\xe9"), run.err);
        QCOMPARE(QDir(m_folder.path()).entryList(), before);
    }

    void helpAndVersionAnswer()
    {
        QCOMPARE(runProgram({QStringLiteral("--version")}).out.trimmed(),
                 QByteArray("odograph " ODOGRAPH_VERSION));
        const ProgramRun help = runProgram({QStringLiteral("track"), QStringLiteral("--help")});
        QCOMPARE(help.exitStatus, 0);
        QVERIFY(help.out.contains("--smoother"));
        QCOMPARE(runProgram({QStringLiteral("help"), QStringLiteral("track")}).out, help.out);
        QCOMPARE(runProgram({QStringLiteral("help"), QStringLiteral("trac")}).exitStatus, 2);
    }
};

ODOGRAPH_TEST(TestCommandLine, QCoreApplication)
#include "tst_command_line.moc"
