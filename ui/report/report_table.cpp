// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_table.h"

#include "ui/report/report_painting.h"
#include "ui/views/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <vector>

namespace odo {

namespace {

class ReportWords
{
    Q_DECLARE_TR_FUNCTIONS(Report)
};

constexpr double cellLeft = 2, cellRight = 4;

QFont rowFont(const ReportTable::Row &row)
{
    return reportFont(smallSize + 1, row.isStrong ? QFont::DemiBold : QFont::Normal);
}

/// What each column needs so that none of its cells is cut.
QList<double> wantedWidths(const ReportTable &table)
{
    QList<double> wanted(table.weights.size(), 0);
    const auto want = [&](const QStringList &cells, const QFont &font) {
        const QFontMetricsF metrics(font);
        for (qsizetype column = 0; column < std::min(cells.size(), wanted.size()); ++column)
            wanted[column] = std::max(wanted.at(column), metrics.horizontalAdvance(cells.at(column)) + cellLeft + cellRight + 1);
    };
    want(table.header, reportFont(smallSize));
    for (const ReportTable::Row &row : table.rows)
        want(row.cells, rowFont(row));
    return wanted;
}

/// What columns have more than they need goes to those that miss some.
void shareSpareWidth(QList<double> &widths, const QList<double> &wanted)
{
    double spare = 0, missing = 0;
    for (qsizetype column = 0; column < widths.size(); ++column) {
        spare += std::max(0.0, widths.at(column) - wanted.at(column));
        missing += std::max(0.0, wanted.at(column) - widths.at(column));
    }
    const double moved = std::min(spare, missing);
    if (moved <= 0)
        return;
    for (qsizetype column = 0; column < widths.size(); ++column) {
        const double over = widths.at(column) - wanted.at(column);
        widths[column] -= moved * over / (over > 0 ? spare : missing);
    }
}

/// By their weights, as far as no cell is cut; where the room is too small, numbers, which stand at the right, are shown whole as long as
/// the widest column of words has more than they miss.
QList<double> widthsOfColumns(const ReportTable &table, double total)
{
    double whole = 0;
    for (const double weight : table.weights)
        whole += weight;
    QList<double> widths;
    for (const double weight : table.weights)
        widths << total * weight / whole;
    const QList<double> wanted = wantedWidths(table);
    shareSpareWidth(widths, wanted);
    for (qsizetype column = 0; column < std::min(widths.size(), table.alignments.size()); ++column) {
        if (!table.alignments.at(column).testFlag(Qt::AlignRight))
            continue;
        const double missing = wanted.at(column) - widths.at(column);
        qsizetype giving = -1;
        for (qsizetype other = 0; other < widths.size(); ++other)
            if (!table.alignments.at(other).testFlag(Qt::AlignRight) && (giving < 0 || widths.at(other) > widths.at(giving)))
                giving = other;
        if (missing <= 0 || giving < 0 || widths.at(giving) < 2 * missing)
            continue;
        widths[column] += missing;
        widths[giving] -= missing;
    }
    return widths;
}

/// A row of the table with the columns' widths; a cell's words take as many lines as the table allows.
class TableRow
{
public:
    TableRow(const ReportTable &table, const QList<double> &widths, const QStringList &cells, const QFont &font)
        : m_table(table), m_widths(widths), m_font(font)
    {
        for (qsizetype column = 0; column < std::min(cells.size(), widths.size()); ++column)
            m_cells << linesOf(cells.at(column), font, roomOf(column), table.mostLines);
    }
    double height() const
    {
        qsizetype most = 1;
        for (const QStringList &lines : m_cells)
            most = std::max(most, lines.size());
        return m_table.rowHeight + double(most - 1) * lineHeight();
    }
    void draw(QPainter &painter, QPointF at, const QColor &colour) const
    {
        for (qsizetype column = 0; column < m_cells.size(); ++column) {
            const Qt::Alignment side = m_table.alignments.isEmpty() ? Qt::AlignLeft : m_table.alignments.at(column);
            double top = at.y();
            for (const QString &line : m_cells.at(column)) {
                drawLine(painter, QRectF(at.x() + cellLeft, top, roomOf(column), m_table.rowHeight), line, m_font, colour,
                         side | Qt::AlignVCenter);
                top += lineHeight();
            }
            at.rx() += m_widths.at(column);
        }
    }

private:
    double roomOf(qsizetype column) const { return m_widths.at(column) - cellLeft - cellRight; }
    double lineHeight() const { return QFontMetricsF(m_font).height(); }

    const ReportTable &m_table;
    const QList<double> &m_widths;
    QFont m_font;
    QList<QStringList> m_cells;
};

/// How many of the rows have room, the last of which is for what is left out.
qsizetype shownRows(const std::vector<TableRow> &rows, double room, double lastHeight)
{
    double used = 0;
    qsizetype shown = 0, withLast = 0;
    for (const TableRow &row : rows) {
        used += row.height();
        if (used > room + 0.5)
            return withLast;
        ++shown;
        if (used + lastHeight <= room + 0.5)
            withLast = shown;
    }
    return shown;
}

} // namespace

double tableHeight(const ReportTable &table, double width)
{
    const QList<double> widths = widthsOfColumns(table, width);
    double height = table.header.isEmpty() ? 0 : table.rowHeight;
    for (const ReportTable::Row &row : table.rows)
        height += TableRow(table, widths, row.cells, rowFont(row)).height();
    return height;
}

double drawTable(QPainter &painter, const QRectF &rect, const ReportTable &table)
{
    const ThemeColours colours = ThemeColours::of(reportPalette());
    const QList<double> widths = widthsOfColumns(table, rect.width());
    double top = rect.top();
    if (!table.header.isEmpty()) {
        TableRow(table, widths, table.header, reportFont(smallSize)).draw(painter, {rect.left(), top}, colours.muted);
        top += table.rowHeight;
    }
    std::vector<TableRow> rows;
    for (const ReportTable::Row &row : table.rows)
        rows.emplace_back(table, widths, row.cells, rowFont(row));
    const qsizetype shown = shownRows(rows, rect.bottom() - top, table.rowHeight);
    for (qsizetype row = 0; row < shown; ++row) {
        painter.setPen(QPen(colours.grid, 0.7));
        if (row > 0 || !table.header.isEmpty())
            painter.drawLine(QPointF(rect.left(), top), QPointF(rect.right(), top));
        rows[std::size_t(row)].draw(painter, {rect.left(), top}, table.rows.at(row).isFaint ? colours.muted : colours.text);
        top += rows[std::size_t(row)].height();
    }
    if (shown < table.rows.size()) {
        drawLine(painter, QRectF(rect.left() + 2, top, rect.width(), table.rowHeight),
                 ReportWords::tr("and %n more", "", int(table.rows.size() - shown)), reportFont(smallSize),
                 colours.muted);
        top += table.rowHeight;
    }
    return top - rect.top();
}

} // namespace odo
