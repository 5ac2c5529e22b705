// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/comparison_report.h"

#include "ui/models/comparison_scene.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/internal/run_painting.h"
#include "ui/report/internal/trial_content.h"
#include "ui/report/trial_report.h"
#include "ui/views/charts/chart_drawing.h"
#include "ui/views/curves/comparison_curves.h"
#include "ui/views/map/comparison_painting.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

namespace odo {

namespace {

constexpr int runStillWidthPx = 480;

class ComparisonReportWords
{
    Q_DECLARE_TR_FUNCTIONS(ComparisonReport)
};

/// One page: the first run against one of the others.
struct ComparisonContent
{
    ComparisonScenePtr scene;
    std::size_t other = 1;
    std::array<std::vector<Still>, 2> stills; ///< of the first run and the other one
};

class ComparisonPage
{
public:
    ComparisonPage(QPainter &painter, const ComparisonContent &content, const ReportOptions &options)
        : m_painter(painter), m_content(content), m_scene(*content.scene), m_options(options)
    {
    }
    void paint(const QRectF &sheet);

private:
    std::size_t runAt(int side) const { return side == 0 ? 0 : m_content.other; }
    void paintRun(const QRectF &rect, int side);
    void paintCurves(const QRectF &rect, Compared what, const QString &title, const QString &remark);
    void paintTable(const QRectF &rect, const QString &title, const DifferenceModel &model);
    QString alignedWords() const;

