// SPDX-License-Identifier: GPL-3.0-or-later
// A lens calibrated at 4:3 in images of other sizes of the same sensor, by markers at exactly projected
// pixels with noise.
#include "core/workflow/calibrate/fitted_intrinsics.h"

#include "core/calibration/floor_registration.h"
#include "core/simulation/demo_testbed.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <random>

using namespace odo;
using Eigen::Vector2d, Eigen::Vector3d;

namespace {

/// The true lens of a clip at 1280×720, and that of 4:3 stills of twice the resolution with the same columns.
struct Sensor
{
    Intrinsics clip, stills;
};

Sensor sensorOf(const Intrinsics &clip)
{
    Sensor sensor{clip, clip};
    sensor.stills.widthPx = 2560;
    sensor.stills.heightPx = 1920;
    sensor.stills.fxPx *= 2;
    sensor.stills.fyPx *= 2;
    sensor.stills.cxPx = 2 * (clip.cxPx + 0.5) - 0.5;
    sensor.stills.cyPx = 2 * (clip.cyPx + 0.5) + (1920 - 2 * 720) / 2 - 0.5;
    const auto count = Eigen::Index(4 + clip.distortion.size());
    sensor.stills.covariance = Eigen::MatrixXd::Zero(count, count);
    sensor.stills.covariance.topLeftCorner<4, 4>().diagonal() << 0.5, 0.5, 0.5, 0.5;
    return sensor;
}

} // namespace

class TestFittedIntrinsics : public QObject
{
    Q_OBJECT

    SimulatedScene m_scene = demoTestbed(1);
    std::mt19937 m_random{5};

    const FloorView &view() const { return m_scene.cameras[0].view; }
    Sensor sensor() const { return sensorOf(view().camera().intrinsics()); }

    MarkerLayout layoutOf(int columns, int rows, double part = 1) const
    {
        MarkerLayout layout;
        layout.name = "grid";
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                Marker marker = m_scene.floor.markers.markers.front();
                marker.label = "m" + std::to_string(row) + "_" + std::to_string(column);
                marker.pointInWorld =
                    Vector2d(0.1 + 2.8 * part * column / (columns - 1), 0.1 + 1.8 * part * row / (rows - 1));
                layout.markers.push_back(marker);
            }
        return layout;
    }

    std::vector<MarkerPixel> seen(const MarkerLayout &layout, const CameraModel &camera, double sigmaPx)
    {
        std::normal_distribution<double> noise(0, sigmaPx);
        std::vector<MarkerPixel> pixels;
        for (const Marker &marker : layout.markers) {
            const Vector3d point = view().worldFromCamera().inverse() *
                                   Vector3d(marker.pointInWorld.x(), marker.pointInWorld.y(), 0);
            const auto pixel = camera.project(point);
            if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > camera.intrinsics().widthPx - 1 ||
                pixel->y() > camera.intrinsics().heightPx - 1)
                continue;
            pixels.push_back({marker.label, *pixel + Vector2d(noise(m_random), noise(m_random))});
        }
        return pixels;
    }

    /// The 4:3 lens as fitted to what a camera of this true lens sees.
    FittedIntrinsics fitted(const Intrinsics &truth, int columns, int rows, double sigmaPx, double part = 1)
    {
        const MarkerLayout layout = layoutOf(columns, rows, part);
        const auto pixels = seen(layout, *CameraModel::create(truth), sigmaPx);
        return fittedIntrinsics(sensor().stills, truth.widthPx, truth.heightPx, pixels.size(),
                                [&](const Intrinsics &lens) -> std::optional<double> {
                                    const auto fit =
                                        registerFloor(layout, pixels, *CameraModel::create(lens), true);
                                    if (!fit)
                                        return std::nullopt;
                                    double squares = 0;
                                    for (const MarkerError &marker : fit->markers)
                                        squares += marker.errorPx * marker.errorPx;
                                    return squares;
                                });
    }
    static double focalSigma(const Intrinsics &lens) { return std::sqrt(lens.covariance(0, 0)) / lens.fxPx; }

