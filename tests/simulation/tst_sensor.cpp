// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/sensor.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>

using namespace odo;

namespace {

constexpr int width = 320, height = 240;

RgbImage flat(const Rgb &colour)
{
    RgbImage image({0, 0, width, height});
    for (int y = 0; y < height; ++y)
        std::fill_n(image.row(y), width, colour);
    return image;
}

Frame shot(const SensorModel &model, const RgbImage &image, std::uint64_t number = 0, double gain = 1.0)
{
    Sensor sensor(model, width, height, 77);
    sensor.take(image);
    return FrameBuffer::toFrame(sensor.read(gain, number), 0, Nanoseconds{0});
}

SensorModel model(double noiseSigma, ChromaSiting siting = ChromaSiting::Left)
{
    SensorModel result;
    result.noiseSigma = noiseSigma;
    result.siting = siting;
    return result;
}

struct Spread
{
    double mean = 0, sigma = 0, alongRow = 0; ///< alongRow: correlation of neighbours
};

Spread spreadOf(const PlaneView &plane)
{
    double sum = 0, squares = 0, products = 0;
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            sum += plane.at(x, y);
    const double count = static_cast<double>(plane.width) * plane.height, mean = sum / count;
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            const double d = plane.at(x, y) - mean;
            squares += d * d;
            if (x > 0)
                products += d * (plane.at(x - 1, y) - mean);
        }
    }
    return {mean, std::sqrt(squares / count), products / squares};
}

} // namespace

