// SPDX-License-Identifier: GPL-3.0-or-later
// A laptop's screen of 1366×768, or one of 2732×1536 at 200 %, and at least 1024×600: nothing may need more.
#include "tests/support/registered_test.h"
#include "tests/ui/support/mnemonics.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/history_page.h"
#include "ui/main_window/language.h"
#include "ui/main_window/main_window.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QDockWidget>
#include <QHeaderView>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestSmallScreen : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::filesystem::path m_project;

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("odograph-test"));
        QCoreApplication::setApplicationName(QStringLiteral("tst_small_screen"));
        applyAppearance(*qApp, Theme::Light);
        QSettings().clear();
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_project = *made;
    }
    void everyModeFits_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("testbed") << static_cast<int>(MainWindow::Mode::Testbed);
        QTest::newRow("record") << static_cast<int>(MainWindow::Mode::Record);
        QTest::newRow("review") << static_cast<int>(MainWindow::Mode::Review);
        QTest::newRow("compare") << static_cast<int>(MainWindow::Mode::Compare);
        QTest::newRow("history") << static_cast<int>(MainWindow::Mode::History);
    }
    void everyModeFits()
    {
        QFETCH(int, mode);
        constexpr QSize screen(1366, 768);
        constexpr int decoration = 40; // title bar and panel of a desktop
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        window.showMode(static_cast<MainWindow::Mode>(mode));
        window.show();
        QTRY_VERIFY_WITH_TIMEOUT(window.isSettled(), 20000);
        const QWidget *page = window.findChild<QStackedWidget *>()->currentWidget();
        const QSize least = page->minimumSizeHint(), whole = window.minimumSizeHint();
        const QString words = QStringLiteral("page %1×%2, window %3×%4")
                                  .arg(least.width())
                                  .arg(least.height())
                                  .arg(whole.width())
                                  .arg(whole.height());
        QVERIFY2(whole.width() <= screen.width() && whole.height() <= screen.height() - decoration,
                 qPrintable(words));
        window.resize(screen.width(), screen.height() - decoration);
        QCOMPARE(window.size(), QSize(screen.width(), screen.height() - decoration));
        const QStringList shared = test::sharedMnemonics(window);
        QVERIFY2(shared.isEmpty(), qPrintable(shared.join(u'\n')));
        if (mode == static_cast<int>(MainWindow::Mode::History)) { // its last column is the score
            const auto *trials = page->findChild<QTableView *>(QStringLiteral("trials"));
            QTRY_VERIFY(trials->horizontalHeader()->length() <= trials->viewport()->width());
        }
    }
    void everyLanguageFits_data()
    {
        QTest::addColumn<QString>("code");
        for (const Language &each : languages())
            QTest::newRow(qPrintable(each.code)) << each.code;
    }
    /// Each page with each of its docks and tabs, in 1024×600.
    void everyLanguageFits()
    {
        QFETCH(QString, code);
        installLanguage(*qApp, code);
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        window.show();
        QStringList complaints;
        const auto look = [&](const QString &what) {
            QTRY_VERIFY_WITH_TIMEOUT(window.isSettled(), 20000);
            QCoreApplication::sendPostedEvents(); // its layouts know of it
            const QSize least = window.minimumSizeHint();
            if (least.width() > 1024 || least.height() > 600)
                complaints << QStringLiteral("%1: %2×%3").arg(what).arg(least.width()).arg(least.height());
            for (const QString &shared : test::sharedMnemonics(window))
                complaints << what + QStringLiteral(": ") + shared;
        };
        for (const WindowMode mode : allModes) {
            window.showMode(mode);
            look(modeWord(mode));
        }
        window.showMode(WindowMode::Review);
        for (QDockWidget *dock : window.findChildren<QDockWidget *>())
            if (dock->window() == &window && dock->parentWidget()->isVisible()) {
                dock->show();
                dock->raise();
                look(dock->objectName());
            }
        window.showMode(WindowMode::History);
        auto *tabs = window.findChild<HistoryPage *>()->findChild<QTabWidget *>();
        for (int tab = 0; tab < tabs->count(); ++tab)
            if (tabs->isTabVisible(tab)) {
                tabs->setCurrentIndex(tab);
                look(tabs->tabText(tab));
            }
        window.resize(1024, 600);
        QStringList needs;
        const auto *pages = window.findChild<QStackedWidget *>();
        for (int page = 0; page < pages->count(); ++page) {
            const QSize least = pages->widget(page)->minimumSizeHint();
            needs << QStringLiteral("%1×%2").arg(least.width()).arg(least.height());
        }
        QVERIFY2(window.size() == QSize(1024, 600), qPrintable(needs.join(u' ')));
        QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(u'\n')));
    }
    void cleanup() { installLanguage(*qApp, QStringLiteral("en")); }
};

ODOGRAPH_TEST(TestSmallScreen, QApplication)
#include "tst_small_screen.moc"
