// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

namespace odo {

/// A picture on which one box is drawn, with the mouse; or by keys: the arrows move it, with Shift they move
/// its lower right corner, with Ctrl either by larger steps. The first of them puts a box in the middle.
class BoxCanvas : public QWidget
{
    Q_OBJECT
public:
    explicit BoxCanvas(QWidget *parent = nullptr);
    /// size: of the picture whose pixels count. Another size forgets the box.
    void setSourceSize(QSize size);
    QSize sourceSize() const { return m_size; }
    void setPicture(const QImage &picture);
    void setEmptyText(const QString &text);
    /// In pixels of the picture; empty: none yet.
    QRect box() const { return m_box; }
    /// Where the picture is shown, in the widget.
    QRectF pictureRect() const;

    QSize sizeHint() const override { return {800, 450}; }
    QSize minimumSizeHint() const override { return {320, 180}; }

Q_SIGNALS:
    void boxChanged(const QRect &box); ///< finished, not while it is drawn
    void resized();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QPoint toPixel(const QPointF &place) const;
    QRectF placeOf(const QRect &box) const;

    QImage m_picture;
    QSize m_size;
    QRect m_box, m_boxBefore;
    QPoint m_corner; ///< where the drawing began
    bool m_drawing = false;
    QString m_emptyText;
};

} // namespace odo
