// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever has no mouse, or does not see the screen, reaches everything in every window, and hears what it is.
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/history_page.h"
#include "ui/history/internal/own_metrics_dialog.h"
#include "ui/main_window/main_window.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextEdit>
#include <QToolButton>

using namespace odo;

class TestKeyboardAlone : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void modes_data();
    void modes();
    void docksAndTabs();
    void ownMetrics();
    void dialogs();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

QString positionOf(const QWidget &widget)
{
    return QStringLiteral("%1 %2 %3 in %4")
        .arg(QString::fromLatin1(widget.metaObject()->className()), widget.objectName(),
             widget.accessibleName().left(40),
             widget.parentWidget() ? QString::fromLatin1(widget.parentWidget()->metaObject()->className())
                                   : QString());
}

/// What a person can do something with; parts of such (the line of a number) are not.
bool isOperated(const QWidget &widget, const QWidget &window)
{
    if (!widget.isVisibleTo(&window) || !widget.isEnabled() || widget.size().isEmpty() || widget.focusProxy())
        return false;
    const QWidget *parent = widget.parentWidget();
    const bool isPart = qobject_cast<const QAbstractSpinBox *>(parent) ||
                        qobject_cast<const QComboBox *>(parent) || qobject_cast<const QLineEdit *>(parent) ||
                        qobject_cast<const QScrollBar *>(&widget) || widget.inherits("QHeaderView") ||
                        widget.inherits("QTableCornerButton") || parent->inherits("QTabBar") ||
                        widget.inherits("QDockWidgetTitleButton");
    return !isPart &&
           (qobject_cast<const QAbstractButton *>(&widget) || qobject_cast<const QComboBox *>(&widget) ||
            qobject_cast<const QLineEdit *>(&widget) || qobject_cast<const QAbstractSpinBox *>(&widget) ||
            qobject_cast<const QAbstractItemView *>(&widget) ||
            qobject_cast<const QAbstractSlider *>(&widget) || qobject_cast<const QTextEdit *>(&widget) ||
            widget.focusPolicy() & Qt::TabFocus);
}

/// A button of a command that has keys, or stands in a menu, needs no focus.
bool isCommand(const QWidget &widget)
{
    const auto *button = qobject_cast<const QToolButton *>(&widget);
    const QAction *command = button ? button->defaultAction() : nullptr;
    if (!command)
        return false;
    const auto places = command->associatedObjects();
    return !command->shortcut().isEmpty() || std::ranges::any_of(places, [](QObject *place) {
        return qobject_cast<QMenu *>(place) != nullptr;
    });
}

QSet<const QWidget *> reachedByTab(QWidget &window)
{
    QSet<const QWidget *> reached;
    constexpr int enough = 400;
    for (int press = 0; press < enough; ++press) {
        QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &window, Qt::Key_Tab);
        const QWidget *now = QApplication::focusWidget();
        if (now && reached.contains(now) && press > reached.size() + 2)
            break;
        for (; now; now = now->parentWidget()) // the focus of a part is that of the whole
            reached.insert(now);
    }
    return reached;
}

QStringList complaintsOf(QWidget &window)
{
    QStringList complaints;
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window))
        return {QStringLiteral("it does not become active")};
    const QSet<const QWidget *> reached = reachedByTab(window);
    const auto widgets = window.findChildren<QWidget *>();
    for (QWidget *widget : widgets) {
        if (widget->window() != &window || !isOperated(*widget, window))
            continue;
        QAccessibleInterface *speech = QAccessible::queryAccessibleInterface(widget);
        if (speech && speech->text(QAccessible::Name).isEmpty())
            complaints << QStringLiteral("has no name: ") + positionOf(*widget);
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const bool isChosenByArrows = button && (button->group() || button->autoExclusive());
        if (!reached.contains(widget) && !isCommand(*widget) && !isChosenByArrows)
            complaints << QStringLiteral("is not reached by Tab: ") + positionOf(*widget);
    }
    complaints.removeDuplicates();
    return complaints;
}

} // namespace

void TestKeyboardAlone::initTestCase()
{
    test::beginWithoutSettings();
    applyAppearance(*qApp, Theme::Light);
    const auto made = storeExample(m_folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1440, 900);
    QVERIFY(m_window->openProject(*made));
    m_window->show();
    test::waitFor(*m_window);
}

void TestKeyboardAlone::modes_data()
{
    test::addModeRows();
}

void TestKeyboardAlone::modes()
{
    QFETCH(int, mode);
    m_window->showMode(static_cast<WindowMode>(mode));
    test::waitFor(*m_window);
    QCOMPARE(test::told(complaintsOf(*m_window)), 0);
}

/// What is hidden at first.
void TestKeyboardAlone::docksAndTabs()
{
    QStringList complaints;
    const auto look = [&](const QString &what) {
        test::waitFor(*m_window);
        for (const QString &each : complaintsOf(*m_window))
            complaints << what + QStringLiteral(" · ") + each;
    };
    m_window->showMode(WindowMode::Review);
    const auto docks = m_window->findChild<ReviewPage *>()->desk().dockActions();
    QVERIFY(docks.size() >= 5);
    for (QAction *dock : docks) {
        if (!dock->isChecked())
            dock->trigger();
        look(dock->text());
    }
    m_window->findChild<ReviewPage *>()->desk().resetLayout();
    m_window->showMode(WindowMode::History);
    auto *tabs = m_window->findChild<HistoryPage *>()->findChild<QTabWidget *>();
    for (const int tab : {1, 2}) {
        tabs->setCurrentIndex(tab);
        look(tabs->tabText(tab));
    }
    tabs->setCurrentIndex(0);
    QCOMPARE(test::told(complaints), 0);
}

void TestKeyboardAlone::ownMetrics()
{
    ResultTable table;
    OwnMetricsDialog dialog(table, {{"half", "m", "0.5 * path_length"}});
    dialog.show();
    QCOMPARE(test::told(complaintsOf(dialog)), 0);
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isVisible());
}

void TestKeyboardAlone::dialogs()
{
    QStringList complaints;
    const int dialogs = test::lookAtDialogs(*m_window, [&](const QAction &command, QDialog &dialog) {
        for (const QString &each : complaintsOf(dialog))
            complaints << command.text() + QStringLiteral(" · ") + each;
    });
    QVERIFY(dialogs > 15);
    QCOMPARE(test::told(complaints), 0);
}

ODOGRAPH_TEST(TestKeyboardAlone, QApplication)
#include "tst_keyboard_alone.moc"
