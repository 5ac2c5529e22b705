// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace odo {

/// A pixel format that can be made planes of, as GenICam's Pixel Format Naming Convention has it.
struct GenicamFormat
{
    std::uint32_t code = 0;
    const char *name = "";
    int bytesPerPixel = 1;
};

/// Those that can be used, the best for tracking first: colours as the sensor has them, then colours that the
/// camera made of them, then none.
std::span<const GenicamFormat> usableGenicamFormats();
std::optional<GenicamFormat> usableGenicamFormat(std::uint32_t code);

/// "BayerRG8, RGB8, ..."
std::string namesOfUsableFormats();

/// The planes of a picture of a usable format; rows lie behind one another. The bytes are copied.
Frame genicamPlanes(const GenicamFormat &format, const std::uint8_t *bytes, int widthPx, int heightPx);

} // namespace odo
