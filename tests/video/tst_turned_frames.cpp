// SPDX-License-Identifier: GPL-3.0-or-later
// Clips that are stored turned or mirrored, with a display matrix that says so, and what turning does to
// chroma.
#include "core/video/frame_turn.h"
#include "core/video/internal/orientation.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"
#include "tests/video/foreign_files.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// Of a display matrix (a, b, c, d), by the orientation that it means.
constexpr std::array<std::array<int, 4>, 9> matrices{{{},
                                                      {1, 0, 0, 1},
                                                      {-1, 0, 0, 1},
                                                      {-1, 0, 0, -1},
                                                      {1, 0, 0, -1},
                                                      {0, 1, 1, 0},
                                                      {0, 1, -1, 0},
                                                      {0, -1, -1, 0},
                                                      {0, -1, 1, 0}}};

/// Where a pixel of a stored frame is shown, by the words of the EXIF standard on its first row and column.
Eigen::Vector2d shownAt(const Eigen::Vector2d &stored, int orientation, const FrameFormat &format)
{
    const double x = stored.x(), y = stored.y(), fromRight = format.width - 1 - x,
                 fromBottom = format.height - 1 - y;
    switch (orientation) {
    case 2: // first row top, first column right
        return {fromRight, y};
    case 3: // bottom, right
        return {fromRight, fromBottom};
    case 4: // bottom, left
        return {x, fromBottom};
    case 5: // left, top
        return {y, x};
    case 6: // right, top
        return {fromBottom, x};
    case 7: // right, bottom
        return {fromBottom, fromRight};
    case 8: // left, bottom
        return {y, fromRight};
    default:
        return stored;
    }
}

/// Every sample of a plane has a value of its own.
Frame countedFrame(const FrameFormat &format)
{
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < format.height; ++y)
        for (int x = 0; x < format.width; ++x)
            buffer->yRow(y)[x] = std::uint8_t(y * format.width + x);
    for (int y = 0; y < buffer->chromaHeight(); ++y)
        for (int x = 0; x < buffer->chromaWidth(); ++x) {
            buffer->uRow(y)[x] = std::uint8_t(y * buffer->chromaWidth() + x);
            buffer->vRow(y)[x] = std::uint8_t(128 + y * buffer->chromaWidth() + x);
        }
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

std::vector<Eigen::Vector2d> chromaPositions(const Frame &frame)
{
    const FrameFormat &format = frame.format;
    std::vector<Eigen::Vector2d> positions(std::size_t(frame.u.width * frame.u.height));
    for (int y = 0; y < frame.u.height; ++y)
        for (int x = 0; x < frame.u.width; ++x)
            positions[frame.u.at(x, y)] = {(x << format.chromaShiftX) + format.chromaOffsetX(),
                                           (y << format.chromaShiftY) + format.chromaOffsetY()};
    return positions;
}

} // namespace

class TestTurnedFrames : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }

