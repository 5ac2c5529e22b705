// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/job.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/compare/compare_page.h"
#include "ui/history/history_page.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/paint_window.h"
#include "ui/main_window/workspace.h"
#include "ui/models/timeline.h"
#include "ui/record/record_page.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/testbed/testbed_page.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <semaphore>

using namespace odo;

namespace {

/// Works until it is released or cancelled, telling when it has begun.
class WaitingJob : public Job
{
public:
    Result<void> prepare(Project &) override { return {}; }
    Result<void> run(const JobControl &control) override
    {
        control.report(0.25, foreignWords("a quarter"));
        while (!control.isCancelled())
            if (m_released.try_acquire_for(std::chrono::milliseconds(20)))
                return {};
        return cancelled(foreignWords("waiting"));
    }
    Result<void> commit(Project &) override
    {
        committed = true;
        return {};
    }
    void release() { m_released.release(); }
    bool committed = false;

private:
    std::binary_semaphore m_released{0};
};

QStringList namelessWidgets(const QWidget &root)
{
    QStringList nameless;
    for (QWidget *widget : root.findChildren<QWidget *>()) {
        if (widget->focusPolicy() == Qt::NoFocus || widget->focusProxy() != nullptr)
            continue;
        if (widget->window() != &root)
            continue; // the list that a combo box pops up speaks for its box
        if (qobject_cast<QLabel *>(widget))
            continue; // a text that can be marked and copied is its own name
        if (const auto *tabs = qobject_cast<QTabBar *>(widget); tabs && tabs->count() == 0)
            continue; // it is named by its tab, and hidden without one
        if (!widget->inherits("QAbstractScrollArea") && qobject_cast<QWidget *>(widget->parent()) &&
            widget->objectName().startsWith(QLatin1String("qt_")))
            continue; // inner parts of Qt's own widgets speak for their owner
        const QAccessibleInterface *speech = QAccessible::queryAccessibleInterface(widget);
        const QString name = speech ? speech->text(QAccessible::Name) : QString();
        if (name.trimmed().isEmpty())
            nameless << QStringLiteral("%1 \"%2\" in %3")
                            .arg(QString::fromLatin1(widget->metaObject()->className()), widget->objectName(),
                                 QString::fromLatin1(widget->parent()->metaObject()->className()));
    }
    return nameless;
}

} // namespace

class TestMainWindow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void init();
    void welcomesWithoutAProject();
    void opensAProject();
    void keepsTheProjectWhenAnotherCannotBeOpened();
    void switchesModesByKeys();
    void refusesAnUnknownTrial();
    void saysThatATrialIsNotTracked();
    void showsProgressAndCancels();
    void finishesAJob();
    void completesARecordingThatWasCutOff();
    void namesEverythingThatTakesFocus();
    void paintsThePicture_data();
    void paintsThePicture();
    void remembersAndResetsTheDocks();
    void headersFollowAChangeOfTheme();

private:
    QTemporaryDir m_folder;
    std::filesystem::path m_project;
};

void TestMainWindow::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("odograph-test"));
    QCoreApplication::setApplicationName(QStringLiteral("tst_main_window"));
    QLocale::setDefault(QLocale::c());
    applyAppearance(*qApp, Theme::Light);
    const auto made = storeExample(m_folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    m_project = *made;
}

void TestMainWindow::init()
{
    QSettings().clear();
}

void TestMainWindow::welcomesWithoutAProject()
{
    MainWindow window;
    QCOMPARE(window.windowTitle(), QStringLiteral("Odograph"));
    QVERIFY(window.isSettled());
    const auto buttons = window.findChild<QStackedWidget *>()->currentWidget()->findChildren<QPushButton *>();
    QStringList texts;
    for (const QPushButton *button : buttons)
        texts << button->text();
    QCOMPARE(texts, QStringList({QStringLiteral("Open demo lesson…"), QStringLiteral("New project…"),
                                 QStringLiteral("Open project…")}));
}

