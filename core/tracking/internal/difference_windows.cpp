// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/difference_windows.h"

#include "core/tracking/internal/bit_mask.h"
#include "core/tracking/internal/fetch_early.h"
#include "core/tracking/internal/wide_vectors.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int windowMargin = 12, nearMargin = 20; // luma pixels around what was found on the lattice

PixelRect grownBy(const PixelRect &rect, int margin, const PixelRect &image)
{
    return PixelRect{rect.x0 - margin, rect.y0 - margin, rect.x1 + margin, rect.y1 + margin}.clipped(image);
}

/// Rectangles that hold those given and do not overlap.
std::vector<PixelRect> merged(const std::vector<PixelRect> &rects)
{
    std::vector<PixelRect> apart;
    for (PixelRect rect : rects) {
        for (std::size_t i = 0; i < apart.size();) {
            if (!apart[i].meets(rect)) {
                ++i;
                continue;
            }
            rect = rect.united(apart[i]);
            apart.erase(apart.begin() + std::ptrdiff_t(i));
            i = 0;
        }
        apart.push_back(rect);
    }
    return apart;
}

/// In each band a window is as wide as what was found in the rows near by.
std::vector<DifferenceWindow::Band> bandsOf(const BitMask &found, const PixelRect &rect)
{
    constexpr int step = DifferenceLattice::step, reach = windowMargin / step;
    const int first = rect.y0 / step, count = (rect.height() + step - 1) / step, width = rect.width();
    const int left = rect.x0 / step, right = std::min(found.width(), (rect.x1 + step - 1) / step);
    std::vector<DifferenceWindow::Band> bands(std::size_t(count), {width, 0, 0, 0});
    for (int row = std::max(0, first); row < std::min(found.height(), first + count); ++row) {
        const int begin = found.nextSet(left, row), end = found.lastSet(right, row) + 1;
        if (begin >= end)
            continue;
        for (int i = std::max(0, row - first - reach); i <= std::min(count - 1, row - first + reach); ++i) {
            DifferenceWindow::Band &band = bands[std::size_t(i)];
            band.begin = std::min(band.begin, std::max(0, begin * step - rect.x0 - windowMargin));
            band.end = std::max(band.end, std::min(width, end * step - rect.x0 + windowMargin));
        }
    }
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const DifferenceWindow::Band &above = bands[i > 0 ? i - 1 : 0],
                                     &below = bands[std::min(i + 1, bands.size() - 1)];
        const int begin = std::max({above.begin, bands[i].begin, below.begin}),
                  end = std::min({above.end, bands[i].end, below.end});
        bands[i].safeBegin = begin > 0 ? begin + DifferenceWindow::safePx : 0;
        bands[i].safeEnd = std::max(bands[i].safeBegin, end < width ? end - DifferenceWindow::safePx : width);
    }
    return bands;
}

} // namespace

std::vector<std::vector<DifferenceWindow>> windowsAround(const BitMask &differences, const PixelRect &image)
{
    // One or two samples are noise; those that are two apart belong together.
    constexpr int step = DifferenceLattice::step;
    const BitMask found = differences.crowded().grown();
    std::vector<PixelRect> windows, wide;
    for (const ConnectedPart &part : connectedParts(found)) {
        const PixelRect cells = boundsOf(part),
                        box{cells.x0 * step, cells.y0 * step, cells.x1 * step, cells.y1 * step};
        windows.push_back(grownBy(box, windowMargin, image));
        wide.push_back(grownBy(box, nearMargin, image));
    }
    windows = merged(windows);
    std::vector<std::vector<DifferenceWindow>> groups;
    for (const PixelRect &around : merged(wide)) {
        groups.emplace_back();
        for (const PixelRect &window : windows)
            if (around.meets(window))
                groups.back().push_back({window, bandsOf(found, window)});
    }
    return groups;
}

