// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>

namespace odo {

/// "dir/a.csv:12": how messages point at a line of an input.
std::string atLine(const std::filesystem::path &file, int line);

/// Reads a whole text file as UTF-8; a byte order mark is dropped. Any thread. Refuses, naming the file:
/// missing, larger than the limit, UTF-16 (with the advice how to save it), bytes that are no text.
Result<std::string> readTextFile(const std::filesystem::path &file, std::size_t maxBytes = 1 << 20);

/// The shortest decimal text that reads back as the same number, with '.', without exponent, whatever the
/// locale.
std::string numberText(double value);

} // namespace odo
