// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <numbers>
#include <random>

using namespace odo;

namespace {

FloorView cameraAt(const Eigen::Vector3d &place, const Eigen::Matrix3d &axes)
{
    Intrinsics lens;
    lens.widthPx = 1280;
    lens.heightPx = 720;
    lens.fxPx = lens.fyPx = 950;
    lens.cxPx = 639.5;
    lens.cyPx = 359.5;
    return FloorView(*CameraModel::create(lens), {Eigen::Quaterniond(axes), place},
                     Eigen::Matrix<double, 6, 6>::Zero());
}

FloorView fromAbove(double heightM)
{
    return cameraAt({0, 0, heightM}, Eigen::Vector3d(1, -1, -1).asDiagonal());
}

FloorView oblique()
{
    const Eigen::Vector3d place(-2.2, -1.6, 2);
    Eigen::Matrix3d axes;
    axes.col(2) = (-place).normalized();
    axes.col(0) = axes.col(2).cross(Eigen::Vector3d::UnitZ()).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return cameraAt(place, axes);
}

/// Moments of all pixels of a fine raster whose ray meets the solid: a slow way without any hull.
RegionMoments rastered(const FloorView &view, const SolidShape &shape, const Eigen::Vector2d &position,
                       double heading, double stepPx)
{
    const Eigen::Rotation2Dd bodyFromWorld(-heading);
    const auto isInside = [&](const Eigen::Vector2d &floorPoint) {
        const Eigen::Vector2d p = bodyFromWorld * (floorPoint - position);
        if (shape.form == SolidShape::Form::Cylinder)
            return p.norm() <= shape.lengthM / 2;
        return std::abs(p.x()) <= shape.lengthM / 2 && std::abs(p.y()) <= shape.widthM / 2;
    };
    const Eigen::Vector2d middle = *view.pixelFromWorld({position.x(), position.y(), shape.topM / 2});
    RegionMoments moments;
    double n = 0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (double y = -90; y < 90; y += stepPx) {
        for (double x = -110; x < 110; x += stepPx) {
            const Eigen::Vector2d pixel = middle + Eigen::Vector2d(x, y);
            bool hit = false;
            for (int slice = 0; slice <= 60 && !hit; ++slice) {
                const double z = shape.baseM + (shape.topM - shape.baseM) * slice / 60;
                const auto point = view.floorFromPixel(pixel, z);
                hit = point && isInside(*point);
            }
            if (!hit)
                continue;
            const Eigen::Vector2d d(x, y);
            n += 1;
            sum += d;
            squares += d * d.transpose();
        }
    }
    const Eigen::Vector2d mean = sum / n;
    moments.areaPx2 = n * stepPx * stepPx;
    moments.centrePx = middle + mean;
    moments.covariancePx2 = squares / n - mean * mean.transpose();
    return moments;
}

} // namespace

class TestSilhouette : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aRectangleHasItsClosedFormMoments()
    {
        std::vector<Eigen::Vector2d> corners = {{2, 3}, {8, 3}, {8, 5}, {2, 5}};
        for (int way = 0; way < 2; ++way) { // in either orientation
            const RegionMoments moments = polygonMoments(corners);
            QCOMPARE(moments.areaPx2, 12.0);
            QVERIFY(moments.centrePx.isApprox(Eigen::Vector2d(5, 4)));
            QVERIFY(moments.covariancePx2.isApprox(
                Eigen::Vector2d(36 / 12.0, 4 / 12.0).asDiagonal().toDenseMatrix()));
            std::reverse(corners.begin(), corners.end());
        }
    }

    void fewerThanThreeCornersHaveNoArea()
    {
        QCOMPARE(polygonMoments({}).areaPx2, 0.0);
        QCOMPARE(polygonMoments({{1, 1}, {2, 2}}).areaPx2, 0.0);
        QCOMPARE(polygonMoments({{1, 1}, {2, 2}, {3, 3}}).areaPx2, 0.0);
    }

    void fromAboveTheTopAloneIsSeen()
    {
        const double scale = 950 / (2.0 - 0.1); // pixels per metre at the top
        const auto box =
            silhouetteMoments(fromAbove(2), {SolidShape::Form::Box, 0.3, 0.2, 0, 0.1}, {0, 0}, 0);
        QVERIFY(box.has_value());
        QVERIFY(std::abs(box->areaPx2 / (0.3 * 0.2 * scale * scale) - 1) < 1e-9);
        QVERIFY((box->centrePx - Eigen::Vector2d(639.5, 359.5)).norm() < 1e-9);
        QVERIFY(std::abs(box->covariancePx2(0, 0) / (0.09 / 12 * scale * scale) - 1) < 1e-9);
        const auto round =
            silhouetteMoments(fromAbove(2), {SolidShape::Form::Cylinder, 0.2, 0.2, 0, 0.1}, {0, 0}, 0);
        QVERIFY(round.has_value());
        QVERIFY(std::abs(round->areaPx2 / (std::numbers::pi * 0.01 * scale * scale) - 1) < 1e-9);
        // The moments of the polygon of 24 corners differ from the circle's by π²/(3·24²)·…: under 0.1 %.
        QVERIFY(std::abs(round->covariancePx2(0, 0) / (0.01 / 4 * scale * scale) - 1) < 1e-3);
    }

    void anObliqueViewSeesWhatARasterSees_data()
    {
        QTest::addColumn<bool>("round");
        QTest::addColumn<double>("base");
        QTest::addColumn<double>("heading");
        QTest::newRow("box") << false << 0.0 << 0.4;
        QTest::newRow("box across") << false << 0.0 << 1.9;
        QTest::newRow("plate") << false << 0.1 << 0.4;
        QTest::newRow("raised box") << false << 0.04 << 2.6;
        QTest::newRow("cylinder") << true << 0.0 << 0.0;
    }

    void anObliqueViewSeesWhatARasterSees()
    {
        QFETCH(bool, round);
        QFETCH(double, base);
        QFETCH(double, heading);
        const SolidShape shape{round ? SolidShape::Form::Cylinder : SolidShape::Form::Box, 0.26,
                               round ? 0.26 : 0.19, base, 0.1};
        const FloorView view = oblique();
        const auto moments = silhouetteMoments(view, shape, {0.3, -0.2}, heading);
        QVERIFY(moments.has_value());
        const RegionMoments raster = rastered(view, shape, {0.3, -0.2}, heading, 0.5);
        // The raster knows a border of some 250 px to half a step, by chance: 0.2 % of the area.
        QVERIFY(std::abs(moments->areaPx2 / raster.areaPx2 - 1) < 0.005);
        QVERIFY((moments->centrePx - raster.centrePx).norm() < 0.06);
        QVERIFY((moments->covariancePx2 - raster.covariancePx2).norm() < 0.01 * raster.covariancePx2.trace());
    }

    void behindTheCameraThereIsNone()
    {
        QVERIFY(!silhouetteMoments(oblique(), {SolidShape::Form::Box, 0.3, 0.2, 0, 0.1}, {-6, -5}, 0));
    }
};

ODOGRAPH_TEST(TestSilhouette, QCoreApplication)
#include "tst_silhouette.moc"
