// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera_model.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <opencv2/calib3d.hpp>
#include <random>

using namespace odo;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Intrinsics lens(LensModel model, std::vector<double> distortion)
{
    Intrinsics intrinsics;
    intrinsics.widthPx = 1280;
    intrinsics.heightPx = 720;
    intrinsics.fxPx = 910.5;
    intrinsics.fyPx = 905.25;
    intrinsics.cxPx = 645.125;
    intrinsics.cyPx = 352.75;
    intrinsics.model = model;
    intrinsics.distortion = std::move(distortion);
    return intrinsics;
}

void addIntrinsicsRows()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<QVector<double>>("distortion");
    const auto row = [](const char *name, LensModel model, QVector<double> k) {
        QTest::newRow(name) << int(model) << k;
    };
    row("none", LensModel::Standard, {});
    row("mild barrel", LensModel::Standard, {-0.12, 0.05, 0.001, -0.0015});
    row("strong barrel", LensModel::Standard, {-0.42, 0.19, 0.002, -0.001, -0.04});
    row("pincushion", LensModel::Standard, {0.25, 0.1, -0.002, 0.003, 0.05});
    row("rational", LensModel::Rational, {8.2, 4.1, 0.0004, -0.0002, 0.25, 8.5, 6.9, 1.2});
    row("fisheye", LensModel::Fisheye, {-0.03, 0.011, -0.006, 0.001});
    row("fisheye without coefficients", LensModel::Fisheye, {});
}

CameraModel cameraOfRow(int model, const QVector<double> &k)
{
    return CameraModel::create(lens(LensModel(model), {k.begin(), k.end()})).value();
}

} // namespace

