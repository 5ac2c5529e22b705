// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_detection.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "tests/support/real_material.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

using namespace odo;

namespace {

constexpr double mostSigmas = 1.96; // 95 %

/// Images of a board by one camera.
struct RealSet
{
    std::string name;
    std::vector<std::filesystem::path> files; ///< images in their order, or one video
    /// By others, 0 where unknown; its σ as they state it, else as OpenCV does for the same images.
    double focalPx = 0, focalSigmaPx = 0;
    std::vector<BoardView> views = {};
    int widthPx = 0, heightPx = 0;
    std::size_t images = 0;
};

bool isImage(const std::filesystem::path &file)
{
    const auto type = file.extension();
    return type == ".jpg" || type == ".png" || type == ".pgm" || type == ".tif";
}

std::vector<std::filesystem::path> imagesIn(const std::filesystem::path &folder,
                                            const std::string &start = {})
{
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
        if (isImage(entry.path()) && entry.path().filename().string().starts_with(start))
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

/// The sets of the real material, and the subfolders of ODOGRAPH_BOARD_FOLDERS: a set each, with the focal
/// length by others in focal_px.txt where that is known.
std::vector<RealSet> realSets()
{
    const auto real = realMaterial();
    const auto stereo = real / "chessboard-stereo", two = real / "chessboards-pose2sim",
               webcams = real / "charuco-four-webcams";
    std::vector<RealSet> sets{{"stereo, left", imagesIn(stereo, "left"), 533.52, 0.28},
                              {"stereo, right", imagesIn(stereo, "right"), 536.81, 0.28},
                              {"Pose2Sim, camera 3", imagesIn(two / "cam03"), 1681.6, 3.6},
                              {"Pose2Sim, camera 4", imagesIn(two / "cam04"), 1675.2, 3.0},
                              {"webcam 0", {webcams / "cam_0.mp4"}, 903.55, 8.0},
                              {"webcam 1", {webcams / "cam_1.mp4"}, 760.33, 26.6},
                              {"webcam 2", {webcams / "cam_2.mp4"}, 650.80, 30.6},
                              {"webcam 3", {webcams / "cam_3.mp4"}, 639.88, 35.1}};
    const std::filesystem::path more = qEnvironmentVariable("ODOGRAPH_BOARD_FOLDERS").toStdString();
    if (more.empty())
        return sets;
    std::vector<std::filesystem::path> folders;
    for (const auto &entry : std::filesystem::directory_iterator(more)) {
        if (entry.is_directory())
            folders.push_back(entry.path());
    }
    std::ranges::sort(folders);
    for (const auto &folder : folders) {
        sets.push_back({folder.filename().string(), imagesIn(folder)});
        std::ifstream(folder / "focal_px.txt") >> sets.back().focalPx >> sets.back().focalSigmaPx;
    }
    return sets;
}

void lookFor(RealSet &set, BoardSpec &spec, const Result<Frame> &image, const std::string &source)
{
    if (!image)
        return;
    ++set.images;
    set.widthPx = image->format.width;
    set.heightPx = image->format.height;
    const auto view = findBoard(*image, spec, source);
    if (!view)
        return;
    spec.pattern = view->pattern;
    spec.columns = view->columns;
    spec.rows = view->rows;
    set.views.push_back(*view);
}

void lookFor(RealSet &set)
{
    BoardSpec spec;
    if (set.files.empty() || isImage(set.files.front())) {
        for (const auto &file : set.files)
            lookFor(set, spec, readImage(file), file.filename().string());
        return;
    }
    const auto video = VideoReader::open(set.files.front());
    QVERIFY2(video, set.name.c_str());
    for (std::int64_t frame = 0; frame < std::ssize((*video)->info().frameTimes); ++frame)
        lookFor(set, spec, (*video)->frameAt(frame), "frame " + std::to_string(frame));
}

struct Focal
{
    double px, sigmaPx;
};

struct Outcome
{
    bool accepted = false, compared = false, within = false;
};

std::optional<Focal> focalOf(const Result<IntrinsicCalibration> &result)
{
    if (!result)
        return std::nullopt;
    return Focal{result->intrinsics.fxPx, std::sqrt(result->intrinsics.covariance(0, 0))};
}

std::string wordsOf(const Result<IntrinsicCalibration> &result)
{
    if (!result)
        return "refused: " + result.error().why.english();
    const std::string verdict = result->verdict.english();
    return verdict.substr(0, verdict.find(':')) + ": " + result->modelReason.english();
}

Outcome tell(const std::string &name, std::size_t images, const Result<IntrinsicCalibration> &result,
             const std::optional<Focal> &reference, qint64 ms)
{
    Outcome outcome;
    const auto focal = focalOf(result);
    outcome.accepted = focal.has_value();
    outcome.compared = focal && reference;
    QString figures;
    if (focal)
        figures = QStringLiteral("fx %1 ± %2, RMS %3 px")
                      .arg(focal->px, 0, 'f', 1)
                      .arg(focal->sigmaPx, 0, 'f', 1)
                      .arg(result->rmsPx, 0, 'f', 2);
    if (outcome.compared) {
        const double sigmas =
            std::abs(focal->px - reference->px) / std::hypot(focal->sigmaPx, reference->sigmaPx);
        outcome.within = sigmas <= mostSigmas;
        figures += QStringLiteral(", reference %1 ± %2: %3 σ off")
                       .arg(reference->px, 0, 'f', 1)
                       .arg(reference->sigmaPx, 0, 'f', 1)
                       .arg(sigmas, 0, 'f', 1);
    }
    qInfo("%s, %zu boards, %.1f s: %s; %s", name.c_str(), images, double(ms) / 1000, qPrintable(figures),
          wordsOf(result).c_str());
    return outcome;
}

Result<IntrinsicCalibration> calibrated(const RealSet &set, const std::vector<BoardView> &views)
{
    return calibrateIntrinsics(views, set.widthPx, set.heightPx, std::nullopt, JobControl());
}

struct Count
{
    int sets = 0, accepted = 0, compared = 0, within = 0;
    void add(const Outcome &outcome)
    {
        ++sets;
        accepted += outcome.accepted ? 1 : 0;
        compared += outcome.compared ? 1 : 0;
        within += outcome.within ? 1 : 0;
    }
};

/// A part of the images beside the rest: every so-manieth still, or a stretch of a video, whose neighbouring
/// frames are alike.
void compareParts(const RealSet &set, std::size_t parts, Count &count)
{
    const bool stills = isImage(set.files.front());
    for (std::size_t part = 0; part < parts; ++part) {
        std::vector<BoardView> some, rest;
        for (std::size_t i = 0; i < set.views.size(); ++i) {
            const bool inside = (stills ? i % parts : i * parts / set.views.size()) == part;
            (inside ? some : rest).push_back(set.views[i]);
        }
        if (some.size() < 3 || rest.size() < 3)
            continue;
        QElapsedTimer clock;
        clock.start();
        const auto result = calibrated(set, some);
        const qint64 ms = clock.elapsed();
        // Two halves are one comparison.
        const auto other = parts == 2 && part == 1 ? std::nullopt : focalOf(calibrated(set, rest));
        count.add(tell(set.name + ", part " + std::to_string(part + 1) + " of " + std::to_string(parts),
                       some.size(), result, other, ms));
    }
}

} // namespace

class TestRealLensSets : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// The table of docs/accuracy.md.
    void statesTheFocalLengthsOfRealSets()
    {
        ODOGRAPH_NEED_REAL("chessboard-stereo");
        ODOGRAPH_NEED_REAL("chessboards-pose2sim");
        ODOGRAPH_NEED_REAL("charuco-four-webcams");
        Count whole, parts;
        for (RealSet &set : realSets()) {
            QElapsedTimer clock;
            clock.start();
            lookFor(set);
            if (set.views.empty()) {
                ++whole.sets;
                qInfo("%s: no board found in %zu images", set.name.c_str(), set.images);
                continue;
            }
            const auto result = calibrated(set, set.views);
            std::optional<Focal> reference;
            if (set.focalPx > 0)
                reference = Focal{set.focalPx, set.focalSigmaPx};
            whole.add(tell(set.name + ", all", set.views.size(), result, reference, clock.elapsed()));
            compareParts(set, 2, parts);
            compareParts(set, 3, parts);
        }
        qInfo("whole sets: %d of %d accepted, %d of %d inside the stated 95 %%", whole.accepted, whole.sets,
              whole.within, whole.compared);
        qInfo("parts beside the rest: %d of %d accepted, %d of %d inside the stated 95 %%", parts.accepted,
              parts.sets, parts.within, parts.compared);
        QVERIFY(whole.compared >= 6 && whole.within >= 0.9 * whole.compared);
        QVERIFY(parts.within >= 0.9 * parts.compared);
    }
};

ODOGRAPH_TEST(TestRealLensSets, QCoreApplication)
#include "tst_real_lens_sets.moc"
