// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/change_journal.h"

#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/project_words.h"
#include "core/project/records.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

// Debian's library has the session extension; its header declares it only to those who ask.
#define SQLITE_ENABLE_SESSION 1
#define SQLITE_ENABLE_PREUPDATE_HOOK 1
#include <sqlite3.h>

namespace odo {

namespace {

/// The journal's own table is never undone, verdicts and what the school's hub is to have follow from the
/// rest, and raw measurements stay.
bool isUndone(const char *table)
{
    return std::ranges::none_of(std::array{"change_entry", "verdict", "verdict_check", "observation_series",
                                           "observation_chunk", "school_link", "school_document",
                                           "school_outbox"},
                                [table](const char *other) { return std::strcmp(table, other) == 0; });
}

struct SessionEnd
{
    void operator()(sqlite3_session *session) const { sqlite3session_delete(session); }
};
using Session = std::unique_ptr<sqlite3_session, SessionEnd>;

struct SqliteFree
{
    void operator()(void *memory) const { sqlite3_free(memory); }
};

tl::unexpected<Error> refusal(const ProjectConnection &connection, int code)
{
    return fail(ErrorCode::Internal, connection.subject(),
                ODO_TEXT("project.change_not_noted",
                         "the change could not be logged (%1)")(foreignWords(sqlite3_errstr(code))),
                ODO_TEXT("project.try_again", "try again"));
}

Result<Session> watch(const ProjectConnection &connection)
{
    sqlite3_session *session = nullptr;
    if (const int code = sqlite3session_create(connection.handle(), "main", &session); code != SQLITE_OK)
        return refusal(connection, code);
    Session watching(session);
    sqlite3session_table_filter(
        session, [](void *, const char *table) { return isUndone(table) ? 1 : 0; }, nullptr);
    if (const int code = sqlite3session_attach(session, nullptr); code != SQLITE_OK)
        return refusal(connection, code);
    return watching;
}

/// Calls a function of SQLite that gives a changeset.
template <class Make>
Result<std::vector<std::byte>> changeset(const ProjectConnection &connection, const Make &make)
{
    int size = 0;
    void *memory = nullptr;
    const int code = make(&size, &memory);
    const std::unique_ptr<void, SqliteFree> owner(memory);
    if (code != SQLITE_OK)
        return refusal(connection, code);
    const auto *bytes = static_cast<const std::byte *>(memory);
    return std::vector<std::byte>(bytes, bytes + size);
}

int abortOnConflict(void *, int, sqlite3_changeset_iter *)
{
    return SQLITE_CHANGESET_ABORT;
}

struct TouchedAnalysis
{
    RecordId id = 0, trial = 0, robot = 0;
};

struct ChangesetEnd
{
    void operator()(sqlite3_changeset_iter *rows) const { sqlite3changeset_finalize(rows); }
};

/// The analyses that a changeset adds or removes. rows is read only.
Result<std::vector<TouchedAnalysis>> touchedAnalyses(const ProjectConnection &connection, std::size_t size,
                                                     void *rows)
{
    sqlite3_changeset_iter *start = nullptr;
    if (const int code = sqlite3changeset_start(&start, static_cast<int>(size), rows); code != SQLITE_OK)
        return refusal(connection, code);
    const std::unique_ptr<sqlite3_changeset_iter, ChangesetEnd> each(start);
    std::vector<TouchedAnalysis> touched;
    int code = SQLITE_ROW;
    while ((code = sqlite3changeset_next(start)) == SQLITE_ROW) {
        const char *table = nullptr;
        int columns = 0, operation = 0;
        sqlite3changeset_op(start, &table, &columns, &operation, nullptr);
        if (std::strcmp(table, "analysis") != 0 || operation == SQLITE_UPDATE)
            continue;
        const auto number = [&](int column) -> RecordId {
            sqlite3_value *value = nullptr;
            (operation == SQLITE_INSERT ? sqlite3changeset_new : sqlite3changeset_old)(start, column, &value);
            return value ? sqlite3_value_int64(value) : 0;
        };
        touched.push_back({number(0), number(1), number(2)}); // id, trial_id, robot_id
    }
    if (code != SQLITE_DONE)
        return refusal(connection, code);
    return touched;
}

/// Whether somebody analysed one of these robots again after the change: what is shown comes from that
/// analysis and would stay.
Result<bool> isAnalysedSince(const ProjectConnection &connection, const std::vector<TouchedAnalysis> &touched)
{
    for (const TouchedAnalysis &one : touched) {
        Statement newest(connection,
                         QStringLiteral("SELECT MAX(id) FROM analysis WHERE trial_id=? AND robot_id=?"));
        ODO_TRY(newest.bind(one.trial).bind(one.robot).firstRow());
        const RecordId id = newest.integer(0);
        if (id > one.id && std::ranges::find(touched, id, &TouchedAnalysis::id) == touched.end())
            return true;
    }
    return false;
}

} // namespace

ChangeJournal::ChangeJournal(ProjectConnection &connection, std::size_t mostBytes)
    : m_connection(connection), m_mostBytes(mostBytes)
{
}

Result<void> ChangeJournal::make(const Message &words, const std::function<Result<void>()> &work,
                                 const std::function<Result<void>()> &adding)
{
    return begin(
        words, [&] { return record(words, work, adding); },
        [&]() -> Result<void> {
            if (adding)
                ODO_TRY(adding());
            return work();
        });
}

Result<void> ChangeJournal::note(const Message &words, const std::function<Result<void>()> &work)
{
    return begin(
        words, [&] { return count(words, work); }, work);
}

/// counted: as a change of its own. part: within another one.
Result<void> ChangeJournal::begin(const Message &words, const std::function<Result<void>()> &counted,
                                  const std::function<Result<void>()> &part)
{
    if (m_isMaking)
        return transact(m_connection, part);
    ODO_TRY(checkText(ODO_TEXT("project.change_words", "description of a change"), words.english()));
    m_isMaking = true;
    auto made = counted();
    m_isMaking = false;
    return made;
}

Result<void> ChangeJournal::count(const Message &words, const std::function<Result<void>()> &work)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto before = sqlite3_total_changes64(m_connection.handle());
        ODO_TRY(work());
        const bool isChanged = sqlite3_total_changes64(m_connection.handle()) != before;
        return isChanged ? tell(words, ChangeEntry::Kind::Made) : Result<void>();
    });
}

