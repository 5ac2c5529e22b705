// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <system_error>
#include <tl/expected.hpp>

namespace odo {

/// A value, or the system's reason why there is none.
template <class T>
using SystemResult = tl::expected<T, std::error_code>;

} // namespace odo
