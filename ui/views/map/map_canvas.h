// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/charts/chart_picture.h"

#include <QWidget>
#include <functional>

namespace odo {

/// A map of the floor of which all but the robots is painted once and kept, until size, palette or font
/// change. What is kept begins with the colour of the ground.
class MapCanvas : public QWidget
{
    Q_OBJECT
protected:
    explicit MapCanvas(QWidget *parent);

    /// All but what moves.
    virtual void paintStill(QPainter &painter) const = 0;
    /// Paints what is kept.
    void drawStill(QPainter &painter);
    /// Adds to what is kept, if anything is yet.
    void addToStill(const std::function<void(QPainter &)> &paint);
    /// It is painted anew.
    void forgetStill();

    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    StillLayer m_still;
};

} // namespace odo
