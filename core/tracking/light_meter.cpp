// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/light_meter.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double wantedSamples = 4000, fewestSamples = 400;
constexpr int noticeable = 4; ///< code values: beyond the noise of most samples
constexpr int darkOffset = 8; ///< code values added, so that a dark picture's noise is no change of light
constexpr int limitedBlack = 16;

/// What two pictures have in common.
PixelRect commonPart(const Frame &a, const Frame &b)
{
    const PixelRect picture{0, 0, b.y.width, b.y.height};
    return a.validRegion.value_or(picture).clipped(b.validRegion.value_or(picture)).clipped(picture);
}

struct Change
{
    double ratio = 1, share = 0;
};

Change changeBetween(const Frame &last, const Frame &frame)
{
    const PixelRect part = commonPart(last, frame);
    if (part.isEmpty())
        return {};
    const int step =
        std::max(1, static_cast<int>(std::sqrt(double(part.width()) * double(part.height()) / wantedSamples)));
    std::int64_t before = 0, now = 0, brighter = 0, count = 0;
    for (int y = part.y0; y < part.y1; y += step) {
        const std::uint8_t *from = last.y.row(y), *to = frame.y.row(y);
        for (int x = part.x0; x < part.x1; x += step) {
            const int difference = to[x] - from[x];
            before += from[x];
            now += to[x];
            brighter += (difference > noticeable) - (difference < -noticeable);
            ++count;
        }
    }
    if (double(count) < fewestSamples)
        return {};
    const std::int64_t zero = count * (darkOffset - (frame.format.fullRange ? 0 : limitedBlack));
    return {double(std::max(now + zero, count)) / double(std::max(before + zero, count)),
            double(brighter) / double(count)};
}

} // namespace

LightLevel LightMeter::measure(const Frame &frame)
{
    Change change;
    if (m_last && m_last->y.width == frame.y.width && m_last->y.height == frame.y.height)
        change = changeBetween(*m_last, frame);
    m_level *= change.ratio;
    m_last = frame;
    return {frame.time, m_level, change.share};
}

} // namespace odo
