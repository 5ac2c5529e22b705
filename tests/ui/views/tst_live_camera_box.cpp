// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/models/camera_lists.h"
#include "ui/views/widgets/form_fields.h"

#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <future>

using namespace odo;

class TestLiveCameraBox : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void fillsWhenTheCamerasAreFound()
    {
        std::promise<std::vector<CameraDescription>> found;
        LiveCameras cameras([&] { return found.get_future().get(); });
        LiveCameraBox box(cameras);
        QCOMPARE(box.currentText(), QStringLiteral("No camera is connected"));
        cameras.poll();
        QVERIFY(cameras.isSearching());
        QCOMPARE(box.currentText(), QStringLiteral("Searching for cameras…"));
        QVERIFY(box.uri().isEmpty());
        QSignalSpy chosen(&box, &QComboBox::currentIndexChanged);
        found.set_value({{.uri = "sim:A",
                          .kind = "simulated",
                          .name = foreignWords("One"),
                          .widthPx = 640,
                          .heightPx = 480},
                         {.uri = "sim:B", .kind = "simulated", .name = foreignWords("Two")}});
        QTRY_COMPARE(box.count(), 2);
        QCOMPARE(box.currentText(), QStringLiteral("One, 640×480"));
        QCOMPARE(box.uri(), QStringLiteral("sim:A"));
        QCOMPARE(chosen.size(), qsizetype(1));
    }
    void keepsWhatIsChosenWhileItIsThere()
    {
        std::vector<CameraDescription> there{
            {.uri = "sim:A", .kind = "simulated", .name = foreignWords("One")},
            {.uri = "sim:B", .kind = "simulated", .name = foreignWords("Two")}};
        LiveCameras cameras([&] { return there; });
        LiveCameraBox box(cameras);
        cameras.poll();
        QTRY_COMPARE(box.count(), 2);
        box.setCurrentIndex(1);
        there.insert(there.begin(), {.uri = "sim:C", .kind = "simulated", .name = foreignWords("Three")});
        cameras.poll();
        QTRY_COMPARE(box.count(), 3);
        QCOMPARE(box.uri(), QStringLiteral("sim:B"));
        there.pop_back();
        cameras.poll();
        QTRY_COMPARE(box.count(), 2);
        QCOMPARE(box.uri(), QStringLiteral("sim:C"));
    }
};

ODOGRAPH_TEST(TestLiveCameraBox, QApplication)
#include "tst_live_camera_box.moc"
