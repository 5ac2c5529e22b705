// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;
using namespace odo::test;
using namespace Qt::StringLiterals;

/// Recordings of more than one file, on the command line to the letter.
class TestImportManyFilesCommand : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const QString &name) const { return m_folder.filePath(name); }
    ProgramRun import(const QString &trial, const QStringList &options) const
    {
        return runProgram(QStringList{u"import"_s, path(u"class.odo"_s), u"--trial"_s, trial} + options);
    }
    QByteArray errorOf(const QStringList &options) const
    {
        const ProgramRun done = import(u"refused"_s, options);
        return done.exitStatus == 0 ? QByteArray("no error")
                                    : QByteArray(done.err).replace((path({}) + u"/"_s).toUtf8(), "");
    }

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(runProgram({u"new"_s, path(u"class.odo"_s)}).exitStatus, 0);
        for (const QString &name : {u"1.mp4"_s, u"2.mp4"_s})
            QVERIFY(writeCoded(path(name).toStdString(), evenTimes(25, 25), {}).isEmpty());
        QVERIFY(QDir().mkpath(path(u"p"_s)));
        for (int i = 1; i < 4; ++i)
            QVERIFY(writeImage(rampFrame(), OutputTarget(path(u"p/%1.png"_s.arg(i)).toStdString())));
        std::ofstream table(path(u"stamps.csv"_s).toStdString());
        for (int i = 0; i < 25; ++i)
            table << 20 * i << "\n";
    }
    void joinsChapters()
    {
        const ProgramRun done =
            import(u"chapters"_s, {u"--video"_s, u"A="_s + path(u"1.mp4+2.mp4"_s), u"--json"_s});
        QCOMPARE(done.exitStatus, 0);
        QCOMPARE(done.err, QByteArray());
        const QJsonObject view = done.json()[u"views"_s][u"A"_s].toObject();
        QCOMPARE(view[u"frames"_s].toInt(), 50);
        QCOMPARE(view[u"duration_s"_s].toDouble(), 2.0);
        QCOMPARE(
            errorOf({u"--video"_s, u"A="_s + path(u"1.mp4"_s), u"--video"_s, u"A="_s + path(u"2.mp4"_s)}),
            QByteArray("odograph: import of trial 'refused': camera 'A' was given two videos; give each "
                       "view a camera of its own, or join the files of one recording with +, like "
                       "--video A=1.mp4+2.mp4\n"));
    }
    void takesImages()
    {
        const ProgramRun done = import(
            u"images"_s, {u"--video"_s, u"A="_s + path(u"p/%d.png"_s), u"--rate"_s, u"50"_s, u"--json"_s});
        QCOMPARE(done.exitStatus, 0);
        QCOMPARE(done.json()[u"views"_s][u"A"_s][u"frames"_s].toInt(), 3);
        QCOMPARE(errorOf({u"--video"_s, u"A="_s + path(u"p"_s)}),
                 QByteArray("odograph: 'p': images have no times; give their rate or a table of their "
                            "times, like --rate 30 or --times A=stamps.csv\n"));
    }
    void takesTimes()
    {
        const QStringList call{u"--video"_s, u"A="_s + path(u"1.mp4"_s), u"--times"_s,
                               u"A="_s + path(u"stamps.csv"_s)};
        QCOMPARE(errorOf(call),
                 QByteArray("odograph: stamps.csv:1: if its times are seconds, the rows are 20.0 s apart and "
                            "the run is 480 s long; give their unit, likely --time-unit ms (s, ms, us, ns, "
                            "min, h, d or frame)\n"));
        const ProgramRun done =
            import(u"times"_s, call + QStringList{u"--time-unit"_s, u"ms"_s, u"--json"_s});
        QCOMPARE(done.exitStatus, 0);
        QVERIFY(std::abs(done.json()[u"views"_s][u"A"_s][u"fps"_s].toDouble() - 50) < 1e-6);
        QVERIFY(errorOf({u"--video"_s, u"A="_s + path(u"1.mp4"_s), u"--time-unit"_s, u"ms"_s})
                    .startsWith("odograph: import: --time-unit needs --track; "));
        QVERIFY(errorOf({u"--track"_s, u"R=x.tum"_s, u"--times"_s, u"A=stamps.csv"_s})
                    .startsWith("odograph: import: --track goes with --trial, --team and --task, not with "
                                "--times; "));
    }
};

ODOGRAPH_TEST(TestImportManyFilesCommand, QCoreApplication)
#include "tst_import_many_files.moc"
