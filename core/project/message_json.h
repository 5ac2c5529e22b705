// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <QJsonObject>
#include <string>

namespace odo {

/// Messages as data, for a project and for whoever reads one. Pure functions, any thread.

/// {"code": "trajectory.jump_of", "arguments": {"1": {"number": 40, "decimals": 0, "unit": "mm"}}};
/// docs/project_file.md lists the kinds of arguments. What joined() has combined has all of its parts
/// as arguments. {} of an empty message.
QJsonObject toJson(const Message &message);
/// What toJson() gave. Empty where there is no code; what is no argument is an empty label.
Message messageFromJson(const QJsonObject &json);

/// As it is stored: that JSON on one line; nothing of an empty message.
std::string storedMessage(const Message &message);
/// A text that is no stored message is foreignWords().
Message messageFromStored(const std::string &stored);

} // namespace odo
