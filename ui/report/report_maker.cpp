// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_maker.h"

#include "core/files/protected_files.h"
#include "core/project/project.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/results.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/models/verdict_mark.h"
#include "ui/report/internal/class_report.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/internal/run_painting.h"
#include "ui/report/internal/trial_content.h"
#include "ui/report/trial_report.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/curves/comparison_curves.h"
#include "ui/views/map/trial_map.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QImageReader>
#include <QLocale>
#include <QPainter>
#include <QSettings>
#include <QString>
#include <algorithm>

namespace odo {

Message reportSubject()
{
    return ODO_TEXT("ui.report", "report");
}

namespace {

Result<void> give(const ReportPages &pages, const PageSink &sink, const JobControl &control)
{
    for (const ReportPage &page : pages) {
        if (control.isCancelled())
            return cancelled(reportSubject());
        ODO_TRY(sink(page));
    }
    return {};
}

} // namespace

ReportMaker trialReports(std::vector<std::string> trials, const ReportOptions &options)
{
    return [trials = std::move(trials), options](Project &project, const JobControl &control,
                                                 const PageSink &sink) -> Result<void> {
        constexpr std::size_t few = 12;
        TrialContentReader reader(project,
                                  trials.size() > few ? StillMoment::KeyFrame : StillMoment::TopSpeed);
        for (std::size_t i = 0; i < trials.size(); ++i) {
            if (control.isCancelled())
                return cancelled(reportSubject());
            control.report(double(i) / double(trials.size()), nameAlone(Named::trial(trials[i])));
            const auto content = ODO_TRY(reader.read(trials[i], control.cancel));
            ODO_TRY(give(trialPages(content, options), sink, control));
        }
        return {};
    };
}

ReportMaker comparisonReport(CompareSettings settings, const ReportOptions &options)
{
    return [settings = std::move(settings), options](Project &project, const JobControl &control,
                                                     const PageSink &sink) -> Result<void> {
        control.report(0, {});
        const auto scene = ODO_TRY(loadComparisonScene(project, settings));
        return give(comparisonPages(scene, options), sink, control);
    };
}

ReportMaker classReport(ClassReportSettings settings, const ReportOptions &options)
{
    return [settings = std::move(settings), options](Project &project, const JobControl &control,
                                                     const PageSink &sink) -> Result<void> {
        control.report(0, nameAlone(Named::schoolClass(settings.className)));
        const auto content = ODO_TRY(readClassContent(project, settings));
        if (control.isCancelled())
            return cancelled(reportSubject());
        return give(classPages(content, options), sink, control);
    };
}

ReportMaker inTurn(std::vector<ReportMaker> makers)
{
    return [makers = std::move(makers)](Project &project, const JobControl &control,
                                        const PageSink &sink) -> Result<void> {
        for (std::size_t i = 0; i < makers.size(); ++i) {
            const double share = 1 / double(makers.size()), from = double(i) * share;
            ODO_TRY(makers[i](project, partOf(control, from, from + share), sink));
        }
        return {};
    };
}

Result<QImage> readLogo(const std::filesystem::path &file)
{
    constexpr qint64 mostPixels = 100'000'000;
    constexpr QSize shown(1400, 400); // ten times what a page shows: sharp in print
    const Message what = ODO_TEXT("ui.logo", "logo '%1'")(Named::file(file));
    ODO_TRY(checkMayBeRead(file, what));
    QImageReader reader(QString::fromStdString(file.string()));
    reader.setAutoTransform(true);
    const QSize size = reader.size();
    if (size.isValid() && qint64(size.width()) * size.height() > mostPixels)
        return fail(ErrorCode::Io, what,
                    ODO_TEXT("ui.logo_too_large", "it is larger than a hundred megapixels"),
                    ODO_TEXT("ui.make_smaller", "make it smaller"));
    if (size.isValid() && (size.width() > shown.width() || size.height() > shown.height()))
        reader.setScaledSize(size.scaled(shown, Qt::KeepAspectRatio));
    QImage image = reader.read();
    if (image.isNull())
        return fail(ErrorCode::Io, what, foreignWords(reader.errorString().toStdString()),
                    ODO_TEXT("ui.choose_logo", "choose a PNG, JPEG or SVG image"));
    return image;
}

namespace {

const QString schoolKey = QStringLiteral("report/school"), remarkKey = QStringLiteral("report/remark"),
              logoKey = QStringLiteral("report/logo"), paperKey = QStringLiteral("report/paper"),
              methodKey = QStringLiteral("report/method");

} // namespace

ReportSettings storedReportSettings()
{
    const QSettings stored;
    const bool isImperial = QLocale().measurementSystem() == QLocale::ImperialUSSystem;
    const QString usual = paperWord(isImperial ? Paper::Letter : Paper::A4);
    return {stored.value(schoolKey).toString(), stored.value(remarkKey).toString(),
            stored.value(logoKey).toString(), paperFromWord(stored.value(paperKey, usual).toString()),
            stored.value(methodKey).toBool()};
}

void storeReportSettings(const ReportSettings &settings)
{
    QSettings stored;
    stored.setValue(schoolKey, settings.school);
    stored.setValue(remarkKey, settings.remark);
    stored.setValue(logoKey, settings.logoFile);
    stored.setValue(paperKey, paperWord(settings.paper));
    stored.setValue(methodKey, settings.withMethod);
}

ReportMaker reportBy(const ReportSettings &settings, std::function<ReportMaker(const ReportOptions &)> of)
{
    return [settings, of = std::move(of)](Project &project, const JobControl &control, const PageSink &sink) {
        ReportOptions options{settings.paper, {settings.school, settings.remark, {}}, settings.withMethod};
        if (!settings.logoFile.isEmpty())
            options.letterhead.logo = readLogo(settings.logoFile.toStdString()).value_or(QImage());
        return of(options)(project, control, sink);
    };
}

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

/// Who drove, a few large metrics, and the first view.
void ComparisonPage::paintRun(const QRectF &rect, int side)
{
    constexpr double lineHeight = 15, metricHeight = 50, keyWidth = 26;
    const ThemeColours colours = ThemeColours::of(reportPalette());
    const std::size_t run = runAt(side);
    const TrialScene &scene = *m_scene.scenes[run];
    QRectF area = drawPartTitle(m_painter, rect, QString());
    // The name is beside its line of the charts.
    m_painter.setPen(QPen(seriesColour(int(run), reportPalette()), 2.2, seriesDash(int(run))));
    m_painter.drawLine(QPointF(rect.left(), rect.top() + 9),
                       QPointF(rect.left() + keyWidth - 5, rect.top() + 9));
    drawLine(m_painter, QRectF(rect.left() + keyWidth, rect.top(), rect.width() - keyWidth, 18),
             literalName(m_scene.name(run)), reportFont(bodySize, QFont::DemiBold), colours.text);
    QStringList facts;
    for (const QString &fact : {QString::fromStdString(scene.trial.className), shownTeam(scene.trial)})
        if (!fact.isEmpty())
            facts << literalName(fact);
    facts << shortDate(scene.trial.date);
    drawLine(m_painter, QRectF(area.left(), area.top(), area.width(), lineHeight),
             facts.join(QStringLiteral(" · ")), reportFont(smallSize + 1), colours.muted);
    area.setTop(area.top() + lineHeight + 6);
    QList<ReportMetric> reportMetrics;
    for (const Metric &metric : informativeMetrics(m_scene.profile(run).metrics, 4))
        reportMetrics << ReportMetric{metricName(metric.name), metricNumber(metric), {}};
    for (qsizetype i = 0; i < reportMetrics.size(); i += 2) {
        drawMetrics(m_painter, QRectF(area.left(), area.top(), area.width(), metricHeight),
                    reportMetrics.mid(i, 2));
        area.setTop(area.top() + metricHeight + 4);
    }
    const auto &stills = m_content.stills[std::size_t(side)];
    if (!stills.empty())
        drawStill(m_painter, area, scene, 0, stills.front());
}

void ComparisonPage::paintCurves(const QRectF &rect, Compared what, const QString &title,
                                 const QString &remark)
{
    const QRectF area = drawPartTitle(m_painter, rect, title, remark);
    const PathSpan common = comparedSpan(m_scene);
    drawChart(m_painter, area,
              {comparedContent(m_scene, what, {0, m_content.other}),
               comparedAxes(what),
               common.lowM,
               common.highM,
               {}},
              reportPalette(), reportFont(smallSize));
}

void ComparisonPage::paintTable(const QRectF &rect, const QString &title, const DifferenceModel &model)
{
    const QRectF area =
        drawPartTitle(m_painter, rect, title, ComparisonReportWords::tr("± one σ; grey, ≈: not significant"));
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
    drawTable(m_painter, area, table);
}

QString ComparisonPage::alignedWords() const
{
    const QString along = m_scene.compared.comparison.isTasksPath
                              ? ComparisonReportWords::tr("along the task’s path")
                              : ComparisonReportWords::tr("along the path of the left run");
    switch (m_scene.compared.comparison.alignedBy) {
    case AlignBy::StartGate:
        return ComparisonReportWords::tr("aligned by the start gate, %1").arg(along);
    case AlignBy::MotionOnset:
        return ComparisonReportWords::tr("aligned by the onset of motion, %1").arg(along);
    case AlignBy::Distance:
        return ComparisonReportWords::tr("aligned by a point that both pass, %1").arg(along);
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
                    .arg(literalName(m_scene.name(runAt(side))), shortDate(analysis.made),
                         literalName(analysis.softwareVersion));
        const TrialRecord &trial = m_scene.trials.runs[runAt(side)].trial;
        if (trial.range)
            foot << QStringLiteral("%1: %2").arg(literalName(m_scene.name(runAt(side))),
                                                 literalName(shownWords(rangeSentence(trial))));
        const TrialVerdict &verdict = m_scene.trials.runs[runAt(side)].verdict;
        if (verdict.level() == CheckLevel::Pass)
            continue;
        const QString name = literalName(m_scene.name(runAt(side)));
        facts << ComparisonReportWords::tr("Verdict on %1: %2").arg(name, shownVerdict(verdict));
        foot << ComparisonReportWords::tr("Verdict on %1: %2")
                    .arg(name, literalName(verdictReasons(verdict).join(u' ')));
    }
    foot << (m_scene.trials.shareCalibration
                 ? ComparisonReportWords::tr(
                       "Both runs share their calibration: its uncertainty largely cancels.")
                 : ComparisonReportWords::tr(
                       "The runs have different calibrations: the uncertainties of both count."));
    const QRectF area =
        drawFoot(m_painter,
                 drawHead(m_painter, sheet, m_options.letterhead,
                          ComparisonReportWords::tr("%1 and %2")
                              .arg(literalName(m_scene.name(0)), literalName(m_scene.name(m_content.other))),
                          facts),
                 m_options.letterhead, foot);
    const double side = sideShare * area.width(), upper = upperShare * area.height();
    paintRun(QRectF(area.left(), area.top(), side, upper), 0);
    paintRun(QRectF(area.right() - side, area.top(), side, upper), 1);
    drawComparedMap(m_painter,
                    QRectF(area.left() + side + gap, area.top(), area.width() - 2 * (side + gap), upper),
                    m_scene, {0, m_content.other});
    const QRectF lower(area.left(), area.top() + upper + gap, area.width(), area.height() - upper - gap);
    const double tables = tableShare * lower.width();
    const QRectF charts(lower.left(), lower.top(), lower.width() - tables - gap, lower.height());
    const double speed = (1 - deltaShare) * charts.height();
    paintCurves(QRectF(charts.left(), charts.top(), charts.width(), speed - 4), Compared::Speed,
                ComparisonReportWords::tr("Speed over distance, %1").arg(comparedUnit(Compared::Speed)),
                ComparisonReportWords::tr("with its ±95 % band"));
    paintCurves(QRectF(charts.left(), charts.top() + speed, charts.width(), deltaShare * charts.height()),
                Compared::TimeDifference, ComparisonReportWords::tr("Time difference, s"),
                ComparisonReportWords::tr("above 0: the right run is later; grey: not significant"));
    DifferenceModel sectors, metrics;
    sectors.setSectors(m_scene.compared.sectors, m_content.other);
    metrics.setMetrics(m_scene.compared.metrics[m_content.other - 1]);
    QRectF right(lower.right() - tables, lower.top(), tables, lower.height());
    const double sectorHeight = 40 + 15 * std::min(5, sectors.rowCount());
    paintTable(QRectF(right.left(), right.top(), right.width(), sectorHeight),
               ComparisonReportWords::tr("Sectors, s"), sectors);
    right.setTop(right.top() + sectorHeight + 4);
    paintTable(right, ComparisonReportWords::tr("Metrics"), metrics);
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
