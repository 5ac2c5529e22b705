// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/lesson.h"

#include "ui/compare/compare_page.h"
#include "ui/main_window/project_pages.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

void Lesson::start(std::vector<LessonStep> steps)
{
    m_steps = std::move(steps);
    if (!m_steps.empty())
        begin(0);
    Q_EMIT changed();
}

void Lesson::stop()
{
    m_isDone = {};
    m_steps.clear();
    m_place = 0;
    Q_EMIT changed();
}

void Lesson::begin(std::size_t place)
{
    m_place = place;
    const auto &start = m_steps[place].begin;
    m_isDone = start ? start() : LessonStep::IsDone();
    m_done = !m_isDone;
}

void Lesson::next()
{
    if (m_place + 1 >= m_steps.size()) {
        stop();
        return;
    }
    begin(m_place + 1);
    Q_EMIT changed();
}

void Lesson::look()
{
    if (!isRunning() || m_done || !m_isDone())
        return;
    m_done = true;
    Q_EMIT changed();
}

namespace {

class FirstLessonWords
{
    Q_DECLARE_TR_FUNCTIONS(FirstLesson)
};

constexpr auto aWhile = std::chrono::milliseconds(300);

/// The time line stands elsewhere than at the beginning of the step.
LessonStep::IsDone timeMoved(const ProjectPages &pages, bool playing)
{
    const Timeline &timeline = pages.review().timeline();
    return [&timeline, playing, from = timeline.currentTime()] {
        return timeline.isPlaying() == playing && std::chrono::abs(timeline.currentTime() - from) > aWhile;
    };
}

bool hasSpikes(const ProjectPages &pages)
{
    const TrialScenePtr scene = pages.review().scene();
    return scene && std::ranges::any_of(scene->robots, [](const SceneRobot &robot) {
               return robot.analysis && !robot.analysis->profile.spikes.empty();
           });
}

/// Samples of the trial on screen that a person has judged.
std::ptrdiff_t judged(const ProjectPages &pages)
{
    std::ptrdiff_t count = 0;
    if (const TrialScenePtr scene = pages.review().scene())
        for (const SceneRobot &robot : scene->robots)
            if (robot.analysis)
                count += std::ranges::count_if(robot.analysis->profile.samples, [](const Sample &sample) {
                    return hasFlag(sample.flags, SampleFlag::ByHand);
                });
    return count;
}

LessonStep::IsDone inMode(const ProjectPages &pages, ProjectPages::Mode mode)
{
    return [&pages, mode] { return pages.mode() == mode; };
}

} // namespace

std::vector<LessonStep> firstLesson(const ProjectPages &pages)
{
    return {
        {FirstLessonWords::tr("Play a run"),
         FirstLessonWords::tr("Two cameras watched a robot drive. Press Space: both videos, the map and the "
                              "curves play in step. "
                              "Space again stops."),
         [&pages] { return timeMoved(pages, true); }},
        {FirstLessonWords::tr("Read a figure"),
         FirstLessonWords::tr(
             "Click into the speed curve. The bubble tells the speed at that moment and its ±: how "
             "far off it may be. The band around the curve is where the truth lies in 95 of 100 cases."),
         [&pages] { return timeMoved(pages, false); }},
        {FirstLessonWords::tr("Look at what was flagged"),
         FirstLessonWords::tr("Go through the trials with Ctrl+Page Up and Ctrl+Page Down to one whose list "
                              "of spikes, at the right, "
                              "is not empty. A spike is a moment at which what was measured cannot be true; "
                              "the list says why."),
         [&pages] { return [&pages] { return hasSpikes(pages); }; }},
        {FirstLessonWords::tr("Overrule it"),
         FirstLessonWords::tr("Click a spike in the list and look at the videos: was the robot really there? "
                              "Press U to use the sample "
                              "all the same. Nothing that was measured is ever lost."),
         [&pages] { return [&pages, before = judged(pages)] { return judged(pages) > before; }; }},
        {FirstLessonWords::tr("Take it back"),
         FirstLessonWords::tr("Press Ctrl+Z. Whatever you change is saved at once, and can be taken back."),
         [&pages] {
             return [&pages, before = judged(pages)] { return judged(pages) < before || before == 0; };
         }},
        {FirstLessonWords::tr("Compare two runs"),
         FirstLessonWords::tr("Press Ctrl+4. Choose two runs at the right: where was one faster, and is that "
                              "more than the error? "
                              "What is grey is not."),
         [&pages] { return inMode(pages, ProjectPages::Mode::Compare); }},
        {FirstLessonWords::tr("Find it again"),
         FirstLessonWords::tr("Press Ctrl+5. History holds the whole year: type a team's name to search, "
                              "open a run with Enter, and see "
                              "under Teams who made progress."),
         [&pages] { return inMode(pages, ProjectPages::Mode::History); }},
        {FirstLessonWords::tr("That was it"),
         FirstLessonWords::tr("With your own robots: make a project (Ctrl+N), set up the floor in Testbed "
                              "(Ctrl+1), then record (Ctrl+2) "
                              "or bring in videos (Ctrl+I). F1 explains each page."),
         {}},
    };
}

namespace {
constexpr int tickSide = 20;
}

LessonBar::LessonBar(Lesson &lesson, QWidget *parent)
    : QFrame(parent), m_lesson(lesson), m_place(new QLabel), m_tick(new QLabel), m_title(new QLabel),
      m_words(new QLabel), m_next(new QPushButton(tr("Ne&xt"))),
      m_leave(new QPushButton(tr("&Leave the lesson")))
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
