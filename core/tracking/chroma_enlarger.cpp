// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/chroma_enlarger.h"

#include <cassert>
#include <cmath>

namespace odo {

namespace {

/// `perSample` luma columns for each sample of a row.
template <int perSample>
void widenRow(const float *row, const int *first, const float *beyond, int samples, float *__restrict into)
{
    for (int k = 0; k < samples; ++k) {
        for (int phase = 0; phase < perSample; ++phase) {
            const float *left = row + first[phase];
            into[perSample * k + phase] = left[k] + beyond[phase] * (left[k + 1] - left[k]);
        }
    }
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
        m_beyond[std::size_t(phase)] = float(at - std::floor(at));
    }
    m_blended.resize(std::size_t(m_samples.width() + columnUnit));
}

void ChromaEnlarger::enlargeRow(const cv::Mat1f &samples, int y, int first, int last, float *into)
{
    const int shift = m_format.chromaShiftX, skipped = first >> shift, count = rounded(last - first) >> shift;
    const double at = (m_part.y0 + y - m_format.chromaOffsetY()) / (1 << m_format.chromaShiftY), above = std::floor(at);
    const auto share = float(at - above);
    const float *upper = samples[int(above) - m_samples.y0] + skipped, *lower = samples[int(above) - m_samples.y0 + 1] + skipped;
    float *blended = m_blended.data();
    const int needed = std::min(count + 2, samples.cols - skipped);
    for (int x = 0; x < needed; ++x)
        blended[x] = upper[x] + share * (lower[x] - upper[x]);
    if (shift == 0)
        widenRow<1>(blended, m_first.data(), m_beyond.data(), count, into);
    else if (shift == 1)
        widenRow<2>(blended, m_first.data(), m_beyond.data(), count, into);
    else
        widenRow<4>(blended, m_first.data(), m_beyond.data(), count, into);
}

} // namespace odo
