// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace odo {

/// Characters that a person does not see and that change what is shown: controls, line separators, soft
/// hyphens, blanks of no width, directional marks and overrides, fillers. Not the joiners that scripts and
/// emoji need.
bool isInvisible(char32_t character);

/// A text from a file, a device or another program as it can be shown: no escape sequence reaches a terminal,
/// and nothing is written backwards or hidden. Control characters become \x1b, other invisible ones ‹U+202E›,
/// bytes that are not UTF-8 \xff; line breaks and tabs are kept. UTF-8. Any thread.
std::string plainText(std::string_view text);

/// The same for what must stay on one line: line breaks and tabs become \x0a and \x09.
std::string plainLine(std::string_view text);

/// With a to z in place of A to Z; all else, also letters beyond ASCII, as it is, whatever the locale.
std::string lowerCaseAscii(std::string_view text);

} // namespace odo
