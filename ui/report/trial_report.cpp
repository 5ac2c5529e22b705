// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/trial_report.h"

#include "core/analysis/gate_passages.h"
#include "core/workflow/compare/trial_metrics.h"
#include "core/workflow/track/track_warnings.h"
#include "ui/models/explanation.h"
#include "ui/models/results.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_lines.h"
#include "ui/models/verdict_mark.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/internal/run_painting.h"
#include "ui/report/internal/trial_content.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <span>

namespace odo {

namespace {

class ReportMethodWords
{
    Q_DECLARE_TR_FUNCTIONS(ReportMethod)
};

QString flagWords(SampleFlags flags)
{
    QStringList words;
    for (const auto &[flag, word] :
         {std::pair(SampleFlag::Jump, ReportMethodWords::tr("jump")),
          std::pair(SampleFlag::SpeedLimit, ReportMethodWords::tr("speed limit")),
          std::pair(SampleFlag::AccelerationLimit, ReportMethodWords::tr("acceleration limit")),
          std::pair(SampleFlag::ViewsDisagree, ReportMethodWords::tr("views disagree")),
          std::pair(SampleFlag::LowScore, ReportMethodWords::tr("low score")),
          std::pair(SampleFlag::Lost, ReportMethodWords::tr("lost")),
          std::pair(SampleFlag::DuplicateFrame, ReportMethodWords::tr("duplicate frame")),
          std::pair(SampleFlag::Interpolated, ReportMethodWords::tr("interpolated")),
          std::pair(SampleFlag::ByHand, ReportMethodWords::tr("by hand"))})
        if (hasFlag(flags, flag))
            words << word;
    return words.join(QStringLiteral(", "));
}

QString decimals(double value, int count)
{
    QLocale plain; // 1,500.2 and 1.500,2 would be read in two ways
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(value, 'f', count);
}

QString viewLine(const TrialContent &content, std::size_t view)
{
    const SceneView &shown = content.scene->views[view];
    QStringList parts;
    parts << ReportMethodWords::tr("%1: %2 frames at %3/s")
                 .arg(literalName(shown.camera))
                 .arg(shown.recording.frameTimes.size())
                 .arg(decimals(shown.recording.framesPerSecond, 2));
    parts << ReportMethodWords::tr("%n missing", "", missingFrames(shown.recording.frameTimes));
    if (view < content.calibrationRmsPx.size() && content.calibrationRmsPx[view])
        parts << ReportMethodWords::tr("lens calibrated to %1 px")
                     .arg(decimals(*content.calibrationRmsPx[view], 2));
    if (shown.registration)
        parts << ReportMethodWords::tr("registered to the floor to %1 px, %2")
                     .arg(decimals(shown.registration->rmsPx, 2), lengthText(shown.registration->rmsM));
    else
        parts << ReportMethodWords::tr("not registered");
    if (const QString uneven = unevenText(shown.recording); !uneven.isEmpty())
        parts << uneven;
    return parts.join(QStringLiteral(", "));
}

QString sampleSummary(const Profile &profile)
{
    const auto count = [&profile](const auto &is) { return int(std::ranges::count_if(profile.samples, is)); };
    return ReportMethodWords::
        tr("%1 samples: %2 measured, %3 used, %4 flagged, %5 bridged; the views disagree by %6 on average")
            .arg(profile.samples.size())
            .arg(count([](const Sample &sample) { return sample.position.has_value(); }))
            .arg(count([](const Sample &sample) { return sample.position && !isRejected(sample.flags); }))
            .arg(profile.spikes.size())
            .arg(count([](const Sample &sample) { return hasFlag(sample.flags, SampleFlag::Interpolated); }))
            .arg(lengthText(profile.meanViewDisagreementM));
}

/// The step between the samples that fit on a page.
void drawSamples(QPainter &painter, const QRectF &rect, const Profile &profile)
{
    ReportTable table;
    const ShownUnits &units = shownUnits();
    table.header = {ReportMethodWords::tr("t, s"),
                    ReportMethodWords::tr("x, %1").arg(units.length.name),
                    ReportMethodWords::tr("y, %1").arg(units.length.name),
                    ReportMethodWords::tr("speed, %1").arg(units.speed.name),
                    ReportMethodWords::tr("± (σ)"),
                    ReportMethodWords::tr("acceleration, %1").arg(units.acceleration.name),
                    ReportMethodWords::tr("flags")};
    table.weights = {0.1, 0.12, 0.12, 0.14, 0.1, 0.18, 0.24};
    table.alignments = QList<Qt::Alignment>(6, Qt::AlignRight) << Qt::AlignLeft;
    table.rowHeight = 13;
    const auto area = std::max<std::size_t>(1, std::size_t(rect.height() / table.rowHeight) - 2);
    const std::size_t step = std::max<std::size_t>(1, (profile.samples.size() + area - 1) / area);
    for (std::size_t i = 0; i < profile.samples.size(); i += step) {
        const ProfilePoint &point = profile.points[i];
        QStringList cells(decimals(toSeconds(profile.samples[i].time), 3));
        if (point.valid)
            cells << decimals(units.length.perSi * point.position.x(), 1)
                  << decimals(units.length.perSi * point.position.y(), 1)
                  << decimals(units.speed.perSi * point.speedMps, 3)
                  << decimals(units.speed.perSi * point.sigmaSpeedMps, 3)
                  << decimals(units.acceleration.perSi * point.accelMps2, 2);
        else
            cells << QStringList(5, QStringLiteral("–"));
        cells << flagWords(profile.samples[i].flags);
        table.rows << ReportTable::Row{cells, !point.valid, false};
    }
    const QRectF left = drawPartTitle(
        painter, rect, ReportMethodWords::tr("What was measured"),
        step == 1 ? ReportMethodWords::tr("every sample, smoothed")
                  : ReportMethodWords::tr("one sample of %1, smoothed; all of them are in the exported file")
                        .arg(step));
    drawTable(painter, left, table);
}

} // namespace

int missingFrames(const std::vector<Nanoseconds> &times)
{
    if (times.size() < 3)
        return 0;
    std::vector<Nanoseconds> steps;
    for (std::size_t i = 1; i < times.size(); ++i)
        steps.push_back(times[i] - times[i - 1]);
    std::vector<Nanoseconds> sorted = steps;
    std::ranges::nth_element(sorted, sorted.begin() + std::ptrdiff_t(sorted.size() / 2));
    const double usual = toSeconds(sorted[sorted.size() / 2]);
    long missing = 0;
    for (const Nanoseconds step : steps)
        missing += std::max(0L, std::lround(toSeconds(step) / usual) - 1);
    return int(missing);
}

QStringList provenanceLines(const TrialContent &content, std::size_t robot)
{
    const TrialScene &scene = *content.scene;
    QStringList lines;
    if (scene.trial.range)
        lines << literalName(shownWords(rangeSentence(scene.trial)));
    for (std::size_t view = 0; view < scene.views.size(); ++view)
        lines << viewLine(content, view);
    if (robot >= scene.robots.size() || !scene.robots[robot].analysis)
        return lines;
    const AnalysisRecord &analysis = *scene.robots[robot].analysis;
    QStringList parts;
    const SyncPassport passport = passportOf(scene);
    for (std::size_t view = 1; view < scene.views.size(); ++view) {
        const QString cost = costText(passport, view);
        parts << ReportMethodWords::tr("%1 %2").arg(literalName(scene.views[view].camera),
                                                    stepText(scene.views[view].recording)) +
                     (cost.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(cost));
    }
    parts << ReportMethodWords::tr("smoother: %1").arg(smootherText(analysis.options.smoother));
    parts << ReportMethodWords::tr("analysed %1, Odograph %2")
                 .arg(shortDate(analysis.made), literalName(analysis.softwareVersion));
    lines << parts.join(QStringLiteral(" · "));
    return lines;
}

void paintMethodPage(QPainter &painter, const QRectF &sheet, const TrialContent &content, std::size_t robot,
                     const Letterhead &letterhead)
{
    constexpr std::size_t explained = 6;
    constexpr double samplesShare = 0.42, gap = 12;
    const TrialScene &scene = *content.scene;
    const AnalysisRecord &analysis = *scene.robots[robot].analysis;
    const ThemeColours colours = ThemeColours::of(reportPalette());
    QRectF area = drawFoot(painter,
                           drawHead(painter, sheet, letterhead,
                                    ReportMethodWords::tr("%1: method").arg(trialTitle(scene, robot)),
                                    trialHeadFacts(scene, robot)),
                           letterhead, provenanceLines(content, robot));
    const QRectF samples(area.left(), area.bottom() - samplesShare * area.height(), area.width(),
                         samplesShare * area.height());
    drawSamples(painter, samples, analysis.profile);
    area.setBottom(samples.top() - gap);
    QRectF text = drawPartTitle(painter, area, ReportMethodWords::tr("How the metrics were computed"));
    const auto paragraph = [&](const QString &words, QFont::Weight weight = QFont::Normal) {
        text.setTop(text.top() +
                    drawParagraph(painter, text, words, reportFont(smallSize + 1, weight), colours.text));
    };
    for (const QString &input : analysisInputs(scene, robot))
        paragraph(input);
    paragraph(sampleSummary(analysis.profile));
    for (const Metric &metric : informativeMetrics(analysis.profile.metrics, explained)) {
        const Explanation how = explainMetric(scene, robot, metric);
        text.setTop(text.top() + 4);
        paragraph(ReportMethodWords::tr("%1: %2").arg(how.what, how.value), QFont::DemiBold);
        QString words = how.formula;
        if (!how.uncertainty.isEmpty())
            words += QStringLiteral(" ") + ReportMethodWords::tr("±: %1.").arg(how.uncertainty);
        paragraph(words);
    }
}

namespace {

constexpr std::size_t largeMetrics = 5, mostEvents = 12;

class TrialReportWords
{
    Q_DECLARE_TR_FUNCTIONS(TrialReport)
};

/// One page, while it is painted.
class TrialPage
{
public:
    TrialPage(QPainter &painter, const TrialContent &content, std::size_t robot, const ReportOptions &options)
        : m_painter(painter), m_content(content), m_scene(*content.scene), m_robot(robot), m_options(options)
    {
        if (m_robot < m_scene.robots.size() && m_scene.robots[m_robot].analysis)
            m_analysis = &*m_scene.robots[m_robot].analysis;
        if (!m_analysis)
            return;
        m_events = runEvents(m_analysis->profile, mostEvents);
        m_laps = lapsOf(m_analysis->profile.passages);
        m_score = scoreOf(m_scene, m_robot);
    }
    void paint(const QRectF &sheet);

private:
    QList<ReportMetric> reportMetrics() const;
    std::size_t largeCount() const { return largeMetrics - (m_score ? 1 : 0); } ///< of the metrics
    /// The three tables below the charts.
    struct Tables
    {
        QRectF events, splits, metrics;
    };
    Tables tablesIn(const QRectF &rect) const;
    double tablesHeight(double width) const;
    QString medianWords(const std::string &metric, const std::string &unit) const;
    void paintPositions(const QRectF &rect);
    void paintTables(const QRectF &rect);
    ReportTable eventsTable() const;
    void paintEvents(const QRectF &rect);
    void paintSplits(const QRectF &rect);
    void paintMetrics(const QRectF &rect);
    QStringList caveats() const;
    void paintRemarks(const QRectF &rect);
    double paintVerdict(const QRectF &rect);

