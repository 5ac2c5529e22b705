// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/curves/chart_content.h"

#include <QPointF>
#include <QRectF>
#include <algorithm>

namespace odo {

/// Where the values of a chart lie: a value, taken from a Chart, for what is painted over it.
struct ChartPlot
{
    QRectF rect;              ///< of the plot, in the chart's coordinates
    double low = 0, high = 1; ///< of the axis below, SI
    ValueRange values;

    QPointF at(double x, double value) const
    {
        return {rect.left() + (x - low) / (high - low) * rect.width(),
                rect.bottom() - (value - values.low) / (values.high - values.low) * rect.height()};
    }
    /// Kept within low and high.
    double xAt(double screenX) const
    {
        const double part = std::clamp((screenX - rect.left()) / std::max(1.0, rect.width()), 0.0, 1.0);
        return low + part * (high - low);
    }
    double valueAt(double screenY) const
    {
        const double part = (rect.bottom() - screenY) / std::max(1.0, rect.height());
        return values.low + std::clamp(part, 0.0, 1.0) * (values.high - values.low);
    }
};

} // namespace odo
