// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/lost_marks.h"

#include "core/base/units.h"
#include "core/exchange/table/internal/course.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double farSteps = 5;           // usual steps that no robot leaps
constexpr double heldSteps = 4;          // that it has gone on while its position was held
constexpr double heldResolutions = 3;    // what a hold is above the rounding of the numbers
constexpr double noisyResolutions = 2.5; // five positions in a row are then the same once in a million
constexpr std::size_t leastHeld = 3, leastHeldInNoise = 5;
constexpr auto restsApart = std::chrono::seconds(1); // less than the gaps that are bridged

/// Measured rows one behind the other with the same position.
struct Run
{
    std::size_t first = 0, last = 0; ///< places in the measured rows
    std::size_t size() const { return last - first + 1; }
};

std::vector<Run> runsOf(const RawTrack &track, const std::vector<std::size_t> &rows)
{
    std::vector<Run> runs;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!runs.empty() && distanceOf(track, rows[i], rows[runs.back().first]) == 0)
            runs.back().last = i;
        else
            runs.push_back({i, i});
    }
    return runs;
}

bool isMark(double x, double y)
{
    constexpr std::array<double, 8> marks{0, -1, -99, -999, -9999, 9999, 99999, -32768};
    return x == y && std::ranges::find(marks, x) != marks.end();
}

void say(std::vector<Message> &notices, const RawTrack &track, const std::vector<std::size_t> &forgotten,
         const MessageText &words)
{
    if (!forgotten.empty())
        notices.push_back(words(forgotten.size(), track.lines[forgotten.front()]));
}

/// Whether a run is where the robot rested: it goes on from there, and came there, no quicker than the noise
/// is. What a tracker sees of a robot that rests may well be the same in every frame.
bool isRest(const RawTrack &track, const std::vector<std::size_t> &rows, const Run &run,
            const CourseFacts &course)
{
    constexpr double mostNoise = 5;
    constexpr std::size_t before = 5; // rows that say how quick it was
    const double most = mostNoise * course.noise + course.resolution;
    if (run.last + 1 < rows.size())
        return distanceOf(track, rows[run.last], rows[run.last + 1]) <= most;
    if (run.first < before)
        return true;
    return distanceOf(track, rows[run.first], rows[run.first - before]) <= most;
}

} // namespace

Result<void> forgetUnsure(RawTrack &track, Understanding &how)
{
    constexpr double usual = 0.6, mostOfShare = 1.5, mostOfPercent = 100, percent = 100;
    if (track.confidence.empty()) {
        if (how.reading.minConfidence)
            return how.wrong(0, ODO_TEXT("exchange.no_confidence", "it has no column of confidences"),
                             ODO_TEXT("exchange.leave_out_confidence", "leave out the least confidence"));
        return {};
    }
    float low = 0, high = 0;
    for (const float value : track.confidence) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    double least = how.reading.minConfidence.value_or(usual);
    const bool isShare = low >= 0 && high <= mostOfShare;
    const bool isPercent = low >= 0 && high > mostOfShare && high <= mostOfPercent;
    if (isPercent && least <= 1)
        least *= percent;
    if (!how.reading.minConfidence && !isShare && !isPercent) {
        how.notices.push_back(
            ODO_TEXT("exchange.confidence_not_used",
                     "its confidences are neither from 0 to 1 nor from 0 to 100, and were not used"));
        return {};
    }
    std::vector<std::size_t> forgotten;
    const std::vector<std::size_t> rows = measuredRows(track);
    for (const std::size_t row : rows) {
        if (static_cast<double>(track.confidence[row]) < least) {
            track.forget(row);
            forgotten.push_back(row);
        }
    }
    if (!rows.empty() && forgotten.size() == rows.size())
        return how.wrong(0,
                         ODO_TEXT("exchange.none_sure_enough",
                                  "none of its positions has a confidence of %1")(quantity(least, 2)),
                         ODO_TEXT("exchange.give_lower_confidence", "give a lower least confidence"));
    if (!forgotten.empty())
        how.notices.push_back(ODO_TEXT("exchange.unsure_left_out",
                                       "%1 positions with a confidence below %2 count as not measured; the "
                                       "first is in line %3")(forgotten.size(), quantity(least, 2),
                                                              track.lines[forgotten.front()]));
    return {};
}