private Q_SLOTS:
    void matrixSaysTheOrientation()
    {
        for (int orientation = 1; orientation <= 8; ++orientation) {
            const auto &[a, b, c, d] = matrices[std::size_t(orientation)];
            QCOMPARE(orientationOfMatrix(a, b, c, d), orientation);
            // two degrees beside it
            QCOMPARE(orientationOfMatrix(1000 * a - 35 * b, 1000 * b + 35 * a, 1000 * c - 35 * d,
                                         1000 * d + 35 * c),
                     orientation);
        }
        QCOMPARE(orientationOfMatrix(0, 0, 0, 0), 1); // shows nothing: damaged
    }

    void clipsAreGivenUpright_data()
    {
        QTest::addColumn<int>("orientation");
        QTest::addColumn<bool>("isMjpeg");
        for (int orientation = 1; orientation <= 8; ++orientation)
            for (const bool isMjpeg : {false, true})
                QTest::addRow("%d, %s", orientation, isMjpeg ? "MJPEG" : "H.264") << orientation << isMjpeg;
    }
    void clipsAreGivenUpright()
    {
        QFETCH(int, orientation);
        QFETCH(bool, isMjpeg);
        VideoWriterOptions options;
        options.codec = isMjpeg ? VideoCodec::Mjpeg : VideoCodec::H264;
        QCOMPARE(writeCoded(path("stored.mkv"), evenTimes(12, 25), options), QString());
        QVERIFY(remux(path("stored.mkv"), path("turned.mov"), matrices[std::size_t(orientation)]));
        QCOMPARE(VideoReader::isShownOtherwise(path("turned.mov"), {12, 1}), orientation != 1);
        const auto stored = VideoReader::open(path("turned.mov"), {}, {12, 1}),
                   turnedClip = VideoReader::open(path("turned.mov"));
        QVERIFY(stored && turnedClip);
        QCOMPARE((*stored)->info().format.width, 192);
        QCOMPARE((*turnedClip)->info().orientation, orientation);
        QCOMPARE((*turnedClip)->info().format.width, orientation < 5 ? 192 : 96);
        QCOMPARE((*turnedClip)->info().format.height, orientation < 5 ? 96 : 192);
        QCOMPARE((*turnedClip)->decodesRegions(), isMjpeg && orientation == 1);
        for (const int number : {0, 1, 2, 9, 4}) {
            const Frame expected = turned((*stored)->frameAt(number).value(), orientation),
                        frame = (*turnedClip)->frameAt(number).value();
            QCOMPARE(frame.index, number);
            QCOMPARE(frame.format.width, (*turnedClip)->info().format.width);
            QCOMPARE(frame.y.height, (*turnedClip)->info().format.height);
            QCOMPARE(fingerprint(frame), fingerprint(expected));
        }
        // a region may be asked for, and all of the frame is given
        QVERIFY((*turnedClip)->seek(3));
        const auto part = (*turnedClip)->next(PixelRect{10, 10, 40, 40}).value();
        QVERIFY(part && (orientation == 1 || !part->validRegion));
    }

    /// Its frames stay what a project has measured them as, and those of one without a matrix cost no copy.
    void framesOfAnUntouchedClipAreTheDecodersOwn()
    {
        QCOMPARE(writeCoded(path("plain.mkv"), evenTimes(3, 25), {}), QString());
        QVERIFY(!VideoReader::isShownOtherwise(path("plain.mkv"), {3, 1}));
        QVERIFY(!VideoReader::isShownOtherwise(path("missing.mkv"), {3, 1}));
        const Frame frame = (*VideoReader::open(path("plain.mkv")))->frameAt(1).value();
        QCOMPARE(FrameTurner(frame.format, 1).turned(frame).y.data, frame.y.data);
    }

    void chromaStaysWhereItIsSeen_data()
    {
        QTest::addColumn<int>("siting");
        QTest::addColumn<int>("shiftX");
        QTest::addColumn<int>("shiftY");
        for (const auto siting : {ChromaSiting::Left, ChromaSiting::Center, ChromaSiting::TopLeft,
                                  ChromaSiting::Bottom, ChromaSiting::Unknown})
            for (const auto &[x, y] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 1}, std::pair{0, 0}})
                QTest::addRow("siting %d, shifts %d %d", int(siting), x, y) << int(siting) << x << y;
    }
    void chromaStaysWhereItIsSeen()
    {
        QFETCH(int, siting);
        QFETCH(int, shiftX);
        QFETCH(int, shiftY);
        const FrameFormat format{10, 8, shiftX, shiftY, ChromaSiting(siting)};
        const Frame frame = countedFrame(format);
        const auto stored = chromaPositions(frame);
        for (int orientation = 1; orientation <= 8; ++orientation) {
            const Frame shown = turned(frame, orientation);
            QCOMPARE(shown.orientation, orientation);
            QVERIFY(sameLayout(shown.format, turnedFormat(format, orientation)));
            for (int y = 0; y < format.height; ++y)
                for (int x = 0; x < format.width; ++x) {
                    const Eigen::Vector2d at = shownAt(Eigen::Vector2d(x, y), orientation, format);
                    QCOMPARE(int(shown.y.at(int(at.x()), int(at.y()))), int(frame.y.at(x, y)));
                }
            const auto positions = chromaPositions(shown);
            for (std::size_t i = 0; i < stored.size(); ++i)
                QCOMPARE(positions[i], shownAt(stored[i], orientation, format));
        }
    }

    void degreesAndMirroring()
    {
        const std::array degrees{0, 0, 180, 180, 270, 90, 90, 270};
        for (int orientation = 1; orientation <= 8; ++orientation) {
            QCOMPARE(clockwiseDegreesOf(orientation), degrees[std::size_t(orientation) - 1]);
            const auto &[a, b, c, d] = matrices[std::size_t(orientation)];
            QCOMPARE(isMirroring(orientation), a * d - b * c < 0);
        }
    }
};

ODOGRAPH_TEST(TestTurnedFrames, QCoreApplication)
#include "tst_turned_frames.moc"
