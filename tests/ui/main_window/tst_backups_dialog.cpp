// SPDX-License-Identifier: GPL-3.0-or-later
// Backups in the window: one each day, what restoring would change, and the project put back by the keyboard.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/backups.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/backups_dialog.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/preferences/backup_plan.h"
#include "ui/main_window/preferences/command_keys.h"
#include "ui/main_window/preferences/preferences_dialog.h"
#include "ui/main_window/workspace.h"
#include "ui/models/background_task.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestBackupsDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        beginWithoutSettings();
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = storeExample(m_folder->path().toStdString()).value();
    }

    void oneIsMadeOnOpening()
    {
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        QTRY_COMPARE(backupsOf(m_project).size(), std::size_t(1));
        const auto backup = Project::open(backupsOf(m_project).front().file, Project::Access::ReadOnly);
        QCOMPARE((*backup)->title().value(), std::string("Year 9 robotics"));
        QVERIFY(window.openProject(m_project)); // on the same day: nothing more, once its look has ended
        QTRY_VERIFY(window.workspace().findChildren<BackgroundTask *>().isEmpty());
        QCOMPARE(backupsOf(m_project).size(), std::size_t(1));
    }

    void thePreferencesDecide()
    {
        CommandKeys keys;
        {
            PreferencesDialog dialog(keys, Theme::Light);
            auto *daily = dialog.findChild<QCheckBox *>(QStringLiteral("dailyBackups"));
            QVERIFY(daily && daily->isChecked());
            auto *days = dialog.findChild<QSpinBox *>(QStringLiteral("backupDays"));
            QCOMPARE(days->value(), 30);
            days->setValue(7);
            QTest::keyClick(daily, Qt::Key_Space);
            QVERIFY(!days->isEnabled());
        }
        QCOMPARE(chosenBackupPlan().daysKept, 7);
        QVERIFY(!chosenBackupPlan().isDaily);
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        QTest::qWait(0);
        QVERIFY(window.workspace().findChildren<BackgroundTask *>().isEmpty());
        QVERIFY(backupsOf(m_project).empty());
        QSettings().setValue(QStringLiteral("backups/days"), -5); // by another program
        QCOMPARE(chosenBackupPlan().daysKept, 1);
    }

    void theProjectIsPutBackByTheKeyboard()
    {
        MainWindow window;
        window.show();
        QVERIFY(window.openProject(m_project));
        QTRY_COMPARE(backupsOf(m_project).size(), std::size_t(1));
        Project &project = *window.workspace().project();
        const std::string name = project.trials().names()->front().name;
        QVERIFY(project.change(foreignWords("rename it"), [&] {
            return project.trials().setName(project.trials().names()->front().id, "Renamed");
        }));
        QSignalSpy opened(&window.workspace(), &Workspace::opened);
        QString preview, change;
        bool couldRestore = false;
        Person person({[&](QDialog &dialog) {
            auto *restore = button(dialog, "&Restore this backup");
            QTRY_VERIFY(restore->isEnabled());
            couldRestore = true;
            preview = previewOf(dialog);
            auto *changes = named<QTableView>(dialog, "Changes since this backup");
            change = changes->model()->index(0, changes->model()->columnCount() - 1).data().toString();
            for (int tabs = 0; tabs < 20 && !restore->hasFocus(); ++tabs)
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QTest::keyClick(restore, Qt::Key_Return);
        }});
        window.findChild<QAction *>(QStringLiteral("backups"))->trigger();
        QVERIFY(person.isDone() && couldRestore);
        QVERIFY2(preview.contains(QStringLiteral("Without: Renamed")), qPrintable(preview));
        QVERIFY2(preview.contains(QString::fromStdString(name)), qPrintable(preview));
        QVERIFY2(preview.contains(QStringLiteral("discards 1 change")), qPrintable(preview));
        QCOMPARE(change, QStringLiteral("rename it"));
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(!window.workspace().isReadOnly());
        QCOMPARE(window.workspace().project()->trials().names()->front().name, name);
        QTRY_VERIFY(window.findChild<MessageBar *>()->text().startsWith(
            QStringLiteral("The backup was restored. What the project was before is kept as “")));
        // which is a backup itself: and forth again
        QCOMPARE(backupsOf(m_project).size(), std::size_t(2));
        QVERIFY(window.workspace().beginGoingBack(backupsOf(m_project).front().file));
        QTRY_COMPARE(opened.count(), 2);
        QCOMPARE(window.workspace().project()->trials().names()->front().name, std::string("Renamed"));
    }

    /// One that cannot be read says why, and cannot be restored; one for reading only can be looked at.
    void whatCannotBeRestored()
    {
        {
            const auto project = Project::open(m_project, Project::Access::ReadWrite).value();
            QVERIFY(backUp(*project, backupTime()));
        }
        BackupsDialog readOnly(m_project, true);
        readOnly.show();
        QTRY_VERIFY(previewOf(readOnly).contains(QStringLiteral("discards no changes")));
        QVERIFY(!button(readOnly, "&Restore this backup")->isEnabled());
        QFile torn(QString::fromStdString(backupsOf(m_project).front().file.string()));
        QVERIFY(torn.resize(5000));
        BackupsDialog dialog(m_project);
        dialog.show();
        QTRY_VERIFY(previewOf(dialog) != QStringLiteral("Reading the backup…"));
        QVERIFY2(previewOf(dialog).contains(QStringLiteral("the file is incomplete")),
                 qPrintable(previewOf(dialog)));
        QVERIFY(!button(dialog, "&Restore this backup")->isEnabled());
        button(dialog, "&Back up now")->click();
        QTRY_COMPARE(dialog.findChild<QTableWidget *>()->rowCount(), 2);
        QTRY_VERIFY(button(dialog, "&Restore this backup")->isEnabled());
    }

private:
    static QString previewOf(const QDialog &dialog)
    {
        return named<QLabel>(dialog, "What restoring would change")->text();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_project;
};

ODOGRAPH_TEST(TestBackupsDialog, QApplication)
#include "tst_backups_dialog.moc"
