// SPDX-License-Identifier: GPL-3.0-or-later
// Images of the largest size that is read: detection in them is bounded in memory, ends when cancelled, and
// measures in the image itself.
#include "core/base/job_control.h"
#include "core/calibration/board_detection.h"
#include "core/calibration/internal/round_markers.h"
#include "core/calibration/internal/tag_detection.h"
#include "tests/calibration/images.h"
#include "tests/support/registered_test.h"

#include <Eigen/Geometry>
#include <QElapsedTimer>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <functional>
#include <future>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <thread>

using namespace odo;
using Eigen::Vector2d;

namespace {

constexpr int width = 8000, height = 6200;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool memoryIsOurs = false; // a sanitizer needs its own
#else
constexpr bool memoryIsOurs = true;
#endif

/// In kB, from /proc/self/status.
long memory(const std::string &key)
{
    std::ifstream status("/proc/self/status");
    std::string word;
    long value = 0;
    while (status >> word)
        if (word == key + ":" && status >> value)
            return value;
    return 0;
}

/// The most memory that work takes beyond what is in use before, in MB.
long megabytesOf(const std::function<void()> &work)
{
    std::ofstream("/proc/self/clear_refs") << 5; // forgets the highest until now
    const long before = memory("VmRSS");
    work();
    return (memory("VmHWM") - before) / 1000;
}

Frame grey()
{
    return frameOf(cv::Mat(height, width, CV_8UC1, cv::Scalar(128)));
}

/// A checkerboard, turned, with squares of sidePx; corners by the place of the first and the step along a
/// row.
struct Board
{
    Vector2d firstPx{2300.3, 1200.7}, stepPx{300, 60};
    Vector2d corner(int column, int row) const
    {
        return firstPx + column * stepPx + row * Vector2d(-stepPx.y(), stepPx.x());
    }
};

/// A drawing laid into an image so that its point `from` comes to `to`, turned and scaled by step / unit;
/// both as pixels' centres.
cv::Mat laid(const cv::Mat &drawing, const Vector2d &from, const Vector2d &to, const Vector2d &step)
{
    const cv::Matx23d map(step.x(), -step.y(), to.x() - step.x() * from.x() + step.y() * from.y(), //
                          step.y(), step.x(), to.y() - step.y() * from.x() - step.x() * from.y());
    cv::Mat image(height, width, CV_8UC1, cv::Scalar(200));
    cv::warpAffine(drawing, image, map, image.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar(200));
    cv::GaussianBlur(image, image, {0, 0}, 1.5);
    return image;
}

} // namespace

