// SPDX-License-Identifier: GPL-3.0-or-later
// The map of expected accuracy as a person uses it, by mouse and by keyboard.
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/testbed/check/accuracy_dialog.h"
#include "ui/testbed/check/floor_sketch.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int patienceMs = 60'000;

} // namespace

class TestAccuracyDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void mapsTheRegisteredCameras();
    void togetherIsBetterThanAlone();
    void plansByNumbersAlone();
    void plansByMouse();
    void findsTheBestPlace();
    void saysWhyAPlannedCameraCannotBeThere();
    void saysWhichCameraToMove();
    void levelsAreRound();
    void closingLeavesNothing();

private:
    std::unique_ptr<AccuracyDialog> makeDialog(int cameras);
    QString summary(AccuracyDialog &dialog);

    SimulatedScene m_scene = demoTestbed(1);
};

std::unique_ptr<AccuracyDialog> TestAccuracyDialog::makeDialog(int cameras)
{
    std::vector<CheckCamera> known;
    for (int i = 0; i < cameras; ++i) {
        const FloorView &truth = m_scene.cameras[std::size_t(i)].view;
        known.push_back({QString(QChar(u'A' + i)),
                         FloorView(truth.camera(), truth.worldFromCamera(),
                                   Eigen::Matrix<double, 6, 6>::Identity() * 1e-7),
                         m_scene.floor.markers, std::nullopt});
    }
    auto dialog = std::make_unique<AccuracyDialog>(m_scene.floor.markers, known, PlacementQuestion{0.06});
    dialog->open();
    return dialog;
}

QString TestAccuracyDialog::summary(AccuracyDialog &dialog)
{
    const bool settled = QTest::qWaitFor([&] { return dialog.isSettled(); }, patienceMs);
    return settled ? named<QLabel>(dialog, "Expected accuracy in words")->text() : QString();
}

/// The first figure of "±1.8 mm in the middle, …".
static double middleMm(const QString &words)
{
    return words.mid(1, words.indexOf(QLatin1Char(' ')) - 1).toDouble();
}

void TestAccuracyDialog::mapsTheRegisteredCameras()
{
    const auto dialog = makeDialog(2);
    const QString words = summary(*dialog);
    QVERIFY2(words.contains(QStringLiteral("mm in the middle")), qPrintable(words));
    QVERIFY2(middleMm(words) > 0.1 && middleMm(words) < 10, qPrintable(words));
    QCOMPARE(named<QListWidget>(*dialog, "Cameras included")->count(), 2);
}

void TestAccuracyDialog::togetherIsBetterThanAlone()
{
    const auto dialog = makeDialog(2);
    const double together = middleMm(summary(*dialog));
    for (auto *box : dialog->findChildren<QComboBox *>())
        if (box->findText(QStringLiteral("The chosen camera alone")) >= 0)
            box->setCurrentIndex(1);
    const double alone = middleMm(summary(*dialog));
    QVERIFY2(alone > together, qPrintable(QStringLiteral("%1 %2").arg(alone).arg(together)));
    // The same by taking the other's tick away.
    const auto other = makeDialog(2);
    named<QListWidget>(*other, "Cameras included")->item(1)->setCheckState(Qt::Unchecked);
    QCOMPARE(middleMm(summary(*other)), alone);
}

void TestAccuracyDialog::plansByNumbersAlone()
{
    const auto dialog = makeDialog(2);
    QVERIFY(QTest::qWaitForWindowActive(dialog.get()));
    const double before = middleMm(summary(*dialog));
    QTest::keyClick(dialog.get(), Qt::Key_P, Qt::AltModifier);
    QTRY_COMPARE(named<QListWidget>(*dialog, "Cameras included")->count(), 3);
    QVERIFY(dialog->planned(2));
    auto *height = named<QDoubleSpinBox>(*dialog, "Height of the camera");
    height->setFocus();
    height->selectAll();
    QTest::keyClicks(height, QStringLiteral("3000"));
    QTest::keyClick(height, Qt::Key_Tab);
    QCOMPARE(dialog->planned(2)->heightM, 3.0);
    auto *direction = named<QDoubleSpinBox>(*dialog, "Viewing direction");
    const Eigen::Vector2d foot = dialog->planned(2)->footM();
    direction->setValue(direction->value() + 10);                 // it turns where it stands
    QVERIFY((dialog->planned(2)->footM() - foot).norm() < 0.002); // the form counts in whole millimetres
    const QString words = summary(*dialog);
    QVERIFY2(middleMm(words) <= before, qPrintable(words));
}

