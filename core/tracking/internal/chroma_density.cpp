// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/chroma_density.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace odo {

namespace {

constexpr double dimmestUnpenalised = 0.6, brightestUnpenalised = 1.5;
constexpr double hueSigmaRad = 11.0 * std::numbers::pi / 180.0;
constexpr double chromaSigma = 3.0;      ///< code values: noise and coding, matters for pale colours
constexpr double mostSquaredSigmas = 40; ///< beyond this a likeness is none: below 1e-8
constexpr int lightSteps = 9;

} // namespace

Chroma ChromaDensity::centreOf(std::size_t bin)
{
    constexpr double half = ((1 << binShift) - 1) / 2.0;
    const auto u = static_cast<double>((bin / binsPerAxis) << binShift);
    const auto v = static_cast<double>((bin % binsPerAxis) << binShift);
    return {u + half - 128.0, v + half - 128.0};
}

void ChromaDensity::count(const ChromaGrid &grid, const ChromaRect &area, int step, float weight)
{
    // Neighbours often fall into one bin, and a count must wait for the one before it in the same bin: so
    // every other one goes to other bins.
    std::array<float, binCount> others{};
    for (int y = area.top; y < area.bottom; y += step) {
        const std::uint8_t *u = grid.u.row(y);
        const std::uint8_t *v = grid.v.row(y);
        int x = area.left;
        for (; x + step < area.right; x += 2 * step) {
            m_bins[binOf(u[x], v[x])] += weight;
            others[binOf(u[x + step], v[x + step])] += weight;
        }
        if (x < area.right)
            m_bins[binOf(u[x], v[x])] += weight;
    }
    for (std::size_t bin = 0; bin < binCount; ++bin)
        m_bins[bin] += others[bin];
}

double ChromaDensity::sum() const
{
    // Four sums at once: each need not wait for the one before.
    std::array<double, 4> sums{};
    for (std::size_t bin = 0; bin < binCount; bin += sums.size()) {
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += m_bins[bin + k];
    }
    return sums[0] + sums[1] + sums[2] + sums[3];
}

void ChromaDensity::normalise()
{
    const double total = sum();
    if (total <= 0)
        return;
    const auto factor = static_cast<float>(1.0 / total);
    for (float &bin : m_bins)
        bin *= factor;
}

void ChromaDensity::blur(int times)
{
    constexpr std::size_t n = binsPerAxis;
    const auto mixed = [](float before, float here, float after) {
        return 0.25f * before + 0.5f * here + 0.25f * after;
    };
    std::array<float, binCount> once{};
    for (int pass = 0; pass < times; ++pass) {
        for (std::size_t row = 0; row < binCount; row += n) {
            const float *from = &m_bins[row];
            float *to = &once[row];
            to[0] = mixed(from[0], from[0], from[1]);
            for (std::size_t i = 1; i < n - 1; ++i)
                to[i] = mixed(from[i - 1], from[i], from[i + 1]);
            to[n - 1] = mixed(from[n - 2], from[n - 1], from[n - 1]);
        }
        for (std::size_t row = 0; row < binCount; row += n) {
            const float *here = &once[row], *before = row > 0 ? here - n : here,
                        *after = row + n < binCount ? here + n : here;
            for (std::size_t i = 0; i < n; ++i)
                m_bins[row + i] = mixed(before[i], here[i], after[i]);
        }
    }
}

/// Where interpolation may give more than zero, in bins. A robot's density fills a small corner of the plane,
/// and skipping the empty rest saves most of the cost.
ChromaDensity::Support ChromaDensity::support() const
{
    int firstU = binsPerAxis, lastU = -1, firstV = binsPerAxis, lastV = -1;
    for (int bin = 0; bin < binCount; ++bin) {
        if (m_bins[bin] == 0)
            continue;
        const int u = bin / binsPerAxis, v = bin % binsPerAxis;
        firstU = std::min(firstU, u), lastU = std::max(lastU, u);
        firstV = std::min(firstV, v), lastV = std::max(lastV, v);
    }
    constexpr int end = binsPerAxis - 1;
    return {static_cast<double>(std::max(firstU - 1, 0)), static_cast<double>(std::min(lastU + 1, end)),
            static_cast<double>(std::max(firstV - 1, 0)), static_cast<double>(std::min(lastV + 1, end))};
}

