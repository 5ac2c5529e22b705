// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/stream_format.h"

#include "core/video/internal/libav.h"
#include "core/video/internal/pixel_planes.h"
#include "core/video/jpeg.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>
extern "C" {
#include <libavutil/pixdesc.h>
}

namespace odo {

namespace {

bool isFullRange(AVPixelFormat pixelFormat, const AVCodecParameters &parameters)
{
    if (parameters.color_range != AVCOL_RANGE_UNSPECIFIED)
        return parameters.color_range == AVCOL_RANGE_JPEG;
    return pixelFormat == AV_PIX_FMT_YUVJ420P || pixelFormat == AV_PIX_FMT_YUVJ422P ||
           pixelFormat == AV_PIX_FMT_YUVJ440P || pixelFormat == AV_PIX_FMT_YUVJ444P ||
           parameters.codec_id == AV_CODEC_ID_MJPEG;
}

YuvMatrix matrixOf(const AVCodecParameters &parameters)
{
    switch (parameters.color_space) {
    case AVCOL_SPC_BT709:
        return YuvMatrix::Bt709;
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
        return YuvMatrix::Bt2020;
    case AVCOL_SPC_UNSPECIFIED:
        break;
    default:
        return YuvMatrix::Bt601;
    }
    // Unsaid: JPEG is BT.601 by definition (JFIF); otherwise high definition is BT.709, as players take it.
    const bool highDefinition = parameters.width >= 1280 || parameters.height > 576;
    return highDefinition && parameters.codec_id != AV_CODEC_ID_MJPEG ? YuvMatrix::Bt709 : YuvMatrix::Bt601;
}

ChromaSiting sitingOf(AVChromaLocation location)
{
    switch (location) {
    case AVCHROMA_LOC_LEFT:
        return ChromaSiting::Left;
    case AVCHROMA_LOC_CENTER:
        return ChromaSiting::Center;
    case AVCHROMA_LOC_TOPLEFT:
        return ChromaSiting::TopLeft;
    case AVCHROMA_LOC_TOP:
        return ChromaSiting::Top;
    case AVCHROMA_LOC_BOTTOMLEFT:
        return ChromaSiting::BottomLeft;
    case AVCHROMA_LOC_BOTTOM:
        return ChromaSiting::Bottom;
    default:
        return ChromaSiting::Unknown;
    }
}

ChromaSiting sitingOf(const VideoInput &input)
{
    const AVCodecParameters &parameters = *input.stream().codecpar;
    if (parameters.codec_id == AV_CODEC_ID_MJPEG) {
        // JFIF's, unless the container says otherwise, as of a camera's own samples.
        const ChromaSiting told = sitingOf(input.containerChromaLocation());
        return told == ChromaSiting::Unknown ? ChromaSiting::Center : told;
    }
    if (parameters.codec_id != AV_CODEC_ID_H264)
        return sitingOf(parameters.chroma_location);
    // libav says "left" for H.264 whether the stream said so or nothing at all; cameras that say nothing
    // often mean something else, so that is kept apart.
    const auto stated = h264ChromaLocation(
        {parameters.extradata, static_cast<std::size_t>(std::max(0, parameters.extradata_size))});
    return sitingOf(stated ? static_cast<AVChromaLocation>(*stated + 1) : input.containerChromaLocation());
}

Transfer transferOf(const AVCodecParameters &parameters)
{
    switch (parameters.color_trc) {
    case AVCOL_TRC_ARIB_STD_B67:
        return Transfer::HybridLogGamma;
    case AVCOL_TRC_SMPTE2084:
        return Transfer::PerceptualQuantizer;
    default:
        return Transfer::Standard;
    }
}

} // namespace

Result<FrameFormat> streamFormat(const VideoInput &input)
{
    const AVCodecParameters &parameters = *input.stream().codecpar;
    const auto pixelFormat = static_cast<AVPixelFormat>(parameters.format);
    const Message what = cannotOpenVideo(input.file());
    FrameFormat stated;
    stated.width = parameters.width;
    stated.height = parameters.height;
    if (stated.width <= 0 || stated.height <= 0)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("video.size_not_found", "its frame size could not be determined"),
                    copyFromCamera());
    if (libav::isTooLarge(stated.width, stated.height))
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("video.pictures_too_large",
                             "its frames have more than 100 megapixels or 32000 pixels a side"),
                    ODO_TEXT("video.convert_to_smaller", "convert it to a smaller size"));
    stated.fullRange = isFullRange(pixelFormat, parameters);
    stated.matrix = matrixOf(parameters);
    stated.siting = sitingOf(input);
    stated.transfer = transferOf(parameters);
    const auto format = planesOf(pixelFormat, stated);
    if (!format || parameters.color_space == AVCOL_SPC_YCGCO) {
        const char *name = av_get_pix_fmt_name(pixelFormat);
        return fail(
            ErrorCode::InvalidInput, what,
            name ? ODO_TEXT("video.pixel_format_not_read",
                            "its pixel format %1 is not supported")(std::string(name))
                 : ODO_TEXT("video.unknown_format_not_read", "its pixel format (unknown) is not supported"),
            ODO_TEXT("video.convert_to_yuv",
                     "convert it to 8-bit YUV, e.g. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4"));
    }
    return *format;
}

