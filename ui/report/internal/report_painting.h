// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/models/number_text.h"

#include <QFont>
#include <QImage>
#include <QList>
#include <QPalette>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <QStringList>
#include <Qt>
#include <functional>
#include <vector>

class QPainter;

namespace odo {

enum class Paper { A4, Letter };
/// "a4", "letter": the word kept in the settings and given on the command line; another one is A4.
Paper paperFromWord(const QString &word);
QString paperWord(Paper paper);

/// The sheet of a page. Lengths of pages are logical pixels, 96 to the inch, as on the screen, so that the
/// same classes paint both.
struct PageFormat
{
    static constexpr double unitsPerInch = 96;
    static constexpr double margin = 45; ///< 12 mm, which every printer can print

    Paper paper = Paper::A4;
    bool isLandscape = false;

    QSizeF size() const;
    QRectF content() const; ///< within the margins
};

/// What a school has on all of its reports.
struct Letterhead
{
    QString school; ///< may be empty
    QString remark; ///< a line at the foot; may be empty
    QImage logo;    ///< null: none
};

/// One page, ready to be painted any number of times, on any thread: onto paper, or onto the screen for a
/// preview. Paints in light colours, whatever the theme.
struct ReportPage
{
    PageFormat format;
    std::function<void(QPainter &)> paint; ///< in the lengths of format, from the sheet's upper left corner
};
using ReportPages = std::vector<ReportPage>;

/// A page as an image, so many pixels wide.
QImage pageImage(const ReportPage &page, int widthPx);

/// What the parts of all reports are painted with. Any thread.

/// Reports are printed in light colours.
const QPalette &reportPalette();
/// Embedded in the file; the same on every computer. Not hinted, so that a page has the same line breaks at
/// every resolution.
QFont reportFont(int size, QFont::Weight weight = QFont::Normal);
constexpr int bodySize = 11, smallSize = 9;

/// Names come from people: characters that cannot be seen and that turn the order of the others around are
/// shown as a sign of their own, a long one is cut.
QString literalName(const QString &name);
QString literalName(const std::string &name);

/// One line within a rectangle, one size smaller where that leaves it whole; what does not fit then is cut
/// with an ellipsis. Text is never markup.
void drawLine(QPainter &painter, const QRectF &rect, const QString &text, const QFont &font,
              const QColor &colour, Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter);
/// A paragraph broken between words; the last of at most so many lines has all that is left.
QStringList linesOf(const QString &paragraph, const QFont &font, double width, int most);
/// Several lines, broken between words; what does not fit at the foot is cut. Gives the height used.
double drawParagraph(QPainter &painter, const QRectF &rect, const QString &text, const QFont &font,
                     const QColor &colour);

/// The name of a part, with a remark at its right in small print, and a thin line below; gives what is left
/// of the rectangle.
QRectF drawPartTitle(QPainter &painter, const QRectF &rect, const QString &title, const QString &remark = {});

/// A large metric: name above, value large, unit and ± small beside it, a remark below.
struct ReportMetric
{
    QString name;
    NumberText number;
    QString remark; ///< "class median 5.31 s"; may be empty
};
/// Side by side, divided by thin lines, over the whole rectangle.
void drawMetrics(QPainter &painter, const QRectF &rect, const QList<ReportMetric> &reportMetrics);

/// The head of a page: school and logo, the title, a line of facts, a rule below. Gives what is left.
QRectF drawHead(QPainter &painter, const QRectF &rect, const Letterhead &letterhead, const QString &title,
                const QStringList &facts);
/// The foot of a page, lines of small print above its lower end; gives what is left.
QRectF drawFoot(QPainter &painter, const QRectF &rect, const Letterhead &letterhead,
                const QStringList &lines);

/// The day alone, as the locale has it.
QString reportDay(Instant instant);

/// A table with thin lines between its rows. The first column is left-aligned, the others as specified.
struct ReportTable
{
    struct Row
    {
        QStringList cells;
        bool isFaint = false; ///< not significant, or otherwise of no weight
        bool isStrong = false;
    };
    QStringList header; ///< may be empty
    QList<Row> rows;
    /// of the columns; as many as cells. What one does not need goes to those that would be cut
    QList<double> weights;
    QList<Qt::Alignment> alignments; ///< likewise; left where empty
    double rowHeight = 15;           ///< of a single line
    int mostLines = 1;               ///< of a row whose words are too many for one
};
/// What all rows need in a width.
double tableHeight(const ReportTable &table, double width);
/// What does not fit into the rectangle is left out, and the last line says how many rows that were. Gives
/// the height used.
double drawTable(QPainter &painter, const QRectF &rect, const ReportTable &table);

} // namespace odo
