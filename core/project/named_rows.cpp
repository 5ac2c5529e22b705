// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/named_rows.h"

#include "core/project/connection.h"
#include "core/project/names.h"

namespace odo {

Result<RecordId> idOfName(ProjectConnection &connection, const std::string &table, const std::string &name)
{
    if (name.empty())
        return 0;
    if (auto valid = checkName(table, name); !valid)
        return tl::unexpected(valid.error());
    const QString tableName = QString::fromStdString(table);
    Statement select(connection, QStringLiteral("SELECT id FROM %1 WHERE name=?").arg(tableName));
    const auto found = select.bind(name).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (*found)
        return select.integer(0);
    Statement insert(connection, QStringLiteral("INSERT INTO %1 (name) VALUES (?)").arg(tableName));
    if (auto done = insert.bind(name).run(); !done)
        return tl::unexpected(done.error());
    return insert.insertedId();
}

Result<std::vector<std::string>> textsOf(const ProjectConnection &connection, const QString &sql)
{
    std::vector<std::string> texts;
    Statement select(connection, sql);
    auto read = select.eachRow([&texts](const Statement &row) -> Result<void> {
        texts.push_back(row.text(0));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return texts;
}

Result<void> runFor(const ProjectConnection &connection, const char *sql, RecordId id)
{
    Statement statement(connection, QString::fromLatin1(sql));
    return statement.bind(id).run();
}

} // namespace odo
