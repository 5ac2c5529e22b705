// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/ffv1_checksum.h"

extern "C" {
#include <libavutil/crc.h>
}

namespace odo {

bool ffv1ChecksumsHold(std::span<const std::uint8_t> packet)
{
    constexpr std::size_t footer = 8;
    const AVCRC *table = av_crc_get_table(AV_CRC_32_IEEE);
    while (packet.size() >= footer) { // only the footers tell where slices begin: from the last to the first
        const auto foot = packet.last(footer);
        const std::size_t size = (static_cast<std::size_t>(foot[0]) << 16 | foot[1] << 8 | foot[2]) + footer;
        if (size > packet.size() || av_crc(table, 0, packet.last(size).data(), size) != 0)
            return false;
        packet = packet.first(packet.size() - size);
    }
    return packet.empty();
}

} // namespace odo
