// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/track_file.h"

#include "tests/exchange/track_styles.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QStringEncoder>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace odo;
using namespace odo::test;

namespace {

using Row = DrivenRun::Row;
using Cells = std::function<QByteArray(std::size_t, const Row &)>;

QByteArray number(double value, int decimals, char sign = '.')
{
    return QByteArray::number(value, 'f', decimals).replace('.', sign);
}

QByteArray table(const QByteArray &header, const Cells &cells)
{
    QByteArray text = header;
    const DrivenRun run = DrivenRun::made(21);
    for (std::size_t i = 0; i < run.rows.size(); ++i)
        text += cells(i, run.rows[i]) + '\n';
    return text;
}

/// t, x, y in seconds and units of so many a metre.
Cells columns(double perMetre, char delimiter = ',', char sign = '.')
{
    return [=](std::size_t, const Row &row) {
        return number(row.t, 4, sign) + delimiter + number(row.x * perMetre, 4, sign) + delimiter +
               number(row.y * perMetre, 4, sign);
    };
}

/// A stamp, then x and y in metres.
Cells stamped(const std::function<QByteArray(std::size_t, double)> &stamp)
{
    return [=](std::size_t i, const Row &row) {
        return stamp(i, row.t) + ',' + number(row.x, 6) + ',' + number(row.y, 6);
    };
}

QByteArray clockTime(double seconds, const char *colon = ":", const char *decimal = ".")
{
    const auto ms = std::lround(seconds * 1000);
    return QString::asprintf("%02ld%s%02ld%s%02ld%s%03ld", ms / 3'600'000, colon, ms / 60'000 % 60, colon,
                             ms / 1000 % 60, decimal, ms % 1000)
        .toUtf8();
}

QByteArray timecode(std::size_t frame, std::size_t rate)
{
    return QString::asprintf("00:00:%02zu:%02zu", frame / rate, frame % rate).toUtf8();
}

QByteArray encoded(const QByteArray &text, QStringEncoder::Encoding encoding)
{
    return QStringEncoder(encoding, QStringEncoder::Flag::WriteBom)(QString::fromUtf8(text));
}

} // namespace

