// SPDX-License-Identifier: GPL-3.0-or-later
// A known length is checked as a person does it, by mouse and by keyboard.
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/camera_lists.h"
#include "ui/testbed/check/length_wizard.h"
#include "ui/testbed/floor/marker_canvas.h"
#include "ui/testbed/floor/still_image.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 60'000;

} // namespace

class TestLengthWizard : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void measuresByMouse();
    void measuresByKeysAlone();
    void tellsALengthThatIsOff();
    void measuresWithoutATruth();
    void tellsWhatIsWrong();
    void takesAnImageOfAnotherSize();
    void takesTheNewestRecordingAndALiveCamera();
    void cancelsAtEveryPage();

private:
    std::unique_ptr<LengthWizard> makeWizard(const QString &image);
    void walkToEnds(LengthWizard &wizard);
    Eigen::Vector2d seen(const char *label) const;
    /// Between markers O and U.
    double trueLengthMm() const;

    QTemporaryDir m_folder;
    LiveCameras m_live{[] {
        return std::vector<CameraDescription>{
            {.uri = "sim:A", .kind = "simulated", .name = foreignWords("Simulated")}};
    }};
    SimulatedScene m_scene = demoTestbed(1);
    QString m_image;
};

void TestLengthWizard::initTestCase()
{
    m_live.poll();
    QTRY_VERIFY(!m_live.isSearching());
    m_image = m_folder.filePath(QStringLiteral("tags.png"));
    QVERIFY(writeImage(SceneRenderer(m_scene, 0).render(0), m_image.toStdString()));
}

Eigen::Vector2d TestLengthWizard::seen(const char *label) const
{
    for (const Marker &marker : m_scene.floor.markers.markers)
        if (marker.label == label)
            return *m_scene.cameras[0].view.pixelFromWorld(
                {marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
    return {};
}

double TestLengthWizard::trueLengthMm() const
{
    const auto &markers = m_scene.floor.markers.markers;
    const auto at = [&](const char *label) {
        return std::ranges::find(markers, std::string(label), &Marker::label)->pointInWorld;
    };
    return 1000 * (at("U") - at("O")).norm();
}

std::unique_ptr<LengthWizard> TestLengthWizard::makeWizard(const QString &image)
{
    // A camera whose pose is known to some millimetres, as after a good registration.
    const FloorView &truth = m_scene.cameras[0].view;
    const FloorView view(truth.camera(), truth.worldFromCamera(),
                         Eigen::Matrix<double, 6, 6>::Identity() * 1e-7);
    CheckCamera camera{QStringLiteral("A"), view, m_scene.floor.markers, std::nullopt};
    camera.registration.registration.worldFromCamera = view.worldFromCamera();
    camera.registration.registration.poseCovariance = view.poseCovariance();
    auto wizard =
        std::make_unique<LengthWizard>(std::vector<CheckCamera>{camera}, QStringLiteral("A"), m_live);
    if (!image.isEmpty())
        wizard->image().setFile(image);
    wizard->open();
    return wizard;
}

void TestLengthWizard::walkToEnds(LengthWizard &wizard)
{
    QTest::keyClick(&wizard, Qt::Key_Return);
    QCOMPARE(wizard.findChild<QStackedWidget *>()->currentIndex(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(says(wizard, "click both ends"), patienceMs);
}

void TestLengthWizard::measuresByMouse()
{
    const auto wizard = makeWizard(m_image);
    walkToEnds(*wizard);
    MarkerCanvas &canvas = wizard->page().canvas();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.fromPixel(seen("O")).toPoint());
    QVERIFY(!wizard->page().check());
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.fromPixel(seen("U")).toPoint());
    QVERIFY(wizard->page().check());
    auto *table = named<QTableWidget>(*wizard, "Ends of the length");
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("tag"));
    named<QDoubleSpinBox>(*wizard, "True length")->setValue(trueLengthMm());
    const LengthCheck &check = *wizard->page().check();
    QVERIFY2(check.agrees, check.words.english().c_str());
    // Both tags are found to a few tenths of a pixel, which is a millimetre or two here.
    QVERIFY2(std::abs(*check.differenceM) < 0.003, check.words.english().c_str());
    QVERIFY(says(*wizard, "within uncertainty"));
    // The same in another unit.
    named<QDoubleSpinBox>(*wizard, "True length")->setValue(trueLengthMm() / 1000);
    named<QComboBox>(*wizard, "Unit of the true length")->setCurrentText(QStringLiteral("m"));
    QVERIFY(wizard->page().check()->agrees);
}

void TestLengthWizard::measuresByKeysAlone()
{
    const auto wizard = makeWizard(m_image);
    QVERIFY(QTest::qWaitForWindowActive(wizard.get()));
    walkToEnds(*wizard);
    MarkerCanvas &canvas = wizard->page().canvas();
    QTRY_VERIFY(canvas.hasFocus());
    const Intrinsics &lens = m_scene.cameras[0].view.camera().intrinsics();
    // from the middle, in steps of twenty pixels and of one
    const auto walk = [&](const Eigen::Vector2d &to) {
        const Eigen::Vector2d way = to - 0.5 * Eigen::Vector2d(lens.widthPx - 1, lens.heightPx - 1);
        for (const auto &[pixels, less, more] : {std::tuple(way.x(), Qt::Key_Left, Qt::Key_Right),
                                                 std::tuple(way.y(), Qt::Key_Up, Qt::Key_Down)}) {
            const Qt::Key key = pixels < 0 ? less : more;
            const int whole = int(std::abs(pixels));
            for (int i = 0; i < whole / 20; ++i)
                QTest::keyClick(&canvas, key, Qt::ControlModifier);
            for (int i = 0; i < whole % 20; ++i)
                QTest::keyClick(&canvas, key, Qt::ShiftModifier);
        }
    };
    walk(seen("O"));
    QTest::keyClick(&canvas, Qt::Key_Space); // which goes on to the other end
    walk(seen("U"));
    QTest::keyClick(&canvas, Qt::Key_Space);
    QVERIFY(wizard->page().check());
    auto *told = named<QDoubleSpinBox>(*wizard, "True length");
    told->setFocus();
    told->selectAll();
    QTest::keyClicks(told, QLocale().toString(trueLengthMm(), 'f', 1).remove(QLocale().groupSeparator()));
    QTest::keyClick(told, Qt::Key_Tab);
    QVERIFY2(wizard->page().check()->agrees, wizard->page().check()->words.english().c_str());
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QVERIFY(!wizard->isVisible());
}

void TestLengthWizard::tellsALengthThatIsOff()
{
    const auto wizard = makeWizard(m_image);
    walkToEnds(*wizard);
    MarkerCanvas &canvas = wizard->page().canvas();
    for (const char *end : {"O", "U"})
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.fromPixel(seen(end)).toPoint());
    named<QDoubleSpinBox>(*wizard, "True length")->setValue(trueLengthMm() + 50);
    QVERIFY(!wizard->page().check()->agrees);
    QVERIFY(says(*wizard, "outside uncertainty"));
    QVERIFY(says(*wizard, "the marker positions"));
}

