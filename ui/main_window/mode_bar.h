// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QAction;
class QActionGroup;
class QVBoxLayout;

namespace odo {

/// The dark bar on the left: one button a mode, icon and word, exclusive. Modes are numbered in the order of
/// adding, from 0, and reached by Ctrl+1, Ctrl+2, ...
class ModeBar : public QFrame
{
    Q_OBJECT
public:
    explicit ModeBar(QWidget *parent = nullptr);
    void addMode(const QString &icon, const QString &name);
    void setCurrent(int mode);
    /// False while there is nothing that the modes could show.
    void setModesEnabled(bool enabled);
    /// The actions, for a menu.
    QList<QAction *> modeActions() const;

Q_SIGNALS:
    /// A person chose it; setCurrent emits nothing.
    void chosen(int mode);

private:
    QActionGroup *m_group;
    QVBoxLayout *m_layout;
};

} // namespace odo
