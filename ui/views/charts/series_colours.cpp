// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/series_colours.h"

#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPalette>
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

} // namespace odo
