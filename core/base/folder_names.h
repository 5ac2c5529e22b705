// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace odo {

/// The names of all that lies in a folder, but "." and "..", in no order. problem: why it could not be read to its end, or nothing;
/// what was read until then is given. Where memory is refused std::bad_alloc is thrown, while std::filesystem's iterators
/// then end the program: libstdc++ 12 puts their paths together in a function that is noexcept. Any thread.
std::vector<std::string> namesIn(const std::filesystem::path &folder, std::error_code &problem);

} // namespace odo
