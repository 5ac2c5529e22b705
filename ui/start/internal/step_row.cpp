// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/internal/step_row.h"

#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace odo {

namespace {

constexpr int discPx = 44, iconPx = 24, tickPx = 18, marginPx = 14, buttonPx = 32, besideTextPx = 10;
constexpr qreal radiusPx = 7;

} // namespace

StepRow::StepRow(const QString &icon, const QString &title, QWidget *parent)
    : QFrame(parent), m_icon(themeIcon(icon)), m_name(title), m_title(new QLabel(title)), m_words(new QLabel),
      m_buttonRow(new QHBoxLayout)
{
    m_title->setObjectName(QStringLiteral("stepTitle"));
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    showAsWords(*m_words);
    m_words->setTextInteractionFlags(Qt::NoTextInteraction);
    m_words->setForegroundRole(QPalette::PlaceholderText);
    m_buttonRow->setSpacing(8);
    m_buttonRow->addStretch(1);
    auto *column = new QVBoxLayout;
    column->setSpacing(4);
    column->addWidget(m_title);
    column->addWidget(m_words);
    column->addSpacing(4);
    column->addLayout(m_buttonRow);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(2 * marginPx + discPx, marginPx, marginPx, marginPx);
    layout->addLayout(column, 1);
}

QPushButton *StepRow::addButton(const QString &text)
{
    auto *button = new QPushButton(text);
    button->setMinimumSize(button->sizeHint().width() + 2 * besideTextPx, buttonPx);
    m_buttonRow->insertWidget(int(m_buttons.size()), button);
    m_buttons << button;
    return button;
}

QString StepRow::words() const
{
    return m_words->text();
}

void StepRow::setState(bool isDone, const QString &words)
{
    m_isDone = isDone;
    m_words->setText(words);
    setAccessibleName(m_name);
    setAccessibleDescription(isDone ? tr("Done. %1").arg(words) : words);
    update();
}

void StepRow::setNext(bool isNext)
{
    m_isNext = isNext;
    bool isWanted = isNext;
    for (QPushButton *button : m_buttons) {
        button->setProperty("primary", isWanted && button->isEnabled());
        isWanted = isWanted && !button->isEnabled();
        button->style()->unpolish(button);
        button->style()->polish(button);
    }
    update();
}

void StepRow::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setPen(QPen(m_isNext ? colours.accent : colours.border, m_isNext ? 1.6 : 1));
    painter.setBrush(colours.card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), radiusPx, radiusPx);
    const QRectF disc(isRightToLeft() ? width() - marginPx - discPx : marginPx, marginPx, discPx, discPx);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.mapGround);
    painter.drawEllipse(disc);
    const QRect icon(qRound(disc.center().x()) - iconPx / 2, qRound(disc.center().y()) - iconPx / 2, iconPx,
                     iconPx);
    m_icon.paint(&painter, icon);
    if (!m_isDone)
        return;
    const BadgeColours done = badgeColours(BadgeState::Good, palette());
    const QRectF mark(disc.right() - tickPx + 3, disc.bottom() - tickPx + 3, tickPx, tickPx);
    painter.setPen(QPen(colours.card, 2));
    painter.setBrush(done.text);
    painter.drawEllipse(mark);
    const qreal inset = 3.5;
    themeIcon(QStringLiteral("tick"), isDark(palette()) ? Qt::black : Qt::white)
        .paint(&painter, mark.adjusted(inset, inset, -inset, -inset).toRect());
}

} // namespace odo
