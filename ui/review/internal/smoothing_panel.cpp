// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/smoothing_panel.h"

#include "ui/models/number_text.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/widgets/theme.h"

#include <QHelpEvent>
#include <QPainter>
#include <QPolygonF>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int cutoffAxisHeight = 18, residualAxisWidth = 58, plotEndRoom = 10;

QString hertzText(const CurveValue &value)
{
    return numberText(value.value, value.sigma, QStringLiteral("Hz")).text();
}

QString residualText(const CurveValue &metres)
{
    const ShownUnit &unit = shownUnits().length;
    return numberText(unit.perSi * metres.value, unit.perSi * metres.sigma, unit.name).text();
}

} // namespace

QString smoothingText(const RobotSmoothing &smoothing)
{
    const CutoffAnalysis &analysis = smoothing.analysis;
    const QString robot = QString::fromStdString(smoothing.robot);
    if (analysis.residuals.empty())
        return SmoothingPanel::tr("%1: measured for less than a second").arg(robot);
    QStringList lines;
    if (analysis.automaticHz && analysis.automaticResidualM)
        lines << SmoothingPanel::tr("%1: smoothed automatically like a filter with a cut-off of %2; what it "
                                    "takes away is %3 of each coordinate")
                     .arg(robot, hertzText(*analysis.automaticHz),
                          residualText(*analysis.automaticResidualM));
    else
        lines << SmoothingPanel::tr("%1: the smoother states no cut-off").arg(robot);
    if (analysis.noiseM)
        lines << SmoothingPanel::tr("Noise of the measurements by their residuals: %1; stated: %2")
                     .arg(residualText(*analysis.noiseM), lengthText(analysis.statedNoiseM));
    if (analysis.chosenHz)
        lines << SmoothingPanel::tr("Cut-off by residual analysis: %1").arg(hertzText(*analysis.chosenHz));
    else
        lines << SmoothingPanel::tr(
            "Residual analysis gives no cut-off: the residuals are not those of noise.");
    return lines.join(u'\n');
}

ResidualPlot::ResidualPlot(CutoffAnalysis analysis, QWidget *parent)
    : QWidget(parent), m_analysis(std::move(analysis))
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Residual against the cut-off"));
    for (const CutoffResidual &each : m_analysis.residuals)
        m_mostM = std::max(m_mostM, each.residualM);
    // The lowest cut-offs take away the motion itself: a few times the noise is shown.
    constexpr double timesNoise = 4;
    if (m_analysis.noiseM)
        m_mostM = std::min(m_mostM, timesNoise * m_analysis.noiseM->value);
}

QRectF ResidualPlot::plot() const
{
    return QRectF(rect()).adjusted(residualAxisWidth, 6, -plotEndRoom, -cutoffAxisHeight);
}

QPointF ResidualPlot::at(double hz, double residualM) const
{
    const QRectF area = plot();
    const double most = m_analysis.residuals.back().cutoffHz;
    return {area.left() + hz / most * area.width(),
            area.bottom() - (m_mostM > 0 ? residualM / m_mostM : 0) * area.height()};
}

void ResidualPlot::paintEvent(QPaintEvent *)
{
    if (m_analysis.residuals.empty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    const QRectF area = plot();
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    painter.setFont(small);
    const AxisTicks across = niceTicks(0, m_analysis.residuals.back().cutoffHz, 6);
    const ShownUnit &unit = shownUnits().length;
    const AxisTicks up = niceTicks(0, unit.perSi * m_mostM, 3);
    for (const double value : across.values()) {
        const double x = at(value, 0).x();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(colours.muted);
        painter.drawText(QRectF(x - 40, area.bottom() + 1, 80, cutoffAxisHeight), Qt::AlignCenter,
                         across.label(value) + QStringLiteral(" Hz"));
    }
    for (const double value : up.values()) {
        const double y = at(0, value / unit.perSi).y();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(colours.muted);
        painter.drawText(QRectF(0, y - 9, residualAxisWidth - 6, 18), Qt::AlignRight | Qt::AlignVCenter,
                         up.label(value) + u' ' + unit.name);
    }
    painter.setClipRect(area.adjusted(-1, -1, 1, 1));
    if (m_analysis.noiseM) {
        painter.setPen(QPen(colours.muted, 1.5, Qt::DashLine));
        painter.drawLine(at(0, m_analysis.noiseM->value),
                         at(m_analysis.residuals.back().cutoffHz, m_analysis.noiseM->value));
    }
    QPolygonF line;
    for (const CutoffResidual &each : m_analysis.residuals)
        line << at(each.cutoffHz, each.residualM);
    painter.setPen(QPen(seriesColour(0, palette()), 2));
    painter.drawPolyline(line);
    const auto mark = [&](const std::optional<CurveValue> &hz, const QString &words, Qt::PenStyle style,
                          double share) {
        if (!hz || hz->value > m_analysis.residuals.back().cutoffHz)
            return;
        const double x = at(hz->value, 0).x();
        painter.setPen(QPen(colours.text, 1.5, style));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        const QRectF label(x + 4, area.top() + share * area.height(),
                           painter.fontMetrics().horizontalAdvance(words) + 2,
                           painter.fontMetrics().height());
        painter.fillRect(label, colours.card); // the other mark may be beneath it
        painter.drawText(label, Qt::AlignCenter, words);
    };
    mark(m_analysis.chosenHz, tr("residual analysis"), Qt::DotLine, 0.2);
    mark(m_analysis.automaticHz, tr("automatic"), Qt::SolidLine, 0);
}

QString ResidualPlot::wordsAt(double x) const
{
    const QRectF area = plot();
    if (m_analysis.residuals.empty() || x < area.left() || x > area.right())
        return {};
    const double hz = (x - area.left()) / area.width() * m_analysis.residuals.back().cutoffHz;
    const auto nearest = std::ranges::min_element(
        m_analysis.residuals, {}, [hz](const CutoffResidual &each) { return std::abs(each.cutoffHz - hz); });
    return tr("a filter of %1 takes away %2")
        .arg(numberText(nearest->cutoffHz, std::nullopt, QStringLiteral("Hz")).text(),
             residualText({nearest->residualM, nearest->sigmaM}));
}

bool ResidualPlot::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    QToolTip::showText(help->globalPos(), wordsAt(help->pos().x()), this);
    return true;
}

SmoothingPanel::SmoothingPanel(QWidget *parent)
    : FigurePanel(
          tr("Smoothing"), tr("Smoothing of the robots"), tr("No curve yet: track the trial."),
          [](const TrialScene &scene) {
              std::vector<Figure> figures;
              for (const SceneRobot &one : scene.robots) {
                  if (!one.analysis)
                      continue;
                  const RobotSmoothing robot{one.robot.name, cutoffAnalysis(one.analysis->profile)};
                  figures.push_back({[robot] { return smoothingText(robot); }});
                  if (!robot.analysis.residuals.empty())
                      figures.back().plot = [robot] { return new ResidualPlot(robot.analysis); };
              }
              return figures;
          },
          parent)
{
    setRemark(tr("residual of a Butterworth filter, by its cut-off"));
}

} // namespace odo
