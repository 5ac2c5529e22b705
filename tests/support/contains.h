// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>
#include <string>
#include <string_view>

namespace odo::test {

/// Whether a sentence has these words; prints it where it has not.
inline bool contains(const std::string &text, std::string_view words)
{
    const bool found = text.find(words) != std::string::npos;
    if (!found)
        qWarning("told instead: %s", text.c_str());
    return found;
}

} // namespace odo::test
