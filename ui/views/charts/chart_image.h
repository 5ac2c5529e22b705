// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_file.h"
#include "ui/views/curves/chart_content.h"

#include <QImage>
#include <QObject>
#include <QPixmap>
#include <QStringList>
#include <functional>

class QColor;
class QFont;
class QPainter;
class QPalette;
class QRectF;
class QWidget;

namespace odo {

class ChartView;
class SeriesKey;

/// The heading above an image.
struct ImageHeading
{
    QString what;     ///< "Speed"
    QStringList runs; ///< of which; empty names are left out
    QString remark;   ///< the unit, say
    /// "Speed · run 1, run 2"
    QString title() const;
};

/// A chart or map as an image for other documents: what it shows, with its heading and the key to its lines
/// above, on white whatever the theme is, and without the frame of the focus. The plot gets two actions for
/// it, in its context menu: copy (also by the keys of copying while it has the focus) and save, as SVG or
/// PDF, in which lines and words stay such, or as PNG of three dots a logical pixel. Child of the plot. GUI
/// thread.
class ChartImage : public QObject
{
    Q_OBJECT
public:
    /// The heading's title is also the proposed file's name. key: nullptr: none; must outlive the plot's
    /// actions.
    ChartImage(QWidget &plot, std::function<ImageHeading()> heading, SeriesKey *key = nullptr);
    /// Of a chart, by what paints it on the screen.
    ChartImage(ChartView &plot, std::function<ImageHeading()> heading, SeriesKey *key = nullptr);

    QByteArray svg() const;
    QByteArray pdf() const; ///< one page as large as the image
    QImage image() const;
    /// As SVG or PDF where the file's ending says so, else as PNG. Errors: those of OutputFile.
    Result<void> save(const OutputTarget &target) const;
    void copy() const;

    /// Whether a painter paints a plot for one of these rather than for the screen.
    static bool isPaintedBy(const QPainter &painter, const QWidget &plot);

private:
    QSize size() const;
    int headHeight() const;
    void paint(QPainter &painter) const;
    void paintHead(QPainter &painter) const;
    void askSave() const;

    QWidget &m_plot;
    std::function<ImageHeading()> m_heading;
    SeriesKey *m_key;
    std::function<void(QPainter &)> m_paintPlot; ///< empty: as it paints itself
};

/// What of a view does not change with the time, kept as an image of its size, so that moving the cursor
/// costs a copy. GUI thread.
class StillLayer
{
public:
    using Draw = std::function<void(QPainter &)>;

    /// Paints it over the whole view; redraws it if it was forgotten, beginning with the colour of the
    /// ground. Draws without keeping it when painted for a ChartImage.
    void paint(QPainter &painter, const QWidget &view, const QColor &ground, const Draw &draw);
    /// Draws more on it, if it is there.
    void add(const QWidget &view, const Draw &draw);
    /// After what it shows has changed, or the size, palette or font of the view.
    void forget() { m_image = {}; }

private:
    QPixmap m_image; ///< null: to be drawn
};

/// Paints a chart into a rectangle of a page or image, by the class that the screen's charts are of; gives
/// where its values lie there. Any thread: the chart itself is made on the window's thread (window_thread.h)
/// while the caller waits. fineness: columns to a unit of the rectangle in which many points are drawn as
/// one.
ChartPlot drawChart(QPainter &painter, const QRectF &rect, const ChartDrawing &drawing,
                    const QPalette &palette, const QFont &font, double fineness = 3);

/// Does work on the window's thread, that of the QApplication, and waits until it is done: at once where that
/// is the caller's, else between two events. For what Qt does there alone, such as charts; keep it short.
/// Where the caller is to end (CancelScope) it throws WorkCancelled instead of waiting on, and the work may
/// still be done later or not at all: work must own all that it touches. Any thread.
void onWindowThread(std::function<void()> work);

} // namespace odo
