// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/blob_finder.h"
#include "core/tracking/internal/robot_expectation.h"
#include "core/tracking/internal/tracked_frame.h"
#include "tests/support/registered_test.h"
#include "tests/tracking/painter.h"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace odo;

namespace {

/// A 4:4:4 picture drawn with letters: '#' is the robot's colour, anything else is not.
Frame drawn(const std::vector<std::string> &rows)
{
    auto buffer = std::make_shared<FrameBuffer>(testFormat(
        static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), ChromaSiting::Left, 0, 0));
    for (std::size_t y = 0; y < rows.size(); ++y) {
        for (std::size_t x = 0; x < rows[y].size(); ++x) {
            buffer->uRow(static_cast<int>(y))[x] = rows[y][x] == '#' ? 100 : 128;
            buffer->vRow(static_cast<int>(y))[x] = rows[y][x] == '#' ? 200 : 128;
        }
    }
    return FrameBuffer::toFrame(buffer, 0, Nanoseconds(0));
}

ChromaTable robotTable()
{
    ChromaDensity robot;
    robot[ChromaDensity::binOf(100, 200)] = 1;
    return {robot, ChromaDensity(), 0.001f};
}

std::vector<Blob> blobsOf(const Frame &frame, int step = 1)
{
    BlobFinder finder;
    const ChromaGrid grid(frame);
    finder.find(grid, robotTable(), grid.bounds(), step);
    return finder.blobs();
}

} // namespace

class TestBlobFinder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void momentsAgreeWithSums();
    void armsThatMeetBelowAreOne();
    void diagonalNeighboursAreOne();
    void oneLostSampleBreaksNothing();
    void widthOfTheAreaIsOfNoMatter();
    void coarseStepKeepsAreaAndPlace();
    void onlyTheAreaIsLookedAt();
    void nothingThere();
    void maskHoldsOneBlobOnly();
    void compactnessTellsShapes();
    void sizesThatAreNoRobots();
    void predictionKeepsTheVelocity();
    void predictionStopsAfterAWhile();
    void duplicatesByteForByte();
};

void TestBlobFinder::momentsAgreeWithSums()
{
    const std::vector<std::string> rows{"..........", ".####.....", ".#####..##", "...###....", ".........."};
    const auto blobs = blobsOf(drawn(rows));
    QCOMPARE(blobs.size(), std::size_t(2));
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 7; ++i) {
            if (rows[std::size_t(j)][std::size_t(i)] == '#')
                n += 1, x += i, y += j, xx += i * i, xy += i * j, yy += j * j;
        }
    }
    const Blob &blob = blobs[0];
    QCOMPARE(blob.count, n);
    QCOMPARE(blob.sumX, x);
    QCOMPARE(blob.sumY, y);
    QCOMPARE(blob.sumXX, xx);
    QCOMPARE(blob.sumXY, xy);
    QCOMPARE(blob.sumYY, yy);
    QCOMPARE(blob.box.left, 1);
    QCOMPARE(blob.box.right, 6);
    QCOMPARE(blob.box.top, 1);
    QCOMPARE(blob.box.bottom, 4);
    QCOMPARE(blob.meanChroma(), Chroma(100 - 128, 200 - 128));
    QVERIFY(blob.meanWeight() > 0.99);
}

void TestBlobFinder::armsThatMeetBelowAreOne()
{
    QCOMPARE(blobsOf(drawn({"##...##..##", "##...##..##", "##...##..##", "###########"})).size(),
             std::size_t(1));
    QCOMPARE(blobsOf(drawn({"##...##..##", "##...##..##", "##...######"})).size(), std::size_t(2));
}

void TestBlobFinder::diagonalNeighboursAreOne()
{
    QCOMPARE(blobsOf(drawn({"#......", ".#.....", "..#....", "...#..."})).size(), std::size_t(1));
    QCOMPARE(blobsOf(drawn({"#......", ".......", "..#...."})).size(), std::size_t(2));
}

void TestBlobFinder::oneLostSampleBreaksNothing()
{
    QCOMPARE(blobsOf(drawn({"###.###"})).size(), std::size_t(1));
    QCOMPARE(blobsOf(drawn({"###..###"})).size(), std::size_t(2));
}

/// Samples are passed over in blocks: wherever a run begins and ends among them, it is found whole.
void TestBlobFinder::widthOfTheAreaIsOfNoMatter()
{
    for (std::size_t width = 30; width < 64; ++width) {
        for (std::size_t begin = 0; begin < width - 3; ++begin) {
            for (const std::size_t length : {std::size_t(1), std::size_t(3), width - begin}) {
                std::string row(width, '.');
                row.replace(begin, length, std::string(length, '#'));
                const auto blobs = blobsOf(drawn({row}));
                QCOMPARE(blobs.size(), std::size_t(1));
                QCOMPARE(blobs[0].box.left, static_cast<int>(begin));
                QCOMPARE(blobs[0].box.right, static_cast<int>(begin + length));
                QCOMPARE(blobs[0].visited, static_cast<double>(length));
            }
        }
    }
}

