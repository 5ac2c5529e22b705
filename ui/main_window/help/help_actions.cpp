// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/help_actions.h"

#include "ui/compare/compare_page.h"
#include "ui/main_window/language.h"
#include "ui/main_window/preferences/command_keys.h"
#include "ui/main_window/project_pages.h"
#include "ui/models/timeline.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStyle>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

class QWidget;

namespace odo {

class CommandKeys;

namespace {

class HelpDialogsWords
{
    Q_DECLARE_TR_FUNCTIONS(HelpDialogs)
};

/// A table of the commands of each menu that have keys.
QString commandTables(const CommandKeys &keys)
{
    QString html, group;
    for (const CommandKeys::Command &command : keys.commands()) {
        if (command.keys.isEmpty())
            continue;
        if (command.group != group) {
            if (!group.isEmpty())
                html += QStringLiteral("</table>");
            group = command.group;
            html += QStringLiteral("<h3>%1</h3><table cellspacing=\"0\" cellpadding=\"3\">")
                        .arg(group.toHtmlEscaped());
        }
        const QString key = QKeySequence::listToString(command.keys, QKeySequence::NativeText);
        html += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                    .arg(key.toHtmlEscaped(), command.words.toHtmlEscaped());
    }
    return group.isEmpty() ? html : html + QStringLiteral("</table>");
}

} // namespace

/// The list of keys, and what this program is. Not modal for the first, which one wants to read while
/// working.
void showKeys(const CommandKeys &keys, QWidget &window)
{
    auto *dialog = new QDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(HelpDialogsWords::tr("Keys"));
    auto *text = new QTextBrowser;
    text->setAccessibleName(HelpDialogsWords::tr("List of keys"));
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(commandTables(keys) + helpPage(QStringLiteral("keys")));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(460, 560);
    dialog->show();
}

void showAbout(QWidget &window)
{
    QMessageBox box(&window);
    box.setWindowTitle(HelpDialogsWords::tr("About Odograph"));
    box.setTextFormat(Qt::PlainText);
    box.setText(HelpDialogsWords::tr("Odograph %1").arg(QStringLiteral(ODOGRAPH_VERSION)));
    box.setInformativeText(HelpDialogsWords::tr(
        "Measures how a mobile robot moved, from the videos of ordinary cameras.\n\n"
        "Free software under the GNU General Public License, version 3 or later, without any warranty.\n\n"
        "The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation "
        "of Mobile Robot Trajectory”, 2018."));
    box.exec();
}

HelpActions::HelpActions(const CommandKeys &keys, HelpPanel &panel, QWidget &window)
    : QObject(&window), m_keys(keys), m_panel(panel), m_window(window), m_lesson(new Lesson(this)),
      m_help(new QAction(tr("&Help on this page"), this)), m_learn(new QAction(tr("&First lesson"), this)),
      m_showKeys(new QAction(tr("&Keys"), this)), m_about(new QAction(tr("&About Odograph"), this))
{
    nameCommands({{m_help, "help"}, {m_learn, "lesson"}, {m_showKeys, "keys"}});
    m_help->setCheckable(true);
    m_help->setShortcut(QKeySequence(Qt::Key_F1));
    m_showKeys->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_F1));
    m_panel.hide();
    connect(m_help, &QAction::toggled, &m_panel, &QWidget::setVisible);
    connect(&m_panel, &HelpPanel::closed, this, [this] { m_help->setChecked(false); });
    connect(m_learn, &QAction::triggered, this, &HelpActions::beginLesson);
    connect(m_showKeys, &QAction::triggered, this, [this] { showKeys(m_keys, m_window); });
    connect(m_about, &QAction::triggered, this, [this] { showAbout(m_window); });
    showPage();
}

void HelpActions::fillMenu(QMenu &menu)
{
    menu.addActions({m_help, m_learn, m_showKeys});
    menu.addSeparator();
    menu.addAction(m_about);
}

void HelpActions::setPages(const ProjectPages *pages)
{
    m_pages = pages;
    showPage();
    if (!pages) {
        m_lesson->stop();
        return;
    }
    connect(pages, &ProjectPages::shown, this, &HelpActions::showPage);
    // the panel is now visible
    connect(pages, &ProjectPages::shown, m_lesson, &Lesson::poll, Qt::QueuedConnection);
    connect(&pages->review(), &ReviewPage::trialShown, m_lesson, &Lesson::poll);
    connect(&pages->review().timeline(), &Timeline::currentChanged, m_lesson, &Lesson::poll);
}

void HelpActions::showPage()
{
    m_panel.showPage(m_pages ? modeWord(m_pages->mode()) : QStringLiteral("welcome"));
}

void HelpActions::beginLesson()
{
    if (m_pages)
        m_lesson->start(firstLesson(*m_pages));
    else
        Q_EMIT demoWanted();
}

namespace {
constexpr int panelWidth = 300, margin = 12, listIndent = 16;
}

