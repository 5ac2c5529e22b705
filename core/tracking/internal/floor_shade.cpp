// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/floor_shade.h"

#include "core/tracking/chroma.h"
#include "core/tracking/internal/difference_windows.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace odo {

namespace {

constexpr int patchReach = 3; // of the patches that are judged, pixels to each side
constexpr int patchRows = 2 * patchReach + 1, patchPixels = patchRows * patchRows;
constexpr int leastPatch = 16;     // pixels
constexpr int flatness = 4;        // the variance of the texture behind against that of what is seen
constexpr double clearTexture = 6; // its variance against the noise's
// code values, of a patch's mean chroma against that of the floor in shadow
constexpr float otherHue = 2.2F;
constexpr double codedChroma = 0.05; // of the chroma's variation about a pixel: by which a codec errs
constexpr double mostMirrored = 0.2; // of a floor's luma: what it mirrors of the room
constexpr float logUnit = 1024;      // of the fixed-point sums: finer than the steps of code values
constexpr int hueUnit = 256;
constexpr std::int64_t ratioUnit = 1 << 30,
                       ratioPerHue = ratioUnit * int(ComparedWindow::chromaUnit) / hueUnit;

// A log sum holds three sums in one number: of the logarithms of luma above black in units of 1 / logUnit
// (the upper bits), of the pixels (6 bits), and of the squares of the logarithms (the lower 32 bits). A patch
// is too small for one to run into the next.
constexpr int pixelsShift = 32, logShift = 38;
static_assert(patchPixels < 1 << (logShift - pixelsShift));

/// The log sum of one pixel, for each luma above black.
std::array<std::uint64_t, 256> makeLogSums()
{
    std::array<std::uint64_t, 256> sums{};
    for (std::size_t i = 1; i < sums.size(); ++i) {
        const auto log = std::uint64_t(std::lround(logUnit * std::log(float(i))));
        sums[i] = (log << logShift) + (std::uint64_t(1) << pixelsShift) + log * log;
    }
    return sums;
}

std::size_t pixelsIn(std::uint64_t logSum)
{
    return (logSum >> pixelsShift) % (1U << (logShift - pixelsShift));
}

/// n² times the variance of n logarithms.
std::int64_t scaledVariance(std::size_t n, std::uint64_t logSum)
{
    const auto sum = std::int64_t(logSum >> logShift), squares = std::int64_t(std::uint32_t(logSum));
    return std::int64_t(n) * squares - sum * sum;
}

/// By how much the summed chroma of n pixels of the floor's own hue may be off.
constexpr auto mostOff = [] {
    std::array<std::int64_t, patchPixels + 1> most{};
    for (std::size_t n = 0; n < most.size(); ++n)
        most[n] = std::int64_t(otherHue * float(hueUnit) * float(n));
    return most;
}();

/// How much the background's chroma varies about a pixel, as far as its patch reaches.
float chromaTexture(const ComparedWindow &window, int x, int y)
{
    const PixelColour here = window.behind(x, y);
    float most = 0;
    for (const int cy : {std::max(0, y - patchReach), std::min(window.height() - 1, y + patchReach)}) {
        for (const int cx : {std::max(0, x - patchReach), std::min(window.width() - 1, x + patchReach)}) {
            const PixelColour corner = window.behind(cx, cy);
            most = std::max({most, std::abs(corner.u - here.u), std::abs(corner.v - here.v)});
        }
    }
    return most;
}

/// Whether the summed chroma of n pixels is off that of the floor in shadow by more than its own, than
/// shadows are tinted, and than a codec errs where the floor's chroma varies. A glossy floor mirrors neutral
/// light of the room; where a dark robot is mirrored instead, that is missing, and the floor's hue is purer
/// than in shadow.
bool isOtherHue(const ComparedWindow &window, std::size_t n, std::int64_t offU, std::int64_t offV, int x,
                int y)
{
    if (std::max(std::abs(offU), std::abs(offV)) <= mostOff[n])
        return false;
    const PixelColour seen = window.seen(x, y), behind = window.behind(x, y);
    const Chroma off{double(offU), double(offV)}, hue = hueUnit * double(n) * Chroma(behind.u, behind.v);
    const double darker = 1 - double(seen.luma) / std::max(1.0, double(behind.luma)),
                 purer = std::clamp(off.dot(hue) / std::max(1.0, hue.squaredNorm()), 0.0,
                                    std::clamp(darker, 0.0, mostMirrored));
    const double tint = window.shadow().tint * std::max(0.0, double(behind.luma) - double(seen.luma)),
                 coded = codedChroma * double(chromaTexture(window, x, y));
    return (off - purer * hue).cwiseAbs().maxCoeff() >
           double(mostOff[n]) + hueUnit * double(n) * (tint + coded);
}

} // namespace

