// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"

#include <QDialog>
#include <QStringList>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace odo {

/// A dialog whose pages are walked one after the other: a title, "step 1 of 2", and Back, Next and Cancel, of
/// which Enter presses Next. Whoever derives from it says when a page is complete and what Next does.
class StepDialog : public QDialog
{
    Q_OBJECT
public:
    void done(int result) override;

protected:
    /// lastButton: what Next is called on the last page.
    StepDialog(const QString &windowTitle, const QString &lastButton, QWidget *parent);

    void addStep(const QString &title, QWidget *page);
    /// Call it once all steps are there, too.
    void turnTo(int step);
    int step() const;
    /// Asks isComplete() again.
    void updateButtons();

    /// Does the work on a thread of its own, then accepts; if it fails, showNotSaved() says why and the
    /// dialog stays open.
    void saveAndAccept(BackgroundTask::Work work);
    bool isSaving() const { return m_saving.isRunning(); }

    virtual bool isComplete(int step) const = 0;
    virtual void next() = 0;
    virtual void back() { turnTo(step() - 1); }
    virtual void showNotSaved(const Error &) {}

private:
    const QString m_lastButton;
    QStringList m_titles;
    QLabel *m_title, *m_steps;
    QStackedWidget *m_pages;
    QPushButton *m_back, *m_next;
    BackgroundTask m_saving;
};

} // namespace odo
