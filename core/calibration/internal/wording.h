// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace odo {

/// "O, U and V", for messages; "none" of none.
std::string listed(const std::vector<std::string> &names);

/// "12.3 mm".
std::string millimetres(double metres);

/// How a registration is judged by the larger of its misfit and its σ, both in metres, against the extent of
/// its points: the verdict's first words, such as "Good: ".
std::string registrationGrade(double worseM, double extentM);

} // namespace odo
