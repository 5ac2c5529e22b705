// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QLocale>
#include <QString>

namespace odo {

/// What a map of the floor says.
struct MapWords
{
    QString title;  ///< for who cannot see it
    QString square; ///< how far the lines of its grid are apart: "a square: %1"
    QLocale locale; ///< of that distance
};

/// The floor from above as one element <svg>, with the path of a robot that was tracked, coloured by speed,
/// the task, markers and spikes. Its colours are in the style sheet (drawingStyle). Any thread.
QString runMap(const TrialScene &scene, std::size_t robot, const MapWords &words);

/// The rules of a style sheet for maps and charts as SVG, by the reader's light or dark theme. Any thread.
QString drawingStyle();

} // namespace odo
