// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/trial_filter.h"

#include <QDateTime>
#include <QLocale>
#include <algorithm>

namespace odo {

namespace {

TrialFilter::Place placeOf(const TrialRecord &trial, const TrialFilter &filter)
{
    if (trial.binned)
        return TrialFilter::Place::Bin;
    const bool isOfArchived = filter.className.empty() && filter.archivedClasses.contains(trial.className);
    return trial.archived || isOfArchived ? TrialFilter::Place::Archived : TrialFilter::Place::Active;
}

} // namespace

QString searchTextOf(const TrialRecord &trial)
{
    // A line break keeps what stands in two fields from being found as one word.
    std::string words = trial.name + '\n' + trial.teamName + '\n' + trial.teamPseudonym + '\n' +
                        trial.className + '\n' + trial.task + '\n' + trial.notes;
    for (const std::string &robot : trial.robotNames)
        words += '\n' + robot;
    for (const std::string &tag : trial.tags)
        words += '\n' + tag;
    const QDateTime date = QDateTime::fromMSecsSinceEpoch(trial.date.time_since_epoch().count());
    return (QString::fromStdString(words) + u'\n' + QLocale().toString(date, QLocale::ShortFormat)).toLower();
}

bool isShown(const TrialFilter &filter, const QStringList &words, const TrialRecord &trial,
             const QString &searchText)
{
    if (placeOf(trial, filter) != filter.place || (filter.starred && !trial.starred))
        return false;
    if ((!filter.className.empty() && trial.className != filter.className) ||
        (!filter.team.empty() && trial.teamName != filter.team) ||
        (!filter.task.empty() && trial.task != filter.task))
        return false;
    if (!filter.robot.empty() && std::ranges::find(trial.robotNames, filter.robot) == trial.robotNames.end())
        return false;
    if ((filter.from && trial.date < *filter.from) || (filter.to && trial.date >= *filter.to))
        return false;
    return std::ranges::all_of(words, [&](const QString &word) { return searchText.contains(word); });
}

} // namespace odo