namespace {

// of the lattice: the rows of a frame just decoded are far, and too far apart for the processor to expect
// the next
constexpr int rowsAhead = 6;

/// The row of luma pixels on which a row of the lattice lies.
int imageRow(int latticeRow)
{
    return latticeRow * DifferenceLattice::step + DifferenceLattice::step / 2;
}

/// Every stride-th byte of a row from an offset on.
template <int stride, int offset>
void takeEvery(const std::uint8_t *row, int count, std::uint8_t *into)
{
    for (int i = 0; i < count; ++i)
        into[i] = row[stride * i + offset];
}

/// The samples of a row's lattice; shift: of the plane's columns against the luma's.
ODO_WIDE_VECTORS void takeRow(const std::uint8_t *row, int shift, int count, std::uint8_t *into)
{
    static_assert(DifferenceLattice::step == 4);
    if (shift == 0)
        takeEvery<4, 2>(row, count, into);
    else if (shift == 1)
        takeEvery<2, 1>(row, count, into);
    else
        takeEvery<1, 0>(row, count, into);
}

/// By how much one value is above another, 0 where it is not.
std::uint8_t above(std::uint8_t value, std::uint8_t other)
{
    return std::uint8_t(std::max(value, other) - other);
}

std::uint8_t apart(std::uint8_t a, std::uint8_t b)
{
    return std::max(above(a, b), above(b, a));
}

/// Where the difference is a step at all, as bytes of 0 or 1: few are, and only those are compared with the
/// noise.
ODO_WIDE_VECTORS void findSteps(const std::uint8_t *y, const std::uint8_t *u, const std::uint8_t *v,
                                const std::uint8_t *yBehind, const std::uint8_t *uBehind,
                                const std::uint8_t *vBehind, int count, std::uint8_t *__restrict steps)
{
    constexpr auto lumaStep = std::uint8_t(leastLumaStep), chromaStep = std::uint8_t(leastChromaStep);
    for (int i = 0; i < count; ++i) {
        const std::uint8_t mayBeDarker = y[i] < LightGain::mostLuma ? 255 : 0;
        const std::uint8_t lighter = above(above(y[i], yBehind[i]), lumaStep),
                           darker = above(above(yBehind[i], y[i]), lumaStep) & mayBeDarker;
        const std::uint8_t chroma =
            above(std::max(apart(u[i], uBehind[i]), apart(v[i], vBehind[i])), chromaStep);
        steps[i] = std::min(std::uint8_t(lighter | darker | chroma), std::uint8_t(1));
    }
}

} // namespace

DifferenceLattice::DifferenceLattice(const Background &background)
    : m_format(background.format), m_columns(background.y.width / step), m_rows(background.y.height / step)
{
    const int sx = m_format.chromaShiftX, sy = m_format.chromaShiftY;
    const auto takeBoth = [this](const Background::Plane &plane, int shiftX, int shiftY, auto &values,
                                 auto &sigmas) {
        takePlane([&](int y) { return plane.row(y); }, shiftX, shiftY, values);
        takePlane([&](int y) { return plane.sigmaRow(y); }, shiftX, shiftY, sigmas);
    };
    takeBoth(background.y, 0, 0, m_behind.y, m_sigmas.y);
    takeBoth(background.u, sx, sy, m_behind.u, m_sigmas.u);
    takeBoth(background.v, sx, sy, m_behind.v, m_sigmas.v);
}

template <class RowOf>
void DifferenceLattice::takePlane(const RowOf &rowOf, int shiftX, int shiftY,
                                  std::vector<std::uint8_t> &into) const
{
    into.resize(std::size_t(m_columns) * std::size_t(m_rows));
    for (int j = 0; j < m_rows; ++j)
        takeRow(rowOf(imageRow(j) >> shiftY), shiftX, m_columns, into.data() + std::ptrdiff_t(j) * m_columns);
}

void DifferenceLattice::compare(const Frame &frame, const Background &background)
{
    const int sx = m_format.chromaShiftX, sy = m_format.chromaShiftY;
    m_luma.resize(m_behind.y.size());
    for (int j = 0; j < m_rows; ++j) {
        if (j + rowsAhead < m_rows)
            fetchEarly(frame.y.row(imageRow(j + rowsAhead)), frame.y.width);
        takeRow(frame.y.row(imageRow(j)), 0, m_columns, m_luma.data() + std::ptrdiff_t(j) * m_columns);
    }
    // all of it: samples aligned with a codec's blocks give a less exact gain
    const Background::Plane &behind = background.y;
    m_gain = LightGain::between(frame.y, {behind.values.data(), behind.width, behind.height, behind.width},
                                frame.format.fullRange);
    adaptToLight();
    m_differences.reset(m_columns, m_rows);
    for (std::vector<std::uint8_t> *row : {&m_u, &m_v, &m_steps})
        row->resize(std::size_t(m_columns));
    for (int j = 0; j < m_rows; ++j) {
        if (j + rowsAhead < m_rows) {
            fetchEarly(frame.u.row(imageRow(j + rowsAhead) >> sy), frame.u.width);
            fetchEarly(frame.v.row(imageRow(j + rowsAhead) >> sy), frame.v.width);
        }
        takeRow(frame.u.row(imageRow(j) >> sy), sx, m_columns, m_u.data());
        takeRow(frame.v.row(imageRow(j) >> sy), sx, m_columns, m_v.data());
        compareRow(j);
    }
}