class TestCameraModel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void pixelsRoundTrip_data() { addIntrinsicsRows(); }
    void pixelsRoundTrip()
    {
        QFETCH(int, model);
        QFETCH(QVector<double>, distortion);
        const CameraModel camera = cameraOfRow(model, distortion);
        int seen = 0;
        for (double y = 0; y < 720; y += 17.3) {
            for (double x = 0; x < 1280; x += 19.7) {
                const auto ray = camera.unproject({x, y});
                if (!ray)
                    continue;
                ++seen;
                const auto back = camera.project(3.7 * *ray);
                QVERIFY(back.has_value());
                QVERIFY2((*back - Vector2d(x, y)).norm() < 1e-9,
                         qPrintable(QString::number((*back - Vector2d(x, y)).norm())));
            }
        }
        QCOMPARE(seen, 42 * 65);
    }
    void derivativesByTheLensAgreeWithDifferences_data() { addIntrinsicsRows(); }
    void derivativesByTheLensAgreeWithDifferences()
    {
        QFETCH(int, model);
        QFETCH(QVector<double>, distortion);
        const CameraModel camera = cameraOfRow(model, distortion);
        const auto moved = [&](Eigen::Index value, double step) {
            Intrinsics in = camera.intrinsics();
            double *const pinhole[] = {&in.fxPx, &in.fyPx, &in.cxPx, &in.cyPx};
            (value < 4 ? *pinhole[value] : in.distortion[static_cast<std::size_t>(value - 4)]) += step;
            return CameraModel::create(in).value();
        };
        for (const Vector3d &point : {Vector3d(0.3, -0.2, 1), Vector3d(-0.8, 0.5, 2), Vector3d(0, 0, 3)}) {
            const PixelByIntrinsics stated = camera.pixelByIntrinsics(point);
            QCOMPARE(stated.cols(), Eigen::Index(4 + distortion.size()));
            for (Eigen::Index value = 0; value < stated.cols(); ++value) {
                const double step = value < 4 ? 1e-3 : 1e-6;
                const Vector2d numeric =
                    (*moved(value, step).project(point) - *moved(value, -step).project(point)) / (2 * step);
                QVERIFY2((stated.col(value) - numeric).norm() < 1e-5 * (1 + numeric.norm()),
                         qPrintable(QString::number(value)));
            }
        }
    }
    void agreesWithOpenCv_data() { addIntrinsicsRows(); }
    void agreesWithOpenCv()
    {
        QFETCH(int, model);
        QFETCH(QVector<double>, distortion);
        const CameraModel camera = cameraOfRow(model, distortion);
        const Intrinsics &in = camera.intrinsics();
        const cv::Matx33d matrix(in.fxPx, 0, in.cxPx, 0, in.fyPx, in.cyPx, 0, 0, 1);
        std::vector<cv::Point3d> points;
        for (double y = -0.4; y <= 0.4; y += 0.1) {
            for (double x = -0.6; x <= 0.6; x += 0.1)
                points.emplace_back(2.5 * x, 2.5 * y, 2.5);
        }
        std::vector<cv::Point2d> expected;
        const std::vector<double> none(4, 0.0);
        const std::vector<double> &k = in.distortion.empty() ? none : in.distortion;
        if (in.model == LensModel::Fisheye)
            cv::fisheye::projectPoints(points, expected, cv::Vec3d(), cv::Vec3d(), matrix, k);
        else
            cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), matrix, k, expected);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto pixel = camera.project({points[i].x, points[i].y, points[i].z});
            QVERIFY(pixel.has_value());
            QVERIFY((*pixel - Vector2d(expected[i].x, expected[i].y)).norm() < 1e-9);
        }
    }
    void derivativeAgreesWithDifferences_data() { addIntrinsicsRows(); }
    void derivativeAgreesWithDifferences()
    {
        QFETCH(int, model);
        QFETCH(QVector<double>, distortion);
        const CameraModel camera = cameraOfRow(model, distortion);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> across(-1.0, 1.0), depth(1.5, 4.0);
        for (int i = 0; i < 200; ++i) {
            const Vector3d point(across(random), 0.6 * across(random), depth(random));
            Eigen::Matrix<double, 2, 3> analytic, numeric;
            QVERIFY(camera.project(point, analytic).has_value());
            const double step = 1e-5;
            for (int axis = 0; axis < 3; ++axis) {
                const Vector3d shift = step * Vector3d::Unit(axis);
                numeric.col(axis) =
                    (*camera.project(point + shift) - *camera.project(point - shift)) / (2 * step);
            }
            QVERIFY((analytic - numeric).norm() < 1e-6 * analytic.norm());
        }
    }
    void farPointsDoNotFoldIn()
    {
        // r(1 - 0.42 r² + 0.05 r⁴) grows, falls and would bring points from far outside into the picture.
        const CameraModel camera =
            CameraModel::create(lens(LensModel::Standard, {-0.42, 0.05, 0, 0, 0})).value();
        double last = camera.intrinsics().cxPx;
        bool ended = false;
        for (double x = 0.01; x < 60; x *= 1.01) {
            const auto pixel = camera.project({x, 0, 1});
            QVERIFY2(!(ended && pixel), "the picture came back after it had ended");
            ended = ended || !pixel;
            if (!pixel)
                continue;
            QVERIFY(pixel->x() > last);
            last = pixel->x();
        }
        QVERIFY(ended);
        QVERIFY(!camera.unproject({last + 5, camera.intrinsics().cyPx}).has_value());
    }
    void nothingIsSeenBehindTheCamera()
    {
        const CameraModel flat = CameraModel::create(lens(LensModel::Standard, {})).value();
        QVERIFY(!flat.project({0.1, 0.1, -1}).has_value());
        QVERIFY(!flat.project({0.1, 0.1, 0}).has_value());
        QVERIFY(!flat.project({0, 0, 0}).has_value());
        QVERIFY(!flat.project({std::nan(""), 0, 1}).has_value());
        const CameraModel fisheye = CameraModel::create(lens(LensModel::Fisheye, {})).value();
        QVERIFY(!fisheye.project({0, 0, -1}).has_value());
        QVERIFY(!fisheye.project({0, 0, 0}).has_value());
    }
    void aFisheyeSeesSidewaysOfNinetyDegrees()
    {
        const CameraModel camera =
            CameraModel::create(lens(LensModel::Fisheye, {-0.01, 0.001, 0, 0})).value();
        const Vector3d sideways = Vector3d(2, 1, -0.5).normalized();
        const auto pixel = camera.project(5 * sideways);
        QVERIFY(pixel.has_value());
        const auto ray = camera.unproject(*pixel);
        QVERIFY(ray.has_value());
        QVERIFY((*ray - sideways).norm() < 1e-12);
    }
    void refusesUnusableIntrinsics()
    {
        const auto refused = [](auto &&change, const char *why) {
            Intrinsics intrinsics = lens(LensModel::Standard, {});
            change(intrinsics);
            const auto camera = CameraModel::create(intrinsics);
            if (camera)
                return false;
            return camera.error().code == ErrorCode::InvalidInput &&
                   camera.error().message().find(why) != std::string::npos;
        };
        QVERIFY(refused([](Intrinsics &i) { i.fxPx = -1; }, "-1.000 px is not positive"));
        QVERIFY(refused([](Intrinsics &i) { i.cxPx = std::nan(""); }, "not a finite number"));
        QVERIFY(refused([](Intrinsics &i) { i.widthPx = 0; }, "0x720"));
        QVERIFY(refused([](Intrinsics &i) { i.distortion = {1, 2, 3}; }, "3 distortion coefficients"));
        QVERIFY(refused([](Intrinsics &i) { i.covariance = Eigen::MatrixXd::Identity(3, 3); }, "covariance"));
        QVERIFY(CameraModel::create(lens(LensModel::Standard, {})).has_value());
    }
    void theAssumedCameraLooksThroughTheMiddle()
    {
        const CameraModel camera = CameraModel::assumed(1920, 1080);
        QCOMPARE(camera.intrinsics().fxPx, 2304.0);
        const auto ray = camera.unproject({959.5, 539.5});
        QVERIFY((*ray - Vector3d(0, 0, 1)).norm() < 1e-15);
    }
};

ODOGRAPH_TEST(TestCameraModel, QCoreApplication)
#include "tst_camera_model.moc"
