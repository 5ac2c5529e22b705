// SPDX-License-Identifier: GPL-3.0-or-later
// Two windows on one project: the first changes it, the second shows it.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"

#include <QApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTwoWindows : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        m_project = storeExample(m_folder.path().toStdString()).value();
    }

    void theSecondOnlyShows()
    {
        auto first = std::make_unique<MainWindow>();
        QVERIFY(first->openProject(m_project));
        QVERIFY(!first->workspace().isReadOnly());
        QCOMPARE(message(*first), QString());

        MainWindow second;
        QVERIFY(second.openProject(m_project));
        QVERIFY(second.workspace().isReadOnly());
        QVERIFY2(message(second).startsWith(
                     QLatin1String("project 'example.odo': it is open in another window (")) &&
                     message(second).endsWith(QLatin1String(
                         "It is read-only here; to change it, close it there and reopen it here.")),
                 qPrintable(message(second)));
        QVERIFY(second.showTrial("Trial 2"));

        // The first goes on, and the second sees it.
        QVERIFY(first->workspace().project()->setTitle("Changed meanwhile"));
        QCOMPARE(second.workspace().project()->title().value(), std::string("Changed meanwhile"));

        first.reset();
        QVERIFY(second.openProject(m_project));
        QVERIFY(!second.workspace().isReadOnly());
        QVERIFY(second.workspace().project()->setTitle("Year 9 robotics"));
    }

    void aSyncedFolderIsToldOf()
    {
        const std::filesystem::path folder = std::filesystem::path(m_folder.path().toStdString()) / "Dropbox";
        std::filesystem::create_directory(folder);
        std::filesystem::copy_file(m_project, folder / "example.odo");
        MainWindow window;
        QVERIFY(window.openProject(folder / "example.odo"));
        QVERIFY(!window.workspace().isReadOnly());
        QVERIFY2(message(window).startsWith(
                     QLatin1String("project 'example.odo': it is in a folder that Dropbox copies")),
                 qPrintable(message(window)));
        std::filesystem::remove_all(folder);
    }

    void theSameWindowOpensItAgain()
    {
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        QVERIFY(window.openProject(m_project));
        QVERIFY(!window.workspace().isReadOnly());
        QVERIFY(QFile::exists(lock()));
        QVERIFY(!window.openProject(m_folder.filePath(QStringLiteral("none.odo")).toStdString()));
        QVERIFY(QFile::exists(lock())); // it still has the one before
    }

    void nothingIsLeftBeside()
    {
        {
            MainWindow window;
            QVERIFY(window.openProject(m_project));
        }
        QVERIFY(!QFile::exists(lock()));
    }

private:
    static QString message(const MainWindow &window) { return window.findChild<MessageBar *>()->text(); }
    QString lock() const { return QString::fromStdString(m_project.string() + ".lock"); }

    QTemporaryDir m_folder;
    std::filesystem::path m_project;
};

ODOGRAPH_TEST(TestTwoWindows, QApplication)
#include "tst_two_windows.moc"
