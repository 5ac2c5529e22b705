// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/main_window/internal/done_work.h"
#include "ui/report/report_dialog.h"

#include <QObject>
#include <QStringList>
#include <memory>

class QAction;
class QWidget;

namespace odo {

class PageOutput;
class ReportJob;
class ProjectPages;
class Workspace;
struct ChosenOutput;

/// Reports of what the window shows: asks what and how with a preview, and saves or prints it by a job. Owns
/// the action. GUI thread.
class ReportActions : public QObject
{
    Q_OBJECT
public:
    ReportActions(Workspace &workspace, QWidget &window);
    ~ReportActions() override;
    QAction *report() const { return m_report; }
    /// Of the set-up of the project, whatever is on screen.
    QAction *certificate() const { return m_certificate; }
    /// Whose trial, comparison or class a report is of; null: no project is open.
    void setPages(ProjectPages *pages);
    /// A report of what is on screen.
    void ask();
    /// Of these trials, one after the other.
    void askTrials(const QStringList &trials);

Q_SIGNALS:
    /// School, logo and wording are to be changed; the receiver does that before it returns.
    void letterheadRequested();
    void failed(const odo::Error &error);
    void done(const odo::DoneWork &work);

private:
    void ask(QList<ReportSubject> subjects);
    QList<ReportSubject> shownSubjects() const;
    ReportChoices choices() const;
    void save();
    void write(const ChosenOutput &output);
    void print();
    void askCertificate();
    void start(std::unique_ptr<PageOutput> output, const DoneWork &work);
    void startJob(std::shared_ptr<ReportJob> job, const Message &words, const DoneWork &work);

    Workspace &m_workspace;
    QWidget &m_window;
    ProjectPages *m_pages = nullptr;
    QAction *m_report, *m_certificate;
    /// Kept when it is closed: a preview that is still being painted ends by itself meanwhile.
    std::unique_ptr<ReportDialog> m_dialog;
};

} // namespace odo
