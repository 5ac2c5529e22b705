// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace odo {

/// Why SQLite did not do what was asked, in words for a person.
struct SqliteRefusal
{
    ErrorCode code;
    Message why, advice;
};

/// Of one of SQLite's result codes. systemError: the errno of what it last asked of the system, 0 where that
/// is not known. Any thread.
SqliteRefusal sqliteRefusal(int resultCode, int systemError);

} // namespace odo
