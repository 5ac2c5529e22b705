// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/track_reading.h"

#include <array>
#include <cstddef>

namespace odo {

namespace {

constexpr std::array<std::string_view, 6> lengthWords{"m", "cm", "mm", "px", "in", "ft"};
constexpr std::array<std::string_view, 8> timeWords{"s", "ms", "us", "ns", "frame", "min", "h", "d"};
constexpr std::array<std::string_view, 3> axesWords{"xy", "xz", "yz"};
constexpr std::array<std::string_view, 2> decimalWords{"point", "comma"};

template <class Enum, std::size_t count>
std::optional<Enum> valueOf(const std::array<std::string_view, count> &words, std::string_view word)
{
    for (std::size_t i = 0; i < count; ++i) {
        if (words[i] == word)
            return static_cast<Enum>(i);
    }
    return std::nullopt;
}

struct Names
{
    std::string_view word, name;
};
constexpr std::array<Names, 11> formats{{{"tum", "TUM"},
                                         {"csv", "CSV"},
                                         {"tracker", "Tracker"},
                                         {"euroc", "EuRoC"},
                                         {"kitti", "KITTI"},
                                         {"rosbag", "ROS"},
                                         {"kinovea", "Kinovea"},
                                         {"trex", "TRex"},
                                         {"deeplabcut", "DeepLabCut"},
                                         {"sleap", "SLEAP"},
                                         {"trc", "TRC"}}};

} // namespace

std::string_view wordOf(LengthUnit unit)
{
    return lengthWords[static_cast<std::size_t>(unit)];
}

std::string_view wordOf(TimeUnit unit)
{
    return timeWords[static_cast<std::size_t>(unit)];
}

std::string_view wordOf(FloorAxes axes)
{
    return axesWords[static_cast<std::size_t>(axes)];
}

std::string_view wordOf(DecimalSign sign)
{
    return decimalWords[static_cast<std::size_t>(sign)];
}

std::optional<LengthUnit> lengthUnitOf(std::string_view word)
{
    return valueOf<LengthUnit>(lengthWords, word);
}

std::optional<TimeUnit> timeUnitOf(std::string_view word)
{
    return valueOf<TimeUnit>(timeWords, word);
}

std::optional<FloorAxes> floorAxesOf(std::string_view word)
{
    return valueOf<FloorAxes>(axesWords, word);
}

std::optional<DecimalSign> decimalSignOf(std::string_view word)
{
    return valueOf<DecimalSign>(decimalWords, word);
}

long double nanosecondsPer(TimeUnit unit)
{
    constexpr std::array<long double, 8> lengths{1e9L, 1e6L, 1e3L, 1, 0, 60e9L, 3600e9L, 86400e9L};
    return lengths[static_cast<std::size_t>(unit)];
}

double perMetre(LengthUnit unit)
{
    constexpr std::array<double, 6> counts{1, 100, 1000, 0, 1 / 0.0254, 1 / 0.3048};
    return counts[static_cast<std::size_t>(unit)];
}

std::string_view trackFormatWord(TrackFormat format)
{
    return formats[static_cast<std::size_t>(format)].word;
}

std::string_view trackFormatName(TrackFormat format)
{
    return formats[static_cast<std::size_t>(format)].name;
}

} // namespace odo
