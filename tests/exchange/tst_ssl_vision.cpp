// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/ssl_vision.h"
#include "tests/support/protobuf_decoder.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

/// The packets by the field numbers of messages_robocup_ssl_detection.proto and
/// messages_robocup_ssl_wrapper.proto: wrapper: detection 1; frame: frame_number 1, t_capture 2, t_sent 3,
/// camera_id 4, balls 5, robots_yellow 6, robots_blue 7; robot: confidence 1, robot_id 2, x 3, y 4,
/// orientation 5, pixel_x 6, pixel_y 7, height 8.
class TestSslVision : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void fieldsAreThePublishedOnes()
    {
        SslFrame frame{300, 1732300000.25, 1732300000.28125, 2, {}};
        frame.robots.push_back({false, 11, 0.5, -0.25, 1.5, -3.0, {}});
        frame.robots.push_back({true, 0, 1, 0.125, -2, {}, 0.06});
        const auto packet = decodeMessage(sslVisionPacket(frame));
        QVERIFY(packet && packet->fields.size() == 1 && packet->first(1) && packet->first(1)->wireType == 2);
        const auto detection = decodeMessage(packet->first(1)->bytes);
        QVERIFY(detection && detection->fields.size() == 6);
        QCOMPARE(detection->first(1)->bits, quint64(300));
        QCOMPARE(detection->first(2)->real(), 1732300000.25);
        QCOMPARE(detection->first(3)->real(), 1732300000.28125);
        QCOMPARE(detection->first(4)->bits, quint64(2));
        const auto yellow = decodeMessage(detection->first(6)->bytes),
                   blue = decodeMessage(detection->first(7)->bytes);
        QVERIFY(yellow && blue);
        QCOMPARE(blue->first(1)->shortReal(), 0.5f);
        QCOMPARE(blue->first(2)->bits, quint64(11));
        QCOMPARE(blue->first(3)->shortReal(), -250.0f); // millimetres
        QCOMPARE(blue->first(4)->shortReal(), 1500.0f);
        QCOMPARE(blue->first(5)->shortReal(), -3.0f);
        QVERIFY(!blue->first(8));
        QVERIFY(!yellow->first(5)); // it has never moved
        QCOMPARE(yellow->first(8)->shortReal(), 60.0f);
        // required, but of no meaning where a place comes of several views
        for (const auto &robot : {*yellow, *blue}) {
            QVERIFY(robot.first(6) && robot.first(6)->wireType == 5 && robot.first(6)->shortReal() == 0);
            QVERIFY(robot.first(7) && robot.first(7)->wireType == 5 && robot.first(7)->shortReal() == 0);
        }
    }
    void aFrameWithoutRobotsIsWhole()
    {
        const auto detection = decodeMessage(decodeMessage(sslVisionPacket({}))->first(1)->bytes);
        QVERIFY(detection && detection->fields.size() == 4);
        QCOMPARE(sslVisionPacket({}),
                 std::string("\x0a\x16\x08\0\x11\0\0\0\0\0\0\0\0\x19\0\0\0\0\0\0\0\0\x20\0", 24));
    }
    void largeNumbers()
    {
        SslFrame frame;
        frame.number = 0xffffffff;
        QCOMPARE(decodeMessage(decodeMessage(sslVisionPacket(frame))->first(1)->bytes)->first(1)->bits,
                 quint64(0xffffffff));
    }
};

ODOGRAPH_TEST(TestSslVision, QCoreApplication)
#include "tst_ssl_vision.moc"
