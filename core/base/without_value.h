// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace odo {

/// Whether it went well, where nobody wants the value.
template <class T>
Result<void> withoutValue(const Result<T> &outcome)
{
    return outcome ? Result<void>() : tl::unexpected(outcome.error());
}

} // namespace odo
