// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/sound_correlation.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace odo {

namespace {

using Spectrum = std::vector<std::complex<float>>;

constexpr double regularised = 0.3; ///< times the mean magnitude: what is weaker counts less
constexpr std::size_t stepsBetweenPeaks = 4;

constexpr double pieceBeforeS = 0.004, fadeS = 0.0015;
constexpr std::size_t mostPieces = 300; ///< by which the usual sound is known
constexpr double fromHz = 300, toHz = 7000;
constexpr double longestLagS = 0.004;
constexpr std::size_t finer = 8; ///< the lags, than the samples
constexpr int smoothedBins = 6;
constexpr double timesUsual = 3;

Spectrum spectrumOf(std::vector<float> values, std::size_t size)
{
    values.resize(size);
    Eigen::FFT<float> transform;
    Spectrum spectrum;
    transform.fwd(spectrum, values);
    return spectrum;
}

std::vector<float> inverseOf(const Spectrum &spectrum)
{
    Eigen::FFT<float> transform;
    std::vector<float> values;
    transform.inv(values, spectrum);
    return values;
}

/// Of a spectrum without negative frequencies.
std::vector<float> envelopeOf(const Spectrum &spectrum)
{
    Eigen::FFT<float> transform;
    Spectrum values;
    transform.inv(values, spectrum);
    std::vector<float> envelope(values.size());
    std::ranges::transform(values, envelope.begin(),
                           [](const std::complex<float> &value) { return std::abs(value); });
    return envelope;
}

std::size_t powerOfTwo(std::size_t least)
{
    std::size_t size = 2;
    while (size < least)
        size *= 2;
    return size;
}

/// How long the compared pieces are, and what is taken as alike in them.
struct Extent
{
    std::size_t samples, size;       ///< the transform's: twice as much, of a power of two
    double leastBins;                ///< of the spectrum that stand out in both
    double leastShare;               ///< of the spectrum that agrees at one lag
    double highestRival;             ///< second peak, in parts of the first
    double rivalWithinS, peakFlankS; ///< a second peak is looked for so far about the first, beyond its flank
    double sigmaS;                   ///< of the lag
    /// Not the phases alone are compared but the waves as they are, and by the envelope of their correlation:
    /// the phases of a pure tone are few, and its waves too close together to tell them apart.
    bool byEnvelope = false;
};

/// The direct sound of a clap and little more; a quarter of a second of a shrill whistle; the same of a pure
/// tone that rises or falls.
constexpr Extent strike{352, 1024, 120, 0.42, 0.5, 0.008, 0.00025, 0.0002};
constexpr Extent whistle{4000, 8192, 800, 0.25, 0.5, 0.008, 0.00025, 0.0002};
constexpr Extent tone{4000, 8192, 100, 0.8, 0.85, 0.06, 0.007, 0.0015, true};

/// From a sample on, faded at both ends; silence where the track does not reach.
std::vector<float> pieceOf(const SoundTrack &track, std::int64_t from, std::size_t samples)
{
    const double fade = fadeS * SoundTrack::rate;
    std::vector<float> piece(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        const std::int64_t at = from + std::int64_t(i);
        if (at < 0 || at >= std::int64_t(track.samples.size()))
            continue;
        const double edge = std::min({1.0, double(i) / fade, double(samples - i) / fade});
        piece[i] = float((0.5 - 0.5 * std::cos(std::numbers::pi * edge)) * track.samples[std::size_t(at)]);
    }
    return piece;
}

/// The power about each bin.
std::vector<double> smoothedPower(const Spectrum &spectrum, std::size_t bins)
{
    std::vector<double> power(bins);
    for (std::size_t i = 0; i < bins; ++i) {
        const std::size_t from = i > smoothedBins ? i - smoothedBins : 1,
                          to = std::min(bins, i + smoothedBins + 1);
        for (std::size_t k = from; k < to; ++k)
            power[i] += double(std::norm(spectrum[k])) / double(to - from);
    }
    return power;
}

/// A piece of sound and how far each of its frequencies stands out.
struct Piece
{
    Spectrum spectrum;
    std::vector<double> weights;
    double startS = 0;
};

Piece pieceAbout(const HeardSound &heard, double timeS, const Extent &extent)
{
    const SoundTrack &track = heard.track;
    const auto from = std::int64_t(std::lround((timeS - pieceBeforeS - track.firstS) * SoundTrack::rate));
    Piece piece{spectrumOf(pieceOf(track, from, extent.samples), extent.size),
                {},
                track.firstS + double(from) / SoundTrack::rate};
    const std::vector<double> loud = smoothedPower(piece.spectrum, extent.size / 2);
    const double longer = double(extent.samples) / double(strike.samples);
    const std::size_t narrower = extent.size / strike.size;
    piece.weights.resize(loud.size());
    for (std::size_t i = 0; i < loud.size(); ++i)
        piece.weights[i] =
            loud[i] > 0 ? std::max(0.0, 1 - timesUsual * longer * heard.usual.power[i / narrower] / loud[i])
                        : 0;
    return piece;
}

} // namespace