void TestMainWindow::opensAProject()
{
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    QTRY_COMPARE(window.windowTitle(), QStringLiteral("Year 9 robotics — Trial 1, Team Falcon — Odograph"));
    QVERIFY(window.statusBar()->findChildren<QLabel *>().front()->text().contains(QLatin1String("saved")));
    QVERIFY(window.showTrial("Trial 2"));
    QTRY_COMPARE(window.windowTitle(), QStringLiteral("Year 9 robotics — Trial 2, Team Heron — Odograph"));
    MainWindow next;
    QVERIFY(next.menuBar()->findChildren<QAction *>().size() > 0);
    bool recent = false;
    for (const QAction *action : next.findChildren<QAction *>())
        recent |= action->text().endsWith(QLatin1String("example.odo"));
    QVERIFY2(recent, "the project is among the recent ones");
}

void TestMainWindow::keepsTheProjectWhenAnotherCannotBeOpened()
{
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    const auto opened = window.openProject(m_folder.filePath(QStringLiteral("none.odo")).toStdString());
    QVERIFY(!opened);
    QCOMPARE(opened.error().code, ErrorCode::NotFound);
    QVERIFY(window.windowTitle().startsWith(QLatin1String("Year 9 robotics")));
    QVERIFY(window.showTrial("Trial 1"));
}

void TestMainWindow::switchesModesByKeys()
{
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    auto *stack = window.findChild<QStackedWidget *>();
    QTest::keyClick(&window, Qt::Key_4, Qt::ControlModifier);
    QVERIFY(qobject_cast<ComparePage *>(stack->currentWidget()));
    QTest::keyClick(&window, Qt::Key_5, Qt::ControlModifier);
    QVERIFY(qobject_cast<HistoryPage *>(stack->currentWidget()));
    QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
    QVERIFY(qobject_cast<TestbedPage *>(stack->currentWidget()));
    QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
    QVERIFY(qobject_cast<RecordPage *>(stack->currentWidget()));
    QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
    auto *review = qobject_cast<ReviewPage *>(stack->currentWidget());
    QVERIFY(review);
    QTRY_VERIFY(review->scene());
    review->setFocus();
    QTest::keyClick(review, Qt::Key_PageUp, Qt::ControlModifier);
    QTRY_COMPARE(QString::fromStdString(review->scene()->trial.name), QStringLiteral("Trial 2"));
}

void TestMainWindow::refusesAnUnknownTrial()
{
    MainWindow window;
    QVERIFY(!window.showTrial("Trial 1"));
    QVERIFY(window.openProject(m_project));
    const auto shown = window.showTrial("Trial 9");
    QVERIFY(!shown);
    QCOMPARE(shown.error().code, ErrorCode::NotFound);
    QVERIFY2(shown.error().message().find("Trial 9") != std::string::npos, shown.error().message().c_str());
    QTRY_VERIFY(window.windowTitle().contains(QLatin1String("Trial 1")));
}

void TestMainWindow::saysThatATrialIsNotTracked()
{
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    auto *button = window.findChild<QPushButton *>(QStringLiteral("trackButton"));
    QVERIFY(!button->isVisibleTo(&window));
    QVERIFY(window.showTrial("Trial 3"));
    QTRY_VERIFY(button->isVisibleTo(&window));
    bool missing = false;
    for (const QLabel *label : window.findChildren<QLabel *>())
        missing |= label->text() == QLatin1String("video missing");
    QVERIFY(missing);
}

void TestMainWindow::showsProgressAndCancels()
{
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    window.show();
    auto *indicator = window.findChild<JobIndicator *>();
    QVERIFY(!indicator->isVisible());
    const auto job = std::make_shared<WaitingJob>();
    QVERIFY(window.workspace().start(job, foreignWords("Waiting"), nullptr));
    QVERIFY(indicator->isVisible());
    QTRY_COMPARE(indicator->text(), QStringLiteral("a quarter"));
    QVERIFY2(!window.workspace().start(std::make_shared<WaitingJob>(), foreignWords("Another"), nullptr),
             "one job at a time");
    QVERIFY2(!window.openProject(m_project), "no other project while a job runs");
    QSignalSpy failed(&window.workspace(), &Workspace::jobFailed);
    QTest::mouseClick(indicator->findChild<QPushButton *>(), Qt::LeftButton);
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(!indicator->isVisible());
    QVERIFY(!job->committed);
    QVERIFY(window.findChild<MessageBar *>()->text().startsWith(QLatin1String("Cancelled")));
}

