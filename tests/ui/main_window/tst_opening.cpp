// SPDX-License-Identifier: GPL-3.0-or-later
// A project is opened in the background, and the window tells that it opens, or why it does not.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/models/background_task.h"

#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

/// Cancels what a workspace opens at the last moment: when its thread has ended, and before that is taken
/// note of.
class LateCancel : public QObject
{
public:
    explicit LateCancel(Workspace &workspace) : m_workspace(workspace) { qApp->installEventFilter(this); }
    bool eventFilter(QObject *receiver, QEvent *event) override
    {
        if (event->type() == QEvent::MetaCall && qobject_cast<BackgroundTask *>(receiver))
            m_workspace.cancel();
        return false;
    }

private:
    Workspace &m_workspace;
};

} // namespace

class TestOpening : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        m_project = storeExample(m_folder.path().toStdString()).value();
    }

    void theWindowTellsThatItOpens()
    {
        MainWindow window;
        window.show();
        QSignalSpy opened(&window.workspace(), &Workspace::opened);
        window.beginOpening(m_project);
        auto *indicator = window.findChild<JobIndicator *>();
        QVERIFY(indicator->isVisible());
        QCOMPARE(indicator->text(), QStringLiteral("Opening example.odo"));
        QVERIFY(!window.workspace().project());
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(!window.workspace().isReadOnly());
        QVERIFY(!indicator->isVisible());
        QTRY_VERIFY(window.windowTitle().startsWith(QStringLiteral("Year 9 robotics — Trial 1")));
        QVERIFY(window.workspace().project()->setTitle("Year 9 robotics"));
    }

    void theOneBeforeStaysUntilThen()
    {
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        const std::filesystem::path other = path("other.odo");
        QVERIFY(Project::create(other, "Another class"));
        QSignalSpy opened(&window.workspace(), &Workspace::opened);
        window.beginOpening(other);
        QCOMPARE(window.workspace().project()->title().value(), std::string("Year 9 robotics"));
        QVERIFY(!window.workspace().open(other)); // one at a time
        QTRY_COMPARE(opened.count(), 1);
        QCOMPARE(window.workspace().project()->title().value(), std::string("Another class"));
        QVERIFY(!QFile::exists(QString::fromStdString(m_project.string() + ".lock"))); // it was given up
    }

    void tellsWhyItDoesNotOpen_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("words");
        QTest::newRow("missing") << QByteArray() << "the file does not exist";
        QTest::newRow("no project") << QByteArray(4096, 'x') << "it is not a project file";
    }

    void tellsWhyItDoesNotOpen()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, words);
        const QString bad = QString::fromStdString(path("bad.odo"));
        QFile::remove(bad);
        if (QFile file(bad); !content.isEmpty() && file.open(QIODevice::WriteOnly))
            file.write(content);
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        window.show();
        QSignalSpy failed(&window.workspace(), &Workspace::jobFailed);
        window.beginOpening(bad.toStdString());
        QTRY_COMPARE(failed.count(), 1);
        const QString told = window.findChild<MessageBar *>()->text();
        QVERIFY2(told.contains(words), qPrintable(told));
        QVERIFY(!QFile::exists(bad + QStringLiteral(".lock")));
        QVERIFY(!window.findChild<JobIndicator *>()->isVisible());
        QCOMPARE(window.workspace().project()->title().value(), std::string("Year 9 robotics"));
        QVERIFY(!window.workspace().isReadOnly()); // it still has the lock
        QVERIFY(window.workspace().project()->setTitle("Year 9 robotics"));
    }

    /// By the keyboard alone: the button is reached by Tab, and pressed by Enter.
    void aDamagedOneIsRestoredFromItsBackup()
    {
        const QString damaged = QString::fromStdString(path("torn.odo").string());
        QVERIFY(QFile::copy(QString::fromStdString(m_project.string()), damaged + QStringLiteral(".bak-10")));
        QFile backup(damaged + QStringLiteral(".bak-10"));
        QVERIFY(backup.open(QIODevice::ReadOnly));
        const QByteArray bytes = backup.readAll().replace(8 * 4096, 4096, QByteArray(4096, 'U'));
        QFile file(damaged);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        MainWindow window;
        window.show();
        QSignalSpy failed(&window.workspace(), &Workspace::jobFailed),
            opened(&window.workspace(), &Workspace::opened);
        window.beginOpening(damaged.toStdString());
        QTRY_COMPARE(failed.count(), 1);
        auto *bar = window.findChild<MessageBar *>();
        const QString written =
            QLocale().toString(QFileInfo(backup.fileName()).lastModified(), QLocale::ShortFormat);
        QCOMPARE(bar->text(), QStringLiteral("Project 'torn.odo': the file is damaged. Its backup of %1 is "
                                             "intact; it does not contain later changes.")
                                  .arg(written));
        auto *button = bar->findChild<QPushButton *>();
        QCOMPARE(button->text(), QStringLiteral("Restore the backup"));
        QVERIFY(button->isVisible());
        QVERIFY(QTest::qWaitForWindowActive(&window));
        for (int tabs = 0; tabs < 40 && !button->hasFocus(); ++tabs)
            QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &window, Qt::Key_Tab);
        QVERIFY(button->hasFocus());
        QTest::keyClick(button, Qt::Key_Return);
        QTRY_COMPARE(opened.count(), 1);
        QCOMPARE(window.workspace().project()->file().filename().string(), std::string("torn.odo"));
        QCOMPARE(window.workspace().project()->title().value(), std::string("Year 9 robotics"));
        QVERIFY(!window.workspace().isReadOnly());
        QVERIFY(!button->isVisible());
        QTRY_COMPARE(
            bar->text(),
            QStringLiteral("The backup was restored. The damaged file is kept as “torn.odo.damaged”."));
        QFile kept(damaged + QStringLiteral(".damaged"));
        QVERIFY(kept.open(QIODevice::ReadOnly) && kept.readAll() == bytes);
    }

    /// Nor is anything offered of what is no damage.
    void withoutABackupNothingIsOffered()
    {
        const QString bad = QString::fromStdString(path("text.odo").string());
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("a letter") > 0);
        file.close();
        MainWindow window;
        window.show();
        QSignalSpy failed(&window.workspace(), &Workspace::jobFailed);
        window.beginOpening(bad.toStdString());
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(!window.findChild<MessageBar *>()->findChild<QPushButton *>()->isVisible());
    }

    void canBeCancelled()
    {
        MainWindow window;
        const LateCancel cancel(window.workspace());
        QSignalSpy failed(&window.workspace(), &Workspace::jobFailed);
        window.beginOpening(m_project);
        QTRY_COMPARE(failed.count(), 1);
        QCOMPARE(window.findChild<MessageBar *>()->text(), QStringLiteral("Cancelled. Nothing was changed."));
        QVERIFY(!window.workspace().project());
        MainWindow other; // the lock is free again
        QVERIFY(other.openProject(m_project));
        QVERIFY(!other.workspace().isReadOnly());
    }

    /// What was made by then is on the disk, and that is said.
    void whatWasMadeBeforeItWasCancelledIsNamed()
    {
        const std::filesystem::path made = path("made.odo");
        MainWindow window;
        const LateCancel cancel(window.workspace());
        QSignalSpy failed(&window.workspace(), &Workspace::jobFailed);
        QVERIFY(window.workspace().makeAndOpen(
            [made](const JobControl &) -> Result<std::filesystem::path> {
                if (const auto project = Project::create(made, "Made"); !project)
                    return tl::unexpected(project.error());
                return made;
            },
            foreignWords("Making a project")));
        QTRY_COMPARE(failed.count(), 1);
        QTRY_COMPARE(window.findChild<MessageBar *>()->text(),
                     QStringLiteral("“made.odo” was written before you cancelled. It was not opened."));
        QVERIFY(!window.workspace().project());
        QVERIFY(Project::open(made, Project::Access::ReadOnly));
    }

    void opensTheSameOneAgain()
    {
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        QSignalSpy opened(&window.workspace(), &Workspace::opened);
        window.beginOpening(m_project);
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(!window.workspace().isReadOnly());
    }

    void opensForReadingWhatAnotherWindowHas()
    {
        MainWindow first, second;
        QVERIFY(first.openProject(m_project));
        QSignalSpy opened(&second.workspace(), &Workspace::opened);
        second.beginOpening(m_project);
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(second.workspace().isReadOnly());
        QVERIFY2(
            second.findChild<MessageBar *>()->text().contains(QLatin1String("it is open in another window")),
            qPrintable(second.findChild<MessageBar *>()->text()));
    }

    void whatIsDroppedIsOpened()
    {
        MainWindow window;
        QSignalSpy opened(&window.workspace(), &Workspace::opened);
        QVERIFY(
            !drop(window, {QUrl(QStringLiteral("https://example.org/other.odo"))})); // not on this machine
        QVERIFY(drop(window, {QUrl::fromLocalFile(QStringLiteral("/nowhere/run.mkv"))}));
        QVERIFY(!window.workspace().isBusy()); // videos belong to no project yet
        QVERIFY(drop(window, {QUrl::fromLocalFile(QString::fromStdString(m_project.string()))}));
        QTRY_COMPARE(opened.count(), 1);
        QCOMPARE(window.workspace().project()->title().value(), std::string("Year 9 robotics"));
    }

private:
    /// Whether the window takes it.
    static bool drop(QWidget &window, const QList<QUrl> &urls)
    {
        QMimeData dragged;
        dragged.setUrls(urls);
        QDragEnterEvent enter({}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        enter.ignore();
        QApplication::sendEvent(&window, &enter);
        if (!enter.isAccepted())
            return false;
        QDropEvent event({}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier);
        return QApplication::sendEvent(&window, &event);
    }

    std::filesystem::path path(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }

    QTemporaryDir m_folder;
    std::filesystem::path m_project;
};

ODOGRAPH_TEST(TestOpening, QApplication)
#include "tst_opening.moc"