HelpPanel::HelpPanel(QWidget *parent) : QFrame(parent), m_text(new QTextBrowser)
{
    setObjectName(QStringLiteral("helpPanel"));
    setAccessibleName(tr("Help"));
    setFixedWidth(panelWidth);
    auto *title = new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Help")));
    auto *close = new QToolButton;
    close->setIcon(themeIcon(QStringLiteral("close")));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close the help (F1)"));
    close->setAccessibleName(tr("Close the help"));
    connect(close, &QToolButton::clicked, this, &HelpPanel::closed);
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->document()->setDocumentMargin(margin);
    m_text->document()->setIndentWidth(listIndent);
    m_text->setAccessibleName(tr("Help on this page"));
    auto *head = new QHBoxLayout;
    head->setContentsMargins(margin, 6, 6, 0);
    head->addWidget(title, 1);
    head->addWidget(close);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(head);
    layout->addWidget(m_text, 1);
}

void HelpPanel::showPage(const QString &name)
{
    m_wanted = name;
    if (isVisible())
        layOut();
}

void HelpPanel::layOut()
{
    if (!m_wanted.isEmpty())
        m_text->setHtml(helpPage(std::exchange(m_wanted, {})));
}

void HelpPanel::showEvent(QShowEvent *event)
{
    layOut();
    QFrame::showEvent(event);
}

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
    m_position = 0;
    Q_EMIT changed();
}

void Lesson::begin(std::size_t position)
{
    m_position = position;
    const auto &start = m_steps[position].begin;
    m_isDone = start ? start() : LessonStep::IsDone();
    m_done = !m_isDone;
}

void Lesson::next()
{
    if (m_position + 1 >= m_steps.size()) {
        stop();
        return;
    }
    begin(m_position + 1);
    Q_EMIT changed();
}

void Lesson::poll()
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

/// The time line was moved since the step began.
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
         FirstLessonWords::tr("Two cameras filmed a robot. Press Space: both videos, the map and the curves "
                              "play together. Press Space again to stop."),
         [&pages] { return timeMoved(pages, true); }},
        {FirstLessonWords::tr("Read a result"),
         FirstLessonWords::tr(
             "Click the speed curve. The bubble shows the speed at that moment and its uncertainty (±). The "
             "band around the curve contains the true speed in 95 of 100 cases."),
         [&pages] { return timeMoved(pages, false); }},
        {FirstLessonWords::tr("Check the flagged samples"),
         FirstLessonWords::tr(
             "Press Ctrl+Page Up or Ctrl+Page Down until the list of spikes on the right is not empty. A "
             "spike is a measurement that cannot be true; the list gives the reason."),
         [&pages] { return [&pages] { return hasSpikes(pages); }; }},
        {FirstLessonWords::tr("Override it"),
         FirstLessonWords::tr(
             "Click a spike in the list and watch the videos: was the robot really there? Press U to use the "
             "sample nevertheless. Odograph never deletes a measurement."),
         [&pages] { return [&pages, before = judged(pages)] { return judged(pages) > before; }; }},
        {FirstLessonWords::tr("Undo it"),
         FirstLessonWords::tr("Press Ctrl+Z. Odograph saves every change at once, and you can undo it."),
         [&pages] {
             return [&pages, before = judged(pages)] { return judged(pages) < before || before == 0; };
         }},
        {FirstLessonWords::tr("Compare two runs"),
         FirstLessonWords::tr("Press Ctrl+4. Choose two runs on the right: where was one faster? Grey "
                              "differences are not significant."),
         [&pages] { return inMode(pages, ProjectPages::Mode::Compare); }},
        {FirstLessonWords::tr("Find it again"),
         FirstLessonWords::tr("Press Ctrl+5. History lists the whole year: type a team's name to search, "
                              "press Enter to open a run, and see under Teams who made progress."),
         [&pages] { return inMode(pages, ProjectPages::Mode::History); }},
        {FirstLessonWords::tr("That's it"),
         FirstLessonWords::tr(
             "For your own robots: create a project (Ctrl+N). Its Start page leads you from the clips of two "
             "phones, or from connected cameras, to a first result. F1 explains each page."),
         {}},
    };
}

namespace {
constexpr int tickSide = 20;
}

LessonBar::LessonBar(Lesson &lesson, QWidget *parent)
    : QFrame(parent), m_lesson(lesson), m_position(new QLabel), m_tick(new QLabel), m_title(new QLabel),
      m_words(new QLabel), m_next(new QPushButton(tr("Ne&xt"))),
      m_leave(new QPushButton(tr("&Leave the lesson")))
{
    setObjectName(QStringLiteral("lessonBar"));
    setAccessibleName(tr("Lesson"));
    m_position->setObjectName(QStringLiteral("quiet"));
    m_tick->setFixedWidth(tickSide);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    for (QLabel *label : {m_position, m_title, m_words})
        label->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    auto *head = new QHBoxLayout;
    head->setSpacing(8);
    head->addWidget(m_title);
    head->addWidget(m_tick);
    head->addWidget(m_position);
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
    const bool isLast = m_lesson.position() + 1 == m_lesson.count();
    m_position->setText(tr("step %1 of %2").arg(m_lesson.position() + 1).arg(m_lesson.count()));
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