/// The bins that may be other than zero when everything inside the support is scaled and turned.
ChromaDensity::Bins ChromaDensity::reachOf(const Support &support, std::initializer_list<double> scales,
                                           double turnRad)
{
    constexpr double perBin = 1 << binShift, half = (perBin - 1) / 2.0;
    const double c = std::cos(turnRad), s = std::sin(turnRad);
    double lowU = binsPerAxis, highU = 0, lowV = binsPerAxis, highV = 0;
    for (const double scale : scales) {
        for (const double binU : {support.beginU, support.endU}) {
            for (const double binV : {support.beginV, support.endV}) {
                const double u = binU * perBin + half - 128.0, v = binV * perBin + half - 128.0;
                const double toU = (scale * (c * u - s * v) + 128.0 - half) / perBin,
                             toV = (scale * (s * u + c * v) + 128.0 - half) / perBin;
                lowU = std::min(lowU, toU), highU = std::max(highU, toU);
                lowV = std::min(lowV, toV), highV = std::max(highV, toV);
            }
        }
    }
    const auto inside = [](double bin) { return std::clamp(static_cast<int>(bin), 0, binsPerAxis - 1); };
    return {inside(std::floor(lowU)), inside(std::ceil(highU)), inside(std::floor(lowV)),
            inside(std::ceil(highV))};
}

float ChromaDensity::interpolated(const Chroma &chroma, const Support &support) const
{
    constexpr double perBin = 1 << binShift;
    const double half = (perBin - 1) / 2.0;
    const double bu = (chroma.x() + 128.0 - half) / perBin;
    const double bv = (chroma.y() + 128.0 - half) / perBin;
    if (bu < support.beginU || bv < support.beginV || bu >= support.endU || bv >= support.endV)
        return 0;
    const int iu = static_cast<int>(bu), iv = static_cast<int>(bv);
    const auto fu = static_cast<float>(bu - iu), fv = static_cast<float>(bv - iv);
    const float *p = &m_bins[static_cast<std::size_t>(iu) * binsPerAxis + iv];
    return (1 - fu) * ((1 - fv) * p[0] + fv * p[1]) +
           fu * ((1 - fv) * p[binsPerAxis] + fv * p[binsPerAxis + 1]);
}

ChromaDensity ChromaDensity::underOtherLight(double low, double high) const
{
    std::array<double, lightSteps> light{};
    std::array<float, lightSteps> trust{};
    for (int i = 0; i < lightSteps; ++i) {
        const double part = static_cast<double>(i) / (lightSteps - 1);
        light[i] = std::exp(std::log(low) + part * std::log(high / low));
        trust[i] = static_cast<float>(1.0 - 0.6 * std::abs(2 * part - 1));
    }
    ChromaDensity result;
    const Support where = support();
    reachOf(where, {low, high}, 0).forEach([&](std::size_t bin) {
        const Chroma seen = centreOf(bin);
        float best = 0;
        for (int i = 0; i < lightSteps; ++i)
            best = std::max(best, trust[i] * interpolated(seen / light[i], where));
        result.m_bins[bin] = best;
    });
    return result;
}

ChromaDensity ChromaDensity::transformed(double scale, double turnRad) const
{
    const double c = std::cos(turnRad) / scale, s = std::sin(turnRad) / scale;
    ChromaDensity result;
    const Support where = support();
    reachOf(where, {scale}, turnRad).forEach([&](std::size_t bin) {
        const Chroma seen = centreOf(bin);
        result.m_bins[bin] = interpolated({c * seen.x() + s * seen.y(), c * seen.y() - s * seen.x()}, where);
    });
    return result;
}

