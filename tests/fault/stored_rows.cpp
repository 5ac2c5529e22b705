// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/stored_rows.h"

#include <memory>
#include <sqlite3.h>

namespace odo::test {

namespace {

using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;

Statement prepared(const Database &database, const QString &sql)
{
    sqlite3_stmt *statement = nullptr;
    sqlite3_prepare_v2(database.get(), sql.toUtf8().constData(), -1, &statement, nullptr);
    return {statement, sqlite3_finalize};
}

QString valueOf(sqlite3_stmt *row, int column)
{
    const QByteArray name = sqlite3_column_name(row, column);
    if (sqlite3_column_type(row, column) == SQLITE_NULL)
        return QStringLiteral("-");
    if (name.endsWith("_ms"))
        return QStringLiteral("moment");
    if (name == "sha256" && qstrcmp(sqlite3_column_table_name(row, column), "analysis_digest") == 0)
        return QStringLiteral("of what was made at a moment");
    const auto *bytes = static_cast<const char *>(sqlite3_column_blob(row, column));
    return QString::fromLatin1(QByteArray(bytes, sqlite3_column_bytes(row, column)).toHex());
}

} // namespace

QStringList storedRows(const std::filesystem::path &file)
{
    sqlite3 *opened = nullptr;
    const int code = sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READWRITE, nullptr);
    const Database database(opened, sqlite3_close);
    if (code != SQLITE_OK)
        return {};
    const Statement check = prepared(database, QStringLiteral("PRAGMA integrity_check"));
    if (!check || sqlite3_step(check.get()) != SQLITE_ROW ||
        qstrcmp(reinterpret_cast<const char *>(sqlite3_column_text(check.get(), 0)), "ok") != 0)
        return {};
    QStringList rows;
    const Statement tables = prepared(
        database,
        QStringLiteral("SELECT name FROM sqlite_master WHERE type='table' AND name NOT LIKE 'sqlite%'"));
    while (tables && sqlite3_step(tables.get()) == SQLITE_ROW) {
        const QString table =
            QString::fromUtf8(reinterpret_cast<const char *>(sqlite3_column_text(tables.get(), 0)));
        const Statement all = prepared(database, QStringLiteral("SELECT * FROM \"%1\"").arg(table));
        int step = SQLITE_DONE;
        while (all && (step = sqlite3_step(all.get())) == SQLITE_ROW) {
            QString row = table;
            for (int column = 0; column < sqlite3_column_count(all.get()); ++column)
                row += u'|' + valueOf(all.get(), column);
            rows << row;
        }
        if (step != SQLITE_DONE)
            return {};
    }
    rows << QStringLiteral("(end)"); // so that an empty database differs from one that cannot be read
    rows.sort();
    return rows;
}

QString firstDifference(const QStringList &expected, const QStringList &found)
{
    for (const QString &row : expected) {
        if (!found.contains(row))
            return QStringLiteral("missing: ") + row.left(200);
    }
    for (const QString &row : found) {
        if (!expected.contains(row))
            return QStringLiteral("too many: ") + row.left(200);
    }
    return expected.size() == found.size() ? QString() : QStringLiteral("a row is there twice");
}

} // namespace odo::test
