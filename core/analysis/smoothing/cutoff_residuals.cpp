// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/smoothing/cutoff_residuals.h"

#include "core/analysis/curve_fit.h"
#include "core/analysis/motion_stretches.h"
#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace odo {

namespace {

/// (√2 − 1)^(1/4): where 1/(1 + x⁴), two passes, is −3 dB; and (√2 − 1)^(1/6) for 1/(1 + x⁶).
const double twoPasses = std::pow(std::numbers::sqrt2 - 1, 0.25);
const double smootherEdge = std::pow(std::numbers::sqrt2 - 1, 1.0 / 6);

/// Both coordinates of a stretch, one value a frame.
struct EvenStretch
{
    std::vector<double> x, y;
};

/// The usual time between two samples; 0 of fewer than two.
double usualStepS(const std::vector<Sample> &samples)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < samples.size(); ++i)
        steps.push_back(toSeconds(samples[i].time - samples[i - 1].time));
    return steps.empty() ? 0 : upperMedian(std::move(steps));
}

void append(EvenStretch &stretch, const Eigen::Vector2d &position)
{
    stretch.x.push_back(position.x());
    stretch.y.push_back(position.y());
}

/// Of the used samples.
std::vector<EvenStretch> stretchesOf(const std::vector<Sample> &samples, double stepS)
{
    constexpr double longestFilled = 4.5; // three frames are missing
    std::vector<EvenStretch> stretches(1);
    const Sample *before = nullptr;
    Eigen::Vector2d last = Eigen::Vector2d::Zero();
    for (const Sample &sample : samples) {
        if (!isUsed(sample))
            continue;
        const Eigen::Vector2d &position = *sample.position;
        const double steps = before ? toSeconds(sample.time - before->time) / stepS : 0;
        if (before && (steps > longestFilled || sample.isAfterBreak)) {
            stretches.emplace_back();
        } else if (before) {
            const auto missing = std::max(0L, std::lround(steps) - 1);
            for (long k = 1; k <= missing; ++k)
                append(stretches.back(), last + (position - last) * (double(k) / double(missing + 1)));
        }
        append(stretches.back(), position);
        last = position;
        before = &sample;
    }
    const auto shortest = static_cast<std::size_t>(std::max(10.0, 1 / stepS));
    std::erase_if(stretches, [shortest](const EvenStretch &each) { return each.x.size() < shortest; });
    return stretches;
}

double meanSquare(const std::vector<double> &a, const std::vector<double> &b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::pow(a[i] - b[i], 2);
    return sum;
}

CutoffResidual residualAt(const std::vector<EvenStretch> &stretches, double rate, double cutoffHz)
{
    double sum = 0, count = 0;
    for (const EvenStretch &stretch : stretches)
        for (const std::vector<double> &values : {stretch.x, stretch.y}) {
            sum += meanSquare(values, butterworth(values, rate, cutoffHz));
            count += double(values.size());
        }
    const double residual = std::sqrt(sum / count);
    // What is taken away is nearly white above the cut-off: it has so many independent values.
    const double independent = std::max(1.0, count * (1 - 2 * cutoffHz / rate));
    return {cutoffHz, residual, residual / std::sqrt(2 * independent)};
}

/// The share of white noise that a filter takes away: (1/f_N)∫(1 − gain)² df up to half of the rate.
double whiteShare(double rate, double cutoffHz)
{
    constexpr int steps = 400;
    const double edge = std::tan(std::numbers::pi * cutoffHz / rate) / twoPasses;
    double share = 0;
    for (int i = 0; i < steps; ++i) {
        const double x = std::tan(std::numbers::pi / 2 * (i + 0.5) / steps) / edge;
        const double taken = 1 - 1 / (1 + std::pow(x, 4));
        share += taken * taken / steps;
    }
    return share;
}

/// By the upper half of the cut-offs, above which only noise is.
void addNoise(CutoffAnalysis &analysis)
{
    constexpr double fromShare = 0.5;
    const double from = fromShare * analysis.residuals.back().cutoffHz;
    const auto first = std::ranges::find_if(
        analysis.residuals, [from](const CutoffResidual &each) { return each.cutoffHz >= from; });
    double sum = 0, squares = 0, count = 0;
    for (const CutoffResidual &each : std::span(first, analysis.residuals.end())) {
        const double noise = each.residualM / std::sqrt(whiteShare(analysis.framesPerSecond, each.cutoffHz));
        sum += noise;
        squares += noise * noise;
        count += 1;
    }
    const double noise = sum / count;
    if (!(noise > 0))
        return;
    // The residuals of one run go up and down together; noise that is not white scatters.
    const double scatter = std::sqrt(std::max(0.0, squares / count - noise * noise));
    analysis.noiseM = CurveValue{noise, std::hypot(scatter, noise * first->sigmaM / first->residualM)};
    for (std::size_t i = 1; i < analysis.residuals.size(); ++i) {
        const CutoffResidual &before = analysis.residuals[i - 1], &after = analysis.residuals[i];
        if (!(before.residualM >= noise && after.residualM < noise))
            continue;
        const double fall = (after.residualM - before.residualM) / (after.cutoffHz - before.cutoffHz);
        analysis.chosenHz = CurveValue{before.cutoffHz + (noise - before.residualM) / fall,
                                       std::hypot(analysis.noiseM->sigma, before.sigmaM) / std::abs(fall)};
        return;
    }
}

