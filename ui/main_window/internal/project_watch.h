// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

namespace odo {

class BackgroundTask;

/// Looks at the open project twice a second: whether anybody else has changed it or taken its file away, and
/// whether all changes are in the project file itself and not only in the log beside it, so that a copy of
/// the file has them. Writes the log back after a quiet second, when the program loses the focus, and every
/// few seconds while changes go on; on a thread of its own. GUI thread; the project must outlive it.
class ProjectWatch : public QObject
{
    Q_OBJECT
public:
    enum class Access { ReadOnly, ReadWrite };
    ProjectWatch(Project &project, Access access, QObject *parent = nullptr);
    ~ProjectWatch() override;

    /// All changes are in the project file. Always false where it is read only.
    bool isSaved() const { return m_access == Access::ReadWrite && m_savedState && m_savedState == m_state; }

Q_SIGNALS:
    void changedOutside(); ///< by another program, or by another thread that has come to rest
    void savedChanged();
    /// The file is no longer where it was opened; again at each look, as long as that is so.
    void lost();
    /// Another program wrote over the file; likewise.
    void overwritten();

private:
    void poll();
    void noteState();
    void writeBack();

    Project &m_project;
    const Access m_access;
    QTimer m_timer;
    QElapsedTimer m_quiet, m_written; ///< since the last change, and since the log was last written back
    std::optional<ProjectState> m_state, m_savedState;
    bool m_isUnsure = false; ///< others changed something while threads of this program did
    std::unique_ptr<BackgroundTask> m_task;
};

} // namespace odo
