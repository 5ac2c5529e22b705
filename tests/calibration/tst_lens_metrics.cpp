// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsic_calibration.h"
#include "tests/calibration/seen_boards.h"
#include "tests/calibration/true_lens.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QTest>
#include <array>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

constexpr int widthPx = 1280, heightPx = 720;

CameraModel camera(LensModel model, std::vector<double> distortion)
{
    return CameraModel::create(trueLens(model, std::move(distortion))).value();
}

CameraModel ordinary()
{
    return trueCamera();
}

Result<IntrinsicCalibration> calibrate(const std::vector<BoardView> &views,
                                       std::optional<LensModel> model = std::nullopt)
{
    return calibrateIntrinsics(views, widthPx, heightPx, model, JobControl());
}

/// Moves so many corners of all pictures by 4 to 12 px in any direction; their numbers counted over all
/// pictures.
std::vector<std::size_t> misread(std::vector<BoardView> &views, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> angle(0, 6.28318530718), length(4, 12);
    std::vector<std::size_t> all(views.size() * 54);
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    std::shuffle(all.begin(), all.end(), random);
    all.resize(count);
    for (std::size_t corner : all) {
        const double a = angle(random), by = length(random);
        views[corner / 54].pixels[corner % 54] += by * Vector2d(std::cos(a), std::sin(a));
    }
    std::ranges::sort(all);
    return all;
}

} // namespace

