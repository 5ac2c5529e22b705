// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"
#include "core/video/internal/header_number.h"

#include <cstdint>
#include <optional>
#include <span>

namespace odo {

/// Whether a file calls itself a still in the container of ISO/IEC 23008-12 (HEIC, HIF, AVIF) that libheif
/// can read; a video in the same container does not.
bool isHeif(std::span<const std::uint8_t> file);

/// Of its primary image as coded, before it is cut and turned: what a decoder takes memory for. 0: not told.
StatedSize heifSize(std::span<const std::uint8_t> file);

/// The primary image as red, green and blue, turned and mirrored as its file says, as a full-range frame by
/// BT.601; nullopt where it is damaged.
std::optional<Frame> decodeHeif(std::span<const std::uint8_t> file);

} // namespace odo