void TestMainWindow::finishesAJob()
{
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    const auto job = std::make_shared<WaitingJob>();
    bool done = false;
    QVERIFY(window.workspace().start(job, foreignWords("Waiting"), [&done] { done = true; }));
    job->release();
    QTRY_VERIFY(done);
    QVERIFY(job->committed);
    QVERIFY(!window.workspace().isBusy());
}

void TestMainWindow::completesARecordingThatWasCutOff()
{
    const std::filesystem::path file = std::filesystem::path(m_project.string() + ".cut.odo");
    {
        const auto project = Project::create(file, "Cut off");
        TrialRecord trial;
        trial.name = "run";
        QVERIFY((*project)->trials().begin(trial, {}));
    }
    MainWindow window;
    QVERIFY(window.openProject(file));
    QTRY_VERIFY(!window.workspace().isBusy());
    QCOMPARE(window.findChild<MessageBar *>()->text(),
             QStringLiteral("trial 'run': its recording was cut off; nothing of it had reached the disk, and "
                            "it was removed: record it again"));
    QVERIFY(window.workspace().project()->trials().all()->empty());
}

void TestMainWindow::namesEverythingThatTakesFocus()
{
    MainWindow window;
    QCOMPARE(namelessWidgets(window).join(QLatin1Char('\n')), QString());
    QVERIFY(window.openProject(m_project));
    window.show();
    QCOMPARE(namelessWidgets(window).join(QLatin1Char('\n')), QString());
}

void TestMainWindow::paintsThePicture_data()
{
    QTest::addColumn<int>("mode");
    QTest::newRow("testbed") << static_cast<int>(MainWindow::Mode::Testbed);
    QTest::newRow("review") << static_cast<int>(MainWindow::Mode::Review);
    QTest::newRow("compare") << static_cast<int>(MainWindow::Mode::Compare);
    QTest::newRow("history") << static_cast<int>(MainWindow::Mode::History);
}

void TestMainWindow::paintsThePicture()
{
    QFETCH(int, mode);
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    window.showMode(static_cast<MainWindow::Mode>(mode));
    const QImage image = paintWindow(window, {1366, 768});
    QCOMPARE(image.size(), QSize(1366, 768) * window.devicePixelRatio());
    QVERIFY(window.isSettled());
    const QString folder = qEnvironmentVariable("ODOGRAPH_KEEP_PICTURES");
    if (!folder.isEmpty())
        image.save(QStringLiteral("%1/%2.png").arg(folder, QString::fromLatin1(QTest::currentDataTag())));
}

void TestMainWindow::remembersAndResetsTheDocks()
{
    {
        MainWindow window;
        QVERIFY(window.openProject(m_project));
        window.show();
        window.findChild<QDockWidget *>(QStringLiteral("accelerationDock"))->hide();
        window.close();
    }
    MainWindow window;
    QVERIFY(window.openProject(m_project));
    window.show();
    auto *dock = window.findChild<QDockWidget *>(QStringLiteral("accelerationDock"));
    QVERIFY(dock->isHidden());
    window.findChild<ReviewDesk *>()->resetLayout();
    QVERIFY(!dock->isHidden());
}

void TestMainWindow::headersFollowAChangeOfTheme()
{
    Card card(QStringLiteral("Title"));
    card.setRemark(QStringLiteral("a remark of some length"));
    card.setContent(new QWidget);
    card.resize(400, 100);
    card.show();
    QVERIFY(QTest::qWaitForWindowExposed(&card));
    // The contrast of text and ground, as the lightness of what is lightest and darkest in the header's right
    // part.
    const auto contrast = [&card] {
        const QImage header = card.grab(QRect(150, 3, 240, 20)).toImage();
        int darkest = 255, lightest = 0;
        for (int y = 0; y < header.height(); ++y)
            for (int x = 0; x < header.width(); ++x) {
                darkest = std::min(darkest, qGray(header.pixel(x, y)));
                lightest = std::max(lightest, qGray(header.pixel(x, y)));
            }
        return lightest - darkest;
    };
    const int light = contrast();
    applyAppearance(*qApp, Theme::Dark);
    const int dark = contrast();
    applyAppearance(*qApp, Theme::Light);
    QVERIFY2(light > 100 && dark > 100, qPrintable(QStringLiteral("%1, %2").arg(light).arg(dark)));
}

ODOGRAPH_TEST(TestMainWindow, QApplication)
#include "tst_main_window.moc"
