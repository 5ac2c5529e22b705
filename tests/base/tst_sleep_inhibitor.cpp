// SPDX-License-Identifier: GPL-3.0-or-later
// The computer is kept awake as long as it should be: with a systemd-inhibit of the test's own, which notes
// how it was called and when it ended.
#include "core/base/platform/sleep_inhibitor.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestSleepInhibitor : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = qgetenv("PATH");
    }
    void cleanup() { qputenv("PATH", m_path); }

    void itIsHeldUntilItIsLetGo()
    {
        install("#!/bin/sh\n"
                "printf '%s\\n' \"$@\" > \"$0.called\"\n"
                "for command; do :; done\n" // the last argument
                "\"$command\"\n"            // waits for the end of its input
                "echo ended > \"$0.ended\"\n");
        {
            const auto held = SleepInhibitor::take("recording 'Trial 1'");
            QVERIFY(held);
            QTRY_VERIFY(read("called").contains("cat"));
            QCOMPARE(read("called"), QByteArray("--what=sleep:idle:handle-lid-switch\n--who=Odograph\n"
                                                "--why=recording 'Trial 1'\n--mode=block\ncat\n"));
            QVERIFY(!QFile::exists(file(QStringLiteral("ended"))));
        }
        QTRY_COMPARE(read("ended"), QByteArray("ended\n"));
        for (int i = 0; i < 20; ++i) // no descriptor and no child is left over
            QVERIFY(SleepInhibitor::take("again"));
    }
    void withoutSystemdThereIsNone()
    {
        qputenv("PATH", m_folder->path().toLocal8Bit()); // nothing is there
        QVERIFY(!SleepInhibitor::take("recording"));
    }
    /// As where no logind answers: nothing hangs, and letting go is no error.
    void oneThatEndsAtOnceDoesNoHarm()
    {
        install("#!/bin/sh\nexit 1\n");
        for (int i = 0; i < 5; ++i) {
            const auto held = SleepInhibitor::take("recording");
            QVERIFY(held);
        }
    }

private:
    QString file(const QString &ending) const
    {
        return m_folder->filePath(QStringLiteral("systemd-inhibit.") + ending);
    }
    QByteArray read(const char *ending) const
    {
        QFile noted(file(QString::fromLatin1(ending)));
        return noted.open(QIODevice::ReadOnly) ? noted.readAll() : QByteArray();
    }
    void install(const QByteArray &script) const
    {
        QFile program(m_folder->filePath(QStringLiteral("systemd-inhibit")));
        QVERIFY(program.open(QIODevice::WriteOnly) && program.write(script) == script.size());
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
        qputenv("PATH", m_folder->path().toLocal8Bit() + ':' + m_path);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QByteArray m_path;
};

ODOGRAPH_TEST(TestSleepInhibitor, QCoreApplication)
#include "tst_sleep_inhibitor.moc"
