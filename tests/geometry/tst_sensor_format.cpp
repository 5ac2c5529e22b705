// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sensor_format.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using Eigen::Vector2d, Eigen::Vector3d;
using Kind = SensorFormat::Kind;

namespace {

/// Of a 4:3 sensor, with its centre aside and a distortion of each kind.
Intrinsics lensOf(LensModel model)
{
    Intrinsics lens{4032, 3024, 3010, 3020, 2051, 1478, model, {}, {}};
    if (model == LensModel::Standard)
        lens.distortion = {-0.21, 0.06, 0.0013, -0.0021, -0.01};
    else if (model == LensModel::Rational)
        lens.distortion = {0.11, -0.05, 0.0013, -0.0021, 0.02, 0.31, -0.02, 0.01};
    else
        lens.distortion = {-0.02, 0.004, -0.001, 0.0002};
    const auto count = Eigen::Index(4 + lens.distortion.size());
    Eigen::MatrixXd root = Eigen::MatrixXd::Identity(count, count);
    root(0, 1) = 0.7;
    root(2, 6) = 0.3;
    lens.covariance = root * root.transpose();
    return lens;
}

/// Points in front of the camera, over the middle of its image.
std::vector<Vector3d> points()
{
    std::vector<Vector3d> all;
    for (const double x : {-0.4, -0.1, 0.0, 0.35})
        for (const double y : {-0.25, 0.05, 0.2})
            all.emplace_back(x, y, 1);
    return all;
}

/// Of the turned camera's axes: a clockwise quarter turn of the image takes right to down.
Vector3d turnedAxes(const Vector3d &point, int clockwiseDeg)
{
    if (clockwiseDeg == 0)
        return point;
    return clockwiseDeg == 90 ? Vector3d(-point.y(), point.x(), point.z())
                              : Vector3d(point.y(), -point.x(), point.z());
}

} // namespace

