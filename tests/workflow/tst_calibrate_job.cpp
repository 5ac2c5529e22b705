// SPDX-License-Identifier: GPL-3.0-or-later
// From pictures to a stored calibration: what is kept, what is refused, and in which words.
#include "core/calibration/board_collector.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/video/video_writer.h"
#include "core/workflow/calibrate/calibrate_job.h"
#include "core/workflow/calibrate/cameras.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <set>

using namespace odo;

namespace {

constexpr int widthPx = 640, heightPx = 360;

CameraModel camera(double focalPx = 560)
{
    return *CameraModel::create(
        {widthPx, heightPx, focalPx, focalPx + 1, 322, 178, LensModel::Standard, {-0.1, 0.02, 0, 0}, {}});
}

std::vector<RigidTransform> poses(int count)
{
    return heldBoardPoses(camera(), SimulatedBoard(), count, 5);
}

Frame rendered(const RigidTransform &cameraFromBoard, const CameraModel &through = camera())
{
    SimulatedBoard board;
    board.cameraFromBoard = cameraFromBoard;
    return renderBoard(through, board, 1, 1);
}

/// A board of 9×6 whose middle is at a place, turned about the camera's x axis.
RigidTransform posed(const Eigen::Vector3d &middle, double degrees)
{
    RigidTransform cameraFromBoard;
    cameraFromBoard.rotation = Eigen::AngleAxisd(degrees * EIGEN_PI / 180, Eigen::Vector3d::UnitX());
    cameraFromBoard.translation = middle - cameraFromBoard.rotation * Eigen::Vector3d(0.1, 0.0625, 0);
    return cameraFromBoard;
}

/// Every pixel the mean of those around it.
Frame blurred(const Frame &frame, int reach)
{
    auto buffer = std::make_shared<FrameBuffer>(frame.format);
    for (int y = 0; y < heightPx; ++y) {
        for (int x = 0; x < widthPx; ++x) {
            int sum = 0, count = 0;
            for (int v = std::max(0, y - reach); v <= std::min(heightPx - 1, y + reach); ++v)
                for (int u = std::max(0, x - reach); u <= std::min(widthPx - 1, x + reach); ++u, ++count)
                    sum += frame.y.data[v * frame.y.stride + u];
            buffer->yRow(y)[x] = std::uint8_t(sum / count);
        }
    }
    return FrameBuffer::toFrame(buffer, 0, Nanoseconds(0));
}

std::vector<BoardView> views(int count, const CameraModel &through = camera(), unsigned seed = 11)
{
    std::vector<BoardView> seen;
    for (const RigidTransform &pose : heldBoardPoses(through, SimulatedBoard(), count, seed)) {
        seen.push_back({"picture" + std::to_string(seen.size()), 9, 6, {}, {}});
        for (int i = 0; i < 54; ++i) {
            const Eigen::Vector2d point(0.025 * (i % 9), 0.025 * (i / 9));
            seen.back().pixels.push_back(*through.project(pose * Eigen::Vector3d(point.x(), point.y(), 0)));
            seen.back().pointsOnBoard.push_back(point);
        }
    }
    return seen;
}

std::string calibrationOf(const std::vector<BoardView> &of)
{
    const auto result = calibrateIntrinsics(of, widthPx, heightPx, std::nullopt, JobControl());
    return result ? "accepted" : result.error().message();
}

/// Why the one picture that was changed is not used.
std::string rejectionOf(const std::function<void(BoardView &)> &change)
{
    std::vector<BoardView> of = views(10);
    change(of[4]);
    const auto result = calibrateIntrinsics(of, widthPx, heightPx, LensModel::Standard, JobControl());
    return result && result->rejected.size() == 1 ? result->rejected[0].reason.english() : "accepted";
}

std::string offered(BoardCollector &collector, const Frame &frame)
{
    const ImageVerdict answer = collector.offer(frame, "p.png");
    return answer.refusal ? answer.refusal->message() : "accepted";
}

std::string found(const Frame &frame, int columns = 0, int rows = 0, double squareM = 0.025)
{
    BoardSpec spec;
    spec.columns = columns;
    spec.rows = rows;
    spec.squareM = squareM;
    const auto view = findBoard(frame, spec, "p.png");
    return view ? "accepted" : view.error().message();
}

const RigidTransform plain = posed({0, 0, 0.45}, 0);

} // namespace

