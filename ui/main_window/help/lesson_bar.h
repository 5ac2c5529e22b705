// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace odo {

class Lesson;

/// The present step of a lesson, below the page; hidden while none runs.
class LessonBar : public QFrame
{
    Q_OBJECT
public:
    /// lesson must outlive it.
    explicit LessonBar(Lesson &lesson, QWidget *parent = nullptr);

private:
    void follow();

    Lesson &m_lesson;
    QLabel *m_place, *m_tick, *m_title, *m_words;
    QPushButton *m_next, *m_leave;
};

} // namespace odo
