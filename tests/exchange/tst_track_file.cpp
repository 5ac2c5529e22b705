// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/track_file.h"

#include "tests/support/c_locales.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <ctime>
#include <limits>

using namespace odo;

/// Finished tracks of other programs: each layout as its program writes it, and what is wrong with a file in
/// one line.
class TestTrackFile : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path fileOf(const QByteArray &text) const
    {
        const QString name = m_folder.filePath(QStringLiteral("run.txt"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no test file");
        return name.toStdString();
    }
    Result<TrackFile> read(const QByteArray &text) const
    {
        return readTrackFile(fileOf(text), TrackReading(), JobControl());
    }

    /// "tum|0 100000000 200000000|0 0.5 1|-1 -1.5 -2": format, nanoseconds, x and y of the first track.
    QString shown(const QByteArray &text, std::size_t track = 0) const
    {
        const auto file = read(text);
        if (!file)
            return QString::fromStdString(file.error().message()).section(QStringLiteral("run.txt"), 1);
        QStringList times, xs, ys;
        for (const ImportedPosition &one : file->tracks.at(track).positions) {
            times << QString::number(one.time.count());
            xs << (one.position ? QString::number(one.position->x()) : QStringLiteral("-"));
            ys << (one.position ? QString::number(one.position->y()) : QStringLiteral("-"));
        }
        return QString::fromUtf8(trackFormatWord(file->format).data()) + u'|' + times.join(u' ') + u'|' +
               xs.join(u' ') + u'|' + ys.join(u' ');
    }

    inline static const QString same = QStringLiteral("|0 100000000 200000000|0 0.5 1|-1 -1.5 -2");

private Q_SLOTS:
    void headings_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QList<double>>("degrees"); // NaN: not known
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        const auto tum = [](const QList<QByteArray> &rotations) {
            QByteArray text;
            for (qsizetype i = 0; i < rotations.size(); ++i)
                text += QByteArray::number(i) + " 0 0 0 " + rotations[i] + '\n';
            return text;
        };
        QTest::newRow("TUM") << tum({"0 0 0 1", "0 0 0.7071067811865476 0.7071067811865476", "0 0 -1 0",
                                     "0 0 0.5 -0.8660254037844386"})
                             << QList<double>{0, 90, 180, -60};
        QTest::newRow("TUM of a robot that pitches by 10°")
            << tum({"0 0.08715574274765817 0 0.9961946980917455",
                    "-0.06162841671621936 0.06162841671621936 "
                    "0.7044160264027587 0.7044160264027587",
                    "0 0 0 1"})
            << QList<double>{0, 90, 0};
        QTest::newRow("TUM without rotations, lying on its side and not normalised")
            << tum({"nan nan nan nan", "0 0 0 0", "0.7071067811865476 0 0 0.7071067811865476", "0 0 2 2",
                    "-NaN 0 0 1"})
            << QList<double>{none, none, none, none, none};
        QTest::newRow("degrees") << QByteArray("t_s,x_m,y_m,heading_deg\n0,0,0,10\n1,1,0,\n2,2,0,-370\n")
                                 << QList<double>{10, none, -370};
        QTest::newRow("radians") << QByteArray(
                                        "t,x,y,theta [rad]\n0,0,0,0\n1,1,0,3.141592653589793\n2,2,0,0\n")
                                 << QList<double>{0, 180, 0};
        QTest::newRow("a unit that is not said, and one that is none of an angle")
            << QByteArray("t,x,y,theta,yaw_px\n0,0,0,a,b\n1,1,0,1,2\n2,2,0,1,2\n")
            << QList<double>{none, none, none};
    }
    void headings()
    {
        QFETCH(QByteArray, text);
        QFETCH(QList<double>, degrees);
        const auto file = read(text);
        QVERIFY2(file, file ? "" : file.error().message().c_str());
        const auto &positions = file->tracks[0].positions;
        QCOMPARE(qsizetype(positions.size()), degrees.size());
        for (qsizetype i = 0; i < degrees.size(); ++i) {
            const auto &heading = positions[std::size_t(i)].headingRad;
            QCOMPARE(heading.has_value(), !std::isnan(degrees[i]));
            QVERIFY2(!heading || std::abs(*heading * 180 / M_PI - degrees[i]) < 1e-9,
                     qPrintable(QString::number(heading.value_or(0))));
        }
    }
    void layouts_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("format");
        const auto row = [](const char *name, const char *text, const char *format) {
            QTest::newRow(name) << QByteArray(text) << QString::fromLatin1(format);
        };
        row("TUM",
            "# timestamp tx ty tz qx qy qz qw\n0 0 -1 0 0 0 0 1\n0.1 0.5 -1.5 0 0 0 0 1\n\n0.2 1 -2 0 0 0 0 "
            "1\n",
            "tum");
        row("TUM of another line end and parted by tabs",
            "0\t0\t-1\t0\t0\t0\t0\t1\r\n0.1\t.5\t-1.5\t0\t0\t0\t0\t1\r\n2e-1\t1\t-2\t0\t0\t0\t0\t1", "tum");
        row("CSV", "t_s,x_mm,y_mm\n0,0,-1000\n0.1,500,-1500\n0.2,1000,-2000\n", "csv");
        row("64 digits",
            "t_s,x_mm,y_mm\n0.00000000000000000000000000000000000000000000000000000000000000,0,-1000\n0.1,"
            "500,-1500\n0.2,1000,-2000\n",
            "csv");
        row("continental",
            "\xef\xbb\xbft_s;x_mm;y_mm\r\n0;0;-1000\r\n0,1;500,0;-1500\r\n0,2;1000;-2000,000\r\n", "csv");
        row("spreadsheet with units", "t [s],x [m],y [m]\n0,0,-1\n0.1,0.5,-1.5\n0.2,1,-2\n", "csv");
        row("other units", "time (ms);x/cm;y [mm]\n0;0;-1000\n100;50;-1500\n200;100;-2000\n", "csv");
        row("units in words",
            "Zeit in Sekunden;X in Zentimetern;Y in Zentimetern\n0;0;-100\n0,1;50;-150\n0,2;100;-200\n",
            "csv");
        row("units in words of one", "Zeit [Sekunde],x [Meter],y [Metre]\n0,0,-1\n0.1,0.5,-1.5\n0.2,1,-2\n",
            "csv");
        row("other columns, in another order",
            "y_mm,note,x_mm,raw_x_mm,timestamp\n-1000,\"a,b\",0,7,0\n-1500,,500,8,0.1\n-2000,,1000,9,0.2\n",
            "csv");
        row("all cells quoted",
            "\"t [s]\",\"x [m]\",\"y "
            "[m]\"\n\"0\",\"0\",\"-1\"\n\"0.1\",\"0.5\",\"-1.5\"\n\"0.2\",\"1\",\"-2\"\n",
            "csv");
        row("a spreadsheet's hint", "sep=;\nt_s;x_m;y_m\n0;0;-1\n0,1;0,5;-1,5\n0,2;1;-2\n", "csv");
        row("Tracker, one track",
            "\tmass A\t\t\t\nt\tx\ty\t\n0.0\t0.0\t-1.0\t\n1.0E-1\t5.0E-1\t-1.5E0\t\n2.0E-1\t1.0\t-2.0\t\n",
            "tracker");
        row("Tracker, older", "mass A\nt\tx\ty\n0.0\t0.0\t-1.0\n1.0E-1\t5.0E-1\t-1.5E0\n2.0E-1\t1.0\t-2.0\n",
            "tracker");
        row("Tracker, decimal comma",
            "\tmass A\t\t\nt\tx\ty\t\n0,0\t0,0\t-1,0\t\n1,0E-1\t5,0E-1\t-1,5\t\n0,2\t1,0\t-2,0\t\n",
            "tracker");
        row("Tracker, semicolons", ";mass A;;\nt;x;y;\n0,0;0,0;-1,0;\n0,1;0,5;-1,5;\n0,2;1,0;-2,0;\n",
            "tracker");
        row("Tracker, commas", ",mass A,,,\nt,x,y,frame,\n0,0,-1,0,\n0.1,0.5,-1.5,1,\n0.2,1,-2,2,\n",
            "tracker");
        row("Tracker, spaces", "ball\nt x y\n0 0 -1\n0.1  0.5 -1.5\n0.2 1 -2\n", "tracker");
        row("Tracker, several",
            "#multi:\n\tA\t\tB\t\t\nt\tx\ty\tx\ty\t\n0\t0\t-1\t5\t5\t\n0.1\t0.5\t-1.5\t6\t6\t\n0.2\t1\t-"
            "2\t7\t7\t\n",
            "tracker");
        row("no header", "0,0,-1\n0.1,0.5,-1.5\n0.2,1,-2\n", "csv");
        row("no header, with tabs", "0\t0\t-1\n0.1\t0.5\t-1.5\n0.2\t1\t-2\n", "csv");
        row("no header, with clock times", "0:00:00.0;0;-1\n0:00:00.1;0,5;-1,5\n0:00:00.2;1;-2\n", "csv");
        row("points of ROS 2, without a frame", "0,0,,0,-1,0\n0,100000000,,0.5,-1.5,0\n0,200000000,,1,-2,0\n",
            "rosbag");
        row("transforms of ROS 2",
            "0,0,odom,base_link,0,-1,0,0,0,0,1\n0,100000000,odom,base_link,0.5,-1.5,0,0,0,0,1\n"
            "0,200000000,odom,base_link,1,-2,0,0,0,0,1\n",
            "rosbag");
        row("Tracker, named pairs", "t\txball (m)\tyball (m)\n0\t0\t-1\n0.1\t0.5\t-1.5\n0.2\t1\t-2\n",
            "tracker");
    }
    void layouts()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, format);
        QCOMPARE(shown(text), format + same);
    }
    /// Tracker leaves a cell blank where the robot was not marked, and ends each line with a delimiter.
    void blanksAreNoValues()
    {
        const QByteArray text =
            "#multi:\n\tred one\t\t\t\tB\t\t\t\t\nt\tx\ty\tpixelx\tpixely\tx\ty\tpixelx\tpixely\t\n"
            "0.0\t\t\t\t\t5.0\t6.0\t1\t2\t\n0.1\t1.0\t2.0\t3\t4\t\t\t\t\t\n0.2\t1.5\t2.5\t3\t4\t7.0\t8."
            "0\t1\t2\t\n"
            "0.3\t2.0\t3.0\t3\t4\t9.0\t9.5\t1\t2\t\n";
        QCOMPARE(shown(text), QStringLiteral("tracker|0 100000000 200000000 300000000|- 1 1.5 2|- 2 2.5 3"));
        QCOMPARE(shown(text, 1), QStringLiteral("tracker|0 100000000 200000000 300000000|5 - 7 9|6 - 8 9.5"));
        QCOMPARE(read(text)->tracks[0].name, std::string("red one"));
        QCOMPARE(read(text)->tracks[1].name, std::string("B"));
    }
    /// Two seconds of 1970 hold fewer nanoseconds than a double has digits; those of today do not.
    void timesAreExactToTheNanosecond()
    {
        const auto file = read("1305031102.175304001 0 0 0 0 0 0 1\n1305031102.175304002 0 0 0 0 0 0 "
                               "1\n1305031102.175304003 0 0 0 0 0 0 1\n");
        QVERIFY2(file, file ? "" : file.error().message().c_str());
        QCOMPARE(file->tracks[0].positions[1].time.count(), 1305031102175304002LL);
        QCOMPARE(read("t_ns,x,y\n1305031102175304001,0,0\n1305031102175304002,0,0\n1305031102175304003,0,0\n")
                     ->tracks[0]
                     .positions[2]
                     .time.count(),
                 1305031102175304003LL);
    }
    void statedErrors()
    {
        const auto file = read("t_s,x_mm,y_mm,sigma_x_mm,sigma_y_mm\n0,1,2,0.5,0.25\n1,1,2,,\n2,1,2,1,1\n");
        QVERIFY(file);
        QCOMPARE(*file->tracks[0].positions[0].sigmaM, Eigen::Vector2d(0.0005, 0.00025));
        QVERIFY(!file->tracks[0].positions[1].sigmaM);
    }
    void mistakes_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char *name, const QByteArray &text, const char *sentence) {
            QTest::newRow(name) << text << QString::fromUtf8(sentence);
        };
        const QByteArray csv = "t_s,x_mm,y_mm\n0,1,2\n";
        const QByteArray tum = "0 1 2 0 0 0 0 1\n";
        const char *header =
            ":1: it has no header with a time, x and y, and it is not a TUM file; begin the file with the "
            "line t_s,x_mm,y_mm, or write lines of timestamp tx ty tz qx qy qz qw";
        const char *order = "; sort the lines by time, with each time only once";
        row("empty", "",
            ":1: the file is empty; begin the file with the line t_s,x_mm,y_mm, or write lines of timestamp "
            "tx ty tz qx qy qz qw");
        row("blank lines", "\n\n",
            ":2: it has no header with a time, x and y, and it is not a TUM file; begin the file with the "
            "line t_s,x_mm,y_mm, or write lines of timestamp tx ty tz qx qy qz qw");
        const char *assumed =
            ":1: it has no header, and its columns do not look like time, x and y; begin the file with the "
            "line t_s,x_mm,y_mm, or write lines of timestamp tx ty tz qx qy qz qw";
        row("no header, four columns", "0,1,2,3\n1,2,3,4\n", header);
        row("no header, lines above", "run 1\n0,1,2\n1,2,3\n2,3,4\n",
            QByteArray(header).replace(":1", ":2").constData());
        row("no header, times last", "5,1,0\n4,2,1\n3,3,2\n", assumed);
        row("no header, x rises unevenly", "0,1,0\n0.1,2,0\n0.15,2,0\n0.3,2,0\n0.37,2,0\n0.6,2,0\n", assumed);
        row("no header, and nothing moves", "0,0,0\n1,0,0\n2,0,0\n", assumed);
        row("another header", "a,b,c\n", header);
        row("header alone", "t_s,x_mm,y_mm\n",
            ":1: the track has 0 positions; choose a file with three positions or more");
        row("one sample", csv, ":2: the track has 1 position; choose a file with three positions or more");
        row("two of a track", "\tA\t\tB\t\nt\tx\ty\tx\ty\t\n0\t1\t1\t1\t1\t\n1\t1\t1\t\t\t\n2\t1\t1\t\t\t\n",
            ":5: track 'B' has 1 position; choose a file with three positions or more");
        row("9 entries", tum + "1 2 3 0 0 0 0 1 9\n",
            ":2: it has 9 entries instead of the 8 of TUM; write timestamp tx ty tz qx qy qz qw, or begin "
            "the file with the line t_s,x_mm,y_mm");
        row("UTF-16 without a mark", QByteArray("t\0_\0s\0", 6),
            "': it is not a UTF-8 text file; save it again as UTF-8 text");
        row("NaN in TUM", tum + "1 nan 2 0 0 0 0 1\n",
            ":2: one of its two coordinates is blank; fill in both or none");
        row("NaN in CSV", csv + "1,NaN,2\n", ":3: one of its two coordinates is blank; fill in both or none");
        row("too large for a number", csv + "1,1e999,2\n",
            ":3: '1e999' is not a finite number; write it with digits, like 12.5, or leave the cell blank");
        // as many as a number may have; what follows them is not looked at
        const QByteArray letters = "nan" + QByteArray(61, '_');
        row("a time of 64 letters", csv + letters + ",1,2\n",
            (":3: '" + letters.left(40).toStdString() + "' is not a time; write it with digits, like 12.5")
                .c_str());
        row("no time", csv + ",1,2\n", ":3: '' is not a time; write it with digits, like 12.5");
        row("a time of no age", tum + "1e300 1 2 0 0 0 0 1\n",
            ":2: its time is more than a century from 1970; check the unit of the times, and that all "
            "lines are of one run");
        row("times with more between them than is counted", "t,x,y\n-9e9,0,0\n9e9,1,1\n",
            ":2: its time is more than a century from 1970; check the unit of the times, and that all "
            "lines are of one run");
        QByteArray many = "t";
        for (int track = 0; track < 1000; ++track)
            many += ",x,y";
        for (int line = 0; line <= 4000; ++line)
            many += '\n' + QByteArray::number(line) + QByteArray(2000, ',');
        row("blank places without end", many,
            ":1502: the file has more than 1.5 million positions; check that all lines are of one run");
        row("half a place", csv + "1,,2\n", ":3: one of its two coordinates is blank; fill in both or none");
        row("backwards", csv + "2,1,2\n1,1,2\n",
            (std::string(":4: its time is earlier than in the line before") + order).c_str());
        row("twice", csv + "1,1,2\n1,1,2\n",
            (std::string(":4: its time is the same as in the line before") + order).c_str());
        row("the same to the nanosecond", csv + "1.0000000001,1,2\n1.0000000002,1,2\n",
            (std::string(":4: its time is the same as in the line before") + order).c_str());
        row("mixed columns", csv + "1,1,2,3\n",
            ":3: it has 4 cells where the header has 3; give each line as many cells as the header");
        row("cut off", csv + "1,1\n2,1,2\n",
            ":3: it has 2 cells where the header has 3; give each line as many cells as the header");
        row("decimal commas among commas", csv + "1,5,1,0,2,0\n",
            ":3: it has 6 cells where the header has 3; give each line as many cells as the header");
        row("far away", tum + "1 1e9 2 0 0 0 0 1\n",
            ":2: its position is more than 100 km away; check the unit of the positions: m, cm or mm");
        row("over a week", csv + "604801,1,2\n",
            ":3: it is more than a week after the first line; check the unit of the times, and that all "
            "lines are of one run");
        row("unknown unit", "t [s],x [yd],y [yd]\n",
            ":1: its column 'x [yd]' is in a unit that is not known; give times in s or ms and positions in "
            "m, cm or mm");
        row("a word", csv + "1,=1+1,2\n",
            ":3: '=1+1' is not a finite number; write it with digits, like 12.5, or leave the cell blank");
    }
    void mistakes()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, sentence);
        QCOMPARE(shown(text), sentence);
    }
    void noFile()
    {
        const auto file = readTrackFile("/nowhere/run.csv", TrackReading(), JobControl());
        QVERIFY(!file && file.error().code == ErrorCode::NotFound);
        QVERIFY(!read(QByteArray("t_s,x_mm,y_mm\n\xff\xfe\0", 17)));
    }
    /// An hour at 60 frames a second, in one go, and cancelled.
    void anHourOfPositions()
    {
        QByteArray text = "t_s,x_mm,y_mm\n";
        for (int i = 0; i < 216000; ++i)
            text += QByteArray::number(i / 60.0, 'f', 9) + ',' + QByteArray::number(i) + ",-1\n";
        const auto file = read(text);
        QVERIFY(file);
        QCOMPARE(file->tracks[0].positions.size(), std::size_t(216000));
        QCOMPARE(file->tracks[0].positions.back().position->x(), 215.999);
        JobControl control;
        control.progress = [&](double, const Message &) { control.cancel.cancel(); };
        const auto stopped = readTrackFile(fileOf(text), TrackReading(), control);
        QVERIFY(!stopped && stopped.error().code == ErrorCode::Cancelled);
    }
    /// A character that begins in one block of the file and ends in the next; and what begins and never ends.
    void charactersAcrossBlocks()
    {
        const QByteArray table = "t_s,x_mm,y_mm\n0,0,-1000\n0.1,500,-1500\n0.2,1000,-2000\n";
        for (qsizetype before = (1 << 16) - 4; before <= 1 << 16; ++before)
            QCOMPARE(shown('#' + QByteArray(before - 1, 'x') + "\u4e2d\n" + table),
                     QStringLiteral("csv") + same);
        // As Windows-1252 writes "ä¸", it is a last line that was cut.
        QCOMPARE(shown(table + "\xe4\xb8"), QStringLiteral("csv") + same);
    }
    /// No file takes more memory than the positions in it, and those are bounded.
    void tooLong()
    {
        QCOMPARE(shown("t_s,x_mm,y_mm\n" + QByteArray(9 << 20, '1')),
                 QStringLiteral(":2: it is longer than 8 MiB; check that it is the right file"));
        QByteArray text = "t_s,x_mm,y_mm\n";
        for (int i = 0; i <= 1'500'000; ++i)
            text += QByteArray::number(i) + "e-3,1,2\n";
        QCOMPARE(shown(text), QStringLiteral(":1500002: the file has more than 1.5 million positions; check "
                                             "that all lines are of one run"));
    }
    /// Of a line, of a header, and of a whole table of which three are meant.
    void aMillionColumns()
    {
        constexpr qsizetype million = 1'000'000;
        QCOMPARE(shown("t_s,x_mm,y_mm\n0,1,2\n1" + QByteArray(",1").repeated(million) + '\n'),
                 QStringLiteral(":3: it has 1000001 cells where the header has 3; give each line as many "
                                "cells as the header"));
        QVERIFY(shown(QByteArray("a,").repeated(million) + '\n')
                    .startsWith(QStringLiteral(":1: it has no header with a time, x and y")));
        const std::clock_t begin = std::clock();
        const QByteArray wide = ",\"n\"" + QByteArray(",0").repeated(million);
        QCOMPARE(shown("t_s,x_m,y_m" + QByteArray(",n").repeated(million + 1) + "\n0,0,-1" + wide +
                       "\n0.1,0.5,-1.5" + wide + "\n0.2,1,-2" + wide + '\n'),
                 QStringLiteral("csv") + same);
        const double tookS = double(std::clock() - begin) / CLOCKS_PER_SEC;
        QVERIFY2(tookS < test::slowness, qPrintable(QString::number(tookS)));
    }
    void sameInEveryLocale()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        test::CLocales locales;
        for (const char *name : {"de_DE", "fr_FR", "tr_TR"}) {
            QVERIFY2(locales.use(name), name);
            QCOMPARE(shown("T [S];X [M];Y [M]\n0;0;-1\n0,1;0,5;-1,5\n0.2;1;-2\n"),
                     QStringLiteral("csv") + same);
        }
        QLocale::setDefault(QLocale::c());
    }
};

ODOGRAPH_TEST(TestTrackFile, QCoreApplication)
#include "tst_track_file.moc"
