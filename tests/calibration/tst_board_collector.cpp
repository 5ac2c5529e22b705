// SPDX-License-Identifier: GPL-3.0-or-later
// Gathering pictures of a board: where it stands, what is missing, what does not count.
#include "core/calibration/board_collector.h"
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"

#include <Eigen/Geometry>
#include <QTest>

using namespace odo;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int widthPx = 640, heightPx = 360;
constexpr double degree = EIGEN_PI / 180;

const CameraModel camera = CameraModel::assumed(widthPx, heightPx);

/// The board's middle at a place of the camera's frame, turned by degrees about the camera's x and y axes.
RigidTransform posed(const Vector3d &middle, double aboutX, double aboutY, double squareM = 0.025)
{
    RigidTransform cameraFromBoard;
    cameraFromBoard.rotation = Eigen::AngleAxisd(aboutY * degree, Vector3d::UnitY()) *
                               Eigen::AngleAxisd(aboutX * degree, Vector3d::UnitX());
    cameraFromBoard.translation = middle - cameraFromBoard.rotation * (squareM * Vector3d(4, 2.5, 0));
    return cameraFromBoard;
}

BoardPlacement placementOfPose(const RigidTransform &cameraFromBoard)
{
    BoardView view{"p", 9, 6, {}, {}};
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 9; ++x) {
            const Vector2d point(0.025 * x, 0.025 * y);
            view.pixels.push_back(*camera.project(
                cameraFromBoard.rotation * Vector3d(point.x(), point.y(), 0) + cameraFromBoard.translation));
            view.pointsOnBoard.push_back(point);
        }
    }
    return *placementOf(view, widthPx, heightPx);
}

Frame rendered(const RigidTransform &cameraFromBoard, double milliseconds = 0, bool charuco = false)
{
    SimulatedBoard board;
    board.charuco = charuco;
    board.cameraFromBoard = cameraFromBoard;
    Frame frame = renderBoard(camera, board, 2, 1);
    frame.time = fromSeconds(1e-3 * milliseconds);
    return frame;
}

bool refusedWith(const ImageVerdict &answer, const char *words)
{
    if (!answer.refusal || answer.kept)
        return false;
    const std::string message = answer.refusal->message();
    if (message.find(words) == std::string::npos)
        qWarning("told instead: %s", message.c_str());
    return message.find(words) != std::string::npos && message.find("; ") != std::string::npos;
}

const RigidTransform frontal = posed({0, 0, 0.45}, 0, 0);

} // namespace

