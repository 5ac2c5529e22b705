// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/video/video_input.h"

#include <vector>

namespace odo {

/// All packets of a video stream in the order of the file, and the frames that they hold in order of
/// presentation.
struct PacketIndex
{
    struct Packet
    {
        std::int64_t pts = AV_NOPTS_VALUE; ///< dts where the file gives no other
        std::int64_t dts = AV_NOPTS_VALUE;
        bool key = false;
    };
    struct ShownFrame
    {
        std::int64_t pts = AV_NOPTS_VALUE;
        std::size_t packet = 0; ///< place in `packets`
    };
    std::vector<Packet> packets;
    std::vector<ShownFrame> frames; ///< by pts, each once; empty pts where `counted`
    std::vector<Nanoseconds> times; ///< of `frames`, since the first, strictly increasing
    /// Packets do not say when their frame is shown: frames can only be told by counting them from the start.
    bool counted = false;
    std::string warning;
    std::vector<std::vector<std::uint8_t>> firstJpegs; ///< of MJPEG: the first packets

    /// The packet to begin decoding with so that this frame comes out: the last key frame before it both in
    /// the file and in presentation (frames that follow a key frame in the file but are shown before it need
    /// the key frame before that).
    std::size_t keyPacketFor(std::size_t frame) const;
    /// The place of the frame with this time stamp; -1 when there is none.
    std::int64_t frameOf(std::int64_t pts) const;
    /// The place of the packet with this time stamp; -1 when there is none.
    std::int64_t packetOf(std::int64_t pts) const;
};

/// Reads the input from where it stands (its start) to its end, without decoding. Error Cancelled, beside those of a file without a frame.
Result<PacketIndex> indexPackets(VideoInput &input);

/// The time stamp by which packets are told apart: pts, else dts.
std::int64_t timeStampOf(const AVPacket &packet);

} // namespace odo
