// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace odo::test {

/// From a moment on, this much light; a course begins with light 1.
struct LightStep
{
    double timeS = 0, light = 1;
};

/// How a camera sees the light of a room.
struct LightFilm
{
    double startS = 0, durationS = 10, framesPerSecond = 30;
    double exposureS = 0.01; ///< of the whole picture: with the read-out, where the shutter rolls
    double noise = 0.001;    ///< of the level
    double gamma = 1;        ///< code = light^(1/gamma)
    double driftPpm = 0;     ///< of its clock
    std::function<double(double timeS)> gain; ///< of an automatic exposure or the sun; empty: none
};

inline double meanLight(const std::vector<LightStep> &steps, double fromS, double toS)
{
    double sum = 0, light = 1, at = fromS;
    for (const LightStep &step : steps) {
        const double until = std::clamp(step.timeS, at, toS);
        sum += light * (until - at);
        at = until;
        light = step.light;
    }
    return (sum + light * (toS - at)) / (toS - fromS);
}

/// The levels that a view of the room gives, by its own clock.
inline std::vector<LightLevel> filmLight(const std::vector<LightStep> &steps, const LightFilm &film,
                                         std::mt19937 &random)
{
    std::normal_distribution<double> noise(0, film.noise);
    std::vector<LightLevel> levels;
    double last = 0;
    for (int i = 0; i < static_cast<int>(film.durationS * film.framesPerSecond); ++i) {
        const double own = i / film.framesPerSecond, t = film.startS + own / (1 + film.driftPpm * 1e-6);
        double level =
            std::pow(meanLight(steps, t - film.exposureS / 2, t + film.exposureS / 2), 1 / film.gamma);
        if (film.gain)
            level *= film.gain(t);
        level *= 1 + noise(random);
        // Samples of about 100 code values: beyond 4 % nearly all of them change noticeably.
        const double share = i == 0 ? 0 : std::clamp((level / last - 1) / 0.04, -1.0, 1.0);
        levels.push_back({fromSeconds(own), level, share});
        last = level;
    }
    return levels;
}

} // namespace odo::test
