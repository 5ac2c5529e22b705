// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QList>
#include <QObject>
#include <vector>

class QAction;
class QWidget;

namespace odo {

struct BinContent;
struct TrialEdit;
class Project;

/// What a person does with trials in History: star, edit in place, archive, put into the bin and out of it,
/// ask to empty the bin. Owns the actions; all but emptying the bin can be undone. On the project's thread.
class MarkActions : public QObject
{
    Q_OBJECT
public:
    /// window: parent of the question.
    MarkActions(Project &project, QWidget &window);

    QAction *star() const { return m_star; }
    QAction *archive() const { return m_archive; }
    QAction *bin() const { return m_bin; }
    QAction *emptyBin() const { return m_empty; }

    /// The trials that the actions mean; the words follow them.
    void setTrials(std::vector<TrialRecord> trials);
    void setReadOnly(bool readOnly);
    /// Whether the bin is what is shown.
    void setBinShown(bool shown);

    void setStarred(RecordId trial, bool starred);
    /// A change that was made in the list.
    void edit(RecordId trial, const TrialEdit &edit);

Q_SIGNALS:
    /// These trials are stored otherwise now.
    void marked(const QList<qint64> &trials);
    /// A person confirmed that these are to be removed for good.
    void emptyBinRequested(const odo::BinContent &content);
    void failed(const odo::Error &error);

private:
    using Mark = Result<void> (*)(Project &, const TrialRecord &, bool);
    void change(const MessageText &words, const MessageText &wordsOfMany, Mark mark, bool to);
    void moveToBinOrBack();
    void report(const Result<void> &done);
    void askToEmpty();
    void updateActions();

    Project &m_project;
    QWidget &m_window;
    std::vector<TrialRecord> m_trials;
    bool m_readOnly = false, m_binShown = false;
    QAction *m_star, *m_archive, *m_bin, *m_empty;
};

} // namespace odo
