// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/light_meter.h"

#include "core/tracking/internal/fetch_early.h"

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
    const int step = std::max(
        1, static_cast<int>(std::sqrt(double(part.width()) * double(part.height()) / wantedSamples)));
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

namespace {

constexpr double comparedSamples = 2000;
constexpr int codedBlack = 16, leastLuma = 24; // darker is noise
constexpr float leastFactor = 0.2F, mostFactor = 5;
constexpr int fewestRatios = 50;

/// Ratios of two lumas, sorted into narrow bins.
class RatioHistogram
{
public:
    void add(float ratio)
    {
        const int bin = std::min(int(m_bins.size()) - 1, int(ratio * binsPerOne));
        m_bins[std::size_t(bin)] += one + Bin(int(ratio * ratioUnit));
        ++m_count;
    }
    int count() const { return m_count; }
    /// Of a bin that lies across a quartile, a share at the bin's mean.
    float meanOfMiddleHalf() const
    {
        const int first = m_count / 4, last = m_count - first;
        double sum = 0;
        int before = 0;
        for (const Bin bin : m_bins) {
            const int inBin = int(bin / one),
                      taken = std::min(last, before + inBin) - std::max(first, before);
            if (taken > 0)
                sum += double(bin % one) / ratioUnit * taken / inBin;
            before += inBin;
            if (before >= last)
                break;
        }
        return float(sum / (last - first));
    }

private:
    /// how many, in units of `one`, and below that the sum of their ratios: both by one addition
    using Bin = std::uint64_t;
    static constexpr Bin one = Bin(1) << 40;
    static constexpr float ratioUnit = 65536, binsPerOne = 256, mostRatio = 10; ///< 235 by 24
    std::array<Bin, std::size_t(binsPerOne *mostRatio)> m_bins{};
    int m_count = 0;
};

} // namespace

LightGain LightGain::between(const PlaneView &plane, const PlaneView &reference, bool fullRange)
{
    LightGain gain{1, fullRange ? 0 : codedBlack};
    const int step =
        std::max(1, static_cast<int>(std::sqrt(double(plane.width) * plane.height / comparedSamples)));
    RatioHistogram ratios;
    for (int y = step / 2; y < plane.height; y += step) {
        const int next = std::min(y + step, plane.height - 1);
        fetchEarly(plane.row(next), plane.width);
        fetchEarly(reference.row(next), plane.width);
        const std::uint8_t *now = plane.row(y), *before = reference.row(y);
        for (int x = step / 2; x < plane.width; x += step) {
            if (std::min(now[x], before[x]) >= leastLuma + gain.black &&
                std::max(now[x], before[x]) <= mostLuma)
                ratios.add(float(now[x] - gain.black) / float(before[x] - gain.black));
        }
    }
    if (ratios.count() >= fewestRatios) // the median alone would step with the code values
        gain.factor = std::clamp(ratios.meanOfMiddleHalf(), leastFactor, mostFactor);
    return gain;
}

std::array<std::uint8_t, 256> LightGain::table(float by) const
{
    std::array<std::uint8_t, 256> values{};
    for (int i = 0; i < 256; ++i)
        values[std::size_t(i)] =
            static_cast<std::uint8_t>(std::clamp(float(black) + by * float(i - black) + 0.5F, 0.0F, 255.0F));
    return values;
}

} // namespace odo
