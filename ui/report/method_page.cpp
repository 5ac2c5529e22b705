// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/method_page.h"

#include "ui/models/analysis_words.h"
#include "ui/models/core_words.h"
#include "ui/models/explanation.h"
#include "ui/models/metric_choice.h"
#include "ui/report/report_painting.h"
#include "ui/report/report_table.h"
#include "ui/report/trial_report.h"
#include "ui/views/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

QString flagWords(SampleFlags flags)
{
    QStringList words;
    for (const QString &name : QString::fromStdString(flagNames(flags)).replace(u'_', u' ').split(u'|', Qt::SkipEmptyParts))
        words << shownWords(name);
    return words.join(QStringLiteral(", "));
}

class ReportMethodWords
{
    Q_DECLARE_TR_FUNCTIONS(ReportMethod)
};

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
    if (view < content.lensRmsPx.size() && content.lensRmsPx[view])
        parts << ReportMethodWords::tr("lens calibrated to %1 px").arg(decimals(*content.lensRmsPx[view], 2));
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

/// Every how many-th sample, so that a page has room for them.
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
    const auto room = std::max<std::size_t>(1, std::size_t(rect.height() / table.rowHeight) - 2);
    const std::size_t step = std::max<std::size_t>(1, (profile.samples.size() + room - 1) / room);
    for (std::size_t i = 0; i < profile.samples.size(); i += step) {
        const ProfilePoint &point = profile.points[i];
        QStringList cells(decimals(toSeconds(profile.samples[i].time), 3));
        if (point.valid)
            cells << decimals(units.length.perSi * point.position.x(), 1) << decimals(units.length.perSi * point.position.y(), 1)
                  << decimals(units.speed.perSi * point.speedMps, 3) << decimals(units.speed.perSi * point.sigmaSpeedMps, 3)
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
    for (std::size_t view = 0; view < scene.views.size(); ++view)
        lines << viewLine(content, view);
    if (robot >= scene.robots.size() || !scene.robots[robot].analysis)
        return lines;
    const AnalysisRecord &analysis = *scene.robots[robot].analysis;
    QStringList parts;
    for (std::size_t view = 1; view < scene.views.size(); ++view)
        parts << ReportMethodWords::tr("%1 %2").arg(literalName(scene.views[view].camera),
                                                    stepText(scene.views[view].recording));
    parts << ReportMethodWords::tr("smoother: %1").arg(smootherText(analysis.options.smoother));
    parts << ReportMethodWords::tr("analysed %1, Odograph %2")
                 .arg(reportDate(analysis.made), literalName(analysis.softwareVersion));
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
    QRectF room = drawFoot(painter,
                           drawHead(painter, sheet, letterhead,
                                    ReportMethodWords::tr("%1: method").arg(trialTitle(scene, robot)),
                                    trialHeadFacts(scene, robot)),
                           letterhead, provenanceLines(content, robot));
    const QRectF samples(room.left(), room.bottom() - samplesShare * room.height(), room.width(), samplesShare * room.height());
    drawSamples(painter, samples, analysis.profile);
    room.setBottom(samples.top() - gap);
    QRectF text = drawPartTitle(painter, room, ReportMethodWords::tr("How the figures were computed"));
    const auto paragraph = [&](const QString &words, QFont::Weight weight = QFont::Normal) {
        text.setTop(text.top() + drawParagraph(painter, text, words, reportFont(smallSize + 1, weight), colours.text));
    };
    for (const QString &input : analysisInputs(scene, robot))
        paragraph(input);
    paragraph(sampleSummary(analysis.profile));
    for (const Metric &metric : tellingMetrics(analysis.profile.metrics, explained)) {
        const Explanation how = explainMetric(scene, robot, metric);
        text.setTop(text.top() + 4);
        paragraph(ReportMethodWords::tr("%1: %2").arg(how.what, how.value), QFont::DemiBold);
        QString words = how.formula;
        if (!how.uncertainty.isEmpty())
            words += QStringLiteral(" ") + ReportMethodWords::tr("±: %1.").arg(how.uncertainty);
        paragraph(words);
    }
}

} // namespace odo
