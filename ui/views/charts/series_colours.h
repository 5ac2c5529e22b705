// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QColor>
#include <QString>
#include <array>
#include <vector>

class QPalette;

namespace odo {

/// Places in the palette of charts and maps (seriesColour) of robots that are drawn together: a chosen colour
/// is kept, the others get, in their order, those that nobody chose. Pure.
std::vector<int> colourPlaces(const std::vector<DrawingColour> &chosen);
std::vector<int> colourPlaces(const std::vector<RobotRecord> &robots);
std::vector<int> colourPlaces(const TrialScene &scene);

/// The colour of a robot that need not be told from others: the chosen one, else `plain`. Pure.
QColor drawnColour(DrawingColour chosen, const QColor &plain, const QPalette &palette);

/// The colour of a place of the palette on pictures, which are what the camera saw in light and dark windows.
/// Pure.
QColor colourOnPicture(int place);

/// Every colour that can be chosen, in the order of the palette.
constexpr std::array<DrawingColour, 6> drawingColours{DrawingColour::Blue,   DrawingColour::Vermilion,
                                                      DrawingColour::Green,  DrawingColour::Purple,
                                                      DrawingColour::Orange, DrawingColour::SkyBlue};
/// "blue"; "by itself" for Automatic.
QString drawingColourName(DrawingColour colour);

} // namespace odo