class TestBoardCollector : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aFrontalBoardInTheMiddle()
    {
        const BoardPlacement placement = placementOfPose(frontal);
        // The middle of the picture is half a pixel off the lens's centre.
        QVERIFY((placement.position - Vector2d(0.5, 0.5)).norm() < 0.01);
        QVERIFY(placement.skew() < 1e-3);
        const double f = camera.intrinsics().fxPx / 0.45 * 0.025;
        QVERIFY(std::abs(placement.size - std::sqrt(8 * f * 5 * f / (widthPx * heightPx))) < 1e-6);
    }

    void slopeTellsAngleAndSide_data()
    {
        QTest::addColumn<double>("aboutX");
        QTest::addColumn<double>("aboutY");
        QTest::addColumn<Vector2d>("farther");
        // Turning about y (down) by a positive angle takes x towards −z: the right side comes nearer.
        QTest::newRow("left side away") << 0.0 << 30.0 << Vector2d(-1, 0);
        QTest::newRow("right side away") << 0.0 << -30.0 << Vector2d(1, 0);
        QTest::newRow("upper side away") << -30.0 << 0.0 << Vector2d(0, -1);
        QTest::newRow("lower side away") << 30.0 << 0.0 << Vector2d(0, 1);
    }
    void slopeTellsAngleAndSide()
    {
        QFETCH(double, aboutX);
        QFETCH(double, aboutY);
        QFETCH(Vector2d, farther);
        const BoardPlacement placement = placementOfPose(posed({0, 0, 0.5}, aboutX, aboutY));
        QVERIFY2(std::abs(placement.angleDegrees() - 30) < 1,
                 qPrintable(QString::number(placement.angleDegrees())));
        QVERIFY(placement.slope.normalized().dot(farther) > 0.99);
    }

    void coverageGrowsAsTheBarsSay()
    {
        QVERIFY(!coverageOf({}, {}, widthPx, heightPx).isEnough());
        std::vector<BoardPlacement> placements(2);
        placements[0].position = {0.1, 0.5};
        placements[1].position = {0.45, 0.5};
        placements[1].size = 0.1;
        placements[1].slope = {0.5, 0};
        const BoardCoverage half = coverageOf({}, placements, widthPx, heightPx);
        QVERIFY(std::abs(half.x - 0.5) < 1e-12); // 0.35 of 0.7
        QCOMPARE(half.y, 0.0);
        QVERIFY(std::abs(half.size - 0.25) < 1e-12);
        QVERIFY(std::abs(half.skew - 0.5) < 1e-12); // tilted by half of 45° to one side only
        placements[0].slope = {-0.5, 0};
        QCOMPARE(coverageOf({}, placements, widthPx, heightPx).skew, 1.0);
    }

    void thePosesAskedForAreEnough()
    {
        std::vector<BoardPlacement> taken;
        for (int i = 0; i < 14; ++i) {
            const WantedPose wanted = wantedPose(taken, 9, 6, widthPx, heightPx);
            for (const Vector2d &corner : wanted.placement.outline)
                QVERIFY(corner.x() > 0 && corner.x() < widthPx && corner.y() > 0 && corner.y() < heightPx);
            for (const BoardPlacement &there : taken)
                QVERIFY2(distanceOf(there, wanted.placement) > 0.2, qPrintable(QString::number(i)));
            taken.push_back(wanted.placement);
        }
        const BoardCoverage coverage = coverageOf({}, taken, widthPx, heightPx);
        QCOMPARE(coverage.x, 1.0);
        QCOMPARE(coverage.y, 1.0);
        QCOMPARE(coverage.size, 1.0);
        QCOMPARE(coverage.skew, 1.0);
    }

    void hintsLeadThere()
    {
        const WantedPose wanted{placementOfPose(posed({0.1, 0, 0.5}, 0, 30))};
        QCOMPARE(hintTowards(wanted, wanted.placement), BoardHint::HoldStill);
        QCOMPARE(hintTowards(wanted, placementOfPose(posed({-0.1, 0, 0.5}, 0, 30))), BoardHint::Right);
        QCOMPARE(hintTowards(wanted, placementOfPose(posed({0.1, 0, 0.5}, 0, 0))), BoardHint::TiltLeft);
        QCOMPARE(hintTowards(wanted, placementOfPose(posed({0.2, 0, 1.2}, 0, 30))), BoardHint::Closer);
    }

    void findsOutPatternAndSizeAndKeepsNewPoses_data()
    {
        QTest::addColumn<bool>("charuco");
        QTest::newRow("checkerboard") << false;
        QTest::newRow("ChArUco") << true;
    }
    void findsOutPatternAndSizeAndKeepsNewPoses()
    {
        QFETCH(bool, charuco);
        BoardCollector collector({});
        const ImageVerdict first = collector.offer(rendered(frontal, 0, charuco), "a.png");
        QVERIFY2(first.kept, first.refusal ? first.refusal->message().c_str() : "");
        QCOMPARE(*collector.spec().pattern, charuco ? BoardPattern::Charuco : BoardPattern::Checkerboard);
        QCOMPARE(collector.spec().columns, 9);
        QCOMPARE(collector.spec().rows, 6);
        QVERIFY(refusedWith(collector.offer(rendered(posed({0.002, 0, 0.451}, 0, 1), 0, charuco), "b.png"),
                            "the board is in the same position as in a.png"));
        QVERIFY(collector.offer(rendered(posed({0, 0, 0.45}, 0, 30), 0, charuco), "c.png").kept);
        QCOMPARE(collector.views().size(), std::size_t(2));
        QCOMPARE(collector.coverage().images, 2);
    }

    void saysWhyAPictureDoesNotCount()
    {
        BoardCollector collector({});
        QVERIFY(refusedWith(collector.offer(rendered(posed({0, 0, 0.3}, 0, 68)), "a.png"), "tilted too far"));
        QVERIFY(refusedWith(collector.offer(rendered(posed({0, 0, 2.6}, 0, 0)), "b.png"), "too small"));
        QVERIFY(collector.offer(rendered(frontal), "c.png").kept);
        SimulatedBoard other;
        other.columns = 8;
        other.cameraFromBoard = frontal;
        QVERIFY(refusedWith(collector.offer(renderBoard(camera, other, 2, 1), "d.png"),
                            "this board has 8x6 inner corners, not 9x6"));
        const Frame larger =
            renderBoard(CameraModel::assumed(800, 600), SimulatedBoard{.cameraFromBoard = frontal}, 2, 1);
        QVERIFY(refusedWith(collector.offer(larger, "e.png"), "it is 800×600, the other images are 640×360"));
    }

    /// The first image does not decide what the board is: it may show a part of it.
    void aCutBoardFirstIsSearchedAgain_data()
    {
        QTest::addColumn<double>("aside");
        QTest::addColumn<bool>("isEnough"); // two thirds of the corners
        QTest::newRow("a part of it") << 0.12 << true;
        QTest::newRow("half of it") << 0.2 << false;
    }
    void aCutBoardFirstIsSearchedAgain()
    {
        QFETCH(double, aside);
        QFETCH(bool, isEnough);
        BoardCollector collector({});
        const Frame cut = rendered(posed({aside, 0, 0.45}, 20, 0));
        QVERIFY(collector.offer(cut, "cut.png").kept);
        QVERIFY(collector.spec().columns * collector.spec().rows < 54);
        const int before = collector.changes();
        QVERIFY(collector.offer(rendered(frontal), "a.png").kept);
        QCOMPARE(collector.changes(), before + 1);
        QCOMPARE(collector.spec().columns, 9);
        QCOMPARE(collector.spec().rows, 6);
        QCOMPARE(collector.images().size(), std::size_t(1));
        const ImageVerdict again = collector.offerAgain(cut, "cut.png");
        QCOMPARE(again.kept, isEnough);
        if (!isEnough)
            QVERIFY(refusedWith(again, "the board is cut off: only "));
        QCOMPARE(collector.images().size(), std::size_t(isEnough ? 2 : 1));
        QCOMPARE(collector.changes(), before + 1); // it does not vote again
    }

    void anotherBoardFirstGivesWayToTheMajority()
    {
        SimulatedBoard other;
        other.columns = 10; // larger: a vote each is not enough
        other.cameraFromBoard = frontal;
        BoardCollector collector({});
        QVERIFY(collector.offer(renderBoard(camera, other, 2, 1), "other.png").kept);
        const ImageVerdict one = collector.offer(rendered(frontal), "a.png");
        QVERIFY(one.isOther);
        QVERIFY(refusedWith(one, "this board has 9x6 inner corners, not 10x6"));
        const Frame tilted = rendered(posed({0, 0, 0.45}, 0, 30));
        QVERIFY(collector.offer(tilted, "b.png").kept);
        QVERIFY(collector.offerAgain(rendered(frontal), "a.png").kept);
        QVERIFY(refusedWith(collector.offerAgain(renderBoard(camera, other, 2, 1), "other.png"),
                            "this board has 10x6 inner corners, not 9x6"));
        QCOMPARE(collector.images().size(), std::size_t(2));
        collector.remove(0); // and does not count any more
        other.cameraFromBoard = posed({0, 0, 0.5}, 30, 0);
        QVERIFY(collector.offer(renderBoard(camera, other, 2, 1), "other2.png").kept);
        QCOMPARE(collector.spec().columns, 10);
    }

    void anImageOfAnotherSizeFirstGivesWay()
    {
        BoardCollector collector({});
        const Frame larger =
            renderBoard(CameraModel::assumed(800, 600), SimulatedBoard{.cameraFromBoard = frontal}, 2, 1);
        QVERIFY(collector.offer(larger, "large.png").kept);
        QVERIFY(refusedWith(collector.offer(rendered(frontal), "a.png"),
                            "it is 640×360, the other images are 800×600"));
        QVERIFY(collector.offer(rendered(posed({0, 0, 0.45}, 0, 30)), "b.png").kept);
        QCOMPARE(collector.widthPx(), 640);
        QCOMPARE(collector.heightPx(), 360);
        QVERIFY(collector.offerAgain(rendered(frontal), "a.png").kept);
        QVERIFY(refusedWith(collector.offerAgain(larger, "large.png"),
                            "it is 800×600, the other images are 640×360"));
    }

    void aHeldCutBoardVotesOnce()
    {
        BoardCollector collector({});
        const RigidTransform cut = posed({0.12, 0, 0.45}, 20, 0);
        QVERIFY(collector.offer(rendered(frontal), "a.png").kept);
        for (int i = 0; i < 6; ++i) { // the same part of it for three seconds
            const ImageVerdict answer = collector.watch(rendered(cut, 500 * i), std::to_string(i));
            QCOMPARE(answer.kept, i == 1); // searched again for the board of most
        }
        QCOMPARE(collector.spec().columns, 9);
        QCOMPARE(collector.images().size(), std::size_t(2));
    }

    void takesAPictureByItselfWhenTheBoardIsStill()
    {
        BoardCollector collector({});
        QVERIFY(!collector.watch(rendered(frontal, 0), "0").kept);
        QVERIFY(!collector.watch(rendered(posed({0.01, 0, 0.45}, 0, 0), 300), "300").kept); // moved: 11 px
        QVERIFY(!collector.watch(rendered(posed({0.0102, 0, 0.45}, 0, 0), 600), "600").kept);
        const ImageVerdict still = collector.watch(rendered(posed({0.01, 0, 0.45}, 0, 0), 800), "800");
        QVERIFY(still.kept);
        QVERIFY(!still.refusal);
        QVERIFY(refusedWith(collector.watch(rendered(posed({0.01, 0, 0.45}, 0, 0), 1400), "1400"),
                            "the same position as in an earlier image"));
    }

    void aSmallBoardHeldStillIsKeptOnce()
    {
        BoardCollector collector({});
        SimulatedBoard board;
        board.cameraFromBoard = posed({0, 0, 1.3}, 0, 0);
        for (unsigned seed = 1; seed <= 40; ++seed) // noise lets it seem to tilt
            collector.offer(renderBoard(camera, board, 8, seed), "a.png");
        QCOMPARE(collector.images().size(), std::size_t(1));
    }

    void aPictureCanBeTakenOutAndPutBack()
    {
        BoardCollector collector({});
        QVERIFY(collector.offer(rendered(frontal), "a.png").kept);
        QVERIFY(collector.offer(rendered(posed({0, 0, 0.45}, 30, 0)), "b.png").kept);
        CollectedImage taken = collector.remove(0);
        QCOMPARE(taken.view.source, std::string("a.png"));
        QCOMPARE(collector.images().front().view.source, std::string("b.png"));
        collector.insert(0, std::move(taken));
        QCOMPARE(collector.images().front().view.source, std::string("a.png"));
        QCOMPARE(collector.coverage().images, 2);
    }
};

ODOGRAPH_TEST(TestBoardCollector, QCoreApplication)
#include "tst_board_collector.moc"
