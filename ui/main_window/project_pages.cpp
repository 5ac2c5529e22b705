// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/project_pages.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/compare/compare_desk.h"
#include "ui/compare/compare_page.h"
#include "ui/history/history_page.h"
#include "ui/main_window/workspace.h"
#include "ui/record/record_page.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/start/start_page.h"
#include "ui/testbed/testbed_page.h"

#include <QCoreApplication>
#include <QStackedWidget>
#include <algorithm>

namespace odo {

namespace {

struct NamedMode
{
    const char *word, *name;
};

/// In the order of the modes.
constexpr std::array<NamedMode, allModes.size()> names{{{"start", QT_TRANSLATE_NOOP("Modes", "Start")},
                                                        {"testbed", QT_TRANSLATE_NOOP("Modes", "Testbed")},
                                                        {"record", QT_TRANSLATE_NOOP("Modes", "Record")},
                                                        {"review", QT_TRANSLATE_NOOP("Modes", "Review")},
                                                        {"compare", QT_TRANSLATE_NOOP("Modes", "Compare")},
                                                        {"history", QT_TRANSLATE_NOOP("Modes", "History")}}};

const NamedMode &named(WindowMode mode)
{
    return names.at(static_cast<std::size_t>(mode));
}

} // namespace

QString modeWord(WindowMode mode)
{
    return QString::fromLatin1(named(mode).word);
}

std::optional<WindowMode> modeFromWord(const QString &word)
{
    const auto same = std::ranges::find(allModes, word, modeWord);
    return same == allModes.end() ? std::nullopt : std::optional(*same);
}

QString modeName(WindowMode mode)
{
    return QCoreApplication::translate("Modes", named(mode).name);
}

ProjectPages::ProjectPages(Workspace &workspace, QStackedWidget &stack, QObject *parent)
    : QObject(parent), m_workspace(workspace), m_stack(stack)
{
    m_maker.setInterval(0);
    connect(&m_maker, &QTimer::timeout, this, &ProjectPages::makeNext);
}

ProjectPages::~ProjectPages()
{
    delete m_record; // what is being recorded is completed before anything else goes
    for (QWidget *page : m_pages)
        if (page != m_record)
            delete page;
}

void ProjectPages::makeNext()
{
    const auto missing = std::ranges::find(m_pages, nullptr);
    if (!m_review)
        page(Mode::Review);
    else if (!m_isOneShown)
        show(isNothingMeasured(*m_workspace.project()).value_or(false) ? Mode::Start : Mode::Review);
    else if (missing != m_pages.end())
        page(static_cast<Mode>(missing - m_pages.begin()));
    else
        m_maker.stop();
}

void ProjectPages::makeAll()
{
    m_maker.start();
    while (m_maker.isActive())
        makeNext();
}

QWidget *ProjectPages::page(Mode mode)
{
    QWidget *&page = m_pages.at(static_cast<std::size_t>(mode));
    if (page)
        return page;
    page = make(mode);
    m_stack.addWidget(page);
    m_stale.insert(page);
    Q_EMIT made(mode);
    return page;
}

/// Parented from the start: reparenting a widget restyles it and all its children.
QWidget *ProjectPages::make(Mode mode)
{
    switch (mode) {
    case Mode::Start:
        return makeStart();
    case Mode::Testbed:
        return makeTestbed();
    case Mode::Record:
        return makeRecord();
    case Mode::Review:
        return makeReview();
    case Mode::Compare:
        return makeCompare();
    case Mode::History:
        break;
    }
    return makeHistory();
}

StartPage &ProjectPages::start()
{
    page(Mode::Start);
    return *m_start;
}

TestbedPage &ProjectPages::testbed()
{
    page(Mode::Testbed);
    return *m_testbed;
}

void ProjectPages::finishRecording()
{
    if (m_record)
        m_record->finishRecording();
}

RecordPage &ProjectPages::record()
{
    page(Mode::Record);
    return *m_record;
}

ReviewPage &ProjectPages::review()
{
    page(Mode::Review);
    return *m_review;
}

ComparePage &ProjectPages::compare()
{
    page(Mode::Compare);
    return *m_compare;
}

HistoryPage &ProjectPages::history()
{
    page(Mode::History);
    return *m_history;
}

QWidget *ProjectPages::makeStart()
{
    m_start = new StartPage(*m_workspace.project(), m_workspace.isReadOnly(), &m_stack);
    connect(m_start, &StartPage::failed, this, &ProjectPages::failed);
    return m_start;
}

QWidget *ProjectPages::makeTestbed()
{
    m_testbed = new TestbedPage(*m_workspace.project(), &m_stack);
    connect(m_testbed, &TestbedPage::changed, this,
            [this](const QString &words, const std::vector<Message> &warnings) {
                showOutcome(words, warnings);
                refreshAllBut(m_testbed);
            });
    connect(m_testbed, &TestbedPage::failed, this, &ProjectPages::failed);
    connect(m_testbed, &TestbedPage::settled, this, &ProjectPages::passOnSettled);
    return m_testbed;
}

QWidget *ProjectPages::makeRecord()
{
    m_record = new RecordPage(*m_workspace.project(), m_workspace.isReadOnly(), {}, &m_stack);
    connect(m_record, &RecordPage::changed, this,
            [this](const QString &words, const std::vector<Message> &warnings) {
                showOutcome(words, warnings);
                refreshAllBut(m_record);
            });
    connect(m_record, &RecordPage::warned, this, &ProjectPages::warned);
    connect(m_record, &RecordPage::failed, this, &ProjectPages::failed);
    connect(m_record, &RecordPage::testbedRequested, this, [this] { show(Mode::Testbed); });
    connect(m_record, &RecordPage::trialChosen, this, &ProjectPages::openTrial);
    return m_record;
}

QWidget *ProjectPages::makeReview()
{
    m_review = new ReviewPage(*m_workspace.project(), &m_stack);
    connect(m_review, &ReviewPage::failed, this, &ProjectPages::failed);
    connect(m_review, &ReviewPage::settled, this, &ProjectPages::passOnSettled);
    connect(m_review, &ReviewPage::changed, this, [this] { refreshAllBut(nullptr); });
    return m_review;
}

QWidget *ProjectPages::makeCompare()
{
    m_compare = new ComparePage(*m_workspace.project(), &m_stack);
    connect(m_compare, &ComparePage::failed, this, &ProjectPages::failed);
    connect(m_compare, &ComparePage::settled, this, &ProjectPages::passOnSettled);
    return m_compare;
}

QWidget *ProjectPages::makeHistory()
{
    m_history = new HistoryPage(*m_workspace.project(), m_workspace.isReadOnly(), &m_stack);
    connect(m_history, &HistoryPage::compareRequested, this, [this](const QStringList &trials) {
        if (const Result<void> compared = compareTrials(trials); !compared)
            Q_EMIT failed(compared.error());
    });
    connect(m_history, &HistoryPage::trialChosen, this, &ProjectPages::openTrial);
    connect(m_history, &HistoryPage::teamNamesChanged, this, [this] { refreshAllBut(m_history); });
    connect(m_history, &HistoryPage::notesChanged, this, [this] { refreshAllBut(m_history); });
    connect(m_history, &HistoryPage::trialsChanged, this, [this](const QString &words) {
        showOutcome(words);
        refreshAllBut(m_history);
    });
    connect(m_history, &HistoryPage::failed, this, &ProjectPages::failed);
    connect(m_history, &HistoryPage::settled, this, &ProjectPages::passOnSettled);
    return m_history;
}

void ProjectPages::showOutcome(const QString &words, const std::vector<Message> &warnings)
{
    if (!words.isEmpty())
        Q_EMIT messageReady(words, warnings);
}

void ProjectPages::openTrial(const QString &trial)
{
    if (const Result<void> shown = showTrial(trial.toStdString()); !shown)
        Q_EMIT failed(shown.error());
}

void ProjectPages::refreshAllBut(const QWidget *page)
{
    for (QWidget *each : m_pages)
        if (each && each != page)
            m_stale.insert(each);
    read(m_stack.currentWidget());
    Q_EMIT changed();
}

/// Its contents are out of date; a page of something else is left alone.
void ProjectPages::read(QWidget *page)
{
    if (m_stale.erase(page) == 0)
        return;
    if (page == m_start)
        m_start->refresh();
    else if (page == m_testbed)
        m_testbed->refresh();
    else if (page == m_record)
        m_record->refresh();
    else if (page == m_review)
        m_review->refresh();
    else if (page == m_compare)
        m_compare->refresh();
    else
        m_history->refresh();
}

void ProjectPages::show(Mode mode)
{
    m_isOneShown = true;
    m_mode = mode;
    const QString trial = m_review ? m_review->trial() : QString();
    QWidget *shownPage = page(mode);
    read(shownPage);
    if (mode == Mode::Compare)
        m_compare->suggestTrial(trial);
    if (mode == Mode::History && !trial.isEmpty())
        m_history->selectTrial(trial);
    Q_EMIT shown(mode);
    m_stack.setCurrentWidget(shownPage);
    shownPage->setFocus(Qt::OtherFocusReason); // so that the page's keys work at once
}

Result<void> ProjectPages::showTrial(const std::string &name)
{
    Result<void> done = review().showTrial(QString::fromStdString(name));
    if (done)
        show(Mode::Review);
    return done;
}

Result<void> ProjectPages::compareTrials(const QStringList &names)
{
    for (const QString &name : names)
        ODO_TRY(m_workspace.project()->trials().find(name.toStdString()));
    compare().showTrials(names);
    show(Mode::Compare);
    return {};
}

bool ProjectPages::isSettled() const
{
    if (!m_isOneShown)
        return false;
    const QWidget *page = m_stack.currentWidget();
    if (page == m_review)
        return m_review->isSettled();
    if (page == m_compare)
        return m_compare->isSettled();
    if (page == m_history)
        return m_history->isSettled();
    return page != m_testbed || m_testbed->isSettled();
}

void ProjectPages::passOnSettled()
{
    if (isSettled())
        Q_EMIT settled();
}

bool ProjectPages::isRecording() const
{
    return m_record != nullptr && m_record->isRecording();
}

void ProjectPages::saveNotes()
{
    if (m_history)
        m_history->saveNotes();
}

void ProjectPages::saveLayouts() const
{
    if (m_review)
        m_review->desk().saveLayout();
    if (m_compare)
        m_compare->desk().saveLayout();
}

QStringList ProjectPages::chosenTrials() const
{
    if (m_history && m_mode == Mode::History)
        return m_history->selectedTrials();
    const TrialScenePtr shown = scene();
    return shown ? QStringList(QString::fromStdString(shown->trial.name)) : QStringList();
}

TrialScenePtr ProjectPages::scene() const
{
    return m_review ? m_review->scene() : nullptr;
}

} // namespace odo
