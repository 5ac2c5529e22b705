// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of trials as CSV, byte by byte, and as workbooks, by the XML in them.
#include "core/exchange/trial_table.h"

#include "tests/support/registered_test.h"

#include <QDateTime>
#include <QTemporaryDir>
#include <QTest>
#include <archive.h>
#include <archive_entry.h>
#include <limits>
#include <map>

using namespace odo;

namespace {

TrialRecord trial(const std::string &name, const std::string &team)
{
    TrialRecord record;
    record.name = name;
    record.teamName = team;
    record.className = team.empty() ? "" : "9B";
    record.task = "Circle";
    // in local time, as it is written
    record.date = Instant(
        std::chrono::milliseconds(QDateTime(QDate(2026, 11, 29), QTime(10, 30, 5)).toMSecsSinceEpoch()));
    return record;
}

TrialVerdict verdict(CheckLevel level)
{
    return {{{"views_agree", CheckLevel::Pass, foreignWords("The views agree.")},
             {"few_gaps", level, foreignWords("It was not\nvisible for 2 s.")}}};
}

/// A good run, one with a lower bound whose verdict is not good, a bad one without a metric, an untracked
/// one.
ResultTable example()
{
    ResultTable table;
    table.columns = {{"max_speed", "m/s"}, {"max_accel", "m/s²"}, {"stops", "1"}};
    const Metric speed{"max_speed", "m/s", 1.25, 0.5}, accel{"max_accel", "m/s²", 3, {}, true},
        stops{"stops", "1", 2, {}};
    table.rows = {
        {trial("run 1", "Falcon"), "Red", verdict(CheckLevel::Pass), false, {speed, {}, stops}},
        {trial("a;b,\"c\"", "=1+1"), "Red", verdict(CheckLevel::Doubtful), true, {speed, accel, {}}},
        {trial("run 3", "Heron"), "Red", verdict(CheckLevel::Bad), false, {{}, accel, {}}},
        {trial("run 4", ""), "", {}, false, {{}, {}, {}}}};
    return table;
}

std::string csv(const ResultTable &table, CsvStyle style)
{
    return wholeText([&](const TextSink &sink) { return writeTrialTableCsv(table, style, sink); });
}

/// The files in a ZIP, by their names.
std::map<std::string, QByteArray> unzipped(const std::filesystem::path &file)
{
    std::map<std::string, QByteArray> files;
    archive *zip = archive_read_new();
    archive_read_support_format_zip(zip);
    archive_entry *entry = nullptr;
    if (archive_read_open_filename(zip, file.c_str(), 1 << 16) == ARCHIVE_OK)
        while (archive_read_next_header(zip, &entry) == ARCHIVE_OK) {
            QByteArray content(1 << 20, '\0');
            content.truncate(archive_read_data(zip, content.data(), std::size_t(content.size())));
            files[archive_entry_pathname(entry)] = content;
        }
    archive_read_free(zip);
    return files;
}

} // namespace

