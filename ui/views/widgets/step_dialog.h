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
/// which Enter presses Next. Whoever derives from it says what a page still lacks, which is shown beside a
/// Next that cannot be pressed, what Next does, and what is lost by leaving, which is asked first.
class StepDialog : public QDialog
{
    Q_OBJECT
public:
    void done(int result) override;
    void reject() override;

protected:
    /// lastButton: what Next is called on the last page.
    StepDialog(const QString &windowTitle, const QString &lastButton, QWidget *parent);

    void addStep(const QString &title, QWidget *page);
    /// Call it once all steps are there, too.
    void turnTo(int step);
    int step() const;
    /// Asks missing() and isBusy() again.
    void updateButtons();

    /// Does the work on a thread of its own, then accepts; if it fails, showNotSaved() says why and the
    /// dialog stays open.
    void saveAndAccept(BackgroundTask::Work work);
    bool isSaving() const { return m_saving.isRunning(); }

    /// What a page still lacks, as a sentence; empty: Next may be pressed.
    virtual QString missing(int step) const = 0;
    /// Something runs for which Next has to wait, and which shows its progress itself.
    virtual bool isBusy(int) const { return isSaving(); }
    /// What the user made here and has not saved, such as "14 images of the board"; empty: nothing.
    virtual QString unsaved() const { return {}; }
    virtual void next() = 0;
    virtual void back() { turnTo(step() - 1); }
    virtual void showNotSaved(const Error &) {}

private:
    const QString m_lastButton;
    QStringList m_titles;
    QLabel *m_title, *m_steps, *m_missing;
    QStackedWidget *m_pages;
    QPushButton *m_back, *m_next;
    BackgroundTask m_saving;
};

} // namespace odo
