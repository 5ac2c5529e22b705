// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_detection.h"
#include "core/calibration/floor_reading.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "tests/support/real_material.h"
#include "tests/support/registered_test.h"

#include <Eigen/LU>
#include <QTest>
#include <algorithm>
#include <fstream>
#include <sstream>

using namespace odo;

namespace {

std::vector<std::vector<std::string>> readCsv(const std::filesystem::path &file)
{
    std::ifstream stream(file);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(stream, line);) {
        std::stringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');)
            rows.back().push_back(field);
    }
    rows.erase(rows.begin()); // the header
    return rows;
}

/// The numbers of the brackets that follow the n-th "data:" of a ROS calibration.
std::vector<double> rosData(const std::filesystem::path &file, int which)
{
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    std::string rest = text.str();
    for (int i = 0; i <= which; ++i)
        rest = rest.substr(rest.find("data: [") + 7);
    std::stringstream numbers(rest.substr(0, rest.find(']')));
    std::vector<double> values;
    for (std::string number; std::getline(numbers, number, ',');)
        values.push_back(QString::fromStdString(number).toDouble());
    return values;
}

CameraModel rosCamera(const std::filesystem::path &file, int widthPx, int heightPx)
{
    const std::vector<double> k = rosData(file, 0);
    Intrinsics intrinsics{widthPx,          heightPx, k[0], k[4], k[2], k[5], LensModel::Standard,
                          rosData(file, 1), {}};
    return CameraModel::create(intrinsics).value();
}

/// A board as a floor of 0.3 m squares, with the camera above it.
Eigen::Vector2d floorCorner(const BoardView &view, std::size_t index)
{
    const auto columns = std::size_t(view.columns);
    return {0.3 * double(index % columns), -0.3 * double(index / columns)};
}

/// So many corners of a board, each as far as possible from those before it.
std::vector<std::size_t> spreadCorners(const BoardView &view, std::size_t count)
{
    std::vector<std::size_t> chosen{0};
    const auto distance = [&](std::size_t index) {
        double least = HUGE_VAL;
        for (const std::size_t one : chosen)
            least = std::min(least, (floorCorner(view, one) - floorCorner(view, index)).norm());
        return least;
    };
    while (chosen.size() < count) {
        std::size_t farthest = 0;
        for (std::size_t i = 0; i < view.pixels.size(); ++i)
            farthest = distance(i) > distance(farthest) ? i : farthest;
        chosen.push_back(farthest);
    }
    return chosen;
}

std::vector<std::filesystem::path> imagesIn(const std::filesystem::path &folder, const std::string &start)
{
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().filename().string().starts_with(start) && entry.path().extension() == ".jpg")
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

Result<BoardView> boardIn(const std::filesystem::path &file, const BoardSpec &spec)
{
    const auto image = readImage(file);
    return image ? findBoard(*image, spec, file.filename().string()) : tl::unexpected(image.error());
}

/// The boards of all pictures; fails the test where one is not found.
std::vector<BoardView> boardsIn(const std::vector<std::filesystem::path> &files, const BoardSpec &spec)
{
    std::vector<BoardView> views;
    for (const auto &file : files) {
        const auto view = boardIn(file, spec);
        if (view)
            views.push_back(*view);
        else
            qWarning("%s", view.error().message().c_str());
    }
    return views;
}

BoardSpec board(BoardPattern pattern, int columns, int rows, double squareM)
{
    BoardSpec spec;
    spec.pattern = pattern;
    spec.columns = columns;
    spec.rows = rows;
    spec.squareM = squareM;
    return spec;
}

} // namespace

