// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QWidget>

class QPlainTextEdit;
class QPushButton;
class QTimer;

namespace odo {

class Card;
class FactList;
class Project;

/// What is known of one trial: where it belongs, its metrics, and the notes, which are saved while they are
/// written.
class TrialDetail : public QWidget
{
    Q_OBJECT
public:
    explicit TrialDetail(Project &project, QWidget *parent = nullptr);
    ~TrialDetail() override;

    /// Its metrics are read from the project.
    void showTrial(const TrialRecord &trial);
    /// Stores what is being written now instead of in a moment.
    void saveNotes();
    /// Nothing is selected; noTrials: because the project has none.
    void showNone(bool noTrials);

Q_SIGNALS:
    void openRequested(const QString &trial);
    void notesChanged(const QString &trial);
    void failed(const odo::Error &error);

private:
    Project &m_project;
    RecordId m_trial = 0;
    QString m_name;
    QString m_savedNotes;
    Card *m_card;
    FactList *m_facts;
    QPlainTextEdit *m_notes;
    QPushButton *m_open;
    QTimer *m_saveTimer;
};

} // namespace odo
