// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <functional>
#include <vector>

namespace odo::test {

/// A robot on a circle of 500 mm round (1500 mm, 1000 mm), two laps in 12 s: 0.5236 m/s, 360 positions
/// measured to 1.5 mm.
struct DrivenRun
{
    struct Row
    {
        double t = 0, x = 0, y = 0; ///< s, m; NaN: not measured
        double confidence = 0.99;
    };
    std::vector<Row> rows;
    static constexpr double rate = 30, speedMps = 0.5235987755982988, radiusM = 0.5;
    static DrivenRun made(unsigned seed);
};

/// How a program writes it.
struct TrackStyle
{
    const char *name;
    std::function<QByteArray(const DrivenRun &)> write;
    std::function<QByteArray(const DrivenRun &)> withoutUnits; ///< empty: the style has none to leave out
    bool hasFrames = false;                                    ///< in place of times
    double pixelM = 0;                                         ///< above zero: positions are so many metres
    bool isTold = true;                                        ///< of pixels: that they are
};
const std::vector<TrackStyle> &trackStyles();

} // namespace odo::test
