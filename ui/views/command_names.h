// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <initializer_list>
#include <utility>

namespace odo {

/// Names by which the settings know commands, whatever language their words are in. A command with a name can
/// be given another key.
inline void nameCommands(std::initializer_list<std::pair<QAction *, const char *>> commands)
{
    for (const auto &[action, name] : commands)
        action->setObjectName(QString::fromLatin1(name));
}

} // namespace odo
