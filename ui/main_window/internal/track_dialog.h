// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/track_job.h"

#include <QDialog>
#include <QStringList>

class QComboBox;
class QDialogButtonBox;

namespace odo {

class CheckList;

/// Asks which robots to follow in a trial, and how to smooth the curves.
class TrackDialog : public QDialog
{
    Q_OBJECT
public:
    /// expected: those that are ticked; none: all are. caveats: sentences on what will make the results
    /// uncertain.
    TrackDialog(const QString &trial, const QStringList &robots, const QStringList &expected,
                const QStringList &caveats, QWidget *parent = nullptr);
    TrackSettings settings() const;

private:
    CheckList *m_robots;
    QComboBox *m_smoother;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
