// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody who presses whatever there is: keys, clicks, drags and wheel at random, in the window and whatever
// comes up. Nothing may crash or hang, and the project opens afterwards. ODOGRAPH_EVENTS: how many (3000);
// ODOGRAPH_SEED: another sequence; ODOGRAPH_EVENTS_LOG: a file to write each into before it is sent.
#include "core/project/project.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QSettings>
#include <QSplitter>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

/// Aborts when nothing has happened for a minute.
class HangWatch
{
public:
    HangWatch()
        : m_thread([this] {
              for (int idle = 0; !m_ended; ++idle) {
                  std::this_thread::sleep_for(100ms); // a watch is made of waiting
                  if (m_alive.exchange(false))
                      idle = 0;
                  if (idle > 600 * slowness) {
                      std::fputs("the window hangs\n", stderr);
                      std::abort();
                  }
              }
          })
    {
    }
    ~HangWatch()
    {
        m_ended = true;
        m_thread.join();
    }
    void beat() { m_alive = true; }

private:
    std::atomic<bool> m_alive = true, m_ended = false;
    std::thread m_thread;
};

/// Sends one event after the other, each from an event loop, so that dialogs get theirs, too.
class Monkey : public QObject
{
public:
    Monkey(QWidget &window, unsigned seed, int events)
        : m_window(window), m_random(seed), m_left(events), m_log(qEnvironmentVariable("ODOGRAPH_EVENTS_LOG"))
    {
        if (!m_log.fileName().isEmpty())
            (void)m_log.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
        schedule();
    }
    bool isDone() const { return m_left <= 0 && m_depth == 0; }

private:
    void schedule() { QTimer::singleShot(0, this, &Monkey::act); }
    int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(m_random); }

    void act()
    {
        if (m_left <= 0) { // close what is still open
            if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget()))
                dialog->reject();
            if (QWidget *popup = QApplication::activePopupWidget())
                popup->close();
            if (m_depth > 0)
                schedule();
            return;
        }
        --m_left;
        schedule(); // before it: what it opens may wait for the next one
        m_watch.beat();
        ++m_depth;
        const int open = ++m_sinceDialog;
        if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
            dialog && (qobject_cast<QFileDialog *>(dialog) || open > 300 || m_depth > 8)) {
            m_sinceDialog = 0;
            dialog->reject(); // files of this machine are not to be played with; and nobody stays for ever
        } else {
            if (!dialog)
                m_sinceDialog = 0;
            poke();
        }
        --m_depth;
    }
    void poke()
    {
        QWidget *top = QApplication::activePopupWidget();
        if (!top)
            top = QApplication::activeModalWidget();
        if (!top)
            top = &m_window;
        QList<QWidget *> targets{top};
        for (QWidget *child : top->findChildren<QWidget *>())
            if (child->isVisibleTo(top) && child->isEnabled() && !child->size().isEmpty())
                targets << child;
        QWidget *target = targets.at(below(int(targets.size())));
        const int kind = below(10);
        if (m_log.isOpen())
            m_log.write(QStringLiteral("%1 %2 %3 %4\n")
                            .arg(m_left)
                            .arg(kind)
                            .arg(QLatin1String(target->metaObject()->className()), target->accessibleName())
                            .toUtf8());
        QWidget *focus = QApplication::focusWidget(); // what a dialog stands before gets no keys from anybody
        const bool isOpen = focus && (focus == top || top->isAncestorOf(focus));
        if (kind < 5)
            pressKey(isOpen && kind < 3 ? focus : target);
        else
            useMouse(target, kind);
    }
    void pressKey(QWidget *target)
    {
        static const QList<QKeyCombination> keys{Qt::Key_Tab,
                                                 Qt::Key_Tab,
                                                 Qt::Key_Space,
                                                 Qt::Key_Return,
                                                 Qt::Key_Escape,
                                                 Qt::Key_Left,
                                                 Qt::Key_Right,
                                                 Qt::Key_Up,
                                                 Qt::Key_Down,
                                                 Qt::Key_Home,
                                                 Qt::Key_End,
                                                 Qt::Key_PageDown,
                                                 Qt::Key_Delete,
                                                 Qt::Key_Backspace,
                                                 Qt::Key_F1,
                                                 Qt::Key_F2,
                                                 Qt::Key_F9,
                                                 Qt::Key_A,
                                                 Qt::Key_D,
                                                 Qt::Key_I,
                                                 Qt::Key_O,
                                                 Qt::Key_J,
                                                 Qt::Key_K,
                                                 Qt::Key_L,
                                                 Qt::Key_U,
                                                 Qt::Key_X,
                                                 Qt::Key_0,
                                                 Qt::Key_1,
                                                 Qt::Key_9,
                                                 Qt::Key_Minus,
                                                 Qt::Key_Percent,
                                                 Qt::CTRL | Qt::Key_1,
                                                 Qt::CTRL | Qt::Key_2,
                                                 Qt::CTRL | Qt::Key_3,
                                                 Qt::CTRL | Qt::Key_4,
                                                 Qt::CTRL | Qt::Key_5,
                                                 Qt::CTRL | Qt::Key_Z,
                                                 Qt::CTRL | Qt::SHIFT | Qt::Key_Z,
                                                 Qt::CTRL | Qt::Key_F,
                                                 Qt::CTRL | Qt::Key_D,
                                                 Qt::CTRL | Qt::Key_I,
                                                 Qt::CTRL | Qt::Key_T,
                                                 Qt::CTRL | Qt::Key_E,
                                                 Qt::CTRL | Qt::Key_L,
                                                 Qt::CTRL | Qt::Key_A,
                                                 Qt::CTRL | Qt::Key_Comma,
                                                 Qt::CTRL | Qt::Key_PageUp,
                                                 Qt::CTRL | Qt::Key_PageDown,
                                                 Qt::ALT | Qt::Key_Down,
                                                 Qt::SHIFT | Qt::Key_Tab};
        const QKeyCombination key = keys.at(below(int(keys.size())));
        QTest::keyClick(target, key.key(), key.keyboardModifiers());
    }
    void useMouse(QWidget *target, int kind)
    {
        const QPoint at(below(target->width()), below(target->height())),
            to(below(target->width()), below(target->height()));
        const QPointer<QWidget> alive(target);
        switch (kind) {
        case 5:
        case 6:
            QTest::mouseClick(target, Qt::LeftButton, {}, at);
            break;
        case 7:
            QTest::mouseDClick(target, Qt::LeftButton, {}, at);
            break;
        case 8:
            QTest::mousePress(target, Qt::LeftButton, {}, at);
            if (alive)
                QTest::mouseMove(target, to);
            if (alive)
                QTest::mouseRelease(target, Qt::LeftButton, {}, to);
            break;
        default: {
            QWheelEvent wheel(at, target->mapToGlobal(at), {}, {0, below(2) == 0 ? 120 : -120}, Qt::NoButton,
                              below(4) == 0 ? Qt::ControlModifier : Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(target, &wheel);
        }
        }
    }

    QWidget &m_window;
    std::mt19937 m_random;
    int m_left, m_depth = 0, m_sinceDialog = 0;
    QFile m_log;
    HangWatch m_watch;
};

} // namespace