/// What a calibration states, against the truth.
class TestLensMetrics : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theStatedIntervalHoldsTheTruth()
    {
        constexpr double noisePx = 0.15;
        const CameraModel truth = ordinary();
        const Intrinsics &in = truth.intrinsics();
        const Eigen::Vector4d wanted(in.fxPx, in.fyPx, in.cxPx, in.cyPx);
        constexpr int sets = 200;
        std::array<int, 4> inside{};
        double worstFocal = 0, worstCentre = 0;
        for (unsigned set = 0; set < sets; ++set) {
            const auto result = calibrate(tiltedViews(truth, 20, noisePx, 1000 + set), LensModel::Standard);
            QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
            const Intrinsics &found = result->intrinsics;
            const Eigen::Vector4d values(found.fxPx, found.fyPx, found.cxPx, found.cyPx);
            for (int i = 0; i < 4; ++i)
                inside[std::size_t(i)] +=
                    std::abs(values[i] - wanted[i]) < 1.96 * std::sqrt(found.covariance(i, i));
            worstFocal = std::max(
                {worstFocal, std::abs(values[0] / wanted[0] - 1), std::abs(values[1] / wanted[1] - 1)});
            worstCentre = std::max(worstCentre, (values.tail<2>() - wanted.tail<2>()).cwiseAbs().maxCoeff());
        }
        qInfo("%g px: inside the stated 95 %%: fx %.1f, fy %.1f, cx %.1f, cy %.1f %%; worst of %d sets: "
              "focal length "
              "%.3f %%, principal point %.2f px",
              noisePx, inside[0] / 2.0, inside[1] / 2.0, inside[2] / 2.0, inside[3] / 2.0, sets,
              100 * worstFocal, worstCentre);
        for (int i = 0; i < 4; ++i)
            QVERIFY2(inside[std::size_t(i)] >= 184 && inside[std::size_t(i)] <= 197,
                     qPrintable(QString::number(i)));
        QVERIFY(worstFocal < 0.003);
        QVERIFY(worstCentre < 3);
    }
    void theFloorFigureHoldsTheTruth()
    {
        // Lenses measured from noisy boards, each registered on the typical testbed, against the true one.
        const CameraModel truth = ordinary();
        double middle = 0, statedMiddle = 0, worst = 0, statedWorst = 0;
        constexpr int sets = 30;
        for (unsigned set = 0; set < sets; ++set) {
            const auto result = calibrate(tiltedViews(truth, 14, 0.2, 5000 + set), LensModel::Standard);
            QVERIFY(result && result->onFloor);
            const auto apart = apartOnFloor(truth.intrinsics(), result->intrinsics);
            QVERIFY(apart.has_value());
            middle += std::pow(apart->middleM, 2) / sets;
            statedMiddle += std::pow(result->onFloor->middleM, 2) / sets;
            worst += std::pow(apart->worstM, 2) / sets;
            statedWorst += std::pow(result->onFloor->worstM, 2) / sets;
            QVERIFY(result->onFloor->worstM >= result->onFloor->middleM);
            QVERIFY(!result->onFloor->worstWhere.isEmpty());
        }
        // The error is of two coordinates, the stated σ the larger of them: a ratio between 1 and sqrt(2).
        const double ratio = std::sqrt(middle / statedMiddle);
        qInfo(
            "error in the middle of the floor %.2f mm RMS, stated %.2f mm; at worst %.2f mm, stated %.2f mm",
            1000 * std::sqrt(middle), 1000 * std::sqrt(statedMiddle), 1000 * std::sqrt(worst),
            1000 * std::sqrt(statedWorst));
        QVERIFY2(ratio > 0.7 && ratio < 1.7, qPrintable(QString::number(ratio)));
    }
    void theModelIsChosenByWhatItForetells_data()
    {
        QTest::addColumn<int>("model");
        QTest::addColumn<QVector<double>>("distortion");
        QTest::addColumn<QString>("words");
        QTest::newRow("standard") << int(LensModel::Standard)
                                  << QVector<double>{-0.28, 0.11, 0.001, -0.0007, -0.02}
                                  << QStringLiteral("Standard lens: it predicts held-out images to ");
        QTest::newRow("without distortion")
            << int(LensModel::Standard) << QVector<double>{}
            << QStringLiteral("Standard lens: it predicts held-out images to ");
        QTest::newRow("fisheye") << int(LensModel::Fisheye) << QVector<double>{0.35, -0.3, 0.25, -0.1}
                                 << QStringLiteral("Fisheye lens: it predicts held-out images to ");
    }
    void theModelIsChosenByWhatItForetells()
    {
        QFETCH(int, model);
        QFETCH(QVector<double>, distortion);
        QFETCH(QString, words);
        Intrinsics lens = camera(LensModel(model), {distortion.begin(), distortion.end()}).intrinsics();
        if (LensModel(model) != LensModel::Standard)
            lens.fxPx = lens.fyPx = 500; // so wide that its bending shows
        const CameraModel truth = CameraModel::create(lens).value();
        int right = 0;
        constexpr int sets = 4;
        for (unsigned set = 0; set < sets; ++set) {
            std::vector<BoardView> views = tiltedViews(truth, 20, 0.15, 300 + set);
            if (LensModel(model) != LensModel::Standard) {
                std::mt19937 random(set);
                std::uniform_real_distribution<double> across(-1, 1);
                for (int i = 0; i < 12; ++i) {
                    views.push_back(see(truth, {0.32 * (i % 4 - 1.5) / 1.5, 0.13 * (i / 4 - 1), 0.32},
                                        0.5 * across(random), 0.5 * across(random), 0, random, 0.15));
                    views.back().source = "wide" + std::to_string(i);
                }
            }
            const auto result = calibrate(views);
            QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
            if (set == 0)
                qInfo("%s", result->verdict.english().c_str());
            QCOMPARE(result->modelTrials.size(), std::size_t(3));
            right += result->intrinsics.model == LensModel(model);
            if (result->intrinsics.model == LensModel(model))
                QVERIFY(contains(result->verdict.english(), words.toStdString()));
        }
        qInfo("right in %d of %d sets", right, sets);
        QVERIFY(right >= sets - 1);
    }
    void fewCornersThatStandOutAreLeftOut()
    {
        const CameraModel truth = ordinary();
        std::vector<BoardView> views = tiltedViews(truth, 20, 0.2, 77);
        const auto clean = calibrate(views);
        const std::vector<std::size_t> moved = misread(views, 22, 3); // 2 %
        const auto result = calibrate(views);
        QVERIFY2(clean && result, result ? "" : result.error().message().c_str());
        std::vector<std::size_t> leftOut;
        for (std::size_t i = 0; i < result->images.size(); ++i)
            for (std::size_t corner : result->images[i].leftOut)
                leftOut.push_back(54 * i + corner);
        QCOMPARE(leftOut, moved);
        QCOMPARE(result->cornersLeftOut(), std::size_t(22));
        QVERIFY(contains(result->verdict.english(), "22 outlier corners were left out, most in picture"));
        QVERIFY(std::abs(result->intrinsics.fxPx - clean->intrinsics.fxPx) < 0.5);
        QVERIFY(std::abs(result->rmsPx - clean->rmsPx) < 0.01);
        const CalibrationImage &image = result->images[moved.front() / 54];
        QCOMPARE(image.residualsPx.size(), std::size_t(54));
        QVERIFY(image.residualsPx[moved.front() % 54].norm() > 3.5);
    }
    void moreOutlierCornersAreLeftOutButNotCalledGood()
    {
        std::vector<BoardView> views = tiltedViews(ordinary(), 20, 0.2, 78);
        const auto clean = calibrate(views);
        misread(views, 76, 4); // 7 %
        const auto result = calibrate(views);
        QVERIFY2(clean && result, result ? "" : result.error().message().c_str());
        QVERIFY2(contains(result->verdict.english(), " outlier corners were left out, most in picture"),
                 result->verdict.english().c_str());
        QVERIFY(result->cornersLeftOut() >= 76 && result->cornersLeftOut() < 100); // with their outer rows
        QVERIFY(!result->verdict.english().starts_with("Good"));
        QVERIFY(std::abs(result->intrinsics.fxPx - clean->intrinsics.fxPx) < 0.5);
    }
    void manyOutlierCornersAreKeptAndNamed()
    {
        std::vector<BoardView> views = tiltedViews(ordinary(), 20, 0.2, 78);
        misread(views, 140, 4); // 13 %
        const auto result = calibrate(views);
        QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
        QVERIFY(contains(result->verdict.english(), "13 % of the corners disagree, most in picture"));
        QVERIFY(contains(result->verdict.english(), "they were kept"));
        QVERIFY(!result->verdict.english().starts_with("Good"));
        QCOMPARE(result->cornersLeftOut(), std::size_t(0));
        QVERIFY(std::abs(result->disagreeingPart - 140.0 / 1080) < 0.005);
    }
    /// As where the outer squares are narrower than the others.
    void anOuterRowThatIsMovedIsLeftOut()
    {
        std::vector<BoardView> views = tiltedViews(ordinary(), 20, 0.2, 79);
        const auto clean = calibrate(views);
        for (std::size_t corner : {0u, 1u, 2u, 3u, 4u})
            views[6].pixels[corner] += Vector2d(0.5, 4);
        const auto result = calibrate(views);
        QVERIFY(clean && result);
        QCOMPARE(result->images[6].outliers, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
        QCOMPARE(result->images[6].leftOut, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
        QVERIFY(contains(result->verdict.english(), "9 outlier corners were left out, in picture6 (9)."));
        QVERIFY(!contains(result->verdict.english(), "kept"));
        QVERIFY2(std::abs(result->intrinsics.fxPx - clean->intrinsics.fxPx) <
                     std::sqrt(result->intrinsics.covariance(0, 0)),
                 qPrintable(QString::number(result->intrinsics.fxPx - clean->intrinsics.fxPx)));
    }
    void aBoardThatIsBentInOneImageIsNamed_data()
    {
        QTest::addColumn<double>("bend");
        QTest::addColumn<QString>("words");
        QTest::newRow("a little") << 0.03 << QStringLiteral("picture6");
        QTest::newRow("more") << 0.06 << QStringLiteral("picture6");
        QTest::newRow("much") << 0.6 << QStringLiteral("Left out: picture6 (its corners are ");
    }
    void aBoardThatIsBentInOneImageIsNamed()
    {
        QFETCH(double, bend);
        QFETCH(QString, words);
        std::vector<BoardView> views = tiltedViews(ordinary(), 40, 0.2, 79);
        const auto clean = calibrate(views);
        for (std::size_t corner = 0; corner < 54; ++corner)
            views[6].pixels[corner] += Vector2d(0, bend * std::pow(double(corner % 9), 2));
        const auto result = calibrate(views);
        QVERIFY2(result, result ? "" : result.error().message().c_str());
        QVERIFY2(contains(result->verdict.english(), words.toStdString()), result->verdict.english().c_str());
        QVERIFY2(std::abs(result->intrinsics.fxPx - clean->intrinsics.fxPx) <
                     2 * std::sqrt(result->intrinsics.covariance(0, 0)),
                 qPrintable(QString::number(result->intrinsics.fxPx - clean->intrinsics.fxPx)));
    }
    /// k3 that may be nothing takes part of the focal length with it.
    void aSixthOrderThatIsNotSignificantIsLeftOut()
    {
        const auto result = calibrate(tiltedViews(ordinary(), 20, 0.2, 81));
        QVERIFY(result.has_value());
        QCOMPARE(result->intrinsics.model, LensModel::Standard);
        QCOMPARE(result->intrinsics.distortion[4], 0.0);
        QVERIFY(result->intrinsics.covariance(8, 8) > 0);
        Intrinsics curved = ordinary().intrinsics();
        curved.distortion[4] = -0.2;
        const auto other =
            calibrate(tiltedViews(*CameraModel::create(curved), 20, 0.2, 81), LensModel::Standard);
        QVERIFY2(other, other ? "" : other.error().message().c_str());
        QVERIFY(std::abs(other->intrinsics.distortion[4] + 0.2) <
                3 * std::sqrt(other->intrinsics.covariance(8, 8)));
        QVERIFY(other->intrinsics.distortion[4] != 0);
    }
    void picturesAreLeftOutByAThreshold()
    {
        const CameraModel truth = ordinary();
        std::vector<BoardView> views = tiltedViews(truth, 40, 0.2, 80);
        std::mt19937 random(9);
        std::normal_distribution<double> noise(0, 0.8);
        for (std::size_t i : {4u, 11u}) // shaken
            for (Vector2d &pixel : views[i].pixels)
                pixel += Vector2d(noise(random), noise(random));
        const auto all = calibrate(views);
        QVERIFY(all.has_value());
        const std::vector<std::size_t> chosen = imagesWithin(*all, 0.6);
        QCOMPARE(chosen.size(), std::size_t(38));
        QElapsedTimer timer;
        timer.start();
        const auto fewer = recalibrate(*all, chosen, JobControl());
        qInfo("calibrated again from 38 pictures in %lld ms", timer.elapsed());
        QVERIFY2(fewer.has_value(), fewer ? "" : fewer.error().message().c_str());
        QCOMPARE(fewer->imagesUsed(), std::size_t(38));
        QCOMPARE(fewer->images.size(), std::size_t(40));
        QVERIFY(!fewer->images[4].used && !fewer->images[11].used);
        QVERIFY(fewer->images[4].rmsPx > 0.8); // as foretold by the others
        QVERIFY(fewer->rmsPx < 0.3);
        QCOMPARE(fewer->intrinsics.model, all->intrinsics.model);
        // As if it had been calibrated from these alone.
        std::vector<BoardView> some;
        for (std::size_t i : chosen)
            some.push_back(views[i]);
        const auto afresh = calibrate(some, all->intrinsics.model);
        QVERIFY(std::abs(afresh->intrinsics.fxPx - fewer->intrinsics.fxPx) < 1e-3);
        QVERIFY(std::abs(afresh->rmsPx - fewer->rmsPx) < 1e-6);
        // And back: the two shaken pictures return.
        std::vector<std::size_t> everything(40);
        for (std::size_t i = 0; i < everything.size(); ++i)
            everything[i] = i;
        const auto back = recalibrate(*fewer, everything, JobControl());
        QVERIFY(back && std::abs(back->intrinsics.fxPx - all->intrinsics.fxPx) < 1e-3);
        QVERIFY(!recalibrate(*all, {0, 1}, JobControl()).has_value());
        JobControl stopped;
        stopped.cancel.cancel();
        QCOMPARE(recalibrate(*all, chosen, stopped).error().code, ErrorCode::Cancelled);
    }
    void refusesABoardThatStaysInOnePlace()
    {
        const CameraModel truth = ordinary();
        std::mt19937 random(12);
        std::uniform_real_distribution<double> across(-1, 1);
        std::vector<BoardView> views;
        for (int i = 0; i < 12; ++i)
            views.push_back(
                see(truth, {-0.55, -0.27, 1.1}, 0.7 * across(random), 0.7 * across(random), 0, random, 0.1));
        const auto result = calibrate(views);
        QVERIFY2(!result.has_value(), result ? result->verdict.english().c_str() : "");
        QVERIFY(
            contains(result.error().message(), "12 images show the board in one position, the upper left"));
    }
    void refusesPicturesOfTwoZooms()
    {
        Intrinsics other = ordinary().intrinsics();
        other.fxPx *= 1.3;
        other.fyPx *= 1.3;
        std::vector<BoardView> views = tiltedViews(ordinary(), 10, 0.2, 81);
        for (BoardView &view : tiltedViews(CameraModel::create(other).value(), 10, 0.2, 82))
            views.push_back(view);
        const auto result = calibrate(views);
        QVERIFY2(!result.has_value(), result ? result->verdict.english().c_str() : "");
        QVERIFY(contains(result.error().message(), "do not agree on one focal length"));
    }
    void theFloorFiguresOfOddLensesAreNoneRatherThanWrong()
    {
        QVERIFY(!expectedOnFloor(ordinary().intrinsics()).has_value()); // no covariance
        Intrinsics telescope = ordinary().intrinsics();
        telescope.fxPx = telescope.fyPx = 60000;
        QVERIFY(!typicalTestbed(CameraModel::create(telescope).value()).has_value());
        const auto same = apartOnFloor(ordinary().intrinsics(), ordinary().intrinsics());
        QVERIFY(same && same->worstM < 1e-6);
        QVERIFY(typicalTestbed(ordinary()).has_value());
    }
};

ODOGRAPH_TEST(TestLensMetrics, QCoreApplication)
#include "tst_lens_metrics.moc"
