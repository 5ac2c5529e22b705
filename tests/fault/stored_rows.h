// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <filesystem>

namespace odo::test {

/// Every value of every row of every table of a database, sorted; of moments (columns that end in "_ms") only
/// whether they are there. Empty where SQLite cannot read it or finds it damaged.
QStringList storedRows(const std::filesystem::path &file);

/// The first difference of two such lists, in words; empty: none.
QString firstDifference(const QStringList &expected, const QStringList &found);

} // namespace odo::test
