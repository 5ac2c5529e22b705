// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <QTest>
#include <cmath>

namespace odo::test {

/// Red, green and blue in 0..255.
struct Colour
{
    double red, green, blue;
};

/// Full-range BT.601 in closed form (JFIF 1.02), unrounded.
struct Yuv
{
    double y, u, v;
};
inline Yuv closedForm(const Colour &colour)
{
    const double y = 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue;
    return {y, 128 + (colour.blue - y) / 1.772, 128 + (colour.red - y) / 1.402};
}

inline Colour between(const Colour &from, const Colour &to, double share)
{
    const auto mix = [share](double a, double b) { return a + (b - a) * share; };
    return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

inline const std::vector<Colour> flatColours{{0, 0, 0},     {255, 255, 255}, {255, 0, 0},
                                             {0, 255, 0},   {0, 0, 255},     {255, 255, 0},
                                             {26, 95, 208}, {215, 35, 40},   {128, 128, 128}};

/// Where a soft edge lies that crosses rows (or columns) of a plane, by the area beside it, between the
/// levels at their ends: one number for each that is not near the border, in the plane's own pixels.
inline std::vector<double> edgePositions(const PlaneView &plane, bool upright)
{
    std::vector<double> places;
    const int across = upright ? plane.width : plane.height, along = upright ? plane.height : plane.width;
    for (int line = 4; line < along - 4; ++line) {
        const auto at = [&](int i) {
            return static_cast<double>(upright ? plane.at(i, line) : plane.at(line, i));
        };
        const double before = at(0), after = at(across - 1);
        double area = 0;
        for (int i = 0; i < across; ++i)
            area += (after - at(i)) / (after - before);
        places.push_back(area - 0.5);
    }
    return places;
}

/// A smooth step from 0 to 1, some 8 pixels wide: so soft that its samples two pixels apart still tell its
/// place exactly.
inline double softStep(double x)
{
    return 1 / (1 + std::exp(-x / 1.2));
}

inline void compareWithin(const PlaneView &plane, double expected, double tolerance)
{
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            QVERIFY2(
                std::abs(plane.at(x, y) - expected) <= tolerance,
                qPrintable(
                    QStringLiteral("%1 at %2, %3 for %4").arg(plane.at(x, y)).arg(x).arg(y).arg(expected)));
}

} // namespace odo::test
