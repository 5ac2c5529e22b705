// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/report_painting.h"

#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QTextLayout>
#include <algorithm>
#include <cmath>
#include <vector>

namespace odo {

namespace {

const QString letterWord = QStringLiteral("letter");

} // namespace

Paper paperFromWord(const QString &word)
{
    return word == letterWord ? Paper::Letter : Paper::A4;
}

QString paperWord(Paper paper)
{
    return paper == Paper::Letter ? letterWord : QStringLiteral("a4");
}

QSizeF PageFormat::size() const
{
    constexpr double perMm = unitsPerInch / 25.4;
    const QSizeF upright = paper == Paper::Letter ? QSizeF(8.5, 11) * unitsPerInch : QSizeF(210, 297) * perMm;
    return isLandscape ? upright.transposed() : upright;
}

QRectF PageFormat::content() const
{
    return QRectF(QPointF(0, 0), size()).adjusted(margin, margin, -margin, -margin);
}

QImage pageImage(const ReportPage &page, int widthPx)
{
    const QSizeF size = page.format.size();
    const double scale = widthPx / size.width();
    QImage image(widthPx, int(std::lround(size.height() * scale)), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.scale(scale, scale);
    page.paint(painter);
    return image;
}

namespace {

constexpr qsizetype longestName = 300; // more than fits on any page

class ReportWords
{
    Q_DECLARE_TR_FUNCTIONS(Report)
};

ThemeColours colours()
{
    return ThemeColours::of(reportPalette());
}

/// The largest that leaves a value within a width, down to what is still prominent.
QFont fittingFont(const QString &value, double width)
{
    constexpr int largest = 23, smallest = 14;
    int size = largest;
    while (size > smallest &&
           QFontMetricsF(reportFont(size, QFont::DemiBold)).horizontalAdvance(value) > width)
        --size;
    return reportFont(size, QFont::DemiBold);
}

constexpr double lineSpacing = 1.25; ///< between the lines of a paragraph, in heights of their font

bool isInvisible(QChar c)
{
    return c.category() == QChar::Other_Control || c.category() == QChar::Other_Format ||
           c.category() == QChar::Separator_Line || c.category() == QChar::Separator_Paragraph;
}

} // namespace

const QPalette &reportPalette()
{
    static const QPalette palette = lightPalette();
    return palette;
}

QFont reportFont(int size, QFont::Weight weight)
{
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(size); // points would count the device's own resolution in once more
    font.setWeight(weight);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Letters with a spacing of their own, be it the usual one, are not joined: what is searched for and
    // copied out of the file has "fi" as two of them.
    font.setLetterSpacing(QFont::PercentageSpacing, 100);
    return font;
}

QString literalName(const QString &name)
{
    QString shown = name.left(longestName);
    for (QChar &c : shown) {
        if (isInvisible(c))
            c = QChar::ReplacementCharacter;
    }
    return name.size() > longestName ? shown + QChar(u'…') : shown;
}

QString literalName(const std::string &name)
{
    return literalName(QString::fromStdString(name));
}

void drawLine(QPainter &painter, const QRectF &rect, const QString &text, const QFont &font,
              const QColor &colour, Qt::Alignment alignment)
{
    QFont smaller = font;
    smaller.setPixelSize(font.pixelSize() - 1);
    const bool isHelped = QFontMetricsF(font).horizontalAdvance(text) > rect.width() &&
                          QFontMetricsF(smaller).horizontalAdvance(text) <= rect.width();
    painter.setFont(isHelped ? smaller : font);
    painter.setPen(colour);
    painter.drawText(rect, int(alignment) | Qt::TextSingleLine | Qt::TextDontClip,
                     QFontMetricsF(painter.font()).elidedText(text, Qt::ElideRight, rect.width()));
}

QStringList linesOf(const QString &paragraph, const QFont &font, double width, int most)
{
    QStringList lines;
    QTextLayout layout(paragraph, font);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid() && lines.size() < most;
         line = layout.createLine()) {
        line.setLineWidth(width);
        lines << (lines.size() + 1 == most ? paragraph.mid(line.textStart())
                                           : paragraph.mid(line.textStart(), line.textLength()).trimmed());
    }
    layout.endLayout();
    return lines;
}

double drawParagraph(QPainter &painter, const QRectF &rect, const QString &text, const QFont &font,
                     const QColor &colour)
{
    const double lineHeight = lineSpacing * QFontMetricsF(font).height();
    double top = rect.top();
    for (const QString &paragraph : text.split(u'\n'))
        for (const QString &line :
             linesOf(paragraph, font, rect.width(), int((rect.bottom() + 1 - top) / lineHeight))) {
            drawLine(painter, QRectF(rect.left(), top, rect.width(), lineHeight), line, font, colour);
            top += lineHeight;
        }
    return top - rect.top();
}

QRectF drawPartTitle(QPainter &painter, const QRectF &rect, const QString &title, const QString &remark)
{
    constexpr double height = 18;
    const QFont bold = reportFont(bodySize, QFont::DemiBold);
    drawLine(painter, QRectF(rect.left(), rect.top(), rect.width(), height), title, bold, colours().text);
    const double left = rect.left() + QFontMetricsF(bold).horizontalAdvance(title) + 12;
    drawLine(painter, QRectF(left, rect.top(), std::max(0.0, rect.right() - left), height), remark,
             reportFont(smallSize), colours().muted, Qt::AlignRight | Qt::AlignVCenter);
    painter.setPen(QPen(colours().border, 0.8));
    painter.drawLine(QPointF(rect.left(), rect.top() + height), QPointF(rect.right(), rect.top() + height));
    return rect.adjusted(0, height + 3, 0, 0);
}

void drawMetrics(QPainter &painter, const QRectF &rect, const QList<ReportMetric> &reportMetrics)
{
    constexpr double apart = 5;
    if (reportMetrics.isEmpty())
        return;
    const double width = rect.width() / double(reportMetrics.size());
    double left = rect.left();
    for (const ReportMetric &each : reportMetrics) {
        const QRectF cell =
            QRectF(left, rect.top(), width, rect.height()).adjusted(left > rect.left() ? 10 : 0, 0, -6, 0);
        if (left > rect.left()) {
            painter.setPen(QPen(colours().border, 0.8));
            painter.drawLine(QPointF(left, rect.top() + 4), QPointF(left, rect.bottom() - 4));
        }
        drawLine(painter, QRectF(cell.left(), cell.top(), cell.width(), 15), each.name,
                 reportFont(smallSize + 1), colours().muted);
        const double baseline = cell.top() + 39;
        const QFont small = reportFont(smallSize + 1);
        const double smallWidth = QFontMetricsF(small).horizontalAdvance(each.number.smallPrint());
        const QFont large = fittingFont(each.number.value, cell.width() - smallWidth - apart);
        const double advance = QFontMetricsF(large).horizontalAdvance(each.number.value);
        painter.setFont(large);
        painter.setPen(colours().text);
        painter.drawText(QPointF(cell.left(), baseline), each.number.value);
        painter.setFont(small);
        painter.setPen(colours().muted);
        painter.drawText(QPointF(cell.left() + advance + apart, baseline),
                         QFontMetricsF(small).elidedText(each.number.smallPrint(), Qt::ElideRight,
                                                         cell.width() - advance - apart + 1));
        drawLine(painter, QRectF(cell.left(), cell.top() + 45, cell.width(), 14), each.remark,
                 reportFont(smallSize), colours().muted);
        left += width;
    }
}

QRectF drawHead(QPainter &painter, const QRectF &rect, const Letterhead &letterhead, const QString &title,
                const QStringList &facts)
{
    constexpr double logoHeight = 40, height = 62;
    QRectF area = rect;
    if (!letterhead.logo.isNull()) {
        const QSizeF size =
            QSizeF(letterhead.logo.size()).scaled(QSizeF(140, logoHeight), Qt::KeepAspectRatio);
        painter.drawImage(QRectF(QPointF(rect.right() - size.width(), rect.top()), size), letterhead.logo);
        area.setRight(rect.right() - size.width() - 16);
    }
    drawLine(painter, QRectF(area.left(), area.top(), area.width(), 14),
             letterhead.school.isEmpty() ? ReportWords::tr("Odograph") : literalName(letterhead.school),
             reportFont(smallSize + 1), colours().muted);
    drawLine(painter, QRectF(area.left(), area.top() + 14, area.width(), 26), title,
             reportFont(19, QFont::DemiBold), colours().text);
    drawLine(painter, QRectF(rect.left(), rect.top() + 42, rect.width(), 15),
             facts.join(QStringLiteral("   ·   ")), reportFont(bodySize), colours().text);
    painter.setPen(QPen(colours().text, 1.2));
    painter.drawLine(QPointF(rect.left(), rect.top() + height), QPointF(rect.right(), rect.top() + height));
    return rect.adjusted(0, height + 8, 0, 0);
}

QRectF drawFoot(QPainter &painter, const QRectF &rect, const Letterhead &letterhead, const QStringList &lines)
{
    constexpr double lineHeight = 12;
    QStringList all = lines;
    if (!letterhead.remark.isEmpty())
        all << literalName(letterhead.remark);
    double top = rect.bottom() - lineHeight * double(all.size());
    painter.setPen(QPen(colours().border, 0.8));
    painter.drawLine(QPointF(rect.left(), top - 4), QPointF(rect.right(), top - 4));
    const QRectF left = rect.adjusted(0, 0, 0, -(rect.bottom() - top) - 10);
    for (const QString &line : all) {
        drawLine(painter, QRectF(rect.left(), top, rect.width(), lineHeight), line, reportFont(smallSize - 1),
                 colours().muted);
        top += lineHeight;
    }
    return left;
}

QString reportDay(Instant instant)
{
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count()).date(),
                              QLocale::ShortFormat);
}

