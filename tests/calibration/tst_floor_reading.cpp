// SPDX-License-Identifier: GPL-3.0-or-later
// Floor positions of single pixels: their σ against the truth, over many drawn cameras.
#include "core/calibration/floor_reading.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/simulation/demo_testbed.h"
#include "tests/calibration/seen_boards.h"
#include "tests/calibration/true_lens.h"
#include "tests/support/registered_test.h"

#include <Eigen/LU>
#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using Eigen::Vector2d;

namespace {

constexpr double floorX = 3, floorY = 2.2;

MarkerLayout layoutOf(int markers)
{
    MarkerLayout layout{"floor",
                        {{"O", {0, 0}}, {"U", {floorX, 0}}, {"V", {0, floorY}}, {"D", {floorX, floorY}}}};
    const Vector2d more[] = {{1.4, 0.9}, {0.7, 1.8}, {2.4, 0.4}, {1.6, 2.1}};
    for (int i = 4; i < markers; ++i)
        layout.markers.push_back({"M" + std::to_string(i), more[i - 4]});
    return layout;
}

/// A camera before the floor with a lens, at one of many positions.
FloorView drawnView(const Intrinsics &lens, std::mt19937 &random)
{
    std::uniform_real_distribution<double> share(0, 1);
    const double direction = 2 * EIGEN_PI * share(random), away = 2.6 + 1.2 * share(random);
    const Eigen::Vector3d position(0.5 * floorX + away * std::cos(direction),
                                   0.5 * floorY + away * std::sin(direction), 1.6 + 1.2 * share(random));
    const FloorView aimed =
        simulatedView(position, {0.5 * floorX, 0.5 * floorY, 0}, lens.widthPx, lens.heightPx, lens.fxPx);
    return FloorView(CameraModel::create(lens).value(), aimed.worldFromCamera(), aimed.poseCovariance());
}

struct Coverage
{
    int points = 0, within = 0, draws = 0;
    double squares = 0; ///< of distances over σ, per coordinate

    double part() const { return double(within) / points; }
    double rms() const { return std::sqrt(squares / (2 * points)); }
};

/// Points all over the floor read by `reading`, against the truth: a pixel of noise on each.
void readAll(const FloorReading &reading, const FloorView &truth, double noisePx, double heightM,
             std::mt19937 &random, Coverage &coverage)
{
    std::normal_distribution<double> normal(0, 1);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < 12; ++i) {
        const Vector2d point(floorX * share(random), floorY * share(random));
        const auto pixel = truth.pixelFromWorld({point.x(), point.y(), heightM});
        if (!pixel)
            continue;
        const auto read = reading.at(*pixel + noisePx * Vector2d(normal(random), normal(random)), heightM);
        if (!read)
            continue;
        const Vector2d off = read->pointInWorld - point;
        const double mahalanobis = off.dot(read->covariance.inverse() * off);
        ++coverage.points;
        coverage.within += mahalanobis < 5.991 ? 1 : 0; // 95 % of χ² of two degrees of freedom
        coverage.squares += mahalanobis;
    }
    ++coverage.draws;
}

std::vector<MarkerPixel> markedPixels(const FloorView &view, const MarkerLayout &layout, double noisePx,
                                      std::mt19937 &random)
{
    std::normal_distribution<double> normal(0, 1);
    std::vector<MarkerPixel> pixels;
    for (const Marker &marker : layout.markers) {
        const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
        if (pixel)
            pixels.push_back({marker.label, *pixel + noisePx * Vector2d(normal(random), normal(random))});
    }
    return pixels;
}

} // namespace

