// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/compared_window.h"

#include "core/tracking/difference_lattice.h"
#include "core/tracking/difference_test.h"
#include "core/tracking/fetch_early.h"

#include <algorithm>

namespace odo {

namespace {

constexpr int marginPx = 8; // around what differs: as far as an edge's surroundings are looked at

/// Samples of a chroma plane about neutral, times a factor.
template <class Plane>
void takeChroma(const ChromaEnlarger &enlarger, const Plane &plane, float factor, cv::Mat1f &into)
{
    constexpr int rowsAhead = 4; // that are fetched before they are read
    enlarger.takeSamples(plane.width, plane.height, [&](int y, int first, int last, float *values) {
        fetchEarly(plane.row(std::min(y + rowsAhead, plane.height - 1)) + first, last - first);
        const std::uint8_t *row = plane.row(y);
        for (int x = first; x < last; ++x)
            values[x - first] = factor * float(row[x] - LightGain::neutralChroma);
    }, into);
}

void keepRow(const std::vector<float> &values, std::int16_t *__restrict into)
{
    constexpr float roundingOffset = 32768.5F; // so that casting rounds values of both signs
    const float *from = values.data();
    for (std::size_t x = 0; x < values.size(); ++x)
        into[x] = std::int16_t(std::int32_t(from[x] * ComparedWindow::chromaUnit + roundingOffset) - std::int32_t(roundingOffset));
}

} // namespace

void ComparedWindow::compare(const Frame &frame, const Background &background, const LightGain &gain, const DifferenceWindow &part)
{
    m_frame = &frame;
    m_background = &background;
    m_gain = gain;
    compareRows(part);
    placeAround(m_differs.crowded().bounds(), part.rect); // single pixels are noise
}

float ComparedWindow::chromaNoise2(int x, int y) const
{
    const int cx = (m_rect.x0 + x) >> m_background->format.chromaShiftX, cy = (m_rect.y0 + y) >> m_background->format.chromaShiftY;
    return squared(float(std::max(m_background->u.sigmaRow(cy)[cx], m_background->v.sigmaRow(cy)[cx])) * Background::sigmaUnit);
}

void ComparedWindow::compareRows(const DifferenceWindow &part)
{
    ChromaEnlarger enlarger(m_frame->format, part.rect);
    takeChroma(enlarger, m_frame->u, 1, m_uSamples);
    takeChroma(enlarger, m_frame->v, 1, m_vSamples);
    takeChroma(enlarger, m_background->u, m_gain.factor, m_uBehindSamples);
    takeChroma(enlarger, m_background->v, m_gain.factor, m_vBehindSamples);
    const int columns = ChromaEnlarger::rounded(part.rect.width());
    for (cv::Mat1s *plane : {&m_uPart, &m_vPart, &m_uBehindPart, &m_vBehindPart})
        plane->create(part.rect.height(), columns);
    for (BitMask *mask : {&m_differs, &m_plain, &m_darkened})
        mask->reset(part.rect.width(), part.rect.height());
    for (std::vector<std::uint8_t> *marks : {&m_marks, &m_plainMarks, &m_darkMarks})
        marks->resize(std::size_t(columns));
    for (int y = 0; y < part.rect.height(); ++y)
        compareRow(part, y, enlarger);
}

void ComparedWindow::compareRow(const DifferenceWindow &part, int y, ChromaEnlarger &enlarger)
{
    const DifferenceWindow::Band &band = part.bands[std::size_t(y / DifferenceLattice::step)];
    if (band.begin >= band.end)
        return;
    const PixelRect columns{part.rect.x0 + band.begin, part.rect.y0, part.rect.x0 + band.end, part.rect.y1};
    m_row.begin(*m_frame, *m_background, m_gain, columns, part.rect.y0 + y);
    const auto enlarge = [&](const cv::Mat1f &samples, std::vector<float> &row, cv::Mat1s &plane) {
        enlarger.enlargeRow(samples, y, band.begin, band.end, row.data());
        keepRow(row, plane[y] + band.begin);
    };
    enlarge(m_uSamples, m_row.u, m_uPart);
    enlarge(m_vSamples, m_row.v, m_vPart);
    enlarge(m_uBehindSamples, m_row.uBehind, m_uBehindPart);
    enlarge(m_vBehindSamples, m_row.vBehind, m_vBehindPart);
    m_row.markDifferences(m_marks.data(), m_plainMarks.data());
    m_differs.setRow(y, m_marks.data() + band.safeBegin - band.begin, band.safeBegin, band.safeEnd);
    const int first = m_differs.nextSet(0, y), last = m_differs.lastSet(m_differs.width(), y);
    if (last < 0)
        return;
    m_row.markDarkened(first - band.begin, last + 1 - band.begin, m_darkMarks.data());
    m_plain.setRow(y, m_plainMarks.data() + first - band.begin, first, last + 1);
    m_darkened.setRow(y, m_darkMarks.data(), first, last + 1);
}

/// Makes the window of what differs in the part.
void ComparedWindow::placeAround(const PixelRect &found, const PixelRect &part)
{
    const PixelRect within = found.isEmpty() ? PixelRect() : PixelRect{found.x0 - marginPx, found.y0 - marginPx, found.x1 + marginPx, found.y1 + marginPx}.clipped({0, 0, part.width(), part.height()});
    m_rect = {part.x0 + within.x0, part.y0 + within.y0, part.x0 + within.x1, part.y0 + within.y1};
    m_differs = m_differs.cropped(within);
    m_plain = m_plain.cropped(within);
    m_darkened = m_darkened.cropped(within) &= m_differs;
    const cv::Rect window(within.x0, within.y0, within.width(), within.height());
    m_u = m_uPart(window);
    m_v = m_vPart(window);
    m_uBehind = m_uBehindPart(window);
    m_vBehind = m_vBehindPart(window);
}

} // namespace odo
