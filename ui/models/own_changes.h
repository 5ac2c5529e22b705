// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>
#include <functional>

namespace odo {

class Project;

/// The changes that one dialog makes to a project: told in words, and taken back by the dialog alone as far
/// as they are its own. On the project's thread; the project must outlive it.
class OwnChanges
{
public:
    explicit OwnChanges(Project &project) : m_project(project) {}
    /// Project::change. The sentence says what was done; empty: it changed nothing.
    Result<QString> make(const QString &words, const std::function<Result<void>()> &work);
    /// Of the last one that was made here. NotFound where there is none left.
    Result<QString> undo();
    Result<QString> redo();

private:
    Project &m_project;
    int m_made = 0, m_takenBack = 0;
};

} // namespace odo
