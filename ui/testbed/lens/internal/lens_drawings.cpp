// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/lens_drawings.h"

#include "ui/views/charts/chart_axis.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

// Okabe and Ito's: everyone can distinguish them, and the shapes differ too.
const QColor keptColour(0, 158, 115), seenColour(230, 159, 0), wantedColour(86, 180, 233),
    coveredColour(0, 114, 178), leftOutColour(255, 130, 70); // a light vermilion
constexpr int mostShade = 90, fullAtCorners = 60;
constexpr double longestArrow = 0.08; // of the image width

} // namespace

BoardCanvas::BoardCanvas(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Image of the board"));
}

void BoardCanvas::setContent(Content content)
{
    m_content = std::move(content);
    update();
}

void BoardCanvas::setEmptyText(const QString &text)
{
    m_emptyText = text;
    update();
}

QRectF BoardCanvas::imageRect() const
{
    QSizeF size = m_content.size;
    size.scale(this->size(), Qt::KeepAspectRatio);
    return QRectF(QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size);
}

/// Pixel (0,0) is the centre of the first.
QPointF BoardCanvas::fromPixel(const QRectF &position, const Eigen::Vector2d &pixel) const
{
    return position.topLeft() + QPointF((pixel.x() + 0.5) * position.width() / m_content.size.width(),
                                        (pixel.y() + 0.5) * position.height() / m_content.size.height());
}

void BoardCanvas::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.imageBackground);
    if (m_content.image.isNull()) {
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        return;
    }
    const QRectF position = imageRect();
    painter.drawImage(position, m_content.image);
    painter.setClipRect(position);
    paintCoverage(painter, position);
    paintWanted(painter, position);
    paintCorners(painter, position);
    paintResiduals(painter, position);
    if (!m_content.label.isEmpty())
        drawTag(painter, position.topLeft() + QPointF(10, 20), m_content.label, Qt::white, position);
}

void BoardCanvas::paintCoverage(QPainter &painter, const QRectF &position) const
{
    if (!m_content.coverage)
        return;
    const double w = position.width() / BoardCoverage::across, h = position.height() / BoardCoverage::down;
    for (int row = 0; row < BoardCoverage::down; ++row) {
        for (int column = 0; column < BoardCoverage::across; ++column) {
            const int count = m_content.coverage->corners[std::size_t(row * BoardCoverage::across + column)];
            if (count == 0)
                continue;
            QColor shade = coveredColour;
            shade.setAlpha(25 + (mostShade - 25) * std::min(count, fullAtCorners) / fullAtCorners);
            painter.fillRect(
                QRectF(position.x() + column * w, position.y() + row * h, w, h).adjusted(1, 1, -1, -1),
                shade);
        }
    }
}

void BoardCanvas::paintWanted(QPainter &painter, const QRectF &position) const
{
    if (!m_content.wanted)
        return;
    QPolygonF outline;
    for (const Eigen::Vector2d &corner : m_content.wanted->outline)
        outline << fromPixel(position, corner);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 5));
    painter.drawPolygon(outline);
    painter.setPen(QPen(wantedColour, 2.5, Qt::DashLine));
    painter.drawPolygon(outline);
}

void BoardCanvas::paintCorners(QPainter &painter, const QRectF &position) const
{
    const double radius = 3.5;
    for (const Eigen::Vector2d &corner : m_content.corners) {
        const QPointF at = fromPixel(position, corner);
        painter.setPen(QPen(QColor(0, 0, 0, 170), 3));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, radius, radius);
        painter.setPen(QPen(m_content.counts ? keptColour : seenColour, 1.6));
        if (m_content.counts)
            painter.setBrush(keptColour);
        painter.drawEllipse(at, radius, radius);
    }
    const double arm = 9;
    for (const std::size_t index : m_content.leftOut) {
        if (index >= m_content.corners.size()) // of another image of this name
            continue;
        const QPointF at = fromPixel(position, m_content.corners[index]);
        for (const auto &[colour, width] :
             {std::pair(QColor(0, 0, 0, 170), 5.0), std::pair(leftOutColour, 2.5)}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(at - QPointF(arm, arm), at + QPointF(arm, arm));
            painter.drawLine(at - QPointF(arm, -arm), at + QPointF(arm, -arm));
        }
    }
}

/// Magnified until the longest is visible; the factor is shown.
void BoardCanvas::paintResiduals(QPainter &painter, const QRectF &position) const
{
    double longest = 0;
    for (const Eigen::Vector2d &residual : m_content.residuals)
        longest = std::max(longest, residual.norm());
    if (!(longest > 0) || m_content.residuals.size() != m_content.corners.size())
        return;
    const double factor = longestArrow * m_content.size.width() / longest;
    for (std::size_t i = 0; i < m_content.corners.size(); ++i) {
        const QPointF from = fromPixel(position, m_content.corners[i]);
        const QPointF to = fromPixel(position, m_content.corners[i] + factor * m_content.residuals[i]);
        for (const auto &[colour, width] :
             {std::pair(QColor(0, 0, 0, 170), 4.0), std::pair(seenColour, 2.0)}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(from, to);
        }
    }
    drawTag(painter, position.bottomLeft() + QPointF(10, -20),
            tr("residuals, longest %1 px").arg(QLocale().toString(longest, 'f', 2)), Qt::white, position);
}

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
    const QRectF below(shown.rect.left(), shown.rect.bottom(), shown.rect.width(),
                       height() - shown.rect.bottom());
    if (m_current < 0) {
        painter.drawText(below, Qt::AlignCenter, tr("images; rejected above %1 px").arg(pixels(m_threshold)));
        return;
    }
    const auto labelled = [&](const QString &name) {
        return tr("%1: %2 px").arg(name, pixels(m_errors[std::size_t(m_current)]));
    };
    const int spare = int(below.width()) - painter.fontMetrics().horizontalAdvance(labelled({}));
    painter.drawText(below, Qt::AlignCenter,
                     labelled(painter.fontMetrics().elidedText(m_names.value(m_current), Qt::ElideMiddle,
                                                               std::max(0, spare))));
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
