// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QAction;
class QComboBox;

namespace odo {

/// Which trial is shown: a list of all, and the ones before and after. Owns the two actions, for menus.
class TrialChooser : public QWidget
{
    Q_OBJECT
public:
    explicit TrialChooser(QWidget *parent = nullptr);
    /// Names in the order of the list, and the words that each is shown by ("Trial 3 · Falcon"); as many.
    void setTrials(const QStringList &names, const QStringList &words);
    /// Emits nothing.
    void setCurrent(const QString &name);
    QAction *previousAction() const { return m_previous; }
    QAction *nextAction() const { return m_next; }

Q_SIGNALS:
    void chosen(const QString &name);

private:
    void step(int by);
    void updateActions();

    QComboBox *m_trials;
    QAction *m_previous;
    QAction *m_next;
};

} // namespace odo
