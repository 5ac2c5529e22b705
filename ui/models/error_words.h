// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

namespace odo {

/// An Error as a person reads it: what, why, and what to do, as sentences.
QString errorInWords(const Error &error);

} // namespace odo
