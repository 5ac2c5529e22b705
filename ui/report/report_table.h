// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QRectF>
#include <QStringList>
#include <Qt>

class QPainter;

namespace odo {

/// A table with thin lines between its rows. The first column is at the left, the others as told.
struct ReportTable
{
    struct Row
    {
        QStringList cells;
        bool isFaint = false; ///< within the error, or otherwise of no weight
        bool isStrong = false;
    };
    QStringList header; ///< may be empty
    QList<Row> rows;
    QList<double> weights;           ///< of the columns; as many as cells. What one does not need goes to those that would be cut
    QList<Qt::Alignment> alignments; ///< likewise; left where empty
    double rowHeight = 15;           ///< of a single line
    int mostLines = 1;               ///< of a row whose words are too many for one
};
/// What all rows need in a width.
double tableHeight(const ReportTable &table, double width);
/// What does not fit into the rectangle is left out, and the last line says how many rows that were. Gives the
/// height used.
double drawTable(QPainter &painter, const QRectF &rect, const ReportTable &table);

} // namespace odo
