// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/html_page.h"

#include "core/analysis/gate_passages.h"
#include "core/project/project.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/track_warnings.h"
#include "ui/models/explanation.h"
#include "ui/models/results.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/shown_message.h"
#include "ui/models/verdict_mark.h"
#include "ui/report/internal/html_figures.h"
#include "ui/report/internal/html_style.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/internal/trial_content.h"
#include "ui/report/trial_report.h"
#include "ui/views/curves/comparison_curves.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace odo {

namespace {

constexpr int mostSpikeRows = 200;

class HtmlPageWords
{
    Q_DECLARE_TR_FUNCTIONS(HtmlPage)
};

Message pageSubject()
{
    return ODO_TEXT("ui.html_page", "page");
}

QString exactNumber(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

/// Writes the sections of one page.
class HtmlPage
{
public:
    explicit HtmlPage(HtmlWriter &page) : m_page(page) {}

    void head(const QString &title, const QString &language)
    {
        m_page.raw(QStringLiteral("<!DOCTYPE html>\n"));
        m_page.open("html", {{"lang", QString(language).replace(u'_', u'-')}});
        m_page.open("head");
        m_page.shape("meta", {{"charset", QStringLiteral("utf-8")}});
        m_page.shape("meta", {{"name", QStringLiteral("viewport")},
                              {"content", QStringLiteral("width=device-width, initial-scale=1")}});
        m_page.shape("meta", {{"name", QStringLiteral("generator")},
                              {"content", QStringLiteral("Odograph " ODOGRAPH_VERSION)}});
        m_page.element("title", title);
        m_page.open("style");
        m_page.raw(htmlStyle());
        m_page.close();
        m_page.close();
        m_page.open("body");
        m_page.open("header");
        m_page.element("h1", title);
        m_page.close();
        m_page.open("main");
    }
    void foot()
    {
        m_page.close();
        m_page.element("footer", HtmlPageWords::tr("Made by Odograph %1; ± is one standard deviation.")
                                     .arg(QStringLiteral(ODOGRAPH_VERSION)));
        m_page.close();
        m_page.close();
    }
    void run(const TrialContent &content, std::size_t robot, bool isAlone);
    void comparison(const ComparisonScene &scene);
    void notCompared(const Error &why);

private:
    void verdict(const TrialVerdict &verdict);
    void metrics(const Profile &profile);
    void laps(const Profile &profile);
    void spikes(const SceneRobot &robot);
    void differences(const QString &caption, const DifferenceModel &model, const ComparisonScene &scene);
    void list(const QString &title, const QStringList &lines);
    void tableHead(const QString &caption, const QStringList &columns);
    void tableEnd();

    HtmlWriter &m_page;
};

void HtmlPage::tableHead(const QString &caption, const QStringList &columns)
{
    m_page.open("div", {{"class", QStringLiteral("scroll")}});
    m_page.open("table");
    m_page.element("caption", caption);
    m_page.open("thead");
    m_page.open("tr");
    for (const QString &column : columns)
        m_page.element("th", column, {{"scope", QStringLiteral("col")}});
    m_page.close();
    m_page.close();
    m_page.open("tbody");
}

void HtmlPage::tableEnd()
{
    for (int open = 0; open < 3; ++open)
        m_page.close();
}

void HtmlPage::list(const QString &title, const QStringList &lines)
{
    if (lines.isEmpty())
        return;
    m_page.element("h3", title);
    m_page.open("ul");
    for (const QString &line : lines)
        m_page.element("li", literalName(line));
    m_page.close();
}

void HtmlPage::verdict(const TrialVerdict &verdict)
{
    if (verdict.checks.empty())
        return;
    const char *level = verdict.level() == CheckLevel::Pass  ? "verdict pass"
                        : verdict.level() == CheckLevel::Bad ? "verdict bad"
                                                             : "verdict doubtful";
    m_page.open("div", {{"class", QLatin1String(level)}});
    m_page.element("strong", HtmlPageWords::tr("Verdict: %1").arg(shownVerdict(verdict)));
    for (const QString &reason : verdictReasons(verdict))
        m_page.element("p", literalName(reason));
    m_page.close();
}

/// Each with its exact value in SI beside what is shown.
void HtmlPage::metrics(const Profile &profile)
{
    tableHead(HtmlPageWords::tr("Metrics"), {HtmlPageWords::tr("metric"), HtmlPageWords::tr("value"),
                                             QStringLiteral("±"), HtmlPageWords::tr("unit")});
    for (const Metric &metric : profile.metrics) {
        const NumberText number = metricNumber(metric);
        m_page.open("tr", {{"data-metric", QString::fromStdString(metric.name)},
                           {"data-unit", QString::fromStdString(metric.unit)}});
        m_page.element("th", metricName(metric.name), {{"scope", QStringLiteral("row")}});
        m_page.open("td");
        m_page.element("data", (metric.isAtLeast ? QStringLiteral("≥ ") : QString()) + number.value,
                       {{"value", exactNumber(metric.value)}});
        m_page.close();
        m_page.open("td");
        if (metric.sigma)
            m_page.element("data", number.sigma, {{"value", exactNumber(*metric.sigma)}});
        m_page.close();
        m_page.element("td", number.unit);
        m_page.close();
    }
    tableEnd();
}

void HtmlPage::laps(const Profile &profile)
{
    const std::vector<Lap> laps = lapsOf(profile.passages);
    if (laps.empty())
        return;
    tableHead(HtmlPageWords::tr("Splits"),
              {HtmlPageWords::tr("from the start to"), HtmlPageWords::tr("time")});
    const auto row = [&](const QString &name, double timeS, double sigmaS) {
        m_page.open("tr");
        m_page.element("th", literalName(name), {{"scope", QStringLiteral("row")}});
        m_page.element("td", numberText(timeS, sigmaS, QStringLiteral("s")).text());
        m_page.close();
    };
    for (std::size_t i = 0; i < laps.size(); ++i) {
        row(HtmlPageWords::tr("Run %1").arg(i + 1), laps[i].timeS, laps[i].sigmaS);
        for (const Sector &sector : laps[i].sectors)
            if (laps[i].sectors.size() > 1)
                row(HtmlPageWords::tr("sector to %1").arg(QString::fromStdString(sector.gate)), sector.timeS,
                    sector.sigmaS);
    }
    tableEnd();
}

void HtmlPage::spikes(const SceneRobot &robot)
{
    const std::vector<Spike> &spikes = robot.analysis->profile.spikes;
    if (spikes.empty()) {
        m_page.element("p", HtmlPageWords::tr("No spikes."));
        return;
    }
    tableHead(HtmlPageWords::tr("Spikes: %n", "", int(spikes.size())),
              {HtmlPageWords::tr("time"), HtmlPageWords::tr("reason")});
    for (const Spike &spike : spikes) {
        if (&spike - spikes.data() == mostSpikeRows)
            break;
        m_page.open("tr");
        m_page.element("td", secondsText(spike.time));
        m_page.element("td", literalName(shownWords(spike.reason)));
        m_page.close();
    }
    tableEnd();
    if (const auto count = int(spikes.size()); count > mostSpikeRows)
        m_page.element("p", HtmlPageWords::tr("and %n more", "", count - mostSpikeRows));
}

void HtmlPage::run(const TrialContent &content, std::size_t robot, bool isAlone)
{
    const TrialScene &scene = *content.scene;
    const SceneRobot &shown = scene.robots[robot];
    m_page.open("section");
    if (!isAlone)
        m_page.element("h2", trialTitle(scene, robot));
    m_page.element("p", trialHeadFacts(scene, robot).join(QStringLiteral(" · ")),
                   {{"class", QStringLiteral("facts")}});
    verdict(scene.verdict);
    m_page.open("div", {{"class", QStringLiteral("figures")}});
    writeRunMap(m_page, scene, robot);
    writeRunCharts(m_page, shown.analysis->profile);
    m_page.close();
    metrics(shown.analysis->profile);
    laps(shown.analysis->profile);
    spikes(shown);
    QStringList remarks;
    if (!shown.analysis->ambiguousNames.empty())
        remarks << fullSentence(
            shownWords(ambiguousNamesText(shown.analysis->ambiguousNames, shown.robot.name)));
    for (const Occlusion &one : shown.occlusions)
        remarks << fullSentence(occlusionText(one));
    if (!scene.trial.notes.empty())
        remarks << QString::fromStdString(scene.trial.notes);
    list(HtmlPageWords::tr("Remarks"), remarks);
    list(HtmlPageWords::tr("Where this comes from"), provenanceLines(content, robot));
    m_page.close();
}

void HtmlPage::differences(const QString &caption, const DifferenceModel &model, const ComparisonScene &scene)
{
    if (model.rowCount() == 0)
        return;
    tableHead(caption, {QString(), literalName(scene.name(0)), literalName(scene.name(1)),
                        HtmlPageWords::tr("difference")});
    for (int row = 0; row < model.rowCount(); ++row) {
        const bool isSignificant = model.index(row, 0).data(DifferenceModel::SignificantRole).toBool();
        m_page.open("tr",
                    isSignificant ? HtmlAttributes{} : HtmlAttributes{{"class", QStringLiteral("faint")}});
        for (int column = 0; column < model.columnCount(); ++column)
            m_page.element(column == 0 ? "th" : "td", literalName(model.index(row, column).data().toString()),
                           column == 0 ? HtmlAttributes{{"scope", QStringLiteral("row")}} : HtmlAttributes{});
        m_page.close();
    }
    tableEnd();
}

void HtmlPage::comparison(const ComparisonScene &scene)
{
    m_page.open("section");
    m_page.element("h2", HtmlPageWords::tr("Comparison"));
    m_page.open("p", {{"class", QStringLiteral("facts")}});
    for (std::size_t run = 0; run < scene.runCount(); ++run) {
        m_page.element("span", QString(), {{"class", QStringLiteral("key s%1").arg(run)}});
        m_page.element("span", literalName(scene.name(run)));
    }
    m_page.close();
    m_page.element("p", scene.trials.shareCalibration
                            ? HtmlPageWords::tr("Both runs share their calibration: its uncertainty largely "
                                                "cancels. ≈: not significant.")
                            : HtmlPageWords::tr("The runs have different calibrations: the uncertainties of "
                                                "both count. ≈: not significant."));
    m_page.open("div", {{"class", QStringLiteral("figures")}});
    writeComparedMap(m_page, scene);
    const PathSpan span = comparedSpan(scene);
    const auto chart = [&](Compared what, const QString &title, const QString &remark) {
        ChartDrawing drawing;
        drawing.content = comparedContent(scene, what);
        drawing.axes = comparedAxes(what);
        drawing.low = span.lowM;
        drawing.high = span.highM;
        writeChart(m_page, drawing, title, remark);
    };
    chart(Compared::Speed, HtmlPageWords::tr("Speed over distance, %1").arg(comparedUnit(Compared::Speed)),
          HtmlPageWords::tr("with its ±95 % band"));
    chart(Compared::TimeDifference, HtmlPageWords::tr("Time difference, s"),
          HtmlPageWords::tr("above 0: the second run is later; grey: not significant"));
    m_page.close();
    DifferenceModel sectors, metrics;
    sectors.setSectors(scene.compared.sectors, 1);
    metrics.setMetrics(scene.compared.metrics.front());
    differences(HtmlPageWords::tr("Sectors, s"), sectors, scene);
    differences(HtmlPageWords::tr("Metrics"), metrics, scene);
    m_page.close();
}

/// Two runs that cannot be compared are still shown, with the reason.
void HtmlPage::notCompared(const Error &why)
{
    m_page.open("section");
    m_page.element("h2", HtmlPageWords::tr("Comparison"));
    m_page.element("p", literalName(errorInWords(why)));
    m_page.close();
}

/// Of a trial its robots that were tracked: all, or the one named.
Result<std::vector<std::size_t>> shownRobots(const TrialScene &scene, const std::string &name)
{
    std::vector<std::size_t> shown;
    std::vector<std::string> tracked;
    for (std::size_t robot = 0; robot < scene.robots.size(); ++robot) {
        if (!scene.robots[robot].analysis)
            continue;
        tracked.push_back(scene.robots[robot].robot.name);
        if (name.empty() || tracked.back() == name)
            shown.push_back(robot);
    }
    const Message what = ODO_TEXT("ui.page_of_trial", "page of trial '%1'")(Named::trial(scene.trial.name));
    if (tracked.empty())
        return fail(ErrorCode::NotFound, what, notTrackedYet(), trackItFirst());
    if (shown.empty())
        return fail(ErrorCode::NotFound, what, robotNotTracked(name, tracked), chooseAnotherOne());
    return shown;
}

} // namespace

Result<std::string> htmlPage(Project &project, const HtmlPageSettings &settings, const JobControl &control)
{
    std::vector<std::string> trials;
    for (const std::string &trial : settings.trials)
        if (std::ranges::find(trials, trial) == trials.end())
            trials.push_back(trial);
    TrialContentReader reader(project, StillMoment::None);
    HtmlWriter writer;
    HtmlPage page(writer);
    std::vector<std::pair<TrialContentPtr, std::vector<std::size_t>>> sections;
    for (const std::string &trial : trials) {
        if (control.isCancelled())
            return cancelled(pageSubject());
        auto content = ODO_TRY(reader.read(trial, control.cancel));
        auto robots = ODO_TRY(shownRobots(*content->scene, settings.robot));
        sections.emplace_back(std::move(content), std::move(robots));
    }
    const bool isAlone = sections.size() == 1 && sections.front().second.size() == 1;
    page.head(isAlone ? trialTitle(*sections.front().first->scene, sections.front().second.front())
                      : literalName(ODO_TRY(project.title())),
              settings.language);
    if (sections.size() == 2) {
        CompareSettings compared;
        for (const auto &[content, robots] : sections)
            compared.runs.push_back(
                {content->scene->trial.name, content->scene->robots[robots.front()].robot.name});
        const auto scene = loadComparisonScene(project, compared);
        if (scene)
            page.comparison(**scene);
        else
            page.notCompared(scene.error());
    }
    for (const auto &[content, robots] : sections)
        for (const std::size_t robot : robots) {
            if (control.isCancelled())
                return cancelled(pageSubject());
            page.run(*content, robot, isAlone);
        }
    page.foot();
    return writer.take().toStdString();
}

} // namespace odo