class TestLargeImages : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void detectionTakesLittleMemory_data()
    {
        QTest::addColumn<bool>("board");
        QTest::newRow("board") << true;
        QTest::newRow("markers") << false;
    }
    /// With the image (150 MB) and the program (60 MB) it is to stay within 500 MB. It took 1.1 GB and 0.5
    /// GB.
    void detectionTakesLittleMemory()
    {
        QFETCH(bool, board);
        if (!memoryIsOurs)
            QSKIP("a sanitizer takes memory of its own");
        const Frame frame = grey();
        const long most = megabytesOf([&] {
            if (board)
                QVERIFY(!findBoard(frame, {}, "grey"));
            else
                QVERIFY(findTags(frame).empty() && findSmallTags(frame).empty() &&
                        findRoundMarkers(frame).empty());
        });
        QVERIFY2(most < 280, qPrintable(QString::number(most)));
    }

    void cancellingEndsIt()
    {
        const Frame frame = grey();
        const CancelToken cancel;
        QElapsedTimer sinceCancelled;
        std::promise<void> begun;
        std::thread canceller([&] {
            begun.get_future().wait();
            sinceCancelled.start();
            cancel.cancel();
        });
        const CancelScope scope(&cancel);
        bool ended = false;
        try {
            for (int i = 0; i < 100; ++i) {
                if (i == 1) // it has done one to its end
                    begun.set_value();
                static_cast<void>(findBoard(frame, {}, "grey"));
            }
        } catch (const WorkCancelled &) {
            ended = true;
        }
        canceller.join();
        QVERIFY(ended);
        // a second, beside other tests
        QVERIFY2(sinceCancelled.elapsed() < 2000, qPrintable(QString::number(sinceCancelled.elapsed())));
    }

    /// Within 0.1 px: the blur is even, and each corner is measured in the image itself (at half its size the
    /// grid is known to half a pixel).
    void aCheckerboardIsMeasuredInTheImageItself()
    {
        constexpr int columns = 9, rows = 6, side = 40;
        cv::Mat drawing((rows + 3) * side, (columns + 3) * side, CV_8UC1, cv::Scalar(225));
        for (int y = 0; y <= rows; ++y)
            for (int x = 0; x <= columns; ++x)
                if ((x + y) % 2 == 0)
                    drawing(cv::Rect((x + 1) * side, (y + 1) * side, side, side)) = 30;
        cv::resize(drawing, drawing, {}, 8, 8, cv::INTER_NEAREST);
        const Board board;
        const Vector2d first(8 * 2 * side - 0.5, 8 * 2 * side - 0.5);
        BoardSpec spec;
        spec.columns = columns;
        spec.rows = rows;
        const auto view =
            findBoard(frameOf(laid(drawing, first, board.firstPx, board.stepPx / (8 * side))), spec, "large");
        QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
        QCOMPARE(view->pixels.size(), std::size_t(columns * rows));
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) {
                const Vector2d truth = board.corner(x, y);
                double nearest = 1e9;
                for (const Vector2d &pixel : view->pixels)
                    nearest = std::min(nearest, (pixel - truth).norm());
                QVERIFY2(nearest < 0.1, qPrintable(QString::number(nearest)));
            }
    }

    void aCharucoBoardIsMeasuredInTheImageItself()
    {
        constexpr int squares = 7, side = 320;
        const auto charuco = cv::aruco::CharucoBoard::create(
            squares, 5, 1.0F, 0.5F, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_6X6_250));
        cv::Mat drawing;
        charuco->draw({squares * side + 2 * side, 5 * side + 2 * side}, drawing, side, 1);
        const Vector2d start(1500.4, 900.2), step(0.9, 0.1);
        const auto view =
            findBoard(frameOf(laid(drawing, {side - 0.5, side - 0.5}, start, step)), {}, "large");
        QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
        QCOMPARE(view->pixels.size(), std::size_t(24));
        double worst = 0;
        for (const Vector2d &pixel : view->pixels) {
            double nearest = 1e9;
            for (int y = 1; y < 5; ++y)
                for (int x = 1; x < squares; ++x) {
                    const Vector2d at = side * Vector2d(x, y);
                    nearest = std::min(nearest, (start +
                                                 Vector2d(step.x() * at.x() - step.y() * at.y(),
                                                          step.y() * at.x() + step.x() * at.y()) -
                                                 pixel)
                                                    .norm());
                }
            worst = std::max(worst, nearest);
        }
        QVERIFY2(worst < 0.1, qPrintable(QString::number(worst)));
    }

    void tagsAndRingsAreMeasuredInTheImageItself()
    {
        constexpr int cellPx = 30, tagAt = 2000, ringAt = 5000;
        cv::Mat image(height, width, CV_8UC1, cv::Scalar(200));
        const TagCells cells = *tagCells({TagFamily::AprilTag36h11, 3});
        for (int y = 0; y < cells.side; ++y)
            for (int x = 0; x < cells.side; ++x)
                image(cv::Rect(tagAt + x * cellPx, tagAt + y * cellPx, cellPx, cellPx)) =
                    cells.white[std::size_t(y * cells.side + x)] ? 200 : 30;
        cv::circle(image, {ringAt, ringAt}, 60, cv::Scalar(30), cv::FILLED, cv::LINE_AA);
        cv::circle(image, {ringAt, ringAt}, 30, cv::Scalar(200), cv::FILLED, cv::LINE_AA);
        cv::GaussianBlur(image, image, {0, 0}, 1.5);
        const Frame frame = frameOf(image);
        const double middle = tagAt + 0.5 * cells.side * cellPx - 0.5;
        const auto tags = findTags(frame);
        QCOMPARE(tags.size(), std::size_t(1));
        QCOMPARE(tags[0].number, 3);
        QVERIFY2((tags[0].pixel - Vector2d(middle, middle)).norm() < 0.05,
                 qPrintable(QString::number((tags[0].pixel - Vector2d(middle, middle)).norm())));
        const auto rings = findRoundMarkers(frame);
        const auto ring = std::ranges::find_if(rings, [&](const RoundMarker &marker) {
            return (marker.centrePx - Vector2d(ringAt, ringAt)).norm() < 3;
        });
        QVERIFY(ring != rings.end());
        QCOMPARE(ring->kind, RoundMarker::Kind::Ring);
        QVERIFY2((ring->centrePx - Vector2d(ringAt, ringAt)).norm() < 0.05,
                 qPrintable(QString::number((ring->centrePx - Vector2d(ringAt, ringAt)).norm())));
        QVERIFY(std::abs(ring->outline.semiAxes.x() - 60.5) < 1);
    }
};

ODOGRAPH_TEST(TestLargeImages, QCoreApplication)
#include "tst_large_images.moc"
