// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/ui/support/stored_example.h"
#include "ui/testbed/testbed_page.h"
#include "ui/testbed/testbed_state.h"
#include "ui/testbed/testbed_tools.h"

#include <QAction>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestTestbedPage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void showsCamerasAndTheirState();
    void drawsCamerasWhereTheyStand();
    void beginsEmpty();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

void TestTestbedPage::initTestCase()
{
    const auto made = storeExample(m_folder.path().toStdString());
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    m_project = std::move(*Project::open(*made, Project::Access::ReadWrite));
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

void TestTestbedPage::beginsEmpty()
{
    const auto empty = Project::create(m_folder.filePath(QStringLiteral("empty.odo")).toStdString(), "Empty");
    QVERIFY(empty);
    TestbedPage page(**empty);
    page.refresh();
    QVERIFY(page.isSettled());
    QCOMPARE(page.findChild<QStackedWidget *>()->currentIndex(), 1);
    QVERIFY2(!page.toolActions().at(TestbedTools::Register)->isEnabled(), "nothing to register yet");
}

QTEST_MAIN(TestTestbedPage)
#include "tst_testbed_page.moc"
