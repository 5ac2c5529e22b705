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
        QCOMPARE(uri.place, std::string("/dev/video0"));
        QCOMPARE(uri.wishes.size(), std::size_t(2));
        QCOMPARE(uri.wishes[0].name, std::string("size"));
        QCOMPARE(uri.wishes[0].value, std::string("640x480"));
        QCOMPARE(uri.wishes[1].text, std::string("rate=30"));
    }

    void whatSaysLittle_data()
    {
        QTest::addColumn<QByteArray>("uri");
        QTest::addColumn<QByteArray>("place");
        QTest::addColumn<QByteArrayList>("wishes");
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
        QFETCH(QByteArray, place);
        QFETCH(QByteArrayList, wishes);
        const CameraUri split = splitCameraUri(uri.toStdString(), "x:");
        QCOMPARE(split.place, place.toStdString());
        QByteArrayList texts;
        for (const CameraWish &wish : split.wishes)
            texts << QByteArray::fromStdString(wish.text);
        QCOMPARE(texts, wishes);
    }

    void whatIsWantedIsReplaced()
    {
        const std::string uri = "aravis:192.168.1.20?rate=60&gain=6";
        QCOMPARE(withoutWishes(uri), std::string("aravis:192.168.1.20"));
        QCOMPARE(withWishes(uri, {}), std::string("aravis:192.168.1.20"));
        QCOMPARE(withWishes(uri, {{"rate=30", "rate", "30"}, {"trigger=software", "trigger", "software"}}),
                 std::string("aravis:192.168.1.20?rate=30&trigger=software"));
        QCOMPARE(withoutWishes("sim:A?board"), std::string("sim:A?board")); // that is no wish
        QCOMPARE(withoutWishes("file:/videos/why?.mp4"), std::string("file:/videos/why?.mp4"));
        QVERIFY(!takesWishes("sim:A"));
    }

    void withoutASignItHasNoName()
    {
        const CameraUri uri = splitCameraUri("x:a?rate", "x:");
        QCOMPARE(uri.wishes.front().text, std::string("rate"));
        QVERIFY(uri.wishes.front().name.empty());
    }
};

ODOGRAPH_TEST(TestCameraUri, QCoreApplication)
#include "tst_camera_uri.moc"
