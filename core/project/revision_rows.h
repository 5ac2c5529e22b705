// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/connection.h"
#include "core/project/records.h"

#include <optional>
#include <vector>

namespace odo {

// Of a camera's calibrations, and likewise of its registrations, every revision stays; the newest is in force
// unless a person has chosen another one. A choice of another camera's, which only a hand in the database can make, is
// none; checkDerivedFigures names it. table: "intrinsics" or "registration", whose rows have a camera_id,
// and for which camera has a column that names the chosen one. columns: a SELECT up to its WHERE. On the
// project's thread.

/// Makes a record of a row.
template <class Record>
using RowReader = Result<Record> (*)(const ProjectConnection &, const Statement &);

/// The one in force; nullopt: there is none.
template <class Record>
Result<std::optional<Record>> currentRevision(const ProjectConnection &connection, const QString &columns,
                                              const char *table, RecordId camera, RowReader<Record> read)
{
    Statement select(connection,
                     columns + QStringLiteral("WHERE id=COALESCE((SELECT chosen.id FROM camera JOIN %1 AS chosen ON chosen.id=camera.%1_id "
                                              "AND chosen.camera_id=camera.id WHERE camera.id=?), (SELECT MAX(id) FROM %1 WHERE camera_id=?))")
                                   .arg(QLatin1String(table)));
    const auto found = select.bind(camera).bind(camera).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return std::nullopt;
    auto record = read(connection, select);
    if (!record)
        return tl::unexpected(record.error());
    return std::optional(std::move(*record));
}

/// The newest first.
template <class Record>
Result<std::vector<Record>> allRevisions(const ProjectConnection &connection, const QString &columns,
                                         RecordId camera, RowReader<Record> read)
{
    std::vector<Record> all;
    Statement select(connection, columns + QStringLiteral("WHERE camera_id=? ORDER BY id DESC"));
    auto done = select.bind(camera).eachRow([&](const Statement &row) -> Result<void> {
        auto record = read(connection, row);
        if (!record)
            return tl::unexpected(record.error());
        all.push_back(std::move(*record));
        return {};
    });
    if (!done)
        return tl::unexpected(done.error());
    return all;
}

} // namespace odo
