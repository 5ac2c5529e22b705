// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/track_file.h"

#include "tests/exchange/track_styles.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace odo;
using namespace odo::test;

namespace {

constexpr double notMeasured = std::numeric_limits<double>::quiet_NaN();

/// What a track says, robust against a few positions that are not measured.
struct Measured
{
    double speedMps = 0, topMps = 0, radiusM = 0, durationS = 0;
    std::size_t lost = 0;
};

Measured measured(const FileTrack &track)
{
    Measured all;
    std::vector<double> speeds, xs;
    constexpr std::size_t apart = 10;
    for (std::size_t i = 0; i < track.positions.size(); ++i) {
        const auto &one = track.positions[i];
        all.lost += !one.position;
        if (!one.position)
            continue;
        xs.push_back(one.position->x());
        if (i < apart || !track.positions[i - apart].position)
            continue;
        const auto &before = track.positions[i - apart];
        speeds.push_back((*one.position - *before.position).norm() / toSeconds(one.time - before.time));
    }
    std::ranges::sort(speeds);
    all.speedMps = speeds[speeds.size() / 2];
    all.topMps = speeds.back();
    all.radiusM = (*std::ranges::max_element(xs) - *std::ranges::min_element(xs)) / 2;
    all.durationS = toSeconds(track.positions.back().time - track.positions.front().time);
    return all;
}

/// Empty: it is the circle; else what is wrong.
QString wrongWith(const FileTrack &track)
{
    const Measured it = measured(track);
    const bool isRight = std::abs(it.speedMps - DrivenRun::speedMps) < 0.02 * DrivenRun::speedMps &&
                         it.topMps < 1.1 * DrivenRun::speedMps &&
                         std::abs(it.radiusM - DrivenRun::radiusM) < 0.01 &&
                         std::abs(it.durationS - 11.9667) < 0.05;
    return isRight ? QString()
                   : QStringLiteral("%1 m/s, at most %2, radius %3 m, %4 s")
                         .arg(it.speedMps)
                         .arg(it.topMps)
                         .arg(it.radiusM)
                         .arg(it.durationS);
}

} // namespace

