// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/interval_panel.h"

#include "ui/models/number_text.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/widgets/theme.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double inMilliseconds = 1e3;
constexpr int axisHeight = 18, sideRoom = 10, longerGap = 8, longerWidth = 12;

QString millisecondsText(double seconds, std::optional<double> sigmaS = std::nullopt)
{
    return numberText(inMilliseconds * seconds,
                      sigmaS ? std::optional(inMilliseconds * *sigmaS) : std::nullopt, QStringLiteral("ms"))
        .text();
}

/// Of the samples that the first view took.
std::optional<std::int64_t> repeatedFrames(const TrialScene &scene)
{
    std::optional<std::int64_t> most;
    for (const SceneRobot &robot : scene.robots) {
        if (!robot.analysis)
            continue;
        const std::int64_t repeated =
            std::ranges::count_if(robot.analysis->profile.samples, [](const Sample &sample) {
                return hasFlag(sample.flags, SampleFlag::DuplicateFrame);
            });
        most = std::max(most.value_or(0), repeated);
    }
    return most;
}

} // namespace

std::vector<ViewIntervals> viewIntervals(const TrialScene &scene)
{
    std::vector<ViewIntervals> views;
    for (const SceneView &view : scene.views)
        views.push_back({view.camera, frameIntervals(view.recording.frameTimes),
                         static_cast<std::int64_t>(view.recording.frameTimes.size()),
                         views.empty() ? repeatedFrames(scene) : std::nullopt});
    return views;
}

QString intervalText(const ViewIntervals &view)
{
    const FrameIntervals &intervals = view.intervals;
    const QString camera = QString::fromStdString(view.camera);
    if (intervals.count == 0)
        return IntervalPanel::tr("%1: fewer than two frames").arg(camera);
    const double usual = toSeconds(intervals.usual);
    QStringList parts;
    parts << IntervalPanel::tr("%1: frames are %2 apart (%3 frames/s), from %4 to %5")
                 .arg(camera, millisecondsText(usual, intervals.usualSigmaS),
                      usual > 0 ? QLocale().toString(1 / usual, 'f', 2) : QStringLiteral("–"),
                      millisecondsText(toSeconds(intervals.shortest)),
                      millisecondsText(toSeconds(intervals.longest)));
    parts << IntervalPanel::tr("jitter %1").arg(millisecondsText(intervals.jitterS, intervals.jitterSigmaS));
    parts << (intervals.missing == 0
                  ? IntervalPanel::tr("no frame missing")
                  : IntervalPanel::tr("%1 missing in %n gap(s)", nullptr, static_cast<int>(intervals.gaps))
                        .arg(intervals.missing));
    if (const std::int64_t repeated = std::max(view.repeated.value_or(0), intervals.repeated); repeated > 0)
        parts << IntervalPanel::tr("%1 of %2 frames repeat the one before").arg(repeated).arg(view.frames);
    else if (view.repeated)
        parts << IntervalPanel::tr("no frame repeated");
    return parts.join(QStringLiteral(" · "));
}

IntervalHistogram::IntervalHistogram(FrameIntervals intervals, QWidget *parent)
    : QWidget(parent), m_intervals(std::move(intervals))
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Histogram of the frame intervals"));
}

QRectF IntervalHistogram::plot() const
{
    const double end = m_intervals.longer > 0 ? sideRoom + longerGap + longerWidth : sideRoom;
    return QRectF(rect()).adjusted(sideRoom, 4, -end, -axisHeight);
}

void IntervalHistogram::paintEvent(QPaintEvent *)
{
    if (m_intervals.bins.empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    const QRectF area = plot();
    const double low = inMilliseconds * toSeconds(m_intervals.bins.front().from),
                 high = inMilliseconds * toSeconds(m_intervals.bins.back().to);
    const auto xOf = [&](double ms) { return area.left() + (ms - low) / (high - low) * area.width(); };
    std::int64_t most = std::max<std::int64_t>(1, m_intervals.longer);
    for (const IntervalBin &bin : m_intervals.bins)
        most = std::max(most, bin.count);
    painter.setPen(colours.grid);
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    painter.setFont(small);
    const AxisTicks ticks = niceTicks(low, high, 6);
    painter.setPen(colours.muted);
    constexpr double labelWidth = 80;
    for (const double value : ticks.values()) {
        const double left = std::clamp(xOf(value) - labelWidth / 2, 0.0, width() - labelWidth);
        painter.drawText(QRectF(left, area.bottom() + 1, labelWidth, axisHeight), Qt::AlignCenter,
                         ticks.label(value) + QStringLiteral(" ms"));
    }
    // By the logarithm, so one interval of ten thousand is still seen.
    const auto drawBar = [&](double left, double right, std::int64_t count) {
        const double share = std::log1p(double(count)) / std::log1p(double(most));
        const double height = std::max(2.0, share * area.height());
        painter.fillRect(QRectF(left, area.bottom() - height, std::max(1.0, right - left - 1), height),
                         painter.brush());
    };
    painter.setBrush(seriesColour(0, palette()));
    for (const IntervalBin &bin : m_intervals.bins)
        if (bin.count > 0)
            drawBar(xOf(inMilliseconds * toSeconds(bin.from)), xOf(inMilliseconds * toSeconds(bin.to)),
                    bin.count);
    if (m_intervals.longer > 0) { // hatched, at the end: it has no length on this axis
        painter.setBrush(QBrush(colours.spike, Qt::BDiagPattern));
        drawBar(area.right() + longerGap, area.right() + longerGap + longerWidth, m_intervals.longer);
    }
}

QString IntervalHistogram::wordsAt(double x) const
{
    const QRectF area = plot();
    if (m_intervals.bins.empty() || area.width() <= 0)
        return {};
    if (m_intervals.longer > 0 && x > area.right())
        return tr("longer than %1: %n interval(s)", nullptr, static_cast<int>(m_intervals.longer))
            .arg(millisecondsText(toSeconds(m_intervals.bins.back().to)));
    const double share = (x - area.left()) / area.width();
    const auto index = static_cast<std::ptrdiff_t>(std::floor(share * double(m_intervals.bins.size())));
    if (index < 0 || index >= static_cast<std::ptrdiff_t>(m_intervals.bins.size()))
        return {};
    const IntervalBin &bin = m_intervals.bins[static_cast<std::size_t>(index)];
    return tr("%1 to %2: %n interval(s)", nullptr, static_cast<int>(bin.count))
        .arg(millisecondsText(toSeconds(bin.from)), millisecondsText(toSeconds(bin.to)));
}

bool IntervalHistogram::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), wordsAt(help->pos().x()), this);
    return true;
}

IntervalPanel::IntervalPanel(QWidget *parent)
    : FigurePanel(
          tr("Frame intervals"), tr("Frame intervals of the views"), tr("This trial has no videos."),
          [](const TrialScene &scene) {
              std::vector<Figure> figures;
              for (const ViewIntervals &view : viewIntervals(scene)) {
                  figures.push_back({[view] { return intervalText(view); }});
                  if (view.intervals.count > 0)
                      figures.back().plot = [view] { return new IntervalHistogram(view.intervals); };
              }
              return figures;
          },
          parent)
{
    setRemark(tr("bars by the logarithm of their number"));
}

} // namespace odo
