// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/planes/field_motion.h"
#include "tests/support/registered_test.h"
#include "tests/video/moving_square.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

FieldMotion::Kind kindOf(const std::vector<Frame> &frames, const std::optional<PixelRect> &region = {})
{
    FieldMotion motion;
    for (const Frame &frame : frames)
        motion.add(frame, region);
    return motion.kind();
}

} // namespace

class TestFieldMotion : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void findsWhichFieldIsFirst()
    {
        QVERIFY(kindOf(movingSquare(FieldOrder::OneMoment, 20)) == FieldMotion::Kind::Progressive);
        QVERIFY(kindOf(movingSquare(FieldOrder::TopFirst, 20)) == FieldMotion::Kind::TopFirst);
        QVERIFY(kindOf(movingSquare(FieldOrder::BottomFirst, 20)) == FieldMotion::Kind::BottomFirst);
    }

    void looksOnlyWhereItIsTold()
    {
        const auto frames = movingSquare(FieldOrder::TopFirst, 20);
        QVERIFY(kindOf(frames, PixelRect{-5, 9, 300, 87}) == FieldMotion::Kind::TopFirst);
        QVERIFY(kindOf(frames, PixelRect{0, 84, 256, 96}) == FieldMotion::Kind::Unknown);
        QVERIFY(kindOf(frames, PixelRect{}) == FieldMotion::Kind::Unknown);
    }

    void whatStandsStillSaysNothing()
    {
        std::vector<Frame> frames(20, movingSquare(FieldOrder::TopFirst, 3).back());
        for (std::size_t i = 0; i < frames.size(); ++i)
            frames[i].index = std::int64_t(i);
        QVERIFY(kindOf(frames) == FieldMotion::Kind::Unknown);
        QVERIFY(kindOf({}) == FieldMotion::Kind::Unknown);
    }

    void framesApartAreNotCompared()
    {
        auto frames = movingSquare(FieldOrder::TopFirst, 20);
        for (std::size_t i = 0; i < frames.size(); ++i)
            frames[i].index = std::int64_t(3 * i);
        QVERIFY(kindOf(frames) == FieldMotion::Kind::Unknown);
    }
};

ODOGRAPH_TEST(TestFieldMotion, QCoreApplication)
#include "tst_field_motion.moc"