void forgetMarks(RawTrack &track, Understanding &how)
{
    const std::vector<std::size_t> rows = measuredRows(track);
    if (rows.size() < enoughForCourse)
        return;
    std::vector<double> steps;
    std::optional<std::size_t> before; // every other row may be a mark
    for (const std::size_t row : rows) {
        if (isMark(track.x[row], track.y[row]))
            continue;
        if (before && distanceOf(track, row, *before) > 0)
            steps.push_back(distanceOf(track, row, *before));
        before = row;
    }
    const double far = farSteps * percentileOf(std::move(steps), 75);
    std::vector<std::size_t> forgotten;
    for (const Run &run : runsOf(track, rows)) {
        const std::size_t row = rows[run.first];
        if (far == 0 || !isMark(track.x[row], track.y[row]))
            continue;
        const bool hasBefore = run.first > 0, hasBehind = run.last + 1 < rows.size();
        const bool leapsIn = hasBefore && distanceOf(track, rows[run.first - 1], row) > far;
        const bool leapsOut = hasBehind && distanceOf(track, rows[run.last + 1], row) > far;
        if (run.size() > 1 ? leapsIn || leapsOut : (leapsIn || !hasBefore) && (leapsOut || !hasBehind))
            for (std::size_t i = run.first; i <= run.last; ++i)
                forgotten.push_back(rows[i]);
    }
    say(how.notices, track, forgotten,
        ODO_TEXT(
            "exchange.marks_left_out",
            "%1 positions that only mark a lost robot (such as 0, 0) count as not measured; the first is "
            "in line %2"));
    for (const std::size_t row : forgotten)
        track.forget(row);
}

void forgetHeld(RawTrack &track, const std::vector<Nanoseconds> &times, Understanding &how)
{
    const std::vector<std::size_t> rows = measuredRows(track);
    const CourseFacts course = courseOf(track);
    if (course.usualStep == 0)
        return;
    // A log that is quicker than what it logs repeats positions all the time.
    constexpr double mostRepeats = 0.25;
    const bool isCoarseLog = course.repeats > mostRepeats && course.repeatRuns * 10 > rows.size() &&
                             course.usualStep > heldResolutions * course.resolution;
    const bool isNoisy = course.noise > noisyResolutions * course.resolution;
    std::vector<std::size_t> forgotten;
    for (const Run &run : runsOf(track, rows)) {
        if (run.size() == 1 || (run.first == 0 && run.last + 1 == rows.size()))
            continue;
        const double leap =
            run.last + 1 < rows.size() ? distanceOf(track, rows[run.last], rows[run.last + 1]) : 0;
        const bool goesOn = run.size() >= leastHeld && leap > heldSteps * course.usualStep &&
                            leap > heldResolutions * course.resolution;
        const bool isHeld = isNoisy && run.size() >= leastHeldInNoise;
        if (!isCoarseLog && !goesOn && !isHeld)
            continue;
        const bool rests = !isCoarseLog && !goesOn && isRest(track, rows, run, course);
        std::size_t kept = run.first;
        for (std::size_t i = run.first + 1; i <= run.last; ++i) {
            if (rests && times[rows[i]] - times[rows[kept]] >= restsApart)
                kept = i;
            else
                forgotten.push_back(rows[i]);
        }
    }
    say(how.notices, track, forgotten,
        ODO_TEXT(
            "exchange.held_left_out",
            "%1 positions that only repeat the last one count as not measured; the first is in line %2"));
    for (const std::size_t row : forgotten)
        track.forget(row);
}

} // namespace odo
