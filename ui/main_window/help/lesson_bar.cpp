// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/lesson_bar.h"

#include "ui/main_window/help/lesson.h"
#include "ui/views/theme_icon.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace odo {
namespace {
constexpr int tickSide = 20;
}

LessonBar::LessonBar(Lesson &lesson, QWidget *parent)
    : QFrame(parent), m_lesson(lesson), m_place(new QLabel), m_tick(new QLabel), m_title(new QLabel), m_words(new QLabel),
      m_next(new QPushButton(tr("Ne&xt"))), m_leave(new QPushButton(tr("&Leave the lesson")))
{
    setObjectName(QStringLiteral("lessonBar"));
    setAccessibleName(tr("Lesson"));
    m_place->setObjectName(QStringLiteral("quiet"));
    m_tick->setFixedWidth(tickSide);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    for (QLabel *label : {m_place, m_title, m_words})
        label->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    auto *head = new QHBoxLayout;
    head->setSpacing(8);
    head->addWidget(m_title);
    head->addWidget(m_tick);
    head->addWidget(m_place);
    head->addStretch(1);
    auto *texts = new QVBoxLayout;
    texts->setSpacing(2);
    texts->addLayout(head);
    texts->addWidget(m_words);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 8, 12, 8);
    layout->setSpacing(12);
    layout->addLayout(texts, 1);
    layout->addWidget(m_leave);
    layout->addWidget(m_next);
    connect(m_next, &QPushButton::clicked, &m_lesson, &Lesson::next);
    connect(m_leave, &QPushButton::clicked, &m_lesson, &Lesson::stop);
    connect(&m_lesson, &Lesson::changed, this, &LessonBar::follow);
    follow();
}

void LessonBar::follow()
{
    setVisible(m_lesson.isRunning());
    if (!m_lesson.isRunning())
        return;
    const bool isLast = m_lesson.place() + 1 == m_lesson.count();
    m_place->setText(tr("step %1 of %2").arg(m_lesson.place() + 1).arg(m_lesson.count()));
    m_title->setText(m_lesson.step().title);
    m_words->setText(m_lesson.step().words);
    const bool wasDone = m_lesson.isDone() && m_lesson.step().begin;
    m_tick->setPixmap(wasDone ? themeIcon(QStringLiteral("tick")).pixmap(tickSide, tickSide) : QPixmap());
    m_tick->setAccessibleName(wasDone ? tr("done") : QString());
    m_next->setText(isLast ? tr("&Finish") : m_lesson.isDone() ? tr("&Next") : tr("&Skip"));
    m_next->setProperty("primary", m_lesson.isDone());
    m_next->style()->polish(m_next);
    m_leave->setVisible(!isLast);
}

} // namespace odo
