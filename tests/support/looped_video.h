// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace odo::test {

/// Copies the packets of a video so many times over, one after another in time, without coding anything
/// again: a long recording in seconds. Each round lasts as long as the clip and the interval of its last two
/// frames. False when libav would not.
bool loopVideo(const std::filesystem::path &from, const std::filesystem::path &to, int times);

} // namespace odo::test
