// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/noise_level.h"

#include <cmath>

namespace odo {

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
