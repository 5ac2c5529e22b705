// SPDX-License-Identifier: GPL-3.0-or-later
// Where one camera is by another, from boards that both see: against simulated truth.
#include "core/calibration/camera_pair.h"
#include "core/calibration/intrinsic_calibration.h"
#include "tests/calibration/true_lens.h"
#include "tests/support/registered_test.h"

#include <Eigen/LU>
#include <QTest>
#include <cmath>
#include <random>

using namespace odo;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

struct DrawnPairs
{
    CameraModel a, b;
    RigidTransform bFromA;
    std::vector<BoardPair> pairs;
};

struct Drawing
{
    int count = 12;
    double noisePx = 0.2;
    double motionM = 0;    ///< σ by which the board moves between the two frames of a pair, each axis
    bool isTurned = false; ///< every other image of B numbers the board from its other end
    int columns = 9, rows = 6;
    bool isCharuco = false;
};

Intrinsics secondLens()
{
    Intrinsics lens = test::trueLens();
    lens.fxPx = 930.4;
    lens.fyPx = 929.1;
    lens.cxPx = 630.5;
    lens.distortion = {-0.1, 0.02, -0.0004, 0.0002, 0};
    return lens;
}

RigidTransform relation(double baselineM)
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(0.25, Vector3d(0.05, 1, 0.02).normalized())),
            Vector3d(-0.95, 0.02, 0.3).normalized() * baselineM};
}

BoardView viewOf(const CameraModel &camera, const RigidTransform &cameraFromBoard, const Drawing &drawing,
                 bool isTurned, double noisePx, std::mt19937 &random)
{
    std::normal_distribution<double> normal(0, 1);
    BoardView view{"", drawing.columns, drawing.rows, {}, {}};
    view.pattern = drawing.isCharuco ? BoardPattern::Charuco : BoardPattern::Checkerboard;
    for (int y = 0; y < drawing.rows; ++y) {
        for (int x = 0; x < drawing.columns; ++x) {
            const Vector2d label(0.03 * x, 0.03 * y);
            const Vector2d point =
                isTurned ? Vector2d(0.03 * (drawing.columns - 1), 0.03 * (drawing.rows - 1)) - label : label;
            const auto pixel = camera.project(cameraFromBoard * Vector3d(point.x(), point.y(), 0));
            if (!pixel)
                continue;
            view.pixels.push_back(*pixel + noisePx * Vector2d(normal(random), normal(random)));
            view.pointsOnBoard.push_back(label);
        }
    }
    return view;
}

/// A lens known exactly.
CameraModel exact(Intrinsics lens)
{
    const auto size = Eigen::Index(4 + lens.distortion.size());
    lens.covariance = Eigen::MatrixXd::Zero(size, size);
    return CameraModel::create(std::move(lens)).value();
}

DrawnPairs drawn(const Drawing &drawing, unsigned seed, double baselineM = 0.25)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> across(-1, 1);
    std::normal_distribution<double> normal(0, 1);
    DrawnPairs drawn{exact(test::trueLens()), exact(secondLens()), relation(baselineM), {}};
    for (int i = 0; i < drawing.count; ++i) {
        const double depth = 0.7 + 0.2 * across(random);
        RigidTransform aFromBoard;
        aFromBoard.rotation = Eigen::AngleAxisd(0.6 * across(random), Vector3d::UnitX()) *
                              Eigen::AngleAxisd(0.6 * across(random), Vector3d::UnitY()) *
                              Eigen::AngleAxisd(0.4 * across(random), Vector3d::UnitZ());
        aFromBoard.translation =
            Vector3d(0.06 + 0.25 * depth * across(random), 0.2 * depth * across(random), depth) -
            aFromBoard.rotation * Vector3d(0.12, 0.075, 0);
        RigidTransform later = aFromBoard;
        later.translation += drawing.motionM * Vector3d(normal(random), normal(random), normal(random));
        BoardPair pair{viewOf(drawn.a, aFromBoard, drawing, false, drawing.noisePx, random),
                       viewOf(drawn.b, drawn.bFromA * later, drawing, drawing.isTurned && i % 2 == 1,
                              drawing.noisePx, random)};
        pair.a.source = "left" + std::to_string(i);
        pair.b.source = "right" + std::to_string(i);
        drawn.pairs.push_back(std::move(pair));
    }
    return drawn;
}

