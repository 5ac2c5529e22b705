// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_painting.h"

#include "ui/views/theme.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr qsizetype longestName = 300; // more than any page has room for

class ReportWords
{
    Q_DECLARE_TR_FUNCTIONS(Report)
};

ThemeColours colours()
{
    return ThemeColours::of(reportPalette());
}

/// The largest that leaves a value within a width, down to what still stands out.
QFont fittingFont(const QString &value, double width)
{
    constexpr int largest = 23, smallest = 14;
    int size = largest;
    while (size > smallest && QFontMetricsF(reportFont(size, QFont::DemiBold)).horizontalAdvance(value) > width)
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
    // Letters with a spacing of their own, be it the usual one, are not joined: what is searched for and copied
    // out of the file has "fi" as two of them.
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
    for (QTextLine line = layout.createLine(); line.isValid() && lines.size() < most; line = layout.createLine()) {
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
        for (const QString &line : linesOf(paragraph, font, rect.width(), int((rect.bottom() + 1 - top) / lineHeight))) {
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

void drawFigures(QPainter &painter, const QRectF &rect, const QList<ReportFigure> &figures)
{
    constexpr double apart = 5;
    if (figures.isEmpty())
        return;
    const double width = rect.width() / double(figures.size());
    double left = rect.left();
    for (const ReportFigure &each : figures) {
        const QRectF cell = QRectF(left, rect.top(), width, rect.height()).adjusted(left > rect.left() ? 10 : 0, 0, -6, 0);
        if (left > rect.left()) {
            painter.setPen(QPen(colours().border, 0.8));
            painter.drawLine(QPointF(left, rect.top() + 4), QPointF(left, rect.bottom() - 4));
        }
        drawLine(painter, QRectF(cell.left(), cell.top(), cell.width(), 15), each.name,
                 reportFont(smallSize + 1), colours().muted);
        const double baseline = cell.top() + 39;
        const QFont small = reportFont(smallSize + 1);
        const double smallWidth = QFontMetricsF(small).horizontalAdvance(each.figure.smallPrint());
        const QFont large = fittingFont(each.figure.value, cell.width() - smallWidth - apart);
        const double advance = QFontMetricsF(large).horizontalAdvance(each.figure.value);
        painter.setFont(large);
        painter.setPen(colours().text);
        painter.drawText(QPointF(cell.left(), baseline), each.figure.value);
        painter.setFont(small);
        painter.setPen(colours().muted);
        painter.drawText(QPointF(cell.left() + advance + apart, baseline),
                         QFontMetricsF(small).elidedText(each.figure.smallPrint(), Qt::ElideRight,
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
    QRectF room = rect;
    if (!letterhead.logo.isNull()) {
        const QSizeF size = QSizeF(letterhead.logo.size()).scaled(QSizeF(140, logoHeight), Qt::KeepAspectRatio);
        painter.drawImage(QRectF(QPointF(rect.right() - size.width(), rect.top()), size), letterhead.logo);
        room.setRight(rect.right() - size.width() - 16);
    }
    drawLine(painter, QRectF(room.left(), room.top(), room.width(), 14),
             letterhead.school.isEmpty() ? ReportWords::tr("Odograph") : literalName(letterhead.school),
             reportFont(smallSize + 1), colours().muted);
    drawLine(painter, QRectF(room.left(), room.top() + 14, room.width(), 26), title,
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

QString reportDate(Instant instant)
{
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count()),
                              QLocale::ShortFormat);
}

} // namespace odo
