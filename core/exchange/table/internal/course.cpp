// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/course.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

std::vector<std::size_t> measuredRows(const RawTrack &track)
{
    std::vector<std::size_t> rows;
    rows.reserve(track.size());
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (track.isMeasured(i))
            rows.push_back(i);
    }
    return rows;
}

double distanceOf(const RawTrack &track, std::size_t row, std::size_t other)
{
    return std::hypot(track.x[row] - track.x[other], track.y[row] - track.y[other]);
}

double percentileOf(std::vector<double> values, double percent)
{
    if (values.empty())
        return 0;
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(percent / 100 * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
}

double spreadOf(const std::vector<double> &values)
{
    std::vector<double> known;
    for (const double value : values) {
        if (std::isfinite(value))
            known.push_back(value);
    }
    constexpr double low = 5, high = 95;
    return percentileOf(known, high) - percentileOf(known, low);
}

namespace {

constexpr std::size_t mostLooked = 20'000; // rows say as much as all

/// The coarsest power of ten that the numbers are multiples of, but for a few; 0 where all of them are 0.
double courseResolution(const RawTrack &track, const std::vector<std::size_t> &rows)
{
    constexpr int finest = 11;
    constexpr double coarsest = 100;
    if (std::ranges::all_of(rows, [&](std::size_t i) { return track.x[i] == 0 && track.y[i] == 0; }))
        return 0;
    double unit = 1 / coarsest;
    for (int digits = 0; digits < finest; ++digits, unit *= 10) {
        const auto isOff = [&](double value) {
            return std::abs(value * unit - std::round(value * unit)) > 1e-5 * std::max(1.0, std::abs(value));
        };
        std::size_t off = 0;
        for (std::size_t i = 0; i < std::min(rows.size(), mostLooked); ++i)
            off += isOff(track.x[rows[i]]) || isOff(track.y[rows[i]]);
        if (off * 50 < std::min(rows.size(), mostLooked))
            break;
    }
    return 1 / unit;
}

/// Of a robot that moves smoothly, third differences leave what it does not do.
double noiseOf(const RawTrack &track, const std::vector<std::size_t> &rows)
{
    std::vector<double> differences;
    for (std::size_t i = 3; i < std::min(rows.size(), mostLooked); ++i) {
        if (rows[i] - rows[i - 3] != 3 || distanceOf(track, rows[i], rows[i - 1]) == 0 ||
            distanceOf(track, rows[i - 1], rows[i - 2]) == 0 ||
            distanceOf(track, rows[i - 2], rows[i - 3]) == 0)
            continue;
        for (const std::vector<double> *values : {&track.x, &track.y}) {
            const std::vector<double> &v = *values;
            differences.push_back(
                std::abs(v[rows[i]] - 3 * v[rows[i - 1]] + 3 * v[rows[i - 2]] - v[rows[i - 3]]));
        }
    }
    const double fromMedian = 1.4826 / std::sqrt(20.0);
    return fromMedian * percentileOf(std::move(differences), 50);
}

} // namespace

CourseFacts courseOf(const RawTrack &track)
{
    CourseFacts course;
    const std::vector<std::size_t> rows = measuredRows(track);
    if (rows.size() < enoughForCourse)
        return course;
    std::vector<double> steps;
    std::size_t repeats = 0;
    bool wasRepeat = false;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double step = distanceOf(track, rows[i], rows[i - 1]);
        if (step > 0)
            steps.push_back(step);
        else
            ++repeats;
        course.repeatRuns += step == 0 && !wasRepeat;
        wasRepeat = step == 0;
    }
    course.repeats = static_cast<double>(repeats) / static_cast<double>(rows.size());
    course.usualStep = percentileOf(std::move(steps), 50);
    course.resolution = courseResolution(track, rows);
    course.noise = noiseOf(track, rows);
    return course;
}

double typicalSpeed(const RawTrack &track, const std::vector<Nanoseconds> &times)
{
    constexpr std::size_t apart = 5;
    constexpr double high = 90;
    const std::vector<std::size_t> rows = measuredRows(track);
    std::vector<double> speeds;
    for (std::size_t i = apart; i < rows.size(); ++i) {
        const double seconds = toSeconds(times[rows[i]] - times[rows[i - apart]]);
        if (seconds > 0)
            speeds.push_back(distanceOf(track, rows[i], rows[i - apart]) / seconds);
    }
    return percentileOf(std::move(speeds), high);
}

} // namespace odo
