// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/school_sync.h"

#include <QString>
#include <vector>

namespace odo {

/// A value that two versions of a row do not share, in words; empty: the version has none.
struct ConflictRow
{
    QString what, here, there;
};

/// What differs, at most 300 values. Two versions that differ only in what nobody reads (samples) give one
/// row that says so. Names of pupils are hidden where pseudonyms are shown.
std::vector<ConflictRow> conflictRows(const SchoolConflict &conflict);

} // namespace odo
