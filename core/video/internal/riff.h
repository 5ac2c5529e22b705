// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/internal/header_number.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace odo {

/// Whether a file is a WebP image that ends where its header says or later (RFC 9649 §2.4). One that is
/// shorter is still told by its header.
bool isWebp(std::span<const std::uint8_t> file);
bool isCutWebp(std::span<const std::uint8_t> file);

/// By the coded image itself, and by the canvas where one is stated; they must agree. 0 for an animation.
StatedSize webpSize(std::span<const std::uint8_t> file);

/// The content of the first chunk of a RIFF file with these four letters; empty where there is none, or where
/// it is cut short.
std::span<const std::uint8_t> riffChunk(std::span<const std::uint8_t> file, std::string_view name);

} // namespace odo
