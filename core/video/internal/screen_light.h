// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace odo {

/// Maps pixels (0xffRRGGBB) of a frame of high dynamic range to those of an ordinary screen, in place, to be
/// looked at only: light by the frame's transfer (ITU-R BT.2100 tables 4 and 5, at a nominal peak of
/// 1000 cd/m²), white of a graphic at 203 cd/m² (ITU-R BT.2408), highlights by Reinhard's extended curve
/// ("Photographic tone reproduction for digital images", 2002, equation 4), colours from BT.2020 to BT.709
/// (ITU-R BT.2087). Any thread. Frames of Transfer::Standard stay as they are.
void mapToScreen(std::span<std::uint32_t> pixels, Transfer transfer);

} // namespace odo