private Q_SLOTS:
    void stillsAtFourToThreeServeAWideClip()
    {
        for (int draw = 0; draw < 5; ++draw) {
            const FittedIntrinsics lens = fitted(sensor().clip, 5, 4, 0.1);
            QVERIFY2(lens.how.code() == "workflow.lens_cropped_rows", lens.how.english().c_str());
            QVERIFY(std::abs(lens.intrinsics.fxPx / sensor().clip.fxPx - 1) < 1e-9);
            QVERIFY(std::abs(lens.intrinsics.cyPx - sensor().clip.cyPx) < 1e-9);
            QVERIFY(focalSigma(lens.intrinsics) < 0.001);
        }
    }

    /// Digital stabilisation reads a part, which the markers show.
    void anEnlargedClipIsNoticed()
    {
        for (const double factor : {1.1, 1.25, 1.6}) {
            const Intrinsics truth = enlarged(sensor().clip, factor);
            const FittedIntrinsics lens = fitted(truth, 7, 6, 0.1);
            QVERIFY2(lens.how.code() == "workflow.lens_enlarged", lens.how.english().c_str());
            QVERIFY2(std::abs(lens.intrinsics.fxPx / truth.fxPx - 1) < 3 * focalSigma(lens.intrinsics),
                     lens.how.english().c_str());
            QVERIFY(focalSigma(lens.intrinsics) < 0.02);
        }
    }

    /// Few markers, or some that are close together, show nothing: what is not known is uncertain.
    void withoutEvidenceItIsUncertain()
    {
        for (const double factor : {1.0, 1.1}) {
            const Intrinsics truth = enlarged(sensor().clip, factor);
            for (const auto &[columns, rows, part] : {std::tuple{2, 2, 0.6}, std::tuple{4, 3, 0.15}}) {
                const FittedIntrinsics lens = fitted(truth, columns, rows, 0.3, part);
                QVERIFY2(lens.how.code() == "workflow.lens_part_unknown", lens.how.english().c_str());
                QVERIFY(std::abs(lens.intrinsics.fxPx / truth.fxPx - 1) < 2 * focalSigma(lens.intrinsics));
                QVERIFY(lens.how.english().find("is known only to 10 %") != std::string::npos);
            }
        }
    }

    /// Tape errors of the layout, which look like another focal length, are in what is stated.
    void anInexactLayoutMisleadsNobody()
    {
        int wrong = 0;
        for (int draw = 0; draw < 20; ++draw) {
            const FittedIntrinsics lens = fitted(sensor().clip, 4, 3, 1.5);
            wrong += std::abs(lens.intrinsics.fxPx / sensor().clip.fxPx - 1) >
                     2 * focalSigma(lens.intrinsics) + 1e-9;
        }
        QVERIFY2(wrong <= 1, qPrintable(QString::number(wrong)));
    }

    void scalingNeedsNoMarkers()
    {
        const FittedIntrinsics lens = fittedIntrinsics(
            sensor().stills, 1280, 960, 4, [](const Intrinsics &) { return std::optional<double>(1.0); });
        QCOMPARE(lens.how.english(),
                 std::string("The lens calibration at 2560×1920 was converted to 1280×960."));
        QCOMPARE(lens.intrinsics.fxPx, sensor().clip.fxPx);
        QCOMPARE(lens.intrinsics.covariance(0, 0), 0.125);
    }

    void aTurnedCameraIsTurnedBack()
    {
        for (const SensorFormat &format : sensorFormats(2560, 1920, 1920, 2560)) {
            Intrinsics truth = inFormat(sensor().stills, format);
            // seen by a camera in the same place, turned about its axis: markers all over the image
            const MarkerLayout layout = layoutOf(7, 6);
            const auto before = seen(layout, *CameraModel::create(sensor().stills), 0.1);
            std::vector<MarkerPixel> pixels = before;
            for (MarkerPixel &marker : pixels)
                marker.pixel = inFormat(marker.pixel, 2560, 1920, format);
            const auto misfit = [&](const Intrinsics &lens) -> std::optional<double> {
                const auto fit = registerFloor(layout, pixels, *CameraModel::create(lens), true);
                if (!fit)
                    return std::nullopt;
                double squares = 0;
                for (const MarkerError &marker : fit->markers)
                    squares += marker.errorPx * marker.errorPx;
                return squares;
            };
            const FittedIntrinsics lens =
                fittedIntrinsics(sensor().stills, 1920, 2560, pixels.size(), misfit);
            const double sigmaX = std::sqrt(lens.intrinsics.covariance(2, 2)),
                         sigmaY = std::sqrt(lens.intrinsics.covariance(3, 3));
            QVERIFY2(std::abs(lens.intrinsics.cxPx - truth.cxPx) < 3 * sigmaX, lens.how.english().c_str());
            QVERIFY2(std::abs(lens.intrinsics.cyPx - truth.cyPx) < 3 * sigmaY, lens.how.english().c_str());
            QVERIFY(std::abs(lens.intrinsics.fxPx - truth.fxPx) < 0.003 * truth.fxPx);
        }
    }
};

ODOGRAPH_TEST(TestFittedIntrinsics, QCoreApplication)
#include "tst_fitted_intrinsics.moc"
