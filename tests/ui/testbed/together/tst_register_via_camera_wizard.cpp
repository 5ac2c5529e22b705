// SPDX-License-Identifier: GPL-3.0-or-later
// A camera is registered through another one as a person does it, by mouse and by keyboard.
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/camera_lists.h"
#include "ui/testbed/floor/marker_canvas.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/testbed/together/joint_dialogs.h"

#include <QApplication>
#include <QComboBox>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 60'000;

} // namespace

class TestRegisterViaCameraWizard : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void markersThatBothSeeAreThereAtOnce();
    void pointsArePutByMouse();
    void pointsArePutByKeysAlone();
    void takesOutAndUndoes();
    void aCameraIsNotRegisteredThroughItself();
    void tellsWhatIsWrong();
    void cancelsAtEveryPage();

private:
    std::unique_ptr<RegisterViaCameraWizard> makeWizard(const QString &image, const QString &referenceImage);
    void walkToPoints(RegisterViaCameraWizard &wizard);
    QString image(int camera, bool withMarkers);
    Eigen::Vector2d seen(int camera, const Eigen::Vector2d &position) const
    {
        return *m_scene.cameras[std::size_t(camera)].view.pixelFromWorld({position.x(), position.y(), 0});
    }
    double offM(RegisterViaCameraWizard &wizard) const
    {
        return (wizard.page().registration()->registration.worldFromCamera.translation -
                m_scene.cameras[1].view.cameraInWorld())
            .norm();
    }

    QTemporaryDir m_folder;
    LiveCameras m_live{[] {
        return std::vector<CameraDescription>{
            {.uri = "sim:A", .kind = "simulated", .name = foreignWords("Simulated")}};
    }};
    SimulatedScene m_scene = demoTestbed(1);
    const std::vector<Eigen::Vector2d> m_positions{{0.6, 0.5}, {2.4, 0.5}, {2.4, 1.7},
                                                   {0.6, 1.7}, {1.5, 1.1}, {1.5, 0.4}};
};

QString TestRegisterViaCameraWizard::image(int camera, bool withMarkers)
{
    SimulatedScene scene = m_scene;
    if (!withMarkers)
        scene.floor.markers.markers.clear();
    const QString file = m_folder.filePath(QStringLiteral("%1%2.png").arg(camera).arg(withMarkers));
    return writeImage(SceneRenderer(scene, camera).render(0), file.toStdString()) ? file : QString();
}

void TestRegisterViaCameraWizard::initTestCase()
{
    m_live.poll();
    QTRY_VERIFY(!m_live.isSearching());
    for (const int camera : {0, 1})
        for (const bool withMarkers : {true, false})
            QVERIFY(!image(camera, withMarkers).isEmpty());
}

std::unique_ptr<RegisterViaCameraWizard>
TestRegisterViaCameraWizard::makeWizard(const QString &image, const QString &referenceImage)
{
    IntrinsicsRecord lens;
    lens.calibration.intrinsics = m_scene.cameras[1].view.camera().intrinsics();
    const FloorView &truth = m_scene.cameras[0].view;
    const FloorView view(truth.camera(), truth.worldFromCamera(),
                         Eigen::Matrix<double, 6, 6>::Identity() * 1e-7);
    auto wizard = std::make_unique<RegisterViaCameraWizard>(
        std::vector<FloorCamera>{{QStringLiteral("A"), lens, std::nullopt},
                                 {QStringLiteral("B"), lens, std::nullopt}},
        QStringLiteral("B"),
        std::vector<CheckCamera>{{QStringLiteral("A"), view, m_scene.floor.markers, std::nullopt}}, m_live,
        [](const QString &, const Frame &) { return Result<void>(); });
    if (!image.isEmpty()) {
        wizard->source().image().setFile(image);
        wizard->source().referenceImage().setFile(referenceImage);
    }
    wizard->open();
    return wizard;
}

