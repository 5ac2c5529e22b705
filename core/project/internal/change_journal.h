// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <vector>

namespace odo {

struct ProjectConnection;

/// The changes made to a project in this session, each of which can be undone and redone:
/// the rows they touched, as they were before and after (SQLite's session extension), so that a change needs
/// no code of its own to undo it. Each is also listed in the project (table change_entry), and so is its
/// undoing.
///
/// Private to core/project; belongs to the thread of its connection.
class ChangeJournal
{
public:
    /// mostBytes: the oldest changes are forgotten when their total is larger.
    explicit ChangeJournal(ProjectConnection &connection, std::size_t mostBytes = std::size_t(64) << 20);

    /// Runs work in one transaction, rolled back when it fails. words: what it does, for people ("rename team
    /// Falcon"). Work that changes nothing leaves no trace. Inside another change it is a part of that one.
    /// adding: what is done before in the same transaction, and stays when work is undone.
    Result<void> make(const Message &words, const std::function<Result<void>()> &work,
                      const std::function<Result<void>()> &adding = {});
    /// As make, for what is listed but cannot be undone: its rows are not kept, however many they are. What
    /// can be undone or redone stays so.
    Result<void> note(const Message &words, const std::function<Result<void>()> &work);
    /// Gives the words of the change. NotFound where there is none; InvalidInput, and nothing done, where
    /// what it changed was changed since by something that is not in the journal, or where a robot it
    /// analysed was reanalysed since.
    Result<Message> undo();
    Result<Message> redo();

    /// Of the change that undo or redo would affect; empty: there is none.
    Message undoWords() const { return m_done.empty() ? Message() : m_done.back().words; }
    Message redoWords() const { return m_undone.empty() ? Message() : m_undone.back().words; }

private:
    using Bytes = std::vector<std::byte>;
    struct Change
    {
        Message words;
        Bytes rows; ///< SQLite's changeset
    };
    Result<void> begin(const Message &words, const std::function<Result<void>()> &counted,
                       const std::function<Result<void>()> &part);
    Result<void> count(const Message &words, const std::function<Result<void>()> &work);
    Result<void> record(const Message &words, const std::function<Result<void>()> &work,
                        const std::function<Result<void>()> &adding);
    Result<void> tell(const Message &words, ChangeEntry::Kind kind);
    Result<void> apply(const Bytes &rows, const Message &what, const Message &words, ChangeEntry::Kind kind);
    void forgetOldest();

    ProjectConnection &m_connection;
    const std::size_t m_mostBytes;
    std::deque<Change> m_done, m_undone;
    bool m_isMaking = false;
};

/// What was changed and when, the newest first.
Result<std::vector<ChangeEntry>> changeEntries(const ProjectConnection &connection);

} // namespace odo
