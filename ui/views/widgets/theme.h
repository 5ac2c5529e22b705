// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/number_text.h"

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>
#include <Qt>

class QApplication;

namespace odo {

/// The palettes of Odograph. A window takes one of them; every view derives its colours from whatever palette
/// is in force (ThemeColours::of) and follows when it changes.
QPalette lightPalette();
QPalette darkPalette();
bool isDark(const QPalette &palette);

/// What the views paint with; contrast of text to its ground is 4.5:1 or better.
struct ThemeColours
{
    QColor card, border, text, muted;
    QColor field;     ///< frame of what is written or chosen; 3:1 to the grounds it lies on
    QColor grid;      ///< of a chart
    QColor accent;    ///< play button, slider
    QColor selection; ///< ground of a chosen row; its text keeps its colour
    QColor spike;     ///< always with a triangle
    QColor point;     ///< measured points
    QColor bubble, bubbleText;
    QColor imageBackground; ///< around a letter-boxed image; text and muted can be read on it
    QColor mapGround, mapGrid;

    static ThemeColours of(const QPalette &palette);
};

/// Ground and text of a badge.
struct BadgeColours
{
    QColor ground, text;
};
BadgeColours badgeColours(BadgeState state, const QPalette &palette);

/// The colour of the n-th robot in charts and maps (Okabe and Ito 2008); never the only difference, see
/// seriesDash.
QColor seriesColour(int index, const QPalette &palette);
Qt::PenStyle seriesDash(int index);
/// Which colours show values on maps; both read well without red and green, and in grey.
enum class ColourScale {
    Cividis, ///< Nuñez, Anderton and Renslow 2018
    Viridis  ///< Smith and van der Walt 2015
};
/// "cividis", "viridis": the word kept in the settings; another one is Cividis.
ColourScale colourScaleFromWord(const QString &word);
QString colourScaleWord(ColourScale scale);
/// That of the whole program; what has been painted stays as it is until it is repainted. Any thread.
void setShownColourScale(ColourScale scale);
ColourScale shownColourScale();
/// At 0 to 1 of a scale; by itself of the one that is shown.
QColor scaleColour(double fraction, ColourScale scale = shownColourScale());

/// One of our line icons ("icons/NAME.svg"), drawn in the palette's text colour at whatever size and scale it
/// is asked for, so that it follows light and dark. With a colour given, always in that one.
QIcon themeIcon(const QString &name, const QColor &colour = {});

/// Light, dark, or as the desktop has it.
enum class Theme { System, Light, Dark };

/// "light", "dark"; anything else is System. The word kept in the settings.
Theme themeFromName(const QString &name);
QString themeName(Theme theme);

/// Gives the application its look: Fusion, a palette of ours, and the style sheet. Can be called again at any
/// time, e.g. when the user chooses another theme or the desktop changes its own. GUI thread.
void applyAppearance(QApplication &application, Theme theme = Theme::System);

} // namespace odo
