// SPDX-License-Identifier: GPL-3.0-or-later
// The cameras are checked before a trial: one that stands still, one that was pushed, one that shows
// something else.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/trial_sources.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/camera_lists.h"
#include "ui/testbed/check/camera_position_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 60'000;
constexpr int resultColumn = 2;

} // namespace

class TestCameraPositionDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void init();
    void tellsOneThatStands();
    void tellsOneThatWasPushed();
    void tellsOneThatLooksElsewhere();
    void namesMarkersThatAreNotFound();
    void checksAllByKeysAlone();
    void picturesOfAnotherSizeAreRefused();
    void cancelKeepsNothing();

private:
    std::unique_ptr<CameraPositionDialog> makeDialog();
    void check(CameraPositionDialog &dialog);
    QString result(CameraPositionDialog &dialog, int row);
    std::optional<RegistrationCheck> kept(const char *camera);

    QTemporaryDir m_folder;
    LiveCameras m_live{[] { return std::vector<CameraDescription>(); }};
    SimulatedScene m_scene = demoTestbed(2);
    QString m_still, m_pushed, m_elsewhere, m_covered, m_small;
    std::unique_ptr<Project> m_project;
    int m_projects = 0;
};

void TestCameraPositionDialog::initTestCase()
{
    m_scene.durationS = 0.1;
    const auto draw = [&](const SimulatedScene &scene, const char *name) {
        const QString file = m_folder.filePath(QString::fromLatin1(name));
        return writeImage(SceneRenderer(scene, 0).render(0), file.toStdString()) ? file : QString();
    };
    m_still = draw(m_scene, "still.png");
    SimulatedScene pushed = m_scene;
    const FloorView &view = m_scene.cameras[0].view;
    RigidTransform turned = view.worldFromCamera();
    turned.rotation =
        Eigen::Quaterniond(Eigen::AngleAxisd(0.006, Eigen::Vector3d::UnitZ())) * turned.rotation;
    pushed.cameras[0].view = FloorView(view.camera(), turned, Eigen::Matrix<double, 6, 6>::Zero());
    m_pushed = draw(pushed, "pushed.png");
    SimulatedScene bare = m_scene; // the camera looks where no markers are
    bare.floor.markerSideM = 0;
    m_elsewhere = draw(bare, "elsewhere.png");
    SimulatedScene covered = m_scene;
    covered.floor.markers.markers.pop_back();
    m_covered = draw(covered, "covered.png");
    m_small = m_folder.filePath(QStringLiteral("small.png"));
    QVERIFY(writeImage(renderBoard(CameraModel::assumed(640, 480),
                                   {.cameraFromBoard = {Eigen::Quaterniond::Identity(), {0, 0, 0.5}}}, 0, 1),
                       m_small.toStdString()));
    for (const QString &file : {m_still, m_pushed, m_elsewhere, m_covered})
        QVERIFY(!file.isEmpty());
}

void TestCameraPositionDialog::init()
{
    const QString file = m_folder.filePath(QStringLiteral("p%1.odo").arg(++m_projects));
    m_project = std::move(*Project::create(file.toStdString(), "Class"));
    QVERIFY(m_project->layouts().add(m_scene.floor.markers));
    for (const char *name : {"A", "B"}) {
        IntrinsicsRecord lens;
        lens.camera = m_project->cameras().add({0, name, ""})->id;
        lens.origin = foreignWords("told");
        lens.calibration.intrinsics = m_scene.cameras[0].view.camera().intrinsics();
        QVERIFY(m_project->cameras().addIntrinsics(lens));
        RegisterJob job({name, m_scene.floor.markers.name, {}, m_still.toStdString(), {}, {}});
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
    }
}

std::unique_ptr<CameraPositionDialog> TestCameraPositionDialog::makeDialog()
{
    std::vector<CheckCamera> cameras;
    const auto rows = loadCameraRows(*m_project);
    for (const CameraRow &row : *rows)
        cameras.push_back({QString::fromStdString(row.camera.name),
                           *floorViewOf(*m_project, *row.registration),
                           m_scene.floor.markers,
                           std::nullopt,
                           {},
                           cameraBadge(row.registration)});
    auto dialog = std::make_unique<CameraPositionDialog>(*m_project, std::move(cameras), m_live);
    dialog->open();
    return dialog;
}

