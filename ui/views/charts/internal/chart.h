// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/internal/chart_series.h"
#include "ui/views/curves/chart_content.h"

#include <QChart>
#include <QFont>
#include <QPalette>
#include <QSet>
#include <memory>
#include <optional>
#include <vector>

class QValueAxis;

namespace odo {

/// A chart of Qt Charts with all of Odograph's looks: curves with bands, points, spikes and shaded stretches
/// over two axes with units, in the colours of a palette. The same object is shown on the screen (ChartView)
/// and painted in reports and images (chart_drawing.h). Needs a QApplication; GUI thread.
class Chart : public QChart
{
public:
    explicit Chart(const ChartAxes &axes = {});
    ~Chart() override;

    void setAxes(const ChartAxes &axes);
    const ChartAxes &axesShown() const { return m_axes; }
    /// nullptr: nothing.
    void setContent(ChartContentPtr content, std::vector<ChartStretch> stretches = {});
    bool hasContent() const { return m_content != nullptr; }
    /// Curves over all others, a fit say; empty: none. False where that changes nothing: there were none.
    bool setOverlay(std::vector<ChartCurve> curves);
    void setStyle(const QPalette &palette, const QFont &font);
    /// A group stays hidden whatever the content.
    void setGroupShown(int group, bool isShown);
    bool isGroupShown(int group) const { return !m_hidden.contains(group); }
    void showAllGroups();
    /// Columns to a pixel, in which many points are drawn as one: more for print.
    void setFineness(double fineness);
    /// All charts with a title at the left have the same margins, so their times or distances line up.
    void setSize(const QSizeF &size);
    /// What is visible: the part of the axis below (SI), and the values that were chosen; nullopt: all, which
    /// an axis of round numbers covers.
    void show(double low, double high, std::optional<ValueRange> chosen = {});

    /// Where the values lie now.
    ChartPlot chartPlot() const;
    /// To be called before it is painted: what has changed since is put into the series, at once.
    void prepare();
    /// So much is visible that smooth edges would take long and show little; after prepare.
    bool isCoarse() const { return m_isCoarse; }

private:
    void makeAxes();
    void remake();
    void add(const std::vector<ChartCurve> &curves);
    void showGroups();
    void searchAgain();
    void invalidate();
    void setAxisRanges();
    void showStretches();
    bool hasCurves() const;

    ChartAxes m_axes;
    QPalette m_palette;
    QFont m_font;
    ChartContentPtr m_content;
    std::vector<ChartStretch> m_stretches;
    std::vector<ChartCurve> m_overlay;
    std::vector<std::unique_ptr<ChartSeries>> m_series; ///< of the content, then of the overlay
    QAreaSeries *m_shade = nullptr, *m_hatch = nullptr;
    QAbstractAxis *m_below = nullptr;
    QValueAxis *m_left = nullptr;
    QGraphicsSimpleTextItem *m_words;
    QSet<int> m_hidden; ///< groups
    double m_fineness = 1, m_low = 0, m_high = 1;
    std::optional<ValueRange> m_chosen;
    ValueRange m_values;
    AxisTicks m_ticks; ///< at the left
    bool m_isStale = true, m_isCoarse = false;
};

} // namespace odo
