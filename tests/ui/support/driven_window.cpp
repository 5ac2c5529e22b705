// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/driven_window.h"

#include "ui/main_window/main_window.h"
#include "ui/main_window/message_bar.h"
#include "ui/main_window/workspace.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>

namespace odo::test {
namespace {
constexpr int longestJobMs = 120'000;
} // namespace

void beginWithoutSettings()
{
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QCoreApplication::setOrganizationName(QStringLiteral("odograph-test"));
    QCoreApplication::setApplicationName(QFileInfo(QCoreApplication::applicationFilePath()).baseName());
    QSettings().clear();
}

void waitFor(const MainWindow &window)
{
    QTRY_VERIFY_WITH_TIMEOUT(!window.workspace().isBusy() && window.isSettled(), longestJobMs);
}

void run(MainWindow &window, QAction *action, const QList<Answer> &answers)
{
    QVERIFY(action);
    QVERIFY2(action->isEnabled(), qPrintable(action->text()));
    Person person(answers);
    action->trigger();
    QVERIFY2(person.isDone(), qPrintable(window.findChild<MessageBar *>()->text()));
    QTRY_VERIFY_WITH_TIMEOUT(!window.workspace().isBusy(), longestJobMs);
}

} // namespace odo::test
