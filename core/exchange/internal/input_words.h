// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <string>

namespace odo {

/// What is said of files that others have written, the same words whatever they hold.
Message separatedBySemicolons();
Message notAFiniteNumber(std::string what); ///< the name of an entry, or what stands there
Message entryIsMissing(std::string key);

Message checkRightFile();                       ///< advice
Message beginWithLine(const std::string &line); ///< advice

} // namespace odo