class TestFloorReading : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// The lens calibrated from boards, its covariance carried: 95 % within, less what 480 points leave to
    /// chance (points of one draw share an error, so each draw counts as three or so), and not twice too
    /// wide.
    void sigmaHoldsWithACalibratedLens_data()
    {
        QTest::addColumn<int>("markers");
        QTest::addColumn<double>("heightM");
        QTest::newRow("four markers") << 4 << 0.0;
        QTest::newRow("eight markers") << 8 << 0.0;
        QTest::newRow("eight markers, 0.3 m up") << 8 << 0.3;
    }
    void sigmaHoldsWithACalibratedLens()
    {
        QFETCH(int, markers);
        QFETCH(double, heightM);
        constexpr double noisePx = 0.4;
        std::mt19937 random(unsigned(11 * markers));
        const MarkerLayout layout = layoutOf(markers);
        Coverage coverage;
        const CameraModel camera = test::trueCamera();
        for (unsigned draw = 0; coverage.draws < 40 && draw < 200; ++draw) {
            const FloorView truth = drawnView(test::trueLens(), random);
            const auto pixels = markedPixels(truth, layout, noisePx, random);
            if (!registerFloor(layout, pixels, camera, true)) // a marker is outside the image
                continue;
            const auto calibration = calibrateIntrinsics(tiltedViews(camera, 12, 0.2, 100 + draw), 1280, 720,
                                                         LensModel::Standard, {});
            QVERIFY(calibration.has_value());
            const CameraModel known = CameraModel::create(calibration->intrinsics).value();
            const auto registration = registerFloor(layout, pixels, known, true);
            if (!registration)
                continue;
            readAll(FloorReading(*registration, known, pixels, false), truth, noisePx, heightM, random,
                    coverage);
        }
        qInfo("%d draws, %d points: %.1f %% within the 95 %% ellipse, RMS %.2f sigma", coverage.draws,
              coverage.points, 100 * coverage.part(), coverage.rms());
        QVERIFY(coverage.draws >= 38);
        QVERIFY(coverage.part() > 0.87);
        QVERIFY(coverage.rms() > 0.5);
    }

    /// Lenses of webcams, phones and action cameras, none of them calibrated: σ still holds.
    void sigmaHoldsWithAnAssumedLens_data()
    {
        QTest::addColumn<int>("markers");
        QTest::newRow("four markers") << 4;
        QTest::newRow("eight markers") << 8;
    }
    void sigmaHoldsWithAnAssumedLens()
    {
        QFETCH(int, markers);
        constexpr double noisePx = 0.4;
        std::mt19937 random(unsigned(7 * markers));
        std::uniform_real_distribution<double> across(-1, 1);
        const MarkerLayout layout = layoutOf(markers);
        Coverage coverage;
        int refused = 0;
        while (coverage.draws < 200 && refused < 600) {
            Intrinsics lens = test::trueLens();
            lens.fxPx = 1280 * (0.75 + 0.2 * across(random));
            lens.fyPx = lens.fxPx * (1 + 0.005 * across(random));
            lens.cxPx += 20 * across(random);
            lens.cyPx += 20 * across(random);
            // A lens bent inwards by k1 is bent back by k2: radii grow all over the picture.
            const double k1 = 0.25 * across(random) - 0.05;
            lens.distortion = {k1, k1 < 0 ? -0.3 * k1 : -0.5 * k1, 0, 0, 0};
            const FloorView truth = drawnView(lens, random);
            const auto pixels = markedPixels(truth, layout, noisePx, random);
            const auto registration =
                registerFloor(layout, pixels, CameraModel::assumed(lens.widthPx, lens.heightPx), false);
            if (!registration) { // a marker is outside the image
                ++refused;
                continue;
            }
            const CameraModel used = CameraModel::create(registration->intrinsics).value();
            readAll(FloorReading(*registration, used, pixels, true), truth, noisePx, 0, random, coverage);
        }
        qInfo("%d draws (%d refused), %d points: %.1f %% within the 95 %% ellipse, RMS %.2f sigma",
              coverage.draws, refused, coverage.points, 100 * coverage.part(), coverage.rms());
        QVERIFY(coverage.draws >= 150);
        QVERIFY(coverage.part() > 0.89);
    }

    void whatIsNoFloorPointHasNoPosition()
    {
        std::mt19937 random(1);
        const MarkerLayout layout = layoutOf(4);
        const FloorView truth = drawnView(test::trueLens(), random);
        const auto pixels = markedPixels(truth, layout, 0, random);
        const auto registration = registerFloor(layout, pixels, truth.camera(), true);
        QVERIFY(registration.has_value());
        const FloorReading reading(*registration, truth.camera(), pixels, false);
        const auto located = reading.located({{"low", pixels[0].pixel}, {"high", {640, -4000}}});
        QCOMPARE(located.size(), std::size_t(2));
        QVERIFY(located[0].position.has_value());
        QVERIFY((located[0].position->pointInWorld - layout.markers[0].pointInWorld).norm() < 1e-6);
        QVERIFY(!located[1].position.has_value()); // above the horizon
        QVERIFY(!reading.at(pixels[0].pixel, 50).has_value());
    }

    /// Of markers that fit badly the pixel counts as badly; of those that fit by chance it does not count as
    /// nothing.
    void thePixelIsAsSureAsTheMarkers()
    {
        std::mt19937 random(5);
        const MarkerLayout layout = layoutOf(8);
        const FloorView truth = drawnView(test::trueLens(), random);
        const auto sigma = [&](double noisePx) {
            const auto pixels = markedPixels(truth, layout, noisePx, random);
            const auto registration = registerFloor(layout, pixels, truth.camera(), true);
            return registration ? FloorReading(*registration, truth.camera(), pixels, false).pixelSigmaPx()
                                : 0;
        };
        QCOMPARE(sigma(0), usualMarkSigmaPx);
        const double bad = sigma(2);
        QVERIFY2(bad > 1 && bad < 4, qPrintable(QString::number(bad))); // of ten residuals, half to double
    }
};

ODOGRAPH_TEST(TestFloorReading, QCoreApplication)
#include "tst_floor_reading.moc"
