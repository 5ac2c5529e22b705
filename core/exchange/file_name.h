// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace odo {

/// A file name, without folder and ending, out of a name that a person gave: it cannot leave its folder,
/// means nothing to any file system, and shows as it is. Replaced by '-': separators and what Windows forbids
/// (`/ \ : * ? " < > |`), control and format characters (line ends, right-to-left overrides, invisible ones),
/// and bytes that are no UTF-8. Cut to 180 bytes, so that an ending fits; without blanks and dots at the end
/// or a dot at the beginning; names of Windows' devices (CON, COM1…) get a '_' in front. Never empty. Any
/// thread.
std::string fileNameOf(const std::string &name);

} // namespace odo
