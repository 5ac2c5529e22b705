// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/message_bar.h"

#include "core/project/names.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QAccessible>
#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <chrono>

namespace odo {

namespace {

constexpr int noteButtonMargin = 14, mostNoteButtons = 3;
constexpr std::chrono::seconds doneStays{8}, warningStays{20}, stillNeeded{2};

} // namespace

QString messageIcon(WindowMessage::Kind kind)
{
    return kind == WindowMessage::Kind::Done ? QStringLiteral("information") : QStringLiteral("warning");
}

QString shownOfMessage(const QString &text)
{
    constexpr qsizetype longestShown = 600;
    return firstCharacters(text, longestShown);
}

QToolButton *messageCloseButton(const QString &accessibleName, const QString &toolTip)
{
    auto *close = new QToolButton;
    close->setProperty("flat", true);
    close->setIcon(themeIcon(QStringLiteral("close")));
    close->setAccessibleName(accessibleName);
    close->setToolTip(toolTip);
    close->setFocusPolicy(Qt::TabFocus);
    return close;
}

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent), m_icon(new QLabel), m_text(new QLabel), m_timer(new QTimer(this))
{
    setObjectName(QStringLiteral("messageBar"));
    setProperty("floating", true);
    showAsWords(*m_text);
    auto *close = messageCloseButton(tr("Close the message"), tr("Close"));
    connect(close, &QToolButton::clicked, this, [this] {
        hide();
        Q_EMIT closed();
    });
    m_timer->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, &MessageBar::leave);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    for (int i = 0; i < mostNoteButtons; ++i) {
        auto *button = new QPushButton(this);
        button->setAutoDefault(true);        // Enter presses it, too
        button->setFocusPolicy(Qt::NoFocus); // until it has words
        button->hide();
        connect(button, &QPushButton::clicked, this, [this, i] {
            hide();
            Q_EMIT acted(i);
        });
        buttons->addWidget(button);
        m_buttons << button;
    }
    buttons->addStretch(1);
    auto *column = new QVBoxLayout;
    column->addWidget(m_text, 1);
    column->addLayout(buttons);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 8, 8, 8);
    layout->setSpacing(10);
    layout->addWidget(m_icon, 0, Qt::AlignTop);
    layout->addLayout(column, 1);
    layout->addWidget(close, 0, Qt::AlignTop);
    hide();
}

/// Not from under the mouse or the keys of a person who reads it.
void MessageBar::leave()
{
    if (underMouse() || isAncestorOf(QApplication::focusWidget()))
        m_timer->start(stillNeeded);
    else
        hide();
}

void MessageBar::present(const WindowMessage &message)
{
    const bool isDone = message.kind == WindowMessage::Kind::Done;
    setProperty("kind", isDone ? QStringLiteral("good") : QStringLiteral("bad"));
    for (QWidget *widget : std::initializer_list<QWidget *>{this, m_text}) {
        widget->style()->unpolish(widget);
        widget->style()->polish(widget);
    }
    const QColor colour = m_text->palette().color(QPalette::WindowText);
    m_icon->setPixmap(themeIcon(messageIcon(message.kind), colour).pixmap(messageIconSide));
    m_fullText = message.text;
    const QString shown = shownOfMessage(message.text);
    m_text->setText(breakable(shown.size() < message.text.size() ? shown + u'…' : shown));
    for (qsizetype i = 0; i < m_buttons.size(); ++i) {
        QPushButton *button = m_buttons[i];
        const bool isThere = i < static_cast<qsizetype>(message.actions.size());
        button->setText(isThere ? message.actions[static_cast<std::size_t>(i)].words : QString());
        button->setFocusPolicy(isThere ? Qt::StrongFocus : Qt::NoFocus);
        button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) +
                                2 * noteButtonMargin);
        button->setVisible(isThere);
    }
    m_timer->start(isDone ? doneStays : warningStays);
    raise();
    show();
    QAccessibleEvent announcement(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&announcement);
}

QString MessageBar::text() const
{
    return isHidden() ? QString() : m_fullText;
}

} // namespace odo
