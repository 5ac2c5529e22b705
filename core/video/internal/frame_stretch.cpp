// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/frame_stretch.h"

#include "core/video/internal/libav.h"
#include "core/video/internal/pixel_planes.h"

#include <cmath>
extern "C" {
#include <libswscale/swscale.h>
}

namespace odo {

namespace {

FrameFormat withWidth(FrameFormat format, int width)
{
    format.width = width;
    return format;
}

} // namespace

int widthAsSeen(const FrameFormat &format, AVRational pixelAspect)
{
    constexpr double most = 3;
    const int covered = 1 << format.chromaShiftX;
    if (pixelAspect.num <= 0 || pixelAspect.den <= 0)
        return format.width;
    const double aspect = av_q2d(pixelAspect);
    const auto width = static_cast<std::int64_t>(std::lround(format.width * aspect / covered)) * covered;
    const bool isUsable = aspect < most && aspect > 1 / most && !libav::isTooLarge(width, format.height);
    return isUsable ? static_cast<int>(width) : format.width;
}

FrameStretcher::FrameStretcher(const FrameFormat &given, int width)
    : m_frames(withWidth(given, width)), m_scaler(libav::allocated(sws_alloc_context()))
{
    constexpr int wholePixel = 256; // of chroma positions
    const auto set = [this](const char *name, std::int64_t value) {
        av_opt_set_int(m_scaler.get(), name, value, 0);
    };
    set("srcw", given.width);
    set("srch", given.height);
    set("dstw", width);
    set("dsth", given.height);
    for (const char *name : {"src_format", "dst_format"})
        set(name, pixelsLike(given));
    for (const char *name : {"src_h_chr_pos", "dst_h_chr_pos"})
        set(name, std::lround(wholePixel * given.chromaOffsetX()));
    for (const char *name : {"src_v_chr_pos", "dst_v_chr_pos"})
        set(name, std::lround(wholePixel * given.chromaOffsetY()));
    set("sws_flags", SWS_BICUBIC | SWS_ACCURATE_RND);
    if (libav::checked(sws_init_context(m_scaler.get(), nullptr, nullptr)) < 0)
        throw std::bad_alloc();
}

Frame FrameStretcher::stretched(const Frame &frame) const
{
    auto [result, y, u, v] = m_frames.take();
    const std::uint8_t *const from[] = {frame.y.data, frame.u.data, frame.v.data, nullptr};
    const int strides[] = {int(frame.y.stride), int(frame.u.stride), int(frame.v.stride), 0};
    std::uint8_t *const to[] = {y, u, v, nullptr};
    const int toStrides[] = {result.y.width, result.u.width, result.v.width, 0};
    libav::checked(sws_scale(m_scaler.get(), from, strides, 0, frame.y.height, to, toStrides));
    result.index = frame.index;
    result.time = frame.time;
    return result;
}

void FrameStretcher::Free::operator()(SwsContext *scaler) const
{
    sws_freeContext(scaler);
}

} // namespace odo
