// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/series_colours.h"

#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

namespace odo {

namespace {

class RobotColoursWords
{
    Q_DECLARE_TR_FUNCTIONS(RobotColours)
};

constexpr int paletteSize = static_cast<int>(drawingColours.size());

int placeOf(DrawingColour colour)
{
    return static_cast<int>(std::ranges::find(drawingColours, colour) - drawingColours.begin());
}

} // namespace

std::vector<int> colourPlaces(const std::vector<DrawingColour> &chosen)
{
    std::array<bool, drawingColours.size()> taken{};
    for (const DrawingColour colour : chosen)
        if (colour != DrawingColour::Automatic)
            taken.at(static_cast<std::size_t>(placeOf(colour))) = true;
    std::vector<int> places;
    int next = 0;
    for (const DrawingColour colour : chosen) {
        if (colour != DrawingColour::Automatic) {
            places.push_back(placeOf(colour));
            continue;
        }
        while (next < paletteSize && taken.at(static_cast<std::size_t>(next)))
            ++next;
        places.push_back(next < paletteSize ? next++ : static_cast<int>(places.size()) % paletteSize);
    }
    return places;
}

std::vector<int> colourPlaces(const std::vector<RobotRecord> &robots)
{
    std::vector<DrawingColour> chosen;
    for (const RobotRecord &robot : robots)
        chosen.push_back(robot.drawingColour);
    return colourPlaces(chosen);
}

std::vector<int> colourPlaces(const TrialScene &scene)
{
    std::vector<DrawingColour> chosen;
    for (const SceneRobot &robot : scene.robots)
        chosen.push_back(robot.robot.drawingColour);
    return colourPlaces(chosen);
}

QColor drawnColour(DrawingColour chosen, const QColor &plain, const QPalette &palette)
{
    return chosen == DrawingColour::Automatic ? plain : seriesColour(placeOf(chosen), palette);
}

QColor colourOnPicture(int place)
{
    return seriesColour(place, darkPalette());
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
    return RobotColoursWords::tr("by itself");
}

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
