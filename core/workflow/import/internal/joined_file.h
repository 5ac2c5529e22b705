// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace odo {

/// Whether a file is several AVI, MP4 or MOV files, one behind the other (as by `cat`). Readers take the
/// second of AVI as if its first frame followed at once, and ignore that of MP4. Reads the headers of the
/// outermost parts only. False for other formats and for what cannot be read. Any thread.
bool isSeveralFiles(const std::filesystem::path &file);

} // namespace odo
