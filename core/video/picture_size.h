// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace odo {

struct PictureSize
{
    std::uint32_t width = 0, height = 0;
};

/// Width and height that the header of a still picture states, without decoding it: PNG, JPEG, BMP, TIFF and
/// PNM. nullopt for anything else and for headers that end early. Never reads outside `file`.
std::optional<PictureSize> pictureSize(std::span<const std::uint8_t> file);

} // namespace odo
