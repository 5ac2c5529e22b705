// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/compared_window.h"

#include "core/tracking/difference_lattice.h"
#include "core/tracking/difference_test.h"
#include "core/tracking/fetch_early.h"

#include <algorithm>

namespace odo {

namespace {

constexpr int marginPx = 8;        // around what differs: as far as an edge's surroundings are looked at
constexpr int windowRowsAhead = 6; // that are fetched before they are read

/// Samples of a chroma plane about neutral in another light, as far as chroma is coded.
template <class Plane>
void takeChroma(const ChromaEnlarger &enlarger, const Plane &plane, float factor, cv::Mat1s &into)
{
    constexpr int factorUnit = 4096, most = LightGain::neutralChroma * ChromaEnlarger::unit;
    const auto times = std::int16_t(std::lround(factor * factorUnit));
    enlarger.takeSamples(plane.width, plane.height, [&](int y, int first, int last, std::int16_t *__restrict samples) {
        fetchEarly(plane.row(std::min(y + windowRowsAhead, plane.height - 1)) + first, last - first);
        const std::uint8_t *row = plane.row(y) + first;
        for (int x = 0; x < last - first; ++x) {
            const auto shifted = std::int16_t((row[x] - LightGain::neutralChroma) * (ChromaEnlarger::unit * (1 << 16) / factorUnit));
            const auto lit = std::int16_t((shifted * times) >> 16), upTo = std::int16_t(lit < most ? lit : most);
            samples[x] = std::int16_t(upTo > -most ? upTo : -most);
        }
    }, into);
}

} // namespace

ComparedWindow::ComparedWindow(const Background &background) : m_background(background), m_noise(background) {}

void ComparedWindow::compare(const Frame &frame, const LightGain &gain, const DifferenceWindow &part)
{
    m_frame = &frame;
    m_gain = gain;
    compareRows(part);
    placeAround(m_differs.crowded().bounds(), part.rect); // single pixels are noise
}

float ComparedWindow::chromaNoise2(int x, int y) const
{
    const int cx = (m_rect.x0 + x) >> m_background.format.chromaShiftX, cy = (m_rect.y0 + y) >> m_background.format.chromaShiftY;
    return squared(float(std::max(m_background.u.sigmaRow(cy)[cx], m_background.v.sigmaRow(cy)[cx])) * Background::sigmaUnit);
}

void ComparedWindow::compareRows(const DifferenceWindow &part)
{
    ChromaEnlarger enlarger(m_frame->format, part.rect);
    takeChroma(enlarger, m_frame->u, 1, m_uSamples);
    takeChroma(enlarger, m_frame->v, 1, m_vSamples);
    takeChroma(enlarger, m_background.u, m_gain.factor, m_uBehindSamples);
    takeChroma(enlarger, m_background.v, m_gain.factor, m_vBehindSamples);
    const int columns = ChromaEnlarger::room(part.rect.width());
    for (cv::Mat1s *plane : {&m_uPart, &m_vPart, &m_uBehindPart, &m_vBehindPart})
        plane->create(part.rect.height(), columns);
    for (BitMask *mask : {&m_differs, &m_plain, &m_darkened})
        mask->reset(part.rect.width(), part.rect.height());
    for (std::vector<std::uint8_t> *marks : {&m_marks, &m_plainMarks, &m_darkMarks})
        marks->resize(std::size_t(columns));
    m_chromaInverse.resize(std::size_t(columns));
    for (int y = 0; y < part.rect.height(); ++y)
        compareRow(part, y, enlarger);
}

/// Of a row of pixels: that of the sample which each lies in.
void ComparedWindow::readChromaInverse(int x0, int width, int y)
{
    const int shift = m_background.format.chromaShiftX, perSample = 1 << shift, samples = (width + perSample - 1) >> shift;
    const std::int16_t *row = m_noise.chromaRow(y >> m_background.format.chromaShiftY) + (x0 >> shift);
    std::int16_t *__restrict into = m_chromaInverse.data();
    if (perSample == 2) { // nearly always
        for (int k = 0; k < samples; ++k)
            into[2 * k] = into[2 * k + 1] = row[k];
    } else {
        for (int k = 0; k < samples; ++k)
            std::fill_n(into + std::ptrdiff_t(k) * perSample, perSample, row[k]);
    }
}

void ComparedWindow::compareRow(const DifferenceWindow &part, int y, ChromaEnlarger &enlarger)
{
    const DifferenceWindow::Band &band = part.bands[std::size_t(y / DifferenceLattice::step)];
    if (band.begin >= band.end)
        return;
    const int x0 = part.rect.x0 + band.begin, width = band.end - band.begin, pictureY = part.rect.y0 + y, ahead = std::min(pictureY + windowRowsAhead, part.rect.y1 - 1);
    fetchEarly(m_frame->y.row(ahead) + x0, width);
    fetchEarly(m_background.y.row(ahead) + x0, width);
    fetchEarly(reinterpret_cast<const std::uint8_t *>(m_noise.lumaRow(ahead) + x0), 2 * width);
    const auto enlarge = [&](const cv::Mat1s &samples, cv::Mat1s &plane) {
        std::int16_t *row = plane[y] + band.begin;
        enlarger.enlargeRow(samples, y, band.begin, band.end, row);
        return row;
    };
    readChromaInverse(x0, width, pictureY);
    const ComparedRow row{width, m_gain, m_background.darkestShadow, m_frame->y.row(pictureY) + x0, m_background.y.row(pictureY) + x0, enlarge(m_uSamples, m_uPart), enlarge(m_vSamples, m_vPart),
                          enlarge(m_uBehindSamples, m_uBehindPart), enlarge(m_vBehindSamples, m_vBehindPart), m_noise.lumaRow(pictureY) + x0, m_chromaInverse.data()};
    row.markDifferences(m_marks.data(), m_plainMarks.data());
    m_differs.setRow(y, m_marks.data() + band.safeBegin - band.begin, band.safeBegin, band.safeEnd);
    const int first = m_differs.nextSet(0, y), last = m_differs.lastSet(m_differs.width(), y);
    if (last < 0)
        return;
    row.markDarkened(first - band.begin, last + 1 - band.begin, m_darkMarks.data());
    m_plain.setRow(y, m_plainMarks.data() + first - band.begin, first, last + 1);
    m_darkened.setRow(y, m_darkMarks.data() + first - band.begin, first, last + 1);
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
