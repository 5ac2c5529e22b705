// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/compared_window.h"

#include "core/tracking/internal/difference_windows.h"
#include "core/tracking/internal/fetch_early.h"
#include "core/tracking/internal/wide_vectors.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace odo {

namespace {

// between samples: their positions are multiples of an eighth in every format
constexpr int partBits = 3, parts = 1 << partBits;

std::int16_t between(std::int16_t value, std::int16_t next, std::int16_t beyond)
{
    return std::int16_t(value + (std::int16_t((next - value) * beyond) >> partBits));
}

/// `perSample` luma columns for each sample of a row.
template <int perSample, int block>
void widenRow(const std::int16_t *row, const int *first, const int *beyond, int samples,
              std::int16_t *__restrict into)
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

ChromaEnlarger::ChromaEnlarger(const FrameFormat &format, const PixelRect &part)
    : m_format(format), m_part(part)
{
    assert(part.x0 % columnUnit == 0);
    const auto before = [](int pixel, double offset, int shift) {
        return int(std::floor((pixel - offset) / (1 << shift)));
    };
    const int sx = format.chromaShiftX, sy = format.chromaShiftY;
    const double offsetX = format.chromaOffsetX(), offsetY = format.chromaOffsetY();
    m_samples = {before(part.x0, offsetX, sx), before(part.y0, offsetY, sy),
                 before(part.x1 - 1, offsetX, sx) + 2, before(part.y1 - 1, offsetY, sy) + 2};
    for (int phase = 0; phase < (1 << sx); ++phase) {
        const double at = (part.x0 + phase - offsetX) / (1 << sx);
        m_first[std::size_t(phase)] = int(std::floor(at)) - m_samples.x0;
        m_beyond[std::size_t(phase)] = int(parts * (at - std::floor(at)));
    }
    m_blended.resize(std::size_t(m_samples.width() + 2 * atOnce));
}

ODO_WIDE_VECTORS void ChromaEnlarger::enlargeRow(const cv::Mat1s &samples, int y, int first, int last,
                                                 std::int16_t *into)
{
    const int shift = m_format.chromaShiftX, skipped = first >> shift,
              count = (last - first + atOnce - 1) / atOnce * atOnce >> shift;
    const double at = (m_part.y0 + y - m_format.chromaOffsetY()) / (1 << m_format.chromaShiftY),
                 above = std::floor(at);
    const auto beyond = std::int16_t(parts * (at - above));
    const std::int16_t *upper = samples[int(above) - m_samples.y0] + skipped,
                       *lower = samples[int(above) - m_samples.y0 + 1] + skipped;
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

namespace {

constexpr float plainSteps = 6;   // of the least step: half of black on grey
constexpr float lightest = 0.99F; // of the floor in shadow against the floor in light
// code values above black: on a darker one a shadow is not seen
constexpr float darkestFloor = 12;

// Fixed-point numbers of 16 bits, of which compilers do eight at once. Luma is in units of 1 / lumaUnit,
// shares of the noise of 1 / shareUnit.
using Fixed = std::int16_t;
constexpr int lumaUnit = 8, chromaUnit = ChromaEnlarger::unit, shareUnit = 32;
constexpr Fixed mostLumaStep = 255 * lumaUnit, mostChromaStep = 255 * chromaUnit;
constexpr Fixed mostShare = 144; // beyond the usual variation; three squares of it fit in 16 bits
static_assert(mostShare * mostShare > shareUnit * shareUnit * differsInSigmas2 &&
              3 * mostShare * mostShare < (1 << 16));

// By value, other than std::min and std::max: so compilers know them.
Fixed lesser(Fixed a, Fixed b)
{
    return a < b ? a : b;
}

Fixed greater(Fixed a, Fixed b)
{
    return a > b ? a : b;
}

Fixed size(Fixed value)
{
    return greater(value, Fixed(-value));
}

/// The upper half of a product.
Fixed upper(Fixed a, Fixed b)
{
    return Fixed((int(a) * int(b)) >> 16);
}

std::uint16_t square(Fixed value)
{
    return std::uint16_t(std::uint16_t(value) * std::uint16_t(value));
}

// lost luma is enlarged by so much, for a tint is less than one
constexpr int lostUnits = 16;
static_assert(lostUnits * mostLumaStep < (1 << 15));

/// By which `upper` makes an offset of chroma of lost luma in lostUnits.
Fixed fixedTint(float tint)
{
    constexpr float ofTint = float(chromaUnit) / float(lumaUnit * lostUnits) * (1 << 16);
    return Fixed(std::lround(std::clamp(tint, 0.0F, 1.0F) * ofTint));
}

constexpr int halfUnit = 1 << 15, quarterUnit = 1 << 14; // by which `upper` takes a half and a quarter

/// Steps in units of the noise.
Fixed lumaShare(Fixed step, Fixed inverse)
{
    constexpr int enlarged = 16;
    static_assert(lumaUnit * enlarged * BackgroundNoise::unit == shareUnit << 16);
    return upper(Fixed(step * enlarged), inverse);
}

Fixed chromaShare(Fixed step, Fixed inverse)
{
    constexpr int enlarged = 8;
    static_assert(chromaUnit * enlarged * BackgroundNoise::unit == shareUnit << 16);
    return upper(Fixed(step * enlarged), inverse);
}

/// Luma above black, as seen and of the background in the frame's light.
class LumaPair
{
public:
    explicit LumaPair(const ComparedRow &row)
        : m_now(row.now), m_behind(row.behind), m_black(Fixed(row.gain.black)),
          m_factor(Fixed(std::lround(row.gain.factor * factorUnit)))
    {
    }
    bool isBright(int x) const { return m_now[x] >= LightGain::mostLuma; }
    Fixed seen(int x) const { return Fixed(Fixed(m_now[x] - m_black) * lumaUnit); }
    Fixed floor(int x) const
    {
        return upper(Fixed(Fixed(m_behind[x] - m_black) * (lumaUnit * (1 << 16) / factorUnit)), m_factor);
    }

private:
    static constexpr int factorUnit = 4096;
    const std::uint8_t *m_now, *m_behind;
    Fixed m_black, m_factor;
};

struct ChromaPair
{
    const Fixed *seen, *behind;

    Fixed step(int x) const { return lesser(size(Fixed(seen[x] - behind[x])), mostChromaStep); }
};

/// Does something for so many columns and perhaps a few beside them, in blocks, the last of which overlaps
/// the one before: so no columns remain that are done singly.
template <class Function>
void forBlocks(int first, int last, int width, const Function &function)
{
    constexpr int block = ComparedRow::leastWidth;
    for (int begin = first; begin < last; begin += block)
        for (int i = 0; i < block; ++i)
            function(std::min(begin, width - block) + i);
}

} // namespace

ODO_WIDE_VECTORS void ComparedRow::markDifferences(std::uint8_t *__restrict differs,
                                                   std::uint8_t *__restrict plain) const
{
    constexpr auto least = std::uint16_t(differsInSigmas2 * shareUnit * shareUnit);
    constexpr auto lumaStep = Fixed(leastLumaStep * lumaUnit),
                   chromaStep = Fixed(leastChromaStep * chromaUnit);
    constexpr auto plainLuma = Fixed(plainSteps * lumaStep), plainChroma = Fixed(plainSteps * chromaStep);
    // the noise grows with the light
    const auto perNoise = Fixed(std::lround(32767 / std::max(1.0F, gain.factor)));
    const LumaPair lumas(*this);
    const ChromaPair us{u, uBehind}, vs{v, vBehind};
    const Fixed *perLuma = lumaInverse, *perChroma = chromaInverse;
    forBlocks(0, width, width, [=](int x) {
        // it may be as light as expected
        const Fixed lighter = Fixed(lumas.seen(x) - lumas.floor(x)),
                    step = lumas.isBright(x) ? greater(lighter, 0) : lighter;
        const Fixed stepY = lesser(size(step), mostLumaStep), stepU = us.step(x), stepV = vs.step(x),
                    chroma = greater(stepU, stepV);
        const Fixed shareY = lesser(upper(Fixed(lumaShare(stepY, perLuma[x]) * 2), perNoise), mostShare);
        const Fixed shareU = lesser(chromaShare(stepU, perChroma[x]), mostShare),
                    shareV = lesser(chromaShare(stepV, perChroma[x]), mostShare);
        const bool isBeyondNoise = std::uint16_t(square(shareY) + square(shareU) + square(shareV)) > least;
        differs[x] = isBeyondNoise & ((stepY > lumaStep) | (chroma > chromaStep));
        plain[x] = isBeyondNoise & ((stepY > plainLuma) | (chroma > plainChroma));
    });
}

ODO_WIDE_VECTORS void ComparedRow::markDarkened(int first, int last, std::uint8_t *__restrict darkened) const
{
    constexpr auto leastFloor = Fixed(darkestFloor * lumaUnit), mostLight = Fixed(lightest * halfUnit);
    constexpr auto tolerance = Fixed(1.5F * chromaUnit), ofHue = Fixed(0.1F * 2 * halfUnit),
                   mostNoise = Fixed(3 * shareUnit);
    const auto leastShare = Fixed(std::lround(shadow.darkest * halfUnit)), tint = fixedTint(shadow.tint);
    const LumaPair lumas(*this);
    const ChromaPair us{u, uBehind}, vs{v, vBehind};
    const Fixed *perChroma = chromaInverse;
    forBlocks(first, last, width, [=](int x) {
        const Fixed luma = lumas.seen(x), floor = lumas.floor(x), twice = Fixed(2 * floor);
        const bool isBetween =
            (floor > leastFloor) & (luma > upper(twice, leastShare)) & (luma < upper(twice, mostLight));
        const auto ratio = Fixed(int(quarterUnit * float(lesser(luma, floor)) / float(greater(floor, 1))));
        const auto lost = Fixed(lostUnits * Fixed(floor - luma));
        const auto isAlike = [=](const ChromaPair &pair) {
            const Fixed expected = upper(Fixed(4 * pair.behind[x]), ratio),
                        off = lesser(size(Fixed(pair.seen[x] - expected)), mostChromaStep);
            const auto beyond =
                Fixed(off - tolerance - upper(size(pair.behind[x]), ofHue) - upper(lost, tint));
            return chromaShare(beyond, perChroma[x]) < mostNoise;
        };
        darkened[x] = isBetween & isAlike(us) & isAlike(vs);
    });
}

namespace {

constexpr int marginPx = 8;        // around the foreground: as far as the surroundings of an edge are read
constexpr int windowRowsAhead = 6; // that are fetched before they are read

/// Samples of a chroma plane about neutral in another light, as far as chroma is coded.
template <class Plane>
void takeChroma(const ChromaEnlarger &enlarger, const Plane &plane, float factor, cv::Mat1s &into)
{
    constexpr int factorUnit = 4096, most = LightGain::neutralChroma * ChromaEnlarger::unit;
    const auto times = std::int16_t(std::lround(factor * factorUnit));
    enlarger.takeSamples(
        plane.width, plane.height,
        [&](int y, int first, int last, std::int16_t *__restrict samples) {
            fetchEarly(plane.row(std::min(y + windowRowsAhead, plane.height - 1)) + first, last - first);
            const std::uint8_t *row = plane.row(y) + first;
            for (int x = 0; x < last - first; ++x) {
                const auto shifted = std::int16_t((row[x] - LightGain::neutralChroma) *
                                                  (ChromaEnlarger::unit * (1 << 16) / factorUnit));
                const auto lit = std::int16_t((shifted * times) >> 16),
                           upTo = std::int16_t(lit < most ? lit : most);
                samples[x] = std::int16_t(upTo > -most ? upTo : -most);
            }
        },
        into);
}

} // namespace

ComparedWindow::ComparedWindow(const Background &background) : m_background(background), m_noise(background)
{
}

void ComparedWindow::compare(const Frame &frame, const LightGain &gain, const DifferenceWindow &part)
{
    m_frame = &frame;
    m_gain = gain;
    compareRows(part);
    if (m_searched)
        m_differs &= m_searched->cropped(part.rect);
    positionAround(m_differs.crowded().bounds(), part.rect); // single pixels are noise
}

/// Of the noisier plane, at the sample that each pixel lies in.
void ComparedWindow::readChromaNoise2(int y, int first, int last, float *__restrict into) const
{
    constexpr int block = 64;
    std::array<float, block> ofU{}, ofV{};
    const int shift = m_background.format.chromaShiftX,
              row = (m_rect.y0 + y) >> m_background.format.chromaShiftY;
    for (int begin = first; begin < last; begin += block) {
        const int x0 = m_rect.x0 + begin, x1 = m_rect.x0 + std::min(last, begin + block),
                  sample = x0 >> shift, end = ((x1 - 1) >> shift) + 1;
        noise2InRow(m_background.u, m_gain.factor, row, sample, end, ofU.data());
        noise2InRow(m_background.v, m_gain.factor, row, sample, end, ofV.data());
        for (int x = x0; x < x1; ++x) {
            const auto i = std::size_t((x >> shift) - sample);
            into[x - m_rect.x0 - first] = std::max(ofU[i], ofV[i]);
        }
    }
}

void ComparedWindow::fetchNoise(int y, int first, int last) const
{
    const int shift = m_background.format.chromaShiftX,
              row = (m_rect.y0 + y) >> m_background.format.chromaShiftY;
    fetchEarly(m_background.y.sigmaRow(m_rect.y0 + y) + m_rect.x0 + first, last - first);
    for (const Background::Plane *plane : {&m_background.u, &m_background.v})
        fetchEarly(plane->sigmaRow(row) + ((m_rect.x0 + first) >> shift), ((last - first) >> shift) + 1);
}

void ComparedWindow::compareRows(const DifferenceWindow &part)
{
    ChromaEnlarger enlarger(m_frame->format, part.rect);
    takeChroma(enlarger, m_frame->u, 1, m_uSamples);
    takeChroma(enlarger, m_frame->v, 1, m_vSamples);
    takeChroma(enlarger, m_background.u, m_gain.factor, m_uBehindSamples);
    takeChroma(enlarger, m_background.v, m_gain.factor, m_vBehindSamples);
    const int columns = ChromaEnlarger::paddedColumns(part.rect.width());
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

/// Of a row of pixels in a row of samples: that of the sample which each lies in.
void ComparedWindow::readChromaInverse(int x0, int width, int chromaY)
{
    const int shift = m_background.format.chromaShiftX, perSample = 1 << shift,
              samples = (width + perSample - 1) >> shift;
    const std::int16_t *row = m_noise.chromaRow(chromaY) + (x0 >> shift);
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
    const int x0 = part.rect.x0 + band.begin, width = band.end - band.begin, imageY = part.rect.y0 + y,
              ahead = std::min(imageY + windowRowsAhead, part.rect.y1 - 1);
    fetchEarly(m_frame->y.row(ahead) + x0, width);
    fetchEarly(m_background.y.row(ahead) + x0, width);
    const auto fetchShorts = [](const std::int16_t *values, int count) {
        fetchEarly(reinterpret_cast<const std::uint8_t *>(values), 2 * count);
    };
    const int shiftX = m_background.format.chromaShiftX, shiftY = m_background.format.chromaShiftY;
    fetchShorts(m_noise.lumaRow(ahead) + x0, width);
    fetchShorts(m_noise.chromaRow(ahead >> shiftY) + (x0 >> shiftX), width >> shiftX);
    const auto enlarge = [&](const cv::Mat1s &samples, cv::Mat1s &plane) {
        std::int16_t *row = plane[y] + band.begin;
        enlarger.enlargeRow(samples, y, band.begin, band.end, row);
        return row;
    };
    if (y % DifferenceLattice::step == 0 || imageY >> shiftY != (imageY - 1) >> shiftY)
        readChromaInverse(x0, width, imageY >> shiftY); // otherwise it is as in the row before
    const ComparedRow row{width,
                          m_gain,
                          m_background.shadow,
                          m_frame->y.row(imageY) + x0,
                          m_background.y.row(imageY) + x0,
                          enlarge(m_uSamples, m_uPart),
                          enlarge(m_vSamples, m_vPart),
                          enlarge(m_uBehindSamples, m_uBehindPart),
                          enlarge(m_vBehindSamples, m_vBehindPart),
                          m_noise.lumaRow(imageY) + x0,
                          m_chromaInverse.data()};
    row.markDifferences(m_marks.data(), m_plainMarks.data());
    m_differs.setRow(y, m_marks.data() + band.safeBegin - band.begin, band.safeBegin, band.safeEnd);
    const int first = m_differs.nextSet(0, y), last = m_differs.lastSet(m_differs.width(), y);
    if (last < 0)
        return;
    row.markDarkened(first - band.begin, last + 1 - band.begin, m_darkMarks.data());
    m_plain.setRow(y, m_plainMarks.data() + first - band.begin, first, last + 1);
    m_darkened.setRow(y, m_darkMarks.data() + first - band.begin, first, last + 1);
}

/// Makes the window of the foreground in the part.
void ComparedWindow::positionAround(const PixelRect &found, const PixelRect &part)
{
    const PixelRect within = found.isEmpty() ? PixelRect()
                                             : PixelRect{found.x0 - marginPx, found.y0 - marginPx,
                                                         found.x1 + marginPx, found.y1 + marginPx}
                                                   .clipped({0, 0, part.width(), part.height()});
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
