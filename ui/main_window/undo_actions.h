// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QObject>

class QAction;
class QMenu;

namespace odo {

class Project;
class Workspace;

/// Undo and Redo of what a person changed in the open project, with the words of the change in the menu. Owns
/// the actions. GUI thread.
class UndoActions : public QObject
{
    Q_OBJECT
public:
    UndoActions(Workspace &workspace, QObject *parent);
    /// The words are looked up when the menu is about to show.
    void fillMenu(QMenu &menu);

Q_SIGNALS:
    /// What is still being written (notes) must be stored now, for it is the last change.
    void aboutToLook();
    /// The project is another one now; words: what was done, as a sentence.
    void changed(const QString &words);
    void failed(const odo::Error &error);

private:
    void showWords();
    void apply(Result<std::string> (Project::*what)(), const QString &sentence);

    Workspace &m_workspace;
    QAction *m_undo, *m_redo;
};

} // namespace odo
