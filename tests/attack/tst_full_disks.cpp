// SPDX-License-Identifier: GPL-3.0-or-later
// Disks of twenty sizes, on each of which another step of a lesson finds no room: it is refused by a line
// with the system's reason, and the project is as it was. Needs the right to mount a disk in memory (root in
// a namespace of its own).
#include "tests/attack/attacked.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestFullDisks : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        const auto file = storeExample(m_folder.path().toStdString());
        QVERIFY(file);
        if (runCommand(QStringLiteral("unshare"), {QStringLiteral("-m"), QStringLiteral("true")})
                .exitStatus != 0)
            QSKIP("no disk can be mounted here");
    }

    void whatFindsNoRoomIsRefused_data()
    {
        QTest::addColumn<int>("freeKb");
        constexpr int sample = 5, sizes = 20;
        for (int i = 0; i < sizes; ++i) {
            if (isWanted(i, sample))
                QTest::addRow("%d KB free", i * i * 8) << i * i * 8;
        }
    }
    void whatFindsNoRoomIsRefused()
    {
        QFETCH(int, freeKb);
        // Each step says what it is and how it ended; its words stand before.
        const QByteArray script = R"sh(
            disk=$1; from=$2; free=$3; program=$ODOGRAPH_PROGRAM
            mkdir -p "$disk"; used=$(du -sk "$from/example.odo" "$from/example.media" | awk '{s+=$1} END {print s}')
            mount -t tmpfs -o size=$((used + 64 + free))k none "$disk" || exit 99
            cp -r "$from/example.odo" "$from/example.media" "$disk/" || exit 98
            video=$(ls "$from"/example.media/*.mkv | head -1)
            step() { name=$1; shift; "$@" >/dev/null 2>"$from/words"; status=$?; lines=$(wc -l <"$from/words"); echo "$name|$status|$lines|$(head -c 300 "$from/words" | tr '\n' ' ')"; }
            cd "$disk"
            step robot "$program" robot add example.odo "new robot" --colour "#00aa00"
            step import "$program" import example.odo --trial imported --video "A=$video"
            step track "$program" track example.odo "Trial 1"
            step export "$program" export example.odo "Trial 1" -o out.csv
            step report "$program" report example.odo "Trial 1" -o out.pdf
            step new "$program" new other.odo
            step check "$program" check example.odo
            ls -A
        )sh";
        QFile file(m_folder.filePath(QStringLiteral("steps.sh")));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate) && file.write(script) == script.size());
        file.close();
        const ProgramRun run =
            runCommand(QStringLiteral("unshare"),
                       {QStringLiteral("-m"), QStringLiteral("bash"), file.fileName(),
                        m_folder.filePath(QStringLiteral("disk")), m_folder.path(), QString::number(freeKb)});
        QVERIFY2(run.exitStatus == 0, run.err.constData());
        for (const QByteArray &line : run.out.split('\n')) {
            const QByteArrayList parts = line.split('|');
            if (parts.size() < 4)
                continue;
            const int status = parts[1].toInt(), lines = parts[2].toInt();
            QVERIFY2(status == 0 || status == 1, line.constData());
            QVERIFY2(status == 0 || (lines == 1 && parts[3].startsWith("odograph: ") &&
                                     !parts[3].contains("nknown error")),
                     line.constData());
            if (parts[0] == "check") // only the video that the example lacks may be missed
                QVERIFY2(!parts[3].contains("damaged"), line.constData());
        }
        QVERIFY2(!run.out.contains(".part") && !run.out.contains("-journal"), run.out.constData());
    }

private:
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestFullDisks, QGuiApplication)
#include "tst_full_disks.moc"
