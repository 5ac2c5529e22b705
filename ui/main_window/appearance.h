// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QApplication;

namespace odo {

/// Light, dark, or as the desktop has it.
enum class Theme { System, Light, Dark };

/// "light", "dark"; anything else is System. The word kept in the settings.
Theme themeFromName(const QString &name);
QString themeName(Theme theme);

/// Gives the application its look: Fusion, a palette of ours, and the style sheet. Can be called again at any
/// time, e.g. when the user chooses another theme or the desktop changes its own. GUI thread.
void applyAppearance(QApplication &application, Theme theme = Theme::System);

} // namespace odo