double ChromaDensity::overlap(const ChromaDensity &other) const
{
    double sum = 0;
    for (std::size_t bin = 0; bin < binCount; ++bin) {
        if (m_bins[bin] > 0 && other.m_bins[bin] > 0) // both in small corners of the plane, as a rule
            sum += std::sqrt(static_cast<double>(m_bins[bin]) * other.m_bins[bin]);
    }
    return sum;
}

double likeness(const Chroma &seen, const Chroma &given)
{
    const double givenSaturation = given.norm(), seenSaturation = seen.norm();
    if (givenSaturation <= 0 || seenSaturation <= 0)
        return 0;
    const double cosine = std::clamp(seen.dot(given) / (seenSaturation * givenSaturation), -1.0, 1.0);
    const double paler = std::min(givenSaturation, seenSaturation);
    const double variance = hueSigmaRad * hueSigmaRad + chromaSigma * chromaSigma / (paler * paler);
    // The square of an angle is no less than that of its chord.
    if (2 * (1 - cosine) > mostSquaredSigmas * variance)
        return 0;
    const double angle = std::acos(cosine);
    const double ratio = seenSaturation / givenSaturation;
    double excess = 0;
    if (ratio < dimmestUnpenalised)
        excess = std::log(dimmestUnpenalised / ratio) / 0.25;
    else if (ratio > brightestUnpenalised)
        excess = std::log(ratio / brightestUnpenalised) / 0.35;
    return std::exp(-0.5 * (angle * angle / variance + excess * excess));
}

ChromaDensity densityOfGivenColour(const Chroma &given)
{
    ChromaDensity density;
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin)
        density[bin] = static_cast<float>(likeness(ChromaDensity::centreOf(bin), given));
    density.normalise();
    return density;
}

ChromaTable::ChromaTable(const ChromaDensity &robot, const ChromaDensity &background, float uncertainty)
{
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin) {
        const float likelihood = robot[bin];
        const float all = likelihood + background[bin] + uncertainty;
        m_weights[bin] = all > 0 ? static_cast<std::uint8_t>(255.0f * likelihood / all + 0.5f) : 0;
    }
    findBox();
}

void ChromaTable::findBox()
{
    constexpr std::size_t n = ChromaDensity::binsPerAxis;
    std::array<std::uint8_t, n> mostOfU{}, mostOfV{}; // weights
    for (std::size_t u = 0; u < n; ++u) {
        const std::uint8_t *weights = &m_weights[u * n];
        mostOfU[u] = *std::max_element(weights, weights + n);
        for (std::size_t v = 0; v < n; ++v)
            mostOfV[v] = std::max(mostOfV[v], weights[v]);
    }
    setRange(mostOfU, m_leastU, m_rangeU);
    setRange(mostOfV, m_leastV, m_rangeV);
}

/// Of a table that takes nothing the range is a single bin: no harm.
void ChromaTable::setRange(const std::array<std::uint8_t, ChromaDensity::binsPerAxis> &most,
                           std::uint8_t &least, std::uint8_t &range)
{
    const auto isTaken = [](std::uint8_t weight) { return weight >= threshold; };
    const auto first = std::find_if(most.begin(), most.end(), isTaken);
    const auto beyond = std::find_if(most.rbegin(), most.rend(), isTaken).base();
    const auto bins = static_cast<int>(std::max<std::ptrdiff_t>(beyond - first, 1));
    const auto start = static_cast<int>(std::min<std::ptrdiff_t>(first - most.begin(), most.size() - 1));
    least = static_cast<std::uint8_t>(start << ChromaDensity::binShift);
    range = static_cast<std::uint8_t>((bins << ChromaDensity::binShift) - 1);
}

void ChromaTable::add(const ChromaTable &other)
{
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin)
        m_weights[bin] = std::max(m_weights[bin], other.m_weights[bin]);
    findBox();
}

} // namespace odo
