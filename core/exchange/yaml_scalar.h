// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace odo {

/// The place of the quote that closes the one at `start`, or npos.
std::size_t closingQuote(const std::string &text, std::size_t start);

/// A scalar without its quotes; its escapes (\n, \t, \", \\, \/, \uXXXX, as JSON has them; '' between single
/// quotes) become what they stand for, unknown ones stay as they are. Text without quotes stays as it is.
std::string unquoted(const std::string &text);

} // namespace odo