class TestSensorFormat : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void usualFormats_data()
    {
        QTest::addColumn<QSize>("from");
        QTest::addColumn<QSize>("to");
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("ways");
        QTest::addColumn<double>("scale");
        QTest::addColumn<Vector2d>("crop");
        const auto row = [](const char *name, QSize from, QSize to, Kind kind, int ways, double scale,
                            double left, double top) {
            QTest::newRow(name) << from << to << int(kind) << ways << scale << Vector2d(left, top);
        };
        row("the same", {1280, 720}, {1280, 720}, Kind::Whole, 1, 1, 0, 0);
        row("4K to full HD", {3840, 2160}, {1920, 1080}, Kind::Whole, 1, 0.5, 0, 0);
        row("rounded rows", {1280, 720}, {854, 480}, Kind::Whole, 1, 854.0 / 1280, 0, 0);
        row("padded rows", {1920, 1088}, {1920, 1080}, Kind::Whole, 1, 1, 0, 0);
        row("to padded rows", {3840, 2160}, {1920, 1088}, Kind::Whole, 1, 0.5, 0, 0);
        row("from padded rows", {1920, 1088}, {1280, 720}, Kind::Whole, 1, 1280.0 / 1920, 0, 0);
        row("4:3 to 16:9", {4032, 3024}, {1920, 1080}, Kind::WholeWidth, 1, 1920.0 / 4032, 0, 378);
        row("16:9 to 4:3", {1920, 1080}, {640, 480}, Kind::WholeHeight, 1, 480.0 / 1080, 240, 0);
        row("turned", {1920, 1080}, {1080, 1920}, Kind::Whole, 2, 1, 0, 0);
        row("turned 4:3 to 9:16", {4032, 3024}, {1080, 1920}, Kind::WholeHeight, 2, 1920.0 / 4032, 378, 0);
    }
    void usualFormats()
    {
        QFETCH(QSize, from);
        QFETCH(QSize, to);
        QFETCH(int, kind);
        QFETCH(int, ways);
        QFETCH(double, scale);
        QFETCH(Vector2d, crop);
        const auto formats = sensorFormats(from.width(), from.height(), to.width(), to.height());
        QCOMPARE(int(formats.size()), ways);
        QCOMPARE(int(formats.front().kind), kind);
        QCOMPARE(formats.front().scaleX, scale);
        QCOMPARE(formats.front().cropLeftPx, crop.x());
        QCOMPARE(formats.front().cropTopPx, crop.y());
        QCOMPARE(formats.front().widthPx, to.width());
        const auto determined = determinedFormat(from.width(), from.height(), to.width(), to.height());
        QCOMPARE(determined.has_value(), ways == 1 && Kind(kind) == Kind::Whole);
    }

    void noFormatOfNothing()
    {
        QVERIFY(sensorFormats(0, 0, 1920, 1080).empty());
        QVERIFY(sensorFormats(1920, 1080, 1920, -1).empty());
        QVERIFY(!determinedFormat(0, 0, 0, 0));
    }

    /// The middle of an image stays its middle, and its corners its corners: pixel centres are at whole
    /// numbers.
    void cornersStayCorners()
    {
        const auto format = determinedFormat(4000, 3000, 1000, 750).value();
        QCOMPARE(inFormat(Vector2d(-0.5, -0.5), 4000, 3000, format), Vector2d(-0.5, -0.5));
        QCOMPARE(inFormat(Vector2d(3999.5, 2999.5), 4000, 3000, format), Vector2d(999.5, 749.5));
        const SensorFormat wide = sensorFormats(4000, 3000, 1920, 1080).front();
        QCOMPARE(inFormat(Vector2d(1999.5, 1499.5), 4000, 3000, wide), Vector2d(959.5, 539.5));
        for (const SensorFormat &turned : sensorFormats(4000, 3000, 750, 1000))
            QCOMPARE(inFormat(Vector2d(1999.5, 1499.5), 4000, 3000, turned), Vector2d(374.5, 499.5));
    }

    /// What the lens projects in the other format is where the pixel went: to the last digits, for every
    /// model.
    void projectsWherePixelsGo_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<QSize>("to");
        for (const auto model : {LensModel::Standard, LensModel::Rational, LensModel::Fisheye})
            for (const QSize to : {QSize(1440, 1080), QSize(1920, 1080), QSize(1080, 1080), QSize(1080, 1920),
                                   QSize(3024, 4032)})
                QTest::addRow("model %d, %d×%d", int(model), to.width(), to.height()) << int(model) << to;
    }
    void projectsWherePixelsGo()
    {
        QFETCH(int, model);
        QFETCH(QSize, to);
        const Intrinsics lens = lensOf(LensModel(model));
        const auto camera = CameraModel::create(lens);
        for (const SensorFormat &format : sensorFormats(4032, 3024, to.width(), to.height())) {
            const Intrinsics other = inFormat(lens, format);
            QCOMPARE(QSize(other.widthPx, other.heightPx), to);
            const auto otherCamera = CameraModel::create(other);
            QVERIFY2(otherCamera, otherCamera ? "" : otherCamera.error().message().c_str());
            for (const Vector3d &point : points()) {
                const Vector2d expected = inFormat(*camera->project(point), 4032, 3024, format);
                const Vector2d pixel = *otherCamera->project(turnedAxes(point, format.clockwiseDeg));
                QVERIFY((pixel - expected).norm() < 1e-9);
                // and its uncertainty is that of the pixel, turned and scaled
                const auto before = camera->pixelByIntrinsics(point);
                const auto after = otherCamera->pixelByIntrinsics(turnedAxes(point, format.clockwiseDeg));
                const Eigen::Matrix2d spread = before * lens.covariance * before.transpose(),
                                      otherSpread = after * other.covariance * after.transpose();
                const double scale2 = format.scaleX * format.scaleY;
                QVERIFY(std::abs(otherSpread.trace() - scale2 * spread.trace()) < 1e-9 * spread.trace());
                QVERIFY(std::abs(otherSpread.determinant() - scale2 * scale2 * spread.determinant()) <
                        1e-9 * spread.determinant());
            }
        }
    }

    void enlargedAboutTheMiddle()
    {
        const Intrinsics lens = lensOf(LensModel::Standard), larger = enlarged(lens, 1.25);
        QCOMPARE(larger.fxPx, 1.25 * 3010);
        QCOMPARE(larger.cxPx, 2015.5 + 1.25 * (2051 - 2015.5));
        QCOMPARE(larger.covariance(0, 1), 1.25 * 1.25 * lens.covariance(0, 1));
        const Intrinsics unsure = withEnlargementSigma(lens, 0.1);
        QCOMPARE(unsure.covariance(0, 0), lens.covariance(0, 0) + 301.0 * 301.0);
        QCOMPARE(unsure.covariance(0, 1), lens.covariance(0, 1) + 301.0 * 302.0);
        Intrinsics unknown = lens;
        unknown.covariance.resize(0, 0);
        QCOMPARE(withEnlargementSigma(unknown, 0.1).covariance(0, 0), 301.0 * 301.0);
        QVERIFY(CameraModel::create(withEnlargementSigma(unknown, 0.1)).has_value());
    }

    void theMeanHoldsBoth()
    {
        Intrinsics one = lensOf(LensModel::Fisheye), other = one;
        other.cxPx += 30;
        const Intrinsics mean = meanOf(one, other);
        QCOMPARE(mean.cxPx, one.cxPx + 15);
        QCOMPARE(mean.covariance(2, 2), one.covariance(2, 2) + 225);
        one.covariance.resize(0, 0);
        QCOMPARE(meanOf(one, other).covariance(2, 2), 225.0);
    }
};

ODOGRAPH_TEST(TestSensorFormat, QCoreApplication)
#include "tst_sensor_format.moc"