/// Tables as other programs write them: read right, or asked; never metrics that are wrong without a word.
class TestForeignTracks : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    Result<TrackFile> read(const QByteArray &text, const TrackReading &how = {}) const
    {
        const QString name = m_folder.filePath(QStringLiteral("run.txt"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no test file");
        file.close();
        return readTrackFile(name.toStdString(), how, JobControl());
    }
    static TrackReading toldOf(const TrackStyle &style)
    {
        TrackReading how;
        if (style.hasFrames)
            how.rate = DrivenRun::rate;
        if (style.pixelM > 0)
            how.pixelM = style.pixelM;
        return how;
    }
    static const TrackStyle &styleNamed(const char *name)
    {
        return *std::ranges::find(trackStyles(), std::string_view(name),
                                  [](const TrackStyle &style) { return std::string_view(style.name); });
    }
    /// The code of why it was refused, or "read".
    static std::string outcomeOf(const Result<TrackFile> &read)
    {
        return read ? "read" : std::string(read.error().why.code());
    }

private Q_SLOTS:
    void styles_data()
    {
        QTest::addColumn<int>("style");
        for (int i = 0; i < int(trackStyles().size()); ++i)
            QTest::newRow(trackStyles()[std::size_t(i)].name) << i;
    }
    void styles()
    {
        QFETCH(int, style);
        const TrackStyle &its = trackStyles()[std::size_t(style)];
        const auto done = read(its.write(DrivenRun::made(1)), toldOf(its));
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks.size(), std::size_t(1));
        QCOMPARE(wrongWith(done->tracks[0]), QString());
        QVERIFY2(done->tracks[0].notices.empty(),
                 done->tracks[0].notices.empty() ? "" : done->tracks[0].notices[0].english().c_str());
    }
    /// What a format leaves open is asked.
    void asked_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("code");
        QTest::addColumn<QByteArray>("likely");
        const DrivenRun run = DrivenRun::made(2);
        const auto row = [](const char *name, const QByteArray &text, const char *code, const char *likely) {
            QTest::newRow(name) << text << QByteArray(code) << QByteArray(likely);
        };
        row("ms", styleNamed("CSV in ms and cm").withoutUnits(run), "exchange.time_steps_too_long", "ms");
        row("mm", styleNamed("own CSV").withoutUnits(run), "exchange.too_fast_in_metres", "mm");
        QByteArray micro = "t,x,y\n", wrongSeconds = "t_s,x_m,y_m\n", wrongMetres = "t_s,x_m,y_m\n";
        for (const auto &one : run.rows) {
            const QByteArray xy =
                ',' + QByteArray::number(one.x, 'f', 5) + ',' + QByteArray::number(one.y, 'f', 5);
            micro += QByteArray::number(std::llround(one.t * 1e6)) + xy + '\n';
            wrongSeconds += QByteArray::number(one.t * 1000, 'f', 1) + xy + '\n';
            wrongMetres += QByteArray::number(one.t, 'f', 4) + ',' +
                           QByteArray::number(one.x * 1000, 'f', 2) + ',' +
                           QByteArray::number(one.y * 1000, 'f', 2) + '\n';
        }
        row("us", micro, "exchange.time_steps_too_long", "us");
        row("ms that the header calls s", wrongSeconds, "exchange.time_steps_too_long", "ms");
        row("mm that the header calls m", wrongMetres, "exchange.too_fast_as_said", "");
        QByteArray either = "t_s,x,y\n"; // 1.6 m/s in cm, or 0.16 m/s in mm
        for (const auto &one : run.rows)
            either += QByteArray::number(one.t, 'f', 4) + ',' + QByteArray::number(one.x * 316, 'f', 2) +
                      ',' + QByteArray::number(one.y * 316, 'f', 2) + '\n';
        row("cm or mm", either, "exchange.too_fast_in_metres", "");
        QByteArray metres = styleNamed("no header").write(run);
        row("metres below millimetres", "t_s,x_mm,y_mm\n" + metres, "exchange.too_small_as_said", "m");
        row("metres of Tracker", styleNamed("Tracker").write(run), "read", "");
        row("pixels", styleNamed("DeepLabCut").write(run), "exchange.frames_without_rate", "");
        row("frame numbers", styleNamed("frame numbers").write(run), "exchange.frames_without_rate", "");
        QByteArray up = "Time (Seconds),X (m),Y (m),Z (m)\n", down = up;
        for (const auto &one : run.rows) {
            const QByteArray t = QByteArray::number(one.t, 'f', 4), x = QByteArray::number(one.x, 'f', 5),
                             y = QByteArray::number(one.y, 'f', 5);
            up += t + ',' + x + ",0.0600," + y + '\n';
            down += t + ",0.0600," + x + ',' + y + '\n';
        }
        row("Y up", up, "exchange.axes_unclear", "xz");
        row("X up", down, "exchange.axes_unclear", "yz");
        row(
            "one stamp",
            [&] {
                QByteArray text = "timestamp,x,y\n";
                for (const auto &one : run.rows)
                    text += "1714989952.000000," + QByteArray::number(one.x, 'f', 5) + ',' +
                            QByteArray::number(one.y, 'f', 5) + '\n';
                return text;
            }(),
            "exchange.stamps_shared", "");
        QByteArray both = "t;x_m;y_m\n";
        for (int i = 1; i < 40; ++i)
            both += QByteArray::number(i * 0.25, 'f', 3) + ";1." + QByteArray::number(200 + i) + ";2.200\n";
        row("a point of thousands or decimals", both.replace("\n0.", "\n1."), "exchange.number_in_two_ways",
            "");
    }
    void asked()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, code);
        QFETCH(QByteArray, likely);
        const auto done = read(text);
        QCOMPARE(QByteArray::fromStdString(outcomeOf(done)), code);
        if (!done && !likely.isEmpty())
            QCOMPARE(QByteArray::fromStdString(done.error().advice.arguments.front().text), likely);
    }
    /// And the answer is taken.
    void answered()
    {
        const DrivenRun run = DrivenRun::made(3);
        TrackReading how;
        how.timeUnit = TimeUnit::Millisecond;
        how.unit = LengthUnit::Centimetre;
        auto done = read(styleNamed("CSV in ms and cm").withoutUnits(run), how);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(wrongWith(done->tracks[0]), QString());
        QByteArray up = "t,x,y,z\n";
        for (const auto &one : run.rows)
            up += QByteArray::number(one.t, 'f', 4) + ',' + QByteArray::number(one.x, 'f', 5) + ",0.0600," +
                  QByteArray::number(one.y, 'f', 5) + '\n';
        how = {};
        how.axes = FloorAxes::Xz;
        done = read(up, how);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(wrongWith(done->tracks[0]), QString());
        how = {};
        how.rate = DrivenRun::rate;
        QCOMPARE(outcomeOf(read(styleNamed("DeepLabCut").write(run), how)),
                 std::string("exchange.format_has_pixels"));
    }
    void decimalSigns()
    {
        const QByteArray text = "t_s;x_mm;y_mm\n1.000;1.500;2.250\n1.250;1.750;2.500\n1.500;1.900;2.750\n";
        TrackReading how;
        QCOMPARE(outcomeOf(read(text)), std::string("exchange.number_in_two_ways"));
        how.decimal = DecimalSign::Point;
        auto done = read(text, how);
        QVERIFY(done);
        QCOMPARE(done->tracks[0].positions[0].position->x(), 0.0015);
        how.decimal = DecimalSign::Comma;
        done = read(text, how);
        QVERIFY(done);
        QCOMPARE(done->tracks[0].positions[0].position->x(), 1.5);
        QCOMPARE(done->tracks[0].positions[0].time.count(), 1'000'000'000'000);
        // Swiss, French and English thousands
        for (const char *mark : {"'", "\u00a0", "\u202f", ","}) {
            const QByteArray grouped = "t_s;x_mm;y_mm\n0;1" + QByteArray(mark) + "500;990\n1;1" + mark +
                                       "750;995\n2;2" + mark + "000;1" + mark + "000.5\n";
            done = read(grouped);
            QVERIFY2(done, done ? mark : done.error().message().c_str());
            QCOMPARE(done->tracks[0].positions[2].position->x(), 2.0);
            QCOMPARE(done->tracks[0].positions[2].position->y(), 1.0005);
        }
    }
    void lostMarks_data()
    {
        QTest::addColumn<double>("mark"); // NaN: the last position is held
        QTest::newRow("0, 0") << 0.0;
        QTest::newRow("-1, -1") << -0.001;
        QTest::newRow("held") << notMeasured;
    }
    /// 12 rows at the beginning and 30 further on; a hold has none at the beginning.
    void lostMarks()
    {
        QFETCH(double, mark);
        DrivenRun run = DrivenRun::made(4);
        for (std::size_t i = 100; i < 130; ++i) {
            run.rows[i].x = std::isnan(mark) ? run.rows[99].x : mark;
            run.rows[i].y = std::isnan(mark) ? run.rows[99].y : mark;
        }
        for (std::size_t i = 0; i < 12 && !std::isnan(mark); ++i)
            run.rows[i].x = run.rows[i].y = mark;
        const auto done = read(styleNamed("own CSV").write(run));
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(wrongWith(done->tracks[0]), QString());
        QCOMPARE(measured(done->tracks[0]).lost, std::size_t(std::isnan(mark) ? 30 : 42));
        QCOMPARE(done->tracks[0].notices.size(), std::size_t(1));
    }
    /// Where nothing leaps, nothing is lost.
    void restIsNotLost()
    {
        QByteArray rests = "t_s,x_mm,y_mm\n";
        for (int i = 0; i < 200; ++i) {
            const double x = i < 60 ? 0 : i < 120 ? 0.05 * (i - 60) * (i - 60) : 180 + 6 * (i - 120);
            rests += QByteArray::number(i / 30.0, 'f', 4) + ',' + QByteArray::number(x, 'f', 2) + ",0.00\n";
        }
        const auto done = read(rests);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(measured(done->tracks[0]).lost, std::size_t(0));
        QVERIFY(done->tracks[0].notices.empty());
    }
    void confidences()
    {
        DrivenRun run = DrivenRun::made(5);
        for (std::size_t i = 100; i < 130; ++i)
            run.rows[i] = {run.rows[i].t, 0.05, 0.03, 0.02};
        const TrackStyle &style = styleNamed("DeepLabCut");
        TrackReading how = toldOf(style);
        auto done = read(style.write(run), how);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(wrongWith(done->tracks[0]), QString());
        QCOMPARE(measured(done->tracks[0]).lost, std::size_t(30));
        QCOMPARE(
            done->tracks[0].notices[0].english(),
            std::string("30 positions with a confidence below 0.60 count as not measured; the first is in "
                        "line 104"));
        how.minConfidence = 0.995;
        QCOMPARE(outcomeOf(read(style.write(run), how)), std::string("exchange.none_sure_enough"));
        how = {};
        how.minConfidence = 0.5;
        QCOMPARE(outcomeOf(read(styleNamed("own CSV").write(run), how)),
                 std::string("exchange.no_confidence"));
    }
    void stamps()
    {
        DrivenRun run = DrivenRun::made(6);
        const TrackStyle &own = styleNamed("own CSV");
        run.rows[200].t = run.rows[199].t; // one is repeated
        auto done = read(own.write(run));
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks[0].positions.size(), std::size_t(359));
        QCOMPARE(done->tracks[0].notices[0].english(),
                 std::string("line 202 was left out, because its time repeats or is out of order"));
        QCOMPARE(wrongWith(done->tracks[0]), QString());
        run = DrivenRun::made(6);
        run.rows[200].t = 900; // one is wrong, and the ones behind it are right
        done = read(own.write(run));
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks[0].positions.size(), std::size_t(359));
        for (const double step : {0.1, 0.01}) { // three rows share one, or none does
            run = DrivenRun::made(6);
            for (auto &row : run.rows)
                row.t = std::round(row.t / step) * step;
            done = read(own.write(run));
            QVERIFY2(done, done ? "" : done.error().message().c_str());
            QCOMPARE(done->tracks[0].positions.size(), std::size_t(360));
            QCOMPARE(wrongWith(done->tracks[0]), QString());
            QVERIFY(done->tracks[0].notices[0].english().ends_with("spread evenly, 30.00 frames/s"));
            // a frame is missing here and there: it cannot be known where within a shared stamp
            run.rows.erase(run.rows.begin() + 100, run.rows.begin() + 104);
            done = read(own.write(run));
            QCOMPARE(outcomeOf(done), std::string(step > 0.05 ? "exchange.stamps_shared" : "read"));
        }
    }
    /// Cut off to 20 ms at 90 frames/s; and in single precision, with a rate that nobody knows well.
    void coarseStamps()
    {
        QByteArray cut = "t_s,x_m,y_m\n", single = cut;
        for (int i = 0; i < 400; ++i) {
            const QByteArray x = QByteArray::number(i * 0.005, 'f', 3);
            cut += QByteArray::number(std::floor(i / 90.0 * 50) / 50, 'f', 2) + ',' + x + ",1\n";
            single += QByteArray::number(std::round(i * 1.6 / 128) * 128, 'f', 1) + ',' + x + ",1\n";
        }
        const auto done = read(cut);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QVERIFY(std::abs(toSeconds(done->tracks[0].positions[399].time - done->tracks[0].positions[0].time) -
                         399 / 90.0) < 0.005);
        QCOMPARE(outcomeOf(read(single)), std::string("exchange.stamps_shared"));
    }
    /// A log that is quicker than what it logs: each row twice, with its stamp or with one of its own.
    void twins()
    {
        const DrivenRun run = DrivenRun::made(9);
        DrivenRun twice, held;
        for (const auto &row : run.rows) {
            twice.rows.insert(twice.rows.end(), 2, row);
            held.rows.insert(held.rows.end(), 2, row);
            held.rows.back().t += 1 / 60.0;
        }
        for (const DrivenRun *one : {&twice, &held}) {
            const auto done = read(styleNamed("own CSV").write(*one));
            QVERIFY2(done, done ? "" : done.error().message().c_str());
            QCOMPARE(done->tracks[0].notices.size(), std::size_t(1));
            std::size_t count = 0;
            for (const auto &position : done->tracks[0].positions)
                count += position.position.has_value();
            QCOMPARE(count, std::size_t(360));
        }
        QByteArray bag = styleNamed("TUM in ns").write(run);
        const auto done = read("0" + bag.mid(bag.indexOf(' '))); // its clock was not set yet
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks[0].positions.size(), std::size_t(359));
    }
    /// Every other row is a mark.
    void marksEverywhere()
    {
        DrivenRun run = DrivenRun::made(10);
        for (std::size_t i = 1; i < run.rows.size(); i += 2)
            run.rows[i].x = run.rows[i].y = -0.001;
        const auto done = read(styleNamed("own CSV").write(run));
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(measured(done->tracks[0]).lost, std::size_t(180));
    }
    void motionCapture()
    {
        QByteArray text =
            "Format Version,1.23,Take Name,run\n\n,,Rigid Body,Rigid Body,Rigid Body,Rigid "
            "Body,Rigid Body,Rigid Body,Rigid "
            "Body\n,,Rotation,Rotation,Rotation,Rotation,Position,Position,Position\nFrame,Time "
            "(Seconds),X,Y,Z,W,X,Y,Z\n";
        int frame = 0;
        for (const auto &row : DrivenRun::made(11).rows)
            text += QByteArray::number(frame++) + ',' + QByteArray::number(row.t, 'f', 6) + ",0,0,0,1," +
                    QByteArray::number(row.x, 'f', 6) + ",0.060," + QByteArray::number(row.y, 'f', 6) + '\n';
        QCOMPARE(outcomeOf(read(text)), std::string("exchange.axes_unclear"));
        TrackReading how;
        how.axes = FloorAxes::Xz;
        const auto done = read(text, how);
        QVERIFY2(done && done->tracks.size() == 1, done ? "" : done.error().message().c_str());
        QCOMPARE(wrongWith(done->tracks[0]), QString());
    }
    /// A localisation that starts anew goes on from elsewhere.
    void breaks()
    {
        DrivenRun run = DrivenRun::made(7);
        for (std::size_t i = 180; i < run.rows.size(); ++i) {
            run.rows[i].x += 0.8;
            run.rows[i].y -= 0.3;
        }
        const auto done = read(styleNamed("own CSV").write(run));
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        const FileTrack &track = done->tracks[0];
        QCOMPARE(track.notices.size(), std::size_t(1));
        QVERIFY2(track.notices[0].english().starts_with("its positions jump by 0.8"),
                 track.notices[0].english().c_str());
        QVERIFY(measured(track).topMps < 0.6);
        // longer than what is bridged
        std::size_t lost = 0;
        for (std::size_t i = 150; i < 210; ++i)
            lost += !track.positions[i].position;
        QVERIFY(lost > 43 && lost == measured(track).lost);
        // a burst there and back is none
        for (std::size_t i = 190; i < run.rows.size(); ++i) {
            run.rows[i].x -= 0.8;
            run.rows[i].y += 0.3;
        }
        const auto burst = read(styleNamed("own CSV").write(run));
        QVERIFY(burst && measured(burst->tracks[0]).lost == 0);
    }
    void severalRobots()
    {
        QByteArray rows = "t_s,id,x_mm,y_mm\n", columns = "t_s,x_mm,y_mm,x_mm,y_mm\n",
                   counted = "id,t_s,x_mm,y_mm\n";
        int line = 0;
        for (const auto &one : DrivenRun::made(8).rows) {
            const QByteArray t = QByteArray::number(one.t, 'f', 4),
                             x = QByteArray::number(one.x * 1000, 'f', 2),
                             y = QByteArray::number(one.y * 1000, 'f', 2);
            rows += t + ",1," + x + ',' + y + '\n' + t + ",7," + y + ',' + x + '\n';
            columns += t + ',' + x + ',' + y + ',' + y + ',' + x + '\n';
            counted += QByteArray::number(line++) + ',' + t + ',' + x + ',' + y + '\n';
        }
        auto done = read(rows);
        QVERIFY2(done && done->tracks.size() == 2, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks[1].name, std::string("7"));
        QCOMPARE(wrongWith(done->tracks[1]), QString());
        done = read(columns);
        QVERIFY(done && done->tracks.size() == 2);
        QCOMPARE(done->tracks[0].name, std::string("1"));
        QCOMPARE(wrongWith(done->tracks[1]), QString());
        done = read(counted); // the lines are numbered, nobody is named
        QVERIFY2(done && done->tracks.size() == 1, done ? "" : done.error().message().c_str());
        QCOMPARE(wrongWith(done->tracks[0]), QString());
    }
    /// Midnight, zones, and poses of KITTI, which have no times.
    void momentsAndPoses()
    {
        QByteArray clock = "time,x_m,y_m\n", poses;
        for (int i = 0; i < 60; ++i) {
            const int second = (59 * 60 + 50 + i / 2) % 3600;
            const QByteArray at = (second >= 3000 ? "23:" : "00:") +
                                  QByteArray::number(100 + second / 60).right(2) + ':' +
                                  QByteArray::number(100 + second % 60).right(2) + (i % 2 ? ".5" : ".0");
            const QByteArray x = QByteArray::number(i * 0.1, 'f', 3);
            clock += at + ',' + x + ",0\n";
            poses += "1 0 0 " + x + " 0 1 0 0.3 0 0 1 " + QByteArray::number(i * i * 0.01) + '\n';
        }
        auto done = read(clock);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks[0].positions.back().time - done->tracks[0].positions.front().time,
                 Nanoseconds(29'500'000'000));
        done = read("time,x_m,y_m\n2024-05-06 12:00:00+02:00,0,0\n2024-05-06T10:00:00.5Z,1,0\n06.05.2024 "
                    "10:00:01,2,0\n");
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(done->tracks[0].positions[0].time.count(), 1'714'989'600'000'000'000);
        QCOMPARE(done->tracks[0].positions[2].time - done->tracks[0].positions[1].time,
                 Nanoseconds(500'000'000));
        TrackReading how;
        QCOMPARE(outcomeOf(read(poses)), std::string("exchange.frames_without_rate"));
        how.rate = 10;
        done = read(poses, how);
        QVERIFY2(done, done ? "" : done.error().message().c_str());
        QCOMPARE(trackFormatWord(done->format), std::string_view("kitti"));
        QVERIFY(done->tracks[0].positions[50].position->isApprox(Eigen::Vector2d(5, 25)));
    }
    void uncertainties()
    {
        QCOMPARE(outcomeOf(read("t_s,x_mm,y_mm,sigma_x_mm,sigma_y_mm\n0,1,2,1,1\n1,1,2,0,1\n2,1,2,1,1\n")),
                 std::string("exchange.sigma_not_above_zero"));
        QCOMPARE(outcomeOf(read("t_s,x_mm,y_mm,sigma_x_mm,sigma_y_mm\n0,1,2,1,1\n1,1,2,1,-1\n2,1,2,1,1\n")),
                 std::string("exchange.sigma_not_above_zero"));
    }

    /// 20 styles and 16 mutations of each: read right, or asked.
    void mutations();
};

