// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace odo {

/// Who writes a file of finished tracks; docs/formats.md.
enum class TrackFormat { Tum, Csv, Tracker, Euroc, Kitti, RosBag, Kinovea, Trex, DeepLabCut, Sleap, Trc };

/// "tum", "csv", "tracker", "euroc", ...
std::string_view trackFormatWord(TrackFormat format);
/// As it is called: "TUM", "Tracker", "EuRoC", ...
std::string_view trackFormatName(TrackFormat format);

enum class LengthUnit { Metre, Centimetre, Millimetre, Pixel, Inch, Foot };
enum class TimeUnit { Second, Millisecond, Microsecond, Nanosecond, Frame, Minute, Hour, Day };
/// Which two coordinates of a table span the floor; the first becomes x and the second y.
enum class FloorAxes { Xy, Xz, Yz };
enum class DecimalSign { Point, Comma };

/// "m", "cm", "mm", "px", "in", "ft"; "s", "ms", "us", "ns", "frame", "min", "h", "d"; "xy", "xz", "yz";
/// "point", "comma". nullopt: none.
std::string_view wordOf(LengthUnit unit);
std::string_view wordOf(TimeUnit unit);
std::string_view wordOf(FloorAxes axes);
std::string_view wordOf(DecimalSign sign);
std::optional<LengthUnit> lengthUnitOf(std::string_view word);
std::optional<TimeUnit> timeUnitOf(std::string_view word);
std::optional<FloorAxes> floorAxesOf(std::string_view word);
std::optional<DecimalSign> decimalSignOf(std::string_view word);

/// How many nanoseconds make the unit; 0: a frame.
long double nanosecondsPer(TimeUnit unit);
/// How many of them make a metre; 0: a pixel.
double perMetre(LengthUnit unit);

/// What a person says of a table of tracks. What is left empty is read from the file, or asked by an error.
/// Plain value.
struct TrackReading
{
    std::optional<LengthUnit> unit;
    std::optional<TimeUnit> timeUnit;
    std::optional<FloorAxes> axes;
    std::optional<DecimalSign> decimal;
    std::optional<double> minConfidence; ///< positions below it are not measured
    std::optional<double> rate;          ///< frames a second, where the file has only their numbers
    std::optional<double> pixelM;        ///< metres a pixel
    std::filesystem::path shownAs = {};  ///< what messages call the file; empty: its path
};

} // namespace odo
