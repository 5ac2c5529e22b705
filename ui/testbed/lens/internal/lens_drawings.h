// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_placement.h"
#include "ui/views/charts/chart_view.h"

#include <QImage>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

namespace odo {

/// An image of the board with its detected corners, the fields that earlier boards covered (shaded), where
/// the board should go next (a dashed outline), and the corners' residuals as arrows.
class BoardCanvas : public QWidget
{
    Q_OBJECT
public:
    struct Content
    {
        QImage image;
        QSize size; ///< of the image in which the pixels below count
        std::vector<Eigen::Vector2d> corners;
        bool counts = false; ///< this image was accepted
        std::optional<BoardCoverage> coverage;
        std::optional<BoardPlacement> wanted;
        std::vector<Eigen::Vector2d> residuals; ///< px, one a corner: seen minus computed
        QString label;                          ///< in the image's upper left
        std::vector<std::size_t> leftOut = {};  ///< indices of the corners that do not count: crossed out
    };

    explicit BoardCanvas(QWidget *parent = nullptr);
    void setContent(Content content);
    const Content &content() const { return m_content; }
    /// The text shown while there is no image.
    void setEmptyText(const QString &text);

    QSize sizeHint() const override { return {720, 405}; }
    QSize minimumSizeHint() const override { return {320, 180}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QRectF imageRect() const;
    void paintCoverage(QPainter &painter, const QRectF &position) const;
    void paintWanted(QPainter &painter, const QRectF &position) const;
    void paintCorners(QPainter &painter, const QRectF &position) const;
    void paintResiduals(QPainter &painter, const QRectF &position) const;
    QPointF fromPixel(const QRectF &position, const Eigen::Vector2d &pixel) const;

    Content m_content;
    QString m_emptyText;
};

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
