// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/main_window/preferences/command_keys.h"

#include <QApplication>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>
#include <QTreeWidget>

using namespace odo;

namespace {

const QKeySequence ctrlT(Qt::CTRL | Qt::Key_T), ctrlE(Qt::CTRL | Qt::Key_E), f5(Qt::Key_F5);

/// A window's menus: File with Open, a menu within it with Track, and a command without a name.
struct Menus
{
    QMenuBar bar;
    QAction *open, *track, *other;

    Menus()
    {
        QMenu *file = bar.addMenu(QStringLiteral("&File"));
        open = file->addAction(QStringLiteral("&Open project…"));
        open->setObjectName(QStringLiteral("open"));
        open->setShortcut(ctrlE);
        other = file->addAction(QStringLiteral("other"));
        other->setShortcut(f5);
        QMenu *within = file->addMenu(QStringLiteral("&Trial"));
        track = within->addAction(QStringLiteral("&Track"));
        track->setObjectName(QStringLiteral("track"));
        track->setShortcuts({ctrlT, f5});
    }
};

} // namespace

class TestCommandKeys : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init() { QSettings().clear(); }

    void knowsTheNamedCommandsOfAllMenus()
    {
        Menus menus;
        CommandKeys keys;
        keys.adopt(menus.bar);
        QCOMPARE(keys.commands().size(), std::size_t(2));
        QCOMPARE(keys.commands()[0].words, QStringLiteral("Open project"));
        QCOMPARE(keys.commands()[0].group, QStringLiteral("File"));
        QCOMPARE(keys.commands()[1].group, QStringLiteral("Trial"));
        QCOMPARE(keys.commands()[1].keys, QList<QKeySequence>({ctrlT, f5}));
        QCOMPARE(keys.commandOf(f5)->name, QStringLiteral("track"));
        QVERIFY(!keys.commandOf(QKeySequence()));
        keys.adopt(menus.bar); // as when another project is opened
        QCOMPARE(keys.commands().size(), std::size_t(2));
    }
    void anotherKeyCountsAtOnceAndIsKept()
    {
        {
            Menus menus;
            CommandKeys keys;
            keys.adopt(menus.bar);
            QSignalSpy changed(&keys, &CommandKeys::changed);
            keys.setKey(QStringLiteral("open"), QKeySequence(Qt::Key_F8));
            QCOMPARE(menus.open->shortcut(), QKeySequence(Qt::Key_F8));
            QCOMPARE(changed.size(), 1);
        }
        Menus menus;
        CommandKeys keys;
        keys.adopt(menus.bar);
        QCOMPARE(menus.open->shortcut(), QKeySequence(Qt::Key_F8));
        QCOMPARE(menus.track->shortcuts(), QList<QKeySequence>({ctrlT, f5}));
        keys.forgetAll();
        QCOMPARE(menus.open->shortcut(), ctrlE);
        QVERIFY(QSettings().allKeys().isEmpty());
    }
    void aKeyHasOneCommand()
    {
        Menus menus;
        CommandKeys keys;
        keys.adopt(menus.bar);
        keys.setKey(QStringLiteral("open"), ctrlT);
        QCOMPARE(menus.open->shortcut(), ctrlT);
        QVERIFY(menus.track->shortcuts().isEmpty());
        keys.setKey(QStringLiteral("open"), {});
        QVERIFY(menus.open->shortcut().isEmpty());
        keys.setKey(QStringLiteral("no such command"), f5); // left over from another version: nothing happens
        QVERIFY(!keys.commandOf(f5));
    }
    void theSettingsMayHoldNonsense()
    {
        QSettings().setValue(QStringLiteral("keys/open"), QStringLiteral("Hyper+Nonsense"));
        QSettings().setValue(QStringLiteral("keys/gone"), QStringLiteral("F7"));
        Menus menus;
        CommandKeys keys;
        keys.adopt(menus.bar);
        QCOMPARE(menus.open->shortcut(), ctrlE);
        QCOMPARE(keys.commands().size(), std::size_t(2));
    }
    void aCommandThatIsGoneIsNotTouched()
    {
        CommandKeys keys;
        {
            Menus menus;
            keys.adopt(menus.bar);
        }
        keys.setKey(QStringLiteral("open"), f5); // its project was closed
        Menus again;
        keys.adopt(again.bar);
        QCOMPARE(again.open->shortcut(), f5);
    }
    void thePageGivesAKeyByKeyboardAlone();
};

void TestCommandKeys::thePageGivesAKeyByKeyboardAlone()
{
    Menus menus;
    CommandKeys keys;
    keys.adopt(menus.bar);
    KeysPage page(keys);
    page.show();
    auto *list = page.findChild<QTreeWidget *>();
    auto *search = page.findChild<QLineEdit *>();
    QTest::keyClicks(search, QStringLiteral("trac"));
    QVERIFY(list->topLevelItem(0)->isHidden());
    QVERIFY(!list->topLevelItem(1)->isHidden());
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Down);
    QTest::keyClick(list, Qt::Key_Down);
    QCOMPARE(list->currentItem()->text(0), QStringLiteral("Track"));
    auto *key = page.findChild<QKeySequenceEdit *>();
    key->setKeySequence(ctrlE);
    const auto labels = page.findChildren<QLabel *>();
    QVERIFY(std::ranges::any_of(labels, [](const QLabel *label) {
        return label->text() ==
               QStringLiteral("Ctrl+E is the key of “Open project”. That command would lose it.");
    }));
    const auto buttons = page.findChildren<QPushButton *>();
    QTest::keyClick(*std::ranges::find(buttons, QStringLiteral("&Use this key"), &QPushButton::text),
                    Qt::Key_Space);
    QCOMPARE(menus.track->shortcuts(), QList<QKeySequence>{ctrlE});
    QVERIFY(menus.open->shortcut().isEmpty());
    QCOMPARE(list->currentItem()->text(1), QStringLiteral("Ctrl+E"));
}

ODOGRAPH_TEST(TestCommandKeys, QApplication)
#include "tst_command_keys.moc"
