// SPDX-License-Identifier: GPL-3.0-or-later
// Runs on this machine: the emulated one records to a disk of its own, and its power is cut.
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <optional>
#include <random>

using namespace odo;

namespace {

constexpr double mostMissingS = 2;
constexpr qint64 diskBytes = 64 << 20;
constexpr int patienceMs = 120000;

QString vmFolder()
{
    return qEnvironmentVariable("ODOGRAPH_SOURCE_DIR") + QStringLiteral("/tests/vm/");
}

/// Seconds from a picture to the last that can be read.
double lengthOf(const QString &file)
{
    auto reader = VideoReader::open(file.toStdString());
    if (!reader)
        return -1;
    double seconds = -1;
    for (auto frame = (*reader)->next(); frame && *frame; frame = (*reader)->next())
        seconds = toSeconds((*frame)->time);
    return seconds;
}

} // namespace

class TestPowerCut : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(QDir().mkpath(path("empty")));
        call(m_program, {QStringLiteral("new"), path("empty/p.odo")});
    }

    /// ODOGRAPH_POWER_CUTS says how many; each at a moment of its own.
    void atMostTheLastSecondsAreMissing()
    {
        bool isNumber = false;
        const int asked = qEnvironmentVariableIntValue("ODOGRAPH_POWER_CUTS", &isNumber),
                  cuts = isNumber ? asked : 3;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> moment(1.2, 3.5);
        for (int cut = 0; cut < cuts; ++cut) {
            makeDisk();
            const auto recordedS = recordAndCut(moment(random));
            if (m_skipped)
                QSKIP("ODOGRAPH-SKIPPED: no test machine");
            if (!recordedS)
                return;
            repairDisk();
            lookAtWhatIsThere(*recordedS);
            if (QTest::currentTestFailed())
                return;
        }
        qInfo("of %d cuts the worst lost the last %.2f s", cuts, m_worstS);
    }

private:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    static void call(const QString &program, const QStringList &arguments, int mostStatus = 0)
    {
        QProcess process;
        process.start(program, arguments);
        QVERIFY(process.waitForFinished(patienceMs));
        QVERIFY2(process.exitCode() <= mostStatus,
                 process.readAllStandardOutput() + process.readAllStandardError());
    }

    /// With an empty project on it.
    void makeDisk()
    {
        QFile image(m_disk);
        QVERIFY(image.open(QIODevice::WriteOnly | QIODevice::Truncate) && image.resize(diskBytes));
        image.close();
        call(QStringLiteral("/sbin/mke2fs"),
             {QStringLiteral("-qFt"), QStringLiteral("ext4"), QStringLiteral("-d"), path("empty"), m_disk});
    }

    /// As any computer does when it starts again: the journal is played, and the rest looked at.
    void repairDisk()
    {
        constexpr int corrected = 1;
        call(QStringLiteral("/sbin/e2fsck"), {QStringLiteral("-fy"), m_disk}, corrected);
        QDir(path("found")).removeRecursively();
        QVERIFY(QDir().mkpath(path("found")));
        call(QStringLiteral("/sbin/debugfs"),
             {QStringLiteral("-R"), QStringLiteral("rdump / ") + path("found"), m_disk});
    }

    /// How long it has recorded by the machine's own clock; nullopt when it did not.
    std::optional<double> recordAndCut(double afterS)
    {
        const QString pidFile = path("pid"), mount = QStringLiteral("/run/disk");
        QProcess machine;
        machine.start(vmFolder() + QStringLiteral("vm_run"),
                      {QStringLiteral("--or-skip"), QStringLiteral("--pid"), pidFile,
                       QStringLiteral("--disk"), m_disk, mount,
                       vmFolder() + QStringLiteral("record_until_cut"), mount});
        std::optional<double> beganS, nowS;
        const auto readLines = [&] {
            while (machine.canReadLine()) {
                const QByteArray line = machine.readLine();
                m_skipped = m_skipped || line.startsWith("ODOGRAPH-SKIPPED");
                if (line.startsWith("alive "))
                    nowS = line.mid(6).trimmed().toDouble();
            }
        };
        while (!beganS || *nowS < *beganS + afterS) {
            if (!machine.canReadLine() && !machine.waitForReadyRead(patienceMs) && !machine.canReadLine()) {
                QTest::qFail("the machine does not record:\n" + machine.readAllStandardError(), __FILE__,
                             __LINE__);
                return std::nullopt;
            }
            readLines();
            if (m_skipped) {
                machine.waitForFinished();
                return std::nullopt;
            }
            if (!beganS)
                beganS = nowS;
        }
        QFile pid(pidFile);
        if (!pid.open(QIODevice::ReadOnly) || kill(pid.readAll().trimmed().toInt(), SIGKILL) != 0)
            QTest::qFail("the machine could not be cut off", __FILE__, __LINE__);
        machine.waitForFinished(patienceMs);
        readLines(); // it lived on until it was cut
        return *nowS - *beganS;
    }

    void lookAtWhatIsThere(double recordedS)
    {
        call(m_program, {QStringLiteral("list"), path("found/p.odo")});
        const QStringList videos =
            QDir(path("found/p.media")).entryList({QStringLiteral("*.mkv")}, QDir::Files);
        QCOMPARE(videos.size(), 2);
        for (const QString &video : videos) {
            const double missingS = recordedS - lengthOf(path("found/p.media/") + video);
            QVERIFY2(
                missingS <= mostMissingS,
                qPrintable(
                    QStringLiteral("%1: of %2 s %3 are missing").arg(video).arg(recordedS).arg(missingS)));
            m_worstS = std::max(m_worstS, missingS);
        }
    }

    const QString m_program = qEnvironmentVariable("ODOGRAPH_PROGRAM");
    QTemporaryDir m_folder;
    const QString m_disk = m_folder.filePath(QStringLiteral("disk"));
    double m_worstS = 0;
    bool m_skipped = false;
};

ODOGRAPH_TEST(TestPowerCut, QCoreApplication)
#include "tst_power_cut.moc"
