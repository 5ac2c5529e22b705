// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/trimmed_outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double leastTrimmed = 0.4;  // share of the outlines
constexpr double scoreOfWhole = 0.25; // too little to learn from, enough to be measured by
constexpr double doubtRadii = 0.08;   // of where the outline's middle is

} // namespace

void doubtUntrimmed(const std::vector<std::vector<Observation> *> &views)
{
    double trimmed = 0, all = 0;
    for (const auto *view : views) {
        for (const Observation &one : *view) {
            all += one.found ? 1 : 0;
            trimmed += one.found && one.isTrimmed ? 1 : 0;
        }
    }
    if (trimmed < leastTrimmed * all)
        return;
    for (auto *view : views) {
        for (Observation &one : *view) {
            if (!one.found || one.isTrimmed)
                continue;
            const double doubtPx2 = doubtRadii * doubtRadii * one.areaPx / std::numbers::pi;
            one.score = std::min(one.score, scoreOfWhole);
            one.centreCovariancePx2 += Eigen::Matrix2d::Identity() * doubtPx2;
        }
    }
}

} // namespace odo
