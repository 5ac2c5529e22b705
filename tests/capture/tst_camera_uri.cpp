// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_source.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

class TestCameraUri : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isTakenApart()
    {
        const CameraUri uri = splitCameraUri("v4l2:/dev/video0?size=640x480&rate=30", "v4l2:");
        QCOMPARE(uri.location, std::string("/dev/video0"));
        QCOMPARE(uri.cameraSettings.size(), std::size_t(2));
        QCOMPARE(uri.cameraSettings[0].name, std::string("size"));
        QCOMPARE(uri.cameraSettings[0].value, std::string("640x480"));
        QCOMPARE(uri.cameraSettings[1].text, std::string("rate=30"));
    }

    void whatSaysLittle_data()
    {
        QTest::addColumn<QByteArray>("uri");
        QTest::addColumn<QByteArray>("location");
        QTest::addColumn<QByteArrayList>("cameraSettings");
        QTest::newRow("no place") << QByteArray("x:") << QByteArray() << QByteArrayList();
        QTest::newRow("no wish") << QByteArray("x:a?") << QByteArray("a") << QByteArrayList();
        QTest::newRow("an end too many")
            << QByteArray("x:a?b=1&") << QByteArray("a") << QByteArrayList{"b=1"};
        QTest::newRow("an empty one between")
            << QByteArray("x:a?b=1&&c=2") << QByteArray("a") << QByteArrayList{"b=1", "", "c=2"};
        QTest::newRow("a second question mark")
            << QByteArray("x:a?b=1?c=2") << QByteArray("a") << QByteArrayList{"b=1?c=2"};
    }
    void whatSaysLittle()
    {
        QFETCH(QByteArray, uri);
        QFETCH(QByteArray, location);
        QFETCH(QByteArrayList, cameraSettings);
        const CameraUri split = splitCameraUri(uri.toStdString(), "x:");
        QCOMPARE(split.location, location.toStdString());
        QByteArrayList texts;
        for (const CameraSetting &setting : split.cameraSettings)
            texts << QByteArray::fromStdString(setting.text);
        QCOMPARE(texts, cameraSettings);
    }

    void whatIsWantedIsReplaced()
    {
        const std::string uri = "aravis:192.168.1.20?rate=60&gain=6";
        QCOMPARE(withoutSettings(uri), std::string("aravis:192.168.1.20"));
        QCOMPARE(withSettings(uri, {}), std::string("aravis:192.168.1.20"));
        QCOMPARE(withSettings(uri, {{"rate=30", "rate", "30"}, {"trigger=software", "trigger", "software"}}),
                 std::string("aravis:192.168.1.20?rate=30&trigger=software"));
        QCOMPARE(withoutSettings("sim:A?board"), std::string("sim:A?board")); // that is no wish
        QCOMPARE(withoutSettings("file:/videos/why?.mp4"), std::string("file:/videos/why?.mp4"));
        QVERIFY(!acceptsSettings("sim:A"));
    }

    void withoutASignItHasNoName()
    {
        const CameraUri uri = splitCameraUri("x:a?rate", "x:");
        QCOMPARE(uri.cameraSettings.front().text, std::string("rate"));
        QVERIFY(uri.cameraSettings.front().name.empty());
    }
};

ODOGRAPH_TEST(TestCameraUri, QCoreApplication)
#include "tst_camera_uri.moc"