namespace {

struct Mutation
{
    const char *name;
    std::function<void(DrivenRun &, std::mt19937 &)> run;
    std::function<QByteArray(const TrackStyle &, const QByteArray &)> text = {};
    bool isBroken = false; ///< in two pieces that fit no circle together
};

void loseRows(DrivenRun &run, std::mt19937 &random,
              const std::function<void(DrivenRun::Row &, const DrivenRun::Row &)> &lose)
{
    const std::size_t from = 40 + random() % 200, count = 5 + random() % 35;
    for (std::size_t i = from; i < from + count; ++i)
        lose(run.rows[i], run.rows[from - 1]);
}

std::vector<Mutation> mutationsOfRuns()
{
    using Row = DrivenRun::Row;
    return {
        {"as it is", [](DrivenRun &, std::mt19937 &) {}},
        {"no positions",
         [](DrivenRun &run, std::mt19937 &random) {
             loseRows(run, random, [](Row &row, const Row &) { row.x = row.y = notMeasured; });
         }},
        {"0, 0",
         [](DrivenRun &run, std::mt19937 &random) {
             loseRows(run, random, [](Row &row, const Row &) { row.x = row.y = 0; });
         }},
        {"held",
         [](DrivenRun &run, std::mt19937 &random) {
             loseRows(run, random, [](Row &row, const Row &last) { row.x = last.x, row.y = last.y; });
         }},
        {"unsure",
         [](DrivenRun &run, std::mt19937 &random) {
             loseRows(run, random, [](Row &row, const Row &) { row.confidence = 0.1; });
         }},
        {"a stamp repeated",
         [](DrivenRun &run, std::mt19937 &random) {
             const std::size_t i = 20 + random() % 300;
             run.rows[i].t = run.rows[i - 1].t;
         }},
        {"a stamp that leaps",
         [](DrivenRun &run, std::mt19937 &random) { run.rows[20 + random() % 300].t = 30; }},
        {"stamps rounded to 10 ms",
         [](DrivenRun &run, std::mt19937 &) {
             for (Row &row : run.rows)
                 row.t = std::round(row.t * 100) / 100;
         }},
        {"stamps rounded to 100 ms",
         [](DrivenRun &run, std::mt19937 &) {
             for (Row &row : run.rows)
                 row.t = std::round(row.t * 10) / 10;
         }},
        {"rows missing",
         [](DrivenRun &run, std::mt19937 &random) {
             const auto from = run.rows.begin() + 40 + random() % 200;
             run.rows.erase(from, from + 7);
         }},
        {"a jump that stays",
         [](DrivenRun &run, std::mt19937 &random) {
             for (std::size_t i = 100 + random() % 150; i < run.rows.size(); ++i)
                 run.rows[i].x += 0.9;
         },
         {},
         true},
        {"axes exchanged",
         [](DrivenRun &run, std::mt19937 &) {
             for (Row &row : run.rows)
                 std::swap(row.x, row.y);
         }},
        {"a comment and blank lines", [](DrivenRun &, std::mt19937 &) {},
         [](const TrackStyle &, const QByteArray &text) { return text + "\n\n# end\n"; }},
        {"lines of Windows and a mark", [](DrivenRun &, std::mt19937 &) {},
         [](const TrackStyle &, const QByteArray &text) {
             return "\xef\xbb\xbf" + QByteArray(text).replace('\n', "\r\n");
         }},
    };
}

} // namespace

