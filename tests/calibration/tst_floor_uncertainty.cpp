// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/calibration/intrinsics_influence.h"
#include "tests/support/registered_test.h"

#include <Eigen/Cholesky>
#include <QTest>
#include <random>

using namespace odo;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int widthPx = 1280, heightPx = 720;

Intrinsics trueIntrinsics()
{
    return {widthPx, heightPx, 930, 928, 646, 352, LensModel::Standard, {-0.2, 0.06, 0.0006, -0.0004, 0}, {}};
}

/// A board of 9×6 corners of 25 mm in some attitude before the camera.
BoardView drawnBoard(const CameraModel &camera, double noisePx, std::mt19937 &random)
{
    std::uniform_real_distribution<double> across(-1, 1);
    std::normal_distribution<double> noise(0, noisePx);
    const double depth = 0.5 + 0.2 * across(random);
    const Vector3d centre(0.45 * depth * across(random), 0.25 * depth * across(random), depth);
    const Eigen::Quaterniond turn = Eigen::AngleAxisd(0.7 * across(random), Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(0.7 * across(random), Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(3 * across(random), Vector3d::UnitZ());
    BoardView view{"picture", 9, 6, {}, {}};
    for (int i = 0; i < 54; ++i) {
        const Vector2d point(0.025 * (i % 9), 0.025 * (i / 9));
        const auto pixel = camera.project(turn * Vector3d(point.x() - 0.1, point.y() - 0.0625, 0) + centre);
        if (!pixel)
            continue;
        view.pixels.push_back(*pixel + Vector2d(noise(random), noise(random)));
        view.pointsOnBoard.push_back(point);
    }
    return view;
}

FloorView trueView()
{
    const Vector3d position(-0.6, -1.5, 1.9);
    const Vector3d forward = (Vector3d(1.4, 0.8, 0) - position).normalized();
    const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    return {*CameraModel::create(trueIntrinsics()),
            {Eigen::Quaterniond(axes), position},
            Eigen::Matrix<double, 6, 6>::Zero()};
}

const MarkerLayout &layout()
{
    static const MarkerLayout markers{"floor",
                                      {{"O", {0, 0}}, {"U", {2.6, 0}}, {"V", {0, 1.8}}, {"D", {2.6, 1.8}}}};
    return markers;
}

/// A camera calibrated and registered as somebody would: everything measured with noise.
Result<FloorView> measuredView(double cornerPx, double markerPx, std::mt19937 &random)
{
    const FloorView truth = trueView();
    std::vector<BoardView> boards;
    for (int i = 0; i < 14; ++i)
        boards.push_back(drawnBoard(truth.camera(), cornerPx, random));
    const auto calibration =
        calibrateIntrinsics(boards, widthPx, heightPx, LensModel::Standard, JobControl());
    if (!calibration)
        return tl::unexpected(calibration.error());
    std::normal_distribution<double> noise(0, markerPx);
    std::vector<MarkerPixel> pixels;
    for (const Marker &marker : layout().markers) {
        const auto seen = truth.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
        pixels.push_back({marker.label, *seen + Vector2d(noise(random), noise(random))});
    }
    const CameraModel camera = *CameraModel::create(calibration->intrinsics);
    const auto registration = registerFloor(layout(), pixels, camera, true);
    if (!registration)
        return tl::unexpected(registration.error());
    return floorViewOf(*registration, camera, pixels);
}

/// Errors of floor points over all draws against what each draw stated.
struct Tally
{
    double actual = 0, stated = 0, withoutIntrinsics = 0; ///< sums of variances, m²
    int inside = 0, coordinates = 0;                      ///< of the 95 % interval

    void add(const FloorView &measured, const FloorView &truth, const Vector2d &position, double heightM)
    {
        const auto seen = measured.locate(*truth.pixelFromWorld({position.x(), position.y(), heightM}),
                                          Eigen::Matrix2d::Zero(), heightM);
        QVERIFY(seen.has_value());
        const Vector2d error = seen->pointInWorld - position;
        actual += error.squaredNorm();
        stated += seen->calibrationCovariance.trace();
        for (int axis = 0; axis < 2; ++axis, ++coordinates)
            inside += std::abs(error(axis)) <= 1.96 * std::sqrt(seen->calibrationCovariance(axis, axis));
        const FloorView exactIntrinsics(measured.camera(), measured.worldFromCamera(),
                                        measured.poseCovariance());
        withoutIntrinsics += exactIntrinsics
                                 .locate(*truth.pixelFromWorld({position.x(), position.y(), heightM}),
                                         Eigen::Matrix2d::Zero(), heightM)
                                 ->calibrationCovariance.trace();
    }
};

} // namespace

class TestFloorUncertainty : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void anErrorOfTheLensReachesTheFloorAsStated()
    {
        // Another lens, the pose refitted with it to the same exact markers, the same pixel located again.
        const FloorView truth = trueView();
        std::mt19937 random(5);
        std::normal_distribution<double> normal;
        Intrinsics lens = trueIntrinsics();
        Eigen::VectorXd sigma(9);
        sigma << 3, 3, 4, 4, 0.004, 0.004, 0.0005, 0.0005, 0.001;
        lens.covariance = sigma.cwiseAbs2().asDiagonal();
        lens.covariance(0, 1) = lens.covariance(1, 0) = 8; // both focal lengths err together
        const Eigen::MatrixXd root = lens.covariance.llt().matrixL();
        std::vector<Vector2d> positions;
        std::vector<MarkerPixel> pixels;
        for (const Marker &marker : layout().markers) {
            positions.push_back(marker.pointInWorld);
            pixels.push_back(
                {marker.label, *truth.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0})});
        }
        const FloorView view(*CameraModel::create(lens), truth.worldFromCamera(),
                             Eigen::Matrix<double, 6, 6>::Zero(),
                             poseByIntrinsics(truth.camera(), truth.worldFromCamera(), positions));
        const Vector3d points[] = {{1.2, 0.9, 0.06}, {0.3, 1.7, 0}, {2.4, 0.4, 0.1}};
        Eigen::Matrix2d sampled[] = {Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero(),
                                     Eigen::Matrix2d::Zero()};
        Eigen::Matrix2d sampledTogether = Eigen::Matrix2d::Zero(); // of the first two points, on the floor
        const int draws = 3000;
        for (int draw = 0; draw < draws; ++draw) {
            const Eigen::VectorXd step =
                root * Eigen::VectorXd::NullaryExpr(9, [&] { return normal(random); });
            Intrinsics other = trueIntrinsics();
            other.fxPx += step(0);
            other.fyPx += step(1);
            other.cxPx += step(2);
            other.cyPx += step(3);
            for (std::size_t i = 0; i < 5; ++i)
                other.distortion[i] += step(static_cast<Eigen::Index>(4 + i));
            const CameraModel camera = *CameraModel::create(other);
            const auto refitted = registerFloor(layout(), pixels, camera, true);
            QVERIFY(refitted.has_value());
            const FloorView wrong(camera, refitted->worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
            const auto floorError = [&](int i) {
                const Vector2d position = points[i].head<2>();
                return Vector2d(
                    *wrong.floorFromPixel(*truth.pixelFromWorld({position.x(), position.y(), 0}), 0) -
                    position);
            };
            sampledTogether += floorError(0) * floorError(1).transpose() / draws;
            for (int i = 0; i < 3; ++i) {
                const auto position = wrong.floorFromPixel(*truth.pixelFromWorld(points[i]), points[i].z());
                const Vector2d error = *position - points[i].head<2>();
                sampled[i] += error * error.transpose() / draws;
            }
        }
        const auto together = view.sharedCovariance(points[0].head<2>(), points[1].head<2>(), 0);
        QVERIFY(together.has_value());
        // Beside the spread of each place: what they share may be little.
        QVERIFY((sampledTogether - *together).norm() <
                0.1 * std::sqrt(sampled[0].norm() * sampled[1].norm()));
        for (int i = 0; i < 3; ++i) {
            const auto stated =
                view.locate(*truth.pixelFromWorld(points[i]), Eigen::Matrix2d::Zero(), points[i].z());
            // 3000 draws leave 2.6 % on a variance, the curvature somewhat less.
            QVERIFY2((sampled[i] - stated->calibrationCovariance).norm() < 0.1 * sampled[i].norm(),
                     qPrintable(QString::number(sampled[i].norm() / stated->calibrationCovariance.norm())));
        }
    }
    void theFloorIsAsUncertainAsStated_data()
    {
        QTest::addColumn<double>("cornerPx");
        QTest::addColumn<double>("markerPx");
        QTest::newRow("sharp boards, picked markers") << 0.1 << 0.3;
        QTest::newRow("blurred boards, picked markers") << 0.4 << 0.3;
    }
    void theFloorIsAsUncertainAsStated()
    {
        QFETCH(double, cornerPx);
        QFETCH(double, markerPx);
        const FloorView truth = trueView();
        std::mt19937 random(41);
        Tally tally;
        const int draws = 40;
        for (int draw = 0; draw < draws; ++draw) {
            const auto measured = measuredView(cornerPx, markerPx, random);
            QVERIFY2(measured.has_value(), measured ? "" : measured.error().message().c_str());
            QVERIFY(measured->hasIntrinsicsPart());
            for (double x = 0.2; x < 2.6; x += 0.4) {
                for (double y = 0.1; y < 1.8; y += 0.4)
                    tally.add(*measured, truth, {x, y}, 0.06);
            }
        }
        const double ratio = std::sqrt(tally.actual / tally.stated);
        const double inside = double(tally.inside) / tally.coordinates;
        qInfo("sigma %.2f mm, actual/stated %.2f, without the lens %.2f, inside %.1f %%",
              1000 * std::sqrt(tally.stated / tally.coordinates), ratio,
              std::sqrt(tally.actual / tally.withoutIntrinsics), 100 * inside);
        // The points of one draw err together: 40 draws know the ratio to about a tenth.
        QVERIFY(ratio > 0.7 && ratio < 1.4);
        QVERIFY(inside > 0.90 && inside < 0.99);
    }
};

ODOGRAPH_TEST(TestFloorUncertainty, QCoreApplication)
#include "tst_floor_uncertainty.moc"
