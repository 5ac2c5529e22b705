// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/planes/field_motion.h"

#include <cmath>
#include <cstdlib>

namespace odo {

namespace {

constexpr int leastChange = 20; // of luma: beyond noise and coding
constexpr std::int64_t fewestPixels = 500;
// of the time between two frames, by which the bottom field is later: 0, or half of it
constexpr double mostProgressive = 0.12, leastInterlaced = 0.3;

PixelRect allOf(const Frame &frame)
{
    return frame.validRegion.value_or(PixelRect{0, 0, frame.y.width, frame.y.height});
}

} // namespace

void FieldMotion::add(const Frame &frame, const std::optional<PixelRect> &region)
{
    if (m_before && m_before->index + 1 == frame.index && sameLayout(m_before->format, frame.format)) {
        const PixelRect both = allOf(*m_before).clipped(allOf(frame));
        compare(*m_before, frame, region ? region->clipped(both) : both);
    }
    m_before = frame;
}

void FieldMotion::compare(const Frame &before, const Frame &frame, const PixelRect &region)
{
    // at an even line the top field is as coded, and the bottom field the mean of the lines beside it
    const int first = std::max(2, region.y0 + 1 + (region.y0 + 1) % 2), end = region.y1 - 1;
    for (int y = first; y < end; y += 2) {
        const std::uint8_t *top0 = before.y.row(y), *above0 = before.y.row(y - 1),
                           *below0 = before.y.row(y + 1), *top1 = frame.y.row(y),
                           *above1 = frame.y.row(y - 1), *below1 = frame.y.row(y + 1);
        for (int x = region.x0; x < region.x1; x += 2) {
            const int bottom0 = (above0[x] + below0[x]) / 2, bottom1 = (above1[x] + below1[x]) / 2;
            const int changes = std::abs(top1[x] - top0[x]) + std::abs(bottom1 - bottom0);
            if (changes < leastChange)
                continue;
            ++m_pixels;
            m_within += changes;
            m_forwards += std::abs(bottom1 - top0[x]);
            m_backwards += std::abs(top1[x] - bottom0);
        }
    }
}

FieldMotion::Kind FieldMotion::kind() const
{
    if (m_pixels < fewestPixels)
        return Kind::Unknown;
    const double later = (m_forwards - m_backwards) / m_within;
    if (std::abs(later) < mostProgressive)
        return Kind::Progressive;
    if (std::abs(later) < leastInterlaced)
        return Kind::Unknown;
    return later > 0 ? Kind::TopFirst : Kind::BottomFirst;
}

} // namespace odo
