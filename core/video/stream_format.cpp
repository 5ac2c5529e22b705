// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/stream_format.h"

#include "core/video/h264_siting.h"
#include "core/video/jpeg_file.h"

extern "C" {
#include <libavutil/pixdesc.h>
}

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace odo {

namespace {

constexpr std::uint8_t neutralChroma = 128;

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
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
        return YuvMatrix::Bt709; // BT.2020 is nearer to it than to BT.601
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

/// The memory of chroma planes that the decoder did not give as such.
struct OwnChroma
{
    libav::FramePtr picture;
    std::vector<std::uint8_t> u, v;
};

Frame withNeutralChroma(libav::FramePtr picture, Frame frame, int width, int height)
{
    auto own = std::make_shared<OwnChroma>();
    own->picture = std::move(picture);
    own->u.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), neutralChroma);
    frame.u = frame.v = {own->u.data(), width, height, width};
    frame.owner = std::move(own);
    return frame;
}

Frame withChromaTakenApart(libav::FramePtr picture, Frame frame, int width, int height)
{
    auto own = std::make_shared<OwnChroma>();
    own->u.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    own->v.resize(own->u.size());
    std::size_t to = 0;
    for (int y = 0; y < height; ++y) {
        const std::uint8_t *row = picture->data[1] + static_cast<std::ptrdiff_t>(y) * picture->linesize[1];
        for (int x = 0; x < width; ++x, ++to) {
            own->u[to] = row[2 * x];
            own->v[to] = row[2 * x + 1];
        }
    }
    own->picture = std::move(picture);
    frame.u = {own->u.data(), width, height, width};
    frame.v = {own->v.data(), width, height, width};
    frame.owner = std::move(own);
    return frame;
}

} // namespace

bool setChromaShifts(AVPixelFormat pixelFormat, FrameFormat &format)
{
    switch (pixelFormat) {
    case AV_PIX_FMT_YUV420P:
    case AV_PIX_FMT_YUVJ420P:
    case AV_PIX_FMT_NV12:
    case AV_PIX_FMT_GRAY8:
        format.chromaShiftX = format.chromaShiftY = 1;
        return true;
    case AV_PIX_FMT_YUV422P:
    case AV_PIX_FMT_YUVJ422P:
        format.chromaShiftX = 1;
        format.chromaShiftY = 0;
        return true;
    case AV_PIX_FMT_YUV440P:
    case AV_PIX_FMT_YUVJ440P:
        format.chromaShiftX = 0;
        format.chromaShiftY = 1;
        return true;
    case AV_PIX_FMT_YUV444P:
    case AV_PIX_FMT_YUVJ444P:
        format.chromaShiftX = format.chromaShiftY = 0;
        return true;
    default:
        return false;
    }
}

Result<FrameFormat> streamFormat(const VideoInput &input)
{
    const AVCodecParameters &parameters = *input.stream().codecpar;
    const auto pixelFormat = static_cast<AVPixelFormat>(parameters.format);
    const std::string what = "cannot open the video " + input.file().string();
    FrameFormat format;
    format.width = parameters.width;
    format.height = parameters.height;
    if (format.width <= 0 || format.height <= 0)
        return fail(ErrorCode::InvalidInput, what, "the size of its pictures could not be found out",
                    "copy it from the camera again");
    if (libav::isTooLarge(format.width, format.height))
        return fail(ErrorCode::InvalidInput, what, "its pictures have more than 100 megapixels or 32000 pixels a side",
                    "convert it to a smaller size");
    if (!setChromaShifts(pixelFormat, format) || parameters.color_space == AVCOL_SPC_RGB ||
        parameters.color_space == AVCOL_SPC_YCGCO) {
        const char *name = av_get_pix_fmt_name(pixelFormat);
        return fail(ErrorCode::InvalidInput, what,
                    std::string("its pixel format ") + (name ? name : "(unknown)") + " is not read",
                    "convert it to 8-bit YUV, e.g. ffmpeg -i FILE -pix_fmt yuv420p NEW.mp4");
    }
    format.fullRange = isFullRange(pixelFormat, parameters);
    format.matrix = matrixOf(parameters);
    format.siting = sitingOf(input);
    return format;
}

void judgeByMost(const std::vector<std::vector<std::uint8_t>> &jpegs, FrameFormat &format, AVPixelFormat &pixelFormat)
{
    const auto layoutOf = [](const FrameFormat &of) { return std::array{of.width, of.height, of.chromaShiftX, of.chromaShiftY}; };
    std::map<std::array<int, 4>, std::size_t> votes;
    for (const auto &jpeg : jpegs) {
        if (const auto said = jpegFormat(jpeg))
            ++votes[layoutOf(*said)];
    }
    const auto most = std::ranges::max_element(votes, {}, [](const auto &vote) { return vote.second; });
    if (most == votes.end() || 2 * most->second <= jpegs.size() || most->first == layoutOf(format))
        return;
    const auto [width, height, shiftX, shiftY] = most->first;
    if (libav::isTooLarge(width, height))
        return;
    format.width = width;
    format.height = height;
    format.chromaShiftX = shiftX;
    format.chromaShiftY = shiftY;
    pixelFormat = shiftX == 0 ? (shiftY == 0 ? AV_PIX_FMT_YUVJ444P : AV_PIX_FMT_YUVJ440P)
                              : (shiftY == 0 ? AV_PIX_FMT_YUVJ422P : AV_PIX_FMT_YUVJ420P);
}

bool fits(const AVFrame &picture, const FrameFormat &format, AVPixelFormat pixelFormat)
{
    return picture.width == format.width && picture.height == format.height && picture.format == pixelFormat;
}

Frame frameOf(libav::FramePtr picture, const FrameFormat &format)
{
    Frame frame;
    frame.format = format;
    frame.y = {picture->data[0], format.width, format.height, picture->linesize[0]};
    const int chromaWidth = AV_CEIL_RSHIFT(format.width, format.chromaShiftX);
    const int chromaHeight = AV_CEIL_RSHIFT(format.height, format.chromaShiftY);
    if (picture->format == AV_PIX_FMT_GRAY8)
        return withNeutralChroma(std::move(picture), frame, chromaWidth, chromaHeight);
    if (picture->format == AV_PIX_FMT_NV12)
        return withChromaTakenApart(std::move(picture), frame, chromaWidth, chromaHeight);
    frame.u = {picture->data[1], chromaWidth, chromaHeight, picture->linesize[1]};
    frame.v = {picture->data[2], chromaWidth, chromaHeight, picture->linesize[2]};
    frame.owner = std::shared_ptr<const AVFrame>(picture.release(), libav::Delete());
    return frame;
}

} // namespace odo
