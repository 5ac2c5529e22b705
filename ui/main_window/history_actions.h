// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QObject>
#include <QStringList>

class QAction;
class QMenu;
class QWidget;

namespace odo {

struct BinContent;
class TrialBatch;
class Workspace;

/// What is done with a class and with many trials at once: import a roster, look through the changes, export,
/// measure again. Owns the actions, asks, and starts the jobs.
class HistoryActions : public QObject
{
    Q_OBJECT
public:
    HistoryActions(Workspace &workspace, QWidget &window);
    void fillMenu(QMenu &menu);
    /// From a file that is asked for.
    void askRoster();
    /// Into a folder that is asked for.
    void exportTrials(const QStringList &trials);
    /// Their annotated videos, likewise; it asks how they are to look.
    void exportVideos(const QStringList &trials);
    /// With the registrations in force; the older analyses stay.
    void reprocessTrials(const QStringList &trials);
    /// Removes trials for good, by a job.
    void emptyBin(const BinContent &content);
    /// Many trials are worked on: their pages need not follow each.
    bool isRunning() const;

Q_SIGNALS:
    /// The project is another one now.
    void changed(const QString &words);
    void failed(const odo::Error &error);

private:
    void showChanges();
    void updateActions();
    void tellEnd(int done, int all, const QStringList &failures);

    Workspace &m_workspace;
    QWidget &m_window;
    TrialBatch *m_batch;
    QString m_doneWords; ///< "Exported trials: %1 of %2."
    QAction *m_roster, *m_changes;
};

} // namespace odo