void TestRegisterViaCameraWizard::walkToPoints(RegisterViaCameraWizard &wizard)
{
    QTest::keyClick(&wizard, Qt::Key_Return);
    QCOMPARE(wizard.findChild<QStackedWidget *>()->currentIndex(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(!says(wizard, "Loading the images"), patienceMs);
}

void TestRegisterViaCameraWizard::markersThatBothSeeAreThereAtOnce()
{
    const auto wizard = makeWizard(image(1, true), image(0, true));
    walkToPoints(*wizard);
    QCOMPARE(wizard->page().points().size(), std::size_t(4));
    QVERIFY(wizard->page().registration());
    // Four points to a tenth of a pixel, 3 m away: some millimetres.
    QVERIFY2(offM(*wizard) < 0.02, qPrintable(QString::number(offM(*wizard))));
    QVERIFY(button(*wizard, "Save")->isEnabled());
}

void TestRegisterViaCameraWizard::pointsArePutByMouse()
{
    const auto wizard = makeWizard(image(1, false), image(0, false));
    walkToPoints(*wizard);
    SharedPointsPage &page = wizard->page();
    QVERIFY(!button(*wizard, "Save")->isEnabled());
    QVERIFY(says(*wizard, "then the same point in the right image"));
    for (std::size_t i = 0; i < m_positions.size(); ++i) {
        QVERIFY(!page.registration() || i >= 4);
        QTest::mouseClick(&page.canvas(), Qt::LeftButton, {},
                          page.canvas().fromPixel(seen(1, m_positions[i])).toPoint());
        QCOMPARE(page.points().size(), i); // not yet in the other picture
        QTest::mouseClick(&page.referenceCanvas(), Qt::LeftButton, {},
                          page.referenceCanvas().fromPixel(seen(0, m_positions[i])).toPoint());
        QCOMPARE(page.points().size(), i + 1);
    }
    QVERIFY(page.registration());
    // A click hits a whole pixel of the screen, on which one of the picture's is less than half as large.
    QVERIFY2(offM(*wizard) < 0.15, qPrintable(QString::number(offM(*wizard))));
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
}

void TestRegisterViaCameraWizard::pointsArePutByKeysAlone()
{
    const auto wizard = makeWizard(image(1, false), image(0, false));
    QVERIFY(QTest::qWaitForWindowActive(wizard.get()));
    walkToPoints(*wizard);
    SharedPointsPage &page = wizard->page();
    QTRY_VERIFY(page.canvas().hasFocus());
    const Intrinsics &lens = m_scene.cameras[0].view.camera().intrinsics();
    const auto walk = [&](MarkerCanvas &canvas, const Eigen::Vector2d &to) { // from the middle
        QVERIFY(canvas.hasFocus());
        const Eigen::Vector2d way = to - 0.5 * Eigen::Vector2d(lens.widthPx - 1, lens.heightPx - 1);
        for (const auto &[pixels, less, more] : {std::tuple(way.x(), Qt::Key_Left, Qt::Key_Right),
                                                 std::tuple(way.y(), Qt::Key_Up, Qt::Key_Down)}) {
            const Qt::Key key = pixels < 0 ? less : more;
            const int whole = int(std::lround(std::abs(pixels)));
            for (int i = 0; i < whole / 20; ++i)
                QTest::keyClick(&canvas, key, Qt::ControlModifier);
            for (int i = 0; i < whole % 20; ++i)
                QTest::keyClick(&canvas, key, Qt::ShiftModifier);
        }
        QTest::keyClick(&canvas, Qt::Key_Space); // goes on to the other picture
    };
    for (std::size_t i = 0; i < 5; ++i) {
        walk(page.canvas(), seen(1, m_positions[i]));
        walk(page.referenceCanvas(), seen(0, m_positions[i]));
    }
    QCOMPARE(page.points().size(), std::size_t(5));
    QVERIFY(page.registration());
    QVERIFY2(offM(*wizard) < 0.05, qPrintable(QString::number(offM(*wizard))));
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
}

void TestRegisterViaCameraWizard::takesOutAndUndoes()
{
    const auto wizard = makeWizard(image(1, true), image(0, true));
    walkToPoints(*wizard);
    named<QTableWidget>(*wizard, "Floor points")->selectRow(0);
    QTest::mouseClick(button(*wizard, "Remove"), Qt::LeftButton);
    QCOMPARE(wizard->page().points().size(), std::size_t(3));
    QVERIFY(!wizard->page().registration());
    QVERIFY(!button(*wizard, "Save")->isEnabled());
    QTest::mouseClick(button(*wizard, "Undo"), Qt::LeftButton);
    QCOMPARE(wizard->page().points().size(), std::size_t(4));
    QVERIFY(wizard->page().registration());
}

void TestRegisterViaCameraWizard::aCameraIsNotRegisteredThroughItself()
{
    const auto wizard = makeWizard(image(1, true), image(0, true));
    QVERIFY(button(*wizard, "Next >")->isEnabled());
    named<QComboBox>(*wizard, "Camera to register")->setCurrentText(QStringLiteral("A"));
    QVERIFY(!button(*wizard, "Next >")->isEnabled());
    QVERIFY(says(*wizard, "cannot be registered via itself"));
}

void TestRegisterViaCameraWizard::tellsWhatIsWrong()
{
    const auto wizard = makeWizard(m_folder.filePath(QStringLiteral("none.png")), image(0, true));
    walkToPoints(*wizard);
    QTRY_VERIFY_WITH_TIMEOUT(says(*wizard, "the file does not exist"), patienceMs);
    QVERIFY(!button(*wizard, "Save")->isEnabled());
}

void TestRegisterViaCameraWizard::cancelsAtEveryPage()
{
    const auto first = makeWizard({}, {});
    QVERIFY(!button(*first, "Next >")->isEnabled());
    QTest::keyClick(first.get(), Qt::Key_Escape);
    QCOMPARE(first->QDialog::result(), int(QDialog::Rejected));
    const auto second = makeWizard(image(1, true), image(0, true));
    QTest::keyClick(second.get(), Qt::Key_Return);
    QTest::keyClick(second.get(), Qt::Key_Escape); // while the pictures are being got
    QCOMPARE(second->QDialog::result(), int(QDialog::Rejected));
}

ODOGRAPH_TEST(TestRegisterViaCameraWizard, QApplication)
#include "tst_register_via_camera_wizard.moc"
