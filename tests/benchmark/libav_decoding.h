// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

namespace odo::test {

/// What a run over a clip cost, in CPU seconds of its thread.
struct PureDecoding
{
    std::int64_t frames = 0;
    double seconds = 0;
};

/// Reads and decodes a clip with libavformat and libavcodec on one thread and looks at nothing: what no
/// program that decodes with them can be faster than. Opening the file is not counted. No frames when that
/// fails.
PureDecoding decodeByLibavcodec(const std::filesystem::path &file);

} // namespace odo::test
