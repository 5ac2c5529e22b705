// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_rescue.h"

#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

const std::string mounts = "/dev/sda1 / ext4 rw,relatime 0 0\n"
                           "tmpfs /tmp tmpfs rw 0 0\n"
                           "server:/class /mnt/class nfs4 rw 0 0\n"
                           "/dev/sdb1 /mnt/class/usb vfat rw 0 0\n"
                           "//nas/year /media/year\\0409 cifs rw 0 0\n";

} // namespace

class TestLocationWarning : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theInnermostMountCounts()
    {
        QCOMPARE(fileSystemOf("/home/anna/p.odo", mounts), std::string("ext4"));
        QCOMPARE(fileSystemOf("/mnt/class/p.odo", mounts), std::string("nfs4"));
        QCOMPARE(fileSystemOf("/mnt/classroom/p.odo", mounts), std::string("ext4"));
        QCOMPARE(fileSystemOf("/mnt/class/usb/p.odo", mounts), std::string("vfat"));
        QCOMPARE(fileSystemOf("/media/year 9/p.odo", mounts), std::string("cifs"));
        QCOMPARE(fileSystemOf("/p.odo", ""), std::string());
    }

    void aNetworkDiskIsToldOf()
    {
        const auto warning = locationWarning("/mnt/class/p.odo", mounts);
        QVERIFY(warning.has_value());
        QCOMPARE(warning->english(),
                 std::string(
                     "project 'p.odo': it is on a network disk (nfs4): a recording can stall there, and two "
                     "computers can damage it; keep it on a disk of this computer, and pack it to share it"));
        QVERIFY(!locationWarning("/mnt/class/usb/p.odo", mounts));
    }

    void aSyncedFolderIsToldOf_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<QString>("mark");
        QTest::addColumn<QString>("program");
        QTest::newRow("none") << QStringLiteral("Lessons/9b") << QString() << QString();
        QTest::newRow("Dropbox") << QStringLiteral("Dropbox/Lessons") << QString()
                                 << QStringLiteral("Dropbox");
        QTest::newRow("by its mark") << QStringLiteral("mine/Lessons")
                                     << QStringLiteral("mine/.dropbox.cache") << QStringLiteral("Dropbox");
        QTest::newRow("OneDrive") << QStringLiteral("OneDrive - School/9b") << QString()
                                  << QStringLiteral("OneDrive");
        QTest::newRow("Syncthing") << QStringLiteral("shared") << QStringLiteral("shared/.stfolder")
                                   << QStringLiteral("Syncthing");
    }
    void aSyncedFolderIsToldOf()
    {
        QFETCH(QString, folder);
        QFETCH(QString, mark);
        QFETCH(QString, program);
        const QTemporaryDir place;
        QVERIFY(QDir(place.path()).mkpath(folder));
        if (!mark.isEmpty())
            QVERIFY(QDir(place.path()).mkpath(mark));
        const auto warning =
            locationWarning(place.filePath(folder + QStringLiteral("/p.odo")).toStdString(), mounts);
        if (program.isEmpty()) {
            QVERIFY(!warning);
            return;
        }
        QVERIFY(warning.has_value());
        QCOMPARE(QString::fromStdString(warning->english()),
                 QStringLiteral(
                     "project 'p.odo': it is in a folder that %1 copies while it changes: a copy may contain "
                     "half a change; keep it on a disk of this computer, and pack it to share it")
                     .arg(program));
    }
};

ODOGRAPH_TEST(TestLocationWarning, QCoreApplication)
#include "tst_location_warning.moc"
