// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_alignment.h"
#include "core/calibration/internal/tag_detection.h"
#include "tests/calibration/images.h"
#include "tests/support/registered_test.h"

#include <Eigen/LU>
#include <QTest>
#include <opencv2/imgproc.hpp>
#include <random>

using namespace odo;
using Eigen::Matrix3d;
using Eigen::Vector2d;

namespace {

constexpr int number = 3;

/// A tag of so many pixels a side about a place, turned and in perspective.
Matrix3d mapOf(double halfPx, const Vector2d &position, double flatness = 0.6)
{
    Matrix3d map;
    map << 0.95 * halfPx, -0.3 * halfPx, position.x(), 0.3 * flatness * halfPx, 0.95 * flatness * halfPx,
        position.y(), 0.0006 * halfPx, 0.0012 * halfPx, 1;
    map.row(0) += (map(2, 0) * position.x()) * Eigen::RowVector3d::UnitX() +
                  (map(2, 1) * position.x()) * Eigen::RowVector3d::UnitY();
    map.row(1) += (map(2, 0) * position.y()) * Eigen::RowVector3d::UnitX() +
                  (map(2, 1) * position.y()) * Eigen::RowVector3d::UnitY();
    return map;
}

/// The picture of a tag by 16 × 16 samples a pixel, on a floor that grows brighter to the right.
cv::Mat imageOf(const Matrix3d &map, double blurPx, double noise, unsigned seed)
{
    constexpr int parts = 16;
    const TagCells cells = *tagCells({TagFamily::AprilTag36h11, number});
    const Matrix3d back = map.inverse();
    cv::Mat image(160, 200, CV_32F);
    for (int y = 0; y < image.rows; ++y) {
        for (int x = 0; x < image.cols; ++x) {
            double sum = 0;
            for (int i = 0; i < parts * parts; ++i) {
                const Vector2d at = (back * Eigen::Vector3d(x - 0.5 + (i % parts + 0.5) / parts,
                                                            y - 0.5 + (i / parts + 0.5) / parts, 1))
                                        .hnormalized();
                double grey = 130;
                if (at.cwiseAbs().maxCoeff() < 1.3)
                    grey = 210;
                if (at.cwiseAbs().maxCoeff() < 1)
                    grey = cells.white[std::size_t(int(4 * (at.y() + 1)) * 8 + int(4 * (at.x() + 1)))] ? 210
                                                                                                       : 30;
                sum += grey;
            }
            image.at<float>(y, x) = float(sum / parts / parts * (0.8 + 0.2 * x / image.cols));
        }
    }
    cv::GaussianBlur(image, image, {0, 0}, blurPx);
    std::mt19937 random(seed);
    std::normal_distribution<float> grey(0, float(noise));
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            image.at<float>(y, x) += grey(random);
    cv::Mat bytes;
    image.convertTo(bytes, CV_8U);
    return bytes;
}

} // namespace

class TestTagAlignment : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void findsTheMiddleToAHundredthOfAPixel_data()
    {
        QTest::addColumn<double>("halfPx");
        QTest::addColumn<double>("flatness");
        QTest::addColumn<double>("mostPx");
        QTest::newRow("cells of 9 px") << 36.0 << 0.7 << 0.02;
        QTest::newRow("cells of 3 px") << 12.0 << 0.7 << 0.04;
        QTest::newRow("cells of 2.5 by 0.9 px") << 10.0 << 0.35 << 0.1;
    }
    void findsTheMiddleToAHundredthOfAPixel()
    {
        QFETCH(double, halfPx);
        QFETCH(double, flatness);
        QFETCH(double, mostPx);
        for (unsigned seed = 0; seed < 6; ++seed) {
            const Vector2d position(98.3 + 0.17 * seed, 81.4 - 0.23 * seed);
            const Matrix3d truth = mapOf(halfPx, position, flatness);
            const cv::Mat image = imageOf(truth, 0.5 + 0.1 * seed, 2, seed);
            // Half a cell beside it, and somewhat turned.
            Matrix3d start =
                mapOf(halfPx * 1.03, position + halfPx / 8 * Vector2d(0.5, -0.4 * flatness), flatness);
            start(0, 1) += 0.02 * halfPx;
            const auto aligned = alignTag(image, *tagCells({TagFamily::AprilTag36h11, number}), start);
            QVERIFY(aligned.has_value());
            const double error = (aligned->middle() - position).norm();
            QVERIFY2(error < mostPx, qPrintable(QString::number(error)));
            QVERIFY(aligned->likeness > 0.9);
            // The stated one is of noise alone.
            QVERIFY2(aligned->sigmaPx > 0.05 * error && aligned->sigmaPx < mostPx,
                     qPrintable(QString::number(aligned->sigmaPx)));
        }
    }
    void isNotLikeAnotherTagOrABareFloor()
    {
        const Matrix3d truth = mapOf(30, {98, 80});
        const auto other =
            alignTag(imageOf(truth, 0.5, 2, 1), *tagCells({TagFamily::AprilTag36h11, number + 1}), truth);
        QVERIFY2(!other || other->likeness < 0.7, qPrintable(QString::number(other->likeness)));
        cv::Mat bare(160, 200, CV_8U);
        cv::randn(bare, 128, 6);
        const auto none = alignTag(bare, *tagCells({TagFamily::AprilTag36h11, number}), truth);
        QVERIFY2(!none || none->likeness < 0.5, qPrintable(QString::number(none->likeness)));
        const auto flat = alignTag(cv::Mat(160, 200, CV_8U, cv::Scalar(128)),
                                   *tagCells({TagFamily::AprilTag36h11, number}), truth);
        QVERIFY(!flat || flat->likeness < 0.5);
    }
    void refusesWhatReachesBeyondThePictureOrIsNoMap()
    {
        const cv::Mat image = imageOf(mapOf(30, {98, 80}), 0.5, 2, 1);
        QVERIFY(
            !alignTag(image, *tagCells({TagFamily::AprilTag36h11, number}), mapOf(30, {20, 80})).has_value());
        QVERIFY(
            !alignTag(image, *tagCells({TagFamily::AprilTag36h11, number}), mapOf(1, {98, 80})).has_value());
        QVERIFY(
            !alignTag(image, *tagCells({TagFamily::AprilTag36h11, number}), Matrix3d::Zero()).has_value());
        QVERIFY(
            !alignTag(image, *tagCells({TagFamily::AprilTag36h11, number}), Matrix3d::Constant(std::nan("")))
                 .has_value());
        Matrix3d beyond = mapOf(30, {98, 80});
        beyond(2, 0) = 1.2; // its left side lies beyond the horizon
        QVERIFY(!alignTag(image, *tagCells({TagFamily::AprilTag36h11, number}), beyond).has_value());
    }
};

ODOGRAPH_TEST(TestTagAlignment, QCoreApplication)
#include "tst_tag_alignment.moc"
