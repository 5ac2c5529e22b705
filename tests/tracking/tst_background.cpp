// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tracking/textured_floor.h"

#include "core/tracking/background.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

const FrameFormat format = testFormat(320, 240);

/// A robot that stands until second `fromS`, then drives to the right.
Frame filmed(const Painter &floor, std::int64_t index, double standsUntilS, double noise,
             std::mt19937 &random, double light = 1)
{
    Painter image = floor;
    const double timeS = double(index) / 10;
    const double x = 60 + 40 * std::max(0.0, timeS - standsUntilS);
    image.rectangle({x, 90}, {x + 40, 125}, {40, 40, 160});
    image.light(light);
    return image.frame(index, timeS, noise, random);
}

/// RMS difference of luma from the floor without the robot.
double wrongBy(const Background &background, const Painter &floor, const PixelRect &rect, double light = 1)
{
    std::mt19937 random(0);
    Painter lit = floor;
    lit.light(light);
    const Frame truth = lit.frame(0, 0, 0, random);
    double squares = 0, count = 0;
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x) {
            const double difference = double(background.y.row(y)[x]) - truth.y.at(x, y);
            squares += difference * difference;
            count += 1;
        }
    return std::sqrt(squares / count);
}

} // namespace

class TestBackground : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aRobotThatStandsForLongIsNoFloor()
    {
        const Painter floor = texturedFloor(format);
        std::mt19937 random(1);
        BackgroundLearner learner;
        for (std::int64_t i = 0; i < 300; ++i) // stands for 25 s of 30
            learner.add(filmed(floor, i, 25, 2, random));
        const auto background = learner.learned();
        QVERIFY(background.has_value());
        // The median of a dozen or more samples with a noise of 2 is off by some 0.6, and by 0.3 for whole
        // code values.
        QVERIFY2(wrongBy(*background, floor, {60, 90, 100, 125}) < 1.2,
                 qPrintable(QString::number(wrongBy(*background, floor, {60, 90, 100, 125}))));
        QVERIFY(wrongBy(*background, floor, {0, 0, 320, 240}) < 1.2);
        double sigmas = 0;
        for (const std::uint8_t sigma : background->y.sigmas)
            sigmas += sigma * double(Background::sigmaUnit) / double(background->y.sigmas.size());
        QVERIFY2(sigmas > 1.2 && sigmas < 3, qPrintable(QString::number(sigmas)));
    }

    void lightThatChangesIsTakenOut()
    {
        const Painter floor = texturedFloor(format);
        std::mt19937 random(2);
        BackgroundLearner learner;
        for (std::int64_t i = 0; i < 60; ++i)
            learner.add(filmed(floor, i, 0, 1, random, 0.8 + 0.005 * double(i)));
        // In the light of the first frame that is kept, so against the floor up to one factor.
        const auto background = learner.learned();
        std::mt19937 still(0);
        const Frame bare = floor.frame(0, 0, 0, still);
        const auto &y = background->y;
        const LightGain gain =
            LightGain::between({y.values.data(), y.width, y.height, y.width}, bare.y, false);
        QVERIFY2(gain.factor > 0.78F && gain.factor < 0.9F, qPrintable(QString::number(double(gain.factor))));
        QVERIFY(wrongBy(*background, floor, {0, 0, 320, 240}, double(gain.factor)) < 1.5);
    }

    void withoutFramesThereIsNone() { QVERIFY(!BackgroundLearner().learned()); }

    void whereNothingMovesItIsTheFrame()
    {
        const Painter floor = texturedFloor(format);
        std::mt19937 random(3);
        BackgroundLearner learner;
        for (std::int64_t i = 0; i < 20; ++i)
            learner.add(floor.frame(i, double(i) / 10, 2, random));
        QCOMPARE(learner.movingFrames(), std::int64_t(0));
        QVERIFY(learner.learned() && wrongBy(*learner.learned(), floor, {0, 0, 320, 240}) < 2.5);
    }

    void theGainOfLightIsMeasured()
    {
        const Painter floor = texturedFloor(format);
        std::mt19937 random(4);
        for (const double light : {0.5, 0.9, 1.3}) {
            Painter lit = floor;
            lit.light(light);
            lit.rectangle({0, 0}, {100, 100}, {250, 250, 250}); // that only one of them shows
            const float factor =
                LightGain::between(lit.frame(0, 0, 1, random).y, floor.frame(0, 0, 1, random).y, false)
                    .factor;
            QVERIFY2(std::abs(double(factor) / light - 1) < 0.03,
                     qPrintable(QString::number(double(factor))));
        }
    }

    void aRunningCameraLearnsAgainAndAgain()
    {
        const Painter floor = texturedFloor(format);
        std::mt19937 random(5);
        LiveBackground live;
        std::optional<Background> newest;
        int learned = 0;
        for (std::int64_t i = 0; i < 90; ++i)
            if (auto background = live.add(filmed(floor, i, 1, 2, random))) {
                newest = std::move(background);
                ++learned;
            }
        QVERIFY(learned >= 2 && learned < 20);
        QVERIFY(wrongBy(*newest, floor, {60, 90, 100, 125}) < 1.5);
    }
};

ODOGRAPH_TEST(TestBackground, QCoreApplication)
#include "tst_background.moc"
