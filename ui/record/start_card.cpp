// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/start_card.h"

#include "ui/models/figure_text.h"
#include "ui/views/command_names.h"
#include "ui/views/theme_icon.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <cmath>

namespace odo {
namespace {

constexpr int iconSide = 22;

/// "00:12.3": tenths are enough while it runs.
QString clockText(Nanoseconds elapsed)
{
    return timeCode(elapsed).chopped(2);
}

} // namespace

StartCard::StartCard(QWidget *parent)
    : Card(tr("Recording"), parent), m_action(new QAction(tr("&Record or stop"), this)),
      m_button(new QPushButton), m_clock(new QLabel), m_words(new QLabel)
{
    auto *content = new QWidget;
    content->setObjectName(QStringLiteral("cardBody"));
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(10, 10, 10, 8);
    layout->setSpacing(6);
    m_button->setObjectName(QStringLiteral("recordButton"));
    m_button->setIconSize({iconSide, iconSide});
    m_clock->setObjectName(QStringLiteral("recordClock"));
    m_clock->setAlignment(Qt::AlignCenter);
    m_clock->setTextFormat(Qt::PlainText);
    m_clock->setAccessibleName(tr("Time recorded"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    m_words->setAlignment(Qt::AlignCenter);
    m_words->setObjectName(QStringLiteral("quiet"));
    layout->addWidget(m_button);
    layout->addWidget(m_clock);
    layout->addWidget(m_words);
    setContent(content);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    nameCommands({{m_action, "recordOrStop"}});
    m_action->setShortcut(QKeySequence(Qt::Key_F9));
    connect(m_action, &QAction::triggered, this, &StartCard::pressed);
    connect(m_button, &QPushButton::clicked, this, &StartCard::pressed);
    setState({});
}

void StartCard::setState(const State &state)
{
    QString words, clock = clockText(state.elapsed);
    QString sign = QStringLiteral("record"), text = tr("Record");
    bool able = state.blocked.isEmpty() && !state.ending;
    switch (state.phase) {
    case RunPhase::Ready:
        words = state.ending               ? tr("Writing the last pictures…")
                : !state.blocked.isEmpty() ? state.blocked
                : state.room.isEmpty()     ? tr("F9 records, F9 stops")
                                           : tr("F9 records, F9 stops; %1").arg(state.room);
        break;
    case RunPhase::CountingDown:
        text = tr("Call off");
        sign = QStringLiteral("stop");
        clock = tr("in %1").arg(int(std::ceil(toSeconds(state.countdownLeft))));
        words = tr("Get ready");
        able = true;
        break;
    case RunPhase::Armed:
        text = tr("Call off");
        sign = QStringLiteral("stop");
        words = tr("Waiting for the robot at “%1”; it is recorded from a second before").arg(state.gate);
        able = true;
        break;
    case RunPhase::Recording:
        text = tr("Stop");
        sign = QStringLiteral("stop");
        words = state.room;
        able = true;
        break;
    }
    if (m_button->text() != text || m_button->icon().isNull() || m_button->isEnabled() != able) {
        m_button->setText(text);
        m_button->setAccessibleName(text);
        m_button->setIcon(able ? themeIcon(sign, Qt::white) : themeIcon(sign)); // white would be lost on grey
    }
    const bool isOn = state.phase != RunPhase::Ready;
    if (m_button->property("on").toBool() != isOn) {
        m_button->setProperty("on", isOn);
        m_button->style()->unpolish(m_button);
        m_button->style()->polish(m_button);
    }
    m_button->setEnabled(able);
    m_action->setEnabled(able);
    m_clock->setText(clock);
    if (m_words->text() != words)
        m_words->setText(words);
}

QString StartCard::words() const
{
    return m_words->text();
}

} // namespace odo
