// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace odo {

/// "O, U and V", for messages; "none" of none.
std::string listed(const std::vector<std::string> &names);

} // namespace odo
