// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/profile.h"

#include <array>
#include <cmath>

namespace odo {

namespace {

constexpr std::array<std::string_view, 9> names = {
    "jump", "speed_limit",     "acceleration_limit", "views_disagree", "low_score",
    "lost", "duplicate_frame", "interpolated",       "by_hand"};

} // namespace

std::string_view flagName(SampleFlag flag)
{
    for (std::size_t bit = 0; bit < names.size(); ++bit) {
        if (flagBit(flag) == (1u << bit))
            return names[bit];
    }
    return {};
}

std::string flagNames(SampleFlags flags)
{
    std::string joined;
    for (std::size_t bit = 0; bit < names.size(); ++bit) {
        if ((flags & (1u << bit)) == 0)
            continue;
        if (!joined.empty())
            joined += '|';
        joined += names[bit];
    }
    return joined;
}

void NoiseLevel::add(const std::vector<Sample> &samples)
{
    for (const Sample &sample : samples) {
        if (!sample.position)
            continue;
        m_variances += sample.covariance.trace();
        m_count += 2;
    }
}

double NoiseLevel::sigmaM() const
{
    return m_count > 0 ? std::sqrt(m_variances / m_count) : 0;
}

} // namespace odo
