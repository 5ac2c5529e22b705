// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/planes/camera_planes.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

namespace {

std::uint8_t lumaAt(int x, int y)
{
    return static_cast<std::uint8_t>(16 + (7 * x + 13 * y) % 220);
}
std::uint8_t uAt(int x, int y)
{
    return static_cast<std::uint8_t>(16 + (5 * x + 3 * y) % 200);
}
std::uint8_t vAt(int x, int y)
{
    return static_cast<std::uint8_t>(240 - (2 * x + 11 * y) % 200);
}

/// Packed as the V4L2 interface describes the layouts, with some bytes between the rows.
std::vector<std::uint8_t> packed(const PackedFormat &format)
{
    const bool planar = format.layout == PackedLayout::Nv12;
    const int rows = planar ? format.height + (format.height + 1) / 2 : format.height;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(format.stride) * static_cast<std::size_t>(rows),
                                    77);
    const int lumaFirst = format.layout == PackedLayout::Yuyv ? 0 : 1;
    for (int y = 0; y < rows; ++y) {
        std::uint8_t *row = bytes.data() + y * format.stride;
        for (int x = 0; planar && y < format.height && x < format.width; ++x)
            row[x] = lumaAt(x, y);
        for (int c = 0; planar && y >= format.height && c < (format.width + 1) / 2; ++c) {
            row[2 * c] = uAt(c, y - format.height);
            row[2 * c + 1] = vAt(c, y - format.height);
        }
        for (int x = 0; !planar && x < format.width; ++x) {
            row[2 * x + lumaFirst] = lumaAt(x, y);
            row[2 * x + 1 - lumaFirst] = x % 2 == 0 ? uAt(x / 2, y) : vAt(x / 2, y);
        }
    }
    return bytes;
}

} // namespace

class TestPackedPlanes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void samplesComeToTheirPlaces_data()
    {
        QTest::addColumn<int>("layout");
        QTest::addColumn<int>("shiftY");
        QTest::newRow("YUYV") << int(PackedLayout::Yuyv) << 0;
        QTest::newRow("UYVY") << int(PackedLayout::Uyvy) << 0;
        QTest::newRow("NV12") << int(PackedLayout::Nv12) << 1;
    }

    void samplesComeToTheirPlaces()
    {
        QFETCH(int, layout);
        QFETCH(int, shiftY);
        const PackedFormat format{PackedLayout(layout), 70, 38, 150, YuvMatrix::Bt709, true};
        const auto frame = PackedPlanes(format).toPlanes(packed(format));
        QVERIFY(frame);
        QCOMPARE(frame->format.chromaShiftX, 1);
        QCOMPARE(frame->format.chromaShiftY, shiftY);
        QCOMPARE(frame->format.siting, ChromaSiting::Center);
        QCOMPARE(frame->format.matrix, YuvMatrix::Bt709);
        QVERIFY(frame->format.fullRange);
        for (int y = 0; y < 38; ++y)
            for (int x = 0; x < 70; ++x)
                QCOMPARE(frame->y.at(x, y), lumaAt(x, y));
        QCOMPARE(frame->u.height, shiftY == 1 ? 19 : 38);
        for (int y = 0; y < frame->u.height; ++y) {
            for (int x = 0; x < frame->u.width; ++x) {
                QCOMPARE(frame->u.at(x, y), uAt(x, y));
                QCOMPARE(frame->v.at(x, y), vAt(x, y));
            }
        }
    }

    void aPictureThatIsCutOffIsNone()
    {
        const PackedFormat format{PackedLayout::Nv12, 64, 32, 64};
        std::vector<std::uint8_t> bytes = packed(format);
        const PackedPlanes planes(format);
        QVERIFY(planes.toPlanes(bytes));
        bytes.pop_back();
        QVERIFY(!planes.toPlanes(bytes));
        QVERIFY(!planes.toPlanes({}));
    }

    void framesDoNotShareTheirMemory()
    {
        const PackedFormat format{PackedLayout::Yuyv, 64, 32, 128};
        std::vector<std::uint8_t> bytes = packed(format);
        const PackedPlanes planes(format);
        const auto first = planes.toPlanes(bytes);
        bytes[0] = 200;
        const auto second = planes.toPlanes(bytes);
        QCOMPARE(first->y.at(0, 0), lumaAt(0, 0));
        QCOMPARE(int(second->y.at(0, 0)), 200);
    }
};

ODOGRAPH_TEST(TestPackedPlanes, QCoreApplication)
#include "tst_packed_planes.moc"