void TestCameraPositionDialog::check(CameraPositionDialog &dialog)
{
    QTest::mouseClick(button(dialog, "Check"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(dialog, "Check")->isEnabled() && !dialog.isRunning(), patienceMs);
}

QString TestCameraPositionDialog::result(CameraPositionDialog &dialog, int row)
{
    return named<QTableWidget>(dialog, "Registered cameras")->item(row, resultColumn)->text();
}

std::optional<RegistrationCheck> TestCameraPositionDialog::kept(const char *camera)
{
    return m_project->cameras().currentRegistration(m_project->cameras().find(camera)->id).value()->lastCheck;
}

void TestCameraPositionDialog::tellsOneThatStands()
{
    const auto dialog = makeDialog();
    dialog->setImage(0, {m_still, {}});
    check(*dialog);
    QCOMPARE(result(*dialog, 0), QStringLiteral("has not moved"));
    QVERIFY(kept("A") && kept("A")->outcome == RegistrationCheck::Outcome::Still);
    QVERIFY2(!kept("B"), "it was not checked");
    QVERIFY(dialog->hasChecked());
    QVERIFY(says(*dialog, "has not moved"));
}

void TestCameraPositionDialog::tellsOneThatWasPushed()
{
    const auto dialog = makeDialog();
    dialog->setImage(0, {m_still, {}});
    dialog->setImage(1, {m_pushed, {}});
    check(*dialog);
    QVERIFY2(result(*dialog, 1).startsWith(QStringLiteral("moved ")), qPrintable(result(*dialog, 1)));
    QVERIFY(says(*dialog, "B has moved"));
    QVERIFY(says(*dialog, "register it again before you record"));
    // What the lists of cameras show changes too, until it is registered again.
    const auto badgeOf = [&](int row) {
        return cameraBadge(loadCameraRows(*m_project)->at(std::size_t(row)).registration);
    };
    QCOMPARE(badgeOf(1).state, BadgeState::Bad);
    QVERIFY(badgeOf(1).text.startsWith(QStringLiteral("moved ")));
    QVERIFY(badgeOf(0).text.startsWith(QChar(0xb1)));
    QTest::mouseClick(button(*dialog, "Register B again…"), Qt::LeftButton);
    QCOMPARE(dialog->toRegister(), QStringLiteral("B"));
    RegisterJob job({"B", m_scene.floor.markers.name, {}, m_pushed.toStdString(), {}, {}});
    QVERIFY(runToEnd(job, *m_project, {}));
    QVERIFY(badgeOf(1).text.startsWith(QChar(0xb1)));
}

void TestCameraPositionDialog::tellsOneThatLooksElsewhere()
{
    const auto dialog = makeDialog();
    dialog->setImage(0, {m_elsewhere, {}});
    check(*dialog);
    QCOMPARE(result(*dialog, 0), QStringLiteral("undetermined"));
    QVERIFY(says(*dialog, "markers were found again, two are needed"));
    QVERIFY(kept("A") && kept("A")->outcome == RegistrationCheck::Outcome::Undetermined);
    QCOMPARE(cameraBadge(loadCameraRows(*m_project)->front().registration).text,
             QStringLiteral("markers not found"));
}

void TestCameraPositionDialog::namesMarkersThatAreNotFound()
{
    const auto dialog = makeDialog();
    dialog->setImage(0, {m_covered, {}});
    check(*dialog);
    QCOMPARE(result(*dialog, 0), QStringLiteral("has not moved"));
    QVERIFY(says(*dialog, ("Not found again: " + m_scene.floor.markers.markers.back().label).c_str()));
}

void TestCameraPositionDialog::checksAllByKeysAlone()
{
    const auto dialog = makeDialog();
    QVERIFY(QTest::qWaitForWindowActive(dialog.get()));
    dialog->setImage(0, {m_still, {}});
    dialog->setImage(1, {m_pushed, {}});
    QTest::keyClick(dialog.get(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(!result(*dialog, 1).isEmpty() && button(*dialog, "Check")->isEnabled() &&
                                 !dialog->isRunning(),
                             patienceMs);
    auto *table = named<QTableWidget>(*dialog, "Registered cameras");
    QCOMPARE(table->currentRow(), 1); // the one that is wrong
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Up);
    QVERIFY(says(*dialog, "A has not moved"));
    QTest::keyClick(dialog.get(), Qt::Key_Escape);
    QVERIFY(!dialog->isVisible());
}

void TestCameraPositionDialog::picturesOfAnotherSizeAreRefused()
{
    const auto dialog = makeDialog();
    dialog->setImage(0, {m_small, {}});
    dialog->setImage(1, {m_folder.filePath(QStringLiteral("nowhere.png")), {}});
    check(*dialog);
    QCOMPARE(result(*dialog, 0), QStringLiteral("undetermined"));
    QCOMPARE(result(*dialog, 1), QStringLiteral("undetermined"));
    auto *table = named<QTableWidget>(*dialog, "Registered cameras");
    table->selectRow(0);
    QVERIFY(says(*dialog, "the image is 640×480, the camera was registered at 1280×720"));
    table->selectRow(1);
    QVERIFY(says(*dialog, "the file does not exist"));
    QVERIFY2(!kept("A") && !kept("B"), "a picture that is none says nothing of the camera");
}

void TestCameraPositionDialog::cancelKeepsNothing()
{
    auto dialog = makeDialog();
    dialog->setImage(0, {m_pushed, {}});
    QTest::mouseClick(button(*dialog, "Check"), Qt::LeftButton);
    QTest::keyClick(dialog.get(), Qt::Key_Escape); // before the outcome can come in
    QVERIFY(!dialog->isVisible());
    dialog.reset();
    QVERIFY(!kept("A"));
}

ODOGRAPH_TEST(TestCameraPositionDialog, QApplication)
#include "tst_camera_position_dialog.moc"
