// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_source.h"
#include "core/capture/v4l2/v4l2_address.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cerrno>
#include <linux/videodev2.h>

using namespace odo;

class TestV4l2Address : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void allPartsAreRead()
    {
        const auto address = parseV4l2Address("v4l2:/dev/video2?size=1280x720&rate=29.97&format=MJPG");
        QVERIFY(address);
        QCOMPARE(address->location, std::string("/dev/video2"));
        QCOMPARE(address->request.widthPx, std::optional(1280));
        QCOMPARE(address->request.heightPx, std::optional(720));
        QCOMPARE(address->request.framesPerSecond, std::optional(29.97));
        QCOMPARE(address->request.format, std::optional<std::uint32_t>(V4L2_PIX_FMT_MJPEG));
    }

    void whatIsLeftOutIsLeftOpen()
    {
        const auto address = parseV4l2Address("v4l2:usb-0000:00:14.0-1");
        QVERIFY(address);
        QCOMPARE(address->location, std::string("usb-0000:00:14.0-1"));
        QVERIFY(!address->request.widthPx && !address->request.framesPerSecond && !address->request.format);
        QCOMPARE(parseV4l2Address("v4l2:/dev/video0?format=Y16")->request.format,
                 std::optional<std::uint32_t>(V4L2_PIX_FMT_Y16));
    }

    void nonsenseIsRefused_data()
    {
        QTest::addColumn<QByteArray>("uri");
        for (const char *uri :
             {"v4l2:", "v4l2:?rate=30", "v4l2:/dev/video0?speed=3", "v4l2:/dev/video0?rate",
              "v4l2:/dev/video0?rate=0", "v4l2:/dev/video0?rate=-5", "v4l2:/dev/video0?rate=nan",
              "v4l2:/dev/video0?rate=30x", "v4l2:/dev/video0?rate=inf", "v4l2:/dev/video0?size=640",
              "v4l2:/dev/video0?size=x480", "v4l2:/dev/video0?size=640x-1",
              "v4l2:/dev/video0?size=99999999999x1",
              "v4l2:/dev/video0?format=", "v4l2:/dev/video0?format=MJPEG", "v4l2:/dev/video0?&"})
            QTest::newRow(uri) << QByteArray(uri);
    }

    void nonsenseIsRefused()
    {
        QFETCH(QByteArray, uri);
        const auto address = parseV4l2Address(uri.toStdString());
        QVERIFY(!address);
        QCOMPARE(address.error().code, ErrorCode::InvalidInput);
        QVERIFY(address.error().message().find("is not valid; write it like v4l2:/dev/video0") !=
                std::string::npos);
    }

    void aCameraThatIsNotThereIsNotFound()
    {
        for (const char *uri : {"v4l2:/dev/video-none", "v4l2:usb-nowhere"}) {
            const auto source = openCamera(uri);
            QVERIFY(!source);
            QCOMPARE(source.error().code, ErrorCode::NotFound);
            QVERIFY(source.error().message().find(
                        "it is not connected; plug it in, or choose a camera that odograph cameras lists") !=
                    std::string::npos);
        }
        // A file that is no camera.
        const auto source = openCamera("v4l2:/dev/null");
        QCOMPARE(source.error().code, ErrorCode::InvalidInput);
        QVERIFY(source.error().message().find("/dev/null sends no frames") != std::string::npos);
    }

    void everyCauseHasItsOwnWords()
    {
        const auto message = [](int number) {
            return QString::fromStdString(v4l2Failure("v4l2:/dev/video0", number).message());
        };
        QVERIFY(message(EBUSY).endsWith(QStringLiteral("another program uses it; close that program")));
        QVERIFY(message(EACCES).contains(QStringLiteral("join the group video")));
        QVERIFY(message(ENODEV).endsWith(QStringLiteral("it was unplugged; plug it in again")));
        QVERIFY(message(ENOSPC).contains(QStringLiteral("USB bus has no bandwidth")));
        QVERIFY(message(ENOSPC).contains(QStringLiteral("MJPG")));
        QVERIFY(message(EIO).contains(QStringLiteral("Input/output error")));
        QCOMPARE(v4l2Failure("x", EBUSY).code, ErrorCode::Unavailable);
        QCOMPARE(v4l2Failure("x", EACCES).code, ErrorCode::Io);
    }
};

ODOGRAPH_TEST(TestV4l2Address, QCoreApplication)
#include "tst_v4l2_address.moc"
