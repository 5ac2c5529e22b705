// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/message_panel.h"

#include "ui/main_window/internal/message_bar.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

constexpr int edge = 12;

} // namespace

MessagePanel::MessagePanel(MessageList &list, QWidget *parent)
    : QFrame(parent), m_list(list), m_none(new QLabel(tr("No messages."))),
      m_dismissAll(new QPushButton(tr("Dismiss &all"))), m_scroll(new QScrollArea), m_rows(new QWidget),
      m_rowLayout(new QVBoxLayout(m_rows))
{
    setObjectName(QStringLiteral("messagePanel"));
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Messages"));
    auto *title = new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Messages")));
    m_close = messageCloseButton(tr("Close the list of messages"), tr("Close (Esc)"));
    connect(m_close, &QToolButton::clicked, this, &MessagePanel::closed);
    m_dismissAll->setAutoDefault(true);
    connect(m_dismissAll, &QPushButton::clicked, &m_list, &MessageList::dismissAll);
    m_none->setObjectName(QStringLiteral("quiet"));
    m_none->setContentsMargins(edge, 0, edge, edge);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(edge, 6, 6, 6);
    head->addWidget(title, 1);
    head->addWidget(m_dismissAll);
    head->addWidget(m_close);
    m_rowLayout->setContentsMargins(0, 0, 0, 0);
    m_rowLayout->setSpacing(0);
    m_rows->setObjectName(QStringLiteral("messageRows"));
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidget(m_rows);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    layout->addLayout(head);
    layout->addWidget(m_none);
    layout->addWidget(m_scroll, 1);
    connect(&m_list, &MessageList::changed, this, [this] {
        if (isVisible())
            fill();
    });
    hide();
}

void MessagePanel::showEvent(QShowEvent *event)
{
    fill();
    QFrame::showEvent(event);
}

/// The focus stays in the list: at the message that is now where the dismissed one was.
void MessagePanel::fill()
{
    const QWidget *focus = QApplication::focusWidget();
    int row = -1;
    for (int i = 0; i < m_rowLayout->count(); ++i)
        if (m_rowLayout->itemAt(i)->widget()->isAncestorOf(focus))
            row = i;
    while (m_rowLayout->count() > 0) {
        QWidget *old = m_rowLayout->takeAt(0)->widget();
        old->hide();
        old->deleteLater(); // its button may be what dismissed it
    }
    setTabOrder(this, m_dismissAll);
    setTabOrder(m_dismissAll, m_close);
    QWidget *before = m_close;
    for (const WindowMessage &message : m_list.messages()) {
        QWidget *made = makeRow(message);
        m_rowLayout->addWidget(made);
        made->show(); // now, not when the event loop runs again
        for (auto *button : made->findChildren<QAbstractButton *>()) {
            setTabOrder(before, button);
            before = button;
        }
    }
    const int count = m_rowLayout->count();
    m_none->setVisible(count == 0);
    m_dismissAll->setVisible(count > 0);
    m_scroll->setVisible(count > 0);
    if (row >= 0 && count > 0)
        m_rowLayout->itemAt(std::min(row, count - 1))->widget()->findChild<QToolButton *>()->setFocus();
    else if (row >= 0 || isAncestorOf(focus))
        setFocus();
    Q_EMIT rowsChanged();
}

QWidget *MessagePanel::makeRow(const WindowMessage &message)
{
    auto *row = new QFrame(m_rows);
    row->setObjectName(QStringLiteral("messageRow"));
    auto *icon = new QLabel;
    icon->setPixmap(themeIcon(messageIcon(message.kind)).pixmap(messageIconSide));
    auto *text = new QLabel(breakable(message.text));
    showAsWords(*text);
    const QString time = QLocale().toString(message.time.time(), QLocale::ShortFormat);
    auto *when = new QLabel(message.count > 1 ? tr("%1, %n times", "", message.count).arg(time) : time);
    when->setObjectName(QStringLiteral("quiet"));
    auto *foot = new QHBoxLayout;
    foot->addWidget(when, 1);
    for (std::size_t i = 0; i < message.actions.size(); ++i) {
        auto *button = new QPushButton(message.actions[i].words);
        button->setAutoDefault(true);
        connect(button, &QPushButton::clicked, this, [this, id = message.id, i] {
            Q_EMIT closed(); // what it begins is not to be covered
            m_list.act(id, i);
        });
        foot->addWidget(button);
    }
    auto *dismiss = messageCloseButton(tr("Dismiss: %1").arg(shownOfMessage(message.text)), tr("Dismiss"));
    connect(dismiss, &QToolButton::clicked, this, [this, id = message.id] { m_list.dismiss(id); });
    auto *column = new QVBoxLayout;
    column->setSpacing(4);
    column->addWidget(text);
    column->addLayout(foot);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(edge, 8, 6, 8);
    layout->addWidget(icon, 0, Qt::AlignTop);
    layout->addLayout(column, 1);
    layout->addWidget(dismiss, 0, Qt::AlignTop);
    return row;
}

int MessagePanel::heightFor(int width) const
{
    constexpr int border = 2; // of both sides, each with the layout's own margin
    const int head = layout()->itemAt(0)->sizeHint().height() + 2 * border;
    if (m_rowLayout->count() == 0)
        return head + m_none->sizeHint().height();
    int height = head;
    for (int i = 0; i < m_rowLayout->count(); ++i)
        height += m_rowLayout->itemAt(i)->widget()->heightForWidth(width - 2 * border);
    return height;
}

void MessagePanel::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        Q_EMIT closed();
    else
        QFrame::keyPressEvent(event);
}

} // namespace odo
