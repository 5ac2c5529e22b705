// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with pictures of a board, one by one and together: each kind in words of its own. Those of
// the floor's markers are in tst_floor_sentences.
#include "core/calibration/board_collector.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/simulation/renderer.h"
#include "tests/calibration/seen_boards.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <set>

using namespace odo;
using Eigen::Vector3d;

namespace {

constexpr double degree = EIGEN_PI / 180;

/// The board's middle at a place of the camera's frame, turned about the camera's y axis.
SimulatedBoard boardAt(const Vector3d &middle, double turnDegrees)
{
    SimulatedBoard board;
    board.cameraFromBoard.rotation = Eigen::AngleAxisd(turnDegrees * degree, Vector3d::UnitY());
    board.cameraFromBoard.translation =
        middle - board.cameraFromBoard.rotation * (0.025 * Vector3d(4, 2.5, 0));
    return board;
}

Frame seen(const SimulatedBoard &board, int widthPx = 640, int heightPx = 360)
{
    return renderBoard(CameraModel::assumed(widthPx, heightPx), board, 2, 1);
}

/// The answer to a picture after a sound one.
std::optional<Error> answerTo(const Frame &image)
{
    BoardCollector collector({});
    if (!collector.offer(seen(boardAt({0, 0, 0.45}, 0)), "first.png").kept)
        return std::nullopt;
    return collector.offer(image, "second.png").refusal;
}

Frame blurred()
{
    const Frame sharp = seen(boardAt({0.03, 0, 0.4}, 20));
    auto buffer = std::make_shared<FrameBuffer>(sharp.format);
    constexpr int reach = 9;
    for (int y = 0; y < sharp.y.height; ++y)
        for (int x = 0; x < sharp.y.width; ++x) {
            int sum = 0;
            for (int dx = -reach; dx <= reach; ++dx)
                sum += sharp.y.at(std::clamp(x + dx, 0, sharp.y.width - 1), y);
            buffer->yRow(y)[x] = static_cast<std::uint8_t>(sum / (2 * reach + 1));
        }
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

Frame empty()
{
    auto buffer = std::make_shared<FrameBuffer>(FrameFormat{.width = 640, .height = 360});
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

std::optional<Error> answerTo(const std::vector<BoardView> &views)
{
    const auto result = calibrateIntrinsics(views, 1280, 720, LensModel::Standard, JobControl());
    return result ? std::nullopt : std::optional(result.error());
}

const CameraModel camera = CameraModel::assumed(1280, 720);

/// Twelve boards at a distance, as far from its middle and as much tilted as told at most.
std::vector<BoardView> twelve(double depthM, const Vector3d &spread, double tilt)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> across(-1, 1);
    std::vector<BoardView> views;
    for (int i = 0; i < 12; ++i) {
        const Vector3d middle(spread.x() * across(random), spread.y() * across(random),
                              depthM + spread.z() * across(random));
        views.push_back(see(camera, middle, tilt * across(random), tilt * across(random), 0.2, random, 0.2));
        views.back().source = "picture" + std::to_string(i);
    }
    return views;
}

/// Half of the pictures are another camera's.
std::vector<BoardView> ofTwoCameras()
{
    Intrinsics other = camera.intrinsics();
    other.fxPx *= 1.4;
    other.fyPx *= 1.4;
    std::vector<BoardView> views = tiltedViews(camera, 8, 0.1),
                           more = tiltedViews(*CameraModel::create(other), 8, 0.1, 2);
    views.insert(views.end(), more.begin(), more.end());
    return views;
}

struct BadInput
{
    const char *kind;
    std::optional<Error> (*answer)();
    const char *words;
};

const BadInput badInputs[] = {
    {"no board", [] { return answerTo(empty()); }, "no board found"},
    {"blurred", [] { return answerTo(blurred()); }, "blurred"},
    {"too oblique",
     [] {
         return answerTo(seen(boardAt({0, 0, 0.3}, 68)));
     },
     "tilted too far"},
    {"too small",
     [] {
         return answerTo(seen(boardAt({0, 0, 2.6}, 0)));
     },
     "too small"},
    {"the same pose again",
     [] {
         return answerTo(seen(boardAt({0.002, 0, 0.451}, 1)));
     },
     "is in the same position as in first.png"},
    {"another board",
     [] {
         SimulatedBoard board = boardAt({0.03, 0, 0.4}, 20);
         board.columns = 8;
         return answerTo(seen(board));
     },
     "this board has 8x6 inner corners, not 9x6"},
    {"another size of picture",
     [] {
         return answerTo(seen(boardAt({0.03, 0, 0.4}, 20), 800, 600));
     },
     "it is 800×600, the other images are 640×360"},
    {"too few", [] { return answerTo(tiltedViews(camera, 2, 0.1)); },
     "calibration needs three images of the board, 2 can be used"},
    {"all frontal",
     [] {
         return answerTo(twelve(0.7, {0.3, 0.18, 0.1}, 0));
     },
     "at nearly the same tilt"},
    {"all in one place",
     [] {
         return answerTo(twelve(1.3, {0.01, 0.01, 0.01}, 0.5));
     },
     "show the board in one position, the middle"},
    {"two cameras", [] { return answerTo(ofTwoCameras()); }, "focal length"},
};

} // namespace

class TestLensSentences : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachKindOfBadInputHasItsOwnSentence()
    {
        std::set<std::string> sentences;
        for (const BadInput &bad : badInputs) {
            const auto error = bad.answer();
            QVERIFY2(error, bad.kind);
            qInfo("%s: %s", bad.kind, error->message().c_str());
            QVERIFY2(error->why.english().find(bad.words) != std::string::npos,
                     (std::string(bad.kind) + ": " + error->message()).c_str());
            QVERIFY2(!error->advice.english().empty(), bad.kind);
            QVERIFY2(sentences.insert(error->why.english()).second, bad.kind);
        }
    }
};

ODOGRAPH_TEST(TestLensSentences, QCoreApplication)
#include "tst_lens_sentences.moc"
