// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/demo_lesson.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QPointF>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo::test;

/// The demo lesson through the command line: tracked, and compared with its known truth.
class TestDemo : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    QString m_project;
    QStringList m_trials;

    struct Truth
    {
        double timeS, xMm, yMm;
    };

    QList<Truth> truthOf(const QString &trial, const QString &robot) const
    {
        QFile file(m_folder.filePath(QStringLiteral("truth/%1_%2.csv").arg(trial, robot)));
        QList<Truth> truth;
        if (!file.open(QIODevice::ReadOnly))
            return truth;
        file.readLine();
        while (!file.atEnd()) {
            const QList<QByteArray> cells = file.readLine().split(',');
            truth.append({cells[0].toDouble(), cells[1].toDouble(), cells[2].toDouble()});
        }
        return truth;
    }

    /// When the truth passes a gate from left to right; straight and even between two frames, which errs by
    /// some 0.5 ms at most (4 m/s² for 33 ms at 1 m/s).
    static QList<double> passagesOf(const QJsonObject &gate, const QList<Truth> &truth)
    {
        const auto point = [&](const char *key) {
            const QJsonArray numbers = gate.value(QLatin1String(key)).toArray();
            return QPointF(numbers[0].toDouble(), numbers[1].toDouble());
        };
        const QPointF from = point("from_mm"), way = point("to_mm") - from;
        const double length = std::hypot(way.x(), way.y());
        const QPointF across(way.y() / length, -way.x() / length);
        QList<double> times;
        for (qsizetype i = 1; i < truth.size(); ++i) {
            const Truth &a = truth[i - 1], &b = truth[i];
            const double before = across.x() * (a.xMm - from.x()) + across.y() * (a.yMm - from.y());
            const double past = across.x() * (b.xMm - from.x()) + across.y() * (b.yMm - from.y());
            if (before > 0 || past <= 0)
                continue;
            const double part = before / (before - past);
            const QPointF at(a.xMm + part * (b.xMm - a.xMm), a.yMm + part * (b.yMm - a.yMm));
            const double along = QPointF::dotProduct(at - from, way) / length;
            if (along >= 0 && along <= length)
                times << a.timeS + part * (b.timeS - a.timeS);
        }
        return times;
    }

