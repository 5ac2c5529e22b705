// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/smoothing/cutoff_residuals.h"
#include "ui/review/internal/figure_panel.h"

#include <QWidget>
#include <string>
#include <vector>

namespace odo {

/// The smoothing of one robot's run.
struct RobotSmoothing
{
    std::string robot;
    CutoffAnalysis analysis;
};

/// "Robot 1: the curve is smoothed like a filter of 3.2 ±0.4 Hz and leaves 1.9 mm of the measurements …"
QString smoothingText(const RobotSmoothing &smoothing);

/// What filters of different cut-offs take away, with the noise as a level and both cut-offs as marks; a
/// cross-hair says the value under the mouse.
class ResidualPlot : public QWidget
{
    Q_OBJECT
public:
    explicit ResidualPlot(CutoffAnalysis analysis, QWidget *parent = nullptr);
    QSize sizeHint() const override { return {260, 120}; }
    QSize minimumSizeHint() const override { return {160, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    bool event(QEvent *event) override;

private:
    QRectF plot() const;
    QPointF at(double hz, double residualM) const;
    QString wordsAt(double x) const;

    const CutoffAnalysis m_analysis;
    double m_mostM = 0; ///< at the top
};

/// How strongly each robot's curve is smoothed, and the residual against the cut-off by which that can be
/// defended.
class SmoothingPanel : public FigurePanel
{
    Q_OBJECT
public:
    explicit SmoothingPanel(QWidget *parent = nullptr);
};

} // namespace odo
