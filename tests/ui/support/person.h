// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QList>
#include <QPointer>
#include <QTimer>
#include <functional>

namespace odo {

/// Fills in one modal dialog, and closes it.
using Answer = std::function<void(QDialog &)>;

/// Answers the modal dialogs that come up one after the other, as a person would. One that comes unasked for
/// is dismissed, so that a test fails instead of waiting. GUI thread.
class Person : public QObject
{
    Q_OBJECT
public:
    explicit Person(QList<Answer> answers);
    /// Every answer was wanted, and no more than these.
    bool isDone() const { return m_answers.isEmpty() && m_unasked == 0; }

private:
    void look();
    QTimer m_timer;
    QPointer<QDialog> m_answered;
    QList<Answer> m_answers;
    bool m_answering = false;
    int m_unasked = 0;
};

/// Presses the dialog's default button, which must be enabled.
void press(QDialog &dialog);
/// For Qt's own file dialog: one existing file or folder, or the name of a new one.
Answer chooseFile(const QString &file);
/// For QInputDialog: a line or the text of an editable list.
Answer enterText(const QString &text);

} // namespace odo