Result<void> ChangeJournal::record(const Message &words, const std::function<Result<void>()> &work,
                                   const std::function<Result<void>()> &adding)
{
    Change change{words, {}};
    const auto watched = [&]() -> Result<void> {
        if (adding)
            ODO_TRY(adding());
        const auto session = ODO_TRY(watch(m_connection));
        ODO_TRY(work());
        auto rows = changeset(m_connection, [&](int *size, void **bytes) {
            return sqlite3session_changeset(session.get(), size, bytes);
        });
        if (!rows)
            return tl::unexpected(rows.error());
        change.rows = std::move(*rows);
        return change.rows.empty() ? Result<void>() : tell(words, ChangeEntry::Kind::Made);
    };
    ODO_TRY(transact(m_connection, watched));
    if (change.rows.empty())
        return {};
    m_undone.clear();
    m_done.push_back(std::move(change));
    forgetOldest();
    return {};
}

void ChangeJournal::forgetOldest()
{
    std::size_t bytes = 0;
    for (const Change &change : m_done)
        bytes += change.rows.size();
    while (bytes > m_mostBytes) {
        bytes -= m_done.front().rows.size();
        m_done.pop_front();
    }
}

Result<void> ChangeJournal::tell(const Message &words, ChangeEntry::Kind kind)
{
    const auto now = instantNow();
    Statement insert(m_connection,
                     QStringLiteral("INSERT INTO change_entry (made_ms, kind, words) VALUES (?,?,?)"));
    insert.bind(static_cast<std::int64_t>(now.time_since_epoch().count()));
    return insert.bind(storedWord(changeKindWords, kind)).bind(words).run();
}