class TestTrialTable : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void csvOfPrograms()
    {
        QCOMPARE(
            csv(example(), CsvStyle::Analysis),
            std::string("trial,team,class,task,robot,date,verdict,max_speed_m_s,sigma_max_speed_m_s,"
                        "max_accel_m_s2,sigma_max_accel_m_s2,stops,sigma_stops,at_least,remarks\n"
                        "run 1,Falcon,9B,Circle,Red,2026-11-29T10:30:05,pass,1.25,0.5,,,2,,,\n"
                        "\"a;b,\"\"c\"\"\",'=1+1,9B,Circle,Red,2026-11-29T10:30:05,doubtful,1.25,0.5,3,,"
                        ",,max_accel,It was analysed with a different course than its task has now. It was "
                        "not\\x0avisible for 2 s.\n"
                        "run 3,Heron,9B,Circle,Red,2026-11-29T10:30:05,bad,,,3,,,,max_accel,It was "
                        "not\\x0avisible for 2 s.\n"
                        "run 4,,,Circle,,2026-11-29T10:30:05,not tracked,,,,,,,,\n"));
    }

    void csvOfSpreadsheets()
    {
        ResultTable table = example();
        table.rows.resize(1);
        const std::string international = csv(table, CsvStyle::International);
        QCOMPARE(international, "\xef\xbb\xbf" + csv(table, CsvStyle::Analysis));
        QVERIFY(csv(table, CsvStyle::Continental)
                    .ends_with("\nrun 1;Falcon;9B;Circle;Red;2026-11-29T10:30:05;pass;1,25;0,5;;;2;;;\n"));
        table.rows.front().metrics[0]->value = std::numeric_limits<double>::infinity();
        QVERIFY(csv(table, CsvStyle::Analysis).ends_with(",pass,,0.5,,,2,,,\n"));
    }

    void acceptedResultsSayWhy()
    {
        ResultTable table = example();
        table.rows.erase(table.rows.begin());
        table.rows.resize(1);
        table.rows.front().verdict->acceptance = VerdictAcceptance{"seen in the video", {}, {"few_gaps"}};
        const std::string text = csv(table, CsvStyle::Analysis);
        QVERIFY(text.find(",\"doubtful, accepted\",") != std::string::npos);
        QVERIFY(text.ends_with(" Accepted: seen in the video\n"));
    }

    void noTrials()
    {
        QCOMPARE(csv({}, CsvStyle::Analysis),
                 std::string("trial,team,class,task,robot,date,verdict,at_least,remarks\n"));
        const QTemporaryDir folder;
        QVERIFY(writeTrialTableXlsx({}, file(folder)));
    }

    void aWorkbookHasNumbersDatesAndAFrozenHeader()
    {
        const QTemporaryDir folder;
        const auto written = writeTrialTableXlsx(example(), file(folder));
        QVERIFY2(written, written ? "" : written.error().message().c_str());
        auto files = unzipped(file(folder));
        const QByteArray sheet = files["xl/worksheets/sheet1.xml"], texts = files["xl/sharedStrings.xml"],
                         styles = files["xl/styles.xml"];
        QVERIFY(sheet.contains("xSplit=\"1\" ySplit=\"1\" topLeftCell=\"B2\" activePane=\"bottomRight\" "
                               "state=\"frozen\""));
        QVERIFY(texts.contains("<t>Top speed (m/s)</t>") && texts.contains("<t>± Top speed (m/s)</t>"));
        QVERIFY(texts.contains("<t>=1+1</t>")); // a text, no formula
        QVERIFY(!sheet.contains("<f>"));
        QVERIFY(valueOf(sheet, "H2") == "1.25" && valueOf(sheet, "I2") == "0.5" &&
                valueOf(sheet, "L2") == "2");
        QVERIFY(!sheet.contains("r=\"J2\"")); // a metric that is missing
        // 29 November 2026 is day 46355 since 1899-12-30 (day 45658 is 1 January 2025), 10:30:05 of it
        // 0.43756
        QCOMPARE(valueOf(sheet, "F2").toDouble(), 46355 + (10 * 3600 + 30 * 60 + 5) / 86400.0);
        QVERIFY(styles.contains("formatCode=\"&quot;≥ &quot;0.000\""));
        QVERIFY(styleOf(sheet, "J3") != styleOf(sheet, "H3")); // a lower bound beside a value
        QVERIFY(styleOf(sheet, "G2").isEmpty());
        QVERIFY(!styleOf(sheet, "G3").isEmpty() && !styleOf(sheet, "G4").isEmpty());
        QVERIFY(styleOf(sheet, "G3") != styleOf(sheet, "G4"));
        QVERIFY(styleOf(sheet, "G5").isEmpty());
    }

    /// On a second sheet; without statistics there is none.
    void statisticsHaveASheet()
    {
        const QTemporaryDir folder;
        ResultTable table = example();
        table.statistics = {{"Falcon", 0, 4, 1.25, 1.2, 1, 1.5, 0.0625, 0.125, 0.1},
                            {"Heron", 2, 1, 2, 2, 2, 2, {}, {}, {}}};
        QVERIFY(writeTrialTableXlsx(table, file(folder)));
        auto files = unzipped(file(folder));
        QVERIFY(files["xl/workbook.xml"].contains("name=\"Statistics\""));
        const QByteArray sheet = files["xl/worksheets/sheet2.xml"];
        QVERIFY(valueOf(sheet, "C2") == "4" && valueOf(sheet, "D2") == "1.25" &&
                valueOf(sheet, "E2") == "0.0625" && valueOf(sheet, "G2") == "0.125" &&
                valueOf(sheet, "H2") == "0.1" && valueOf(sheet, "J2") == "1.5");
        QVERIFY(valueOf(sheet, "D3") == "2" && !sheet.contains("r=\"E3\""));
        QVERIFY(files["xl/styles.xml"].contains("formatCode=\"0.0%\""));
        QVERIFY(writeTrialTableXlsx(example(), file(folder)));
        QVERIFY(!unzipped(file(folder)).contains("xl/worksheets/sheet2.xml"));
    }

    void aWorkbookReplacesAnotherOnly()
    {
        const QTemporaryDir folder;
        QVERIFY(writeTrialTableXlsx(example(), file(folder)));
        QVERIFY(writeTrialTableXlsx(example(), file(folder)));
        QVERIFY(writeOutput(OutputTarget(file(folder), Existing::ReplaceAny), "Dear Anna,\n"));
        QVERIFY(writeTrialTableXlsx(example(), file(folder))
                    .error()
                    .message()
                    .find("a file of another kind has that name") != std::string::npos);
    }

    void aLongTextIsCut()
    {
        ResultTable table = example();
        table.rows[1].verdict->checks[1].text = foreignWords(std::string(40'000, 'x'));
        const QTemporaryDir folder;
        QVERIFY(writeTrialTableXlsx(table, file(folder)));
        QVERIFY(unzipped(file(folder))["xl/sharedStrings.xml"].contains(QByteArray(30'000, 'x')));
    }

private:
    static std::filesystem::path file(const QTemporaryDir &folder)
    {
        return folder.filePath(QStringLiteral("table.xlsx")).toStdString();
    }
    static QByteArray cell(const QByteArray &sheet, const QByteArray &name)
    {
        const auto from = sheet.indexOf("<c r=\"" + name + '"');
        return from < 0 ? QByteArray() : sheet.mid(from, sheet.indexOf("</c>", from) - from);
    }
    static QByteArray valueOf(const QByteArray &sheet, const QByteArray &name)
    {
        const QByteArray all = cell(sheet, name);
        return all.mid(all.indexOf("<v>") + 3, all.indexOf("</v>") - all.indexOf("<v>") - 3);
    }
    static QByteArray styleOf(const QByteArray &sheet, const QByteArray &name)
    {
        const QByteArray all = cell(sheet, name);
        const auto from = all.indexOf("s=\"");
        return from < 0 ? QByteArray() : all.mid(from, all.indexOf('"', from + 3) - from);
    }
};

ODOGRAPH_TEST(TestTrialTable, QCoreApplication)
#include "tst_trial_table.moc"
