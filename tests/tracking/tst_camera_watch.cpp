// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/camera_watch.h"

#include "tests/support/registered_test.h"
#include "tests/tracking/painter.h"

#include <QTest>

using namespace odo;

namespace {

const FrameFormat format = testFormat(320, 240);
constexpr double framesPerSecond = 5;

/// Tiles of many shades, seen by a camera that is turned by a shift of the image.
Painter floorSeen(const Eigen::Vector2d &shiftPx, int tiles = 400)
{
    Painter floor(format);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-60, 380), y(-60, 300), size(8, 40), shade(40, 210);
    for (int i = 0; i < tiles; ++i) {
        const Eigen::Vector2d low = Eigen::Vector2d(x(random), y(random)) + shiftPx;
        const Eigen::Vector2d high = low + Eigen::Vector2d(size(random), size(random));
        const auto code = static_cast<std::uint8_t>(shade(random));
        floor.rectangle(low, high, {code, code, code});
    }
    return floor;
}

Frame framed(const Painter &painter)
{
    static std::mt19937 noise(3);
    return painter.frame(0, 0, 2, noise);
}

/// What is found in six seconds of frames; seen: each at its time.
std::optional<CameraMove> foundIn(const std::function<Frame(double timeS)> &seen)
{
    CameraWatch watch;
    for (int i = 0; i < int(6 * framesPerSecond); ++i) {
        Frame frame = seen(i / framesPerSecond);
        frame.index = i;
        frame.time = fromSeconds(i / framesPerSecond);
        watch.add(frame);
    }
    return watch.move();
}

} // namespace

class TestCameraWatch : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aMoveIsDatedAndMeasured_data()
    {
        QTest::addColumn<double>("shiftPx");
        for (const double shiftPx : {1.0, 3.5, 20.0, 35.0})
            QTest::addRow("%.1f px", shiftPx) << shiftPx;
    }
    void aMoveIsDatedAndMeasured()
    {
        QFETCH(const double, shiftPx);
        const Frame before = framed(floorSeen({0, 0})),
                    behind = framed(floorSeen({shiftPx * 0.6, -shiftPx * 0.8}));
        const auto move = foundIn([&](double timeS) { return timeS < 3 ? before : behind; });
        QVERIFY(move);
        QVERIFY2(std::abs(move->shiftPx - shiftPx) < 0.15, qPrintable(QString::number(move->shiftPx)));
        QVERIFY(move->time < std::chrono::seconds(3) && move->time >= std::chrono::milliseconds(2500));
    }

    /// Noise, another light, somebody who walks by, and a knock at the table that is over at once.
    void otherThingsAreNone()
    {
        const Painter floor = floorSeen({0, 0}), shaken = floorSeen({4, 0});
        QVERIFY(!foundIn([&](double timeS) {
            Painter seen = timeS > 3 && timeS < 3.4 ? shaken : floor;
            if (timeS > 2)
                seen.light(0.7);
            seen.rectangle({60 * timeS, 40}, {60 * timeS + 60, 200}, {90, 60, 50});
            return framed(seen);
        }));
    }

    void withoutTextureNothingIsSaid()
    {
        const Frame before = framed(floorSeen({0, 0}, 0)), behind = framed(floorSeen({5, 0}, 0));
        QVERIFY(!foundIn([&](double timeS) { return timeS < 3 ? before : behind; }));
        QVERIFY(!CameraWatch().move());
    }
};

ODOGRAPH_TEST(TestCameraWatch, QCoreApplication)
#include "tst_camera_watch.moc"