    QPainter &m_painter;
    const TrialContent &m_content;
    const TrialScene &m_scene;
    std::size_t m_robot;
    const ReportOptions &m_options;
    const AnalysisRecord *m_analysis = nullptr; ///< null: not tracked
    std::vector<RunEvent> m_events;
    std::vector<Lap> m_laps;
    std::optional<Score> m_score;
};

QString TrialPage::medianWords(const std::string &metric, const std::string &unit) const
{
    const auto found = m_content.classMedians.find(metric);
    if (found == m_content.classMedians.end() || found->second.runs < 2)
        return {};
    NumberText number = metricNumber({metric, unit, found->second.median, std::nullopt});
    return TrialReportWords::tr("class median %1").arg(number.text());
}

QList<ReportMetric> TrialPage::reportMetrics() const
{
    QList<ReportMetric> reportMetrics;
    if (m_score)
        reportMetrics << ReportMetric{TrialReportWords::tr("Score"), scoreNumber(*m_score),
                                      medianWords(scoreMetric, "1")};
    for (const Metric &metric : informativeMetrics(m_analysis->profile.metrics, largeCount()))
        reportMetrics << ReportMetric{metricName(metric.name), metricNumber(metric),
                                      medianWords(metric.name, metric.unit)};
    return reportMetrics;
}

/// The map, and beside it what the cameras saw.
void TrialPage::paintPositions(const QRectF &rect)
{
    const bool hasViews = !m_scene.views.empty();
    constexpr double mapShare = 0.6, gap = 14;
    const double mapWidth = hasViews ? mapShare * rect.width() : rect.width();
    const QRectF map =
        drawPartTitle(m_painter, QRectF(rect.left(), rect.top(), mapWidth, rect.height()),
                      TrialReportWords::tr("The run from above"), TrialReportWords::tr("coloured by speed"));
    drawRunMap(m_painter, map, m_scene, m_robot, m_events);
    if (!hasViews)
        return;
    const QRectF right(rect.left() + mapWidth + gap, rect.top(), rect.width() - mapWidth - gap,
                       rect.height());
    const QRectF images =
        drawPartTitle(m_painter, right, TrialReportWords::tr("The cameras’ views"),
                      m_analysis && m_content.isAtTopSpeed && m_scene.robots.size() == 1
                          ? TrialReportWords::tr("at %1, the top speed").arg(secondsText(m_content.stillTime))
                          : TrialReportWords::tr("at %1").arg(secondsText(m_content.stillTime)));
    drawStills(m_painter, images, m_scene, m_content.stills);
}

ReportTable TrialPage::eventsTable() const
{
    ReportTable table;
    table.weights = {0.09, 0.2, 0.71};
    table.alignments = {Qt::AlignLeft, Qt::AlignRight, Qt::AlignLeft};
    table.mostLines = 2;
    for (const RunEvent &event : m_events)
        table.rows << ReportTable::Row{
            {QString::number(event.number), secondsText(event.time), literalName(event.words)}, false, false};
    return table;
}

void TrialPage::paintEvents(const QRectF &rect)
{
    const QRectF area = drawPartTitle(m_painter, rect, TrialReportWords::tr("What happened"));
    if (m_events.empty())
        drawLine(m_painter, QRectF(area.left(), area.top(), area.width(), 16),
                 TrialReportWords::tr("It did not move"), reportFont(bodySize),
                 ThemeColours::of(reportPalette()).muted);
    drawTable(m_painter, area, eventsTable());
}

void TrialPage::paintSplits(const QRectF &rect)
{
    const QRectF area = drawPartTitle(m_painter, rect, TrialReportWords::tr("Splits"));
    const auto best = std::ranges::min_element(m_laps, {}, &Lap::timeS);
    ReportTable table;
    table.weights = {0.42, 0.58};
    table.alignments = {Qt::AlignLeft, Qt::AlignRight};
    for (auto lap = m_laps.begin(); lap != m_laps.end(); ++lap) {
        const auto time = [](double seconds, double sigmaS) {
            return numberText(seconds, sigmaS, QStringLiteral("s")).text();
        };
        table.rows << ReportTable::Row{
            {TrialReportWords::tr("Run %1").arg(lap - m_laps.begin() + 1), time(lap->timeS, lap->sigmaS)},
            false,
            m_laps.size() > 1 && lap == best};
        for (const Sector &sector : lap->sectors)
            if (lap->sectors.size() > 1)
                table.rows << ReportTable::Row{
                    {QStringLiteral("   ") + TrialReportWords::tr("to %1").arg(literalName(sector.gate)),
                     time(sector.timeS, sector.sigmaS)},
                    false,
                    false};
    }
    drawTable(m_painter, area, table);
}

void TrialPage::paintMetrics(const QRectF &rect)
{
    const QRectF area =
        drawPartTitle(m_painter, rect, TrialReportWords::tr("Metrics"), TrialReportWords::tr("± one σ"));
    ReportTable table;
    table.weights = {0.54, 0.46};
    table.alignments = {Qt::AlignLeft, Qt::AlignRight};
    const auto &all = m_analysis->profile.metrics;
    const std::vector<Metric> telling = informativeMetrics(all, all.size());
    for (const Metric &metric : std::span(telling).subspan(std::min(largeCount(), telling.size())))
        table.rows << ReportTable::Row{{metricName(metric.name), metricNumber(metric).text()}, false, false};
    drawTable(m_painter, area, table);
}

TrialPage::Tables TrialPage::tablesIn(const QRectF &rect) const
{
    constexpr double gap = 16;
    const bool hasSplits = !m_laps.empty();
    const double width = rect.width() - (hasSplits ? 2 : 1) * gap;
    Tables tables = {rect, rect, rect};
    tables.events.setWidth(width * (hasSplits ? 0.41 : 0.55));
    tables.splits.setLeft(tables.events.right() + gap);
    tables.splits.setWidth(hasSplits ? width * 0.26 : 0);
    tables.metrics.setLeft(hasSplits ? tables.splits.right() + gap : tables.splits.left());
    return tables;
}

/// What the list of events needs, so that map and images get the rest; the other tables are cut there.
double TrialPage::tablesHeight(double width) const
{
    constexpr double title = 21, fewestRows = 8 * 15;
    return title +
           std::max(fewestRows, tableHeight(eventsTable(), tablesIn(QRectF(0, 0, width, 0)).events.width()));
}

void TrialPage::paintTables(const QRectF &rect)
{
    const Tables tables = tablesIn(rect);
    paintEvents(tables.events);
    if (!m_laps.empty())
        paintSplits(tables.splits);
    paintMetrics(tables.metrics);
}

/// When the robot is ambiguous, and when it was hidden: the longest ones, for space is short.
QStringList TrialPage::caveats() const
{
    QStringList sentences;
    if (!m_analysis)
        return sentences;
    const SceneRobot &robot = m_scene.robots[m_robot];
    if (!m_analysis->ambiguousNames.empty())
        sentences << fullSentence(
            shownWords(ambiguousNamesText(m_analysis->ambiguousNames, robot.robot.name)));
    constexpr std::size_t most = 2;
    std::vector<Occlusion> longest = robot.occlusions;
    std::ranges::stable_sort(longest, std::ranges::greater(),
                             [](const Occlusion &one) { return one.span.end - one.span.begin; });
    longest.resize(std::min(longest.size(), most));
    QStringList hidden;
    for (const Occlusion &one : longest)
        hidden << occlusionText(one);
    if (robot.occlusions.size() > most)
        hidden << TrialReportWords::tr("%1 times in all").arg(robot.occlusions.size());
    if (!hidden.isEmpty())
        sentences << fullSentence(hidden.join(QStringLiteral("; ")));
    return sentences;
}

/// Ambiguities, and the notes, or lines for a pen if there are none.
void TrialPage::paintRemarks(const QRectF &rect)
{
    QRectF area = drawPartTitle(m_painter, rect, TrialReportWords::tr("Remarks"));
    for (const QString &sentence : caveats())
        area.setTop(area.top() + drawParagraph(m_painter, area, literalName(sentence),
                                               reportFont(smallSize + 1),
                                               ThemeColours::of(reportPalette()).spike));
    if (!m_scene.trial.notes.empty()) {
        drawParagraph(m_painter, area, literalName(m_scene.trial.notes), reportFont(smallSize + 1),
                      ThemeColours::of(reportPalette()).text);
        return;
    }
    m_painter.setPen(QPen(ThemeColours::of(reportPalette()).grid, 0.8));
    constexpr double lineHeight = 18;
    for (double y = area.top() + lineHeight - 3; y <= area.bottom(); y += lineHeight)
        m_painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
}

/// Why the results are doubtful or bad, and why they were accepted; gives the height used.
double TrialPage::paintVerdict(const QRectF &rect)
{
    constexpr qsizetype most = 4;
    QStringList lines = verdictReasons(m_scene.verdict);
    if (lines.isEmpty())
        return 0;
    if (lines.size() > most) {
        const int more = int(lines.size() - most + 1);
        lines = lines.first(most - 1) << TrialReportWords::tr("… and %n more", "", more);
    }
    const bool isBad = m_scene.verdict.level() == CheckLevel::Bad;
    const ThemeColours colours = ThemeColours::of(reportPalette());
    QRectF area = rect;
    const auto add = [&](const QString &words, QFont::Weight weight, const QColor &colour) {
        area.setTop(area.top() + drawParagraph(m_painter, area, literalName(words),
                                               reportFont(smallSize + 1, weight), colour));
    };
    add(isBad ? TrialReportWords::tr("Bad results: do not use them.")
        : m_scene.verdict.isAccepted()
            ? TrialReportWords::tr("Doubtful results, which were accepted.")
            : TrialReportWords::tr("Doubtful results: read the reasons before you use them."),
        QFont::DemiBold, m_scene.verdict.isAccepted() ? colours.text : colours.spike);
    for (const QString &line : std::as_const(lines))
        add(line, QFont::Normal, colours.text);
    return area.top() - rect.top() + 4;
}

void TrialPage::paint(const QRectF &sheet)
{
    constexpr double metricsHeight = 66, gap = 10, chartShare = 0.14, remarksHeight = 58;
    QRectF area = drawFoot(m_painter,
                           drawHead(m_painter, sheet, m_options.letterhead, trialTitle(m_scene, m_robot),
                                    trialHeadFacts(m_scene, m_robot)),
                           m_options.letterhead, provenanceLines(m_content, m_robot));
    const QRectF remarks(area.left(), area.bottom() - remarksHeight, area.width(), remarksHeight);
    area.setBottom(remarks.top() - gap);
    paintRemarks(remarks);
    if (!m_analysis) {
        drawLine(m_painter, QRectF(area.left(), area.top(), area.width(), 30),
                 TrialReportWords::tr("This trial has not been tracked yet: it has no metrics."),
                 reportFont(bodySize + 2), ThemeColours::of(reportPalette()).text);
        paintPositions(area.adjusted(0, 40, 0, -area.height() * 0.35));
        return;
    }
    area.setTop(area.top() + paintVerdict(area));
    drawMetrics(m_painter, QRectF(area.left(), area.top(), area.width(), metricsHeight), reportMetrics());
    area.setTop(area.top() + metricsHeight + gap);
    QRectF tables = area;
    tables.setTop(area.bottom() - tablesHeight(area.width()));
    paintTables(tables);
    area.setBottom(tables.top() - gap);
    const double chart = chartShare * sheet.height();
    const auto fromBelow = [&](Quantity quantity) {
        drawRunChart(m_painter, QRectF(area.left(), area.bottom() - chart, area.width(), chart),
                     m_analysis->profile, quantity, m_events);
        area.setBottom(area.bottom() - chart - gap / 2);
    };
    fromBelow(Quantity::Acceleration);
    fromBelow(Quantity::Speed);
    paintPositions(area);
}

} // namespace

QString trialTitle(const TrialScene &scene, std::size_t robot)
{
    const QString name = literalName(scene.trial.name);
    return scene.robots.size() > 1 && robot < scene.robots.size()
               ? TrialReportWords::tr("%1 – %2").arg(name, literalName(scene.robots[robot].robot.name))
               : name;
}

QStringList trialHeadFacts(const TrialScene &scene, std::size_t robot)
{
    QStringList facts;
    const auto add = [&facts](const QString &what, const QString &value) {
        if (!value.isEmpty())
            facts << TrialReportWords::tr("%1: %2").arg(what, literalName(value));
    };
    add(TrialReportWords::tr("Class"), QString::fromStdString(scene.trial.className));
    add(TrialReportWords::tr("Team"), shownTeam(scene.trial));
    if (robot < scene.robots.size())
        add(TrialReportWords::tr("Robot"), QString::fromStdString(scene.robots[robot].robot.name));
    add(TrialReportWords::tr("Task"), QString::fromStdString(scene.trial.task));
    if (const auto &range = scene.trial.range)
        add(TrialReportWords::tr("Range"), QStringLiteral("%1–%2 s").arg(decimals(toSeconds(range->begin), 2),
                                                                         decimals(toSeconds(range->end), 2)));
    if (!scene.verdict.checks.empty())
        add(TrialReportWords::tr("Verdict"), shownVerdict(scene.verdict));
    facts << shortDate(scene.trial.date);
    return facts;
}

ReportPages trialPages(const TrialContentPtr &content, const ReportOptions &options)
{
    ReportPages pages;
    const PageFormat format{options.paper, false};
    const std::size_t robots = std::max<std::size_t>(1, content->scene->robots.size());
    for (std::size_t robot = 0; robot < robots; ++robot) {
        pages.push_back({format, [content, robot, options, format](QPainter &painter) {
                             TrialPage(painter, *content, robot, options).paint(format.content());
                         }});
        const bool isTracked =
            robot < content->scene->robots.size() && content->scene->robots[robot].analysis;
        if (options.withMethod && isTracked)
            pages.push_back({format, [content, robot, options, format](QPainter &painter) {
                                 paintMethodPage(painter, format.content(), *content, robot,
                                                 options.letterhead);
                             }});
    }
    return pages;
}

} // namespace odo
