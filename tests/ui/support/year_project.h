// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>

namespace odo::test {

/// Makes a project in a folder: so many trials of 1800 samples and two views, a minute apart, of 24 teams in
/// four classes and six tasks, every one a copy of the same analysed trial (its observations are left out),
/// with tags and notes that differ. All share two short videos. Written in one transaction without a log,
/// which is fast and safe against nothing.
Result<std::filesystem::path> makeYearProject(const std::filesystem::path &folder, int trials);

constexpr const char *yearProjectName = "year.odo";
constexpr int samplesOfATrial = 1800;

} // namespace odo::test