void DifferenceLattice::compareRow(int j)
{
    const auto first = std::ptrdiff_t(j) * m_columns;
    findSteps(m_luma.data() + first, m_u.data(), m_v.data(), m_litBehind.data() + first,
              m_behind.u.data() + first, m_behind.v.data() + first, m_columns, m_steps.data());
    m_differences.setRow(j, m_steps.data(), 0, m_columns);
    m_differences.forEachInRow(j, [&](int i) {
        if (!differs(std::size_t(first + i), std::size_t(i)))
            m_differences.clear(i, j);
    });
}

void DifferenceLattice::adaptToLight()
{
    const auto table = m_gain.fromReference();
    if (table == m_litTable && m_litBehind.size() == m_behind.y.size())
        return;
    m_litTable = table;
    m_litBehind.resize(m_behind.y.size());
    for (std::size_t i = 0; i < m_litBehind.size(); ++i)
        m_litBehind[i] = table[m_behind.y[i]];
}

/// Whether a step is larger than the noise. inImage, inRow: the sample's number in the frame and in its
/// row.
bool DifferenceLattice::differs(std::size_t inImage, std::size_t inRow) const
{
    const auto share = [](int difference, int sigmas) {
        return squared(float(difference)) / squared(float(sigmas) * Background::sigmaUnit);
    };
    const int luma = m_luma[inImage], darker = luma - m_litBehind[inImage],
              dy = luma >= LightGain::mostLuma ? std::max(0, darker) : darker;
    const int du = m_u[inRow] - m_behind.u[inImage], dv = m_v[inRow] - m_behind.v[inImage];
    return share(dy, m_sigmas.y[inImage]) + share(du, m_sigmas.u[inImage]) + share(dv, m_sigmas.v[inImage]) >
           differsInSigmas2;
}

namespace {

// of a plane's slope: what coding and a lens that breathes move, samples
constexpr float textureJitter = 0.08F;

std::int16_t inverseOf(float noise2)
{
    return std::int16_t(float(BackgroundNoise::unit) / std::sqrt(noise2));
}

} // namespace

void noise2InRow(const Background::Plane &plane, float factor, int y, int first, int last,
                 float *__restrict into)
{
    const float jitter2 = squared(textureJitter * factor);
    const std::uint8_t *here = plane.row(y), *above = plane.row(std::max(0, y - 1)),
                       *below = plane.row(std::min(plane.height - 1, y + 1)), *sigma = plane.sigmaRow(y);
    const auto at = [=](int x, int left, int right) {
        const int slopeX = here[right] - here[left], slopeY = below[x] - above[x];
        return squared(float(sigma[x]) * Background::sigmaUnit) +
               jitter2 * (squared(float(slopeX)) + squared(float(slopeY)));
    };
    const int begin = std::max(first, 1), end = std::min(last, plane.width - 1);
    if (first < begin)
        into[0] = at(0, 0, std::min(1, end));
    for (int x = begin; x < end; ++x)
        into[x - first] = at(x, x - 1, x + 1);
    if (end < last)
        into[end - first] = at(end, std::max(0, end - 1), end);
}

BackgroundNoise::BackgroundNoise(const Background &background)
    : m_lumaWidth(background.y.width), m_chromaWidth(background.u.width), m_luma(background.y.values.size()),
      m_chroma(background.u.values.size())
{
    static_assert(Background::leastSigma >= 1); // so that all inverses fit
    const auto lumaWidth = std::size_t(m_lumaWidth), chromaWidth = std::size_t(m_chromaWidth);
    std::vector<float> ofLuma(lumaWidth), ofU(chromaWidth), ofV(chromaWidth);
    for (int y = 0; y < background.y.height; ++y) {
        noise2InRow(background.y, 1, y, 0, m_lumaWidth, ofLuma.data());
        std::ranges::transform(ofLuma, m_luma.begin() + std::ptrdiff_t(y) * m_lumaWidth, inverseOf);
    }
    for (int y = 0; y < background.u.height; ++y) {
        noise2InRow(background.u, 1, y, 0, m_chromaWidth, ofU.data());
        noise2InRow(background.v, 1, y, 0, m_chromaWidth, ofV.data());
        std::ranges::transform(ofU, ofV, m_chroma.begin() + std::ptrdiff_t(y) * m_chromaWidth,
                               [](float u2, float v2) { return inverseOf(std::max(u2, v2)); });
    }
}

} // namespace odo