void TestBlobFinder::coarseStepKeepsAreaAndPlace()
{
    std::vector<std::string> rows(40, std::string(60, '.'));
    for (std::size_t y = 10; y < 30; ++y)
        rows[y].replace(20, 24, std::string(24, '#'));
    const auto fine = blobsOf(drawn(rows), 1), coarse = blobsOf(drawn(rows), 2);
    QCOMPARE(coarse.size(), std::size_t(1));
    QCOMPARE(coarse[0].area(), fine[0].area());
    QVERIFY((coarse[0].centre() - fine[0].centre()).norm() <= 0.8);
    QVERIFY((coarse[0].covariance() - fine[0].covariance()).norm() < 0.01 * fine[0].covariance().norm());
    // Exactly the variance of a box of 24 × 20.
    QVERIFY(std::abs(fine[0].covariance()(0, 0) - 48) < 1e-9);
}

void TestBlobFinder::onlyTheAreaIsLookedAt()
{
    const Frame frame = drawn({"##...##", "##...##"});
    BlobFinder finder;
    finder.find(ChromaGrid(frame), robotTable(), {3, 0, 7, 2}, 1);
    QCOMPARE(finder.blobs().size(), std::size_t(1));
    QCOMPARE(finder.blobs()[0].box.left, 5);
}

void TestBlobFinder::nothingThere()
{
    QVERIFY(blobsOf(drawn({"....", "...."})).empty());
}

void TestBlobFinder::maskHoldsOneBlobOnly()
{
    const Frame frame = drawn({"##...##", "##...##"});
    BlobFinder finder;
    finder.find(ChromaGrid(frame), robotTable(), {0, 0, 7, 2}, 1);
    RegionMask mask;
    finder.paint(finder.blobs()[1], 4, mask);
    QCOMPARE(std::count(mask.bytes.begin(), mask.bytes.end(), 1), std::ptrdiff_t(4));
    QVERIFY(mask.at(5, 0) && mask.at(6, 1) && !mask.at(4, 0) && !mask.at(0, 0));
}

void TestBlobFinder::compactnessTellsShapes()
{
    const auto boxMoments = [](double w, double h) {
        return Eigen::Matrix2d(Eigen::Vector2d(w * w / 12, h * h / 12).asDiagonal());
    };
    QVERIFY(compactness(Eigen::Vector2d(100, 25).asDiagonal(), std::numbers::pi * 20 * 10) > 0.99); // ellipse
    QVERIFY(compactness(boxMoments(30, 20), 600) > 0.95);
    QVERIFY(compactness(boxMoments(200, 8), 1600) < 0.01); // tape
    QVERIFY(compactness(boxMoments(30, 20), 250) < 0.01);  // scattered over the same place
    QCOMPARE(compactness(Eigen::Matrix2d::Zero(), 10), 0.0);
}

void TestBlobFinder::sizesThatAreNoRobots()
{
    QVERIFY(sizeLikelihood(1e-6) < 0.02);
    QVERIFY(sizeLikelihood(5e-3) > 0.95);
    QVERIFY(sizeLikelihood(0.6) < 0.01);
}

void TestBlobFinder::predictionKeepsTheVelocity()
{
    MotionPredictor predictor;
    predictor.start({10, 20}, 0);
    for (int i = 1; i <= 12; ++i)
        predictor.update({10 + 3.0 * i, 20 - 1.0 * i}, i / 30.0);
    // The gain of 0.6 leaves 0.4¹² of the first error.
    QVERIFY((predictor.velocity() - Eigen::Vector2d(90, -30)).norm() < 0.01);
    QVERIFY((predictor.at(13 / 30.0) - Eigen::Vector2d(49, 7)).norm() < 0.01);
    predictor.update({100, 100}, 12 / 30.0); // the same time again: no velocity from it
    QVERIFY((predictor.velocity() - Eigen::Vector2d(90, -30)).norm() < 0.01);
}

void TestBlobFinder::predictionStopsAfterAWhile()
{
    MotionPredictor predictor;
    predictor.start({0, 0}, 0);
    predictor.update({10, 0}, 0.1);
    QCOMPARE(predictor.at(5), predictor.at(50));
    QCOMPARE(predictor.at(0.0), Eigen::Vector2d(10, 0)); // never backwards
}

void TestBlobFinder::duplicatesByteForByte()
{
    DuplicateDetector detector;
    std::mt19937 random(1);
    const Painter painter(testFormat(64, 48));
    const Frame first = painter.frame(0, 0, 0, random), same = painter.frame(1, 0.1, 0, random);
    QVERIFY(!detector.repeatsTheLast(first));
    QVERIFY(detector.repeatsTheLast(same));
    // One sample off the lattice that is looked at first.
    auto buffer = std::make_shared<FrameBuffer>(testFormat(64, 48));
    for (int y = 0; y < 48; ++y)
        std::copy_n(first.y.row(y), 64, buffer->yRow(y));
    for (int y = 0; y < 24; ++y) {
        std::copy_n(first.u.row(y), 32, buffer->uRow(y));
        std::copy_n(first.v.row(y), 32, buffer->vRow(y));
    }
    buffer->yRow(21)[33] += 1;
    QVERIFY(!detector.repeatsTheLast(FrameBuffer::toFrame(buffer, 2, Nanoseconds(2))));
    QVERIFY(!detector.repeatsTheLast(Painter(testFormat(62, 48)).frame(3, 0.3, 0, random)));
}

ODOGRAPH_TEST(TestBlobFinder, QCoreApplication)
#include "tst_blob_finder.moc"
