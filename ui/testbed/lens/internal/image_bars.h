// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/charts/chart_view.h"

#include <QStringList>
#include <vector>

namespace odo {

/// How well each image fits, as bars, with a threshold to drag (mouse, or the keys Up and Down); Left and
/// Right select an image. Bars above the threshold are hatched: they are rejected.
class ImageBars : public ChartView
{
    Q_OBJECT
public:
    explicit ImageBars(QWidget *parent = nullptr);
    /// Keeps the threshold unless there was none.
    void setBars(const QStringList &names, std::vector<double> errorsPx);
    double threshold() const { return m_threshold; }
    int current() const { return m_current; }
    void setCurrent(int index);

    QSize sizeHint() const override { return {420, 170}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

Q_SIGNALS:
    void thresholdChanged(double px); ///< when the line was let go, or a key was pressed
    void currentChanged(int index);

protected:
    void paintOver(QPainter &painter) override;
    void goTo(double x) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void showBars();
    bool isAtThreshold(const QPointF &position) const;
    void setThreshold(double px);

    QStringList m_names;
    std::vector<double> m_errors;
    double m_threshold = 0;
    int m_current = -1;
    bool m_dragging = false;
};

} // namespace odo
