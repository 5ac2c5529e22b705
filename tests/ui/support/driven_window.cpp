// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/driven_window.h"

#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QPointer>
#include <QSet>
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

int lookAtDialogs(MainWindow &window,
                  const std::function<void(const QAction &command, QDialog &dialog)> &look)
{
    QSet<QString> seen;
    for (const WindowMode mode : allModes) {
        window.showMode(mode);
        waitFor(window);
        const auto commands = window.findChildren<QAction *>();
        for (QAction *command : commands) {
            if (!command->text().contains(u'…') || !command->isEnabled() || seen.contains(command->text()))
                continue;
            seen << command->text();
            Person person({[&](QDialog &dialog) {
                QCoreApplication::sendPostedEvents(); // it is laid out now
                if (!qobject_cast<QFileDialog *>(&dialog))
                    look(*command, dialog);
                dialog.reject();
            }});
            command->trigger();
            waitFor(window);
            QList<QPointer<QWidget>> others; // one that was closed before may go meanwhile
            for (QWidget *other : QApplication::topLevelWidgets())
                others << other;
            for (const QPointer<QWidget> &other : others) // those that do not wait for an answer
                if (auto *dialog = qobject_cast<QDialog *>(other.data()); dialog && dialog->isVisible()) {
                    look(*command, *dialog);
                    dialog->close();
                }
        }
    }
    return static_cast<int>(seen.size());
}

void addModeRows()
{
    QTest::addColumn<int>("mode");
    for (const WindowMode mode : allModes)
        QTest::newRow(qPrintable(modeWord(mode))) << static_cast<int>(mode);
}

qsizetype told(const QStringList &found)
{
    for (const QString &each : found)
        qWarning().noquote() << each;
    return found.size();
}

} // namespace odo::test
