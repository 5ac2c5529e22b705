// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsic_calibration.h"
#include "tests/calibration/seen_boards.h"
#include "tests/calibration/true_lens.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QTest>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int widthPx = 1280, heightPx = 720;

} // namespace

class TestIntrinsicCalibration : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void exactCornersGiveTheLensBack_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<QVector<double>>("distortion");
        QTest::newRow("standard") << int(LensModel::Standard)
                                  << QVector<double>{-0.28, 0.11, 0.001, -0.0007, -0.02};
        QTest::newRow("rational") << int(LensModel::Rational)
                                  << QVector<double>{0.3, 0.05, 0.0005, -0.0004, 0.01, 0.55, 0.1, 0.02};
        QTest::newRow("fisheye") << int(LensModel::Fisheye) << QVector<double>{-0.02, 0.01, -0.004, 0.001};
    }
    void exactCornersGiveTheLensBack()
    {
        QFETCH(int, model);
        QFETCH(QVector<double>, distortion);
        const Intrinsics truth = trueLens(LensModel(model), {distortion.begin(), distortion.end()});
        const CameraModel camera = CameraModel::create(truth).value();
        const auto result = calibrateIntrinsics(tiltedViews(camera, 14, 0), widthPx, heightPx,
                                                LensModel(model), JobControl());
        QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
        QVERIFY2(result->rmsPx < 1e-3, qPrintable(QString::number(result->rmsPx)));
        QVERIFY(std::abs(result->intrinsics.fxPx - truth.fxPx) < 0.05);
        QVERIFY(std::abs(result->intrinsics.fyPx - truth.fyPx) < 0.05);
        const CameraModel found = CameraModel::create(result->intrinsics).value();
        for (double x = -0.4; x <= 0.4;
             x += 0.1) // the coefficients may trade among themselves; the map may not
            QVERIFY((*found.project({x, 0.5 * x, 1}) - *camera.project({x, 0.5 * x, 1})).norm() < 0.02);
    }
    void noiseIsStatedAsItIs()
    {
        const Intrinsics truth = trueLens(LensModel::Standard, {-0.2, 0.06, 0.0005, -0.0003, 0});
        const CameraModel camera = CameraModel::create(truth).value();
        double squares = 0;
        const int draws = 20;
        for (unsigned draw = 0; draw < draws; ++draw) {
            const auto result = calibrateIntrinsics(tiltedViews(camera, 12, 0.2, 100 + draw), widthPx,
                                                    heightPx, LensModel::Standard, JobControl());
            QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
            QVERIFY(std::abs(result->rmsPx - 0.2 * std::sqrt(2.0)) < 0.03);
            QVERIFY2(result->crossValidationPx > 0.25 && result->crossValidationPx < 0.7,
                     qPrintable(QString::number(result->crossValidationPx)));
            squares += std::pow(result->intrinsics.fxPx - truth.fxPx, 2) /
                       result->intrinsics.covariance(0, 0) / draws;
        }
        // Normalised by the stated variance the mean square is 1; 20 draws scatter it by 0.32.
        QVERIFY2(squares > 0.3 && squares < 2.2, qPrintable(QString::number(squares)));
    }
    void theVerdictSpeaksOfFiguresAndNamesTheOddPicture()
    {
        const CameraModel camera =
            CameraModel::create(trueLens(LensModel::Standard, {-0.2, 0.06, 0, 0})).value();
        std::vector<BoardView> views = tiltedViews(camera, 12, 0.1);
        for (std::size_t i = 0; i < views[7].pixels.size(); i += 2)
            views[7].pixels[i].x() += 1.5;
        const auto result = calibrateIntrinsics(views, widthPx, heightPx, LensModel::Standard, JobControl());
        QVERIFY(result.has_value());
        QVERIFY(contains(result->verdict.english(), "12 images fit to 0."));
        QVERIFY(contains(result->verdict.english(), "Check picture7"));
        QVERIFY(contains(result->verdict.english(), "each half of the images predicts the other to"));
        QCOMPARE(result->imagesUsed(), std::size_t(12));
    }
    void picturesThatCannotBeUsedAreTold()
    {
        const CameraModel camera = CameraModel::create(trueLens(LensModel::Standard, {})).value();
        std::vector<BoardView> views = tiltedViews(camera, 10, 0.1);
        views[3].pixels.resize(4);
        views[5].pixels[2].x() = std::nan("");
        for (Vector2d &point : views[8].pointsOnBoard)
            point.y() = 0;
        const auto result = calibrateIntrinsics(views, widthPx, heightPx, LensModel::Standard, JobControl());
        QVERIFY(result.has_value());
        QCOMPARE(result->rejected.size(), std::size_t(3));
        QCOMPARE(result->imagesUsed(), std::size_t(7));
    }
    void refusesFewerThanThreePictures()
    {
        const CameraModel camera = CameraModel::create(trueLens(LensModel::Standard, {})).value();
        for (int count : {0, 1, 2}) {
            const auto result = calibrateIntrinsics(tiltedViews(camera, count, 0.1), widthPx, heightPx,
                                                    LensModel::Standard, JobControl());
            QVERIFY(!result.has_value());
            QVERIFY(contains(result.error().message(), "calibration needs three images of the board, "));
        }
    }
    void refusesFrontalPictures()
    {
        // The trap: a low RMS with a focal length that is wrong by any factor.
        const CameraModel camera =
            CameraModel::create(trueLens(LensModel::Standard, {-0.1, 0.02, 0, 0})).value();
        for (unsigned seed = 1; seed <= 6; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> across(-1, 1);
            for (double tilt : {0.0, 0.01, 0.03}) {
                std::vector<BoardView> views;
                for (int i = 0; i < 12; ++i)
                    views.push_back(
                        see(camera, {0.15 * across(random), 0.1 * across(random), 0.6 + 0.1 * across(random)},
                            tilt * across(random), tilt * across(random), across(random), random, 0.2));
                const auto result =
                    calibrateIntrinsics(views, widthPx, heightPx, LensModel::Standard, JobControl());
                QVERIFY2(!result.has_value(), result ? result->verdict.english().c_str() : "");
                QCOMPARE(result.error().code, ErrorCode::Undetermined);
                QVERIFY(contains(result.error().message(), "tilted by 30 to 45 degrees"));
            }
        }
    }
    /// One tilt leaves the lens open but for what is usual of lenses: then its focal length, wide or long,
    /// lies inside the stated interval, and the verdict says what was assumed.
    void theUsualLensFillsInWhatOneTiltLeavesOpen()
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> across(-1, 1);
        int accepted = 0, within = 0;
        const int draws = 60;
        for (int draw = 0; draw < draws; ++draw) {
            const double focalPx = 900 * std::exp(0.3 * across(random)), k1 = 0.3 * across(random);
            const Intrinsics truth{widthPx,
                                   heightPx,
                                   focalPx,
                                   focalPx * (1 + 0.006 * across(random)),
                                   639.5 + 30 * across(random),
                                   359.5 + 30 * across(random),
                                   LensModel::Standard,
                                   {k1, -0.3 * k1, 0.002 * across(random), 0.002 * across(random), 0},
                                   {}};
            const CameraModel camera = CameraModel::create(truth).value();
            std::vector<BoardView> views;
            for (int i = 0; i < 8; ++i)
                views.push_back(see(camera, {0.1 * across(random), 0.05 * across(random), focalPx / 1800},
                                    0.7 + 0.03 * across(random), 0.03 * across(random), 3 * across(random),
                                    random, 0.15));
            const auto result = calibrateIntrinsics(views, widthPx, heightPx, std::nullopt, JobControl());
            if (!result)
                continue;
            ++accepted;
            QVERIFY2(contains(result->verdict.english(), "were assumed"), result->verdict.english().c_str());
            within += std::abs(result->intrinsics.fxPx - focalPx) <
                              1.96 * std::sqrt(result->intrinsics.covariance(0, 0))
                          ? 1
                          : 0;
        }
        qInfo("%d of %d accepted, %d of them inside the stated 95 %%", accepted, draws, within);
        QVERIFY(accepted >= draws / 2);
        QVERIFY(within >= 0.88 * accepted); // 0.95 less two σ of the number of draws
    }
    void refusesTheSamePoseAgainAndAgain()
    {
        const CameraModel camera = CameraModel::create(trueLens(LensModel::Standard, {})).value();
        std::mt19937 random(5);
        std::vector<BoardView> views;
        for (int i = 0; i < 12; ++i)
            views.push_back(see(camera, {0.02, 0.01, 0.6}, 0.5, -0.3, 0.1, random, 0.2));
        const auto result = calibrateIntrinsics(views, widthPx, heightPx, LensModel::Standard, JobControl());
        QVERIFY(!result.has_value());
        QVERIFY(contains(result.error().message(), "1 can be used; 11 of 12 images show the board in the "
                                                   "same position as another one"));
    }
    void stopsWhenCancelled()
    {
        const CameraModel camera = CameraModel::create(trueLens(LensModel::Standard, {})).value();
        JobControl control;
        control.progress = [&](double, const Message &) { control.cancel.cancel(); };
        const auto result = calibrateIntrinsics(tiltedViews(camera, 12, 0.1), widthPx, heightPx,
                                                LensModel::Standard, control);
        QVERIFY(!result.has_value());
        QCOMPARE(result.error().code, ErrorCode::Cancelled);
    }
};

ODOGRAPH_TEST(TestIntrinsicCalibration, QCoreApplication)
#include "tst_intrinsic_calibration.moc"