namespace {

/// Whether behind an image's end another one begins, as where each field of a frame is an image of its own.
bool holdsTwoImages(const std::vector<std::uint8_t> &jpegs)
{
    constexpr std::array<std::uint8_t, 2> begin{0xff, 0xd8}, end{0xff, 0xd9};
    const auto behind = std::search(jpegs.begin(), jpegs.end(), end.begin(), end.end());
    return std::search(behind, jpegs.end(), begin.begin(), begin.end()) != jpegs.end();
}

} // namespace

void judgeByMost(const std::vector<std::vector<std::uint8_t>> &jpegs, FrameFormat &format,
                 AVPixelFormat &pixelFormat)
{
    const auto layoutOf = [](const FrameFormat &of) {
        return std::array{of.width, of.height, of.chromaShiftX, of.chromaShiftY};
    };
    std::map<std::array<int, 4>, std::size_t> votes;
    for (const auto &jpeg : jpegs) {
        if (const auto said = jpegFormat(jpeg))
            ++votes[layoutOf(*said)];
    }
    const auto most = std::ranges::max_element(votes, {}, [](const auto &vote) { return vote.second; });
    if (most == votes.end() || 2 * most->second <= jpegs.size() || most->first == layoutOf(format))
        return;
    const auto [width, height, shiftX, shiftY] = most->first;
    const bool areFields = width == format.width && height == (format.height + 1) / 2 &&
                           2 * std::ranges::count_if(jpegs, &holdsTwoImages) > std::ssize(jpegs);
    if (libav::isTooLarge(width, height) || areFields) // which libav weaves into one frame
        return;
    format.width = width;
    format.height = height;
    format.chromaShiftX = shiftX;
    format.chromaShiftY = shiftY;
    pixelFormat = shiftX == 0 ? (shiftY == 0 ? AV_PIX_FMT_YUVJ444P : AV_PIX_FMT_YUVJ440P)
                              : (shiftY == 0 ? AV_PIX_FMT_YUVJ422P : AV_PIX_FMT_YUVJ420P);
}

