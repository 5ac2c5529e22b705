// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// A column of numbers with its unit.
struct UnitColumn
{
    std::size_t index = 0;
    double unit = 1; ///< in seconds or metres
};

/// Where the columns of one track lie.
struct TrackColumns
{
    std::string name; ///< may be empty
    UnitColumn x, y;
    std::optional<UnitColumn> sigmaX, sigmaY;
};

/// What the header of a table of tracks says.
struct TrackHeader
{
    UnitColumn time;
    std::vector<TrackColumns> tracks; ///< at least one
    std::size_t columns = 0;          ///< of them all
    bool hasUnits = false;            ///< of the time or a place, but for `xNAME`
};

/// Reads a header: a time (t, time, timestamp) and pairs of x and y, perhaps sigma_x and sigma_y; each with its unit as
/// `x_mm`, `x [m]`, `x (cm)`, `x/m`, or none (s, m); of more tracks `xNAME` and `yNAME`, or the names in the line above. Other columns are
/// passed over. nullopt: it is no such header. The Error is the reason alone, of a unit that is not known.
std::optional<Result<TrackHeader>> readTrackHeader(const std::vector<std::string_view> &cells,
                                                   const std::vector<std::string_view> &namesAbove);

} // namespace odo
