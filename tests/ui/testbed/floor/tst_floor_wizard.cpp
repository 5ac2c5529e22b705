// SPDX-License-Identifier: GPL-3.0-or-later
// The floor wizard and the layout dialog as a person walks them, by mouse and by keyboard.
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/camera_lists.h"
#include "ui/testbed/floor/floor_wizard.h"
#include "ui/testbed/floor/layout_dialog.h"
#include "ui/testbed/floor/marker_canvas.h"

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 60'000;

} // namespace

class TestFloorWizard : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void findsTheMarkersByItself();
    void byKeyboardFromACamera();
    void byMouseFromACamera();
    void takesMarkersByMouseAndKeys();
    void staysOpenWhenTheDiskIsFull();
    void oneClickTellsAllOthersApart();
    void takesOutAndUndoes();
    void namesExchangedMarkers();
    void cancelsAtEveryPage_data();
    void cancelsAtEveryPage();
    void tellsWhatIsWrongWithAPicture();
    void layoutIsEditedInTableAndDrawing();
    void layoutAxesAreChanged();
    void layoutProblemsAreNamed_data();
    void layoutProblemsAreNamed();
    void layoutGoesOutAndComesBack();

private:
    std::unique_ptr<FloorWizard> makeWizard(const QString &image);
    void walkToMarkers(FloorWizard &wizard);
    Eigen::Vector2d truth(const char *label) const;

    QTemporaryDir m_folder;
    int m_keptWidth = 0;            ///< of the picture that was to be kept
    std::optional<Error> m_problem; ///< of keeping it
    LiveCameras m_live{[] {
        return std::vector<CameraDescription>{
            {.uri = "sim:A", .kind = "simulated", .name = foreignWords("Simulated")}};
    }};
    SimulatedScene m_scene = demoTestbed(1);
    QString m_image, m_bare; ///< with tags, and without
    LayoutRecord m_layout;
};

void TestFloorWizard::initTestCase()
{
    m_live.poll();
    QTRY_VERIFY(!m_live.isSearching());
    m_layout = {7, m_scene.floor.markers};
    m_layout.layout.name = "Gym";
    m_image = m_folder.filePath(QStringLiteral("tags.png"));
    QVERIFY(writeImage(SceneRenderer(m_scene, 0).render(0), m_image.toStdString()));
    SimulatedScene bare = m_scene;
    bare.floor.markerSideM = 0;
    m_bare = m_folder.filePath(QStringLiteral("bare.png"));
    QVERIFY(writeImage(SceneRenderer(bare, 0).render(0), m_bare.toStdString()));
}

