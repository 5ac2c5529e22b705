// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/one_field.h"

extern "C" {
#include <libavutil/imgutils.h>
#include <libavutil/pixdesc.h>
}

#include <cstdint>
#include <span>
#include <utility>

namespace odo {

namespace {

/// Fills every other line, from the one before or behind the first one kept.
void fillLines(std::uint8_t *plane, std::ptrdiff_t lineSize, std::size_t bytes, int lines, int firstKept)
{
    const auto line = [&](int y) { return std::span(plane + y * lineSize, bytes); };
    for (int y = 1 - firstKept; y < lines; y += 2) {
        const auto above = line(y > 0 ? y - 1 : y + 1), below = line(y + 1 < lines ? y + 1 : y - 1);
        const auto here = line(y);
        for (std::size_t x = 0; x < bytes; ++x)
            here[x] = static_cast<std::uint8_t>((above[x] + below[x] + 1) / 2);
    }
}

} // namespace

bool isInterlaced(const AVFrame &avFrame)
{
    return avFrame.interlaced_frame != 0;
}

libav::FramePtr firstFieldOf(libav::FramePtr avFrame)
{
    if (libav::checked(av_frame_make_writable(avFrame.get())) < 0)
        return nullptr;
    const auto format = static_cast<AVPixelFormat>(avFrame->format);
    const AVPixFmtDescriptor *description = av_pix_fmt_desc_get(format);
    const int firstKept = avFrame->top_field_first ? 0 : 1;
    for (int plane = 0; description && plane < av_pix_fmt_count_planes(format); ++plane) {
        const int bytes = av_image_get_linesize(format, avFrame->width, plane);
        const int lines =
            plane == 0 ? avFrame->height : AV_CEIL_RSHIFT(avFrame->height, int(description->log2_chroma_h));
        if (bytes > 0 && lines > 1)
            fillLines(avFrame->data[plane], avFrame->linesize[plane], static_cast<std::size_t>(bytes), lines,
                      firstKept);
    }
    return avFrame;
}

} // namespace odo
