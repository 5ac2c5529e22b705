// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/text_file.h"
#include "core/exchange/track_export.h"
#include "core/exchange/trial_json.h"
#include "core/files/output_file.h"
#include "tests/support/c_locales.h"
#include "tests/support/registered_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

const std::string header =
    "t_s,x_mm,y_mm,vx_mm_s,vy_mm_s,speed_mm_s,ax_mm_s2,ay_mm_s2,accel_mm_s2,sigma_x_mm,sigma_y_mm,"
    "sigma_speed_mm_s,sigma_accel_mm_s2,raw_x_mm,raw_y_mm,views,flags\n";

/// Three frames: a good one, one bridged over a gap, one where nothing is known.
AnalysisRecord sampleTrack()
{
    AnalysisRecord analysis;
    analysis.robotName = "red one";
    analysis.views = {"A", "B"};
    analysis.registrations = {3, 0};
    Profile &profile = analysis.profile;
    Sample seen;
    seen.position = Eigen::Vector2d(0.25, -1.5);
    seen.views = 3;
    Sample bridged;
    bridged.time = Nanoseconds(33333333);
    bridged.flags = flagBit(SampleFlag::Lost) | flagBit(SampleFlag::Interpolated);
    Sample lost;
    lost.time = Nanoseconds(66666667);
    lost.flags = flagBit(SampleFlag::Lost);
    profile.samples = {seen, bridged, lost};
    const ProfilePoint moving{{0.25, -1.5}, {0, 2}, {0.5, 0}, 0.001, 0.002, 2, 0.0625, 0.5, 0.25, true};
    ProfilePoint unknown = moving;
    unknown.valid = false;
    ProfilePoint standing = moving;
    standing.speedMps = 0.1;
    standing.velocity = {0.1, 0};
    standing.accelMps2 = std::numeric_limits<double>::quiet_NaN();
    profile.points = {moving, standing, unknown};
    profile.metrics = {{"max_speed", "m/s", 2, 0.0625}, {"duration", "s", 0.5, std::nullopt}};
    profile.spikes = {
        {1, Nanoseconds(33333333), flagBit(SampleFlag::Lost), foreignWords("no view found the robot")}};
    return analysis;
}

} // namespace