/// The difference of a relation from the truth, as CameraPair's covariance counts it.
Eigen::Matrix<double, 6, 1> errorOf(const CameraPair &pair, const RigidTransform &truth)
{
    const Eigen::AngleAxisd turn(pair.bFromA.rotation * truth.rotation.conjugate());
    Eigen::Matrix<double, 6, 1> error;
    error << turn.angle() * turn.axis(), pair.bFromA.translation - truth.translation;
    return error;
}

CameraModel calibrated(const std::vector<BoardPair> &pairs, bool ofB)
{
    std::vector<BoardView> views;
    for (const BoardPair &pair : pairs)
        views.push_back(ofB ? pair.b : pair.a);
    const auto calibration = calibrateIntrinsics(views, 1280, 720, LensModel::Standard, {});
    return calibration ? CameraModel::create(calibration->intrinsics).value()
                       : CameraModel::assumed(1280, 720);
}

/// How often chance is tried.
unsigned draws()
{
    const int asked = qEnvironmentVariableIntValue("ODOGRAPH_PAIR_DRAWS");
    return asked > 0 ? unsigned(asked) : 12;
}

/// Of so many true 95 % intervals fewer hold in one of 300 sets.
int leastWithin()
{
    return int(0.95 * draws() - 2.9 * std::sqrt(0.95 * 0.05 * draws()));
}

} // namespace

class TestCameraPair : public QObject
{
    Q_OBJECT

    static void fails(const std::vector<BoardPair> &pairs, const CameraModel &a, const CameraModel &b,
                      const char *message)
    {
        const auto pair = relateCameras(pairs, a, b, {});
        QVERIFY(!pair.has_value());
        QCOMPARE(pair.error().message(), std::string(message));
    }

private Q_SLOTS:
    void withoutNoiseItIsExact()
    {
        Drawing drawing;
        drawing.noisePx = 0;
        const DrawnPairs truth = drawn(drawing, 1);
        const auto pair = relateCameras(truth.pairs, truth.a, truth.b, {});
        QVERIFY2(pair.has_value(), pair ? "" : pair.error().message().c_str());
        QCOMPARE(pair->used.size(), std::size_t(12));
        QVERIFY(errorOf(*pair, truth.bFromA).norm() < 1e-7);
        QVERIFY(std::abs(pair->baselineM - 0.25) < 1e-7 && pair->rmsPx < 1e-6);
        QVERIFY(std::abs(pair->squares.meanM - 0.03) < 1e-7 && pair->squares.sdM < 1e-7);
        QCOMPARE(pair->squares.count, std::size_t(12 * (8 * 6 + 9 * 5)));
    }

    /// Over draws with seeds of their own: the error in σ, with the lenses exact, calibrated from other
    /// images, or from the same ones; and with boards that move between the frames of a pair.
    void sigmaHolds_data()
    {
        QTest::addColumn<int>("lens"); // 0: exact, 1: from other images, 2: from the same
        QTest::addColumn<double>("motionM");
        QTest::addColumn<int>("count");
        QTest::newRow("exact lenses") << 0 << 0.0 << 12;
        QTest::newRow("lenses of other images") << 1 << 0.0 << 12;
        QTest::newRow("lenses of the same images") << 2 << 0.0 << 12;
        QTest::newRow("a board that moves") << 1 << 0.001 << 20;
    }
    void sigmaHolds()
    {
        QFETCH(int, lens);
        QFETCH(double, motionM);
        QFETCH(int, count);
        Drawing drawing;
        drawing.motionM = motionM;
        drawing.count = count;
        int within = 0, within6 = 0;
        double squares = 0, errors = 0, sigmas = 0;
        std::size_t rejected = 0;
        for (unsigned draw = 0; draw < draws(); ++draw) {
            const DrawnPairs truth = drawn(drawing, 1000 + draw);
            const auto &seen = lens == 1 ? drawn(drawing, 5000 + draw).pairs : truth.pairs;
            const CameraModel a = lens == 0 ? truth.a : calibrated(seen, false),
                              b = lens == 0 ? truth.b : calibrated(seen, true);
            const auto pair = relateCameras(truth.pairs, a, b, {});
            QVERIFY2(pair.has_value(), pair ? "" : pair.error().message().c_str());
            rejected += pair->rejected.size();
            const double off = pair->baselineM - 0.25;
            within += std::abs(off) < 1.96 * pair->baselineSigmaM ? 1 : 0;
            squares += std::pow(off / pair->baselineSigmaM, 2);
            errors += off * off;
            sigmas += pair->baselineSigmaM * pair->baselineSigmaM;
            const auto error = errorOf(*pair, truth.bFromA);
            within6 += error.dot(pair->covariance.inverse() * error) < 12.592 ? 1 : 0; // 95 % of χ² of six
        }
        qInfo("baseline: %d of %u within 95 %%, RMS %.2f sigma (error %.3f mm, sigma %.3f mm); all six: %d "
              "within 95 %%; %zu pairs rejected",
              within, draws(), std::sqrt(squares / draws()), 1e3 * std::sqrt(errors / draws()),
              1e3 * std::sqrt(sigmas / draws()), within6, rejected);
        QVERIFY(within >= leastWithin() && within6 >= leastWithin());
        QVERIFY(std::sqrt(squares / draws()) > 0.55); // σ is not far too wide
        QVERIFY(rejected <= draws() * unsigned(count) / 100);
    }