std::vector<CurveLag> correlationPeaks(const std::vector<float> &first, const std::vector<float> &second,
                                       std::size_t most)
{
    const std::size_t size = powerOfTwo(first.size() + second.size());
    Spectrum cross = spectrumOf(first, size);
    {
        const Spectrum other = spectrumOf(second, size);
        double mean = 0;
        for (std::size_t i = 0; i < size; ++i) {
            cross[i] *= std::conj(other[i]);
            mean += double(std::abs(cross[i])) / double(size);
        }
        for (std::complex<float> &value : cross)
            value /= std::max(1e-20F, std::abs(value) + float(regularised * mean));
    }
    const std::vector<float> lags = inverseOf(cross);
    const auto at = [&lags, size](std::int64_t lag) {
        return lags[std::size_t(lag < 0 ? lag + std::int64_t(size) : lag)];
    };
    std::vector<CurveLag> peaks;
    for (std::int64_t lag = -std::int64_t(second.size()); lag < std::int64_t(first.size()); ++lag) {
        const float height = at(lag);
        if (height <= 0 || height < at(lag - 1) || height <= at(lag + 1) ||
            (peaks.size() == most && height <= peaks.back().height))
            continue;
        const auto near = std::ranges::find_if(peaks, [lag](const CurveLag &peak) {
            return std::abs(double(lag) - peak.steps) < double(stepsBetweenPeaks);
        });
        if (near != peaks.end()) {
            if (near->height >= height)
                continue;
            peaks.erase(near);
        }
        const CurveLag peak{double(lag), height};
        peaks.insert(
            std::ranges::upper_bound(peaks, -peak.height, {}, [](const CurveLag &p) { return -p.height; }),
            peak);
        if (peaks.size() > most)
            peaks.pop_back();
    }
    return peaks;
}

UsualSound usualSoundOf(const SoundTrack &track)
{
    const std::size_t pieces = std::clamp<std::size_t>(track.samples.size() / strike.samples, 1, mostPieces);
    std::vector<std::vector<double>> powers(strike.size / 2);
    for (std::size_t i = 0; i < pieces; ++i) {
        const auto from = std::int64_t(i * (track.samples.size() / pieces));
        const std::vector<double> power =
            smoothedPower(spectrumOf(pieceOf(track, from, strike.samples), strike.size), powers.size());
        for (std::size_t k = 0; k < power.size(); ++k)
            powers[k].push_back(power[k]);
    }
    UsualSound usual;
    for (std::vector<double> &power : powers)
        usual.power.push_back(upperMedian(std::move(power)));
    return usual;
}

namespace {

WaveLikeness compare(const HeardSound &first, double firstS, const HeardSound &second, double secondS,
                     const Extent &extent)
{
    const Piece a = pieceAbout(first, firstS, extent), b = pieceAbout(second, secondS, extent);
    Spectrum cross(extent.size * finer);
    double whole = 0, firstPower = 0, secondPower = 0;
    const double hzPerBin = SoundTrack::rate / double(extent.size);
    for (auto i = std::size_t(fromHz / hzPerBin); i < std::size_t(toHz / hzPerBin); ++i) {
        const std::complex<float> product = a.spectrum[i] * std::conj(b.spectrum[i]);
        const double weight = a.weights[i] * b.weights[i], magnitude = std::abs(product);
        if (magnitude <= 0)
            continue;
        cross[i] = product * float(extent.byEnvelope ? weight : weight / magnitude);
        firstPower += weight * double(std::norm(a.spectrum[i]));
        secondPower += weight * double(std::norm(b.spectrum[i]));
        if (!extent.byEnvelope)
            cross[cross.size() - i] = std::conj(cross[i]);
        whole += weight;
    }
    if (whole < extent.leastBins)
        return {};
    const std::vector<float> lags = extent.byEnvelope ? envelopeOf(cross) : inverseOf(cross);
    const double lagStepS = 1 / (SoundTrack::rate * double(finer));
    const auto height = [&lags](std::int64_t lag) {
        return double(lags[std::size_t(lag < 0 ? lag + std::int64_t(lags.size()) : lag)]);
    };
    const auto longest = std::int64_t(longestLagS / lagStepS),
               beside = std::int64_t(extent.peakFlankS / lagStepS),
               farthest = std::int64_t(extent.rivalWithinS / lagStepS);
    std::int64_t best = 0;
    for (std::int64_t lag = -longest; lag <= longest; ++lag)
        best = height(lag) > height(best) ? lag : best;
    if (height(best) <= 0)
        return {};
    double rival = 0;
    for (std::int64_t lag = best - farthest; lag <= best + farthest; ++lag)
        rival = std::abs(lag - best) > beside ? std::max(rival, height(lag)) : rival;
    const double share = height(best) * double(lags.size()) /
                         (extent.byEnvelope ? std::sqrt(firstPower * secondPower) : 2 * whole);
    return {share >= extent.leastShare && rival <= extent.highestRival * height(best),
            double(best) * lagStepS + (a.startS - firstS) - (b.startS - secondS), extent.sigmaS};
}

} // namespace

WaveLikeness compareWaves(const HeardSound &first, double firstS, const HeardSound &second, double secondS)
{
    WaveLikeness likeness;
    for (const Extent *extent : {&strike, &whistle, &tone})
        if (likeness = compare(first, firstS, second, secondS, *extent); likeness.isAlike)
            break;
    return likeness;
}

} // namespace odo
