// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_detection.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>

using namespace odo;

class TestTagDetection : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void longSides_data();
    void longSides();
};

void TestTagDetection::longSides_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("twice as wide as can be counted when enlarged") << 32000 << 64;
    QTest::newRow("just too tall when enlarged") << 64 << 16384;
    QTest::newRow("too wide") << 32768 << 64;
    QTest::newRow("too tall") << 64 << 64259;
}

/// libapriltag ends the program where it cannot count a side; there are no tags in such a picture.
void TestTagDetection::longSides()
{
    QFETCH(int, width);
    QFETCH(int, height);
    FrameFormat format;
    format.width = width;
    format.height = height;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < height; ++y)
        std::fill_n(buffer->yRow(y), width, std::uint8_t(128));
    const Frame frame = FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
    QVERIFY(findTags(frame).empty());
    QVERIFY(findSmallTags(frame).empty());
}

ODOGRAPH_TEST(TestTagDetection, QCoreApplication)
#include "tst_tag_detection.moc"
