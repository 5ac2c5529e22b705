// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/even_times.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace odo {

namespace {

constexpr std::size_t enoughEvenRows = 10;
constexpr double leastShare = 0.02;  // of the interval; less rounding does not show
constexpr int leastSpan = 50;        // resolutions; over fewer the rate is not known well
constexpr double mostResidual = 0.6; // of the resolution: half of it, and what the fit is off

/// A line through the times over the numbers of their rows.
struct Line
{
    double startNs = 0, stepNs = 0; ///< from the first time on
};

Line lineThrough(const std::vector<double> &numbers, const std::vector<Nanoseconds> &times)
{
    double n = 0, sumK = 0, sumT = 0, sumKk = 0, sumKt = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double k = numbers[i], t = static_cast<double>((times[i] - times.front()).count());
        n += 1;
        sumK += k;
        sumT += t;
        sumKk += k * k;
        sumKt += k * t;
    }
    const double step = (n * sumKt - sumK * sumT) / (n * sumKk - sumK * sumK);
    return {(sumT - step * sumK) / n, step};
}

/// Puts the times on a line where they are on it but for the rounding.
EvenSpread putOn(const Line &line, const std::vector<double> &numbers, std::vector<Nanoseconds> &times,
                 Nanoseconds resolution)
{
    constexpr double exact = 0.01, small = 0.2;
    const double unit = static_cast<double>(resolution.count());
    double worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = static_cast<double>((times[i] - times.front()).count());
        worst = std::max(worst, std::abs(line.startNs + line.stepNs * numbers[i] - t));
    }
    if (!(worst <= mostResidual * unit))
        return EvenSpread::NotEven;
    if (worst < exact * unit)
        return EvenSpread::AlreadyEven;
    const Nanoseconds first = times.front();
    // A series that begins at 0 does not begin before it.
    const bool isBefore =
        first >= Nanoseconds(0) && first + Nanoseconds(std::llround(line.startNs)) < Nanoseconds(0);
    const double startNs = isBefore ? 0 : line.startNs;
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = first + Nanoseconds(std::llround(startNs + line.stepNs * numbers[i]));
    return unit < small * line.stepNs ? EvenSpread::Slightly : EvenSpread::Much;
}

} // namespace

Nanoseconds resolutionOf(const std::vector<Nanoseconds> &times)
{
    std::int64_t step = 0;
    for (std::size_t i = 1; i < times.size() && step != 1; ++i)
        step = std::gcd(step, (times[i] - times[i - 1]).count());
    return Nanoseconds(step);
}

std::size_t sharedStamps(const std::vector<Nanoseconds> &times)
{
    std::size_t count = 0;
    for (std::size_t i = 1; i < times.size(); ++i)
        count += times[i] == times[i - 1];
    return count;
}

EvenSpread spreadEvenly(std::vector<Nanoseconds> &times, Nanoseconds resolution)
{
    if (times.size() < enoughEvenRows || !std::ranges::is_sorted(times) || times.front() == times.back())
        return EvenSpread::NotEven;
    const double step =
        static_cast<double>((times.back() - times.front()).count()) / static_cast<double>(times.size() - 1);
    if (static_cast<double>(resolution.count()) < leastShare * step ||
        times.back() - times.front() < leastSpan * resolution)
        return EvenSpread::NotEven;
    std::vector<double> numbers(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
        numbers[i] = static_cast<double>(i);
    const Line line = lineThrough(numbers, times);
    return line.stepNs > 1 ? putOn(line, numbers, times, resolution) : EvenSpread::NotEven;
}

EvenSpread spreadWithGaps(std::vector<Nanoseconds> &times, Nanoseconds resolution)
{
    if (times.size() < enoughEvenRows)
        return EvenSpread::NotEven;
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i)
        steps.push_back(static_cast<double>((times[i] - times[i - 1]).count()));
    double step = upperMedian(steps);
    if (!(step > 0) || static_cast<double>(resolution.count()) < leastShare * step)
        return EvenSpread::NotEven;
    std::vector<double> numbers(times.size(), 0);
    Line line;
    for (int round = 0; round < 3; ++round) {
        for (std::size_t i = 1; i < times.size(); ++i)
            numbers[i] = numbers[i - 1] + std::max(1.0, std::round(steps[i - 1] / step));
        line = lineThrough(numbers, times);
        step = line.stepNs;
        if (!(step > 1))
            return EvenSpread::NotEven;
    }
    return putOn(line, numbers, times, resolution);
}

} // namespace odo
