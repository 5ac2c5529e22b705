// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/class_report.h"

#include "core/base/error.h"
#include "core/base/percentile.h"
#include "core/workflow/compare/standings_reading.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/report/internal/report_painting.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/curves/comparison_curves.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace odo {

Result<ClassContentPtr> readClassContent(Project &project, const ClassReportSettings &settings)
{
    auto trials = ODO_TRY(project.trials().all());
    auto reading = ODO_TRY(
        readStandings(project, std::move(trials), {settings.className, settings.task, settings.metric}));
    auto content = std::make_shared<ClassContent>();
    content->settings = settings;
    ClassReportSettings &chosen = content->settings;
    chosen.task = reading.standings.choice.task;
    chosen.metric = reading.standings.choice.metric;
    content->trials = reading.trials;
    content->leftOut = reading.leftOut;
    content->bad = reading.bad;
    content->standings = std::move(reading.standings);
    if (content->standings.teams.empty())
        return fail(
            ErrorCode::NotFound,
            ODO_TEXT("ui.report_of_class", "report of class '%1'")(Named::schoolClass(chosen.className)),
            chosen.task.empty()
                ? ODO_TEXT("ui.no_run_with_figure",
                           "none of its teams has a run with the metric '%1'")(chosen.metric)
                : ODO_TEXT("ui.no_run_with_figure_in_task",
                           "none of its teams has a run with the metric '%1' in the task '%2'")(
                      chosen.metric, Named::task(chosen.task)),
            ODO_TEXT("ui.track_or_choose_figure", "track its trials, or choose another task or metric"));
    return content;
}

namespace {

constexpr double metricsHeight = 66, partTitleHeight = 21, scaleHeight = 16, partGap = 10, footHeight = 30;
constexpr double leastRow = 17, mostRow = 25;

class ClassReportWords
{
    Q_DECLARE_TR_FUNCTIONS(ClassReport)
};

QString teamName(const TeamStanding &team)
{
    return literalName(shownTeam(team.team, team.pseudonym));
}

NumberText metricOf(const Standings &standings, double value, std::optional<double> sigma = std::nullopt)
{
    Metric metric = standings.teams.front().runs.front().metric; // its name and unit
    metric.value = value;
    metric.sigma = sigma;
    return metricNumber(metric);
}

QString medianText(const TeamStanding &team, const Standings &standings)
{
    const double sigma = team.statistics.sigma;
    return metricOf(standings, team.statistics.median, sigma > 0 ? std::optional(sigma) : std::nullopt)
        .text();
}

std::vector<double> allValues(const Standings &standings)
{
    std::vector<double> values;
    for (const TeamStanding &team : standings.teams)
        values.insert(values.end(), team.statistics.values.begin(), team.statistics.values.end());
    return values;
}

double bestOf(const Standings &standings)
{
    const std::vector<double> values = allValues(standings);
    return standings.isLessBetter ? std::ranges::min(values) : std::ranges::max(values);
}

QString marked(const QString &text, bool isDoubtful)
{
    return isDoubtful ? QStringLiteral("! ") + text : text;
}

/// How the columns of the ranking share the width.
struct Columns
{
    double rank, team, runs, best, median, strip; ///< what is left is for the progress
};
constexpr Columns columnWidths{24, 122, 50, 76, 92, 160};

/// What part of a ranking a page shows.
struct RankingPart
{
    std::size_t from = 0, to = 0;
    int page = 1, pages = 1;
    double rowHeight = mostRow;
};

class ClassPage
{
public:
    ClassPage(QPainter &painter, const ClassContent &content, const ReportOptions &options)
        : m_painter(painter), m_content(content), m_standings(content.standings), m_options(options),
          m_colours(ThemeColours::of(reportPalette()))
    {
    }
    void paintRanking(const QRectF &sheet, const RankingPart &part);
    void paintTeam(const QRectF &sheet, std::size_t index);

private:
    QRectF paintFrame(const QRectF &sheet, const QString &title, const QStringList &facts, int page,
                      int pages);
    void paintClassMedians(const QRectF &rect);
    void paintStrip(const QRectF &rect, const RankingPart &part);
    void paintRow(const QRectF &row, const TeamStanding &team);
    void paintRuns(const QRectF &rect, const TeamStanding &team);
    QStringList classFacts() const;