void TestAccuracyDialog::plansByMouse()
{
    const auto dialog = makeDialog(0); // with none, one is planned to begin with
    QVERIFY(dialog->planned(0));
    QVERIFY2(summary(*dialog).contains(QStringLiteral("mm in the middle")),
             "it sees the markers from where it begins");
    FloorSketch &sketch = dialog->sketch();
    const Eigen::Vector2d foot = dialog->planned(0)->footM(), aim = dialog->planned(0)->aimM;
    const QPoint from = sketch.fromWorld(foot).toPoint(), by(60, -20);
    QTest::mousePress(&sketch, Qt::LeftButton, {}, from);
    QTest::mouseMove(&sketch, from + by);
    QTest::mouseRelease(&sketch, Qt::LeftButton, {}, from + by);
    QVERIFY((dialog->planned(0)->footM() - foot).x() > 0.1);
    QVERIFY((dialog->planned(0)->footM() - foot).y() > 0.03);
    QVERIFY((dialog->planned(0)->aimM - aim).norm() < 1e-9);
    summary(*dialog);
    const QPoint at = sketch.fromWorld(dialog->planned(0)->aimM).toPoint();
    QTest::mousePress(&sketch, Qt::LeftButton, {}, at);
    QTest::mouseMove(&sketch, at + QPoint(0, -30));
    QTest::mouseRelease(&sketch, Qt::LeftButton, {}, at + QPoint(0, -30));
    QVERIFY((dialog->planned(0)->aimM - aim).y() > 0.05);
}

void TestAccuracyDialog::findsTheBestPlace()
{
    const auto dialog = makeDialog(0);
    const auto worst = [&] {
        const QString words = summary(*dialog), after = words.mid(words.lastIndexOf(QChar(0xb1)) + 1);
        return after.left(after.indexOf(QLatin1Char(' '))).toDouble();
    };
    named<QDoubleSpinBox>(*dialog, "Field of view")->setValue(75);
    const double before = worst();
    QTest::mouseClick(button(*dialog, "Find best position"), Qt::LeftButton);
    QVERIFY(!dialog->isSettled());
    const double after = worst();
    QVERIFY2(after > 0 && after < before, qPrintable(QStringLiteral("%1 %2").arg(before).arg(after)));
}

void TestAccuracyDialog::saysWhyAPlannedCameraCannotBeThere()
{
    const auto dialog = makeDialog(0);
    named<QDoubleSpinBox>(*dialog, "Field of view")->setValue(10);
    summary(*dialog);
    QVERIFY(says(*dialog, "four are needed"));
    QVERIFY(says(*dialog, "choose a wider lens"));
    QVERIFY(says(*dialog, "None of the floor between the markers is in view."));
    named<QDoubleSpinBox>(*dialog, "Field of view")->setValue(80);
    summary(*dialog);
    QVERIFY(named<QLabel>(*dialog, "Problems")->isHidden());
}

/// The camera that is moved counts in the stead of the one that is registered, once it is ticked, and the map
/// is then what the sentence promises.
void TestAccuracyDialog::saysWhichCameraToMove()
{
    // far away and low, where a metre helps
    m_scene.cameras[1].view = simulatedView({6.5, 5.5, 0.9}, {1.5, 1, 0}, 1280, 720, 1500);
    const auto dialog = makeDialog(2);
    m_scene = demoTestbed(1);
    const QString before = summary(*dialog);
    QTest::mouseClick(button(*dialog, "Advice"), Qt::LeftButton);
    summary(*dialog);
    const QString words = named<QLabel>(*dialog, "Advice in words")->text();
    QVERIFY2(words.contains(QStringLiteral("Moving B by ")) &&
                 words.contains(QStringLiteral(" lowers the error from ±")),
             qPrintable(words));
    auto *list = named<QListWidget>(*dialog, "Cameras included");
    const auto rowOf = [list](const QString &text) {
        return list->findItems(text, Qt::MatchExactly).value(0);
    };
    QVERIFY(rowOf(QStringLiteral("B, moved")) != nullptr);
    QCOMPARE(rowOf(QStringLiteral("B, moved"))->checkState(), Qt::Unchecked);
    rowOf(QStringLiteral("B, moved"))->setCheckState(Qt::Checked);
    const QString after = summary(*dialog);
    QCOMPARE(list->item(1)->checkState(), Qt::Unchecked);
    QVERIFY2(middleMm(after) > 0 && after != before, qPrintable(after));
    list->item(1)->setCheckState(Qt::Checked);
    QCOMPARE(rowOf(QStringLiteral("B, moved"))->checkState(), Qt::Unchecked);
    QCOMPARE(summary(*dialog), before);
}

void TestAccuracyDialog::levelsAreRound()
{
    SketchedAccuracy accuracy{{{0, 0}, 1, 4, 1}, {0.0013, 0.0045, std::nan(""), 0.021}};
    const auto levels = accuracyLevelsM(accuracy);
    QCOMPARE(levels.size(), std::size_t(4)); // 2, 5, 10 and 20 mm
    QVERIFY(std::abs(levels.front() - 0.002) < 1e-12 && std::abs(levels.back() - 0.02) < 1e-12);
    accuracy.sigmaM.assign(4, std::nan(""));
    QVERIFY(accuracyLevelsM(accuracy).empty());
}

void TestAccuracyDialog::closingLeavesNothing()
{
    const auto dialog = makeDialog(1);
    QTest::keyClick(dialog.get(), Qt::Key_P, Qt::AltModifier);
    QTest::mouseClick(button(*dialog, "Find best position"),
                      Qt::LeftButton); // and away while it is looked for
    QTest::keyClick(dialog.get(), Qt::Key_Escape);
    QVERIFY(!dialog->isVisible());
}

ODOGRAPH_TEST(TestAccuracyDialog, QApplication)
#include "tst_accuracy_dialog.moc"
