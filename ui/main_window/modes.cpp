// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/modes.h"

#include <QCoreApplication>
#include <algorithm>

namespace odo {
namespace {

struct NamedMode
{
    const char *word, *name;
};

/// In the order of the modes.
constexpr std::array<NamedMode, allModes.size()> names{{{"testbed", QT_TRANSLATE_NOOP("Modes", "Testbed")},
                                                        {"record", QT_TRANSLATE_NOOP("Modes", "Record")},
                                                        {"review", QT_TRANSLATE_NOOP("Modes", "Review")},
                                                        {"compare", QT_TRANSLATE_NOOP("Modes", "Compare")},
                                                        {"history", QT_TRANSLATE_NOOP("Modes", "History")}}};

const NamedMode &named(WindowMode mode)
{
    return names.at(static_cast<std::size_t>(mode));
}

} // namespace

QString modeWord(WindowMode mode)
{
    return QString::fromLatin1(named(mode).word);
}

std::optional<WindowMode> modeFromWord(const QString &word)
{
    const auto same = std::ranges::find(allModes, word, modeWord);
    return same == allModes.end() ? std::nullopt : std::optional(*same);
}

QString modeName(WindowMode mode)
{
    return QCoreApplication::translate("Modes", named(mode).name);
}

} // namespace odo
