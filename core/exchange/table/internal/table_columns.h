// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/exchange/table/track_reading.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

struct LengthColumn
{
    std::size_t index = 0;
    std::optional<LengthUnit> unit; ///< as the header says it
};

/// Where the columns of one track are.
struct TrackColumns
{
    struct Angle
    {
        std::size_t index = 0;
        double radPerUnit = 1;
    };
    std::string name; ///< may be empty
    LengthColumn x, y;
    std::optional<LengthColumn> z = {}, sigmaX = {}, sigmaY = {};
    std::optional<Angle> heading = {};
    std::optional<std::array<std::size_t, 4>> quaternion = {}; ///< x, y, z, w
    std::optional<std::size_t> confidence = {};
};

/// What a header says, or what a format without one has.
struct TableColumns
{
    struct Time
    {
        std::size_t index = 0;
        std::optional<TimeUnit> unit;           ///< as the header or the format says it
        std::optional<std::size_t> nanoseconds; ///< of ROS: they go in addition to whole seconds
    };
    struct LostFlag
    {
        std::size_t index = 0;
        bool isLostIfTrue = true;
    };
    TrackFormat format = TrackFormat::Csv;
    std::optional<Time> time;         ///< empty: rows come at a rate
    std::vector<TrackColumns> tracks; ///< at least one
    std::optional<std::size_t> id;    ///< of the track that a row belongs to
    std::optional<LostFlag> lost;
    std::size_t columns = 0;     ///< of them all
    bool mayHaveUnnamed = false; ///< the header ends with a delimiter; rows may have a cell behind it
    bool hasUnits = false;       ///< the time or a position
    bool areAssumed = false;     ///< there is no header: the first may be times, the others x and y
};

/// Reads a header by the names of its columns (ColumnName), with the row above for the names of tracks.
/// nullopt: it is no header of tracks. The Error is the reason alone, of a unit that is not known.
std::optional<Result<TableColumns>> tableColumnsOf(const std::vector<std::string_view> &cells,
                                                   const std::vector<std::string_view> &namesAbove);

/// Of a header, the column of times or, failing it, of frame numbers, found by the same names. nullopt: it
/// has none. The Error as above.
std::optional<Result<TableColumns::Time>> timeColumnOf(const std::vector<std::string_view> &cells);

/// Of lines of `timestamp tx ty tz qx qy qz qw`, and of the twelve numbers of a KITTI pose.
TableColumns tumColumns();
TableColumns kittiColumns();
/// Of a TRC file: its line of markers (Frame#, Time and the names), and the unit in its head.
std::optional<TableColumns> trcColumns(const std::vector<std::string_view> &markers, std::string_view unit);

} // namespace odo
