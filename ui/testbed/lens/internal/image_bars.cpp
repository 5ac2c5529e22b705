// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/image_bars.h"

#include "ui/views/charts/chart_axis.h"
#include "ui/views/widgets/theme.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

constexpr double grabPx = 7, keyStep = 1.05;
constexpr double looseFactor = 1.5; // the threshold starts this far above the worst image

QString pixels(double px)
{
    return QLocale().toString(px, 'f', px < 1 ? 2 : 1);
}

ChartCurve barsOf(ChartInk ink, Qt::BrushStyle fill)
{
    ChartCurve bars;
    bars.kind = ChartCurve::Kind::Bars;
    bars.ink = ink;
    bars.fill = fill;
    bars.runs.resize(1);
    return bars;
}

} // namespace

ImageBars::ImageBars(QWidget *parent)
    : ChartView(*new AxisSpan, {{{}, 1}, QStringLiteral("px"), ChartStyle::Bars}, parent)
{
    span().setParent(this);
    setAccessibleName(tr("Error of each image, with a threshold"));
    showBars();
}

void ImageBars::setBars(const QStringList &names, std::vector<double> errorsPx)
{
    m_names = names;
    m_errors = std::move(errorsPx);
    if (m_threshold <= 0 && !m_errors.empty())
        m_threshold = looseFactor * std::ranges::max(m_errors);
    m_current = std::min(m_current, int(m_errors.size()) - 1);
    span().setWhole(-0.5, std::max(0.5, double(m_errors.size()) - 0.5));
    showValues(std::nullopt);
    showBars();
}

void ImageBars::setCurrent(int index)
{
    if (index == m_current || index < 0 || index >= int(m_errors.size()))
        return;
    m_current = index;
    showBars();
    Q_EMIT currentChanged(index);
}

void ImageBars::showBars()
{
    ChartCurve counting = barsOf(ChartInk::Accent, Qt::SolidPattern),
               beyond = barsOf(ChartInk::Spike, Qt::BDiagPattern),
               current = barsOf(ChartInk::Text, Qt::NoBrush), line;
    for (std::size_t i = 0; i < m_errors.size(); ++i) {
        const BandPoint bar(double(i), {m_errors[i], 0});
        (m_errors[i] <= m_threshold ? counting : beyond).runs.front().points.push_back(bar);
        if (int(i) == m_current)
            current.runs.front().points.push_back(bar);
    }
    line.ink = ChartInk::Text;
    line.widthPx = 1.5;
    line.dash = Qt::DashLine;
    line.runs = {CurveRun{
        0,
        {BandPoint(span().wholeLow(), {m_threshold, 0}), BandPoint(span().wholeHigh(), {m_threshold, 0})}}};
    const double worst = m_errors.empty() ? 1 : std::ranges::max(m_errors);
    auto content = std::make_shared<ChartContent>();
    content->range = {0, std::max({1.15 * worst, 1.1 * m_threshold, 0.05})};
    content->curves = {std::move(counting), std::move(beyond), std::move(current), std::move(line)};
    setContent(std::move(content));
}

void ImageBars::paintOver(QPainter &painter)
{
    const ThemeColours colours = ThemeColours::of(palette());
    const ChartPlot shown = plot();
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.text);
    painter.drawEllipse(shown.at(shown.high, m_threshold), 4, 4); // to be grabbed by
    painter.setPen(colours.text);
    painter.drawText(
        QRectF(shown.rect.left(), shown.rect.bottom(), shown.rect.width(), height() - shown.rect.bottom()),
        Qt::AlignCenter,
        m_current >= 0
            ? tr("%1: %2 px").arg(m_names.value(m_current), pixels(m_errors[std::size_t(m_current)]))
            : tr("images; rejected above %1 px").arg(pixels(m_threshold)));
}

void ImageBars::setThreshold(double px)
{
    // Three images at least must stay: fewer give no result.
    std::vector<double> sorted = m_errors;
    std::ranges::sort(sorted);
    m_threshold = std::max(px, sorted.size() >= 3 ? sorted[2] : px);
    showBars();
}

bool ImageBars::isAtThreshold(const QPointF &position) const
{
    return std::abs(position.y() - plot().at(0, m_threshold).y()) <= grabPx;
}

void ImageBars::goTo(double x)
{
    setCurrent(int(std::lround(x)));
}

void ImageBars::mousePressEvent(QMouseEvent *event)
{
    m_dragging = event->button() == Qt::LeftButton && isAtThreshold(event->position());
    if (!m_dragging && plot().rect.contains(event->position()))
        ChartView::mousePressEvent(event);
}

void ImageBars::mouseMoveEvent(QMouseEvent *event)
{
    setCursor(m_dragging || isAtThreshold(event->position()) ? Qt::SizeVerCursor : Qt::ArrowCursor);
    if (m_dragging)
        setThreshold(plot().valueAt(event->position().y()));
    else
        ChartView::mouseMoveEvent(event);
}

void ImageBars::mouseReleaseEvent(QMouseEvent *event)
{
    ChartView::mouseReleaseEvent(event);
    if (std::exchange(m_dragging, false))
        Q_EMIT thresholdChanged(m_threshold);
}

void ImageBars::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
        setThreshold(event->key() == Qt::Key_Up ? m_threshold * keyStep : m_threshold / keyStep);
        Q_EMIT thresholdChanged(m_threshold);
        break;
    case Qt::Key_Left:
        setCurrent(std::max(0, m_current - 1));
        break;
    case Qt::Key_Right:
        setCurrent(m_current + 1);
        break;
    default:
        ChartView::keyPressEvent(event);
    }
}

} // namespace odo