namespace {

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
            wanted[column] = std::max(wanted.at(column),
                                      metrics.horizontalAdvance(cells.at(column)) + cellLeft + cellRight + 1);
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

/// By their weights, as far as no cell is cut; if space is short, the numbers on the right are shown whole as
/// long as the widest column of words can spare it.
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
            if (!table.alignments.at(other).testFlag(Qt::AlignRight) &&
                (giving < 0 || widths.at(other) > widths.at(giving)))
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
    TableRow(const ReportTable &table, const QList<double> &widths, const QStringList &cells,
             const QFont &font)
        : m_table(table), m_widths(widths), m_font(font)
    {
        for (qsizetype column = 0; column < std::min(cells.size(), widths.size()); ++column)
            m_cells << linesOf(cells.at(column), font, areaOf(column), table.mostLines);
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
            const Qt::Alignment side =
                m_table.alignments.isEmpty() ? Qt::AlignLeft : m_table.alignments.at(column);
            double top = at.y();
            for (const QString &line : m_cells.at(column)) {
                drawLine(painter, QRectF(at.x() + cellLeft, top, areaOf(column), m_table.rowHeight), line,
                         m_font, colour, side | Qt::AlignVCenter);
                top += lineHeight();
            }
            at.rx() += m_widths.at(column);
        }
    }

private:
    double areaOf(qsizetype column) const { return m_widths.at(column) - cellLeft - cellRight; }
    double lineHeight() const { return QFontMetricsF(m_font).height(); }

    const ReportTable &m_table;
    const QList<double> &m_widths;
    QFont m_font;
    QList<QStringList> m_cells;
};

/// How many of the rows fit; the last one is for what is left out.
qsizetype shownRows(const std::vector<TableRow> &rows, double area, double lastHeight)
{
    double used = 0;
    qsizetype shown = 0, withLast = 0;
    for (const TableRow &row : rows) {
        used += row.height();
        if (used > area + 0.5)
            return withLast;
        ++shown;
        if (used + lastHeight <= area + 0.5)
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
        TableRow(table, widths, table.header, reportFont(smallSize))
            .draw(painter, {rect.left(), top}, colours.muted);
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
        rows[std::size_t(row)].draw(painter, {rect.left(), top},
                                    table.rows.at(row).isFaint ? colours.muted : colours.text);
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
