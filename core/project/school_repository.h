// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection;

/// What ties a project to the school's hub.
struct SchoolLink
{
    std::string url;   ///< without a password
    std::string bench; ///< UUID of this project at the hub; made when it was first connected
    std::string role;  ///< "teacher", "bench" or "viewer", at the last contact
    int schemaVersion = 0;
    std::string media;       ///< the folder for recordings; empty: none
    std::int64_t pulled = 0; ///< up to which of the hub's revisions everything was received
    std::optional<Instant> lastSync = {};
};

/// What the hub keeps, each with all that belongs to it.
enum class SchoolKind { Class, Team, Task, Trial };
/// "class", "team", "task", "trial".
std::string schoolKindWord(SchoolKind kind);
/// InvalidInput for another word.
Result<SchoolKind> schoolKindOf(const std::string &word);

/// A change that the hub is to have. mark: of this change; a later one of the same row has another.
struct OutboxEntry
{
    SchoolKind kind = SchoolKind::Trial;
    RecordId row = 0;
    std::string removed; ///< the UUID of a row that is gone; empty: it is there
    std::int64_t mark = 0;
};

/// By what the hub knows a row.
struct SchoolIdentity
{
    SchoolKind kind = SchoolKind::Trial;
    RecordId row = 0;
    std::string uuid;
    std::int64_t revision = 0; ///< the hub's last one that was sent or received; 0: none
    std::string sha256 = {};   ///< of the document then
    std::string owner = {};    ///< the login that published it first; empty: not known
    /// of a trial from elsewhere: the views that it was recorded in, whose recordings are there
    std::vector<std::string> views = {};
};

/// The project's part of the school's hub: its link, and the outbox that triggers fill in the transaction of
/// each change (schema/21_school.sql). Plain synchronous calls on the project's thread;
/// Project::inTransaction binds several.
class SchoolRepository
{
public:
    explicit SchoolRepository(ProjectConnection &connection);
    /// nullopt: the project is not connected.
    Result<std::optional<SchoolLink>> link() const;
    /// Connects, and notes everything that there is as to be sent. The bench keeps its UUID.
    Result<void> connect(SchoolLink link);
    /// Identities are kept, the outbox is not: connecting again notes everything anew.
    Result<void> disconnect();
    Result<void> setContact(const std::string &role, int schemaVersion, Instant when);
    Result<void> setPulled(std::int64_t revision);

    /// Classes, teams, tasks, then trials, each in the order of their changes.
    Result<std::vector<OutboxEntry>> outbox() const;
    Result<std::int64_t> pending() const;
    Result<bool> isPending(SchoolKind kind, RecordId row) const;
    /// It is sent: removes it, unless the row was changed since the entry was read.
    Result<void> settle(const OutboxEntry &entry);
    /// Removes whatever change of a row is noted: it came from the hub.
    Result<void> settle(SchoolKind kind, RecordId row);

    Result<std::optional<SchoolIdentity>> known(SchoolKind kind, RecordId row) const;
    /// Makes it where the row has none.
    Result<SchoolIdentity> identity(SchoolKind kind, RecordId row);
    Result<std::optional<SchoolIdentity>> find(const std::string &uuid) const;
    /// Replaces the row's.
    Result<void> setIdentity(const SchoolIdentity &identity);
    /// Adds recordings to a trial that has none; digests of its analyses that were right stay so.
    Result<void> addRecordings(RecordId trial, const std::vector<RecordingRecord> &recordings,
                               const std::function<Result<void>()> &synchronise);
    /// The row of that name; 0: there is none.
    Result<RecordId> rowNamed(SchoolKind kind, const std::string &name) const;

private:
    ProjectConnection &m_connection;
};

} // namespace odo
