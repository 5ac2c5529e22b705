// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/track_breaks.h"

#include "core/analysis/motion_stretches.h"
#include "core/base/percentile.h"
#include "core/exchange/table/internal/course.h"
#include "core/trajectory/analyser.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double leastLeapM = 0.05, leastLeapMps = 1.5;
constexpr double fasterThanElse = 6;   // than the quickest that the robot drives
constexpr std::size_t settledRows = 8; // on both sides of a leap
constexpr double returnsWithinS = 3, mostOffReturn = 0.3;
constexpr std::size_t mostBreaks = 20;

/// Leaps of one track.
class LeapSearch
{
public:
    LeapSearch(const RawTrack &track, const std::vector<Nanoseconds> &times, double unitsPerMetre)
        : m_track(track), m_times(times), m_perMetre(unitsPerMetre), m_rows(measuredRows(track))
    {
        constexpr double almostAll = 98;
        std::vector<double> speeds;
        for (std::size_t i = 1; i < m_rows.size(); ++i)
            speeds.push_back(speedTo(i));
        m_quickest = percentileOf(std::move(speeds), almostAll);
    }

    /// Places in the measured rows, each the first one behind a leap that stays.
    std::vector<std::size_t> found() const
    {
        std::vector<std::size_t> leaps;
        for (std::size_t i = settledRows; i + settledRows < m_rows.size(); ++i) {
            if (isLeap(i) && isSettled(i - settledRows, i - 1) && isSettled(i, i + settledRows))
                leaps.push_back(i);
        }
        std::vector<std::size_t> staying;
        for (std::size_t k = 0; k < leaps.size(); ++k) {
            // A burst of false positions, there and back, is left to the search for spikes.
            const bool returns = k + 1 < leaps.size() && isReturn(leaps[k], leaps[k + 1]);
            const bool isReturned = k > 0 && isReturn(leaps[k - 1], leaps[k]);
            if (!returns && !isReturned)
                staying.push_back(leaps[k]);
        }
        return staying;
    }
    const std::vector<std::size_t> &rows() const { return m_rows; }
    double metresTo(std::size_t i) const
    {
        return distanceOf(m_track, m_rows[i], m_rows[i - 1]) / m_perMetre;
    }

private:
    double speedTo(std::size_t i) const
    {
        const double seconds = toSeconds(m_times[m_rows[i]] - m_times[m_rows[i - 1]]);
        return seconds > 0 ? metresTo(i) / seconds : 0;
    }
    bool isLeap(std::size_t i) const
    {
        return metresTo(i) > leastLeapM && speedTo(i) > std::max(leastLeapMps, fasterThanElse * m_quickest);
    }
    bool isSettled(std::size_t from, std::size_t to) const
    {
        for (std::size_t i = from + 1; i <= to; ++i) {
            if (isLeap(i))
                return false;
        }
        return true;
    }
    bool isReturn(std::size_t leap, std::size_t next) const
    {
        const auto step = [&](std::size_t i) {
            const std::size_t to = m_rows[i], from = m_rows[i - 1];
            return std::array{m_track.x[to] - m_track.x[from], m_track.y[to] - m_track.y[from]};
        };
        const auto there = step(leap), back = step(next);
        const double seconds = toSeconds(m_times[m_rows[next]] - m_times[m_rows[leap]]);
        return seconds < returnsWithinS && std::hypot(there[0] + back[0], there[1] + back[1]) <
                                               mostOffReturn * std::hypot(there[0], there[1]);
    }

    const RawTrack &m_track;
    const std::vector<Nanoseconds> &m_times;
    double m_perMetre, m_quickest = 0;
    std::vector<std::size_t> m_rows;
};

/// Longer than what is bridged between positions.
Nanoseconds openGap(const std::vector<Nanoseconds> &times)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i)
        steps.push_back(toSeconds(times[i] - times[i - 1]));
    const Nanoseconds usual = fromSeconds(steps.empty() ? 0 : upperMedian(std::move(steps)));
    return std::max(AnalysisOptions().longestBridgedGap, bridgedIntervals * usual) + usual;
}

} // namespace

Result<void> openBreaks(RawTrack &track, const std::vector<Nanoseconds> &times, double unitsPerMetre,
                        Understanding &how)
{
    const LeapSearch search(track, times, unitsPerMetre);
    if (search.rows().size() < 3 * settledRows)
        return {};
    const std::vector<std::size_t> leaps = search.found();
    if (leaps.size() > mostBreaks)
        return how.wrong(track.lines[search.rows()[leaps.front()]],
                         ODO_TEXT("exchange.breaks_too_often",
                                  "its positions jump %1 times and go on from elsewhere")(leaps.size()),
                         ODO_TEXT("exchange.check_one_run", "check that all lines are of one run"));
    const Nanoseconds half = openGap(times) / 2;
    std::vector<std::pair<std::size_t, double>> found; // row, metres
    for (const std::size_t leap : leaps)
        found.emplace_back(search.rows()[leap], search.metresTo(leap));
    for (const auto &[row, metres] : found) {
        std::size_t count = 0;
        const Nanoseconds at = times[row];
        for (std::size_t i = 0; i < track.size(); ++i) {
            if (times[i] > at - half && times[i] < at + half && track.isMeasured(i)) {
                track.forget(i);
                ++count;
            }
        }
        how.notices.push_back(ODO_TEXT(
            "exchange.break_opened", "its positions jump by %1 in line %2 and go on from there: %3 positions "
                                     "around count as not measured, and the path ends at the jump")(
            quantity(metres, 2, "m"), track.lines[row], count));
    }
    return {};
}

} // namespace odo
