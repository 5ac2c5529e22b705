// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/series_colours.h"

#include "ui/views/charts/chart_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPainter>
#include <QPalette>
#include <algorithm>

namespace odo {

namespace {

class RobotColoursWords
{
    Q_DECLARE_TR_FUNCTIONS(RobotColours)
};

constexpr int paletteSize = static_cast<int>(drawingColours.size());

int positionOf(DrawingColour colour)
{
    return static_cast<int>(std::ranges::find(drawingColours, colour) - drawingColours.begin());
}

} // namespace

std::vector<int> paletteIndices(const std::vector<DrawingColour> &chosen)
{
    std::array<bool, drawingColours.size()> taken{};
    for (const DrawingColour colour : chosen)
        if (colour != DrawingColour::Automatic)
            taken.at(static_cast<std::size_t>(positionOf(colour))) = true;
    std::vector<int> colourIndices;
    int next = 0;
    for (const DrawingColour colour : chosen) {
        if (colour != DrawingColour::Automatic) {
            colourIndices.push_back(positionOf(colour));
            continue;
        }
        while (next < paletteSize && taken.at(static_cast<std::size_t>(next)))
            ++next;
        colourIndices.push_back(next < paletteSize ? next++
                                                   : static_cast<int>(colourIndices.size()) % paletteSize);
    }
    return colourIndices;
}

std::vector<int> paletteIndices(const std::vector<RobotRecord> &robots)
{
    std::vector<DrawingColour> chosen;
    for (const RobotRecord &robot : robots)
        chosen.push_back(robot.drawingColour);
    return paletteIndices(chosen);
}

std::vector<int> paletteIndices(const TrialScene &scene)
{
    std::vector<DrawingColour> chosen;
    for (const SceneRobot &robot : scene.robots)
        chosen.push_back(robot.robot.drawingColour);
    return paletteIndices(chosen);
}

QColor drawnColour(DrawingColour chosen, const QColor &plain, const QPalette &palette)
{
    return chosen == DrawingColour::Automatic ? plain : seriesColour(positionOf(chosen), palette);
}

QColor colourOnImage(int colourIndex)
{
    return seriesColour(colourIndex, darkPalette());
}

QString drawingColourName(DrawingColour colour)
{
    switch (colour) {
    case DrawingColour::Automatic:
        break;
    case DrawingColour::Blue:
        return RobotColoursWords::tr("blue");
    case DrawingColour::Vermilion:
        return RobotColoursWords::tr("vermilion");
    case DrawingColour::Green:
        return RobotColoursWords::tr("green");
    case DrawingColour::Purple:
        return RobotColoursWords::tr("purple");
    case DrawingColour::Orange:
        return RobotColoursWords::tr("orange");
    case DrawingColour::SkyBlue:
        return RobotColoursWords::tr("sky blue");
    }
    return RobotColoursWords::tr("automatic");
}

/// One line and its name; checked: it is shown.
class SeriesKeyEntry : public QAbstractButton
{
public:
    SeriesKeyEntry(const QString &name, int colourIndex, int index, QWidget *parent)
        : QAbstractButton(parent), m_colourIndex(colourIndex), m_index(index)
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
        painter.setPen(QPen(isChecked() ? seriesColour(m_colourIndex, palette()) : colours.border, 2,
                            seriesDash(m_index)));
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

    int m_colourIndex, m_index;
};

SeriesKey::SeriesKey(QWidget *parent) : QWidget(parent)
{
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Legend"));
    hide();
}

void SeriesKey::setNames(const QStringList &names, const std::vector<int> &colourIndices)
{
    qDeleteAll(m_entries);
    m_entries.clear();
    setAccessibleDescription(names.join(QStringLiteral(", ")));
    for (int i = 0; names.size() > 1 && i < names.size(); ++i) {
        const int colourIndex = colourIndices.empty() ? i : colourIndices.at(static_cast<std::size_t>(i));
        auto *entry = new SeriesKeyEntry(names[i], colourIndex, i, this);
        connect(entry, &QAbstractButton::toggled, this,
                [this, i](bool isShown) { Q_EMIT toggled(i, isShown); });
        layout()->addWidget(entry);
        m_entries << entry;
    }
    layout()->activate();
    setVisible(names.size() > 1);
}

} // namespace odo