class TestCalibrateJob : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;

    std::filesystem::path path(const QString &name) const { return m_folder->filePath(name).toStdString(); }

    std::filesystem::path written(const QString &name, const QByteArray &bytes) const
    {
        QFile file(m_folder->filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write %s", qPrintable(name));
        return path(name);
    }

    std::vector<std::filesystem::path> images(int count) const
    {
        std::vector<std::filesystem::path> files;
        for (const RigidTransform &pose : poses(count)) {
            files.push_back(path(QStringLiteral("board %1.png").arg(files.size())));
            if (!writeImage(rendered(pose), files.back()))
                qFatal("cannot write a picture");
        }
        return files;
    }

    /// The message with which a calibration from these files fails, or the reason why the last was not used.
    std::string jobOn(std::vector<std::filesystem::path> files, bool last)
    {
        CalibrateJob job({"A", std::move(files), {}, LensModel::Standard});
        const auto done = runToEnd(job, *m_project, {});
        if (!done)
            return last ? "failed: " + done.error().message() : done.error().message();
        return last && !job.calibration().rejected.empty()
                   ? job.calibration().rejected.back().reason.english()
                   : "accepted";
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = std::move(*Project::create(path(QStringLiteral("run.odo")), "run"));
    }
    void cleanup() { m_project.reset(); }

    void keepsAllThatItWasMadeFrom()
    {
        CalibrateJob job({"Cam/1", images(10), {}, std::nullopt});
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        m_project.reset();
        m_project = std::move(*Project::open(path(QStringLiteral("run.odo")), Project::Access::ReadWrite));
        const auto id = m_project->cameras().find("Cam/1")->id;
        const IntrinsicsRecord record = **m_project->cameras().currentIntrinsics(id);
        QCOMPARE(record.softwareVersion, std::string(ODOGRAPH_VERSION));
        QVERIFY(record.board.pattern == BoardPattern::Checkerboard && record.board.columns == 9 &&
                record.board.rows == 6);
        QCOMPARE(record.board.squareM, 0.025);
        QVERIFY(!record.calibration.modelReason.isEmpty());
        QCOMPARE(record.files.size(), job.calibration().images.size());
        for (const StoredImage &image : record.files) {
            QVERIFY2(image.path.starts_with("run.media/calibration/Cam-1_board_"), image.path.c_str());
            QCOMPARE(qint64(image.bytes),
                     QFileInfo(m_folder->filePath(QString::fromStdString(image.path))).size());
        }
        QVERIFY(m_project->check(true)->empty());

        // Solved again from the stored corners: the same lens; with a picture less: one of the others.
        std::vector<std::size_t> all(record.files.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = i;
        const auto again = recalibrate(record.calibration, all, {});
        QVERIFY2(again.has_value(), again ? "" : again.error().message().c_str());
        QVERIFY(std::abs(again->intrinsics.fxPx - record.calibration.intrinsics.fxPx) < 1e-3);
        all.pop_back();
        QCOMPARE(recalibrate(record.calibration, all, {})->imagesUsed(), all.size());
        // And from the stored pictures themselves.
        std::vector<std::filesystem::path> files;
        for (const StoredImage &image : record.files)
            files.push_back(path(QString::fromStdString(image.path)));
        CalibrateJob second({"Cam/1", files, {}, record.calibration.intrinsics.model});
        QVERIFY(runToEnd(second, *m_project, {}).has_value());
        QVERIFY(std::abs(second.calibration().intrinsics.fxPx / record.calibration.intrinsics.fxPx - 1) <
                0.001);
        QCOMPARE(m_project->cameras().allIntrinsics(id)->size(), std::size_t(2));
        QVERIFY(m_project->check(true)->empty());

        // The check names what is missing and what was changed.
        QVERIFY(QFile::remove(QString::fromStdString(files[0].string())));
        QFile changed(QString::fromStdString(files[1].string()));
        QVERIFY(changed.open(QIODevice::ReadWrite) && changed.seek(100) && changed.write("?") == 1);
        changed.close();
        const auto problems = m_project->check(true);
        QCOMPARE(problems->size(), std::size_t(2));
        QCOMPARE(problems->at(0).what.english(),
                 std::string("the calibration image 'board 0.png' of camera 'Cam/1' is missing"));
        QCOMPARE(
            problems->at(1).what.english(),
            std::string(
                "the calibration image 'board 1.png' of camera 'Cam/1' has changed since it was created"));
    }
    void imagesOfOnePositionCountOnce()
    {
        const auto files = images(5);
        CalibrateJob alone({"A", files, {}, std::nullopt});
        QVERIFY(runToEnd(alone, *m_project, {}).has_value());
        auto repeated = files;
        for (const RigidTransform &pose : poses(5)) {
            SimulatedBoard board;
            board.cameraFromBoard = pose;
            repeated.push_back(path(QStringLiteral("again %1.png").arg(repeated.size())));
            QVERIFY(writeImage(renderBoard(camera(), board, 1, 77), repeated.back())); // with other noise
        }
        CalibrateJob job({"B", repeated, {}, std::nullopt});
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        QCOMPARE(job.calibration().imagesUsed(), std::size_t(5));
        QCOMPARE(job.calibration().intrinsics.covariance, alone.calibration().intrinsics.covariance);
        const IntrinsicsRecord record =
            **m_project->cameras().currentIntrinsics(m_project->cameras().find("B")->id);
        QCOMPARE(record.origin.english(), std::string("calibrated from 5 images"));
        QVERIFY(record.calibration.verdict.english().find(
                    "5 of 10 images show the board in the same position as another one") !=
                std::string::npos);
        QCOMPARE(record.calibration.images.size(), std::size_t(10));
        QCOMPARE(record.calibration.imagesUsed(), std::size_t(5));
        for (std::size_t i = 0; i < 10; ++i) {
            QCOMPARE(record.calibration.images[i].used, i < 5);
            QCOMPARE(record.files[i].path.empty(), i >= 5); // its corners tell enough
        }
        QVERIFY(m_project->check(true)->empty());
        std::vector<std::size_t> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
        QCOMPARE(recalibrate(record.calibration, all, {})->imagesRepeated(), std::size_t(5));
    }
    /// The first image does not decide what the board is: it may show a part of it.
    void aCutBoardFirstCostsNoOther_data()
    {
        QTest::addColumn<double>("aside");
        QTest::addColumn<int>("used");
        QTest::newRow("half of it") << 0.285 << 19;
    }
    void aCutBoardFirstCostsNoOther()
    {
        QFETCH(double, aside);
        QFETCH(int, used);
        auto files = images(19);
        files.insert(files.begin(), path(QStringLiteral("cut.png")));
        QVERIFY(writeImage(rendered(posed({aside, 0, 0.45}, 20)), files.front()));
        const auto cut = findBoard(*readImage(files.front()), {}, "cut");
        QVERIFY(cut && cut->columns * cut->rows < 54); // another board, taken alone
        CalibrateJob job({"A", files, {}, std::nullopt});
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        const auto &calibration = job.calibration();
        QCOMPARE(int(calibration.images.size()), used);
        QCOMPARE(job.settings().board.columns, 9);
        QCOMPARE(job.settings().board.rows, 6);
        if (used == 19) {
            QCOMPARE(calibration.rejected.front().file, std::string("cut.png"));
            const std::string why = calibration.rejected.front().reason.english();
            QVERIFY2(why.starts_with("the board is cut off: only "), why.c_str());
        }
    }
    void anImageOfAnotherSizeFirstCostsNoOther()
    {
        auto files = images(8);
        files.insert(files.begin(), path(QStringLiteral("large.png")));
        SimulatedBoard board;
        board.cameraFromBoard = posed({0, 0, 0.6}, 0);
        QVERIFY(writeImage(renderBoard(CameraModel::assumed(800, 600), board, 1, 1), files.front()));
        CalibrateJob job({"A", files, {}, std::nullopt});
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        QCOMPARE(job.calibration().images.size(), std::size_t(8));
        QCOMPARE(job.calibration().rejected.front().file, std::string("large.png"));
        QCOMPARE(job.calibration().rejected.front().reason.english(),
                 std::string("it is 800×600, the other images are 640×360"));
    }
    /// A hand that stops ten times: of the frames before, at and behind each stop only the sharp one is
    /// taken.
    void theSharpFramesOfAClipAreTaken()
    {
        const auto clip = path(QStringLiteral("clip.mkv"));
        VideoWriterOptions options;
        options.codec = VideoCodec::Mjpeg;
        const auto held = poses(10);
        auto writer = VideoWriter::create(clip, rendered(held[0]).format, options);
        QVERIFY2(writer.has_value(), writer ? "" : writer.error().message().c_str());
        for (int i = 0; i < 30; ++i) { // twelve frames a second
            Frame frame = rendered(held[std::size_t(i / 3)]);
            if (i % 3 != 1)
                frame = blurred(frame, 3);
            frame.time = Nanoseconds(std::int64_t(i) * 1'000'000'000 / 12);
            QVERIFY((*writer)->write(frame).has_value());
        }
        QVERIFY((*writer)->finish().has_value());
        CalibrateJob job({"A", {clip}, {}, std::nullopt});
        const auto done = runToEnd(job, *m_project, {});
        QVERIFY2(done.has_value(), done ? "" : done.error().message().c_str());
        QVERIFY(job.calibration().images.size() >= 8);
        for (const CalibrationImage &image : job.calibration().images) {
            const std::string &source = image.view.source;
            const int index = QString::fromStdString(source.substr(source.find('@') + 1)).toInt();
            QVERIFY2(index % 3 == 1, source.c_str());
        }
        QVERIFY(std::abs(job.calibration().intrinsics.fxPx - 560) < 6); // one per cent
    }
    void whatFailsLeavesNothing()
    {
        const auto files = images(8);
        JobControl control;
        control.progress = [&](double fraction, const Message &) {
            if (fraction > 0.5)
                control.cancel.cancel();
        };
        CalibrateJob cancelledJob({"A", files, {}, std::nullopt});
        QCOMPARE(runToEnd(cancelledJob, *m_project, control).error().code, ErrorCode::Cancelled);
        CalibrateJob tooFew({"A", {files[0], files[1]}, {}, std::nullopt});
        QVERIFY(!runToEnd(tooFew, *m_project, {}).has_value());
        // Its rows cannot be stored, after its pictures were written.
        CalibrateJob unnamed({std::string(300, 'x'), files, {}, std::nullopt});
        QVERIFY(!runToEnd(unnamed, *m_project, {}).has_value());
        QVERIFY(m_project->cameras().all()->empty());
        QVERIFY(!std::filesystem::exists(m_project->mediaFolder()));
    }

    void everyKindOfBadInputHasItsSentence_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("words");
        const char *rows[][2] = {
            {"no board", "no board found; show the whole board, flat, sharp and well lit"},
            {"another size", "inner corners, not 7x5; count the inner corners, or leave the size out"},
            {"blurred", "the board is blurred: its edges are "},
            {"cut off", "keep the whole board in view"},
            {"too oblique", "the board is tilted too far, by "},
            {"too small", "the board is too small: it fills "},
            {"another resolution",
             "the other images are 640×360; use images of one camera at one resolution"},
            {"the same pose again",
             "the board is in the same position as in p.png; move it elsewhere, turn it or tilt it"},
            {"no such file", "the file does not exist; check the name and the folder"},
            {"not a picture", "it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image"},
            {"damaged picture", "its content is damaged or cut short"},
            {"empty video", "the file is empty"},
            {"too few", "calibration needs three images of the board, 2 can be used; take ten or more"},
            {"all frontal", "take images with the board tilted by 30 to 45 degrees, to each side"},
            {"all in one place", "show the board in one position, the upper left"},
            {"two zooms", "the images do not agree on one focal length: 8 give about "},
            {"not a number", "a corner of it is not a number: detect the board in it again"},
            {"too few corners", "it has 4 corners of the board, six are needed: show more of it"},
            {"collinear corners",
             "its corners do not match a flat board: glue the board onto something stiff"},
            {"squares of no size", "the squares have no size; give a size such as 25mm"},
            {"a board of 2×2", "a board of 2x2 inner corners is too small; give at least 3x3, such as 9x6"},
            {"a picture without size", "the image has no size; use images from the camera"},
        };
        int kind = 0;
        for (const auto &[name, words] : rows)
            QTest::newRow(name) << kind++ << QString::fromUtf8(words);
    }
    void everyKindOfBadInputHasItsSentence()
    {
        QFETCH(int, kind);
        QFETCH(QString, words);
        const std::string told = messageOf(kind);
        QVERIFY2(QString::fromStdString(told).contains(words), told.c_str());
        QVERIFY(told.find('\n') == std::string::npos);
    }

private:
    std::string messageOf(int kind)
    {
        BoardCollector collector({});
        const auto withGood = [this](const std::filesystem::path &bad) {
            auto files = images(8);
            files.push_back(bad);
            return jobOn(files, true);
        };
        switch (kind) {
        case 0:
            return found(rendered(posed({0, 0, 60}, 0)));
        case 1:
            return found(rendered(plain), 7, 5);
        case 2:
            return found(blurred(rendered(plain), 8));
        case 3:
            return found(rendered(posed({0.255, 0, 0.45}, 0)), 9, 6);
        case 4: {
            RigidTransform oblique;
            oblique.rotation = Eigen::AngleAxisd(68 * EIGEN_PI / 180, Eigen::Vector3d::UnitY());
            oblique.translation =
                Eigen::Vector3d(0, 0, 0.3) - oblique.rotation * Eigen::Vector3d(0.1, 0.0625, 0);
            return offered(collector, rendered(oblique, CameraModel::assumed(widthPx, heightPx)));
        }
        case 5:
            return offered(collector,
                           rendered(posed({0, 0, 2.6}, 0), CameraModel::assumed(widthPx, heightPx)));
        case 6: {
            offered(collector, rendered(plain));
            SimulatedBoard board;
            board.cameraFromBoard = posed({0, 0, 0.6}, 0);
            return offered(collector, renderBoard(CameraModel::assumed(800, 600), board, 1, 1));
        }
        case 7:
            offered(collector, rendered(plain));
            return offered(collector, rendered(plain));
        case 8:
            return jobOn({path(QStringLiteral("gone.png"))}, false);
        case 9:
            return withGood(written(QStringLiteral("letter.png"), "Dear class"));
        case 10: {
            QFile whole(QString::fromStdString(images(1)[0].string()));
            return whole.open(QIODevice::ReadOnly)
                       ? withGood(written(QStringLiteral("half.png"), whole.read(400)))
                       : "";
        }
        case 11:
            return withGood(written(QStringLiteral("clip.mp4"), {}));
        case 12:
            return jobOn(images(2), false);
        case 13: {
            std::vector<BoardView> frontal;
            for (int i = 0; i < 12; ++i) {
                const Eigen::Vector3d middle(0.1 * (i % 4 - 1.5), 0.06 * (i / 4 - 1), 0.5 + 0.02 * i);
                frontal.push_back(*findBoard(rendered(posed(middle, 0)), {}, "frontal" + std::to_string(i)));
            }
            return calibrationOf(frontal);
        }
        case 14: {
            std::vector<BoardView> still = views(12);
            for (BoardView &view : still)
                for (Eigen::Vector2d &pixel : view.pixels)
                    pixel *= 0.3;
            return calibrationOf(still);
        }
        case 15: {
            std::vector<BoardView> mixed = views(8);
            for (BoardView &view : views(8, camera(760), 20))
                mixed.push_back(view);
            return calibrationOf(mixed);
        }
        case 16:
            return rejectionOf([](BoardView &view) { view.pixels[7].y() = std::nan(""); });
        case 17:
            return rejectionOf([](BoardView &view) {
                view.pixels.resize(4);
                view.pointsOnBoard.resize(4);
            });
        case 18:
            return rejectionOf([](BoardView &view) {
                for (Eigen::Vector2d &point : view.pointsOnBoard)
                    point.y() = 0;
            });
        case 19:
            return found(rendered(plain), 9, 6, 0);
        case 20:
            return found(rendered(plain), 2, 2);
        default:
            return calibrateIntrinsics(views(8), 0, 0, std::nullopt, {}).error().message();
        }
    }
};

ODOGRAPH_TEST(TestCalibrateJob, QCoreApplication)
#include "tst_calibrate_job.moc"