    /// Lenses with errors as imported ones have, which nobody states: σ is wide enough for them.
    void aLensOfUnknownUncertaintyWidensSigma()
    {
        std::mt19937 random(2);
        std::normal_distribution<double> normal(0, 1);
        int within = 0;
        for (unsigned draw = 0; draw < draws(); ++draw) {
            const DrawnPairs truth = drawn({}, 3000 + draw);
            const auto imported = [&](Intrinsics lens) {
                const double focal = 1 + 0.008 * normal(random);
                lens.fxPx *= focal;
                lens.fyPx *= focal;
                lens.cxPx += 5 * normal(random);
                lens.cyPx += 5 * normal(random);
                return CameraModel::create(std::move(lens)).value();
            };
            const auto pair =
                relateCameras(truth.pairs, imported(test::trueLens()), imported(secondLens()), {});
            QVERIFY2(pair.has_value(), pair ? "" : pair.error().message().c_str());
            QVERIFY(!pair->areIntrinsicsSigmasStated);
            within += std::abs(pair->baselineM - 0.25) < 1.96 * pair->baselineSigmaM ? 1 : 0;
        }
        qInfo("%d of %u within 95 %%", within, draws());
        QVERIFY(within >= leastWithin());
    }

    void aBoardNumberedFromItsOtherEndIsTurned_data()
    {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::newRow("9x6") << 9 << 6;
        QTest::newRow("8x6") << 8 << 6;
        QTest::newRow("7x7") << 7 << 7;
    }
    void aBoardNumberedFromItsOtherEndIsTurned()
    {
        QFETCH(int, columns);
        QFETCH(int, rows);
        Drawing drawing;
        drawing.isTurned = true;
        drawing.columns = columns;
        drawing.rows = rows;
        const DrawnPairs truth = drawn(drawing, 7);
        const auto pair = relateCameras(truth.pairs, truth.a, truth.b, {});
        QVERIFY2(pair.has_value(), pair ? "" : pair.error().message().c_str());
        QCOMPARE(pair->used.size(), std::size_t(12));
        QVERIFY(std::abs(pair->baselineM - 0.25) < 5 * pair->baselineSigmaM);
    }

    void aNumberingThatStaysOpenIsRefused()
    {
        Drawing drawing;
        drawing.count = 1;
        const DrawnPairs truth = drawn(drawing, 3);
        fails(truth.pairs, truth.a, truth.b,
              "the relative position of the cameras: the board looks the same when turned by half, and 1 "
              "pairs fit both ways; show it in more positions with different tilts, or use a ChArUco board");
        drawing.isCharuco = true; // names its corners
        const DrawnPairs named = drawn(drawing, 3);
        const auto pair = relateCameras(named.pairs, named.a, named.b, {});
        QVERIFY2(pair.has_value(), pair ? "" : pair.error().message().c_str());
        QVERIFY(std::abs(pair->baselineM - 0.25) < 4 * pair->baselineSigmaM);
    }

    void aPairThatContradictsIsNamed()
    {
        DrawnPairs truth = drawn({}, 9);
        std::swap(truth.pairs[3].b, truth.pairs[8].b); // taken at other moments
        truth.pairs[5].b.pixels.clear();
        truth.pairs[5].b.pointsOnBoard.clear();
        truth.pairs[6].b.pixels = truth.pairs[6].a.pixels;
        const auto pair = relateCameras(truth.pairs, truth.a, truth.b, {});
        QVERIFY2(pair.has_value(), pair ? "" : pair.error().message().c_str());
        QCOMPARE(pair->used.size(), std::size_t(8));
        QCOMPARE(pair->rejected.size(), std::size_t(4));
        QCOMPARE(pair->rejected[0].reason.english(), std::string("the board was not found in 'right5'"));
        QCOMPARE(pair->rejected[1].reason.english(), std::string("both are the same image"));
        QCOMPARE(pair->rejected[2].a, std::string("left3"));
        QCOMPARE(pair->rejected[2].b, std::string("right8"));
        QVERIFY(pair->rejected[2].reason.english().starts_with("it contradicts the other pairs by "));
        QCOMPARE(pair->rejected[3].a, std::string("left8"));
        QVERIFY(std::abs(pair->baselineM - 0.25) < 4 * pair->baselineSigmaM);
    }