Eigen::Vector2d TestFloorWizard::truth(const char *label) const
{
    for (const Marker &marker : m_layout.layout.markers)
        if (marker.label == label)
            return *m_scene.cameras[0].view.pixelFromWorld(
                {marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
    return {};
}

std::unique_ptr<FloorWizard> TestFloorWizard::makeWizard(const QString &image)
{
    IntrinsicsRecord lens;
    lens.id = 3;
    lens.calibration.intrinsics = m_scene.cameras[0].view.camera().intrinsics();
    auto wizard = std::make_unique<FloorWizard>(
        std::vector<FloorCamera>{{QStringLiteral("A"), lens, std::nullopt}}, QStringLiteral("A"),
        std::vector<LayoutRecord>{m_layout}, m_live,
        [this](const QString &, const Frame &kept) -> Result<void> {
            m_keptWidth = kept.format.width;
            return m_problem ? Result<void>(tl::unexpected(*m_problem)) : Result<void>();
        });
    if (!image.isEmpty())
        wizard->source().setFile(image);
    wizard->open();
    return wizard;
}

void TestFloorWizard::walkToMarkers(FloorWizard &wizard)
{
    QTest::keyClick(&wizard, Qt::Key_Return);
    QCOMPARE(wizard.findChild<QStackedWidget *>()->currentIndex(), 1);
    QTRY_COMPARE_WITH_TIMEOUT(wizard.findChild<QTableWidget *>()->rowCount(), 4, patienceMs);
}

void TestFloorWizard::findsTheMarkersByItself()
{
    const auto wizard = makeWizard(m_image);
    QVERIFY(QTest::qWaitForWindowActive(wizard.get()));
    walkToMarkers(*wizard);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QVERIFY(says(*wizard, "m above the floor"));
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
    QCOMPARE(m_keptWidth, 1280);
    const RegistrationRecord record = wizard->result();
    QCOMPARE(record.layout, RecordId(7));
    QCOMPARE(record.intrinsics, RecordId(3));
    QCOMPARE(record.pixels.size(), std::size_t(4));
    const Eigen::Vector3d off =
        record.registration.worldFromCamera.translation - m_scene.cameras[0].view.cameraInWorld();
    QVERIFY2(off.norm() < 0.02, qPrintable(QString::number(off.norm())));
}

void TestFloorWizard::byKeyboardFromACamera()
{
    const auto wizard = makeWizard({});
    QVERIFY(QTest::qWaitForWindowActive(wizard.get()));
    QVERIFY(!button(*wizard, "Next >")->isEnabled());
    const auto focused = [] { return QApplication::focusWidget(); };
    QTest::keyClick(wizard.get(), Qt::Key_A, Qt::AltModifier); // the camera, typed
    QTest::keyClick(focused(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(focused(), QStringLiteral("A"));
    QTest::keyClick(wizard.get(), Qt::Key_L, Qt::AltModifier);
    QVERIFY(qobject_cast<QComboBox *>(focused()));
    QTest::keyClick(wizard.get(), Qt::Key_C, Qt::AltModifier); // what a connected camera sees now
    QVERIFY(qobject_cast<QRadioButton *>(focused()));
    QTRY_VERIFY(qobject_cast<QRadioButton *>(focused())->isChecked()); // Qt presses a button for a moment
    QTest::keyClick(focused(), Qt::Key_Tab);
    QCOMPARE(focused()->accessibleName(), QStringLiteral("Connected camera"));
    BusyWatch busy;
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QCOMPARE(wizard->findChild<QStackedWidget *>()->currentIndex(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QVERIFY2(busy.longestMs() < longestAllowedMs(),
             qPrintable(QStringLiteral("the event loop stood for %1 ms").arg(busy.longestMs())));
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
    QCOMPARE(wizard->camera(), QStringLiteral("A"));
    const Eigen::Vector3d off =
        wizard->result().registration.worldFromCamera.translation - m_scene.cameras[0].view.cameraInWorld();
    QVERIFY2(off.norm() < 0.02, qPrintable(QString::number(off.norm())));
}

void TestFloorWizard::byMouseFromACamera()
{
    const auto wizard = makeWizard({});
    auto *live = wizard->findChildren<QRadioButton *>().at(1);
    QTest::mouseClick(live, Qt::LeftButton, {}, {8, live->height() / 2});
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QTest::mouseClick(button(*wizard, "< Back"), Qt::LeftButton);
    QCOMPARE(wizard->findChild<QStackedWidget *>()->currentIndex(), 0);
    QTest::mouseClick(button(*wizard, "Next >"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
}

void TestFloorWizard::staysOpenWhenTheDiskIsFull()
{
    m_problem = test::saidError(ErrorCode::Io, "calibration image 'A_floor'", "no space left on device",
                                "check the free space");
    const auto wizard = makeWizard(m_image);
    walkToMarkers(*wizard);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_VERIFY(says(*wizard, "The registration was not stored. calibration image 'A_floor': no space left "
                              "on device; check the free space"));
    m_problem.reset();
    QTRY_VERIFY(button(*wizard, "Save")->isEnabled());
    QTest::mouseClick(button(*wizard, "Save"), Qt::LeftButton);
    QTRY_COMPARE(wizard->QDialog::result(), int(QDialog::Accepted));
}

void TestFloorWizard::takesMarkersByMouseAndKeys()
{
    const auto wizard = makeWizard(m_bare);
    walkToMarkers(*wizard);
    QVERIFY(!button(*wizard, "Save")->isEnabled());
    MarkerCanvas &canvas = wizard->markers().canvas();
    auto *table = wizard->findChild<QTableWidget *>();
    // Click after click: the next marker that is nowhere is chosen by itself.
    for (int row = 0; row < 4; ++row) {
        const QByteArray label = table->item(table->currentRow(), 0)->text().toUtf8();
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.fromPixel(truth(label.constData())).toPoint());
        QCOMPARE(wizard->markers().pixels().size(), std::size_t(row + 1));
    }
    // A click is good to a screen pixel, which is more than one of the picture.
    QVERIFY2(wizard->markers().registration() || says(*wizard, "fit"),
             "four clicks say where the camera stands, or why not");
    // The keys move the chosen marker by a tenth of a pixel, with Shift by one.
    table->selectRow(0);
    const std::string label = table->item(0, 0)->text().toStdString();
    const auto pixel = [&] {
        return std::ranges::find(wizard->markers().pixels(), label, &MarkerPixel::label)->pixel;
    };
    const Eigen::Vector2d before = pixel();
    QTest::keyClick(&canvas, Qt::Key_Right);
    QTest::keyClick(&canvas, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY((pixel() - before - Eigen::Vector2d(0.1, -1)).norm() < 1e-9);
}

void TestFloorWizard::oneClickTellsAllOthersApart()
{
    // Rings in a rectangle look the same from two sides.
    SimulatedScene rings = m_scene;
    rings.floor.markerShape = MarkerShape::Ring;
    const QString image = m_folder.filePath(QStringLiteral("rings.png"));
    QVERIFY(writeImage(SceneRenderer(rings, 0).render(0), image.toStdString()));
    const auto wizard = makeWizard(image);
    walkToMarkers(*wizard);
    QTRY_VERIFY_WITH_TIMEOUT(says(*wizard, "in 2 ways"), patienceMs);
    MarkerCanvas &canvas = wizard->markers().canvas();
    auto *table = wizard->findChild<QTableWidget *>();
    const QByteArray label = table->item(table->currentRow(), 0)->text().toUtf8();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.fromPixel(truth(label.constData())).toPoint());
    QTRY_COMPARE_WITH_TIMEOUT(wizard->markers().pixels().size(), std::size_t(4), patienceMs);
    for (const MarkerPixel &marker : wizard->markers().pixels())
        QVERIFY((marker.pixel - truth(marker.label.c_str())).norm() < 0.5);
    QVERIFY(button(*wizard, "Save")->isEnabled());
}

void TestFloorWizard::takesOutAndUndoes()
{
    const auto wizard = makeWizard(m_image);
    walkToMarkers(*wizard);
    QTRY_VERIFY_WITH_TIMEOUT(button(*wizard, "Save")->isEnabled(), patienceMs);
    QTest::mouseClick(button(*wizard, "Remove"), Qt::LeftButton);
    QCOMPARE(wizard->markers().pixels().size(), std::size_t(3));
    QVERIFY(!button(*wizard, "Save")->isEnabled());
    QVERIFY(says(*wizard, "four markers in common"));
    QTest::mouseClick(button(*wizard, "Undo"), Qt::LeftButton);
    QVERIFY(button(*wizard, "Save")->isEnabled());
}

void TestFloorWizard::namesExchangedMarkers()
{
    std::swap(m_layout.layout.markers[1].pointInWorld, m_layout.layout.markers[2].pointInWorld);
    const auto wizard = makeWizard(m_image);
    std::swap(m_layout.layout.markers[1].pointInWorld, m_layout.layout.markers[2].pointInWorld);
    walkToMarkers(*wizard);
    QTRY_VERIFY_WITH_TIMEOUT(says(*wizard, "swapped"), patienceMs);
    QVERIFY(!button(*wizard, "Save")->isEnabled());
}

void TestFloorWizard::cancelsAtEveryPage_data()
{
    QTest::addColumn<bool>("live");
    QTest::addRow("from a file") << false;
    QTest::addRow("from a camera") << true;
}

void TestFloorWizard::cancelsAtEveryPage()
{
    QFETCH(bool, live);
    for (int page = 0; page < 2; ++page) {
        const auto wizard = makeWizard(live ? QString() : m_image);
        if (live)
            wizard->findChildren<QRadioButton *>().at(1)->setChecked(true);
        if (page > 0)
            QTest::keyClick(wizard.get(), Qt::Key_Return); // and away while the markers are being looked for
        QTest::keyClick(wizard.get(), Qt::Key_Escape);
        QVERIFY(!wizard->isVisible());
        QCOMPARE(wizard->QDialog::result(), int(QDialog::Rejected));
    }
}

void TestFloorWizard::tellsWhatIsWrongWithAPicture()
{
    SimulatedScene small = m_scene;
    Intrinsics lens = small.cameras[0].view.camera().intrinsics();
    const QString other = m_folder.filePath(QStringLiteral("small.png"));
    QVERIFY(writeImage(renderBoard(CameraModel::assumed(640, 480),
                                   {.cameraFromBoard = {Eigen::Quaterniond::Identity(), {0, 0, 0.5}}}, 0, 1),
                       other.toStdString()));
    const auto wizard = makeWizard(other);
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(says(*wizard, "its size is 640×480, but the lens was calibrated at 1280×720"),
                             patienceMs);
    QVERIFY(says(*wizard, "calibrate the lens again"));
    QVERIFY(!button(*wizard, "Save")->isEnabled());
}

void TestFloorWizard::layoutIsEditedInTableAndDrawing()
{
    LayoutDialog dialog(m_layout.layout, {QStringLiteral("Gym")});
    dialog.open();
    QCOMPARE(QString::fromStdString(dialog.layout().name), QStringLiteral("Gym (2)"));
    QVERIFY(button(dialog, "Save")->isEnabled());
    auto *table = dialog.findChild<QTableWidget *>();
    table->item(1, 1)->setText(QStringLiteral("2500"));
    QVERIFY(std::abs(dialog.layout().markers[1].pointInWorld.x() - 2.5) < 1e-12);
    Q_EMIT dialog.findChild<LayoutDrawing *>()->moved(1, {2.75, 0});
    QCOMPARE(table->item(1, 1)->text(), QStringLiteral("2750"));
    QTest::mouseClick(button(dialog, "Add"), Qt::LeftButton);
    QCOMPARE(table->rowCount(), 5);
    QTest::mouseClick(button(dialog, "Remove"), Qt::LeftButton);
    QCOMPARE(table->rowCount(), 4);
}

void TestFloorWizard::layoutAxesAreChanged()
{
    LayoutDialog dialog(m_layout.layout, {});
    AxesChange change;
    change.originMarker = "D";
    dialog.changeAxes(change);
    const auto &markers = dialog.layout().markers;
    const auto d = std::ranges::find(markers, std::string("D"), &Marker::label),
               o = std::ranges::find(markers, std::string("O"), &Marker::label);
    QVERIFY(d->pointInWorld.norm() < 1e-12);
    QVERIFY((o->pointInWorld + m_layout.layout.markers.back().pointInWorld -
             m_layout.layout.markers.front().pointInWorld)
                .norm() < 1e-9);
    dialog.changeAxes({.reverseX = true});
    QVERIFY2(says(dialog, "mirror"), "one axis alone cannot be reversed");
}

void TestFloorWizard::layoutProblemsAreNamed_data()
{
    QTest::addColumn<int>("row");
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("words");
    QTest::newRow("no label") << 1 << 0 << QString() << QStringLiteral("A marker has no label.");
    QTest::newRow("the same label") << 1 << 0 << QStringLiteral("O")
                                    << QStringLiteral("Two markers are called O.");
    QTest::newRow("no number") << 1 << 1 << QStringLiteral("far")
                               << QStringLiteral("The position of U is not a number.");
    QTest::newRow("one place") << 1 << 1 << QStringLiteral("0")
                               << QStringLiteral("O and U have the same position.");
}

void TestFloorWizard::layoutProblemsAreNamed()
{
    QFETCH(int, row);
    QFETCH(int, column);
    QFETCH(QString, text);
    QFETCH(QString, words);
    LayoutDialog dialog({"x", {{"O", {0, 0}}, {"U", {3, 0}}, {"V", {0, 2}}, {"D", {3, 2}}}}, {});
    dialog.findChild<QTableWidget *>()->item(row, column)->setText(text);
    QCOMPARE(dialog.problem(), words);
    QVERIFY(!button(dialog, "Save")->isEnabled());
}

void TestFloorWizard::layoutGoesOutAndComesBack()
{
    const QString file = m_folder.filePath(QStringLiteral("layout.csv"));
    LayoutDialog from(m_layout.layout, {}),
        to({"y", {{"O", {0, 0}}, {"U", {1, 0}}, {"V", {0, 1}}, {"D", {1, 1}}}}, {});
    QVERIFY(from.exportCsv(file.toStdString()));
    QVERIFY(to.importCsv(file));
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY((from.layout().markers[i].pointInWorld - to.layout().markers[i].pointInWorld).norm() < 1e-12);
    QVERIFY(!to.importCsv(m_folder.filePath(QStringLiteral("nowhere.csv"))));
}

ODOGRAPH_TEST(TestFloorWizard, QApplication)
#include "tst_floor_wizard.moc"
