// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings and errors are kept until they are dismissed, with buttons for what they advise; nothing moves.
#include "core/analysis/run_differences.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/track_warnings.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/models/shown_message.h"
#include "ui/record/record_page.h"
#include "ui/testbed/testbed_page.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

using namespace odo;
using namespace odo::test;

namespace {

Error untracked()
{
    return {ErrorCode::NotFound, trialSubject("Trial 3"), notTrackedYet(), trackItFirst()};
}

Error other()
{
    return {ErrorCode::Io, foreignWords("saving"), foreignWords("the disk is full"),
            foreignWords("free some space")};
}

/// Of a second view that was not synchronised.
Message unsynchronised()
{
    RecordingRecord view;
    view.position = 1;
    view.cameraName = "B";
    return stepWarning("Trial 1", view);
}

} // namespace

class TestWindowMessages : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_project = *made;
    }
    void init()
    {
        m_window = std::make_unique<MainWindow>();
        QVERIFY(m_window->openProject(m_project));
        QTRY_VERIFY(!m_window->workspace().isBusy());
        m_window->resize(1024, 600);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_messages = m_window->findChild<WindowMessages *>();
        m_bar = m_window->findChild<MessageBar *>();
        m_panel = m_window->findChild<MessagePanel *>();
    }
    void cleanup() { m_window.reset(); }

    void adviceHasAButton_data()
    {
        QTest::addColumn<int>("remedy");
        QTest::addColumn<Message>("message");
        QTest::newRow("track") << int(Remedy::Track) << wholeMessage(untracked());
        QTest::newRow("synchronise") << int(Remedy::Synchronise) << unsynchronised();
        QTest::newRow("none") << -1 << wholeMessage(other());
    }
    void adviceHasAButton()
    {
        QFETCH(int, remedy);
        QFETCH(Message, message);
        const std::vector<Remedy> found = remediesOf(message);
        QCOMPARE(found.size(), std::size_t(remedy < 0 ? 0 : 1));
        if (remedy >= 0)
            QCOMPARE(int(found.front()), remedy);
    }

    /// What pages warn of is kept as well, with what can be done about it; what the page itself shows is not
    /// shown again.
    void pagesWarnToo()
    {
        auto *record = m_window->findChild<RecordPage *>();
        Q_EMIT record->changed(QStringLiteral("Trial 9 is recorded."), {});
        QCOMPARE(m_bar->text(), QStringLiteral("Trial 9 is recorded."));
        QCOMPARE(m_messages->bell()->text(), QString());
        Q_EMIT record->changed(QStringLiteral("Trial 1 is recorded. View B is not synchronised."),
                               {unsynchronised()});
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("1"));
        Q_EMIT m_window->findChild<TestbedPage *>()->changed(QStringLiteral("Camera A is registered. Poor."),
                                                             {foreignWords("Poor")});
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("2"));
        m_messages->hideBar();
        Q_EMIT record->warned(QStringLiteral("The disk is nearly full: 2 min"));
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("3"));
        QVERIFY(m_bar->isHidden());
        QTest::mouseClick(m_messages->bell(), Qt::LeftButton);
        QVERIFY(shows("nearly full") && shows("not synchronised") && shows("Poor"));
        QVERIFY(button(*m_panel, "Synchronise…")->isVisible());
    }

    /// The list is as high as what it holds: nothing is cut off, and nothing scrolls that has room.
    void theListFits()
    {
        m_messages->action()->trigger();
        auto *scroll = m_panel->findChild<QScrollArea *>();
        QCoreApplication::sendPostedEvents();
        for (const QLabel *label : m_panel->findChildren<QLabel *>())
            if (label->isVisible())
                QVERIFY2(label->height() >= label->sizeHint().height(), qPrintable(label->text()));
        QVERIFY(!scroll->isVisible());
        m_messages->showWarning(QString(QStringLiteral("words that are not short ")).repeated(12));
        m_messages->showError(other());
        QCoreApplication::sendPostedEvents();
        QVERIFY(scroll->isVisible());
        QCOMPARE(scroll->verticalScrollBar()->maximum(), 0);
        QVERIFY(!scroll->verticalScrollBar()->isVisible());
        m_messages->action()->trigger();
    }

    /// However often it is said, it is one message; the bell counts messages.
    void errorsAreKeptUntilTheyAreDismissed()
    {
        for (int i = 0; i < 3; ++i)
            m_messages->showError(untracked());
        m_messages->showError(other());
        m_messages->showDone(QStringLiteral("Saved."));
        QCOMPARE(m_bar->text(), QStringLiteral("Saved."));
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("2"));
        QTest::mouseClick(m_messages->bell(), Qt::LeftButton);
        QVERIFY(m_panel->isVisible());
        QCOMPARE(QApplication::focusWidget(), m_panel);
        QVERIFY(says(*m_panel, "the disk is full"));
        QVERIFY(says(*m_panel, "3 time"));
        dismissButtons().front()->click(); // the newest
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("1"));
        QVERIFY(!shows("the disk is full"));
        QVERIFY(shows("has not been tracked yet"));
        QTest::keyClick(m_panel, Qt::Key_Escape);
        QVERIFY(m_panel->isHidden());
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("1"));
        m_messages->action()->trigger();
        button(*m_panel, "Dismiss all")->click();
        QVERIFY(m_messages->bell()->text().isEmpty());
        QVERIFY(shows("No messages."));
    }

    /// Closed by a person, it is dismissed; a cancelled job is no error.
    void whatIsClosedIsNotKept()
    {
        m_messages->showError(other());
        named<QToolButton>(*m_bar, "Close the message")->click();
        QVERIFY(m_bar->isHidden());
        QVERIFY(m_messages->bell()->text().isEmpty());
        m_messages->showError(cancelled(foreignWords("tracking")).value());
        QVERIFY(m_messages->bell()->text().isEmpty());
        QCOMPARE(m_bar->text(), QStringLiteral("Cancelled. Nothing was changed."));
    }

    /// Neither the message nor the list takes room from the page, and both stay within it.
    void nothingMoves()
    {
        const auto *stack = m_window->findChild<QStackedWidget *>();
        const QRect before = stack->geometry();
        m_messages->showError(untracked());
        m_messages->showWarning(QString(20'000, u'w'));
        QCOMPARE(stack->geometry(), before);
        QVERIFY(before.contains(m_bar->geometry()));
        for (int i = 0; i < 40; ++i)
            m_messages->showWarning(QStringLiteral("Camera A has moved, run %1").arg(i));
        m_messages->action()->trigger();
        QCOMPARE(stack->geometry(), before);
        QVERIFY(before.contains(m_panel->geometry()));
        QVERIFY(m_bar->isHidden());
    }

    /// The button of a warning begins what it advises, for the trial that it names; the message stays.
    void aButtonDoesWhatIsAdvised()
    {
        QSignalSpy wanted(m_messages, &WindowMessages::remedyWanted);
        disconnect(m_messages, &WindowMessages::remedyWanted, m_window.get(), nullptr); // no dialog here
        m_messages->showDone({QStringLiteral("Trial 1 is tracked."), {unsynchronised(), unsynchronised()}});
        button(*m_bar, "Synchronise…")->click();
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.at(0).at(1).toString(), QStringLiteral("Trial 1"));
        QVERIFY(m_bar->isHidden());
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("1"));
        m_messages->action()->trigger();
        button(*m_panel, "Synchronise…")->click();
        QCOMPARE(wanted.count(), 2);
        QVERIFY(m_panel->isHidden());
    }

    void whatConcernsTheProjectEndsWithIt()
    {
        m_messages->showError(untracked());
        QVERIFY(m_window->openProject(m_project));
        QCOMPARE(m_messages->bell()->text(), QStringLiteral("1"));
        m_messages->action()->trigger();
        QVERIFY(shows("has not been tracked yet"));
        for (const QPushButton *each : m_panel->findChildren<QPushButton *>())
            QVERIFY(each->isHidden() || each->text() != QStringLiteral("Track…"));
    }

    /// F8 opens it, Tab reaches its buttons, Enter presses them, Esc closes it and gives the focus back.
    void byTheKeyboardAlone()
    {
        m_messages->showError(other());
        QWidget *before = QApplication::focusWidget();
        QTest::keyClick(m_window.get(), Qt::Key_F8);
        QVERIFY(m_panel->isVisible());
        QToolButton *dismiss = dismissButtons().front();
        for (int tabs = 0; tabs < 10 && !dismiss->hasFocus(); ++tabs)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY(dismiss->hasFocus());
        QTest::keyClick(dismiss, Qt::Key_Space);
        QVERIFY(m_messages->bell()->text().isEmpty());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(m_panel->isHidden());
        QCOMPARE(QApplication::focusWidget(), before);
    }

private:
    QList<QToolButton *> dismissButtons() const
    {
        QList<QToolButton *> buttons;
        for (QToolButton *each : m_panel->findChildren<QToolButton *>())
            if (each->isVisible() && each->accessibleName().startsWith(QLatin1String("Dismiss: ")))
                buttons << each;
        return buttons;
    }
    bool shows(const char *words) const
    {
        const auto labels = m_panel->findChildren<QLabel *>();
        return std::ranges::any_of(labels, [&](const QLabel *label) {
            return label->isVisible() && label->text().contains(QString::fromUtf8(words));
        });
    }

    QTemporaryDir m_folder;
    std::filesystem::path m_project;
    std::unique_ptr<MainWindow> m_window;
    WindowMessages *m_messages = nullptr;
    MessageBar *m_bar = nullptr;
    MessagePanel *m_panel = nullptr;
};

ODOGRAPH_TEST(TestWindowMessages, QApplication)
#include "tst_window_messages.moc"
