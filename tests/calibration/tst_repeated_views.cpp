// SPDX-License-Identifier: GPL-3.0-or-later
// Images that show the board in the same position count once: copies change nothing, and frames of a board
// held still are as sure as they state.
#include "core/calibration/intrinsic_calibration.h"
#include "core/calibration/repeated_views.h"
#include "tests/calibration/seen_boards.h"
#include "tests/calibration/true_lens.h"
#include "tests/support/contains.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <numeric>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

constexpr int widthPx = 1280, heightPx = 720;

Result<IntrinsicCalibration> calibrate(const std::vector<BoardView> &views,
                                       std::optional<LensModel> model = LensModel::Standard)
{
    return calibrateIntrinsics(views, widthPx, heightPx, model, JobControl());
}

/// Three that determine the lens.
std::vector<BoardView> threeViews()
{
    std::mt19937 random(3);
    std::vector<BoardView> views{see(trueCamera(), {-0.15, -0.05, 0.55}, 0.6, 0.2, 0, random, 0.2),
                                 see(trueCamera(), {0.15, 0.06, 0.6}, -0.2, -0.7, 0.4, random, 0.2),
                                 see(trueCamera(), {0, 0, 0.5}, -0.5, 0.5, 1.2, random, 0.2)};
    for (std::size_t i = 0; i < views.size(); ++i)
        views[i].source = "picture" + std::to_string(i);
    return views;
}

std::vector<BoardView> times(const std::vector<BoardView> &views, int count)
{
    std::vector<BoardView> all;
    for (int i = 0; i < count; ++i)
        all.insert(all.end(), views.begin(), views.end());
    return all;
}

/// Twelve frames of a board that is held somewhere by a hand; it moves them by so much and turns the board as
/// much at its edge. Each corner has an error that is common to the frames, and one of its own.
void holdStill(std::vector<BoardView> &views, unsigned seed, double noisePx, double commonPx, double handM)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> across(-1, 1);
    const double depth = 0.55 + 0.25 * across(random), edgeM = 0.12;
    const Eigen::Vector3d middle(0.4 * depth * across(random), 0.22 * depth * across(random), depth);
    const Eigen::Vector3d turns(0.7 * across(random), 0.7 * across(random), 3 * across(random));
    const auto any = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)); };
    std::vector<Vector2d> common;
    for (int i = 0; i < 54; ++i)
        common.push_back(commonPx * any().head<2>());
    for (int frame = 0; frame < 12; ++frame) {
        const Eigen::Vector3d at = middle + handM * any(), turned = turns + handM / edgeM * any();
        views.push_back(see(trueCamera(), at, turned.x(), turned.y(), turned.z(), random, noisePx));
        for (std::size_t i = 0; i < views.back().pixels.size(); ++i)
            views.back().pixels[i] += common[i];
    }
}

BoardView boardAt(double x, double tilt)
{
    std::mt19937 random(1);
    return see(trueCamera(), {x, 0, 0.6}, tilt, 0, 0.2, random, 0);
}

void compareLenses(const Intrinsics &one, const Intrinsics &other)
{
    QVERIFY(std::abs(one.fxPx - other.fxPx) < 1e-6);
    QVERIFY(std::abs(one.cyPx - other.cyPx) < 1e-6);
    QVERIFY((one.covariance - other.covariance).norm() < 1e-6 * other.covariance.norm());
}

} // namespace

