// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_detection.h"
#include "tests/calibration/images.h"
#include "tests/support/registered_test.h"

#include <Eigen/Geometry>
#include <QTest>
#include <ctime>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

using namespace odo;
using Eigen::Vector2d;

namespace {

constexpr int squarePx = 40; // of the flat board that is then warped

cv::Mat flatCheckerboard(int columns, int rows)
{
    cv::Mat board((rows + 3) * squarePx, (columns + 3) * squarePx, CV_8UC1, cv::Scalar(225));
    for (int y = 0; y <= rows; ++y) {
        for (int x = 0; x <= columns; ++x) {
            if ((x + y) % 2 == 0)
                board(cv::Rect((x + 1) * squarePx, (y + 1) * squarePx, squarePx, squarePx)) = 30;
        }
    }
    return board;
}

/// Pixel of the warped picture by pixel of the flat board.
cv::Matx33d oblique(double scale, double turn, cv::Point2d at)
{
    const double c = scale * std::cos(turn), s = scale * std::sin(turn);
    return cv::Matx33d(c, -s, at.x, s, c, at.y, 2.5e-4, 3.5e-4, 1);
}

/// Four times oversampled, so that the edges lie where the geometry says.
cv::Mat seen(const cv::Mat &board, const cv::Matx33d &warp, cv::Size size, double blurPx = 0.8)
{
    constexpr int fine = 4;
    const cv::Matx33d toFine(fine, 0, 0.5 * (fine - 1), 0, fine, 0.5 * (fine - 1), 0, 0, 1);
    cv::Mat large, image;
    cv::warpPerspective(board, large, cv::Mat(toFine * warp), size * fine, cv::INTER_LINEAR,
                        cv::BORDER_CONSTANT, cv::Scalar(120));
    cv::resize(large, image, size, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(image, image, {0, 0}, blurPx);
    cv::Mat noise(size, CV_16SC1);
    cv::RNG random(9);
    random.fill(noise, cv::RNG::NORMAL, 0, 2.0);
    cv::add(image, noise, image, cv::noArray(), CV_8U);
    return image;
}

/// A corner of the flat board lies between pixels: half a pixel before the square's first.
Vector2d warped(const cv::Matx33d &warp, double column, double row)
{
    const cv::Vec3d point = warp * cv::Vec3d((column + 2) * squarePx - 0.5, (row + 2) * squarePx - 0.5, 1);
    return {point[0] / point[2], point[1] / point[2]};
}

BoardSpec spec(BoardPattern pattern, int columns, int rows)
{
    BoardSpec board;
    board.pattern = pattern;
    board.columns = columns;
    board.rows = rows;
    board.squareM = 0.03;
    return board;
}

bool refusedWith(const cv::Mat &image, const BoardSpec &board, const char *words)
{
    const auto view = findBoard(frameOf(image), board, "p.png");
    if (view)
        return false;
    const bool told = view.error().message().find(words) != std::string::npos &&
                      view.error().message().starts_with("p.png: ");
    if (!told)
        qWarning("told instead: %s", view.error().message().c_str());
    return told;
}

const cv::Matx33d someWarp = oblique(0.9, 0.25, {110, 40});

cv::Mat flatCharuco(int squaresX, int squaresY, double ratio, cv::aruco::PREDEFINED_DICTIONARY_NAME name)
{
    const auto board = cv::aruco::CharucoBoard::create(squaresX, squaresY, 1.0F, static_cast<float>(ratio),
                                                       cv::aruco::getPredefinedDictionary(name));
    cv::Mat image;
    board->draw({squaresX * 60 + 60, squaresY * 60 + 60}, image, 30, 1);
    return image;
}

} // namespace

class TestBoardDetection : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Brickwork is full of places that are nearly corners, noise of quadrilaterals: a search took 52 s and 7
    /// s of a processor.
    void anImageWithoutABoardIsAnsweredSoon()
    {
        std::mt19937 random(3);
        cv::Mat noise(3000, 4000, CV_8UC1), bricks(720, 1280, CV_8UC1);
        for (int y = 0; y < noise.rows; ++y)
            for (int x = 0; x < noise.cols; ++x)
                noise.at<std::uint8_t>(y, x) = std::uint8_t(random() % 256);
        for (int y = 0; y < bricks.rows; ++y)
            for (int x = 0; x < bricks.cols; ++x)
                bricks.at<std::uint8_t>(y, x) = y % 20 < 2 || (x + y / 20 * 20) % 40 < 2 ? 60 : 190;
        for (const cv::Mat *image : {&noise, &bricks}) {
            const std::clock_t start = std::clock();
            const auto view = findBoard(frameOf(*image), BoardSpec(), "p");
            const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
            QVERIFY(!view);
            QVERIFY2(seconds < 3,
                     qPrintable(QString::number(seconds))); // a busy machine takes thrice as long
        }
    }
    void findsTheCornersOfACheckerboard_data()
    {
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::addColumn<bool>("told");
        QTest::newRow("9x6 told") << 9 << 6 << true;
        QTest::newRow("9x6 found out") << 9 << 6 << false;
        QTest::newRow("8x5 found out") << 8 << 5 << false;
        QTest::newRow("7x7 found out") << 7 << 7 << false;
        QTest::newRow("3x3 told") << 3 << 3 << true;
    }
    void findsTheCornersOfACheckerboard()
    {
        QFETCH(int, columns);
        QFETCH(int, rows);
        QFETCH(bool, told);
        const cv::Mat image = seen(flatCheckerboard(columns, rows), someWarp, {640, 480});
        const auto view = findBoard(
            frameOf(image), spec(BoardPattern::Checkerboard, told ? columns : 0, told ? rows : 0), "p.png");
        QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
        QCOMPARE(view->columns, columns);
        QCOMPARE(view->rows, rows);
        QCOMPARE(view->pixels.size(), std::size_t(columns * rows));
        double squares = 0;
        for (const auto &pixel : view->pixels) {
            double nearest = 1e9; // whatever corner it starts from
            for (int y = 0; y < rows; ++y) {
                for (int x = 0; x < columns; ++x)
                    nearest = std::min(nearest, (pixel - warped(someWarp, x, y)).norm());
            }
            squares += nearest * nearest;
        }
        QVERIFY2(std::sqrt(squares / (columns * rows)) < 0.08,
                 qPrintable(QString::number(std::sqrt(squares / (columns * rows)))));
        QVERIFY((view->pointsOnBoard[1] - view->pointsOnBoard[0] - Vector2d(0.03, 0)).norm() < 1e-12);
    }
    void pointsOnTheBoardAreRightHandedInThePicture()
    {
        for (double turn : {0.2, 1.4, 2.9, -1.3}) {
            const cv::Matx33d warp = oblique(0.7, turn,
                                             {320 - 190 * std::cos(turn) + 140 * std::sin(turn),
                                              240 - 190 * std::sin(turn) - 140 * std::cos(turn)});
            const auto view = findBoard(frameOf(seen(flatCheckerboard(9, 6), warp, {640, 480})),
                                        spec(BoardPattern::Checkerboard, 9, 6), "p.png");
            QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
            const Vector2d u = view->pixels[1] - view->pixels[0], v = view->pixels[9] - view->pixels[0];
            QVERIFY(u.x() * v.y() - u.y() * v.x() > 0);
        }
    }
    void saysWhichSizeItFound()
    {
        const cv::Mat image = seen(flatCheckerboard(9, 6), someWarp, {640, 480});
        QVERIFY(refusedWith(image, spec(BoardPattern::Checkerboard, 8, 6),
                            "this board has 9x6 inner corners, not 8x6"));
        QVERIFY(refusedWith(image, spec(BoardPattern::Checkerboard, 10, 7),
                            "this board has 9x6 inner corners, not 10x7"));
    }
    void saysWhenThereIsNone()
    {
        QVERIFY(refusedWith(cv::Mat(480, 640, CV_8UC1, cv::Scalar(90)),
                            spec(BoardPattern::Checkerboard, 9, 6), "no board found"));
        cv::Mat noise(480, 640, CV_8UC1);
        cv::RNG random(3);
        random.fill(noise, cv::RNG::UNIFORM, 0, 256);
        QVERIFY(refusedWith(noise, spec(BoardPattern::Checkerboard, 0, 0), "no board found"));
        QVERIFY(refusedWith(noise, spec(BoardPattern::Charuco, 0, 0), "no board found"));
        QVERIFY(refusedWith(cv::Mat(20, 20, CV_8UC1, cv::Scalar(0)), spec(BoardPattern::Checkerboard, 0, 0),
                            "too small"));
    }
    void refusesWhatIsNoBoard()
    {
        const cv::Mat image(480, 640, CV_8UC1, cv::Scalar(90));
        QVERIFY(refusedWith(image, spec(BoardPattern::Checkerboard, 1, 6), "1x6 inner corners is too small"));
        BoardSpec board = spec(BoardPattern::Charuco, 0, 0);
        board.dictionary = "DICT_9X9";
        QVERIFY(refusedWith(image, board, "marker dictionary DICT_9X9 does not exist"));
        board.squareM = 0;
        QVERIFY(refusedWith(image, board, "the squares have no size"));
    }
    void refusesABlurredBoard()
    {
        const cv::Mat image = seen(flatCheckerboard(9, 6), someWarp, {640, 480}, 8);
        QVERIFY(refusedWith(image, spec(BoardPattern::Checkerboard, 9, 6), "blurred"));
    }
    void aBoardCutOffByTheBorderIsTakenAsFarAsItIsSeen()
    {
        const cv::Matx33d shifted = oblique(0.9, 0.05, {-75, 40}); // the first column is left of the picture
        const cv::Mat image = seen(flatCheckerboard(9, 6), shifted, {640, 480});
        const auto view = findBoard(frameOf(image), spec(BoardPattern::Checkerboard, 9, 6), "p.png");
        QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
        QCOMPARE(view->columns, 9);
        QCOMPARE(view->pixels.size(), std::size_t(48));
        const cv::Matx33d farther = oblique(0.9, 0.05, {-230, 40});
        QVERIFY(refusedWith(seen(flatCheckerboard(9, 6), farther, {640, 480}),
                            spec(BoardPattern::Checkerboard, 9, 6), "the board is cut off"));
    }
    void findsTheCornersOfACharucoBoard_data()
    {
        QTest::addColumn<int>("squaresX");
        QTest::addColumn<int>("squaresY");
        QTest::addColumn<int>("dictionary");
        QTest::addColumn<double>("ratio");
        QTest::addColumn<bool>("inverted");
        QTest::newRow("5x7") << 5 << 7 << int(cv::aruco::DICT_6X6_250) << 0.5 << false;
        QTest::newRow("4x5 inverted") << 4 << 5 << int(cv::aruco::DICT_4X4_1000) << 0.75 << true;
        QTest::newRow("even rows") << 6 << 4 << int(cv::aruco::DICT_5X5_100) << 0.7 << false;
    }
    void findsTheCornersOfACharucoBoard()
    {
        QFETCH(int, squaresX);
        QFETCH(int, squaresY);
        QFETCH(int, dictionary);
        QFETCH(double, ratio);
        QFETCH(bool, inverted);
        cv::Mat flat =
            flatCharuco(squaresX, squaresY, ratio, cv::aruco::PREDEFINED_DICTIONARY_NAME(dictionary));
        if (inverted)
            cv::bitwise_not(flat, flat);
        const cv::Matx33d warp = oblique(1.35, 0.15, {120, 10});
        const cv::Mat image = seen(flat, warp, {900, 720});
        for (bool told : {true, false}) {
            const auto view = findBoard(
                frameOf(image), spec(BoardPattern::Charuco, told ? squaresX - 1 : 0, told ? squaresY - 1 : 0),
                "p.png");
            QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
            QCOMPARE(view->columns, squaresX - 1);
            QCOMPARE(view->rows, squaresY - 1);
            QCOMPARE(view->pixels.size(), std::size_t((squaresX - 1) * (squaresY - 1)));
            for (std::size_t i = 0; i < view->pixels.size(); ++i) {
                const Vector2d square = view->pointsOnBoard[i] / 0.03 + Vector2d(1, 1);
                const cv::Vec3d point =
                    warp * cv::Vec3d(30 + 60 * square.x() - 0.5, 30 + 60 * square.y() - 0.5, 1);
                const Vector2d truth(point[0] / point[2], point[1] / point[2]);
                QVERIFY2((view->pixels[i] - truth).norm() < 0.5,
                         qPrintable(QString::number((view->pixels[i] - truth).norm())));
            }
        }
    }
};

ODOGRAPH_TEST(TestBoardDetection, QCoreApplication)
#include "tst_board_detection.moc"
