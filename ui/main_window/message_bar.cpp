// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/message_bar.h"

#include "ui/models/error_words.h"
#include "ui/views/theme_icon.h"
#include "ui/views/words_label.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <chrono>
#include <utility>

namespace odo {
namespace {

constexpr int messageIconSide = 20, buttonMargin = 14;
constexpr std::chrono::seconds doneStays{8};

} // namespace

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_text(new QLabel(this)), m_button(new QPushButton(this)),
      m_timer(new QTimer(this))
{
    setObjectName(QStringLiteral("messageBar"));
    showAsWords(*m_text);
    auto *close = new QToolButton(this);
    close->setProperty("flat", true);
    close->setIcon(themeIcon(QStringLiteral("close")));
    close->setAccessibleName(tr("Close the message"));
    close->setToolTip(tr("Close"));
    close->setFocusPolicy(Qt::TabFocus);
    m_button->setAutoDefault(true); // Enter presses it, too
    m_button->setFocusPolicy(Qt::NoFocus); // until it has words
    connect(m_button, &QPushButton::clicked, this, [this] {
        const auto act = std::exchange(m_act, nullptr);
        m_button->hide();
        if (act)
            act();
    });
    connect(close, &QToolButton::clicked, this, &QWidget::hide);
    m_timer->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, &QWidget::hide);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 6, 8, 6);
    layout->setSpacing(10);
    layout->addWidget(m_icon, 0, Qt::AlignTop);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_button, 0, Qt::AlignTop);
    layout->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void MessageBar::showError(const Error &error)
{
    if (error.code == ErrorCode::Cancelled)
        return showDone(tr("Cancelled. Nothing was changed."));
    m_timer->stop();
    present("bad", QStringLiteral("warning"), errorInWords(error));
}

void MessageBar::showWarning(const QString &text)
{
    m_timer->stop();
    present("bad", QStringLiteral("warning"), text);
}

void MessageBar::showDone(const QString &text)
{
    present("good", QStringLiteral("information"), text);
    m_timer->start(doneStays);
}

void MessageBar::offer(const QString &words, std::function<void()> act)
{
    m_act = std::move(act);
    m_button->setText(words);
    m_button->setFocusPolicy(Qt::StrongFocus);
    m_button->setMinimumWidth(m_button->fontMetrics().horizontalAdvance(words) + 2 * buttonMargin);
    m_button->show();
}

QString MessageBar::text() const
{
    return isHidden() ? QString() : m_text->text();
}

void MessageBar::present(const char *kind, const QString &icon, const QString &text)
{
    setProperty("kind", QString::fromLatin1(kind));
    for (QWidget *widget : std::initializer_list<QWidget *>{this, m_text}) {
        widget->style()->unpolish(widget);
        widget->style()->polish(widget);
    }
    m_icon->setPixmap(themeIcon(icon, m_text->palette().color(QPalette::WindowText)).pixmap(messageIconSide));
    m_text->setText(text);
    m_act = nullptr;
    m_button->hide();
    show();
    QAccessibleEvent announcement(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&announcement);
}

} // namespace odo
