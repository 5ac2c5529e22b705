// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/series_key.h"

#include "ui/views/charts/chart_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractButton>
#include <QHBoxLayout>
#include <QPainter>

namespace odo {

/// One line and its name; checked: it is shown.
class SeriesKeyEntry : public QAbstractButton
{
public:
    SeriesKeyEntry(const QString &name, int place, int index, QWidget *parent)
        : QAbstractButton(parent), m_place(place), m_index(index)
    {
        setText(name);
        setCheckable(true);
        setChecked(true);
        setAccessibleName(name);
        setFocusPolicy(Qt::TabFocus); // a click leaves Space to playing
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        // As plain text, whatever the name contains.
        setToolTip(QStringLiteral("<p>%1</p>")
                       .arg(SeriesKey::tr("%1: click to hide or show")
                                .arg(name.left(mostInToolTip))
                                .toHtmlEscaped()));
    }
    QSize sizeHint() const override
    {
        return {2 * aside + lineLength + lineGap + fontMetrics().horizontalAdvance(shownName()),
                fontMetrics().height() + 2};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const ThemeColours colours = ThemeColours::of(palette());
        const double middle = height() / 2.0;
        painter.setPen(
            QPen(isChecked() ? seriesColour(m_place, palette()) : colours.border, 2, seriesDash(m_index)));
        painter.drawLine(QPointF(aside, middle), QPointF(aside + lineLength, middle));
        QFont words = font();
        words.setStrikeOut(!isChecked());
        painter.setFont(words);
        painter.setPen(isChecked() ? colours.text : colours.muted);
        painter.drawText(rect().adjusted(aside + lineLength + lineGap, 0, 0, 0),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, shownName());
        drawChartFocus(painter, *this);
    }

private:
    static constexpr int aside = 6, lineLength = 26, lineGap = 6, longestName = 130, mostInToolTip = 500;

    QString shownName() const { return fontMetrics().elidedText(text(), Qt::ElideMiddle, longestName); }

    int m_place, m_index;
};

SeriesKey::SeriesKey(QWidget *parent) : QWidget(parent)
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Key to the lines"));
    hide();
}

void SeriesKey::setNames(const QStringList &names, const std::vector<int> &places)
{
    qDeleteAll(m_entries);
    m_entries.clear();
    setAccessibleDescription(names.join(QStringLiteral(", ")));
    for (int i = 0; names.size() > 1 && i < names.size(); ++i) {
        const int place = places.empty() ? i : places.at(static_cast<std::size_t>(i));
        auto *entry = new SeriesKeyEntry(names[i], place, i, this);
        connect(entry, &QAbstractButton::toggled, this,
                [this, i](bool isShown) { Q_EMIT toggled(i, isShown); });
        layout()->addWidget(entry);
        m_entries << entry;
    }
    layout()->activate();
    setVisible(names.size() > 1);
}

} // namespace odo
