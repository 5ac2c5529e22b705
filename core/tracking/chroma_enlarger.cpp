// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/chroma_enlarger.h"

#include <cassert>
#include <cmath>

namespace odo {

namespace {

constexpr int partBits = 3, parts = 1 << partBits; // between samples: their places are multiples of an eighth in every format

std::int16_t between(std::int16_t value, std::int16_t next, std::int16_t beyond)
{
    return std::int16_t(value + (std::int16_t((next - value) * beyond) >> partBits));
}

/// `perSample` luma columns for each sample of a row.
template <int perSample, int block>
void widenRow(const std::int16_t *row, const int *first, const int *beyond, int samples, std::int16_t *__restrict into)
{
    std::array<const std::int16_t *, perSample> left{};
    std::array<std::int16_t, perSample> by{};
    for (std::size_t phase = 0; phase < perSample; ++phase) {
        left[phase] = row + first[phase];
        by[phase] = std::int16_t(beyond[phase]);
    }
    for (int k = 0; k < samples / block * block; ++k) // which it is: then compilers leave none over
        for (std::size_t phase = 0; phase < perSample; ++phase)
            into[perSample * k + int(phase)] = between(left[phase][k], left[phase][k + 1], by[phase]);
}

} // namespace

ChromaEnlarger::ChromaEnlarger(const FrameFormat &format, const PixelRect &part) : m_format(format), m_part(part)
{
    assert(part.x0 % columnUnit == 0);
    const auto before = [](int pixel, double offset, int shift) { return int(std::floor((pixel - offset) / (1 << shift))); };
    const int sx = format.chromaShiftX, sy = format.chromaShiftY;
    const double offsetX = format.chromaOffsetX(), offsetY = format.chromaOffsetY();
    m_samples = {before(part.x0, offsetX, sx), before(part.y0, offsetY, sy), before(part.x1 - 1, offsetX, sx) + 2, before(part.y1 - 1, offsetY, sy) + 2};
    for (int phase = 0; phase < (1 << sx); ++phase) {
        const double at = (part.x0 + phase - offsetX) / (1 << sx);
        m_first[std::size_t(phase)] = int(std::floor(at)) - m_samples.x0;
        m_beyond[std::size_t(phase)] = int(parts * (at - std::floor(at)));
    }
    m_blended.resize(std::size_t(m_samples.width() + 2 * atOnce));
}

void ChromaEnlarger::enlargeRow(const cv::Mat1s &samples, int y, int first, int last, std::int16_t *into)
{
    const int shift = m_format.chromaShiftX, skipped = first >> shift, count = (last - first + atOnce - 1) / atOnce * atOnce >> shift;
    const double at = (m_part.y0 + y - m_format.chromaOffsetY()) / (1 << m_format.chromaShiftY), above = std::floor(at);
    const auto beyond = std::int16_t(parts * (at - above));
    const std::int16_t *upper = samples[int(above) - m_samples.y0] + skipped, *lower = samples[int(above) - m_samples.y0 + 1] + skipped;
    std::int16_t *__restrict blended = m_blended.data();
    constexpr int block = 8;
    for (int x = 0; x < (count / block + 1) * block; ++x)
        blended[x] = between(upper[x], lower[x], beyond);
    if (shift == 0)
        widenRow<1, atOnce / 1>(blended, m_first.data(), m_beyond.data(), count, into);
    else if (shift == 1)
        widenRow<2, atOnce / 2>(blended, m_first.data(), m_beyond.data(), count, into);
    else
        widenRow<4, atOnce / 4>(blended, m_first.data(), m_beyond.data(), count, into);
}

} // namespace odo