private Q_SLOTS:
    void initTestCase()
    {
        const QString problem = provideDemoLesson(m_folder.path());
        QVERIFY2(problem.isEmpty(), qPrintable(problem));
        m_project = m_folder.filePath(QStringLiteral("demo.odo"));
        const ProgramRun list = runProgram({QStringLiteral("list"), m_project, QStringLiteral("--json")});
        QCOMPARE(list.exitStatus, 0);
        for (const QJsonValue &trial : list.json().value(QStringLiteral("trials")).toArray())
            m_trials << trial.toObject().value(QStringLiteral("name")).toString();
        QVERIFY(m_trials.size() >= 4);
    }

    void everyTrialTracksWithinTheBounds()
    {
        for (const QString &trial : m_trials) {
            const ProgramRun track =
                runProgram({QStringLiteral("track"), m_project, trial, QStringLiteral("--json")});
            QVERIFY2(track.exitStatus == 0, track.err);
            const ProgramRun show =
                runProgram({QStringLiteral("show"), m_project, trial, QStringLiteral("--json")});
            QVERIFY2(show.exitStatus == 0, show.err);
            const QJsonObject robots = show.json().value(QStringLiteral("robots")).toObject();
            QVERIFY(!robots.isEmpty());
            for (const QString &robot : robots.keys()) {
                const QJsonObject truth =
                    robots.value(robot).toObject().value(QStringLiteral("truth")).toObject();
                const double compared = truth.value(QStringLiteral("compared")).toDouble();
                const double positionMm = truth.value(QStringLiteral("position_rms_mm")).toDouble(1e9);
                const double velocityMmS = truth.value(QStringLiteral("velocity_rms_mm_s")).toDouble(1e9);
                qInfo("%s / %s: %.0f samples, position %.2f mm, velocity %.1f mm/s, acceleration %.0f mm/s2; "
                      "inside 95 %%: x "
                      "%.3f y %.3f speed %.3f",
                      qPrintable(trial), qPrintable(robot), compared, positionMm, velocityMmS,
                      truth.value(QStringLiteral("acceleration_rms_mm_s2")).toDouble(),
                      truth.value(QStringLiteral("inside_95_x")).toDouble(),
                      truth.value(QStringLiteral("inside_95_y")).toDouble(),
                      truth.value(QStringLiteral("inside_95_speed")).toDouble());
                // At least 95 % of the frames must carry a figure, or a good RMS could be had by leaving out
                // the rest.
                const double frames = track.json()
                                          .value(QStringLiteral("robots"))
                                          .toObject()
                                          .value(robot)
                                          .toObject()
                                          .value(QStringLiteral("frames"))
                                          .toDouble();
                QVERIFY2(frames >= 150 && compared >= 0.95 * frames, qPrintable(trial));
                QVERIFY2(positionMm <= 10.0, qPrintable(trial));
                QVERIFY2(velocityMmS <= 40.0, qPrintable(trial));
            }
        }
    }

    void theRoverWithoutAColourIsMeasured()
    {
        const ProgramRun track = runProgram({QStringLiteral("track"), m_project,
                                             QStringLiteral("circle with rover"), QStringLiteral("--json")});
        QVERIFY2(track.exitStatus == 0, track.err);
        const QJsonObject tracked = track.json()
                                        .value(QStringLiteral("robots"))
                                        .toObject()
                                        .value(QStringLiteral("Rover 4"))
                                        .toObject();
        QCOMPARE(tracked.value(QStringLiteral("look")).toString(), QStringLiteral("any"));
        QCOMPARE(tracked.value(QStringLiteral("tracked")).toDouble(),
                 tracked.value(QStringLiteral("frames")).toDouble());
        const QJsonObject rover = runProgram({QStringLiteral("show"), m_project,
                                              QStringLiteral("circle with rover"), QStringLiteral("--json")})
                                      .json()
                                      .value(QStringLiteral("robots"))
                                      .toObject()
                                      .value(QStringLiteral("Rover 4"))
                                      .toObject();
        const QJsonObject truth = rover.value(QStringLiteral("truth")).toObject();
        // What docs/accuracy.md demands of robots of any look, and has of all but the hardest scenes.
        QVERIFY(truth.value(QStringLiteral("position_rms_mm")).toDouble(1e9) <= 5);
        QVERIFY(truth.value(QStringLiteral("inside_95_x")).toDouble() >= 0.9 &&
                truth.value(QStringLiteral("inside_95_y")).toDouble() >= 0.9);
        QVERIFY(rover.value(QStringLiteral("spikes")).toArray().isEmpty());
    }

    void reflectionsThatJoinTheOutlineAreFlagged()
    {
        // Seen by both cameras from 3.25 to 3.34 s and from 7.88 to 7.96 s: two to four frames each. Nothing
        // else is a spike.
        const QJsonObject robots =
            runProgram({QStringLiteral("show"), m_project, QStringLiteral("figure-eight with reflections"),
                        QStringLiteral("--json")})
                .json()
                .value(QStringLiteral("robots"))
                .toObject();
        const QJsonArray spikes = robots.begin().value().toObject().value(QStringLiteral("spikes")).toArray();
        int first = 0, second = 0;
        for (const QJsonValue &spike : spikes) {
            const double timeS = spike.toObject().value(QStringLiteral("t_s")).toDouble();
            const QString reason = spike.toObject().value(QStringLiteral("reason")).toString();
            qInfo("spike at %.3f s: %s", timeS, qPrintable(reason));
            QVERIFY(!reason.isEmpty());
            first += timeS > 3.2 && timeS < 3.4;
            second += timeS > 7.83 && timeS < 8.0;
        }
        QVERIFY(first >= 2 && second >= 2);
        QCOMPARE(first + second, int(spikes.size()));
    }

    void timesAtTheGatesAreThoseOfTheTruth()
    {
        const QJsonArray tasks =
            runProgram({QStringLiteral("task"), QStringLiteral("list"), m_project, QStringLiteral("--json")})
                .json()
                .value(QStringLiteral("tasks"))
                .toArray();
        QVERIFY(tasks.size() >= 4);
        int checked = 0;
        for (const QString &trial : m_trials) {
            const QJsonObject shown =
                runProgram({QStringLiteral("show"), m_project, trial, QStringLiteral("--json")}).json();
            const QString name = shown.value(QStringLiteral("task")).toString();
            const auto task = std::find_if(tasks.begin(), tasks.end(), [&](const QJsonValue &one) {
                return one.toObject().value(QStringLiteral("name")).toString() == name;
            });
            QVERIFY2(task != tasks.end(), qPrintable(name));
            const QString robot = shown.value(QStringLiteral("robots")).toObject().keys().first();
            const QJsonObject measured =
                shown.value(QStringLiteral("robots")).toObject().value(robot).toObject();
            const QList<Truth> truth = truthOf(trial, robot);
            QVERIFY(measured.value(QStringLiteral("laps")).toArray().size() >= 1);
            for (const QJsonValue &gate : task->toObject().value(QStringLiteral("gates")).toArray()) {
                const QList<double> wanted = passagesOf(gate.toObject(), truth);
                QList<QJsonObject> found;
                for (const QJsonValue &passage : measured.value(QStringLiteral("gates")).toArray()) {
                    if (passage.toObject().value(QStringLiteral("name")) ==
                        gate.toObject().value(QStringLiteral("name")))
                        found << passage.toObject();
                }
                QCOMPARE(found.size(), wanted.size());
                for (qsizetype i = 0; i < wanted.size(); ++i) {
                    const double error = found[i].value(QStringLiteral("time_s")).toDouble() - wanted[i];
                    const double sigma = found[i].value(QStringLiteral("sigma_s")).toDouble();
                    qInfo("%s: gate %s at %.4f s, error %.2f ms, stated %.2f ms", qPrintable(trial),
                          qPrintable(found[i].value(QStringLiteral("name")).toString()), wanted[i],
                          1e3 * error, 1e3 * sigma);
                    QVERIFY(std::abs(error) < 0.005 && std::abs(error) < 4 * sigma);
                    ++checked;
                }
            }
        }
        QVERIFY(checked >= 10);
    }

    void twoRunsOfOneTaskAreCompared()
    {
        const QStringList call{QStringLiteral("compare"), m_project, QStringLiteral("figure-eight"),
                               QStringLiteral("figure-eight with reflections")};
        const ProgramRun run = runProgram(call + QStringList{QStringLiteral("--json")});
        QVERIFY2(run.exitStatus == 0, run.err);
        const QJsonObject answer = run.json();
        QCOMPARE(answer.keys(), QStringList({QStringLiteral("aligned_by"), QStringLiteral("delta_t_s"),
                                             QStringLiteral("distance_m"), QStringLiteral("metrics"),
                                             QStringLiteral("ranges"), QStringLiteral("verdicts")}));
        QCOMPARE(answer.value(QStringLiteral("aligned_by")).toString(), QStringLiteral("start_gate"));
        const QJsonArray distances = answer.value(QStringLiteral("distance_m")).toArray(),
                         differences = answer.value(QStringLiteral("delta_t_s")).toArray();
        QCOMPARE(distances.size(), differences.size());
        // Round the task's eight the laps take 5.2 s and 6.0 s, half a lap half as long.
        const auto x = [](double angle) {
            return QPointF(1.05 * std::sin(angle), 0.6 * std::sin(2 * angle));
        };
        double lapM = 0;
        for (int i = 0; i < 10000; ++i) {
            const QPointF step = x((i + 1) * M_PI / 5000) - x(i * M_PI / 5000);
            lapM += std::hypot(step.x(), step.y());
        }
        QVERIFY(distances.last().toDouble() > lapM);
        for (qsizetype i = 0; i < distances.size(); ++i) {
            for (const double laps : {0.5, 1.0}) {
                // A station is off by 5 mm at most, where 10 mm are 1 ms of difference; the gates are known
                // to 0.5 ms.
                if (std::abs(distances[i].toDouble() - laps * lapM) <= 0.005)
                    QVERIFY2(std::abs(differences[i].toDouble() - laps * 0.8) < 0.004,
                             qPrintable(QString::number(differences[i].toDouble())));
            }
        }
        QSet<QString> significant;
        const QJsonArray metrics = answer.value(QStringLiteral("metrics")).toArray();
        for (const QJsonValue &each : metrics) {
            const QJsonObject metric = each.toObject();
            QCOMPARE(metric.keys(),
                     QStringList({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("difference"),
                                  QStringLiteral("name"), QStringLiteral("sigma"),
                                  QStringLiteral("significant"), QStringLiteral("unit")}));
            const auto at = [&](const char *key) { return metric.value(QLatin1String(key)).toDouble(1e9); };
            QVERIFY(std::abs(at("difference") - (at("b") - at("a"))) < 1e-9);
            QCOMPARE(metric.value(QStringLiteral("significant")).toBool(),
                     std::abs(at("difference")) > 1.96 * at("sigma"));
            if (metric.value(QStringLiteral("significant")).toBool())
                significant.insert(metric.value(QStringLiteral("name")).toString());
        }
        QVERIFY(significant.contains(QStringLiteral("best_lap")) &&
                significant.contains(QStringLiteral("max_speed")));
        QVERIFY(!significant.contains(QStringLiteral("laps")) &&
                !significant.contains(QStringLiteral("duration")));

        const ProgramRun turned = runProgram({call[0], call[1], call[3], call[2], QStringLiteral("--align"),
                                              QStringLiteral("motion_onset"), QStringLiteral("--json")});
        QCOMPARE(turned.json().value(QStringLiteral("aligned_by")).toString(),
                 QStringLiteral("motion_onset"));
        QVERIFY(turned.json().value(QStringLiteral("delta_t_s")).toArray().last().toDouble() < -0.8);
        QVERIFY(runProgram(call).out.contains("not significant"));
    }

    void whatCannotBeComparedIsSaidInOneLine()
    {
        const auto error = [&](const QStringList &arguments, int status) {
            const ProgramRun run = runProgram(QStringList{QStringLiteral("compare"), m_project} + arguments);
            const bool isOneLine = run.out.isEmpty() && run.err.count('\n') == 1;
            return run.exitStatus == status && isOneLine
                       ? QString::fromUtf8(run.err)
                       : QStringLiteral("exit status %1").arg(run.exitStatus);
        };
        const QString eight = QStringLiteral("figure-eight"),
                      other = QStringLiteral("figure-eight with reflections");
        QVERIFY(error({eight, eight}, 1)
                    .contains(QLatin1String("a run cannot be compared with itself; choose another one")));
        QVERIFY(error({eight, QStringLiteral("nothing")}, 1).contains(QLatin1String("nothing")));
        QVERIFY(error({eight, other, QStringLiteral("--robot"), QStringLiteral("Pink")}, 1)
                    .contains(QLatin1String(
                        "robot 'Pink' was not tracked in it, only 'Green 3'; track it, or choose another")));
        QVERIFY(error({eight, other, QStringLiteral("--align"), QStringLiteral("north")}, 2)
                    .contains(QLatin1String("--align is auto")));
        QVERIFY(error({eight, other, QStringLiteral("-o"), QStringLiteral("/nowhere/report.pdf")}, 1)
                    .contains(QLatin1String("does not exist")));
        QVERIFY(error({eight}, 2).contains(QLatin1String("compare")));
    }

    void theClipsOffsetIsFoundFromTheMotion()
    {
        // Told when the demo was made: the truth. 3 ms is a tenth of a frame, 3 mm at 1 m/s.
        for (const QString &trial : {QStringLiteral("figure-eight"), QStringLiteral("stop-and-go")}) {
            const QJsonObject told =
                runProgram({QStringLiteral("show"), m_project, trial, QStringLiteral("--json")}).json();
            const QString robot = told.value(QStringLiteral("robots")).toObject().keys().first();
            QStringList call{QStringLiteral("import"),  m_project,
                             QStringLiteral("--trial"), trial + QStringLiteral(" again"),
                             QStringLiteral("--robot"), robot,
                             QStringLiteral("--sync"),  QStringLiteral("auto"),
                             QStringLiteral("--json")};
            for (const QString &camera : {QStringLiteral("A"), QStringLiteral("B")})
                call << QStringLiteral("--video")
                     << camera + u'=' +
                            m_folder.filePath(QStringLiteral("demo.media/%1_%2.mkv").arg(trial, camera));
            const ProgramRun run = runProgram(call);
            QVERIFY2(run.exitStatus == 0, run.err);
            const QJsonObject sync = run.json().value(QStringLiteral("sync")).toObject();
            QCOMPARE(sync.value(QStringLiteral("method")).toString(), QStringLiteral("auto"));
            const double truth =
                told.value(QStringLiteral("sync")).toObject().value(QStringLiteral("offset_s")).toDouble();
            const double found = sync.value(QStringLiteral("offset_s")).toDouble(1e9);
            qInfo("%s: offset %.4f s, truth %.4f s", qPrintable(trial), found, truth);
            QVERIFY(std::abs(found - truth) <= 0.003);
        }
    }

    void exportHasARowForEachFrame()
    {
        const QString file = m_folder.filePath(QStringLiteral("run.csv"));
        const ProgramRun run =
            runProgram({QStringLiteral("export"), m_project, m_trials.first(), QStringLiteral("-o"), file});
        QVERIFY2(run.exitStatus == 0, run.err);
        QFile csv(file);
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = csv.readAll().trimmed().split('\n');
        QCOMPARE(
            lines.first(),
            QByteArray("t_s,x_mm,y_mm,vx_mm_s,vy_mm_s,speed_mm_s,ax_mm_s2,ay_mm_s2,accel_mm_s2,sigma_x_mm,"
                       "sigma_y_mm,sigma_speed_mm_s,sigma_accel_mm_s2,raw_x_mm,raw_y_mm,views,flags"));
        const ProgramRun show =
            runProgram({QStringLiteral("show"), m_project, m_trials.first(), QStringLiteral("--json")});
        const QJsonObject views = show.json().value(QStringLiteral("views")).toObject();
        QCOMPARE(lines.size() - 1,
                 views.value(QStringLiteral("A")).toObject().value(QStringLiteral("frames")).toInt());
    }

    void snapshotsHaveTheSizeAskedFor()
    {
        for (const QString &mode : {QStringLiteral("review"), QStringLiteral("compare"),
                                    QStringLiteral("history"), QStringLiteral("testbed")}) {
            const QString file = m_folder.filePath(mode + QStringLiteral(".png"));
            const ProgramRun run = runProgram({QStringLiteral("snapshot"), m_project, m_trials.first(),
                                               QStringLiteral("-o"), file, QStringLiteral("--mode"), mode,
                                               QStringLiteral("--size"), QStringLiteral("1366x768")});
            QVERIFY2(run.exitStatus == 0, run.err);
            QCOMPARE(QImage(file).size(), QSize(1366, 768));
        }
    }

    void checkFindsNothingUntilARecordingIsLost()
    {
        const ProgramRun sound = runProgram({QStringLiteral("check"), m_project, QStringLiteral("--json")});
        QVERIFY2(sound.exitStatus == 0, sound.err);
        QCOMPARE(sound.json().value(QStringLiteral("ok")).toBool(), true);

        const QDir media(m_folder.filePath(QStringLiteral("demo.media")));
        const QString video = media.filePath(media.entryList(QDir::Files).first()),
                      elsewhere = m_folder.filePath(QStringLiteral("elsewhere.mkv"));
        QVERIFY(QFile::rename(video, elsewhere));
        const ProgramRun lost = runProgram({QStringLiteral("check"), m_project, QStringLiteral("--json")});
        QVERIFY(QFile::rename(elsewhere, video));
        QCOMPARE(lost.exitStatus, 1);
        QCOMPARE(lost.json().value(QStringLiteral("ok")).toBool(true), false);
        QCOMPARE(lost.json().value(QStringLiteral("problems")).toArray().size(), 1);
    }

    void aSecondDemoInTheSameFolderIsRefused()
    {
        const QByteArray before = fileHash(m_project);
        const ProgramRun run = runProgram({QStringLiteral("demo"), m_folder.path()});
        QCOMPARE(run.exitStatus, 1);
        QVERIFY(run.err.contains("already exists"));
        QCOMPARE(fileHash(m_project), before);
    }
};

ODOGRAPH_TEST(TestDemo, QCoreApplication)
#include "tst_demo.moc"
