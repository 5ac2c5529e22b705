// SPDX-License-Identifier: GPL-3.0-or-later
// Which device is which camera, how it is set, and the set-up doctor: all by keys.
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "ui/models/camera_lists.h"
#include "ui/record/internal/camera_choice.h"
#include "ui/record/internal/health_watch.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/widgets/fact_list.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

const CameraDescription webcam{.uri = "v4l2:/dev/video0",
                               .kind = "v4l2",
                               .name = foreignWords("Webcam"),
                               .formats = {{foreignWords("MJPG 1280×720 at 30 frames/s"), "MJPG", 1280, 720},
                                           {foreignWords("YUYV 640×480 at 30 frames/s"), "YUYV", 640, 480}}};
const CameraDescription industrial{
    .uri = "aravis:S1", .kind = "aravis", .name = foreignWords("Vendor Model")};

/// Walks there by the tabulator, as somebody without a mouse does.
bool walkTo(QDialog &dialog, const QWidget *wanted)
{
    for (int i = 0; i < 30 && dialog.focusWidget() != wanted; ++i)
        QTest::keyClick(&dialog, Qt::Key_Tab);
    return dialog.focusWidget() == wanted;
}

void show(QDialog &dialog)
{
    dialog.show();
    dialog.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
}

} // namespace

class TestRecordDialogs : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void devicesAreChosenByKeys();
    void oneDeviceIsNotTwoCameras();
    void settingsGoIntoTheAddress();
    void settingsOfAnAddressAreShownAndKept();
    void settingsAreAskedForFromTheChoice();
    void theDoctorLooksAndLooksAgain();
};

void TestRecordDialogs::devicesAreChosenByKeys()
{
    LiveCameras connected([] { return std::vector<CameraDescription>{webcam, industrial}; });
    CameraChoiceDialog dialog({{"A", ""}, {"B", ""}}, connected);
    show(dialog);
    auto *a = named<QComboBox>(dialog, "Device for camera A");
    auto *b = named<QComboBox>(dialog, "Device for camera B");
    QTRY_COMPARE(a->count(), 3);
    QPushButton *use = button(dialog, "Use these");
    QTRY_VERIFY(!connected.isSearching());
    QVERIFY(!use->isEnabled()); // none is used
    QVERIFY(walkTo(dialog, a));
    QTest::keyClick(a, Qt::Key_Down);
    QVERIFY(walkTo(dialog, b));
    QTest::keyClick(b, Qt::Key_End);
    QVERIFY(use->isEnabled());
    QTest::keyClick(b, Qt::Key_Return);
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QCOMPARE(dialog.cameras(), (std::vector<ChosenCamera>{{"A", "v4l2:/dev/video0"}, {"B", "aravis:S1"}}));
}

void TestRecordDialogs::oneDeviceIsNotTwoCameras()
{
    LiveCameras connected([] { return std::vector<CameraDescription>{webcam}; });
    CameraChoiceDialog dialog({{"A", "v4l2:/dev/video0?rate=15"}, {"B", "v4l2:/dev/video0"}}, connected);
    show(dialog);
    QTRY_VERIFY(dialog.findChild<QLabel *>(QStringLiteral("quiet"))->text() ==
                QStringLiteral("You cannot use one device as two cameras."));
    QVERIFY(!button(dialog, "Use these")->isEnabled());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QCOMPARE(dialog.result(), int(QDialog::Rejected));
}

void TestRecordDialogs::settingsGoIntoTheAddress()
{
    CameraSettingsDialog usb(webcam, webcam.uri);
    QCOMPARE(usb.uri(), webcam.uri); // nothing is wanted
    auto *live = named<QComboBox>(usb, "Format");
    live->setCurrentIndex(2);
    named<QDoubleSpinBox>(usb, "Rate")->setValue(15);
    QCOMPARE(usb.uri(), std::string("v4l2:/dev/video0?format=YUYV&size=640x480&rate=15"));

    CameraSettingsDialog gige(industrial, industrial.uri);
    show(gige);
    auto *rate = named<QDoubleSpinBox>(gige, "Rate");
    auto *exposure = named<QDoubleSpinBox>(gige, "Exposure");
    auto *trigger = named<QCheckBox>(gige, "Software trigger");
    QVERIFY(walkTo(gige, rate));
    QTest::keyClick(rate, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(rate, QStringLiteral("60"));
    QVERIFY(walkTo(gige, exposure));
    QTest::keyClick(exposure, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(exposure, QLocale().toString(2.5));
    QVERIFY(walkTo(gige, trigger));
    QTest::keyClick(trigger, Qt::Key_Space);
    QTest::keyClick(trigger, Qt::Key_Return);
    QCOMPARE(gige.result(), int(QDialog::Accepted));
    QCOMPARE(gige.uri(), std::string("aravis:S1?rate=60&exposure_ms=2.5&trigger=software"));
}

void TestRecordDialogs::settingsOfAnAddressAreShownAndKept()
{
    const std::string uri =
        "aravis:S1?format=BayerGB8&rate=60&exposure_ms=4&trigger=software&size=640x480&packet_delay_us=12";
    CameraSettingsDialog dialog(industrial, uri);
    QCOMPARE(named<QComboBox>(dialog, "Format")->currentText(), QStringLiteral("BayerGB8"));
    QCOMPARE(dialog.uri(), uri);
    named<QDoubleSpinBox>(dialog, "Exposure")->setValue(0);
    named<QCheckBox>(dialog, "Software trigger")->setChecked(false);
    QCOMPARE(dialog.uri(), std::string("aravis:S1?format=BayerGB8&rate=60&size=640x480&packet_delay_us=12"));
    // A picture that the camera is not known to have stays as it was asked for.
    const std::string other = "v4l2:/dev/video0?format=MJPG&size=800x600";
    QCOMPARE(CameraSettingsDialog(webcam, other).uri(), other);
}

void TestRecordDialogs::settingsAreAskedForFromTheChoice()
{
    LiveCameras connected([] { return std::vector<CameraDescription>{webcam}; });
    CameraChoiceDialog dialog({{"A", "v4l2:/dev/video0"}, {"B", ""}}, connected);
    show(dialog);
    QTRY_VERIFY(!connected.isSearching());
    auto *settings = named<QPushButton>(dialog, "Settings of camera A");
    QVERIFY(settings->isEnabled());
    QVERIFY(!named<QPushButton>(dialog, "Settings of camera B")->isEnabled());
    Person person({[](QDialog &asked) {
        named<QDoubleSpinBox>(asked, "Rate")->setValue(10);
        press(asked);
    }});
    QVERIFY(walkTo(dialog, settings));
    QTest::keyClick(settings, Qt::Key_Space);
    QTRY_VERIFY(person.isDone());
    QCOMPARE(dialog.cameras().front().second, std::string("v4l2:/dev/video0?rate=10"));
}

void TestRecordDialogs::theDoctorLooksAndLooksAgain()
{
    RunningCameras none;
    DoctorDialog dialog(none);
    show(dialog);
    QPushButton *again = button(dialog, "&Check again");
    QTRY_VERIFY(again->isEnabled());
    QVERIFY(walkTo(dialog, again));
    QTest::keyClick(again, Qt::Key_Space);
    QVERIFY(!again->isEnabled());
    QTRY_VERIFY(again->isEnabled());
    QVERIFY(dialog.findChild<FactList *>());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isVisible());
}

ODOGRAPH_TEST(TestRecordDialogs, QApplication)
#include "tst_record_dialogs.moc"
