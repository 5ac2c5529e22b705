// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/project/school_documents.h"
#include "core/school/hub_address.h"
#include "core/workflow/compare/standings_reading.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class HubThread;

/// Standings as a hub has them: teams by the names that viewers may see, trials by their UUIDs.
struct HubStandings
{
    StandingsReading reading;
    std::vector<std::string> robots; ///< names; TeamRun::robot counts them from 1
};

/// What the hub has of a trial beyond its results.
struct HubTrial
{
    SchoolDocument document;
    std::string owner; ///< the login that published it first
};

/// Which runs a list has. What is empty in it does not limit it.
struct HubRunFilter
{
    std::string search; ///< a text in the name of the trial or of the team; of a viewer's in the latter
    std::string className, team, task;
    std::string metric; ///< of which the list has the value
    /// The login that published them first; of those who may read more than results.
    std::string bench = {};
};

/// A robot's run in a trial, as a list shows it.
struct HubRun
{
    std::string trial; ///< UUID
    std::string robot;
    std::string name; ///< of the trial; empty where the login may not read it
    std::string team, className, task;
    Instant held;
    double durationS = 0;
    std::string standing; ///< "pass", "doubtful", "bad", or "otherwise": by another course
    std::optional<Metric> metric;
    std::string bench = {}; ///< the login that published it first; empty where the login may not read it
};

/// The results at a school's hub, which any of its roles may read. It changes nothing. On one thread at a
/// time; each call asks the server, and one that takes the server more than 15 s ends with an error; a
/// cancellation waits for no server. Errors: Unavailable where the hub cannot be reached or went away:
/// connect again; isPasswordNeeded(); InvalidInput, NotFound and NewerFormat for what does not pass by
/// itself; Cancelled.
class HubResults
{
public:
    static Result<std::unique_ptr<HubResults>> connect(const HubAddress &address,
                                                       const JobControl &control = {});
    ~HubResults();
    HubResults(const HubResults &) = delete;
    HubResults &operator=(const HubResults &) = delete;

    /// Another number after each change of results; quick.
    Result<std::int64_t> state();
    /// As readStandings(), with what differs at a hub: what is not chosen is the task of the newest trial
    /// that has one, and of metrics the score where runs of the task have one, else the most informative one
    /// that its newest runs have. A class or a task without results gives no teams.
    Result<HubStandings> standings(StandingsChoice choice);

    /// The newest runs first, a page of so many at most; after: the last one of the page before.
    Result<std::vector<HubRun>> runs(const HubRunFilter &filter, int most, const HubRun *after = nullptr,
                                     const JobControl &control = {});

    /// The logins that published runs, in alphabetical order; none where the login may not read them.
    Result<std::vector<std::string>> benches(const JobControl &control = {});

    /// Whether the login may read more of trials than their results.
    bool mayReadTrials() const { return m_role != "viewer"; }
    /// Of a trial by its UUID; 0: it is not there.
    Result<std::int64_t> revisionOf(const std::string &trial);
    /// nullopt: it is not there. The document has no recordings and no results.
    Result<std::optional<HubTrial>> trial(const std::string &trial);

private:
    explicit HubResults(std::unique_ptr<HubThread> hub, std::string role);
    /// What work(SchoolHub &) gives; it owns all that it uses.
    template <class Work>
    auto ask(const Work &work, const JobControl &control = {});

    std::unique_ptr<HubThread> m_hub;
    std::string m_role;
};

} // namespace odo
