// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace odo::test {

/// What a simulated camera can do besides the least.
struct GenicamAbilities
{
    bool timestampLatch = true; ///< its clock can be read
    bool automatics = false;    ///< has ExposureAuto and GainAuto
};

/// The GenICam file (EMVA, GenICam 2.1.1; names by its SFNC 2.7) that describes the registers of
/// gige_registers.h.
std::string genicamDescription(const GenicamAbilities &abilities);

} // namespace odo::test