void TestLengthWizard::measuresWithoutATruth()
{
    const auto wizard = makeWizard(m_image);
    walkToEnds(*wizard);
    MarkerCanvas &canvas = wizard->page().canvas();
    for (const char *end : {"O", "U"})
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.fromPixel(seen(end)).toPoint());
    QVERIFY(!wizard->page().check()->differenceM);
    QVERIFY(says(*wizard, "Enter its true length"));
    // A step by key is by hand: no longer what was snapped to.
    QTest::keyClick(&canvas, Qt::Key_Right);
    QCOMPARE(named<QTableWidget>(*wizard, "Ends of the length")->item(1, 1)->text(),
             QStringLiteral("by hand"));
}

void TestLengthWizard::tellsWhatIsWrong()
{
    const QString small = m_folder.filePath(QStringLiteral("small.png"));
    QVERIFY(writeImage(renderBoard(CameraModel::assumed(640, 480),
                                   {.cameraFromBoard = {Eigen::Quaterniond::Identity(), {0, 0, 0.5}}}, 0, 1),
                       small.toStdString()));
    const auto wizard = makeWizard(small);
    QTest::keyClick(wizard.get(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(says(*wizard, "its size is 640×480, but the lens was calibrated at 1280×720"),
                             patienceMs);

    const auto same = makeWizard(m_image);
    walkToEnds(*same);
    MarkerCanvas &canvas = same->page().canvas();
    for (int end = 0; end < 2; ++end) { // the arrows begin in the middle, for both
        named<QTableWidget>(*same, "Ends of the length")->selectRow(end);
        QTest::keyClick(&canvas, Qt::Key_Up);
    }
    QVERIFY(says(*same, "both ends are on the same pixel"));
    QVERIFY(!same->page().check());
}

/// The lens is converted to an image of half the size, and the wizard says so.
void TestLengthWizard::takesAnImageOfAnotherSize()
{
    const QString half = m_folder.filePath(QStringLiteral("half.png"));
    const QImage image(m_image);
    QVERIFY(image.scaled(image.size() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).save(half));
    const auto wizard = makeWizard(half);
    walkToEnds(*wizard);
    const char *converted = "The lens calibration at 1280×720 was converted to 640×360.";
    QVERIFY(says(*wizard, converted));
    MarkerCanvas &canvas = wizard->page().canvas();
    for (const char *label : {"O", "U"}) {
        const Eigen::Vector2d pixel = 0.5 * (seen(label).array() + 0.5) - 0.5;
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.fromPixel(pixel).toPoint());
    }
    QVERIFY(wizard->page().check());
    named<QDoubleSpinBox>(*wizard, "True length")->setValue(trueLengthMm());
    const LengthCheck &check = *wizard->page().check();
    QVERIFY2(check.agrees, check.words.english().c_str());
    // Both tags are found to a few tenths of a pixel of twice the size on the floor.
    QVERIFY2(std::abs(*check.differenceM) < 0.006, check.words.english().c_str());
    QVERIFY(says(*wizard, converted));
}

void TestLengthWizard::takesTheNewestRecordingAndALiveCamera()
{
    ImageChoice choice(m_live, QStringLiteral("file"));
    QVERIFY(!choice.isComplete());
    choice.setRecording(std::filesystem::path("/somewhere/a.mkv"));
    QCOMPARE(choice.origin().file, QStringLiteral("/somewhere/a.mkv"));
    choice.setRecording(std::nullopt); // of another camera, which has none
    QVERIFY(!choice.isComplete());
    for (auto *radio : choice.findChildren<QAbstractButton *>())
        if (radio->text().contains(QLatin1String("onnected")))
            radio->click();
    QCOMPARE(choice.origin().liveUri, QStringLiteral("sim:A"));
    QVERIFY(choice.isComplete());
}

void TestLengthWizard::cancelsAtEveryPage()
{
    for (int page = 0; page < 2; ++page) {
        const auto wizard = makeWizard(m_image);
        if (page > 0)
            QTest::keyClick(wizard.get(), Qt::Key_Return); // and away while the picture is being got
        QTest::keyClick(wizard.get(), Qt::Key_Escape);
        QVERIFY(!wizard->isVisible());
        QCOMPARE(wizard->QDialog::result(), int(QDialog::Rejected));
    }
}

ODOGRAPH_TEST(TestLengthWizard, QApplication)
#include "tst_length_wizard.moc"
