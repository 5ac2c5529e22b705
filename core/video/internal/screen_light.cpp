// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/screen_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

constexpr double peakNits = 1000, whiteNits = 203;

/// Light of a code value from 0 to 1, in cd/m² of the screen that it was meant for, grey taken.
double nitsOfHybridLogGamma(double code)
{
    constexpr double a = 0.17883277, b = 1 - 4 * a, systemGamma = 1.2;
    const double c = 0.5 - a * std::log(4 * a);
    const double scene = code <= 0.5 ? code * code / 3 : (std::exp((code - c) / a) + b) / 12;
    return peakNits * std::pow(scene, systemGamma);
}

double nitsOfPerceptualQuantizer(double code)
{
    constexpr double m1 = 2610.0 / 16384, m2 = 2523.0 / 32, c1 = 3424.0 / 4096, c2 = 2413.0 / 128,
                     c3 = 2392.0 / 128;
    const double root = std::pow(code, 1 / m2);
    return 10000 * std::pow(std::max(root - c1, 0.0) / (c2 - c3 * root), 1 / m1);
}

/// Of a grey from black to white and beyond; 1 is the screen's white.
double toneOf(double light)
{
    constexpr double brightest = peakNits / whiteNits;
    return light * (1 + light / (brightest * brightest)) / (1 + light);
}

/// IEC 61966-2-1.
double screenCode(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

struct Tables
{
    static constexpr std::size_t codes = 256, steps = 4096;
    std::array<float, codes> light{}; ///< of a channel; 1 is white
    std::array<float, codes> gain{};  ///< of all channels, by the luma of the pixel

    explicit Tables(double (*nitsOf)(double))
    {
        for (std::size_t i = 0; i < codes; ++i) {
            const double is = nitsOf(double(i) / (codes - 1)) / whiteNits;
            light[i] = float(is);
            gain[i] = float(is > 0 ? toneOf(is) / is : 1);
        }
    }
};

const Tables &tablesOf(Transfer transfer)
{
    static const Tables logGamma(&nitsOfHybridLogGamma), quantizer(&nitsOfPerceptualQuantizer);
    return transfer == Transfer::HybridLogGamma ? logGamma : quantizer;
}

std::uint32_t encoded(float light)
{
    static const auto table = [] {
        std::array<std::uint8_t, Tables::steps> codes{};
        for (std::size_t i = 0; i < codes.size(); ++i)
            codes[i] = std::uint8_t(std::lround(255 * screenCode(double(i) / (Tables::steps - 1))));
        return codes;
    }();
    return table[std::size_t(std::clamp(light, 0.0F, 1.0F) * (Tables::steps - 1))];
}

} // namespace

void mapToScreen(std::span<std::uint32_t> pixels, Transfer transfer)
{
    if (transfer == Transfer::Standard)
        return;
    const Tables &tables = tablesOf(transfer);
    for (std::uint32_t &pixel : pixels) {
        const std::uint32_t red = pixel >> 16 & 0xff, green = pixel >> 8 & 0xff, blue = pixel & 0xff;
        const float gain = tables.gain[(67 * red + 174 * green + 15 * blue) >> 8]; // luma of BT.2020
        const float r = gain * tables.light[red], g = gain * tables.light[green],
                    b = gain * tables.light[blue];
        pixel = 0xff000000U | encoded(1.6605F * r - 0.5876F * g - 0.0728F * b) << 16 |
                encoded(-0.1246F * r + 1.1329F * g - 0.0083F * b) << 8 |
                encoded(-0.0182F * r - 0.1006F * g + 1.1187F * b);
    }
}

} // namespace odo
