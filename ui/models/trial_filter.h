// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QString>
#include <QStringList>
#include <optional>
#include <set>

namespace odo {

/// Which trials of a list are shown. Everything that is set must hold.
struct TrialFilter
{
    enum class Place { Active, Archived, Bin };
    /// Each of its words must occur in what a person would look for; upper and lower case count as the same.
    QString text;
    std::string className, team, task, robot; ///< by name; empty: any
    std::set<std::string> archivedClasses;    ///< whose trials count as archived unless the class is chosen by name
    bool starred = false;                     ///< only those
    Place place = Place::Active;
    std::optional<Instant> from, to; ///< from included, to excluded
};

/// What a person would look for in a trial, in lower case: names, pseudonym, date, notes, tags.
QString searchTextOf(const TrialRecord &trial);

/// words: of the filter's text, in lower case; searchText: searchTextOf the trial.
bool isShown(const TrialFilter &filter, const QStringList &words, const TrialRecord &trial,
             const QString &searchText);

} // namespace odo
