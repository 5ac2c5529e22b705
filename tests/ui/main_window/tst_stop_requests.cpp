// SPDX-License-Identifier: GPL-3.0-or-later
// A window that the system asks to end while it records: by a signal, and at log-out.
#include "core/base/platform/process.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/circle_lesson.h"
#include "tests/ui/support/driven_window.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/program_ends.h"
#include "ui/record/record_page.h"

#include <QApplication>
#include <QDir>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <csignal>

using namespace odo;

class TestStopRequests : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { watchStopSignals(); }
    void init();
    void cleanup();
    void logOutFinishesTheRecording();
    void aSignalEndsTheWindowAndKeepsTheRecording(); // last: a signal comes once

private:
    void record();
    TrialRecord onlyTrial() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
    std::unique_ptr<MainWindow> m_window;
};

void TestStopRequests::init()
{
    test::beginWithoutSettings();
    m_folder = std::make_unique<QTemporaryDir>();
    m_file = m_folder->filePath(QStringLiteral("lesson.odo")).toStdString();
    {
        const auto project = Project::create(m_file, "Lesson");
        QVERIFY(project);
        test::addCircleLesson(**project);
    }
    m_window = std::make_unique<MainWindow>();
    QVERIFY(m_window->openProject(m_file));
    m_window->show();
    m_window->showMode(WindowMode::Record);
    test::waitFor(*m_window);
}

void TestStopRequests::cleanup()
{
    m_window.reset();
}

void TestStopRequests::record()
{
    auto *page = m_window->findChild<RecordPage *>();
    auto *button = page->findChild<QPushButton *>(QStringLiteral("recordButton"));
    QVERIFY(button);
    QTRY_VERIFY_WITH_TIMEOUT(button->isEnabled(), 60'000);
    button->click();
    QTRY_VERIFY_WITH_TIMEOUT(page->isRecording(), 60'000);
    const auto images = [&] {
        const QDir media(m_folder->filePath(QStringLiteral("lesson.media")));
        const QFileInfoList videos = media.entryInfoList({QStringLiteral("*.mkv")}, QDir::Files);
        return std::ranges::any_of(videos, [](const QFileInfo &video) { return video.size() > 50'000; });
    };
    QTRY_VERIFY_WITH_TIMEOUT(images(), 60'000);
}

TrialRecord TestStopRequests::onlyTrial() const
{
    const auto project = Project::openAgain(m_file, Project::Access::ReadOnly);
    const auto trials = (*project)->trials().all().value();
    return trials.size() == 1 ? trials.front() : TrialRecord();
}

/// Somebody may call it off: the window stays.
void TestStopRequests::logOutFinishesTheRecording()
{
    record();
    QVERIFY(onlyTrial().unfinished);
    m_window->finishRecording(); // what StopRequests does then; no session manager can be had here
    QVERIFY(!onlyTrial().unfinished);
    QVERIFY(onlyTrial().durationS > 0);
    QVERIFY(m_window->isVisible());
    QTRY_VERIFY(!m_window->findChild<RecordPage *>()->isRecording());
}

void TestStopRequests::aSignalEndsTheWindowAndKeepsTheRecording()
{
    const StopRequests requests(*m_window);
    record();
    std::raise(SIGTERM);
    QCOMPARE(QApplication::exec(), 0);
    QVERIFY(!m_window->isVisible());
    const TrialRecord trial = onlyTrial();
    QVERIFY(!trial.unfinished && trial.durationS > 0);
}

ODOGRAPH_TEST(TestStopRequests, QApplication)
#include "tst_stop_requests.moc"
