// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/jpeg_decoder.h"
#include "core/video/libav.h"

namespace odo {

/// A picture of an MJPEG stream of which only a part was decoded, with its packet.
class JpegPicture : public CodedPicture
{
public:
    JpegPicture(libav::PacketPtr packet, std::shared_ptr<JpegDecoder> decoder)
        : m_packet(std::move(packet)), m_decoder(std::move(decoder))
    {
    }
    Result<Frame> decodeWhole() const override
    {
        Frame frame;
        if (m_decoder->decode(bytesOf(*m_packet), std::nullopt, frame) != JpegDecoder::Outcome::Decoded)
            return fail(ErrorCode::InvalidInput, "cannot decode all of a frame", "its data are damaged",
                        "its sound part is used");
        return frame;
    }
    static std::span<const std::uint8_t> bytesOf(const AVPacket &packet)
    {
        return {packet.data, static_cast<std::size_t>(packet.size)};
    }

private:
    const libav::PacketPtr m_packet;
    const std::shared_ptr<JpegDecoder> m_decoder;
};

} // namespace odo
