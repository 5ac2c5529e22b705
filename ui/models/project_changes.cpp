// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/project_changes.h"

#include "core/project/project.h"
#include "core/project/project_words.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>

namespace odo {

namespace {

QString kindWord(ChangeEntry::Kind kind)
{
    switch (kind) {
    case ChangeEntry::Kind::Made:
        return ChangeModel::tr("made");
    case ChangeEntry::Kind::Undone:
        return ChangeModel::tr("undone");
    case ChangeEntry::Kind::Redone:
        return ChangeModel::tr("redone");
    }
    return {};
}

} // namespace

ChangeModel::ChangeModel(std::vector<ChangeEntry> changes, QObject *parent)
    : RowTableModel(ColumnCount, parent), m_changes(std::move(changes))
{
    setText({});
}

void ChangeModel::setText(const QString &text)
{
    beginResetModel();
    m_shown.clear();
    for (std::size_t i = 0; i < m_changes.size(); ++i)
        if (shownWords(m_changes[i].words).contains(text, Qt::CaseInsensitive))
            m_shown.push_back(i);
    endResetModel();
}

QVariant ChangeModel::cell(int index, int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    const ChangeEntry &change = m_changes[m_shown[static_cast<std::size_t>(index)]];
    switch (column) {
    case DateColumn:
        return shortDate(change.made);
    case KindColumn:
        return kindWord(change.kind);
    default:
        return shownWords(change.words);
    }
}

QVariant ChangeModel::heading(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case DateColumn:
        return tr("When");
    case KindColumn:
        return tr("How");
    default:
        return tr("What");
    }
}

namespace {

class OwnChangesWords
{
    Q_DECLARE_TR_FUNCTIONS(OwnChanges)
};

/// All changes ever recorded.
std::size_t countOf(const Project &project)
{
    const auto changes = project.changes();
    return changes ? changes->size() : 0;
}

tl::unexpected<Error> nothing(Message what)
{
    return fail(ErrorCode::NotFound, std::move(what),
                ODO_TEXT("ui.nothing_changed_here", "no change was made here"),
                ODO_TEXT("ui.undo_in_menu", "use the window's Edit menu to undo earlier changes"));
}

} // namespace

Result<QString> OwnChanges::make(const Message &words, const std::function<Result<void>()> &work)
{
    const std::size_t before = countOf(m_project);
    ODO_TRY(m_project.change(words, work));
    if (countOf(m_project) == before)
        return QString(); // nothing is another now
    ++m_made;
    m_undone = 0;
    return OwnChangesWords::tr("Done: %1. Press Ctrl+Z to undo it.").arg(shownWords(words));
}

Result<QString> OwnChanges::undo()
{
    if (m_made == 0)
        return nothing(undoSubject());
    const auto words = ODO_TRY(m_project.undo());
    --m_made;
    ++m_undone;
    return OwnChangesWords::tr("Undone: %1.").arg(shownWords(words));
}

Result<QString> OwnChanges::redo()
{
    if (m_undone == 0)
        return nothing(redoSubject());
    const auto words = ODO_TRY(m_project.redo());
    ++m_made;
    --m_undone;
    return OwnChangesWords::tr("Redone: %1.").arg(shownWords(words));
}

} // namespace odo
