// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <functional>

class QColor;
class QPainter;
class QWidget;

namespace odo {

/// What of a view does not change with the time, kept as a picture of its size, so that moving the cursor
/// costs a copy. GUI thread.
class StillLayer
{
public:
    using Draw = std::function<void(QPainter &)>;

    /// Paints it over the whole view; where it was forgotten it is drawn anew, beginning with the colour of
    /// the ground. Drawn and not kept where it is painted for a ChartPicture.
    void paint(QPainter &painter, const QWidget &view, const QColor &ground, const Draw &draw);
    /// Draws more on it, if it is there.
    void add(const QWidget &view, const Draw &draw);
    /// After what it shows has changed, or the size, palette or font of the view.
    void forget() { m_picture = {}; }

private:
    QPixmap m_picture; ///< null: to be drawn
};

} // namespace odo
