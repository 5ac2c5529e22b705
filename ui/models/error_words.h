// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

namespace odo {

/// An Error as a person reads it, in the language of the windows: what, why, and what to do, as sentences.
QString errorInWords(const Error &error);

/// The same on one line, as Error::message() has it: "what: why; what to do".
QString errorLine(const Error &error);

} // namespace odo
