// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/wording.h"

#include "core/base/units.h"

#include <algorithm>

namespace odo {

std::string listed(const std::vector<std::string> &names)
{
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0)
            text += i + 1 == names.size() ? " and " : ", ";
        text += names[i];
    }
    return names.empty() ? "none" : text;
}

std::string millimetres(double metres)
{
    return formatNumber(toMillimetres(metres), 1) + " mm";
}

std::string registrationGrade(double worseM, double extentM)
{
    return worseM <= std::max(0.005, 0.0025 * extentM)   ? "Good: "
           : worseM <= std::max(0.015, 0.0075 * extentM) ? "Usable: "
                                                         : "Poor, measure the markers again: ";
}

} // namespace odo
