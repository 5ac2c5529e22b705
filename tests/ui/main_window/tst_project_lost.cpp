// SPDX-License-Identifier: GPL-3.0-or-later
// What a window does with what comes from outside: another program's changes, a file that is taken away; and
// when it says saved.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"

#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;
namespace fs = std::filesystem;

class TestProjectLost : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { beginWithoutSettings(); }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = storeExample(folder()).value();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(m_window->openProject(m_project));
    }
    void cleanup() { m_window.reset(); }

    void savedMeansThatACopyOfTheFileHasIt()
    {
        QTRY_COMPARE(saved(), QStringLiteral("All changes saved"));
        QVERIFY(project().teams().add({0, "Kestrel", "9B"}));
        QTRY_COMPARE(saved(), QStringLiteral("Saving…"));
        QTRY_COMPARE_WITH_TIMEOUT(saved(), QStringLiteral("All changes saved"), 10'000);
        fs::copy_file(m_project, folder() / "copy.odo");
        const auto copy = Project::open(folder() / "copy.odo", Project::Access::ReadOnly);
        QVERIFY((*copy)->teams().find("Kestrel"));
    }

    void whatAnotherProgramChangesIsFollowed()
    {
        QSignalSpy changed(&m_window->workspace(), &Workspace::changed);
        QCOMPARE(runProgram({QStringLiteral("camera"), QStringLiteral("add"),
                             QString::fromStdString(m_project.string()), QStringLiteral("C")})
                     .exitStatus,
                 0);
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, 2000);
        QVERIFY(project().cameras().find("C"));
    }

    void ofItsOwnChangesItIsNotTold()
    {
        QSignalSpy changed(&m_window->workspace(), &Workspace::changed);
        QVERIFY(project().teams().add({0, "Kestrel", "9B"}));
        QTRY_COMPARE_WITH_TIMEOUT(saved(), QStringLiteral("All changes saved"), 10'000); // it has looked
        QCOMPARE(changed.count(), 0);
    }

    void aFileThatIsTakenAwayIsRescued_data()
    {
        QTest::addColumn<bool>("isReplaced");
        QTest::newRow("deleted") << false;
        QTest::newRow("replaced") << true;
    }
    void aFileThatIsTakenAwayIsRescued()
    {
        QFETCH(bool, isReplaced);
        QVERIFY(project().teams().add({0, "Kestrel", "9B"}));
        if (isReplaced) {
            QVERIFY(Project::create(folder() / "other.odo", "another"));
            fs::rename(folder() / "other.odo", m_project);
        } else {
            fs::remove(m_project);
        }
        const fs::path rescued = folder() / "example (rescued).odo";
        QTRY_COMPARE_WITH_TIMEOUT(project().file(), rescued, 3000);
        const QString words = m_window->findChild<MessageBar *>()->text();
        QCOMPARE(words,
                 QStringLiteral("Another program deleted, renamed or replaced “example.odo”. Odograph "
                                "rescued its contents in “example (rescued).odo” and opened that project."));
        QVERIFY(!m_window->workspace().isReadOnly());
        QVERIFY(project().teams().find("Kestrel"));
        QVERIFY(project().teams().add({0, "Merlin", "9B"}));
        const auto recordings = project().trials().recordings(project().trials().find("Trial 1")->id);
        QVERIFY(recordings && !recordings->empty() && fs::exists(project().resolve(recordings->front())));
        if (isReplaced) {
            const auto other = Project::open(m_project, Project::Access::ReadOnly);
            QVERIFY(other);
            QCOMPARE((*other)->title().value(), std::string("another"));
        }
    }

    /// It is the same project, whole, under another name.
    void oneThatWasRenamedWithItsVideosIsFollowed()
    {
        QVERIFY(project().teams().add({0, "Kestrel", "9B"}));
        fs::create_directories(folder() / "example.media");
        fs::rename(folder() / "example.media", folder() / "new.media");
        fs::rename(m_project, folder() / "new.odo");
        QTRY_COMPARE_WITH_TIMEOUT(project().file(), fs::canonical(folder()) / "new.odo", 3000);
        QCOMPARE(m_window->findChild<MessageBar *>()->text(),
                 QStringLiteral(
                     "Another program renamed “example.odo” and its videos. It is now open as “new.odo”."));
        QVERIFY(project().teams().find("Kestrel"));
        QVERIFY(project().teams().add({0, "Merlin", "9B"}));
        QVERIFY(!fs::exists(folder() / "example (rescued).odo"));
        m_window.reset();
        for (const char *left : {"example.odo", "example.odo-wal", "example.odo-shm"})
            QVERIFY2(!fs::exists(folder() / left), left);
    }

    void whatIsCopiedOverItIsOpened_data()
    {
        QTest::addColumn<bool>("isProject");
        QTest::newRow("another project") << true;
        QTest::newRow("something else") << false;
    }
    void whatIsCopiedOverItIsOpened()
    {
        QFETCH(bool, isProject);
        QVERIFY(project().teams().add({0, "Kestrel", "9B"}));
        QVERIFY(Project::create(folder() / "other.odo", "another"));
        if (!isProject)
            fs::resize_file(folder() / "other.odo", 1000);
        fs::copy_file(folder() / "other.odo", m_project, fs::copy_options::overwrite_existing);
        const auto *messages = m_window->findChild<MessageBar *>();
        if (!isProject) {
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().project(), 3000);
            QVERIFY(messages->text().contains(QStringLiteral("example.odo")));
            return;
        }
        QTRY_COMPARE_WITH_TIMEOUT(project().title().value(), std::string("another"), 3000);
        QCOMPARE(messages->text(),
                 QStringLiteral("Another program overwrote “example.odo” while it was open. Its earlier "
                                "contents are gone; the window shows the new ones."));
        QVERIFY(!m_window->workspace().isReadOnly());
        QVERIFY(!project().teams().find("Kestrel"));
        QVERIFY(project().teams().add({0, "Merlin", "9B"}));
    }

private:
    fs::path folder() const { return m_folder->path().toStdString(); }
    Project &project() { return *m_window->workspace().project(); }
    QString saved() const { return m_window->findChild<StatusLine *>()->findChild<QLabel *>()->text(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    fs::path m_project;
    std::unique_ptr<MainWindow> m_window;
};

ODOGRAPH_TEST(TestProjectLost, QApplication)
#include "tst_project_lost.moc"
