// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/trial_content.h"

#include <QRectF>

class QPainter;

namespace odo {

/// Two views of a trial at a moment, one below the other, with the robots' ways and outlines as on the screen, and
/// the views' names; a single one is at the top. Where a picture cannot be had, words are in its place.
void drawStills(QPainter &painter, const QRectF &rect, const TrialScene &scene, const std::vector<Still> &stills);

/// One of them, as large as fits; gives where it is.
QRectF drawStill(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t view, const Still &still);

} // namespace odo
