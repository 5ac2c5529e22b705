// SPDX-License-Identifier: GPL-3.0-or-later
// From an empty window to a measured run of two phones' clips and the printed mat, by the Start page: each
// decision (a click, a drop, an entry) is counted.
#include "core/calibration/floor_mat.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/start/start_page.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestFirstOwnRun : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void twelveDecisions();

private:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    void drop(const QStringList &files);
    void press(const char *text, const QList<Answer> &answers);
    QString message() const { return m_window->findChild<MessageBar *>()->text(); }

    QTemporaryDir m_folder;
    SimulatedScene m_scene = demoTestbed(11);
    std::unique_ptr<MainWindow> m_window;
    int m_decisions = 0;
};

/// A robot circles around the mat on the demo's floor; nobody gave a lens, a layout, or a clock.
void TestFirstOwnRun::initTestCase()
{
    test::beginWithoutSettings();
    m_scene.durationS = 5;
    m_scene.floor.markers = matLayout({FloorMat::Paper::A4, 4, 3});
    m_scene.floor.areTagsByLabel = true;
    m_scene.floor.markerSideM = matTagM;
    for (Marker &marker : m_scene.floor.markers.markers)
        marker.pointInWorld += Eigen::Vector2d(0.95, 0.8);
    m_scene.cameras[1].startOffsetS = 0.42;
    m_scene.robots.push_back(demoRobot("Robot", {}, makeCircleMotion({1.5, 1.1}, 0.8, 0.9, 0.5)));
    for (int camera = 0; camera < 2; ++camera)
        QVERIFY(renderVideo(m_scene, camera, path(camera == 0 ? "phone1.mp4" : "phone2.mp4").toStdString(),
                            {}, {}));
    m_window = std::make_unique<MainWindow>();
    m_window->show();
}

void TestFirstOwnRun::drop(const QStringList &files)
{
    QMimeData data;
    QList<QUrl> urls;
    for (const QString &file : files)
        urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    // Qt lets a widget drop only what has entered it.
    QDragEnterEvent enter(QPoint(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QDropEvent event(QPointF(400, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_window.get(), &event);
    ++m_decisions;
}

/// A button of the Start page, and what is answered to the dialogs that follow; waits for the job.
void TestFirstOwnRun::press(const char *text, const QList<Answer> &answers)
{
    QPushButton *wanted = nullptr;
    for (QPushButton *each : m_window->findChild<StartPage *>()->findChildren<QPushButton *>())
        if (each->text() == QString::fromUtf8(text))
            wanted = each;
    QVERIFY2(wanted && wanted->isEnabled(), text);
    QTRY_VERIFY2(wanted->property("primary").toBool(), text); // it is the one that is proposed
    Person person(answers);
    wanted->click();
    ++m_decisions;
    QVERIFY2(person.isDone(), qPrintable(message()));
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().isBusy(), 120'000);
}

void TestFirstOwnRun::twelveDecisions()
{
    const Answer accept = [this](QDialog &dialog) {
        odo::press(dialog);
        ++m_decisions;
    };
    test::run(*m_window, test::actionOf(*m_window, "New project…"), {chooseFile(path("lesson"))});
    m_decisions += 2; // New project, and the name that is offered
    QTRY_VERIFY(m_window->findChild<StartPage *>() && m_window->findChild<StartPage *>()->isVisible());
    {
        Person person({accept}); // name, cameras and synchronisation are as proposed
        drop({path("phone1.mp4"), path("phone2.mp4")});
        QVERIFY(person.isDone());
    }
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->workspace().isBusy(), 120'000);
    QVERIFY2(m_window->findChild<StartPage *>()->isVisible(), "the next step is here, not in Review");
    press("Find the mat in the clips…", {[this](QDialog &dialog) {
              dialog.findChild<QDoubleSpinBox *>()->setValue(1000);
              odo::press(dialog);
              m_decisions += 2; // the check line's length, and Enter
          }});
    QVERIFY2(message().startsWith(QStringLiteral("Registered to the floor mat: A ±")), qPrintable(message()));
    press("Add a robot…", {[this](QDialog &dialog) {
              dialog.findChild<QLineEdit *>()->setText(QStringLiteral("Robot"));
              odo::press(dialog);
              m_decisions += 2; // the name, and Enter
          }});
    press("Track…", {accept});
    test::waitFor(*m_window);
    QVERIFY2(m_decisions <= 12, std::to_string(m_decisions).c_str());

    Project &project = *m_window->workspace().project();
    const auto trials = project.trials().all();
    QCOMPARE(trials->size(), std::size_t(1));
    QVERIFY2(m_window->windowTitle().contains(QString::fromStdString(trials->front().name)),
             qPrintable(m_window->windowTitle())); // its result is on screen
    const auto metrics = project.analyses().currentMetrics(trials->front().id);
    QCOMPARE(metrics->size(), std::size_t(1));
    // At 0.9 m/s about the middle of the floor, by cameras whose lenses nobody calibrated.
    const auto metric = [&](const std::string &name) {
        return *std::ranges::find(metrics->front().profile.metrics, name, &Metric::name);
    };
    const Metric speed = metric("mean_speed");
    const double sigma = speed.sigma.value_or(0);
    qInfo("%d decisions; mean speed %.4f ± %.4f m/s", m_decisions, speed.value, sigma);
    QVERIFY2(std::abs(speed.value - 0.9) < 3 * sigma, std::to_string(speed.value).c_str());
    QVERIFY2(sigma < 0.03, std::to_string(sigma).c_str());
}

ODOGRAPH_TEST(TestFirstOwnRun, QApplication)
#include "tst_first_own_run.moc"