void addAutomatic(const Profile &profile, CutoffAnalysis &analysis)
{
    std::vector<double> rates;
    for (const RunInstant &instant : validInstants(profile.samples, profile.points))
        if (const double rate = errorRate(ownSigmaOfPosition(instant), instant.point->sigmaSpeedMps);
            rate > 0 && std::isfinite(rate))
            rates.push_back(smootherEdge * rate / (2 * std::numbers::pi));
    if (!rates.empty()) {
        std::ranges::sort(rates);
        const auto at = [&rates](double share) {
            return rates[static_cast<std::size_t>(share * double(rates.size() - 1))];
        };
        constexpr double below = 0.159, above = 0.841; // of a normal distribution: one σ
        analysis.automaticHz = CurveValue{at(0.5), (at(above) - at(below)) / 2};
    }
    double sum = 0, noise = 0, count = 0;
    for (std::size_t i = 0; i < profile.samples.size(); ++i) {
        const Sample &sample = profile.samples[i];
        if (!isUsed(sample) || !profile.points[i].valid)
            continue;
        sum += (*sample.position - profile.points[i].position).squaredNorm() / 2;
        noise += sample.covariance.trace() / 2;
        count += 1;
    }
    if (count == 0)
        return;
    const double residual = std::sqrt(sum / count);
    analysis.automaticResidualM = CurveValue{residual, residual / std::sqrt(4 * count)};
    analysis.statedNoiseM = std::sqrt(noise / count);
}

} // namespace

std::vector<double> butterworth(const std::vector<double> &values, double framesPerSecond, double cutoffHz)
{
    const auto size = static_cast<std::ptrdiff_t>(values.size());
    if (size < 2)
        return values;
    // Second order by the bilinear transform, prewarped; each pass has its edge further out.
    const double k = std::tan(std::numbers::pi * std::min(cutoffHz / framesPerSecond, 0.499)) / twoPasses;
    const double norm = 1 / (1 + std::numbers::sqrt2 * k + k * k);
    const double b = k * k * norm, a1 = 2 * (k * k - 1) * norm,
                 a2 = (1 - std::numbers::sqrt2 * k + k * k) * norm;
    const auto pass = [&](std::vector<double> &series) {
        double x1 = series.front(), x2 = x1, y1 = x1, y2 = x1;
        for (double &value : series) {
            const double y = b * (value + 2 * x1 + x2) - a1 * y1 - a2 * y2;
            x2 = x1;
            x1 = value;
            y2 = y1;
            value = y1 = y;
        }
    };
    // Reflected about its ends, so the filter has settled where the series begins.
    const std::ptrdiff_t room =
        std::min(size - 1, static_cast<std::ptrdiff_t>(std::ceil(3 * framesPerSecond / cutoffHz)));
    std::vector<double> series;
    series.reserve(static_cast<std::size_t>(size + 2 * room));
    for (std::ptrdiff_t i = room; i > 0; --i)
        series.push_back(2 * values.front() - values[static_cast<std::size_t>(i)]);
    series.insert(series.end(), values.begin(), values.end());
    for (std::ptrdiff_t i = 1; i <= room; ++i)
        series.push_back(2 * values.back() - values[static_cast<std::size_t>(size - 1 - i)]);
    pass(series);
    std::ranges::reverse(series);
    pass(series);
    std::ranges::reverse(series);
    return {series.begin() + room, series.begin() + room + size};
}

CutoffAnalysis cutoffAnalysis(const Profile &profile)
{
    constexpr int steps = 40;
    constexpr double lowestHz = 0.5, highestShare = 0.9;
    CutoffAnalysis analysis;
    if (profile.samples.size() != profile.points.size())
        return analysis;
    const double stepS = usualStepS(profile.samples);
    if (!(stepS > 0))
        return analysis;
    analysis.framesPerSecond = 1 / stepS;
    const std::vector<EvenStretch> stretches = stretchesOf(profile.samples, stepS);
    const double highestHz = highestShare * analysis.framesPerSecond / 2;
    if (stretches.empty() || highestHz <= lowestHz)
        return analysis;
    for (int i = 0; i < steps; ++i) // evenly, as the line is straight over the frequency
        analysis.residuals.push_back(residualAt(stretches, analysis.framesPerSecond,
                                                lowestHz + (highestHz - lowestHz) * i / (steps - 1)));
    addNoise(analysis);
    addAutomatic(profile, analysis);
    return analysis;
}

} // namespace odo
