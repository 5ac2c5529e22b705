// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;

namespace odo {

/// Whether the key of a command is being held down, so that other keys can mean something else meanwhile. The command itself runs as
/// ever when the key goes down. GUI thread; needs the application.
class HeldKey : public QObject
{
    Q_OBJECT
public:
    /// action: whose key it is, whatever key it has; must outlive this.
    explicit HeldKey(const QAction &action, QObject *parent = nullptr);
    bool isHeld() const { return m_isHeld; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool isItsKey(int key) const;

    const QAction &m_action;
    bool m_isHeld = false;
};

} // namespace odo
