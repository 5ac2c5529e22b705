// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/internal/stamps.h"
#include "core/exchange/table/internal/table_columns.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace odo {

/// The rows of one track as the file has them, in its units; NaN: not measured or not there. What a file does
/// not have is an empty vector, all others have a value a row. Plain value.
struct RawTrack
{
    std::string name;
    TrackColumns columns;
    Stamp::Kind stampKind = Stamp::Kind::Number;
    std::vector<int> lines;
    std::vector<long double> stamps;
    std::vector<double> x, y, z;
    std::vector<float> confidence;
    std::vector<std::array<double, 2>> sigmas; ///< NaN: not stated
    std::vector<double> headings;              ///< radians

    std::size_t size() const { return lines.size(); }
    void addRow(const RawTrack &from, std::size_t row);
    /// Takes out the rows that are marked; one mark a row.
    void remove(const std::vector<bool> &marked);
    void forget(std::size_t row); ///< that anything was measured in it
    bool isMeasured(std::size_t row) const { return x[row] == x[row] && y[row] == y[row]; }
};

struct RawTable
{
    TableColumns columns;
    std::vector<RawTrack> tracks;
    std::size_t unreadable = 0; ///< rows without a time that can be read
    int firstUnreadable = 0;    ///< their first line
    int lastLine = 0;           ///< of the file
    int cutLine = 0;            ///< the last row, where it ends too early and was left out; 0: it does not
    bool isTracker = false;
    char thousands = 0; ///< what parts them in its numbers; 0: nothing
};

} // namespace odo
