// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/internal/opening_check.h"

#include <cstdint>
#include <vector>

namespace odo {

/// "Odog" in the header of every project file (PRAGMA application_id), by which `file` and desktops can
/// identify it.
constexpr std::uint32_t projectApplicationId = 0x4f646f67;

/// All steps of the schema that docs/project_file.md describes.
std::vector<Migration> projectMigrations();

/// Runs them. Kept, because making the steps takes longer than to open a small project. Any thread.
const Migrator &projectMigrator();

} // namespace odo