class TestTrackExport : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void csvForPrograms()
    {
        QCOMPARE(trackCsv(sampleTrack(), CsvStyle::Analysis),
                 header + "0,250,-1500,0,2000,2000,500,0,500,1,2,62.5,250,250,-1500,A+B,\n"
                          "0.033333333,250,-1500,100,0,100,500,0,,1,2,62.5,250,,,,lost|interpolated\n"
                          "0.066666667,,,,,,,,,,,,,,,,lost\n");
    }
    void csvForSpreadsheets()
    {
        QCOMPARE(trackCsv(sampleTrack(), CsvStyle::International),
                 "\xef\xbb\xbf" + trackCsv(sampleTrack(), CsvStyle::Analysis));
        const std::string continental = trackCsv(sampleTrack(), CsvStyle::Continental);
        QVERIFY(continental.starts_with("\xef\xbb\xbft_s;x_mm;y_mm;"));
        QVERIFY(continental.find("\n0;250;-1500;0;2000;2000;500;0;500;1;2;62,5;250;250;-1500;A+B;\n"
                                 "0,033333333;250;") != std::string::npos);
        QVERIFY(continental.ends_with("\n0,066666667;;;;;;;;;;;;;;;;lost\n"));
    }
    /// Columns are named after the unit; times are seconds in all of them.
    void inOtherUnits()
    {
        const auto in = [](const char *word) {
            return wholeText([&](const TextSink &sink) {
                return writeTrackCsv(sampleTrack(), CsvStyle::Analysis, sink, {}, *csvLengthFromWord(word));
            });
        };
        QCOMPARE(in("mm"), trackCsv(sampleTrack(), CsvStyle::Analysis));
        QVERIFY(
            in("m").starts_with("t_s,x_m,y_m,vx_m_s,vy_m_s,speed_m_s,ax_m_s2,ay_m_s2,accel_m_s2,sigma_x_m,"
                                "sigma_y_m,sigma_speed_m_s,sigma_accel_m_s2,raw_x_m,raw_y_m,views,flags\n"
                                "0,0.25,-1.5,0,2,2,0.5,0,0.5,0.001,0.002,0.0625,0.25,0.25,-1.5,A+B,\n"));
        QVERIFY(in("cm").find("\n0,25,-150,0,200,200,50,0,50,0.1,0.2,6.25,25,25,-150,A+B,\n") !=
                std::string::npos);
        QVERIFY(in("in").find("\n0,9.84251968503937,") != std::string::npos);
        QVERIFY(!csvLengthFromWord("ft"));
    }
    void textCellsAreNoFormulas()
    {
        AnalysisRecord analysis = sampleTrack();
        analysis.views = {"=cmd|'/C calc'!A0", "B,\"x\""};
        const std::string text = trackCsv(analysis, CsvStyle::Analysis);
        QVERIFY2(text.find(",\"'=cmd|'/C calc'!A0+B,\"\"x\"\"\",\n") != std::string::npos, text.c_str());
        QVERIFY(text.find(",-1500,") != std::string::npos); // numbers keep their sign
    }
    void stylesByName()
    {
        QVERIFY(*parseCsvStyle("continental") == CsvStyle::Continental);
        QCOMPARE(parseCsvStyle("german").error().message(),
                 std::string("style 'german' of CSV: this style does not exist; choose analysis, "
                             "international or continental"));
    }
    void numbersReadBackExactly()
    {
        for (double value : {0.1, 1.0 / 3, -1e-9, 123456.789e6, 5e-324, 1.7976931348623157e308}) {
            const double back = std::strtod(numberText(value).c_str(), nullptr);
            QVERIFY(back == value || std::abs(value) < 1e-300);
        }
    }

    void tum()
    {
        // The direction of motion is +Y; it is kept while the robot stands, and unknown points are left out.
        const std::string half = numberText(std::sqrt(0.5));
        const std::string text = trackTum(sampleTrack());
        const QStringList lines = QString::fromStdString(text).split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 2);
        for (const QString &line : lines) {
            QVERIFY(!line.endsWith(u' '));
            const QStringList cells = line.split(u' ');
            QCOMPARE(cells.size(), 8);
            QVERIFY(std::abs(cells[6].toDouble() - std::sqrt(0.5)) < 1e-15);
            QVERIFY(std::abs(cells[7].toDouble() - std::sqrt(0.5)) < 1e-15);
        }
        QVERIFY(text.starts_with("0 0.25 -1.5 0 0 0 0.707106781186547"));
        QVERIFY(lines[1].startsWith(QStringLiteral("0.033333333 0.25 -1.5 0 0 0 ")));
    }
    /// The heading of the body counts where it was measured, and the JSON says which of the two it is.
    void headingsOfTheBody()
    {
        AnalysisRecord analysis = sampleTrack();
        analysis.profile.points[1].body = BodyHeading{2 * std::acos(-1.0), 0.125, -1.5, 0.25};
        const QStringList lines = QString::fromStdString(trackTum(analysis)).split(u'\n', Qt::SkipEmptyParts);
        const QStringList cells = lines[1].split(u' ');
        QVERIFY(std::abs(cells[6].toDouble()) < 1e-15 && std::abs(std::abs(cells[7].toDouble()) - 1) < 1e-15);
        QVERIFY(!lines[0].endsWith(QStringLiteral(" 1")));
        const auto document =
            QJsonDocument::fromJson(QByteArray::fromStdString(trialJson({}, {}, {analysis})));
        const QJsonValue columns = document[QStringLiteral("robots")][0][QStringLiteral("columns")];
        const QJsonValue source = columns[QStringLiteral("heading_source")];
        QCOMPARE(source[0].toString(), QStringLiteral("motion"));
        QCOMPARE(source[1].toString(), QStringLiteral("body"));
        QVERIFY(source[2].isNull() && source.toArray().size() == 3);
        QCOMPARE(columns[QStringLiteral("sigma_heading_rad")][1].toDouble(), 0.125);
        QCOMPARE(columns[QStringLiteral("turn_rate_rad_s")][1].toDouble(), -1.5);
        QCOMPARE(columns[QStringLiteral("sigma_turn_rate_rad_s")][1].toDouble(), 0.25);
    }
    /// As evo's file_interface.read_tum_trajectory_file has it: cells parted by one blank, exactly eight in a
    /// line, all of them numbers.
    void tumAsEvoReadsIt()
    {
        const std::string text = trackTum(sampleTrack());
        QVERIFY(text.ends_with('\n') && text.find("\n\n") == std::string::npos &&
                text.find('\r') == std::string::npos);
        double before = -1;
        for (const QString &line : QString::fromStdString(text).chopped(1).split(u'\n')) {
            const QStringList cells = line.split(u' ');
            QCOMPARE(cells.size(), 8);
            double squares = 0;
            for (int i = 0; i < 8; ++i) {
                bool isNumber = false;
                const double number = cells[i].toDouble(&isNumber);
                QVERIFY2(isNumber && !cells[i].isEmpty(), qPrintable(line));
                squares += i < 4 ? 0 : number * number;
            }
            QVERIFY(std::abs(squares - 1) < 1e-12); // a unit quaternion
            QCOMPARE(cells[3], QStringLiteral("0"));
            QVERIFY(cells[0].toDouble() > before);
            before = cells[0].toDouble();
        }
    }
    /// By DataTool.parseData of Open Source Physics, with which Tracker reads: the first line with a single
    /// entry that is no number is the title, the next without a number the columns; a line counts whose
    /// entries are all numbers or blank, with as many columns as it has entries.
    void trackerAsTrackerReadsIt()
    {
        for (const char *name : {"red one", "42", "#1", "//x", "a;b,c\td", "-1e3"}) {
            AnalysisRecord analysis = sampleTrack();
            analysis.robotName = name;
            const QStringList lines = QString::fromStdString(trackTracker(analysis)).chopped(1).split(u'\n');
            QCOMPARE(lines.size(), 5);
            bool isNumber = false;
            lines[0].toDouble(&isNumber);
            QVERIFY2(!isNumber && !lines[0].contains(u'\t') && !lines[0].startsWith(u'#') &&
                         !lines[0].startsWith(QStringLiteral("//")),
                     name);
            QCOMPARE(lines[1], QStringLiteral("t\tx\ty"));
            for (const QString &line : lines.sliced(2)) {
                const QStringList cells = line.split(u'\t');
                QCOMPARE(cells.size(), 3);
                QVERIFY(!cells[0].isEmpty() && cells[1].isEmpty() == cells[2].isEmpty());
                for (const QString &cell : cells) {
                    cell.toDouble(&isNumber);
                    QVERIFY2(isNumber || cell.isEmpty(), qPrintable(line));
                }
            }
        }
    }
    void tracker()
    {
        QCOMPARE(trackTracker(sampleTrack()), std::string("red_one\nt\tx\ty\n0.0E0\t2.5E-1\t-1.5E0\n"
                                                          "3.3333333E-2\t2.5E-1\t-1.5E0\n"
                                                          "6.6666667E-2\t\t\n"));
    }
    void json()
    {
        TrialRecord trial;
        trial.name = "Lauf „1“";
        trial.date = Instant(std::chrono::milliseconds(1600000000123));
        RecordingRecord recording;
        recording.cameraName = "A";
        recording.frameTimes.resize(3);
        const auto document = QJsonDocument::fromJson(
            QByteArray::fromStdString(trialJson(trial, {recording}, {sampleTrack()})));
        const QJsonObject root = document.object();
        QCOMPARE(root[QStringLiteral("schema")].toString(), QStringLiteral("odograph.trial"));
        QCOMPARE(root[QStringLiteral("version")].toInt(), 1);
        const QJsonObject its = root[QStringLiteral("trial")].toObject();
        QCOMPARE(its[QStringLiteral("name")].toString(), QString::fromUtf8("Lauf „1“"));
        QCOMPARE(its[QStringLiteral("date")].toString(), QStringLiteral("2020-09-13T12:26:40.123Z"));
        QCOMPARE(root[QStringLiteral("views")][0][QStringLiteral("frames")].toInt(), 3);
        const QJsonValue robot = root[QStringLiteral("robots")][0];
        QCOMPARE(robot[QStringLiteral("name")].toString(), QStringLiteral("red one"));
        QVERIFY(robot[QStringLiteral("analysis")][QStringLiteral("registrations")][1].isNull());
        QCOMPARE(robot[QStringLiteral("metrics")][0][QStringLiteral("sigma")].toDouble(), 0.0625);
        QVERIFY(robot[QStringLiteral("metrics")][1][QStringLiteral("sigma")].isNull());
        QCOMPARE(robot[QStringLiteral("spikes")][0][QStringLiteral("flags")][0].toString(),
                 QStringLiteral("lost"));
        const QJsonValue columns = robot[QStringLiteral("columns")];
        QCOMPARE(columns[QStringLiteral("x_m")].toArray().size(), 3);
        QCOMPARE(columns[QStringLiteral("t_s")][1].toDouble(), 0.033333333);
        QVERIFY(columns[QStringLiteral("x_m")][2].isNull());
        QVERIFY(columns[QStringLiteral("accel_m_s2")][1].isNull()); // NaN
        const double up = std::acos(-1.0) / 2;
        QCOMPARE(columns[QStringLiteral("heading_rad")][0].toDouble(), up);
        QCOMPARE(columns[QStringLiteral("heading_rad")][1].toDouble(), up); // kept while it stands
        QVERIFY(columns[QStringLiteral("sigma_heading_rad")][1].isNull());
        QVERIFY(columns[QStringLiteral("heading_rad")][2].isNull());
        QCOMPARE(columns[QStringLiteral("turn_rate_rad_s")][0].toDouble(), -0.25);
    }

    void theLocaleDoesNotMatter()
    {
        const auto everything = [] {
            return trackCsv(sampleTrack(), CsvStyle::Analysis) +
                   trackCsv(sampleTrack(), CsvStyle::Continental) + trackTum(sampleTrack()) +
                   trackTracker(sampleTrack()) + trialJson({}, {}, {sampleTrack()});
        };
        const std::string before = everything();
        const QLocale locale;
        test::CLocales locales;
        for (const char *name : {"de_DE", "fr_FR", "tr_TR"}) {
            QLocale::setDefault(QLocale(QString::fromLatin1(name)));
            QVERIFY2(locales.use(name), name);
            const std::string after = everything();
            QLocale::setDefault(locale);
            QVERIFY2(after == before, name);
        }
    }

    void filesAppearWholeOrNotAtAll()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QString::fromUtf8("Läufe.csv")).toStdString();
        QVERIFY(writeOutput(file, "old").has_value());
        // What ends half way leaves the old file.
        const auto ended = writeOutput(file, [](const TextSink &sink) -> Result<void> {
            if (auto written = sink("half"); !written)
                return written;
            return cancelled(foreignWords("export"));
        });
        QCOMPARE(ended.error().code, ErrorCode::Cancelled);
        QCOMPARE(readTextFile(file).value(), std::string("old"));
        QVERIFY(writeOutput(file, "new").has_value());
        QCOMPARE(*readTextFile(file, 100), std::string("new"));
        QVERIFY(!writeOutput(file / "below a file", "x").has_value());
        QVERIFY(!writeOutput(std::filesystem::path(folder.path().toStdString()), "x").has_value());
        const auto entries = std::filesystem::directory_iterator(folder.path().toStdString());
        QCOMPARE(std::distance(begin(entries), end(entries)), std::ptrdiff_t(1));
    }
};

ODOGRAPH_TEST(TestTrackExport, QCoreApplication)
#include "tst_track_export.moc"