namespace {

using Bytes = std::span<const std::uint8_t>;

/// Reads a raw byte sequence payload bit by bit; beyond its end it gives zeros and remembers.
class BitReader
{
public:
    explicit BitReader(Bytes data)
    {
        // Emulation prevention: 00 00 03 stands for 00 00 (§7.4.1).
        int zeros = 0;
        for (const std::uint8_t byte : data) {
            if (zeros >= 2 && byte == 3) {
                zeros = 0;
                continue;
            }
            zeros = byte == 0 ? zeros + 1 : 0;
            m_bytes.push_back(byte);
        }
    }
    unsigned bits(int count)
    {
        unsigned value = 0;
        for (int i = 0; i < count; ++i)
            value = value << 1 | bit();
        return value;
    }
    bool flag() { return bit() != 0; }
    /// Exp-Golomb, unsigned (§9.1). A signed one has the same length, and none of their values is needed
    /// here.
    unsigned golomb()
    {
        int zeros = 0;
        while (!exhausted() && bit() == 0)
            ++zeros;
        return zeros > 31 ? 0 : (1U << zeros) - 1 + bits(zeros);
    }
    bool exhausted() const { return m_at > m_bytes.size() * 8; }

private:
    unsigned bit()
    {
        const std::size_t at = m_at++;
        return at / 8 < m_bytes.size() ? m_bytes[at / 8] >> (7 - at % 8) & 1U : 0U;
    }
    std::vector<std::uint8_t> m_bytes;
    std::size_t m_at = 0;
};

constexpr unsigned sequenceParameterSet = 7;

/// The payload of the first sequence parameter set after its header byte; empty when there is none.
Bytes findParameterSet(Bytes data)
{
    if (data.size() > 8 &&
        data[0] == 1) { // avcC: version, profile, compatibility, level, lengths, count, size
        const std::size_t size = static_cast<std::size_t>(data[6]) << 8 | data[7];
        return (data[5] & 0x1f) > 0 && size > 1 && 8 + size <= data.size() ? data.subspan(9, size - 1)
                                                                           : Bytes();
    }
    for (std::size_t i = 0; i + 4 < data.size(); ++i)
        if (data[i] == 0 && data[i + 1] == 0 && data[i + 2] == 1 &&
            (data[i + 3] & 0x1f) == sequenceParameterSet)
            return data.subspan(i + 4);
    return {};
}

void skipScalingList(BitReader &reader, int size)
{
    unsigned last = 8, next = 8;
    for (int i = 0; i < size && !reader.exhausted(); ++i) {
        if (next != 0) {
            const unsigned code = reader.golomb();
            // of any size where the file is damaged
            const unsigned delta = code % 2 == 1 ? code / 2 + 1 : 0U - code / 2;
            next = (last + delta) % 256;
        }
        last = next == 0 ? last : next;
    }
}

void skipHighProfileFields(BitReader &reader)
{
    const unsigned chromaFormat = reader.golomb();
    if (chromaFormat == 3)
        reader.flag();
    reader.golomb(); // bit depths
    reader.golomb();
    reader.flag();
    if (!reader.flag())
        return;
    for (int i = 0; i < (chromaFormat == 3 ? 12 : 8); ++i)
        if (reader.flag())
            skipScalingList(reader, i < 6 ? 16 : 64);
}

bool isHighProfile(unsigned profile)
{
    constexpr std::array high{100U, 110U, 122U, 244U, 44U, 83U, 86U, 118U, 128U, 138U, 139U, 134U, 135U};
    return std::ranges::find(high, profile) != high.end();
}

/// Everything of the parameter set before vui_parameters_present_flag.
void skipToVui(BitReader &reader)
{
    const unsigned profile = reader.bits(8);
    reader.bits(16);
    reader.golomb();
    if (isHighProfile(profile))
        skipHighProfileFields(reader);
    reader.golomb(); // log2_max_frame_num
    const unsigned orderType = reader.golomb();
    if (orderType == 0) {
        reader.golomb();
    } else if (orderType == 1) {
        reader.flag();
        reader.golomb();
        reader.golomb();
        for (unsigned i = reader.golomb(); i > 0 && !reader.exhausted(); --i)
            reader.golomb();
    }
    reader.golomb(); // reference frames
    reader.flag();
    reader.golomb(); // width
    reader.golomb(); // height
    if (!reader.flag())
        reader.flag();
    reader.flag();
    if (reader.flag()) // cropping
        for (int i = 0; i < 4; ++i)
            reader.golomb();
}

} // namespace

std::optional<unsigned> h264ChromaLocation(Bytes data)
{
    constexpr unsigned extendedAspect = 255;
    BitReader reader(findParameterSet(data));
    skipToVui(reader);
    if (!reader.flag()) // vui_parameters_present_flag
        return std::nullopt;
    if (reader.flag() && reader.bits(8) == extendedAspect)
        reader.bits(32);
    if (reader.flag()) // overscan
        reader.flag();
    if (reader.flag()) { // video signal type
        reader.bits(4);
        if (reader.flag())
            reader.bits(24);
    }
    if (!reader.flag()) // chroma_loc_info_present_flag
        return std::nullopt;
    const unsigned location = reader.golomb();
    return reader.exhausted() || location > 5 ? std::nullopt : std::optional(location);
}

} // namespace odo
