// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/message_migration.h"

#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/old_sentences.h"
#include "core/project/message_json.h"

#include <new>
#include <sqlite3.h>
#include <string>

namespace odo {

namespace {

struct SentenceColumn
{
    const char *table, *column;
    OldSentences of;
};
constexpr SentenceColumn columns[] = {{"intrinsics", "verdict", OldSentences::Calibrations},
                                      {"intrinsics", "lens_reason", OldSentences::Calibrations},
                                      {"intrinsics", "origin", OldSentences::Origins},
                                      {"rejected_picture", "reason", OldSentences::Pictures},
                                      {"registration", "verdict", OldSentences::Registrations},
                                      {"registration_check", "words", OldSentences::Registrations},
                                      {"spike", "reason", OldSentences::Spikes},
                                      {"imported_track", "reading", OldSentences::Readings},
                                      {"change_entry", "words", OldSentences::Changes}};

/// The function of SQL that makes a stored message of OldSentences and a text, while it lives. Triggers,
/// which keep imported tracks and the list of changes from ever being changed, rest meanwhile.
class MessageFunction
{
public:
    explicit MessageFunction(sqlite3 *handle) : m_handle(handle)
    {
        set(&MessageFunction::convert);
        sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    }
    ~MessageFunction()
    {
        sqlite3_db_config(m_handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 1, nullptr);
        set(nullptr);
    }
    MessageFunction(const MessageFunction &) = delete;
    MessageFunction &operator=(const MessageFunction &) = delete;

private:
    using Function = void (*)(sqlite3_context *, int, sqlite3_value **);
    void set(Function function)
    {
        sqlite3_create_function_v2(m_handle, "stored_message", 2, SQLITE_UTF8 | SQLITE_DIRECTONLY, nullptr,
                                   function, nullptr, nullptr, nullptr);
    }
    static void convert(sqlite3_context *context, int, sqlite3_value **values) noexcept
    {
        try {
            const auto of = OldSentences(sqlite3_value_int(values[0]));
            const auto *text = reinterpret_cast<const char *>(sqlite3_value_text(values[1]));
            const auto size = static_cast<std::size_t>(sqlite3_value_bytes(values[1]));
            const std::string stored =
                storedMessage(fromOldSentence(of, text ? std::string(text, size) : std::string()));
            sqlite3_result_text(context, stored.data(), static_cast<int>(stored.size()), SQLITE_TRANSIENT);
        } catch (const std::bad_alloc &) {
            sqlite3_result_error_nomem(context);
        }
    }

    sqlite3 *const m_handle;
};

Result<void> convertColumns(ProjectConnection &connection)
{
    const MessageFunction function(connection.handle());
    for (const SentenceColumn &each : columns) {
        const QString sql = QStringLiteral("UPDATE %1 SET %2=stored_message(%3, %2) WHERE %2<>''")
                                .arg(QLatin1String(each.table), QLatin1String(each.column))
                                .arg(int(each.of));
        ODO_TRY(connection.execute(sql));
    }
    return {};
}

/// Of what the columns belong to.
Result<std::vector<DigestedPart>> touchedParts(const ProjectConnection &connection)
{
    std::vector<DigestedPart> parts;
    const auto add = [&](const char *sql, std::initializer_list<DigestPart> of) {
        Statement analyses(connection, QString::fromLatin1(sql));
        return analyses.eachRow([&](const Statement &row) -> Result<void> {
            for (const DigestPart part : of)
                parts.push_back({row.integer(0), part});
            return {};
        });
    };
    auto read = add("SELECT DISTINCT analysis_id FROM analysis_digest",
                    {DigestPart::Registrations, DigestPart::Results});
    if (read)
        read = add("SELECT DISTINCT analysis.id FROM analysis JOIN imported_track USING (trial_id, robot_id)",
                   {DigestPart::Measurements});
    if (!read)
        return tl::unexpected(read.error());
    return parts;
}

} // namespace

Result<void> storeMessages(ProjectConnection &connection)
{
    const auto parts = ODO_TRY(touchedParts(connection));
    return keepDigestsRight(connection, parts, [&] { return convertColumns(connection); });
}

} // namespace odo
