// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/trouble_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace odo {

TroubleBar::TroubleBar(QWidget *parent) : QFrame(parent), m_words(new QLabel), m_button(new QPushButton)
{
    setObjectName(QStringLiteral("messageBar"));
    setProperty("kind", QStringLiteral("bad"));
    setAccessibleName(tr("What is the matter"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->addWidget(m_words, 1);
    layout->addWidget(m_button);
    m_button->setAccessibleName(tr("Put it right"));
    connect(m_button, &QPushButton::clicked, this, &TroubleBar::clicked);
    hide();
}

void TroubleBar::setWords(const QString &words, const QString &button)
{
    if (words != m_words->text())
        m_words->setText(words);
    m_button->setText(button);
    m_button->setVisible(!button.isEmpty());
    setVisible(!words.isEmpty());
}

QString TroubleBar::words() const
{
    return isHidden() ? QString() : m_words->text();
}

} // namespace odo
