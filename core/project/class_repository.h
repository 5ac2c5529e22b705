// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection;

struct ClassRecord
{
    RecordId id = 0;
    std::string name;
    std::optional<Instant>
        archived;  ///< since when it is out of the way: its teams and trials are listed only where asked for
    int teams = 0; ///< read only
};

/// The classes of a project. Plain synchronous calls on the project's thread, as those of repositories.h.
class ClassRepository
{
public:
    explicit ClassRepository(ProjectConnection &connection);
    /// AlreadyExists for a name that is taken.
    Result<ClassRecord> add(const std::string &name);
    /// In alphabetical order, those that are archived too.
    Result<std::vector<ClassRecord>> all() const;
    Result<ClassRecord> find(const std::string &name) const;
    Result<ClassRecord> get(RecordId id) const;
    Result<void> rename(RecordId id, const std::string &name);
    Result<void> setArchived(RecordId id, bool archived);
    /// InvalidInput where it has teams.
    Result<void> remove(RecordId id);

private:
    ProjectConnection &m_connection;
};

} // namespace odo
