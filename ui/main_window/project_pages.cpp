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
#include "ui/testbed/testbed_page.h"

#include <QStackedWidget>

namespace odo {

ProjectPages::ProjectPages(Workspace &workspace, QStackedWidget &stack, QObject *parent)
    : QObject(parent), m_workspace(workspace), m_stack(stack),
      m_testbed(new TestbedPage(*workspace.project())),
      m_record(new RecordPage(*workspace.project(), workspace.isReadOnly())),
      m_review(new ReviewPage(*workspace.project())), m_compare(new ComparePage(*workspace.project())),
      m_history(new HistoryPage(*workspace.project(), workspace.isReadOnly())), m_pages{m_testbed, m_record,
                                                                                        m_review, m_compare,
                                                                                        m_history},
      m_stale(m_pages.begin(), m_pages.end())
{
    for (QWidget *page : m_pages)
        m_stack.addWidget(page);
    connectTestbed();
    connectRecord();
    connectReview();
    connectCompare();
    connectHistory();
}

ProjectPages::~ProjectPages()
{
    delete m_record; // what is being recorded is completed before anything else goes
    for (QWidget *page : m_pages)
        if (page != m_record)
            delete page;
}

void ProjectPages::connectTestbed()
{
    connect(m_testbed, &TestbedPage::changed, this, [this](const QString &words) {
        tell(words);
        refreshAllBut(m_testbed);
    });
    connect(m_testbed, &TestbedPage::failed, this, &ProjectPages::failed);
    connect(m_testbed, &TestbedPage::settled, this, &ProjectPages::passOnSettled);
}

void ProjectPages::connectRecord()
{
    connect(m_record, &RecordPage::changed, this, [this](const QString &words) {
        tell(words);
        refreshAllBut(m_record);
    });
    connect(m_record, &RecordPage::failed, this, &ProjectPages::failed);
    connect(m_record, &RecordPage::testbedRequested, this, [this] { show(Mode::Testbed); });
    connect(m_record, &RecordPage::trialChosen, this, &ProjectPages::openTrial);
}

void ProjectPages::connectReview()
{
    connect(m_review, &ReviewPage::failed, this, &ProjectPages::failed);
    connect(m_review, &ReviewPage::settled, this, &ProjectPages::passOnSettled);
}

void ProjectPages::connectCompare()
{
    connect(m_compare, &ComparePage::failed, this, &ProjectPages::failed);
    connect(m_compare, &ComparePage::settled, this, &ProjectPages::passOnSettled);
}

void ProjectPages::connectHistory()
{
    connect(m_history, &HistoryPage::compareRequested, this, [this](const QStringList &trials) {
        if (const Result<void> compared = compareTrials(trials); !compared)
            Q_EMIT failed(compared.error());
    });
    connect(m_history, &HistoryPage::trialChosen, this, &ProjectPages::openTrial);
    connect(m_history, &HistoryPage::teamNamesChanged, this, [this] { refreshAllBut(m_history); });
    connect(m_history, &HistoryPage::notesChanged, this, [this] { refreshAllBut(m_history); });
    connect(m_history, &HistoryPage::trialsChanged, this, [this](const QString &words) {
        tell(words);
        refreshAllBut(m_history);
    });
    connect(m_history, &HistoryPage::failed, this, &ProjectPages::failed);
    connect(m_history, &HistoryPage::settled, this, &ProjectPages::passOnSettled);
}

void ProjectPages::tell(const QString &words)
{
    if (!words.isEmpty())
        Q_EMIT told(words);
}

void ProjectPages::openTrial(const QString &trial)
{
    if (const Result<void> shown = showTrial(trial.toStdString()); !shown)
        Q_EMIT failed(shown.error());
}

void ProjectPages::refreshAllBut(const QWidget *page)
{
    for (QWidget *each : m_pages)
        if (each != page)
            m_stale.insert(each);
    read(m_stack.currentWidget());
    Q_EMIT changed();
}

/// What stands in it is out of date; a page of something else is left alone.
void ProjectPages::read(QWidget *page)
{
    if (m_stale.erase(page) == 0)
        return;
    if (page == m_testbed)
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
    const QString trial = m_review->trial();
    QWidget *page = m_pages.at(static_cast<std::size_t>(mode));
    m_mode = mode;
    read(page);
    if (mode == Mode::Compare)
        m_compare->suggestTrial(trial);
    if (mode == Mode::History && !trial.isEmpty())
        m_history->selectTrial(trial);
    Q_EMIT shown(mode);
    m_stack.setCurrentWidget(page);
    page->setFocus(Qt::OtherFocusReason); // so that the page's keys work at once
}

Result<void> ProjectPages::showTrial(const std::string &name)
{
    const Result<void> done = m_review->showTrial(QString::fromStdString(name));
    if (done)
        show(Mode::Review);
    return done;
}

Result<void> ProjectPages::compareTrials(const QStringList &names)
{
    for (const QString &name : names)
        if (const auto trial = m_workspace.project()->trials().find(name.toStdString()); !trial)
            return tl::unexpected(trial.error());
    m_compare->showTrials(names);
    show(Mode::Compare);
    return {};
}

bool ProjectPages::isSettled() const
{
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

void ProjectPages::saveLayouts() const
{
    m_review->desk().saveLayout();
    m_compare->desk().saveLayout();
}

} // namespace odo