class TestRandomEvents : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void nothingCrashesOrHangs()
    {
        QStandardPaths::setTestModeEnabled(true);
        QTemporaryDir folder;
        qputenv("HOME", folder.path().toUtf8());
        QSettings().clear();
        const auto made = storeExample(folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        const int events = qEnvironmentVariable("ODOGRAPH_EVENTS", QStringLiteral("3000")).toInt();
        const unsigned seed = qEnvironmentVariable("ODOGRAPH_SEED", QStringLiteral("1")).toUInt();
        {
            MainWindow window;
            window.findChild<QAction *>(QStringLiteral("quit"))->setVisible(false); // that is no crash
            window.findChild<QAction *>(QStringLiteral("quit"))->setEnabled(false);
            window.show();
            QVERIFY(window.openProject(*made));
            Monkey monkey(window, seed, events);
            QTRY_VERIFY_WITH_TIMEOUT(monkey.isDone(), 1000 * (60 + events));
            QTRY_VERIFY_WITH_TIMEOUT(!window.workspace().isBusy(), 60000 * slowness);
        }
        const auto again = Project::open(*made, Project::Access::ReadWrite);
        QVERIFY2(again, again ? "" : again.error().message().c_str());
        QSettings().clear();
    }
};

ODOGRAPH_TEST(TestRandomEvents, QApplication)
#include "tst_random_events.moc"
