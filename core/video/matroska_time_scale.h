// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"

#include <filesystem>

namespace odo {

/// libav's Matroska muxer counts in milliseconds and nothing else, which would shift frames by up to half of
/// one. So the writer hands it microseconds as if they were milliseconds, and this turns the finished file
/// into the truth: it sets TimestampScale (RFC 9559 §5.1.2.9) to 1000 ns and the DURATION tag to the real
/// duration. The file must have been written without CRC-32 elements.
Result<void> setMicrosecondScale(const std::filesystem::path &file, Nanoseconds duration);

} // namespace odo
