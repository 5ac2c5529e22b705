// SPDX-License-Identifier: GPL-3.0-or-later
// Preferences in the window: what is chosen counts at once, and again at the next start.
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/preferences/preferences_dialog.h"
#include "ui/main_window/workspace.h"
#include "ui/models/number_text.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestPreferencesDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(m_window->openProject(*made));
        QTRY_VERIFY(!m_window->workspace().isBusy() && m_window->isSettled());
    }
    void cleanup()
    {
        QSettings().clear();
        GeneralPage::applySettings();
    }
    void cleanupTestCase() { m_window.reset(); }

    void anotherUnitIsShownAtOnceAndKept()
    {
        QVERIFY(m_window->showTrial("Trial 2"));
        QTRY_VERIFY(m_window->isSettled());
        m_window->showMode(MainWindow::Mode::History);
        QVERIFY(statusHas(QStringLiteral("mm · m/s · s")));
        choose(QStringLiteral("Units of results"), static_cast<int>(UnitSystem::Inches));
        QVERIFY(statusHas(QStringLiteral("in · ft/s · s")));
        QCOMPARE(shownUnitSystem(), UnitSystem::Inches);
        QTRY_VERIFY(m_window->isSettled());
        auto *review = m_window->findChild<ReviewPage *>(); // made anew, with what was on it
        QTRY_COMPARE(review->trial(), QStringLiteral("Trial 2"));
        setShownUnitSystem(UnitSystem::Millimetres);
        GeneralPage::applySettings(); // as at the next start
        QCOMPARE(shownUnitSystem(), UnitSystem::Inches);
    }
    void anotherScaleOfColours()
    {
        choose(QStringLiteral("Colours of maps"), static_cast<int>(ColourScale::Viridis));
        QCOMPARE(shownColourScale(), ColourScale::Viridis);
        QCOMPARE(scaleColour(0), QColor(0x44, 0x01, 0x54));
        QCOMPARE(QSettings().value(QStringLiteral("colourScale")).toString(), QStringLiteral("viridis"));
    }
    void theme()
    {
        choose(QStringLiteral("Theme"), 2);
        QVERIFY(isDark(m_window->palette()));
        choose(QStringLiteral("Theme"), 1);
        QVERIFY(!isDark(m_window->palette()));
        QCOMPARE(QSettings().value(QStringLiteral("theme")).toString(), QStringLiteral("light"));
    }
    void settingsOfNobodyKnowsWhat()
    {
        QSettings().setValue(QStringLiteral("units"), QStringLiteral("furlongs"));
        QSettings().setValue(QStringLiteral("colourScale"), 7);
        GeneralPage::applySettings();
        QCOMPARE(shownUnitSystem(), UnitSystem::Millimetres);
        QCOMPARE(shownColourScale(), ColourScale::Cividis);
    }

private:
    /// By keys alone, in the dialog that the menu opens.
    void choose(const QString &box, int index)
    {
        Person person({[&](QDialog &dialog) {
            for (QComboBox *each : dialog.findChildren<QComboBox *>()) {
                if (each->accessibleName() != box)
                    continue;
                each->setFocus();
                QTest::keyClick(each, Qt::Key_Home);
                for (int i = 0; i < index; ++i)
                    QTest::keyClick(each, Qt::Key_Down);
            }
            dialog.reject();
        }});
        m_window->findChild<QAction *>(QStringLiteral("preferences"))->trigger();
        QVERIFY(person.isDone());
    }
    bool statusHas(const QString &words) const
    {
        const auto labels = m_window->statusBar()->findChildren<QLabel *>();
        return std::ranges::any_of(labels, [&](const QLabel *label) { return label->text() == words; });
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

ODOGRAPH_TEST(TestPreferencesDialog, QApplication)
#include "tst_preferences_dialog.moc"
