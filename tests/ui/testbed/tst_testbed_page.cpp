// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/floor_readings.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/testbed/internal/known_cameras.h"
#include "ui/testbed/internal/testbed_tools.h"
#include "ui/testbed/testbed_page.h"
#include "ui/views/image/camera_view.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace odo;

class TestTestbedPage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void showsCamerasAndTheirState();
    void drawsCamerasWhereTheyStand();
    void warnsAndShowsWhatHasMoved();
    void mapsTheAccuracyToExpect();
    void readsTheFloorUnderTheMouse();
    void beginsEmpty();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

void TestTestbedPage::initTestCase()
{
    m_project = openStoredExample(m_folder.path().toStdString());
}

void TestTestbedPage::showsCamerasAndTheirState()
{
    TestbedPage page(*m_project);
    QSignalSpy failed(&page, &TestbedPage::failed);
    page.refresh();
    QCOMPARE(failed.count(), 0);
    auto *table = page.findChild<QTableView *>();
    QCOMPARE(table->model()->rowCount(), 2);
    QCOMPARE(table->model()->index(0, 1).data().toString(), QStringLiteral("calibrated, ±0.21 px"));
    QCOMPARE(table->model()->index(0, 2).data().toString(), QStringLiteral("registered, ±1.6\u00a0mm"));
    page.resize(1200, 700);
    page.show();
    QTRY_VERIFY(page.isSettled());
}

void TestTestbedPage::drawsCamerasWhereTheyStand()
{
    const auto rows = loadCameraRows(*m_project);
    QVERIFY(rows);
    const auto layout = m_project->layouts().find("floor");
    QVERIFY(layout);
    const auto cameras = sketchedCameras(*m_project, *rows, layout->id);
    QVERIFY(cameras);
    QCOMPARE(cameras->size(), std::size_t(2));
    // Both look at (1.5, 1.1), to within the half pixel by which the middle of a picture is off its centre.
    for (const SketchedCamera &camera : *cameras)
        QVERIFY((camera.lookAtInWorld - Eigen::Vector2d(1.5, 1.1)).norm() < 0.02);
    QVERIFY(std::abs(cameras->front().pointInWorld.z() - 2.0) < 1e-9);
    QVERIFY(sketchedCameras(*m_project, *rows, layout->id + 1)->empty());
}

void TestTestbedPage::warnsAndShowsWhatHasMoved()
{
    QTemporaryDir folder; // the others keep theirs as it is
    const auto project = openStoredExample(folder.path().toStdString());
    const auto camera = project->cameras().find("B");
    const RecordId registration = project->cameras().currentRegistration(camera->id).value()->id;
    QVERIFY(project->cameras().addCheck(registration, {Instant(std::chrono::milliseconds(1'762'952'400'000)),
                                                       RegistrationCheck::Outcome::CameraMoved, 6, 0.014,
                                                       foreignWords("B has moved 6 px = 14 mm.")}));
    TestbedPage page(*project);
    page.refresh();
    auto *table = page.findChild<QTableView *>();
    QCOMPARE(table->model()->index(1, 2).data(CameraListModel::BadgeTextRole).toString(),
             QStringLiteral("moved 14.0\u00a0mm"));
    QCOMPARE(table->model()->index(1, 2).data(CameraListModel::BadgeStateRole).toInt(), int(BadgeState::Bad));
    QVERIFY(
        table->model()->index(1, 2).data(Qt::ToolTipRole).toString().contains(QStringLiteral("B has moved")));
    QCOMPARE(table->model()->index(0, 2).data(CameraListModel::BadgeStateRole).toInt(),
             int(BadgeState::Good));
    // The example was calibrated in 2025 at a picture size of its own.
    const auto rows = loadCameraRows(*project);
    QVERIFY(!rows->at(1).warnings.empty());
    const QList<Fact> facts = cameraFacts(rows->at(1));
    QCOMPARE(facts[0].name, QStringLiteral("Warning")); // what is wrong comes first
    QCOMPARE(facts[0].value, QStringLiteral("B has moved 6 px = 14 mm."));
    QCOMPARE(facts[1].name, QStringLiteral("Warning"));
    QVERIFY2(facts[1].value.contains(QLatin1String("days old")), qPrintable(facts[1].value));
}

void TestTestbedPage::readsTheFloorUnderTheMouse()
{
    TestbedPage page(*m_project);
    page.refresh();
    page.resize(1200, 700);
    page.show();
    QTRY_VERIFY(page.isSettled());
    auto *view = page.findChild<CameraView *>();
    auto *copy = view->findChild<QAction *>();
    QVERIFY(copy && !copy->isEnabled());
    const auto marker = m_project->layouts().find("floor")->layout.markers[1];
    const auto camera = m_project->cameras().find("A");
    const auto registration = m_project->cameras().currentRegistration(camera->id).value();
    const Eigen::Vector2d pixel = *floorReadingOf(*m_project, *registration)
                                       ->view()
                                       .pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
    QTest::mouseMove(view->imageArea(), view->fromImagePixels({pixel.x(), pixel.y()}).toPoint());
    QVERIFY(copy->isEnabled());
    copy->trigger();
    const QString text = QApplication::clipboard()->text();
    qInfo("%s", qPrintable(text));
    // The mouse has whole pixels of the screen: some millimetres on the floor.
    const double x = QLocale().toDouble(text.section(u' ', 1, 1));
    QVERIFY2(std::abs(x - 1e3 * marker.pointInWorld.x()) < 30, qPrintable(text));
    QVERIFY(text.contains(u'±') && text.contains(QLatin1String("mm")));
    QTest::mouseMove(view->imageArea(), {1, 1}); // beside the image
    QVERIFY(!copy->isEnabled());
}

void TestTestbedPage::mapsTheAccuracyToExpect()
{
    TestbedPage page(*m_project);
    page.refresh();
    page.resize(1200, 700);
    page.show();
    QTRY_VERIFY(page.isSettled());
    const auto told = [&page] {
        const QLatin1String words("mm in the middle");
        return std::ranges::any_of(page.findChildren<QLabel *>(), [words](const QLabel *label) {
            return label->text().contains(words) || label->toolTip().contains(words);
        });
    };
    QTRY_VERIFY(told());
    page.findChild<QCheckBox *>()->click();
    QTRY_VERIFY(!told());
}

void TestTestbedPage::beginsEmpty()
{
    const auto empty = Project::create(m_folder.filePath(QStringLiteral("empty.odo")).toStdString(), "Empty");
    QVERIFY(empty);
    TestbedPage page(**empty);
    page.refresh();
    QVERIFY(page.isSettled());
    QCOMPARE(page.findChild<QStackedWidget *>()->currentIndex(), 1);
    QVERIFY2(!page.toolActions().at(TestbedTools::Register)->isEnabled(), "nothing to register yet");
    const QList<QAction *> checks = page.toolActions().mid(TestbedTools::ToolCount);
    QCOMPARE(checks.size(), qsizetype(CheckTools::ToolCount));
    for (const QAction *check : checks)
        QVERIFY2(!check->isEnabled(), qPrintable(check->text()));
    TestbedPage full(*m_project);
    full.refresh();
    for (const QAction *check : full.toolActions().mid(TestbedTools::ToolCount))
        QVERIFY2(check->isEnabled(), qPrintable(check->text()));
}

ODOGRAPH_TEST(TestTestbedPage, QApplication)
#include "tst_testbed_page.moc"