void FloorShade::Sums::add(const Sums &other)
{
    seen += other.seen;
    behind += other.behind;
    offU += other.offU;
    offV += other.offV;
}

void FloorShade::Sums::remove(const Sums &other)
{
    seen -= other.seen;
    behind -= other.behind;
    offU -= other.offU;
    offV -= other.offV;
}

void FloorShade::find(const ComparedWindow &window)
{
    m_shade = window.darkened();
    m_byHue.reset(m_shade.width(), m_shade.height());
    readGain(window.gain());
    m_columns.assign(std::size_t(m_shade.width() + 2 * patchReach), {});
    m_rows.resize(patchRows);
    for (std::vector<Sums> &row : m_rows)
        row.resize(std::size_t(m_shade.width()));
    const PixelRect box = m_shade.bounds();
    for (int y = box.y0; y < box.y1 + patchReach; ++y) {
        if (y - patchRows >= box.y0)
            removeRow(window, y - patchRows); // the one above the patch of the row judged now
        if (y < box.y1)
            takeRow(window, y);
        if (y - patchReach >= box.y0)
            judgeRow(window, y - patchReach);
    }
}

/// Divides once for each luma instead of for each pixel.
void FloorShade::readGain(const LightGain &gain)
{
    for (int i = 0; i < int(m_perLuma.size()); ++i)
        m_perLuma[std::size_t(i)] = std::int32_t(float(ratioUnit) / std::max(1.0F, gain.factor * float(i)));
}

std::vector<FloorShade::Sums> &FloorShade::rowAt(int y)
{
    return m_rows[std::size_t(y) % patchRows];
}

void FloorShade::removeRow(const ComparedWindow &window, int y)
{
    const Sums *sums = rowAt(y).data();
    Sums *columns = m_columns.data() + patchReach;
    window.darkened().forEachInRow(y, [&](int x) { columns[x].remove(sums[x]); });
}

/// Adds a row to the columns. Floor in shadow has the chroma of the background times the ratio of luma as
/// seen to that of the background.
void FloorShade::takeRow(const ComparedWindow &window, int y)
{
    static const std::array<std::uint64_t, 256> logSums = makeLogSums();
    const auto black = std::size_t(window.gain().black);
    const std::uint8_t *luma = window.lumaRow(y), *lumaBehind = window.lumaBehindRow(y);
    const std::int16_t *u = window.uRow(y), *v = window.vRow(y), *uBehind = window.uBehindRow(y),
                       *vBehind = window.vBehindRow(y);
    const auto off = [](std::int64_t seen, std::int64_t behind, std::int64_t ratio) {
        return (ratioUnit * seen - ratio * behind) / ratioPerHue;
    };
    Sums *sums = rowAt(y).data(), *columns = m_columns.data() + patchReach;
    window.darkened().forEachInRow(y, [&](int x) {
        // both above 0; the gain would add to all logarithms, and to no variance
        const std::size_t now = luma[x] - black, before = lumaBehind[x] - black;
        const std::int64_t ratio = std::int64_t(now) * m_perLuma[before]; // of luma
        sums[x] = {logSums[now], logSums[before], off(u[x], uBehind[x], ratio), off(v[x], vBehind[x], ratio)};
        columns[x].add(sums[x]);
    });
}

/// Takes from the shade what the patch around it shows to be none.
void FloorShade::judgeRow(const ComparedWindow &window, int y)
{
    Sums sums;
    int next = -1; // the pixel whose patch the sums hold, save for its last column
    window.darkened().forEachInRow(y, [&](int x) {
        const Sums *patch = m_columns.data() + x; // its first column
        if (x != next) {
            sums = {};
            for (int i = 0; i < patchRows - 1; ++i)
                sums.add(patch[i]);
        }
        sums.add(patch[patchRows - 1]);
        judge(window, sums, x, y);
        sums.remove(patch[0]);
        next = x + 1;
    });
}

/// Compares the variances of the logarithms, which a shadow's factor leaves as they are.
inline void FloorShade::judge(const ComparedWindow &window, const Sums &sums, int x, int y)
{
    const std::size_t n = pixelsIn(sums.seen);
    if (n < leastPatch)
        return;
    if (isOtherHue(window, n, sums.offU, sums.offV, x, y)) {
        m_byHue.set(x, y);
        m_shade.clear(x, y);
        return;
    }
    const std::int64_t varianceBehind = scaledVariance(n, sums.behind);
    if (flatness * scaledVariance(n, sums.seen) >= varianceBehind)
        return;
    const float luma = std::max(1.0F, window.seen(x, y).luma);
    if (double(varianceBehind) * double(squared(luma)) >
        clearTexture * double(n * n) * double(squared(logUnit) * window.lumaNoise2(x, y)))
        m_shade.clear(x, y);
}

} // namespace odo