    QPainter &m_painter;
    const ComparisonContent &m_content;
    const ComparisonScene &m_scene;
    const ReportOptions &m_options;
};

/// Who drove, a few large figures, and the first view.
void ComparisonPage::paintRun(const QRectF &rect, int side)
{
    constexpr double lineHeight = 15, figureHeight = 50, keyWidth = 26;
    const ThemeColours colours = ThemeColours::of(reportPalette());
    const std::size_t run = runAt(side);
    const TrialScene &scene = *m_scene.scenes[run];
    QRectF room = drawPartTitle(m_painter, rect, QString());
    // The name stands beside its line of the charts.
    m_painter.setPen(QPen(seriesColour(int(run), reportPalette()), 2.2, seriesDash(int(run))));
    m_painter.drawLine(QPointF(rect.left(), rect.top() + 9),
                       QPointF(rect.left() + keyWidth - 5, rect.top() + 9));
    drawLine(m_painter, QRectF(rect.left() + keyWidth, rect.top(), rect.width() - keyWidth, 18),
             literalName(m_scene.name(run)), reportFont(bodySize, QFont::DemiBold), colours.text);
    QStringList facts;
    for (const QString &fact : {QString::fromStdString(scene.trial.className), shownTeam(scene.trial)})
        if (!fact.isEmpty())
            facts << literalName(fact);
    facts << reportDate(scene.trial.date);
    drawLine(m_painter, QRectF(room.left(), room.top(), room.width(), lineHeight),
             facts.join(QStringLiteral(" · ")), reportFont(smallSize + 1), colours.muted);
    room.setTop(room.top() + lineHeight + 6);
    QList<ReportFigure> figures;
    for (const Metric &metric : tellingMetrics(m_scene.profile(run).metrics, 4))
        figures << ReportFigure{metricName(metric.name), metricFigure(metric), {}};
    for (qsizetype i = 0; i < figures.size(); i += 2) {
        drawFigures(m_painter, QRectF(room.left(), room.top(), room.width(), figureHeight),
                    figures.mid(i, 2));
        room.setTop(room.top() + figureHeight + 4);
    }
    const auto &stills = m_content.stills[std::size_t(side)];
    if (!stills.empty())
        drawStill(m_painter, room, scene, 0, stills.front());
}

void ComparisonPage::paintCurves(const QRectF &rect, Compared what, const QString &title,
                                 const QString &remark)
{
    const QRectF room = drawPartTitle(m_painter, rect, title, remark);
    const PathSpan common = comparedSpan(m_scene);
    drawChart(m_painter, room,
              {comparedContent(m_scene, what, {0, m_content.other}),
               comparedAxes(what),
               common.lowM,
               common.highM,
               {}},
              reportPalette(), reportFont(smallSize));
}

void ComparisonPage::paintTable(const QRectF &rect, const QString &title, const DifferenceModel &model)
{
    const QRectF room = drawPartTitle(m_painter, rect, title,
                                      ComparisonReportWords::tr("± one σ; grey, ≈: within the error"));
    ReportTable table;
    table.weights = {0.28, 0.24, 0.24, 0.24};
    table.alignments = {Qt::AlignLeft, Qt::AlignRight, Qt::AlignRight, Qt::AlignRight};
    table.header = {QString(), ComparisonReportWords::tr("left"), ComparisonReportWords::tr("right"),
                    ComparisonReportWords::tr("right − left")};
    for (int row = 0; row < model.rowCount(); ++row) {
        ReportTable::Row line;
        for (int column = 0; column < model.columnCount(); ++column)
            line.cells << literalName(model.index(row, column).data().toString());
        line.isFaint = !model.index(row, 0).data(DifferenceModel::SignificantRole).toBool();
        table.rows << line;
    }
    drawTable(m_painter, room, table);
}

QString ComparisonPage::alignedWords() const
{
    const QString along = m_scene.compared.comparison.isTasksPath
                              ? ComparisonReportWords::tr("along the task’s path")
                              : ComparisonReportWords::tr("along the way of the left run");
    switch (m_scene.compared.comparison.alignedBy) {
    case AlignBy::StartGate:
        return ComparisonReportWords::tr("aligned by the start gate, %1").arg(along);
    case AlignBy::MotionOnset:
        return ComparisonReportWords::tr("aligned by the onset of motion, %1").arg(along);
    case AlignBy::Distance:
        return ComparisonReportWords::tr("aligned by a place that both pass, %1").arg(along);
    case AlignBy::ByHand:
        break;
    }
    return ComparisonReportWords::tr("aligned by hand, %1").arg(along);
}

void ComparisonPage::paint(const QRectF &sheet)
{
    constexpr double gap = 12, sideShare = 0.26, upperShare = 0.42, deltaShare = 0.5, tableShare = 0.44;
    const TrialScene &first = *m_scene.scenes.front();
    QStringList facts;
    if (!first.trial.task.empty())
        facts << ComparisonReportWords::tr("Task: %1").arg(literalName(first.trial.task));
    facts << alignedWords();
    QStringList foot;
    for (int side = 0; side < 2; ++side) {
        const AnalysisRecord &analysis = m_scene.trials.runs[runAt(side)].analysis;
        foot << ComparisonReportWords::tr("%1: analysed %2, Odograph %3")
                    .arg(literalName(m_scene.name(runAt(side))), reportDate(analysis.made),
                         literalName(analysis.softwareVersion));
    }
    foot << (m_scene.trials.shareCalibration
                 ? ComparisonReportWords::tr(
                       "Both runs share their calibration: its error cancels as far as they do.")
                 : ComparisonReportWords::tr(
                       "The runs do not share their calibration: the errors of both count."));
    const QRectF room =
        drawFoot(m_painter,
                 drawHead(m_painter, sheet, m_options.letterhead,
                          ComparisonReportWords::tr("%1 and %2")
                              .arg(literalName(m_scene.name(0)), literalName(m_scene.name(m_content.other))),
                          facts),
                 m_options.letterhead, foot);
    const double side = sideShare * room.width(), upper = upperShare * room.height();
    paintRun(QRectF(room.left(), room.top(), side, upper), 0);
    paintRun(QRectF(room.right() - side, room.top(), side, upper), 1);
    drawComparedMap(m_painter,
                    QRectF(room.left() + side + gap, room.top(), room.width() - 2 * (side + gap), upper),
                    m_scene, {0, m_content.other});
    const QRectF lower(room.left(), room.top() + upper + gap, room.width(), room.height() - upper - gap);
    const double tables = tableShare * lower.width();
    const QRectF charts(lower.left(), lower.top(), lower.width() - tables - gap, lower.height());
    const double speed = (1 - deltaShare) * charts.height();
    paintCurves(QRectF(charts.left(), charts.top(), charts.width(), speed - 4), Compared::Speed,
                ComparisonReportWords::tr("Speed along the way, %1").arg(comparedUnit(Compared::Speed)),
                ComparisonReportWords::tr("with its ±95 % band"));
    paintCurves(QRectF(charts.left(), charts.top() + speed, charts.width(), deltaShare * charts.height()),
                Compared::TimeDifference, ComparisonReportWords::tr("Time difference, s"),
                ComparisonReportWords::tr("above 0: the right run is later; grey: within the error"));
    DifferenceModel sectors, metrics;
    sectors.setSectors(m_scene.compared.sectors, m_content.other);
    metrics.setMetrics(m_scene.compared.metrics[m_content.other - 1]);
    QRectF right(lower.right() - tables, lower.top(), tables, lower.height());
    const double sectorHeight = 40 + 15 * std::min(5, sectors.rowCount());
    paintTable(QRectF(right.left(), right.top(), right.width(), sectorHeight),
               ComparisonReportWords::tr("Sectors, s"), sectors);
    right.setTop(right.top() + sectorHeight + 4);
    paintTable(right, ComparisonReportWords::tr("Figures"), metrics);
}

} // namespace

ReportPages comparisonPages(const ComparisonScenePtr &scene, const ReportOptions &options)
{
    const auto stillsOf = [&](std::size_t run) {
        return takeStills(*scene->scenes[run], tellingMoment(*scene->scenes[run]), runStillWidthPx);
    };
    const std::vector<Still> first = stillsOf(0);
    const PageFormat format{options.paper, true};
    ReportPages pages;
    for (std::size_t other = 1; other < scene->runCount(); ++other) {
        const auto content = std::make_shared<const ComparisonContent>(
            ComparisonContent{scene, other, {first, stillsOf(other)}});
        pages.push_back({format, [content, options, format](QPainter &painter) {
                             ComparisonPage(painter, *content, options).paint(format.content());
                         }});
    }
    return pages;
}

} // namespace odo