class TestRepeatedViews : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void copiesOfThreeImagesAddNothing()
    {
        const auto alone = calibrate(threeViews()), copied = calibrate(times(threeViews(), 12));
        QVERIFY2(alone && copied, copied ? "" : copied.error().message().c_str());
        qInfo("%s", copied->verdict.english().c_str());
        compareLenses(copied->intrinsics, alone->intrinsics);
        QCOMPARE(copied->rmsPx, alone->rmsPx);
        QCOMPARE(copied->crossValidationPx, 0.0);
        QVERIFY(!copied->halvesApart);
        QCOMPARE(copied->onFloor->worstM, alone->onFloor->worstM);
        QCOMPARE(copied->images.size(), std::size_t(36));
        QCOMPARE(copied->imagesUsed(), std::size_t(3));
        QCOMPARE(copied->imagesRepeated(), std::size_t(33));
        QCOMPARE(alone->imagesRepeated(), std::size_t(0));
        QVERIFY(contains(copied->verdict.english(), "; 3 images fit to"));
        QVERIFY(contains(copied->verdict.english(),
                         "33 of 36 images show the board in the same position as another one, and each "
                         "position counts once."));
        QCOMPARE(copied->images[5].repeats.english(),
                 std::string("the board is in the same position as in picture2"));
        QVERIFY(std::abs(copied->images[5].rmsPx - copied->images[2].rmsPx) < 1e-6);
        QVERIFY(alone->verdict.english().find("same position") == std::string::npos);
    }
    void copiesOfManyImagesAddNothing_data()
    {
        QTest::addColumn<bool>("neighbours");
        QTest::newRow("one after the other") << false;
        QTest::newRow("each beside its copies") << true; // even and odd images were the same boards
    }
    void copiesOfManyImagesAddNothing()
    {
        QFETCH(bool, neighbours);
        const std::vector<BoardView> views = tiltedViews(trueCamera(), 10, 0.2, 21);
        std::vector<BoardView> copies = times(views, 4);
        if (neighbours)
            std::ranges::stable_sort(copies, {}, &BoardView::source);
        const auto alone = calibrate(views, std::nullopt), copied = calibrate(copies, std::nullopt);
        QVERIFY2(alone && copied, copied ? "" : copied.error().message().c_str());
        compareLenses(copied->intrinsics, alone->intrinsics);
        QCOMPARE(copied->imagesUsed(), std::size_t(10));
        QCOMPARE(copied->crossValidationPx, alone->crossValidationPx);
        QCOMPARE(copied->halvesApart->worstM, alone->halvesApart->worstM);
        QCOMPARE(copied->modelTrials.size(), alone->modelTrials.size());
        for (std::size_t i = 0; i < alone->modelTrials.size(); ++i)
            QCOMPARE(copied->modelTrials[i].heldOutPx, alone->modelTrials[i].heldOutPx);
        QCOMPARE(copied->modelReason, alone->modelReason);
    }
    void aSingleCopyIsToldAsOne()
    {
        std::vector<BoardView> views = tiltedViews(trueCamera(), 12, 0.2, 22);
        views.push_back(views[4]);
        const auto result = calibrate(views);
        QVERIFY(result.has_value());
        QVERIFY(contains(result->verdict.english(), " 1 of 13 images shows the board in the same position"));
    }
    void copiesChangeNoRefusal()
    {
        std::mt19937 random(5);
        std::vector<BoardView> views;
        for (const double x : {-0.15, 0.0, 0.15})
            views.push_back(see(trueCamera(), {x, 0.5 * x, 0.6}, 0.05, -0.03, 0.1, random, 0.2));
        const auto alone = calibrate(views), copied = calibrate(times(views, 12));
        QVERIFY(!alone && !copied);
        const std::string counts = "; 33 of 36 images show the board in the same position as another one, "
                                   "and each position counts once";
        QCOMPARE(copied.error().why.english(), alone.error().why.english() + counts);
        QCOMPARE(copied.error().advice, alone.error().advice);
        views.pop_back();
        const auto two = calibrate(times(views, 18));
        QVERIFY(!two);
        QVERIFY(contains(two.error().message(), "needs three images of the board, 2 can be used; 34 of 36"));
    }
    void imagesThatCannotBeUsedTakeTheirCopiesAlong()
    {
        std::vector<BoardView> views = tiltedViews(trueCamera(), 10, 0.1);
        for (Vector2d &point : views[8].pointsOnBoard)
            point.y() = 0;
        const auto result = calibrate(times(views, 2));
        QVERIFY(result.has_value());
        QCOMPARE(result->rejected.size(), std::size_t(2));
        QCOMPARE(result->images.size(), std::size_t(18));
        QCOMPARE(result->imagesUsed(), std::size_t(9));
        QCOMPARE(result->imagesRepeated(), std::size_t(9));
    }
    void framesOfABoardHeldStillAreAsSureAsTheyState_data()
    {
        QTest::addColumn<double>("noisePx");
        QTest::addColumn<double>("commonPx"); // the same in all frames of a position: bent board, blur
        QTest::addColumn<double>("handM");    // along each axis
        QTest::newRow("new noise only") << 0.2 << 0.0 << 0.0;
        QTest::newRow("errors in common") << 0.1 << 0.2 << 0.0;
        QTest::newRow("held in a hand") << 0.1 << 0.2 << 0.001;
    }
    void framesOfABoardHeldStillAreAsSureAsTheyState()
    {
        QFETCH(double, noisePx);
        QFETCH(double, commonPx);
        QFETCH(double, handM);
        constexpr int sets = 100;
        int inside = 0;
        std::size_t used = 0;
        for (unsigned set = 0; set < sets; ++set) {
            std::vector<BoardView> views;
            for (unsigned position = 0; position < 10; ++position)
                holdStill(views, 100 * set + position, noisePx, commonPx, handM);
            const auto result = calibrate(views);
            QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
            inside += std::abs(result->intrinsics.fxPx - trueCamera().intrinsics().fxPx) <
                      1.96 * std::sqrt(result->intrinsics.covariance(0, 0));
            used += result->imagesUsed();
        }
        qInfo("inside the stated 95 %%: %d of %d; of 120 images %.1f counted", inside, sets,
              double(used) / sets);
        QVERIFY2(inside >= 0.89 * sets, qPrintable(QString::number(inside)));
        QVERIFY(used >= 10 * sets && used < 12 * sets);
    }
    void boardsThatMovedAllCount()
    {
        for (unsigned seed = 1; seed <= 40; ++seed)
            QCOMPARE(positionsIn(tiltedViews(trueCamera(), 20, 0.2, seed)).repeats(), std::size_t(0));
        // 0.24 m wide, a square 0.03 m: a step of 3 % of it, of exactly a square, and a tilt by 12 degrees.
        QVERIFY(!repeatsPosition(boardAt(0, 0.4), boardAt(0.0075, 0.4)));
        QVERIFY(!repeatsPosition(boardAt(0, 0), boardAt(0.03 * std::cos(0.2), 0)));
        QVERIFY(!repeatsPosition(boardAt(0, 0.4), boardAt(0, 0.6)));
        // On a turntable, a metre away: by ten degrees each.
        std::vector<BoardView> turned;
        std::mt19937 random(1);
        for (int i = -4; i <= 4; ++i)
            turned.push_back(see(trueCamera(), {0.05, 0.02, 1}, 0, i * EIGEN_PI / 18, 0, random, 0.2));
        QCOMPARE(positionsIn(turned).repeats(), std::size_t(0));
        QVERIFY(repeatsPosition(boardAt(0, 0.4), boardAt(0.002, 0.41)));
    }
    void cornersAreMatchedWhereTheyAre()
    {
        const BoardView whole = boardAt(0, 0.4);
        BoardView turned = whole, part = whole;
        std::ranges::reverse(turned.pixels);
        QVERIFY(repeatsPosition(turned, whole));
        part.pixels.resize(36); // four of six rows
        part.pointsOnBoard.resize(36);
        QVERIFY(repeatsPosition(part, whole));
        QVERIFY(!repeatsPosition(whole, part));
        const BoardPositions positions = positionsIn({part, whole, turned});
        QCOMPARE(positions.counting, std::vector<std::size_t>{1}); // the most corners
        QCOMPARE(positions.shownBy, (std::vector<std::size_t>{1, 1, 1}));
        BoardView misread = whole;
        for (std::size_t i : {3u, 20u, 21u, 40u})
            misread.pixels[i].x() += 15;
        QVERIFY(repeatsPosition(misread, whole));
        QVERIFY(positionsIn({}).counting.empty());
    }
    void aBoardThatMovesSlowlyCountsAgainAndAgain()
    {
        std::vector<BoardView> views;
        for (int i = 0; i < 90; ++i) // by 1 mm a frame; three steps of 2 % of the board are 17 mm
            views.push_back(boardAt(0.001 * i - 0.045, 0.4));
        const std::size_t counting = positionsIn(views).counting.size();
        QVERIFY2(counting >= 5 && counting <= 8, qPrintable(QString::number(counting)));
    }
    void copiesChangeNothingOfAChoice()
    {
        const std::vector<BoardView> views = tiltedViews(trueCamera(), 12, 0.2, 23);
        const auto alone = calibrate(views), copied = calibrate(times(views, 3));
        QVERIFY(alone && copied);
        std::vector<std::size_t> all(36), some, originals;
        std::iota(all.begin(), all.end(), std::size_t(0));
        for (std::size_t i : all) {
            if (i % 12 >= 2)
                some.push_back(i);
        }
        const auto again = recalibrate(*copied, all, JobControl());
        QVERIFY(again.has_value());
        QCOMPARE(again->imagesUsed(), std::size_t(12));
        QVERIFY(std::abs(again->intrinsics.fxPx - alone->intrinsics.fxPx) < 1e-4);
        originals.assign({2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
        const auto fewer = recalibrate(*copied, some, JobControl()),
                   fewerAlone = recalibrate(*alone, originals, JobControl());
        QVERIFY(fewer && fewerAlone);
        QCOMPARE(fewer->imagesUsed(), std::size_t(10));
        QCOMPARE(fewer->imagesRepeated(), std::size_t(20));
        QVERIFY(fewer->images[0].repeats.isEmpty() && !fewer->images[0].used); // it was not chosen
        QVERIFY(std::abs(fewer->intrinsics.covariance(0, 0) / fewerAlone->intrinsics.covariance(0, 0) - 1) <
                1e-4);
        // A copy stands in for an image that was left out.
        std::vector<std::size_t> copies(all.begin() + 12, all.end());
        const auto others = recalibrate(*copied, copies, JobControl());
        QVERIFY(others && !others->images[0].used && others->images[12].used);
        QVERIFY(std::abs(others->intrinsics.fxPx - alone->intrinsics.fxPx) < 1e-4);
    }
};

ODOGRAPH_TEST(TestRepeatedViews, QCoreApplication)
#include "tst_repeated_views.moc"
