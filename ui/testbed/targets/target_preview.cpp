// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/targets/target_preview.h"

#include "ui/testbed/targets/target_painter.h"
#include "ui/views/theme.h"

#include <QPainter>
#include <algorithm>

namespace odo {
namespace {

constexpr int gapPx = 14, leastPx = 260;

/// The number of columns with which so many sheets come out largest, and how large: pixels a millimetre.
std::pair<int, double> bestGrid(int sheets, QSizeF paperMm, QSizeF roomPx)
{
    std::pair<int, double> best{1, 0};
    for (int columns = 1; columns <= sheets; ++columns) {
        const int rows = (sheets + columns - 1) / columns;
        const double scale = std::min((roomPx.width() - (columns + 1) * gapPx) / (columns * paperMm.width()),
                                      (roomPx.height() - (rows + 1) * gapPx) / (rows * paperMm.height()));
        if (scale > best.second)
            best = {columns, scale};
    }
    return best;
}

} // namespace

TargetPreview::TargetPreview(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Preview of the sheets"));
    setMinimumSize(leastPx, leastPx);
}

void TargetPreview::setSheets(const TargetSpec &spec, std::vector<TargetSheet> sheets)
{
    m_spec = spec;
    m_sheets = std::move(sheets);
    update();
}

void TargetPreview::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.mapGround);
    if (m_sheets.empty())
        return;
    const int count = int(m_sheets.size());
    const QSizeF paper = m_sheets.front().paperMm;
    const auto [columns, scale] = bestGrid(count, paper, size());
    if (scale <= 0)
        return;
    const int rows = (count + columns - 1) / columns;
    const QSizeF sheetPx = paper * scale;
    const QPointF start(0.5 * (width() - columns * sheetPx.width() - (columns - 1) * gapPx),
                        0.5 * (height() - rows * sheetPx.height() - (rows - 1) * gapPx));
    for (int i = 0; i < count; ++i) {
        const int row = i / columns;
        const QPointF corner = start + QPointF((i % columns) * (sheetPx.width() + gapPx), row * (sheetPx.height() + gapPx));
        painter.save();
        painter.translate(corner);
        painter.setPen(colours.border);
        painter.setBrush(Qt::white);
        painter.drawRect(QRectF(QPointF(0, 0), sheetPx));
        painter.scale(scale, scale);
        paintTarget(painter, m_spec, m_sheets[std::size_t(i)]);
        painter.restore();
    }
}

} // namespace odo
