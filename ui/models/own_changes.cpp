// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/own_changes.h"

#include "core/project/project.h"
#include "ui/models/core_words.h"

#include <QCoreApplication>

namespace odo {

namespace {

class OwnChangesWords
{
    Q_DECLARE_TR_FUNCTIONS(OwnChanges)
};

/// Of all changes that were ever told.
std::size_t countOf(const Project &project)
{
    const auto changes = project.changes();
    return changes ? changes->size() : 0;
}

tl::unexpected<Error> nothing(const QString &what)
{
    return fail(
        ErrorCode::NotFound, what.toStdString(),
        OwnChangesWords::tr("nothing was changed here").toStdString(),
        OwnChangesWords::tr("what was changed before is taken back in the window's menu Edit").toStdString());
}

} // namespace

Result<QString> OwnChanges::make(const QString &words, const std::function<Result<void>()> &work)
{
    const std::size_t before = countOf(m_project);
    if (const auto done = m_project.change(words.toStdString(), work); !done)
        return tl::unexpected(done.error());
    if (countOf(m_project) == before)
        return QString(); // nothing is another now
    ++m_made;
    m_takenBack = 0;
    return OwnChangesWords::tr("Done: %1. Ctrl+Z takes it back.").arg(words);
}

Result<QString> OwnChanges::undo()
{
    if (m_made == 0)
        return nothing(OwnChangesWords::tr("undo"));
    const auto words = m_project.undo();
    if (!words)
        return tl::unexpected(words.error());
    --m_made;
    ++m_takenBack;
    return OwnChangesWords::tr("Undone: %1.").arg(shownWords(*words));
}

Result<QString> OwnChanges::redo()
{
    if (m_takenBack == 0)
        return nothing(OwnChangesWords::tr("redo"));
    const auto words = m_project.redo();
    if (!words)
        return tl::unexpected(words.error());
    ++m_made;
    --m_takenBack;
    return OwnChangesWords::tr("Made again: %1.").arg(shownWords(*words));
}

} // namespace odo