    void misreadCornersDoNotCount()
    {
        DrawnPairs truth = drawn({}, 11);
        for (int i = 0; i < 6; ++i) // an outer column misread in one image, by less and less
            truth.pairs[2].b.pixels[std::size_t(9 * i)] += Vector2d(4.0 - 0.5 * i, 0.5);
        truth.pairs[4].a.pixels[20] += Vector2d(0, 6);
        const auto pair = relateCameras(truth.pairs, truth.a, truth.b, {});
        QVERIFY2(pair.has_value(), pair ? "" : pair.error().message().c_str());
        QCOMPARE(pair->used[2].cornersLeftOut, std::size_t(6));
        QCOMPARE(pair->used[4].cornersLeftOut, std::size_t(1));
        QCOMPARE(pair->cornersLeftOut(), std::size_t(7));
        QVERIFY(pair->rmsPx < 0.3);
        QVERIFY(std::abs(pair->baselineM - 0.25) < 4 * pair->baselineSigmaM);
    }

    void pairsInAWrongOrderAreRefused()
    {
        DrawnPairs truth = drawn({}, 13);
        for (std::size_t i = 0; i + 1 < truth.pairs.size(); ++i)
            std::swap(truth.pairs[i].b, truth.pairs[i + 1].b);
        const auto pair = relateCameras(truth.pairs, truth.a, truth.b, {});
        QVERIFY(!pair.has_value());
        QVERIFY2(pair.error().message().starts_with(
                     "the relative position of the cameras: the pairs contradict each other ("),
                 pair.error().message().c_str());
    }

    void swappedImagesAreNamed()
    {
        DrawnPairs truth = drawn({}, 15);
        Intrinsics other = secondLens();
        other.fxPx = other.fyPx = 1400;
        const CameraModel longer = CameraModel::create(other).value();
        Drawing drawing;
        std::vector<BoardPair> swapped;
        std::mt19937 random(4);
        for (int i = 0; i < 8; ++i) {
            RigidTransform pose;
            pose.rotation = Eigen::AngleAxisd(0.1 * i - 0.4, Vector3d(1, 0.3 * i - 1, 0.1).normalized());
            pose.translation = {-0.1, -0.05, 0.9 + 0.02 * i};
            BoardPair pair{viewOf(longer, relation(0.2) * pose, drawing, false, 0.2, random),
                           viewOf(truth.a, pose, drawing, false, 0.2, random)};
            swapped.push_back(pair);
        }
        const auto pair = relateCameras(swapped, truth.a, longer, {});
        QVERIFY(!pair.has_value());
        QCOMPARE(pair.error().code, ErrorCode::InvalidInput);
        QVERIFY2(
            pair.error().message().starts_with("the relative position of the cameras: the images of each "
                                               "camera fit the lens calibration of the other one ("),
            pair.error().message().c_str());
    }

    void withoutABoardNothingIsFound()
    {
        DrawnPairs truth = drawn({}, 17);
        for (BoardPair &pair : truth.pairs) {
            pair.a.pixels.clear();
            pair.a.pointsOnBoard.clear();
        }
        fails(
            truth.pairs, truth.a, truth.b,
            "the relative position of the cameras: none of 12 pairs can be used: the board was not found in "
            "'left0'; show the whole board to both cameras at once, in ten positions or more");
        fails(
            {}, truth.a, truth.b,
            "the relative position of the cameras: none of 0 pairs can be used; show the whole board to both "
            "cameras at once, in ten positions or more");
    }

    void itCanBeCancelled()
    {
        const DrawnPairs truth = drawn({}, 19);
        JobControl control;
        control.cancel.cancel();
        const auto pair = relateCameras(truth.pairs, truth.a, truth.b, control);
        QVERIFY(!pair.has_value());
        QCOMPARE(pair.error().code, ErrorCode::Cancelled);
    }
};

ODOGRAPH_TEST(TestCameraPair, QCoreApplication)
#include "tst_camera_pair.moc"