    QPainter &m_painter;
    const ClassContent &m_content;
    const Standings &m_standings;
    const ReportOptions &m_options;
    ThemeColours m_colours;
};

/// What counts, and what does not.
QStringList countingLines(const ClassContent &content)
{
    QStringList lines(
        ClassReportWords::tr("Rank: one more than the number of significantly better teams (medians differ "
                             "by more than 1.96 σ). Teams of the same rank do not differ significantly."));
    if (content.leftOut > 0)
        lines << ClassReportWords::tr(
            "%n trial(s) not counted: analysed with a different course. Reanalyse them.", "",
            content.leftOut);
    if (content.bad > 0)
        lines << ClassReportWords::tr("%n trial(s) not counted: bad results.", "", content.bad);
    int doubtful = 0;
    for (const TeamStanding &team : content.standings.teams)
        doubtful += team.doubtfulRuns();
    if (doubtful > 0)
        lines << ClassReportWords::tr("! %n trial(s) with doubtful results counted.", "", doubtful);
    return lines;
}

QRectF ClassPage::paintFrame(const QRectF &sheet, const QString &title, const QStringList &facts, int page,
                             int pages)
{
    QStringList foot = countingLines(m_content);
    foot << (pages > 1 ? ClassReportWords::tr("Page %1 of %2 · Odograph %3")
                             .arg(page)
                             .arg(pages)
                             .arg(QStringLiteral(ODOGRAPH_VERSION))
                       : ClassReportWords::tr("Odograph %1").arg(QStringLiteral(ODOGRAPH_VERSION)));
    return drawFoot(m_painter, drawHead(m_painter, sheet, m_options.letterhead, title, facts),
                    m_options.letterhead, foot);
}

QStringList ClassPage::classFacts() const
{
    QStringList facts;
    if (!m_standings.choice.task.empty())
        facts << ClassReportWords::tr("Task: %1").arg(literalName(m_standings.choice.task));
    facts << ClassReportWords::tr("by %1").arg(metricName(m_standings.choice.metric));
    Instant first = Instant::max(), last = Instant::min();
    for (const TeamStanding &team : m_standings.teams) {
        first = std::min(first, team.runs.front().date);
        last = std::max(last, team.runs.back().date);
    }
    const QString from = reportDay(first), to = reportDay(last);
    facts << (from == to ? from : ClassReportWords::tr("%1 to %2").arg(from, to));
    return facts;
}

void ClassPage::paintClassMedians(const QRectF &rect)
{
    std::vector<double> values = allValues(m_standings);
    const auto number = [](int count) { return NumberText{QLocale().toString(count), {}, {}}; };
    QList<ReportMetric> trialMetrics;
    trialMetrics << ReportMetric{ClassReportWords::tr("Teams"), number(int(m_standings.teams.size())), {}}
                 << ReportMetric{ClassReportWords::tr("Trials"), number(int(values.size())),
                                 m_content.trials > int(values.size())
                                     ? ClassReportWords::tr("of %1").arg(m_content.trials)
                                     : QString()}
                 << ReportMetric{ClassReportWords::tr("Best"), metricOf(m_standings, bestOf(m_standings)), {}}
                 << ReportMetric{ClassReportWords::tr("Median of all runs"),
                                 metricOf(m_standings, median(values)),
                                 {}};
    constexpr std::size_t leastForQuartiles = 4;
    std::ranges::sort(values);
    const auto quartile = [&](double part) {
        return values[std::size_t(std::lround(part * double(values.size() - 1)))];
    };
    if (values.size() >= leastForQuartiles)
        trialMetrics << ReportMetric{ClassReportWords::tr("Middle half of the runs"),
                                     metricOf(m_standings, quartile(0.75) - quartile(0.25)),
                                     ClassReportWords::tr("%1 to %2")
                                         .arg(metricOf(m_standings, quartile(0.25)).value,
                                              metricOf(m_standings, quartile(0.75)).text())};
    drawMetrics(m_painter, rect, trialMetrics);
}

/// Every run of the teams of a page as a dot on the scale of the class, the median of each as a line.
void ClassPage::paintStrip(const QRectF &rect, const RankingPart &part)
{
    constexpr int mostTicks = 5;
    // Beyond the outermost marks; of a row; so much lower the scale is on the line of the headings.
    constexpr double asidePx = 6, halfLine = 0.32, lower = 3;
    const std::vector<double> values = allValues(m_standings);
    const auto [low, high] = std::ranges::minmax(values);
    const double factor = metricUnit(m_standings.teams.front().runs.front().metric).perSi;
    const AxisTicks ticks =
        coveringTicks(low * factor, low * factor + std::max(1e-9, (high - low) * factor), mostTicks);
    const double aside = asidePx * (ticks.last() - ticks.first) / std::max(1.0, rect.width() - 2 * asidePx);
    ChartCurve dots, medians;
    dots.kind = ChartCurve::Kind::Points;
    dots.ink = ChartInk::Point;
    dots.widthPx = 2;
    medians.ink = ChartInk::Text;
    medians.widthPx = 2;
    CurveRun points;
    for (std::size_t team = part.from; team < part.to; ++team) {
        const double row = double(part.to - team) - 0.5; // from below
        for (const double value : m_standings.teams[team].statistics.values)
            points.points.emplace_back(factor * value, CurveValue{row, 0});
        const double median = factor * m_standings.teams[team].statistics.median;
        medians.runs.push_back(
            {0, {BandPoint(median, {row - halfLine, 0}), BandPoint(median, {row + halfLine, 0})}});
    }
    std::ranges::sort(points.points, {}, &BandPoint::x);
    dots.runs = {std::move(points)};
    auto content = std::make_shared<ChartContent>();
    content->curves = {std::move(dots), std::move(medians)};
    content->range = {0, double(part.to - part.from) - lower / part.rowHeight};
    drawChart(
        m_painter, rect.adjusted(0, lower, 0, 0),
        {std::move(content), {{}, {}, ChartStyle::Strip}, ticks.first - aside, ticks.last() + aside, {}},
        reportPalette(), reportFont(smallSize));
}

void ClassPage::paintRow(const QRectF &row, const TeamStanding &team)
{
    const QFont font = reportFont(smallSize + 1);
    double left = row.left();
    const auto cell = [&](double width, const QString &text, Qt::Alignment side,
                          QFont::Weight weight = QFont::Normal) {
        drawLine(m_painter, QRectF(left + 2, row.top(), width - 8, row.height()), text,
                 weight == QFont::Normal ? font : reportFont(smallSize + 1, weight), m_colours.text,
                 side | Qt::AlignVCenter);
        left += width;
    };
    cell(columnWidths.rank,
         m_standings.isRanked() ? QLocale().toString(team.statistics.rank) : QStringLiteral("–"),
         Qt::AlignRight, QFont::DemiBold);
    cell(columnWidths.team, teamName(team), Qt::AlignLeft);
    cell(columnWidths.runs, marked(QLocale().toString(int(team.runs.size())), team.doubtfulRuns() > 0),
         Qt::AlignRight);
    cell(columnWidths.best, metricOf(m_standings, team.progress.best).text(), Qt::AlignRight);
    cell(columnWidths.median, medianText(team, m_standings), Qt::AlignRight);
    left += columnWidths.strip;
    drawLine(m_painter, QRectF(left + 8, row.top(), row.right() - left - 8, row.height()),
             progressText(team, m_standings), reportFont(smallSize), m_colours.muted);
}

void ClassPage::paintRanking(const QRectF &sheet, const RankingPart &part)
{
    QRectF area =
        paintFrame(sheet, literalName(m_standings.choice.className), classFacts(), part.page, part.pages);
    if (part.page == 1) {
        paintClassMedians(QRectF(area.left(), area.top(), area.width(), metricsHeight));
        area.setTop(area.top() + metricsHeight + partGap);
    }
    area = drawPartTitle(m_painter, area, ClassReportWords::tr("The teams"),
                         ClassReportWords::tr("each run is a dot; the line is the median of the team"));
    const Columns &w = columnWidths;
    constexpr double stripGap = 14; // so that the scale keeps off the word before it
    const double stripLeft = area.left() + stripGap + w.rank + w.team + w.runs + w.best + w.median;
    const double rows = part.rowHeight * double(part.to - part.from);
    paintStrip(QRectF(stripLeft, area.top(), w.strip - stripGap, scaleHeight + rows), part);
    double left = area.left();
    const auto head = [&](double width, const QString &text, Qt::Alignment side) {
        drawLine(m_painter, QRectF(left + 2, area.top(), width - 8, scaleHeight), text, reportFont(smallSize),
                 m_colours.muted, side | Qt::AlignVCenter);
        left += width;
    };
    head(w.rank, ClassReportWords::tr("#"), Qt::AlignRight);
    head(w.team, ClassReportWords::tr("Team"), Qt::AlignLeft);
    head(w.runs, ClassReportWords::tr("Trials"), Qt::AlignRight);
    head(w.best, ClassReportWords::tr("Best"), Qt::AlignRight);
    head(w.median, ClassReportWords::tr("Median"), Qt::AlignRight);
    left += w.strip + 6;
    head(area.right() - left, ClassReportWords::tr("Over the term"), Qt::AlignLeft);
    double top = area.top() + scaleHeight;
    for (std::size_t team = part.from; team < part.to; ++team) {
        m_painter.setPen(QPen(m_colours.grid, 0.7));
        m_painter.drawLine(QPointF(area.left(), top), QPointF(area.right(), top));
        paintRow(QRectF(area.left(), top, area.width(), part.rowHeight), m_standings.teams[team]);
        top += part.rowHeight;
    }
}

/// Every run of a team, the newest below; in two columns where they are many.
void ClassPage::paintRuns(const QRectF &rect, const TeamStanding &team)
{
    QRectF area = drawPartTitle(m_painter, rect, ClassReportWords::tr("Its trials"));
    ReportTable table;
    table.weights = {0.3, 0.42, 0.28};
    table.alignments = {Qt::AlignLeft, Qt::AlignLeft, Qt::AlignRight};
    table.header = {ClassReportWords::tr("Date"), ClassReportWords::tr("Trial"),
                    metricName(m_standings.choice.metric)};
    const auto perColumn = std::size_t(std::max(1.0, area.height() / table.rowHeight - 1));
    const bool isWide = team.runs.size() > perColumn;
    const double width = isWide ? (area.width() - 20) / 2 : area.width() * 0.7;
    for (std::size_t column = 0; column < (isWide ? 2 : 1); ++column) {
        table.rows.clear();
        const std::size_t end = column == 1 || !isWide ? team.runs.size() : perColumn;
        for (std::size_t i = column * perColumn; i < end; ++i)
            table.rows << ReportTable::Row{
                {shortDate(team.runs[i].date), literalName(team.runs[i].trial),
                 marked(metricNumber(team.runs[i].metric).text(), team.runs[i].isDoubtful)},
                false,
                team.runs[i].metric.value == team.progress.best};
        drawTable(m_painter,
                  QRectF(area.left() + double(column) * (width + 20), area.top(), width, area.height()),
                  table);
    }
}

void ClassPage::paintTeam(const QRectF &sheet, std::size_t index)
{
    constexpr double trendHeight = 260;
    const TeamStanding &team = m_standings.teams[index];
    QStringList facts(ClassReportWords::tr("Class: %1").arg(literalName(m_standings.choice.className)));
    QRectF area = paintFrame(sheet, teamName(team), facts + classFacts(), 1, 1);
    QList<ReportMetric> trialMetrics;
    if (m_standings.isRanked())
        trialMetrics << ReportMetric{
            ClassReportWords::tr("Rank"),
            {QLocale().toString(team.statistics.rank), {}, {}},
            ClassReportWords::tr("of %n team(s)", "", int(m_standings.teams.size()))};
    trialMetrics << ReportMetric{ClassReportWords::tr("Best"), metricOf(m_standings, team.progress.best), {}};
    const double sigma = team.statistics.sigma;
    trialMetrics << ReportMetric{
        ClassReportWords::tr("Median"),
        metricOf(m_standings, team.statistics.median, sigma > 0 ? std::optional(sigma) : std::nullopt),
        ClassReportWords::tr("class median %1")
            .arg(metricOf(m_standings, median(allValues(m_standings))).text())};
    if (team.progress.spread)
        trialMetrics << ReportMetric{
            ClassReportWords::tr("Spread of one run"), metricOf(m_standings, *team.progress.spread), {}};
    drawMetrics(m_painter, QRectF(area.left(), area.top(), area.width(), metricsHeight), trialMetrics);
    area.setTop(area.top() + metricsHeight + partGap);
    const QRectF trend =
        drawPartTitle(m_painter, QRectF(area.left(), area.top(), area.width(), trendHeight),
                      ClassReportWords::tr("Over the term"), progressText(team, m_standings));
    drawChart(m_painter, trend, trendDrawing(team), reportPalette(), reportFont(smallSize));
    area.setTop(area.top() + trendHeight + partGap);
    paintRuns(area, team);
}

/// As many rows as fit on a page at a height between the least and the most.
std::vector<RankingPart> partsOf(const ClassContent &content, const PageFormat &format,
                                 const Letterhead &letterhead)
{
    const std::size_t teams = content.standings.teams.size();
    const auto lines = std::max<qsizetype>(2, countingLines(content).size()) + 1;
    const double head = 70, foot = 12.0 * double(lines + (letterhead.remark.isEmpty() ? 0 : 1)) + 10;
    const double later = format.content().height() - head - foot - partTitleHeight - scaleHeight,
                 first = later - metricsHeight - partGap;
    const double wanted = std::clamp(first / double(teams), leastRow, mostRow);
    const auto fits = [wanted](double area) { return std::size_t(area / wanted + 1e-6); };
    std::vector<RankingPart> parts;
    for (std::size_t from = 0; from < teams;) {
        const std::size_t to = std::min(teams, from + fits(parts.empty() ? first : later));
        parts.push_back({from, to, int(parts.size()) + 1, 1, wanted});
        from = to;
    }
    for (RankingPart &part : parts)
        part.pages = int(parts.size());
    return parts;
}

} // namespace

ReportPages classPages(const ClassContentPtr &content, const ReportOptions &options)
{
    const PageFormat format{options.paper, false};
    ReportPages pages;
    for (const RankingPart &part : partsOf(*content, format, options.letterhead))
        pages.push_back({format, [content, options, format, part](QPainter &painter) {
                             ClassPage(painter, *content, options).paintRanking(format.content(), part);
                         }});
    for (std::size_t team = 0; content->settings.withTeams && team < content->standings.teams.size(); ++team)
        pages.push_back({format, [content, options, format, team](QPainter &painter) {
                             ClassPage(painter, *content, options).paintTeam(format.content(), team);
                         }});
    return pages;
}

} // namespace odo
