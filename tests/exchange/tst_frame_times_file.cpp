// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/frame_times_file.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;

/// Tables of when the frames of a video were taken.
class TestFrameTimesFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void reads_data();
    void reads();
    void refuses_data();
    void refuses();
    void aPersonSaysTheUnit();

private:
    std::filesystem::path written(const std::string &content) const
    {
        std::filesystem::path file = std::filesystem::path(m_folder.path().toStdString()) / "t.csv";
        std::ofstream(file, std::ios::binary) << content;
        return file;
    }
    /// Twelve rows, 40 ms apart; line: what a row is, of the number and the time in seconds.
    template <class Line>
    static std::string rows(const std::string &header, const Line &line)
    {
        std::string text = header;
        for (int i = 0; i < 12; ++i)
            text += line(i, i * 0.04) + "\n";
        return text;
    }
    QTemporaryDir m_folder;
};

void TestFrameTimesFile::reads_data()
{
    QTest::addColumn<QString>("content");
    const auto fixed = [](double value, int decimals) {
        return QString::number(value, 'f', decimals).toStdString();
    };
    const auto add = [](const char *name, const std::string &content) {
        QTest::newRow(name) << QString::fromStdString(content);
    };
    add("seconds", rows("t_s\n", [&](int, double t) { return fixed(5 + t, 3); }));
    add("frame and time",
        rows("frame,timestamp\n", [&](int i, double t) { return std::to_string(i) + "," + fixed(t, 6); }));
    add("milliseconds by name", rows("time_ms;x\n", [&](int, double t) { return fixed(1e3 * t, 1) + ";7"; }));
    add("nanoseconds since 1970", rows("#timestamp [ns],filename\n", [&](int i, double) {
            return std::to_string(1'700'000'000'000'000'000LL + i * 40'000'000LL) + ",a.png";
        }));
    add("microseconds since 1970", rows("timestamp\n", [&](int i, double) {
            return std::to_string(1'700'000'000'000'000LL + i * 40'000LL);
        }));
    add("a name with a blank", rows("# timestamps [seconds]\n", [&](int, double t) { return fixed(t, 3); }));
    add("no header", rows("", [&](int, double t) { return fixed(t, 3); }));
    add("no header, counted from 1",
        rows("", [&](int i, double t) { return std::to_string(i + 1) + " " + fixed(t, 3); }));
    add("a remark that is a sentence", rows("# the time of each frame\n", [&](int i, double t) {
            return std::to_string(i) + " " + fixed(t, 3);
        }));
    add("decimal comma", rows("Frame;Zeit\n", [&](int i, double t) {
            std::string time = fixed(t, 2);
            std::ranges::replace(time, '.', ',');
            return std::to_string(i) + ";" + time;
        }));
    add("seconds and nanoseconds of ROS", rows("header.stamp.secs,header.stamp.nsecs\n", [&](int i, double) {
            return "1700000000," + std::to_string(500'000'000 + i * 40'000'000);
        }));
    add("clock", rows("time\n", [&](int, double t) { return "10:11:0" + fixed(t, 3); }));
}

void TestFrameTimesFile::reads()
{
    QFETCH(QString, content);
    const auto times = readFrameTimes(written(content.toStdString()), {}, {});
    QVERIFY2(times, times ? "" : times.error().message().c_str());
    QCOMPARE(times->size(), std::size_t(12));
    for (std::size_t i = 0; i < times->size(); ++i)
        QVERIFY2(std::abs((*times)[i].count() - 40'000'000LL * std::int64_t(i)) <= 1,
                 std::to_string((*times)[i].count()).c_str());
}

void TestFrameTimesFile::refuses_data()
{
    QTest::addColumn<QString>("content");
    QTest::addColumn<QString>("message");
    QTest::newRow("goes back") << "t_s\n0\n0.1\n0.05\n"
                               << "t.csv:4: its time is earlier than in the line before";
    QTest::newRow("stands still") << "t_s\n0\n0.1\n0.1\n"
                                  << "t.csv:4: its time is the same as in the line before";
    QTest::newRow("blank") << "t_s,x\n0,1\n,2\n"
                           << "t.csv:3: it has no time that can be read";
    QTest::newRow("infinite") << "t_s\n0\ninf\n"
                              << "t.csv:3: it has no time that can be read";
    QTest::newRow("no number") << "t_s\n0\nabc\n"
                               << "t.csv:3: it has no time that can be read";
    QTest::newRow("short row") << "x,t_s\n0,1\n0\n"
                               << "t.csv:3: it has no time that can be read";
    QTest::newRow("no such column") << "a,b\n1,2\n"
                                    << "t.csv:1: no column of it is called a time";
    QTest::newRow("frames alone") << "frame\n1\n2\n"
                                  << "t.csv:2: it has frame numbers in place of times";
    QTest::newRow("unknown unit") << "time [fortnights]\n1\n2\n"
                                  << "t.csv:1: its column 'time [fortnights]' is in a unit that is not known";
    QTest::newRow("comma of decimals or of thousands")
        << "x;t_s\n1;1,000\n1;1,040\n1;1,080\n"
        << "t.csv:2: its times can be read in two ways: '1,000' with three decimals, or without";
    QTest::newRow("header alone") << "t_s\n"
                                  << "file 't.csv': ";
    QTest::newRow("empty") << ""
                           << "file 't.csv': ";
}

void TestFrameTimesFile::refuses()
{
    QFETCH(QString, content);
    QFETCH(QString, message);
    const auto times = readFrameTimes(written(content.toStdString()), {}, {});
    QVERIFY(!times);
    QVERIFY2(
        QString::fromStdString(times.error().message()).remove(m_folder.path() + u'/').startsWith(message),
        times.error().message().c_str());
}

void TestFrameTimesFile::aPersonSaysTheUnit()
{
    const auto file = written(rows("", [](int i, double) { return std::to_string(40 * i); }));
    const auto open = readFrameTimes(file, {}, {});
    QVERIFY(!open);
    QVERIFY(open.error().message().find(
                "choose their unit: s, ms, us, ns, min, h, d or frame; ms is likely") != std::string::npos);
    TrackReading reading;
    reading.timeUnit = TimeUnit::Millisecond;
    QCOMPARE(readFrameTimes(file, reading, {}).value().back(), Nanoseconds(440'000'000));
    JobControl cancelled;
    cancelled.cancel.cancel();
    QCOMPARE(readFrameTimes(file, reading, cancelled).error().code, ErrorCode::Cancelled);
}

ODOGRAPH_TEST(TestFrameTimesFile, QCoreApplication)
#include "tst_frame_times_file.moc"
