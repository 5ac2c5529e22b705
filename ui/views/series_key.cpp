// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/series_key.h"

#include "ui/views/theme.h"

#include <QPainter>

namespace odo {

namespace {

constexpr int lineLength = 26, lineGap = 6, entryGap = 14, longestName = 130;

} // namespace

SeriesKey::SeriesKey(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Key to the lines"));
    hide();
}

void SeriesKey::setNames(const QStringList &names, std::vector<int> places)
{
    m_names = names;
    m_places = std::move(places);
    setAccessibleDescription(names.join(QStringLiteral(", ")));
    // As plain text, whatever the names contain, and not wider than the screen.
    setToolTip(QStringLiteral("<p>%1</p>")
                   .arg(names.join(u'\n').left(2000).toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"))));
    setVisible(names.size() > 1);
    updateGeometry();
    update();
}

QString SeriesKey::shown(const QString &name) const
{
    return fontMetrics().elidedText(name, Qt::ElideMiddle, longestName);
}

QSize SeriesKey::sizeHint() const
{
    int width = 0;
    for (const QString &name : m_names)
        width += lineLength + lineGap + fontMetrics().horizontalAdvance(shown(name)) + entryGap;
    return {width, fontMetrics().height()};
}

void SeriesKey::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    int left = entryGap;
    for (int i = 0; i < m_names.size(); ++i) {
        const int place = m_places.empty() ? i : m_places.at(static_cast<std::size_t>(i));
        painter.setPen(QPen(seriesColour(place, palette()), 2, seriesDash(i)));
        painter.drawLine(QPointF(left, middle), QPointF(left + lineLength, middle));
        left += lineLength + lineGap;
        painter.setPen(ThemeColours::of(palette()).text);
        painter.drawText(QRect(left, 0, width() - left, height()), Qt::AlignLeft | Qt::AlignVCenter,
                         shown(m_names[i]));
        left += fontMetrics().horizontalAdvance(shown(m_names[i])) + entryGap;
    }
}

} // namespace odo
