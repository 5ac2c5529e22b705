// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace odo {

/// chroma_sample_loc_type (0 left, 1 centre, 2 top left, ...) of the first sequence parameter set in H.264
/// decoder configuration (avcC or Annex B), or nullopt where the stream says nothing about it. Never reads
/// outside `data`. Source: ITU-T H.264 (08/2021) §7.3.2.1.1 and §E.1.1.
std::optional<unsigned> h264ChromaLocation(std::span<const std::uint8_t> data);

} // namespace odo
