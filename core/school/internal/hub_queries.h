// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/hub_results.h"

#include <QString>
#include <QVariantList>
#include <cstdint>
#include <string>

namespace odo {

/// A question to the hub: a statement and the values of its ?, in order.
struct HubQuery
{
    QString text;
    QVariantList values = {};
};

/// All that the program asks a hub for, in one file: what is here is what tests/school/tst_hub_size measures
/// with a million trials. Of an empty class: of all.
namespace hubQueries {

/// A number that is another one after each change of results.
HubQuery resultState();
/// Each robot's run of a task, in the order of time: trial, robot, shown_team, class, held in ms, standing;
/// and unit, value, sigma, at_least of the metric, NULL where it has none.
HubQuery standings(const StandingsChoice &choice);
/// The task of the newest trial that has one.
HubQuery newestTask(const std::string &className);
/// The names of the metrics of the newest two hundred runs of a task.
HubQuery metricNames(const StandingsChoice &choice);

/// Where a text is searched. InNewest: among the newest twenty thousand runs of those that are asked for,
/// which is quick for what is frequent; InAll: by its trigrams, which is quick for what is rare. The server
/// cannot choose: where row security is on it takes every text as rare.
enum class TextSearch { InNewest, InAll };
/// The newest runs first: trial, robot, name (empty without names), shown_team, class, task, held in ms,
/// duration_s, standing; unit, value, sigma, at_least of the metric, NULL where it has none; and owner (empty
/// without names). after: the last one of the page before; null: the first page.
HubQuery runs(const HubRunFilter &filter, TextSearch search, bool withNames, const HubRun *after, int most);

/// The logins that published runs, without a look at each run.
HubQuery benches();

HubQuery publish(const QVariantList &document);
HubQuery setStandings(const std::string &bench, const QString &standings);
/// Documents of others than a bench after a revision, in the order of the revisions.
HubQuery since(std::int64_t revision, const std::string &bench, int most);
HubQuery recordings(const std::string &trial);
/// kind, name, owner, SHA-256, body
HubQuery document(const std::string &uuid);
HubQuery revision(const std::string &uuid);

} // namespace hubQueries

} // namespace odo
