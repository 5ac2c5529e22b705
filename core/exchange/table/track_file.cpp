// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/track_file.h"

#include "core/exchange/table/internal/course.h"
#include "core/exchange/table/internal/lost_marks.h"
#include "core/exchange/table/internal/table_reader.h"
#include "core/exchange/table/internal/track_breaks.h"
#include "core/exchange/table/internal/track_scale.h"
#include "core/exchange/table/internal/track_times.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double mostM = 100e3;
constexpr std::size_t leastPositions = 3;

Message positionsOf(const std::string &track, std::size_t count)
{
    if (track.empty())
        return count == 1 ? ODO_TEXT("exchange.track_has_position", "the track has %1 position")(count)
                          : ODO_TEXT("exchange.track_has_positions", "the track has %1 positions")(count);
    return count == 1
               ? ODO_TEXT("exchange.named_track_has_position", "track '%1' has %2 position")(track, count)
               : ODO_TEXT("exchange.named_track_has_positions", "track '%1' has %2 positions")(track, count);
}

Message chooseLongerTrack()
{
    return ODO_TEXT("exchange.choose_longer_track", "choose a file with three positions or more");
}

/// How many of the file's units make a metre.
struct Scale
{
    double position = 1, sigmaX = 1, sigmaY = 1;
};

Scale scaleOf(const RawTrack &track, double unitsPerMetre)
{
    const auto ofSigma = [&](const std::optional<LengthColumn> &column) {
        return column && column->unit && *column->unit != LengthUnit::Pixel ? perMetre(*column->unit)
                                                                            : unitsPerMetre;
    };
    return {unitsPerMetre, ofSigma(track.columns.sigmaX), ofSigma(track.columns.sigmaY)};
}

/// Refuses what no robot's track has; keeps the rest as it is.
Result<std::vector<ImportedPosition>> positionsFrom(const RawTrack &track,
                                                    const std::vector<Nanoseconds> &times, const Scale &scale,
                                                    const Understanding &how)
{
    std::vector<ImportedPosition> positions;
    positions.reserve(track.size());
    for (std::size_t i = 0; i < track.size(); ++i) {
        ImportedPosition &one = positions.emplace_back(ImportedPosition{times[i], {}, {}, {}});
        if (!track.isMeasured(i))
            continue;
        // A quotient is rounded once: 0.1 is not 100 times 0.001.
        one.position = ImportedPosition::Pair(track.x[i] / scale.position, track.y[i] / scale.position);
        if (one.position->cwiseAbs().maxCoeff() > mostM)
            return how.wrong(
                track.lines[i], ODO_TEXT("exchange.place_too_far", "its position is more than 100 km away"),
                ODO_TEXT("exchange.check_unit_of_places", "check the unit of the positions: m, cm or mm"));
        if (!track.sigmas.empty() && std::isfinite(track.sigmas[i][0]))
            one.sigmaM =
                ImportedPosition::Pair(track.sigmas[i][0] / scale.sigmaX, track.sigmas[i][1] / scale.sigmaY);
        if (!track.headings.empty() && std::isfinite(track.headings[i]))
            one.headingRad = track.headings[i];
    }
    return positions;
}

/// What the numbers were rounded to where the robot often stays within it, so that the error is the same from
/// row to row and no scatter; else 0.
double coarseRounding(const CourseFacts &course)
{
    constexpr double leastRepeats = 0.1, mostStep = 2;
    return course.repeats > leastRepeats && course.usualStep <= mostStep * course.resolution
               ? course.resolution
               : 0;
}

/// From the rows of the file to positions on the floor.
Result<FileTrack> understood(RawTrack raw, const RawTable &table, Understanding how)
{
    const TrackFormat format = table.columns.format;
    if (table.columns.areAssumed)
        how.facts.push_back(
            ODO_TEXT("exchange.columns_assumed", "it has no header: its columns count as time, x and y"));
    if (table.thousands != 0)
        how.facts.push_back(table.thousands == '.'
                                ? ODO_TEXT("exchange.points_group_thousands", "points separate thousands")
                                : ODO_TEXT("exchange.commas_group_thousands", "commas separate thousands"));
    if (table.unreadable == 1)
        how.notices.push_back(
            ODO_TEXT("exchange.row_without_time",
                     "line %1 was left out, because it has no time")(table.firstUnreadable));
    else if (table.unreadable > 1)
        how.notices.push_back(ODO_TEXT("exchange.rows_without_time",
                                       "%1 lines were left out, because they have no time; the first is line "
                                       "%2")(table.unreadable, table.firstUnreadable));
    if (table.cutLine > 0)
        how.notices.push_back(
            ODO_TEXT("exchange.cut_line_left_out",
                     "the last line, line %1, was left out, because it ends too early")(table.cutLine));
    makeOneUnit(raw);
    const auto times = ODO_TRY(timesOf(raw, table, how));
    ODO_TRY(forgetUnsure(raw, how));
    ODO_TRY(chooseAxes(raw, format, how));
    forgetMarks(raw, how);
    forgetHeld(raw, times, how);
    const double perMetre = ODO_TRY(unitsPerMetre(raw, format, times, how));
    ODO_TRY(openBreaks(raw, times, perMetre, how));
    FileTrack track{raw.name, ODO_TRY(positionsFrom(raw, times, scaleOf(raw, perMetre), how))};
    track.roundedM = coarseRounding(courseOf(raw)) / perMetre;
    track.facts = std::move(how.facts);
    track.notices = std::move(how.notices);
    return track;
}

/// Tracks without a position are passed over, unless it is the only one.
Result<void> checkLengths(std::vector<FileTrack> &tracks, const Understanding &how, int lastLine)
{
    const auto count = [](const FileTrack &track) {
        return static_cast<std::size_t>(std::ranges::count_if(
            track.positions, [](const ImportedPosition &one) { return one.position.has_value(); }));
    };
    for (const FileTrack &track : tracks) {
        const std::size_t positions = count(track);
        if (positions < leastPositions && (tracks.size() == 1 || positions > 0))
            return how.wrong(lastLine, positionsOf(track.name, positions), chooseLongerTrack());
    }
    std::erase_if(tracks, [&](const FileTrack &track) { return count(track) == 0; });
    if (tracks.empty())
        return how.wrong(lastLine,
                         ODO_TEXT("exchange.no_track_has_position", "none of its tracks has a position"),
                         chooseLongerTrack());
    return {};
}

/// Several tracks must be told apart.
void nameTracks(std::vector<RawTrack> &tracks)
{
    if (tracks.size() < 2)
        return;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        const auto isSame = [&](const RawTrack &other) {
            return &other != &tracks[i] && other.name == tracks[i].name;
        };
        if (tracks[i].name.empty() || std::ranges::any_of(tracks, isSame))
            tracks[i].name += (tracks[i].name.empty() ? "" : " ") + std::to_string(i + 1);
    }
}

} // namespace

Result<TrackFile> readTrackFile(const std::filesystem::path &file, const TrackReading &reading,
                                const JobControl &control)
{
    auto table = ODO_TRY(readRawTable(file, reading, control));
    const Understanding how{file, reading, {}, {}};
    nameTracks(table.tracks);
    TrackFile result{table.columns.format, {}};
    for (RawTrack &raw : table.tracks) {
        auto track = ODO_TRY(understood(std::move(raw), table, how));
        result.tracks.push_back(std::move(track));
    }
    ODO_TRY(checkLengths(result.tracks, how, table.lastLine));
    return result;
}

} // namespace odo
