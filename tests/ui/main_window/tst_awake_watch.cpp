// SPDX-License-Identifier: GPL-3.0-or-later
// The window keeps the computer awake while it works, and no longer: with a systemd-inhibit of the test's
// own.
#include "tests/support/registered_test.h"
#include "ui/main_window/internal/awake_watch.h"

#include <QApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestAwakeWatch : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void itIsHeldWhileSomethingWorks()
    {
        QTemporaryDir folder;
        QFile program(folder.filePath(QStringLiteral("systemd-inhibit")));
        QVERIFY(program.open(QIODevice::WriteOnly) &&
                program.write("#!/bin/sh\necho held >> \"$0.calls\"\ncat\necho let go >> \"$0.calls\"\n"));
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", folder.path().toLocal8Bit() + ':' + path);
        const auto calls = [&folder] {
            QFile noted(folder.filePath(QStringLiteral("systemd-inhibit.calls")));
            return noted.open(QIODevice::ReadOnly) ? noted.readAll() : QByteArray();
        };
        bool isWorking = false;
        int looks = 0;
        const auto working = [&] {
            ++looks;
            return isWorking;
        };
        AwakeWatch watch(working);
        QTRY_COMPARE(looks, 1);
        QVERIFY(!watch.isHeld());
        isWorking = true;
        QTRY_VERIFY(watch.isHeld());
        QTRY_COMPARE(calls(), QByteArray("held\n"));
        QTRY_VERIFY(looks >= 4); // held once, not at each look
        QCOMPARE(calls(), QByteArray("held\n"));
        isWorking = false;
        QTRY_VERIFY(!watch.isHeld());
        QTRY_COMPARE(calls(), QByteArray("held\nlet go\n"));
        qputenv("PATH", folder.filePath(QStringLiteral("nowhere")).toLocal8Bit());
        isWorking = true;
        const int before = looks;
        QTRY_VERIFY(looks >= before + 2); // there is none, and nothing happens
        QVERIFY(!watch.isHeld());
        qputenv("PATH", path);
    }
};

ODOGRAPH_TEST(TestAwakeWatch, QApplication)
#include "tst_awake_watch.moc"
