// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/internal/message_list.h"

#include <QFrame>

class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace odo {

/// All warnings and errors that were not dismissed, over the page, each with its buttons. Esc closes it.
class MessagePanel : public QFrame
{
    Q_OBJECT
public:
    explicit MessagePanel(MessageList &list, QWidget *parent = nullptr);
    /// With all of its rows, in that width.
    int heightFor(int width) const;

Q_SIGNALS:
    void closed();
    void rowsChanged();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void fill();
    QWidget *makeRow(const WindowMessage &message);

    MessageList &m_list;
    QLabel *m_none;
    QPushButton *m_dismissAll;
    QToolButton *m_close;
    QScrollArea *m_scroll;
    QWidget *m_rows;
    QVBoxLayout *m_rowLayout;
};

} // namespace odo