Result<void> ChangeJournal::apply(const Bytes &rows, const Message &what, const Message &words,
                                  ChangeEntry::Kind kind)
{
    return transact(m_connection, [&]() -> Result<void> {
        // SQLite reads them only, whatever it asks for.
        auto *bytes =
            const_cast<std::byte *>(rows.data()); // NOLINT(cppcoreguidelines-pro-type-const-cast): see above
        const auto touched = ODO_TRY(touchedAnalyses(m_connection, rows.size(), bytes));
        const auto isSuperseded = ODO_TRY(isAnalysedSince(m_connection, touched));
        const int code = isSuperseded
                             ? SQLITE_ABORT
                             : sqlite3changeset_apply(m_connection.handle(), static_cast<int>(rows.size()),
                                                      bytes, nullptr, abortOnConflict, nullptr);
        if (code == SQLITE_ABORT || code == SQLITE_CONSTRAINT)
            return fail(
                ErrorCode::InvalidInput, what,
                ODO_TEXT("project.changed_since", "something it concerns has been changed or used since"),
                ODO_TEXT("project.take_later_back", "undo the later change first, or leave this one"));
        if (code != SQLITE_OK)
            return refusal(m_connection, code);
        return tell(words, kind);
    });
}

Result<Message> ChangeJournal::undo()
{
    if (m_done.empty())
        return fail(
            ErrorCode::NotFound, undoSubject(),
            ODO_TEXT("project.nothing_to_undo", "nothing has been changed since the project was opened"),
            ODO_TEXT("project.change_something_first", "change something first"));
    const Change &last = m_done.back();
    const auto inverse = changeset(m_connection, [&](int *size, void **bytes) {
        return sqlite3changeset_invert(static_cast<int>(last.rows.size()), last.rows.data(), size, bytes);
    });
    if (!inverse)
        return tl::unexpected(inverse.error());
    ODO_TRY(apply(*inverse, ODO_TEXT("project.undo_of", "undo '%1'")(last.words), last.words,
                  ChangeEntry::Kind::Undone));
    m_undone.push_back(std::move(m_done.back()));
    m_done.pop_back();
    return m_undone.back().words;
}

Result<Message> ChangeJournal::redo()
{
    if (m_undone.empty())
        return fail(ErrorCode::NotFound, redoSubject(),
                    ODO_TEXT("project.nothing_to_redo", "nothing has been undone"),
                    ODO_TEXT("project.undo_something_first", "undo something first"));
    const Change &last = m_undone.back();
    ODO_TRY(apply(last.rows, ODO_TEXT("project.redo_of", "redo '%1'")(last.words), last.words,
                  ChangeEntry::Kind::Redone));
    m_done.push_back(std::move(m_undone.back()));
    m_undone.pop_back();
    return m_done.back().words;
}

Result<std::vector<ChangeEntry>> changeEntries(const ProjectConnection &connection)
{
    std::vector<ChangeEntry> entries;
    Statement select(connection,
                     QStringLiteral("SELECT made_ms, kind, words FROM change_entry ORDER BY id DESC"));
    auto read = select.eachRow([&](const Statement &row) -> Result<void> {
        ChangeEntry entry;
        entry.made = Instant(std::chrono::milliseconds(row.integer(0)));
        const auto kind = ODO_TRY(fromStoredWord(changeKindWords, row.text(1),
                                                 ODO_TEXT("project.change_list", "the list of changes")));
        entry.kind = kind;
        entry.words = row.message(2);
        entries.push_back(std::move(entry));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return entries;
}

} // namespace odo