void TestForeignTracks::mutations()
{
    int right = 0, asked = 0;
    QStringList wrong;
    unsigned seed = 100;
    for (const TrackStyle &style : trackStyles()) {
        std::vector<Mutation> all = mutationsOfRuns();
        if (style.withoutUnits) {
            all.push_back({"no units", [](DrivenRun &, std::mt19937 &) {}});
            all.push_back({"no units, lost at 0, 0", mutationsOfRuns()[2].run});
        }
        for (const Mutation &mutation : all) {
            DrivenRun run = DrivenRun::made(++seed);
            std::mt19937 random(seed);
            mutation.run(run, random);
            const bool isBare = std::string_view(mutation.name).starts_with("no units");
            QByteArray text = isBare ? style.withoutUnits(run) : style.write(run);
            if (mutation.text)
                text = mutation.text(style, text);
            const auto done = read(text, toldOf(style));
            if (!done) {
                ++asked;
                const std::string line = done.error().message();
                if (!isBare && std::string_view(mutation.name) == "as it is")
                    wrong << QStringLiteral("%1: %2").arg(QLatin1String(style.name),
                                                          QString::fromStdString(line));
                continue;
            }
            const QString fault = mutation.isBroken && !done->tracks[0].notices.empty()
                                      ? QString()
                                      : wrongWith(done->tracks[0]);
            if (fault.isEmpty())
                ++right;
            else
                wrong << QStringLiteral("%1, %2: %3")
                             .arg(QLatin1String(style.name), QLatin1String(mutation.name), fault);
        }
    }
    qInfo("%d read right, %d asked", right, asked);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    QVERIFY2(right + asked >= 290 && right > 2 * asked, "too few were read");
}

ODOGRAPH_TEST(TestForeignTracks, QCoreApplication)
#include "tst_foreign_tracks.moc"
