// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>

namespace odo {

struct ProjectConnection;

constexpr int maxNameLength = 200;

/// A name as people may give it to a camera, robot, team, trial…: UTF-8, not blank, at most 200 characters,
/// no control characters or line breaks. `kind` is the word for messages ("robot").
Result<void> checkName(const std::string &kind, const std::string &name);

/// A text that may be long, empty and of several lines; only valid UTF-8 is asked for.
Result<void> checkText(const std::string &kind, const std::string &text);

/// AlreadyExists when the table has a row of that name. `kind` is the word for messages.
Result<void> checkNameIsFree(const ProjectConnection &connection, const std::string &table,
                             const std::string &kind, const std::string &name);

/// The NotFound of a name: "robot 'x': there is no such robot in the project; it has 'red', 'blue'".
tl::unexpected<Error> noSuchName(const ProjectConnection &connection, const std::string &table,
                                 const std::string &kind, const std::string &name);

/// The NotFound of an id that refers to nothing.
tl::unexpected<Error> noSuchId(const ProjectConnection &connection, const std::string &kind, std::int64_t id);

} // namespace odo
