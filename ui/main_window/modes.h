// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <optional>

namespace odo {

/// The modes of the window, in the order in which the mode bar shows them.
enum class WindowMode { Testbed, Record, Review, Compare, History };

inline constexpr std::array allModes{WindowMode::Testbed, WindowMode::Record, WindowMode::Review,
                                     WindowMode::Compare, WindowMode::History};

/// "testbed": of its icon, its help, its command and the command line.
QString modeWord(WindowMode mode);
/// nullopt: no mode has that word.
std::optional<WindowMode> modeFromWord(const QString &word);
/// "Testbed", as a person reads it.
QString modeName(WindowMode mode);

} // namespace odo
