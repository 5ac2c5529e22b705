// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/printed_text.h"
#include "tests/ui/support/stored_example.h"
#include "ui/models/shown_names.h"
#include "ui/report/internal/class_report.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;

namespace {

/// So many teams of a class with ten runs each, in days one after the other; times about 5 s.
ClassContentPtr contentOf(int teams, bool withTeams, const std::string &name = "Team")
{
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 0.2);
    std::vector<TrialRecord> trials;
    std::vector<TrialMetric> metrics;
    for (int team = 1; team <= teams; ++team)
        for (int run = 0; run < 10; ++run) {
            TrialRecord trial;
            trial.id = RecordId(trials.size()) + 1;
            trial.name = "Run " + std::to_string(trial.id);
            trial.team = team;
            trial.teamName = name + " " + std::to_string(team);
            trial.teamPseudonym = "Lion " + std::to_string(team);
            trial.className = "9B";
            trial.task = "Line";
            trial.date = Instant(std::chrono::hours(24 * (20000 + run)));
            metrics.push_back({trial.id, 1, {"duration", "s", 4 + 0.05 * team + noise(random), 0.01}});
            trials.push_back(trial);
        }
    std::vector<const TrialRecord *> all;
    for (const TrialRecord &trial : trials)
        all.push_back(&trial);
    auto content = std::make_shared<ClassContent>();
    content->settings = {"9B", "Line", "duration", withTeams};
    content->trials = int(trials.size());
    content->standings = standingsOf(all, metrics, {"9B", "Line", "duration"});
    return content;
}

} // namespace

class TestClassReport : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;

    QString printed(const ReportPages &pages) { return test::printed(pages, m_folder); }

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void cleanup() { showPseudonyms(false); }

    void aLineForEachTeam()
    {
        const QString file = printed(classPages(contentOf(40, false), {}));
        const PrintedWords words = printedWords(file);
        QCOMPARE(words.pageSizes.size(), 1); // forty teams fit on a page
        QCOMPARE(fontsNotEmbedded(file), QStringList());
        const QString text = printedText(file);
        for (int team = 1; team <= 40; ++team)
            QVERIFY2(text.contains(QStringLiteral("Team %1 ").arg(team)), qPrintable(QString::number(team)));
        for (const char *head :
             {"9B", "Task: Line", "by Time", "Median of all runs", "Middle half of the runs"})
            QVERIFY2(text.contains(QLatin1String(head)), head);
    }
    void manyTeamsTakeMorePages()
    {
        const QString file = printed(classPages(contentOf(130, false), {}));
        const int pages = int(printedWords(file).pageSizes.size());
        QCOMPARE(pages, 3);
        QVERIFY(printedText(file, 3).contains(QStringLiteral("Page 3 of 3")));
        QVERIFY(!printedText(file, 2).contains(QStringLiteral("Median of all runs")));
        const QString text = printedText(file);
        for (int team = 1; team <= 130; ++team)
            QCOMPARE(text.count(QStringLiteral(" Team %1 ").arg(team)), 1);
    }
    void eachTeamHasItsPageOnDemand()
    {
        const auto content = contentOf(3, true);
        const QString file = printed(classPages(content, {}));
        QCOMPARE(printedWords(file).pageSizes.size(), 4);
        const QString text = printedText(file, 2);
        const TeamStanding &first = content->standings.teams.front();
        for (const QString &words :
             {QString::fromStdString(first.team), QStringLiteral("Over the term"),
              QStringLiteral("Its trials"), QString::fromStdString(first.runs.back().trial),
              QStringLiteral("class median")})
            QVERIFY2(text.contains(words), qPrintable(words));
    }
    void pseudonymsAreShownWhereTheyAreWanted()
    {
        showPseudonyms(true);
        const QString text = printedText(printed(classPages(contentOf(3, true), {})));
        QVERIFY(text.contains(QStringLiteral("Lion 2")));
        QVERIFY(!text.contains(QStringLiteral("Team 2")));
    }
    void longNamesAreCut()
    {
        const PrintedWords words =
            printedWords(printed(classPages(contentOf(12, true, std::string(10000, 'W')), {})));
        for (const PrintedWord &word : words.words)
            QVERIFY(QRectF(QPointF(30, 30), words.pageSizes.at(word.page - 1) - QSizeF(60, 60))
                        .contains(word.box));
    }
    void whatIsAskedOfAProject()
    {
        const auto stored = storeExample(m_folder.path().toStdString());
        const auto project = Project::open(*stored, Project::Access::ReadWrite).value();
        const auto content = readClassContent(*project, {"9B", "Figure eight, 2 laps", "max_speed", false});
        QVERIFY2(content.has_value(), content ? "" : content.error().message().c_str());
        QCOMPARE((*content)->standings.teams.size(), std::size_t(1));
        QCOMPARE((*content)->standings.teams.front().team, std::string("Falcon"));
        QVERIFY(!readClassContent(*project, {"9B", {}, {}, false}).value()->settings.metric.empty());
        const auto no = [&](const ClassReportSettings &settings, const char *words) {
            const auto none = readClassContent(*project, settings);
            QCOMPARE(none.error().code, ErrorCode::NotFound);
            QVERIFY2(QString::fromStdString(none.error().message()).contains(QLatin1String(words)),
                     none.error().message().c_str());
        };
        no({"7C", {}, {}, false}, "the project has '9B'");
        no({"9B", "No such", {}, false}, "No such");
        no({"9B", "Figure eight, 2 laps", "no_such", false}, "none of its teams has a run");
    }
};

ODOGRAPH_TEST(TestClassReport, QApplication)
#include "tst_class_report.moc"