class TestRealCalibration : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void registersTheRealTwoCameras_data()
    {
        QTest::addColumn<QString>("camera");
        QTest::newRow("A") << QStringLiteral("A");
        QTest::newRow("B") << QStringLiteral("B");
    }
    void registersTheRealTwoCameras()
    {
        ODOGRAPH_NEED_REAL("cap-two-views");
        QFETCH(QString, camera);
        const auto folder = realMaterial() / "cap-two-views";
        MarkerLayout layout{"treadmill", {}};
        const auto number = [](const std::string &text) { return QString::fromStdString(text).toDouble(); };
        for (const auto &row : readCsv(folder / "layout.csv"))
            layout.markers.push_back({row[0], {number(row[1]) / 1000, number(row[2]) / 1000}});
        std::vector<MarkerPixel> pixels;
        for (const auto &row : readCsv(folder / ("pixels_" + camera.toStdString() + ".csv")))
            pixels.push_back({row[0], {number(row[1]), number(row[2])}});
        const CameraModel lens = rosCamera(folder / (camera.toStdString() + ".yaml"), 1088, 1920);
        const auto registration = registerFloor(layout, pixels, lens, true);
        QVERIFY2(registration.has_value(), registration ? "" : registration.error().message().c_str());
        qInfo("%s: %.3f px, %.2f mm, camera %.3f m above the floor; %s", qPrintable(camera),
              registration->rmsPx, 1000 * registration->rmsM, registration->worldFromCamera.translation.z(),
              registration->verdict.english().c_str());
        QVERIFY(registration->rmsM < 0.005);
        const auto guessed = registerFloor(layout, pixels, CameraModel::assumed(1088, 1920), false);
        QVERIFY2(guessed.has_value(), guessed ? "" : guessed.error().message().c_str());
        qInfo("%s without intrinsics: %s", qPrintable(camera), guessed->verdict.english().c_str());
        const double sigmaPx = std::sqrt(guessed->intrinsics.covariance(0, 0));
        QVERIFY(std::abs(guessed->intrinsics.fxPx - lens.intrinsics().fxPx) < 2 * sigmaPx);
        QVERIFY(sigmaPx < 0.02 * lens.intrinsics().fxPx);
    }
    /// Twelve corners of one image tell the lens, and where the other 42 are. The outer squares are narrower,
    /// so that some of these corners are off.
    void estimatesALensFromTwelveCornersOfAnImage()
    {
        ODOGRAPH_NEED_REAL("chessboard-stereo");
        const auto files = imagesIn(realMaterial() / "chessboard-stereo", "left");
        const auto views = boardsIn(files, board(BoardPattern::Checkerboard, 9, 6, 0.025));
        QCOMPARE(views.size(), std::size_t(13));
        int within = 0, points = 0;
        std::vector<double> errorsM;
        for (const BoardView &view : views) {
            MarkerLayout layout{"board", {}};
            std::vector<MarkerPixel> pixels;
            for (const std::size_t i : spreadCorners(view, 12)) {
                layout.markers.push_back({std::to_string(i), floorCorner(view, i)});
                pixels.push_back({std::to_string(i), view.pixels[i]});
            }
            const auto registration = registerFloor(layout, pixels, CameraModel::assumed(640, 480), false);
            QVERIFY2(registration.has_value(), registration ? "" : registration.error().message().c_str());
            const double sigmaPx = std::sqrt(registration->intrinsics.covariance(0, 0));
            QVERIFY2(std::abs(registration->intrinsics.fxPx - 533.5) < 3 * sigmaPx, view.source.c_str());
            QVERIFY2(sigmaPx < 30, view.source.c_str());
            const FloorReading reading(*registration, CameraModel::create(registration->intrinsics).value(),
                                       pixels, true);
            for (std::size_t i = 0; i < view.pixels.size(); ++i) {
                if (std::ranges::find(layout.markers, std::to_string(i), &Marker::label) !=
                    layout.markers.end())
                    continue;
                const auto read = reading.at(view.pixels[i]);
                QVERIFY(read.has_value());
                const Eigen::Vector2d off = read->pointInWorld - floorCorner(view, i);
                within += off.dot(read->covariance.inverse() * off) < 5.991 ? 1 : 0; // 95 % of χ²(2)
                ++points;
                errorsM.push_back(off.norm());
            }
        }
        std::ranges::sort(errorsM);
        const double medianM = errorsM[errorsM.size() / 2];
        qInfo("%d of %d other corners inside the stated 95 %%, half of them to %.2f mm of a floor of 2.4 m",
              within, points, 1000 * medianM);
        QVERIFY(within >= 0.95 * points);
        QVERIFY(medianM < 0.0015);
    }
    void calibratesTheStereoSetsCameras_data()
    {
        QTest::addColumn<QString>("side");
        QTest::addColumn<double>("publishedPx");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::newRow("left, told") << QStringLiteral("left") << 533.52 << 9 << 6;
        QTest::newRow("left, found out") << QStringLiteral("left") << 533.52 << 0 << 0;
        QTest::newRow("right") << QStringLiteral("right") << 536.81 << 9 << 6;
    }
    void calibratesTheStereoSetsCameras()
    {
        ODOGRAPH_NEED_REAL("chessboard-stereo");
        QFETCH(QString, side);
        QFETCH(double, publishedPx);
        QFETCH(int, columns);
        QFETCH(int, rows);
        const auto files = imagesIn(realMaterial() / "chessboard-stereo", side.toStdString());
        const auto views = boardsIn(files, board(BoardPattern::Checkerboard, columns, rows, 0.025));
        QCOMPARE(files.size(), std::size_t(13));
        QCOMPARE(views.size(), files.size());
        for (const BoardView &view : views)
            QCOMPARE(view.pixels.size(), std::size_t(54));
        const auto result = calibrateIntrinsics(views, 640, 480, LensModel::Standard, JobControl());
        QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
        qInfo("fx %.3f fy %.3f, RMS %.4f px; %s", result->intrinsics.fxPx, result->intrinsics.fyPx,
              result->rmsPx, result->verdict.english().c_str());
        // published with bars of 3 σ; the outer squares are narrower, and their corners do not count
        QVERIFY(std::abs(result->intrinsics.fxPx - publishedPx) < 0.85);
        QVERIFY(result->rmsPx <= 0.25);
    }
    void calibratesTheTwoCamerasFromSevenPictures_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<double>("focalPx");
        QTest::newRow("A") << QStringLiteral("cam03") << 1681.6;
        QTest::newRow("B") << QStringLiteral("cam04") << 1675.2;
    }
    void calibratesTheTwoCamerasFromSevenPictures()
    {
        ODOGRAPH_NEED_REAL("chessboards-pose2sim");
        QFETCH(QString, folder);
        QFETCH(double, focalPx);
        const auto files = imagesIn(realMaterial() / "chessboards-pose2sim" / folder.toStdString(), "cam");
        const auto views = boardsIn(files, board(BoardPattern::Checkerboard, 4, 7, 0.06));
        QCOMPARE(files.size(), std::size_t(7));
        QCOMPARE(views.size(), files.size());
        const auto result = calibrateIntrinsics(views, 1088, 1920, LensModel::Standard, JobControl());
        QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
        qInfo("fx %.3f fy %.3f, RMS %.4f px; %s", result->intrinsics.fxPx, result->intrinsics.fyPx,
              result->rmsPx, result->verdict.english().c_str());
        QVERIFY(std::abs(result->intrinsics.fxPx - focalPx) < 0.03 * focalPx);
        QVERIFY(std::abs(result->intrinsics.fyPx - focalPx) < 0.03 * focalPx);
    }
    void readsTheCharucoStills_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("corners");
        QTest::newRow("whole") << QStringLiteral("choriginal.jpg") << 24;
        QTest::newRow("occluded") << QStringLiteral("chocclusion_original.jpg") << 16;
    }
    void readsTheCharucoStills()
    {
        ODOGRAPH_NEED_REAL("charuco-stills");
        QFETCH(QString, file);
        QFETCH(int, corners);
        for (int columns : {4, 0}) {
            const auto view = boardIn(realMaterial() / "charuco-stills" / file.toStdString(),
                                      board(BoardPattern::Charuco, columns, columns ? 6 : 0, 0.04));
            QVERIFY2(view.has_value(), view ? "" : view.error().message().c_str());
            QCOMPARE(view->columns, 4);
            QCOMPARE(view->rows, 6);
            QCOMPARE(view->pixels.size(), std::size_t(corners));
        }
    }
    void calibratesAWebcamFromItsVideoOfAnInvertedCharucoBoard()
    {
        ODOGRAPH_NEED_REAL("charuco-four-webcams");
        const auto reader = VideoReader::open(realMaterial() / "charuco-four-webcams/cam_1.mp4");
        QVERIFY(reader.has_value());
        BoardSpec spec = board(BoardPattern::Charuco, 3, 4, 0.054);
        spec.dictionary = "DICT_4X4_1000";
        std::vector<BoardView> views;
        for (int index = 64; index < 111; index += 2) { // before that the board lies on a table
            const auto frame = (*reader)->frameAt(index);
            QVERIFY(frame.has_value());
            const auto view = findBoard(*frame, spec, "frame " + std::to_string(index));
            if (view)
                views.push_back(*view);
        }
        qInfo("board found in %zu of 24 frames", views.size());
        QVERIFY(views.size() >= 14);
        const auto result = calibrateIntrinsics(views, 1280, 720, LensModel::Standard, JobControl());
        QVERIFY2(result.has_value(), result ? "" : result.error().message().c_str());
        qInfo("fx %.2f, %s", result->intrinsics.fxPx, result->verdict.english().c_str());
        // camera_array.toml has 760.3, from more pictures; these cover a fifth of the picture, and the
        // verdict says so: ± 1.9 %, of which three are allowed.
        QVERIFY(std::abs(result->intrinsics.fxPx - 760.3) < 0.057 * 760.3);
        QVERIFY(result->verdict.english().starts_with("Poor"));
        QVERIFY(result->rmsPx < 0.2);
    }
};

ODOGRAPH_TEST(TestRealCalibration, QCoreApplication)
#include "tst_real_calibration.moc"
