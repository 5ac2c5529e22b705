// SPDX-License-Identifier: GPL-3.0-or-later
// Every window in a language that nobody speaks: what was never given to a translator stands out.
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/mnemonics.h"
#include "tests/ui/support/pseudo_words.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/language.h"
#include "ui/main_window/main_window.h"
#include "ui/models/camera_lists.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <net/if.h>

using namespace odo;

class TestPseudoLocale : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void modes_data();
    void modes();
    void dialogs();
    void everyLanguageFits_data();
    void everyLanguageFits();

private:
    QTemporaryDir m_folder;
    std::filesystem::path m_project;
    test::PseudoWords m_words;
    std::unique_ptr<MainWindow> m_window;
};

namespace {

/// Names and words of people in the example, and what is the same in each language.
const QStringList &known()
{
    static const QStringList all = [] {
        QStringList names{
            QStringLiteral("Odograph"),
            QStringLiteral("Odograph Simulated"), // a camera that another test may have connected
            QStringLiteral("Year 9 robotics"),
            QStringLiteral("Figure eight, both at once"),
            QStringLiteral("Figure eight, 2 laps"),
            QStringLiteral("example"),
            QStringLiteral("Falcon"),
            QStringLiteral("Heron"),
            QStringLiteral("Trial 1"),
            QStringLiteral("Trial 2"),
            QStringLiteral("Trial 3"),
            QStringLiteral("Red 2"),
            QStringLiteral("Blue 1"),
            QStringLiteral("floor"),
            QStringLiteral("New wheels since trial 2."),
            QStringLiteral("inch"),
        };
        for (const Language &language : languages())
            names << language.name;
        if (auto *const ports = if_nameindex()) { // of this machine's network
            for (auto *port = ports; port->if_index != 0; ++port)
                names << QString::fromLocal8Bit(port->if_name);
            if_freenameindex(ports);
        }
        return names;
    }();
    return all;
}

/// What is cut off once everything is laid out; a job may have told something a moment ago.
QStringList cutOffAtLast(const QWidget &window)
{
    QStringList cut;
    const auto fits = [&] {
        cut = test::cutOffIn(window);
        return cut.isEmpty();
    };
    return QTest::qWaitFor(fits, 3000) ? QStringList() : cut;
}

/// What is found of cameras changes dialogs that are shown.
void waitForCameras(const MainWindow &window)
{
    const auto isFound = [&window] {
        return std::ranges::none_of(window.findChildren<LiveCameras *>(), &LiveCameras::isSearching);
    };
    QVERIFY(QTest::qWaitFor(isFound, 30'000));
}

} // namespace

void TestPseudoLocale::initTestCase()
{
    test::beginWithoutSettings();
    applyAppearance(*qApp, Theme::Light);
    const auto made = storeExample(m_folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    m_project = *made;
    QCoreApplication::installTranslator(&m_words);
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1366, 728);
    QVERIFY(m_window->openProject(*made));
    m_window->show();
    test::waitFor(*m_window);
}

void TestPseudoLocale::modes_data()
{
    test::addModeRows();
}

void TestPseudoLocale::modes()
{
    QFETCH(int, mode);
    m_window->showMode(static_cast<WindowMode>(mode));
    test::waitFor(*m_window);
    QCOMPARE(test::told(test::untranslatedIn(*m_window, known())), 0);
}

void TestPseudoLocale::dialogs()
{
    QStringList raw;
    const int dialogs = test::lookAtDialogs(*m_window, [&](const QAction &command, QDialog &dialog) {
        waitForCameras(*m_window);
        for (const QString &each : test::untranslatedIn(dialog, known()))
            raw << command.text() + QStringLiteral(" · ") + each;
    });
    QVERIFY(dialogs > 15);
    QCOMPARE(test::told(raw), 0);
}

void TestPseudoLocale::everyLanguageFits_data()
{
    QTest::addColumn<QString>("code");
    for (const Language &each : languages())
        QTest::newRow(qPrintable(each.code)) << each.code;
}

/// In a window as small as a laptop has it, and in dialogs as large as they come. None needs more than the
/// smallest screen has beside a title bar, and no key means two things in it.
void TestPseudoLocale::everyLanguageFits()
{
    QFETCH(QString, code);
    QCoreApplication::removeTranslator(&m_words);
    installLanguage(*qApp, code);
    MainWindow window;
    window.resize(1366, 728);
    QVERIFY(window.openProject(m_project));
    window.show();
    test::waitFor(window);
    QStringList cut;
    for (const WindowMode mode : allModes) {
        window.showMode(mode);
        test::waitFor(window);
        cut << cutOffAtLast(window);
    }
    test::lookAtDialogs(window, [&](const QAction &command, QDialog &dialog) {
        waitForCameras(window);
        for (const QString &each : cutOffAtLast(dialog))
            cut << command.text() + QStringLiteral(" · ") + each;
        const QSize least = dialog.minimumSizeHint().expandedTo(dialog.minimumSize());
        if (least.width() > 1024 || least.height() > 568)
            cut << QStringLiteral("%1 needs %2×%3")
                       .arg(command.text())
                       .arg(least.width())
                       .arg(least.height());
        for (const QString &each : test::sharedMnemonics(dialog))
            cut << command.text() + QStringLiteral(" · ") + each;
    });
    cut.removeDuplicates();
    QCOMPARE(test::told(cut), 0);
}

ODOGRAPH_TEST(TestPseudoLocale, QApplication)
#include "tst_pseudo_locale.moc"
