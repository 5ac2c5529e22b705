// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/sound_onsets.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

struct Band
{
    double fromHz, toHz;
};

constexpr std::array bands{Band{300, 800}, Band{800, 2000}, Band{2000, 4000}, Band{4000, 7000}};
constexpr auto samplesPerStep = std::size_t(SoundTrack::rate * SoundOnsets::stepS);
constexpr std::size_t stepsBetween = 4; ///< the level before ends this far before
constexpr double decay = 0.983; ///< of the level before, a step: that of a room that rings on for 0.4 s
constexpr double aboveBefore = 1.5;
constexpr double scaleStart = 4; ///< times the usual level
constexpr double leastLevel = 2; ///< of 32,767
constexpr std::size_t riseSteps = 3;
constexpr std::size_t stepsOfEvent = 20; ///< in which all of its onset lies
constexpr std::size_t stepsApart = 60;   ///< of two events
constexpr double firstPartOfSteepest = 0.4;
constexpr double leastStrength = 1.5;
constexpr double leastPartOfStrongest = 0.25;

/// Second-order filters by the bilinear transform (R. Bristow-Johnson, Audio EQ cookbook), Q = 1/√2.
class Filter
{
public:
    static Filter lowPass(double hz) { return {hz, false}; }
    static Filter highPass(double hz) { return {hz, true}; }
    double operator()(double in)
    {
        const double out = m_b0 * in + m_state1;
        m_state1 = m_b1 * in - m_a1 * out + m_state2;
        m_state2 = m_b0 * in - m_a2 * out;
        return out;
    }

private:
    Filter(double hz, bool high)
    {
        const double w = 2 * std::numbers::pi * hz / SoundTrack::rate, c = std::cos(w);
        const double alpha = std::sin(w) / std::numbers::sqrt2, a0 = 1 + alpha;
        m_b1 = (high ? -(1 + c) : 1 - c) / a0;
        m_b0 = (high ? 1 + c : 1 - c) / 2 / a0;
        m_a1 = -2 * c / a0;
        m_a2 = (1 - alpha) / a0;
    }
    double m_b0, m_b1, m_a1, m_a2;
    double m_state1 = 0, m_state2 = 0;
};

/// Root mean square of each step.
std::vector<float> levelsOf(const std::vector<std::int16_t> &samples, const Band &band)
{
    Filter low = Filter::lowPass(band.toHz), high = Filter::highPass(band.fromHz);
    std::vector<float> levels(samples.size() / samplesPerStep);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < samplesPerStep; ++k) {
            const double value = low(high(samples[i * samplesPerStep + k]));
            sum += value * value;
        }
        levels[i] = float(std::sqrt(sum / double(samplesPerStep)));
    }
    return levels;
}

void addOnsets(std::vector<float> &curve, const std::vector<float> &levels)
{
    const double usual = std::max<double>(leastLevel, upperMedian(levels));
    double before = 0;
    std::vector<float> novelty(levels.size());
    for (std::size_t i = stepsBetween; i < levels.size(); ++i) {
        before = std::max<double>(before * decay, levels[i - stepsBetween]);
        const double risen = levels[i] - aboveBefore * before;
        novelty[i] = float(std::log2(1 + std::max(0.0, risen) / (scaleStart * usual)));
    }
    for (std::size_t i = riseSteps; i < novelty.size(); ++i)
        curve[i] += std::max(0.0F, novelty[i] - *std::max_element(&novelty[i - riseSteps], &novelty[i]));
}

/// In steps: the first rise, which is that of the direct sound, of those that end at `last`.
double beginningOf(const std::vector<float> &curve, std::size_t last)
{
    const std::size_t from = last >= stepsOfEvent ? last - stepsOfEvent + 1 : 0;
    const float steepest = *std::max_element(&curve[from], &curve[last] + 1);
    std::size_t first = from;
    while (double(curve[first]) < firstPartOfSteepest * double(steepest))
        ++first;
    double sum = 0, weighted = 0;
    for (std::size_t i = first > 0 ? first - 1 : 0; i <= std::min(first + 1, curve.size() - 1); ++i) {
        sum += curve[i];
        weighted += double(i) * double(curve[i]);
    }
    return weighted / sum;
}

std::vector<SoundEvent> eventsOf(const SoundOnsets &onsets)
{
    const std::vector<float> &curve = onsets.curve;
    std::vector<float> sums(curve.size());
    double sum = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        sum += curve[i] - (i >= stepsOfEvent ? curve[i - stepsOfEvent] : 0);
        sums[i] = float(sum);
    }
    const double strongest = sums.empty() ? 0 : *std::ranges::max_element(sums);
    const double least = std::max(leastStrength, leastPartOfStrongest * strongest);
    std::vector<SoundEvent> events;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (sums[i] < least)
            continue;
        const std::size_t to = std::min(sums.size(), i + stepsApart);
        const auto best = std::size_t(
            std::max_element(sums.begin() + std::ptrdiff_t(i), sums.begin() + std::ptrdiff_t(to)) -
            sums.begin());
        events.push_back({onsets.firstS + SoundOnsets::stepS * beginningOf(curve, best), sums[best]});
        i = best + stepsApart;
    }
    return events;
}

} // namespace

SoundOnsets findSoundOnsets(const SoundTrack &track)
{
    SoundOnsets onsets;
    onsets.firstS = track.firstS;
    onsets.curve.resize(track.samples.size() / samplesPerStep);
    for (const Band &band : bands)
        addOnsets(onsets.curve, levelsOf(track.samples, band));
    onsets.events = eventsOf(onsets);
    return onsets;
}

} // namespace odo
