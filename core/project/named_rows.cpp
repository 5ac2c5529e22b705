// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/named_rows.h"

#include "core/project/connection.h"
#include "core/project/names.h"

namespace odo {

Result<RecordId> idOfName(ProjectConnection &connection, const std::string &table, const std::string &name)
{
    if (name.empty())
        return 0;
    const auto known = idNamed(connection, table, name);
    if (!known || *known != 0)
        return known;
    if (auto valid = checkName(table, name); !valid)
        return tl::unexpected(valid.error());
    Statement insert(connection, QStringLiteral("INSERT INTO %1 (name) VALUES (?)").arg(QString::fromStdString(table)));
    if (auto done = insert.bind(normalName(name)).run(); !done)
        return tl::unexpected(done.error());
    return insert.insertedId();
}

Result<std::vector<std::string>> textsOf(const ProjectConnection &connection, const QString &sql)
{
    std::vector<std::string> texts;
    Statement select(connection, sql);
    auto read = select.eachRow([&texts](const Statement &row) -> Result<void> {
        texts.push_back(row.name(0));
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