class TestSensor : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void coloursAreThoseOfBt601_data()
    {
        QTest::addColumn<QList<int>>("rgb");
        QTest::addColumn<QList<int>>("yuv");
        // The 100 % colour bars' values in every table of BT.601.
        QTest::newRow("white") << QList{255, 255, 255} << QList{235, 128, 128};
        QTest::newRow("black") << QList{0, 0, 0} << QList{16, 128, 128};
        QTest::newRow("red") << QList{255, 0, 0} << QList{81, 90, 240};
        QTest::newRow("green") << QList{0, 255, 0} << QList{145, 54, 34};
        QTest::newRow("blue") << QList{0, 0, 255} << QList{41, 240, 110};
    }
    void coloursAreThoseOfBt601()
    {
        QFETCH(QList<int>, rgb);
        QFETCH(QList<int>, yuv);
        const Rgb colour(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]),
                         0.f);
        const Frame frame = shot(model(0), flat(colour));
        QCOMPARE(int(frame.y.at(100, 100)), yuv[0]);
        QCOMPARE(int(frame.u.at(0, 0)), yuv[1]);
        QCOMPARE(int(frame.v.at(159, 119)), yuv[2]);
        QVERIFY(!frame.format.fullRange && frame.format.matrix == YuvMatrix::Bt601);
    }

    void noiseIsAsStated_data()
    {
        QTest::addColumn<ChromaSiting>("siting");
        QTest::addColumn<double>("chromaShare");
        QTest::addColumn<double>("chromaCorrelation");
        // √(Σw²) of the filters [1 2 1]/4 and [1 1]/2, and what two neighbours on a row share of it.
        QTest::newRow("left") << ChromaSiting::Left << std::sqrt(6.0 / 16 / 2) << 1.0 / 6;
        QTest::newRow("centre") << ChromaSiting::Center << 0.5 << 0.0;
        QTest::newRow("top left") << ChromaSiting::TopLeft << 6.0 / 16 << 1.0 / 6;
    }
    void noiseIsAsStated()
    {
        QFETCH(ChromaSiting, siting);
        QFETCH(double, chromaShare);
        QFETCH(double, chromaCorrelation);
        const double sigma = 4.0, rounding = 1.0 / 12;
        const Frame frame = shot(model(sigma, siting), flat({120, 130, 110, 0}));
        const Spread luma = spreadOf(frame.y), u = spreadOf(frame.u), v = spreadOf(frame.v);
        // 76800 luma and 19200 chroma samples: the sigma is known to 0.26 % and 0.5 % (one sigma),
        // correlation to 0.7 %.
        QVERIFY(std::abs(luma.sigma / std::sqrt(sigma * sigma + rounding) - 1) < 0.01);
        QVERIFY(std::abs(luma.alongRow) < 0.02);
        const double chromaSigma = std::sqrt(sigma * sigma * chromaShare * chromaShare + rounding);
        QVERIFY(std::abs(u.sigma / chromaSigma - 1) < 0.025 && std::abs(v.sigma / chromaSigma - 1) < 0.025);
        const double unrounded = sigma * sigma * chromaShare * chromaShare / (chromaSigma * chromaSigma);
        QVERIFY(std::abs(u.alongRow - chromaCorrelation * unrounded) < 0.035);
        const Spread clean = spreadOf(shot(model(0, siting), flat({120, 130, 110, 0})).y);
        QVERIFY(std::abs(luma.mean - clean.mean) < 0.5 + 0.06);
    }

    void noiseDiffersFromPictureToPictureOnly()
    {
        const RgbImage grey = flat({120, 120, 120, 0});
        const Frame first = shot(model(2), grey, 5), again = shot(model(2), grey, 5),
                    next = shot(model(2), grey, 6);
        int equal = 0, same = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                equal += first.y.at(x, y) == again.y.at(x, y);
                same += first.y.at(x, y) == next.y.at(x, y);
            }
        }
        QCOMPARE(equal, width * height);
        // Two independent values of sigma 2 agree in 1/(2·2·√π) = 14 % of the pixels.
        QVERIFY(std::abs(static_cast<double>(same) / (width * height) - 0.14) < 0.02);
    }

    void sitingMovesTheChromaSamples()
    {
        // A red stripe from column 101 to 140, rows 60 to 90: its chroma centroid in samples tells where they
        // lie.
        RgbImage image = flat({128, 128, 128, 0});
        for (int y = 60; y <= 90; ++y)
            std::fill_n(image.row(y) + 101, 40, Rgb(200, 40, 40, 0));
        const auto centroid = [&](ChromaSiting siting) {
            const Frame frame = shot(model(0, siting), image);
            Eigen::Vector2d moment = Eigen::Vector2d::Zero();
            double weight = 0;
            for (int y = 0; y < frame.v.height; ++y) {
                for (int x = 0; x < frame.v.width; ++x) {
                    weight += frame.v.at(x, y) - 128;
                    moment += (frame.v.at(x, y) - 128) * Eigen::Vector2d(x, y);
                }
            }
            return Eigen::Vector2d(moment / weight);
        };
        const Eigen::Vector2d left = centroid(ChromaSiting::Left), centre = centroid(ChromaSiting::Center),
                              topLeft = centroid(ChromaSiting::TopLeft);
        // Luma x = 2 cx + offset: a quarter sample is half a luma pixel. Rounding to 8 bits costs up to 0.01.
        QVERIFY(std::abs(left.x() - 120.5 / 2) < 0.01);
        QVERIFY(std::abs(centre.x() - (120.5 - 0.5) / 2) < 0.01);
        QVERIFY(std::abs(left.x() - centre.x() - 0.25) < 0.01);
        QVERIFY(std::abs(left.y() - (75 - 0.5) / 2) < 0.01 && std::abs(centre.y() - left.y()) < 0.01);
        QVERIFY(std::abs(topLeft.x() - left.x()) < 0.01 && std::abs(topLeft.y() - 75.0 / 2) < 0.01);
    }

    void gainScalesLightAboutBlack()
    {
        const Frame frame = shot(model(0), flat({150, 100, 100, 0}), 0, 1.1);
        const double luma = 16 + 1.1 * 219.0 / 255 * (0.299 * 150 + 0.701 * 100);
        QVERIFY(std::abs(frame.y.at(9, 9) - luma) < 0.6);
        const double red = 128 + 1.1 * 224.0 / 255 * 0.5 * (1 - 0.299) / 0.701 * 50;
        QVERIFY(std::abs(frame.v.at(9, 9) - red) < 0.6);
    }

    void aPartCanBeReplacedAndRestored()
    {
        const RgbImage still = flat({90, 120, 150, 0});
        Sensor sensor(model(0), width, height, 1);
        sensor.take(still);
        sensor.keepStill();
        RgbImage part = still.part({40, 60, 80, 100});
        for (int y = 70; y < 90; ++y)
            std::fill_n(part.row(y) + 10, 20, Rgb(220, 20, 20, 0));
        RgbImage whole = still;
        for (int y = 70; y < 90; ++y)
            std::fill_n(whole.row(y) + 50, 20, Rgb(220, 20, 20, 0));
        sensor.take(part);
        const auto sameAs = [&](const Frame &expected) {
            const Frame frame = FrameBuffer::toFrame(sensor.read(1.0, 0), 0, Nanoseconds{0});
            return std::equal(frame.y.data, frame.y.data + width * height, expected.y.data) &&
                   std::equal(frame.u.data, frame.u.data + width * height / 4, expected.u.data) &&
                   std::equal(frame.v.data, frame.v.data + width * height / 4, expected.v.data);
        };
        QVERIFY(sameAs(shot(model(0), whole)));
        sensor.restore({40, 60, 80, 100});
        QVERIFY(sameAs(shot(model(0), still)));
    }
};

ODOGRAPH_TEST(TestSensor, QCoreApplication)
#include "tst_sensor.moc"
