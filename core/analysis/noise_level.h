// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

#include <vector>

namespace odo {

/// The root mean square σ of a coordinate of all samples that were added, metres; 0 without a position.
class NoiseLevel
{
public:
    void add(const std::vector<Sample> &samples);
    double sigmaM() const;

private:
    double m_variances = 0, m_count = 0;
};

} // namespace odo
