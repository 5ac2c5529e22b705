// SPDX-License-Identifier: GPL-3.0-or-later
// Runs on this machine: the emulated one records to a disk of its own, and its power is cut.
#include "core/video/video_reader.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <random>

using namespace odo;

namespace {

constexpr double mostMissingS = 2;
constexpr qint64 diskBytes = 64 << 20;
constexpr int cutsTogether = 10; ///< whose disks are looked at in one go
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
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("empty")));
        QCOMPARE(QProcess::execute(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                                   {QStringLiteral("new"), m_folder.filePath(QStringLiteral("empty/p.odo"))}),
                 0);
    }

    /// ODOGRAPH_POWER_CUTS says how many; each at a moment of its own.
    void atMostTheLastSecondsAreMissing()
    {
        bool isNumber = false;
        const int asked = qEnvironmentVariableIntValue("ODOGRAPH_POWER_CUTS", &isNumber),
                  cuts = isNumber ? asked : 3;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> moment(1.5, 4);
        for (int first = 0; first < cuts; first += cutsTogether) {
            m_recordedS.clear();
            for (int cut = first; cut < std::min(cuts, first + cutsTogether); ++cut) {
                recordAndCut(moment(random));
                if (m_skipped)
                    QSKIP("ODOGRAPH-SKIPPED: no test machine");
                if (QTest::currentTestFailed())
                    return;
            }
            lookAtTheDisks();
        }
        qInfo("of %d cuts the worst lost the last %.2f s", cuts, m_worstS);
    }

private:
    QString disk(std::size_t index) const { return m_folder.filePath(QStringLiteral("disk%1").arg(index)); }

    /// With an empty project on it.
    void makeDisk(const QString &file)
    {
        QFile image(file);
        QVERIFY(image.open(QIODevice::WriteOnly | QIODevice::Truncate) && image.resize(diskBytes));
        image.close();
        QCOMPARE(QProcess::execute(QStringLiteral("/sbin/mke2fs"),
                                   {QStringLiteral("-q"), QStringLiteral("-F"), QStringLiteral("-t"),
                                    QStringLiteral("ext4"), QStringLiteral("-d"),
                                    m_folder.filePath(QStringLiteral("empty")), file}),
                 0);
    }

    void recordAndCut(double afterS)
    {
        const QString image = disk(m_recordedS.size()), pidFile = m_folder.filePath(QStringLiteral("pid"));
        makeDisk(image);
        QProcess machine;
        machine.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        machine.start(vmFolder() + QStringLiteral("vm_run"),
                      {QStringLiteral("--or-skip"), QStringLiteral("--pid"), pidFile,
                       QStringLiteral("--disk"), image, QStringLiteral("/run/disk"),
                       vmFolder() + QStringLiteral("record_until_cut"), QStringLiteral("/run/disk")});
        double beganS = -1, nowS = -1;
        while (beganS < 0 || nowS < beganS + afterS) {
            QVERIFY2(machine.canReadLine() || machine.waitForReadyRead(patienceMs) || machine.canReadLine(),
                     "the machine does not record");
            while (machine.canReadLine()) {
                const QByteArray line = machine.readLine();
                m_skipped = m_skipped || line.startsWith("ODOGRAPH-SKIPPED");
                if (line.startsWith("alive "))
                    nowS = line.mid(6).trimmed().toDouble();
            }
            if (m_skipped)
                return void(machine.waitForFinished());
            if (beganS < 0)
                beganS = nowS;
        }
        QFile pid(pidFile);
        QVERIFY(pid.open(QIODevice::ReadOnly));
        QCOMPARE(kill(pid.readAll().trimmed().toInt(), SIGKILL), 0);
        QVERIFY(machine.waitForFinished(patienceMs));
        m_recordedS.push_back(nowS - beganS);
    }

    /// Another start of the machine repairs the disks as any computer does, and hands over what is on them.
    void lookAtTheDisks()
    {
        const QString found = m_folder.filePath(QStringLiteral("found"));
        QDir(found).removeRecursively();
        QVERIFY(QDir().mkpath(found));
        QStringList call{QStringLiteral("--module"), QString(), QStringLiteral("--out"), found};
        QString copying = QStringLiteral("true");
        for (std::size_t i = 0; i < m_recordedS.size(); ++i) {
            call << QStringLiteral("--disk") << disk(i) << QStringLiteral("/run/disk%1").arg(i);
            copying += QStringLiteral(" && cp -r /run/disk%1 %2/").arg(i).arg(found);
        }
        QCOMPARE(QProcess::execute(vmFolder() + QStringLiteral("vm_run"),
                                   call << QStringLiteral("bash") << QStringLiteral("-c") << copying),
                 0);
        for (std::size_t i = 0; i < m_recordedS.size(); ++i) {
            const QString folder = QStringLiteral("%1/disk%2/").arg(found).arg(i);
            QCOMPARE(QProcess::execute(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                                       {QStringLiteral("list"), folder + QStringLiteral("p.odo")}),
                     0);
            const QStringList videos =
                QDir(folder + QStringLiteral("p.media")).entryList({QStringLiteral("*.mkv")}, QDir::Files);
            QCOMPARE(videos.size(), 2);
            for (const QString &video : videos) {
                const double missingS =
                    m_recordedS[i] - lengthOf(folder + QStringLiteral("p.media/") + video);
                QVERIFY2(missingS <= mostMissingS, qPrintable(QStringLiteral("%1: of %2 s %3 are missing")
                                                                  .arg(video)
                                                                  .arg(m_recordedS[i])
                                                                  .arg(missingS)));
                m_worstS = std::max(m_worstS, missingS);
            }
        }
    }

    QTemporaryDir m_folder;
    std::vector<double> m_recordedS; ///< until the power was cut, of each disk
    double m_worstS = 0;
    bool m_skipped = false;
};

QTEST_GUILESS_MAIN(TestPowerCut)
#include "tst_power_cut.moc"
