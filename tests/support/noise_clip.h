// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>

namespace odo::test {

/// A clip for cameras that play it: noise, so that its pictures are of some size; 160 x 96, 30 frames a
/// second.
Result<void> writeNoiseClip(const std::filesystem::path &file, double seconds);

/// Every picture of the recording decodes, and each has its time.
bool playsWholly(const std::filesystem::path &file, std::size_t frames);

} // namespace odo::test
