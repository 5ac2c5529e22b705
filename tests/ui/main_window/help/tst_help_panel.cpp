// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/help_actions.h"

#include "tests/support/registered_test.h"
#include "ui/main_window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>
#include <QTextBrowser>
#include <QToolButton>

using namespace odo;

class TestHelpPanel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void thereIsATextForEachPage()
    {
        HelpPanel panel;
        panel.show();
        const auto *text = panel.findChild<QTextBrowser *>();
        QStringList seen;
        for (const char *page : {"welcome", "testbed", "record", "review", "compare", "history"}) {
            panel.showPage(QString::fromLatin1(page));
            QVERIFY2(text->toPlainText().size() > 300, page);
            QVERIFY(!seen.contains(text->toPlainText()));
            seen << text->toPlainText();
        }
    }
    void opensAndClosesByKeyAndButton()
    {
        QSettings().clear();
        MainWindow window;
        window.show();
        auto *panel = window.findChild<HelpPanel *>();
        QVERIFY(panel->isHidden());
        auto *help = window.findChild<QAction *>(QStringLiteral("help"));
        QCOMPARE(help->shortcut(), QKeySequence(Qt::Key_F1));
        help->trigger();
        QVERIFY(panel->isVisible());
        QVERIFY(panel->findChild<QTextBrowser *>()->toPlainText().startsWith(QStringLiteral("Welcome")));
        panel->findChild<QToolButton *>()->click();
        QVERIFY(panel->isHidden() && !help->isChecked());
    }
};

ODOGRAPH_TEST(TestHelpPanel, QApplication)
#include "tst_help_panel.moc"