/// Tables in the dialects of spreadsheets, languages and laboratory programs: each is one run, read to the
/// millimetre and the millisecond, or asked.
class TestTableDialects : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    Result<TrackFile> read(const QByteArray &text, const TrackReading &how = {}) const
    {
        QFile file(m_folder.filePath(QStringLiteral("run.txt")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no test file");
        file.close();
        return readTrackFile(file.fileName().toStdString(), how, JobControl());
    }
    static std::string outcomeOf(const Result<TrackFile> &read)
    {
        return read ? "read" : std::string(read.error().why.code());
    }
    /// Empty: it is the run.
    static QString wrongWith(const FileTrack &track, std::size_t missing = 0)
    {
        const DrivenRun run = DrivenRun::made(21);
        if (track.positions.size() + missing != run.rows.size())
            return QStringLiteral("%1 positions").arg(track.positions.size());
        const double start = toSeconds(track.positions.front().time);
        for (std::size_t i = 0; i < track.positions.size(); ++i) {
            const ImportedPosition &one = track.positions[i];
            const Row &row = run.rows[i];
            if (!one.position || std::hypot(one.position->x() - row.x, one.position->y() - row.y) > 1e-3)
                return QStringLiteral("position %1").arg(i);
            if (std::abs(toSeconds(one.time) - start - row.t) > 1e-3)
                return QStringLiteral("time %1: %2 s").arg(i).arg(toSeconds(one.time) - start);
        }
        return {};
    }

private Q_SLOTS:
    void readRight_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("rate");
        const auto row = [](const char *name, const QByteArray &text, double rate = 0) {
            QTest::newRow(name) << text << rate;
        };
        row("inches", table("time_s,x_in,y_in\n", columns(1 / 0.0254)));
        row("inches in brackets", table("Time (s),X (inches),Y (inches)\n", columns(1 / 0.0254)));
        row("feet", table("t_s,x_ft,y_ft\n", columns(1 / 0.3048)));

        row("German", table("Zeit in s;x in mm;y in mm\n", columns(1000, ';', ',')));
        row("French", table("Temps (s);X (cm);Y (cm)\n", columns(100, ';', ',')));
        row("Spanish", table("tiempo [s];posición x [m];posición y [m]\n", columns(1, ';', ',')));
        row("Korean", table("시간(s),x(mm),y(mm)\n", columns(1000)));
        row("Chinese", table("时间 (秒),X坐标 (毫米),Y坐标 (毫米)\n", columns(1000)));

        const QByteArray german = table("Zeit (s);x (mm);y (mm)\n", columns(1000, ';', ','));
        row("UTF-16 LE", encoded(german, QStringEncoder::Utf16LE));
        row("UTF-16 BE", encoded(german, QStringEncoder::Utf16BE));
        row("Windows-1252", "L\xe4nge \x80\n" + german);
        row("CR alone", QByteArray(german).replace('\n', '\r'));
        row("quoted decimal commas", table("t_s,x_mm,y_mm\n", [](std::size_t, const Row &one) {
                return '"' + columns(1000, ';', ',')(0, one).replace(";", "\",\"") + '"';
            }));

        row("AM and PM", table("time,x_m,y_m\n", stamped([](std::size_t, double t) {
                                   return t < 5 ? clockTime(11 * 3600 + 3595 + t) + " AM"
                                                : clockTime(12 * 3600 + t - 5) + " PM";
                               })));
        row("American dates", table("time,x_m,y_m\n", stamped([](std::size_t, double t) {
                                        return "5/16/2024 " + clockTime(4000 + t) + " PM";
                                    })));
        row("compact dates", table("time,x_m,y_m\n", stamped([](std::size_t, double t) {
                                       return "20240516T" + clockTime(40000 + t, "") + 'Z';
                                   })));
        row("milliseconds behind a colon", table("time,x_m,y_m\n", stamped([](std::size_t, double t) {
                                                     return clockTime(4000 + t, ":", ":");
                                                 })));
        row("a unit in each cell",
            table("Time,x_m,y_m\n", stamped([](std::size_t, double t) { return number(t, 4) + " sec"; })));
        row("days of a spreadsheet", table("time,x_m,y_m\n", stamped([](std::size_t, double t) {
                                               return number(45'418.4 + t / 86'400, 10);
                                           })));
        row("minutes", table("time (min),x (m),y (m)\n",
                             stamped([](std::size_t, double t) { return number(t / 60, 8); })));
        row("a column called ms",
            table("ms,x_m,y_m\n", stamped([](std::size_t, double t) { return number(t * 1000, 1); })));
        row("a timecode of 30 frames",
            table("timecode,x_m,y_m\n", stamped([](std::size_t i, double) { return timecode(i, 30); })), 30);
        row("hundredths of Kinovea", table("#Kinovea export\n#T X Y\n", [](std::size_t, const Row &one) {
                return timecode(std::size_t(std::lround(one.t * 100)), 100) + ' ' + number(one.x, 5) + ' ' +
                       number(one.y, 5);
            }));

        row("a remark of NumPy", table("# t_s x_m y_m\n", columns(1, ' ')));
        row("Motive",
            table("Format Version,1.23,Length Units,Millimeters\n\n,,Body,Body,Body,Body\n,,Position,"
                  "Position,Position,Mean Marker Error\nFrame,Time (Seconds),X,Y,Z,\n",
                  [](std::size_t i, const Row &one) {
                      return QByteArray::number(quint64(i)) + ',' + columns(1000)(i, one) + ",60.1,0.2";
                  }));
        row("Vicon",
            table("Trajectories\n30\n,,robot:front,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n",
                  [](std::size_t i, const Row &one) {
                      return QByteArray::number(quint64(i + 1)) + ",0," + number(one.x * 1000, 3) + ',' +
                             number(one.y * 1000, 3) + ",61";
                  }),
            30);
        row("Qualisys",
            table("NO_OF_FRAMES\t360\nNO_OF_MARKERS\t1\nFREQUENCY\t30\nMARKER_NAMES\tR\nFrame\tTime\tR "
                  "X\tR Y\n",
                  [](std::size_t i, const Row &one) {
                      return QByteArray::number(quint64(i)) + '\t' + columns(1000, '\t')(i, one);
                  }));
        row("EthoVision", table(QByteArray("\"Number of header lines:\";\"36\"\n") +
                                    QByteArray("\"Field\";\"v\"\n").repeated(33) +
                                    "\"Trial time\";\"Recording time\";\"X center\";\"Y center\"\n"
                                    "\"s\";\"s\";\"cm\";\"cm\"\n",
                                [](std::size_t i, const Row &one) {
                                    return number(one.t, 3, ',') + ';' + columns(100, ';', ',')(i, one);
                                }));
        row("a true minus", table("t_s,x_mm,y_mm\n", columns(1000)).replace('-', "\u2212"));
    }
    void readRight()
    {
        QFETCH(QByteArray, text);
        QFETCH(double, rate);
        TrackReading how;
        if (rate > 0)
            how.rate = rate;
        const auto done = read(text, how);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks.size(), std::size_t(1));
        QCOMPARE(wrongWith(done->tracks[0]), QString());
    }
    void asked_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("likely");
        const auto row = [](const char *name, const QByteArray &text, const char *code,
                            const char *likely = "") {
            QTest::newRow(name) << text << QByteArray(code) << QByteArray(likely);
        };
        for (const char *unit : {"dm", "um", "km"})
            row(unit, table(QByteArray("t_s,x_") + unit + ",y_" + unit + '\n', columns(10)),
                "exchange.unit_not_known");
        for (const std::size_t rate : {25, 30, 60})
            row(rate == 25   ? "25 frames"
                : rate == 30 ? "30 frames"
                             : "60 frames",
                table("time,x_m,y_m\n", stamped([rate](std::size_t i, double) { return timecode(i, rate); })),
                "exchange.timecode_without_rate");
        for (const auto &[seconds, unit] : {std::pair{60.0, "min"}, {3600.0, "h"}, {86400.0, "d"}})
            row(unit, table("time,x_m,y_m\n", stamped([seconds](std::size_t, double t) {
                                return number(t / seconds, 12);
                            })),
                "exchange.time_steps_too_short", unit);
    }
    void asked()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, code);
        QFETCH(QByteArray, likely);
        const auto done = read(text);
        QCOMPARE(QByteArray::fromStdString(outcomeOf(done)), code);
        if (!likely.isEmpty())
            QCOMPARE(QByteArray::fromStdString(done.error().advice.arguments.front().text), likely);
    }
    /// Fewer frames a second than the timecode counts are none.
    void ratesOfTimecodes()
    {
        const QByteArray text =
            table("time,x_m,y_m\n", stamped([](std::size_t i, double) { return timecode(i, 30); }));
        TrackReading how;
        how.rate = 25;
        QCOMPARE(outcomeOf(read(text, how)), std::string("exchange.timecode_without_rate"));
        how.rate = 29.97;
        const auto done = read(text, how);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QVERIFY(std::abs(toSeconds(done->tracks[0].positions.back().time) - 359 / 29.97) < 1e-6);
    }
    /// A program that was stopped while it wrote; a line that only the last one may be.
    void lastLines()
    {
        const QByteArray text = table("t_s,x_mm,y_mm\n", columns(1000));
        for (const QByteArray &end :
             {QByteArray("12.0,1"), QByteArray("\nMean speed: 0.5\n"), QByteArray("end")}) {
            const auto done = read(text + end);
            QVERIFY2(done, done ? "" : done.error().message().c_str());
            QCOMPARE(wrongWith(done->tracks[0]), QString());
            QCOMPARE(done->tracks[0].notices.size(), std::size_t(1));
            QVERIFY(done->tracks[0].notices[0].english().starts_with("the last line, line 36"));
        }
        QCOMPARE(outcomeOf(read(text + "12.0,1\n12.1,1,1\n")), std::string("exchange.cells_of_columns"));
        QCOMPARE(outcomeOf(read(text + "12.0,1,1,1\n")), std::string("exchange.cells_of_columns"));
    }
    void wordsForNothing()
    {
        for (const char *word : {"lost", "***", "#NV"}) {
            const auto done = read(table("t_s,x_mm,y_mm\n", [&](std::size_t i, const Row &one) {
                return i == 100 ? number(one.t, 4) + ',' + word + ',' + word : columns(1000)(i, one);
            }));
            QVERIFY2(done, done ? "" : done.error().message().c_str());
            QVERIFY(!done->tracks[0].positions[100].position);
        }
    }
    /// A tracker sees a robot that rests in the same place in every frame: that is one measurement, and no
    /// gap.
    void rest()
    {
        for (const double restsS : {2.0, 5.0, 20.0}) {
            QByteArray text = "t_s,x_mm,y_mm\n";
            const DrivenRun noise = DrivenRun::made(5);
            const int rows = int((restsS + 6) * 30);
            for (int i = 0; i < rows; ++i) {
                const double t = i / 30.0, u = std::clamp(t - 3, 0.0, restsS), moving = t - u;
                const bool isResting = t > 3 && u < restsS;
                const auto &at = noise.rows[std::size_t(isResting ? 90 : i % 360)];
                const double x = 600 * (1 - std::cos(moving * std::numbers::pi / 3)) / 2,
                             error = (std::hypot(at.x - 1, at.y - 1) - 0.5) * 1000;
                text += number(t, 4) + ',' + number(x + error, 3) + ',' + number(500 + error / 2, 3) + '\n';
            }
            const auto done = read(text);
            QVERIFY2(done, done ? "" : done.error().message().c_str());
            const auto &positions = done->tracks[0].positions;
            Nanoseconds last = positions.front().time, longest{0};
            for (const ImportedPosition &one : positions) {
                if (!one.position)
                    continue;
                longest = std::max(longest, one.time - last);
                last = one.time;
            }
            QVERIFY2(longest > std::chrono::milliseconds(900) && longest < std::chrono::milliseconds(1400),
                     QByteArray::number(double(longest.count()) / 1e9).constData());
        }
    }
    /// Marks of lost positions have no decimals, and say nothing of those of others.
    void marksAreNoNumbers()
    {
        for (const char *mark : {"-1;0", "0;0", "-999;-999"}) {
            const QByteArray text = table("frame;x_cm;y_cm\n", [&](std::size_t i, const Row &one) {
                return QByteArray::number(quint64(i)) + ';' +
                       (i > 50 && i < 60 ? QByteArray(mark)
                                         : number(one.x * 100, 3, ',') + ';' + number(one.y * 100, 3, ','));
            });
            TrackReading how;
            how.rate = 30;
            const auto done = read(text, how);
            QVERIFY2(done || outcomeOf(done) == "exchange.number_in_two_ways",
                     done ? "" : done.error().message().c_str());
            QVERIFY(!done || std::abs(done->tracks[0].positions[0].position->x() - 1.5) < 0.01);
        }
    }
    /// Where the robot stays within the rounding of its positions, they say so.
    void rounding()
    {
        const auto rounded = [&](double stepMm, double speedMps) {
            QByteArray text = "t_s,x_mm,y_mm\n";
            for (int i = 0; i < 600; ++i) {
                const double angle = speedMps / 0.5 * i / 30;
                text += number(i / 30.0, 4) + ',' +
                        number(std::round(500 * std::cos(angle) / stepMm) * stepMm, 2) + ',' +
                        number(std::round(500 * std::sin(angle) / stepMm) * stepMm, 2) + '\n';
            }
            const auto done = read(text);
            return done ? done->tracks[0].roundedM : -1;
        };
        QCOMPARE(rounded(10, 0.02), 0.01);
        QCOMPARE(rounded(1, 0.01), 0.001);
        QCOMPARE(rounded(100, 0.4), 0.1);
        QCOMPARE(rounded(1, 0.5), 0.0); // then it is scatter
        QCOMPARE(rounded(0.01, 0.5), 0.0);
    }
    /// Metres that nobody stated are said.
    void metresAreSaid()
    {
        const auto done = read(table("t,x,y\n", columns(1)));
        QVERIFY(done);
        QCOMPARE(done->tracks[0].facts.size(), std::size_t(1));
        QCOMPARE(done->tracks[0].facts[0].english(),
                 std::string("its positions have no unit and were read as metres"));
        QVERIFY(read(table("t_s,x_m,y_m\n", columns(1)))->tracks[0].facts.empty());
    }
};

ODOGRAPH_TEST(TestTableDialects, QCoreApplication)
#include "tst_table_dialects.moc"
