// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QColor>
#include <QList>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <array>
#include <vector>

class QPalette;

namespace odo {

/// Palette entries (seriesColour) for robots drawn together on charts and maps: a chosen colour is kept, the
/// others get, in their order, those that nobody chose. Pure.
std::vector<int> paletteIndices(const std::vector<DrawingColour> &chosen);
std::vector<int> paletteIndices(const std::vector<RobotRecord> &robots);
std::vector<int> paletteIndices(const TrialScene &scene);

/// The colour of a robot that need not be distinguished from others: the chosen one, else `plain`. Pure.
QColor drawnColour(DrawingColour chosen, const QColor &plain, const QPalette &palette);

/// The colour of a palette entry on images: the same in light and dark windows. Pure.
QColor colourOnImage(int colourIndex);

/// Every colour that can be chosen, in the order of the palette.
constexpr std::array<DrawingColour, 6> drawingColours{DrawingColour::Blue,   DrawingColour::Vermilion,
                                                      DrawingColour::Green,  DrawingColour::Purple,
                                                      DrawingColour::Orange, DrawingColour::SkyBlue};
/// "blue"; "automatic" for Automatic.
QString drawingColourName(DrawingColour colour);

class SeriesKeyEntry;

/// Which line is whose: a button a line, with a piece of it (seriesColour and seriesDash) and its name, long
/// ones cut in their middle and whole in the tool tip. A click, or Space, hides the line and shows it again.
/// Hidden for fewer than two. GUI thread.
class SeriesKey : public QWidget
{
    Q_OBJECT
public:
    explicit SeriesKey(QWidget *parent = nullptr);
    /// All of them are shown then. colourIndices: of their colours in the palette (paletteIndices); by
    /// default one after the other.
    void setNames(const QStringList &names, const std::vector<int> &colourIndices = {});

Q_SIGNALS:
    void toggled(int index, bool isShown);

private:
    QList<SeriesKeyEntry *> m_entries;
};

} // namespace odo
