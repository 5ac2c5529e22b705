// SPDX-License-Identifier: GPL-3.0-or-later
// The annotated video of a trial: what its pictures show, their times, and what is left when it cannot be
// made.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/stored_example.h"
#include "ui/report/annotated_video.h"
#include "ui/report/internal/annotated_frame.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sys/resource.h>

using namespace odo;

namespace {

constexpr QSize smallSize{640, 360};

bool hasColourNear(const QImage &image, const QPointF &place, const QColor &colour, int reach = 3,
                   int tolerance = 60)
{
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            const QPoint at = place.toPoint() + QPoint(x, y);
            if (!image.rect().contains(at))
                continue;
            const QColor got = image.pixelColor(at);
            if (std::abs(got.red() - colour.red()) + std::abs(got.green() - colour.green()) +
                    std::abs(got.blue() - colour.blue()) <
                tolerance)
                return true;
        }
    }
    return false;
}

/// Of any channel of any pixel.
int largestDifference(const QImage &a, const QImage &b)
{
    int largest = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            largest = std::max({largest, std::abs(p.red() - q.red()), std::abs(p.green() - q.green()),
                                std::abs(p.blue() - q.blue())});
        }
    return largest;
}

AnnotationStyle look(QSize size = {1280, 720})
{
    return {size, lightPalette(), QGuiApplication::font(), 1};
}

/// All views grey, at the frame of a time.
std::vector<ViewMoment> greyViews(const AnnotatedFrame &painter, const TrialScene &scene, Nanoseconds time)
{
    std::vector<ViewMoment> moments;
    for (std::size_t view = 0; view < scene.views.size(); ++view) {
        QImage grey(painter.viewSizePx(view), QImage::Format_RGB32);
        grey.fill(QColor(90, 90, 90));
        moments.push_back({grey, scene.frameAt(view, time).value_or(-1)});
    }
    return moments;
}

QImage painted(const TrialScene &scene, Nanoseconds time, AnnotationStyle shown = look())
{
    AnnotatedFrame painter(std::make_shared<TrialScene>(scene), std::move(shown));
    return painter.paint(time, greyViews(painter, scene, time));
}

std::string read(const std::filesystem::path &file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

class TestAnnotatedVideo : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

    std::filesystem::path file(const char *name = "run.mp4") const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / "out" / name;
    }
    AnnotatedVideoSettings settings() const
    {
        AnnotatedVideoSettings settings;
        settings.target = file();
        settings.sizePx = smallSize;
        return settings;
    }
    std::string failure(const std::string &trial, const AnnotatedVideoSettings &settings) const
    {
        AnnotatedVideoJob job(trial, settings);
        const auto made = runToEnd(job, *m_project, {});
        return made ? "it was made" : made.error().message();
    }
    QStringList left() const
    {
        return QDir(QString::fromStdString(file().parent_path().string())).entryList(QDir::Files);
    }

private Q_SLOTS:
    void initTestCase()
    {
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_project = std::move(*Project::open(*made, Project::Access::ReadWrite));
    }
    void init()
    {
        std::filesystem::remove_all(file().parent_path());
        std::filesystem::create_directory(file().parent_path());
    }

    void aVideoHasAPictureForEachFrame()
    {
        AnnotatedVideoJob job("Trial 1", settings());
        std::vector<double> reported;
        const auto made = runToEnd(
            job, *m_project, {{}, [&](double fraction, const Message &) { reported.push_back(fraction); }});
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        QCOMPARE(left(), QStringList{QStringLiteral("run.mp4")});
        QCOMPARE(job.frameCount(), 30);
        QVERIFY(std::ranges::is_sorted(reported));
        QCOMPARE(reported.back(), 1.0);
        auto reader = VideoReader::open(file());
        QVERIFY2(reader, reader ? "" : reader.error().message().c_str());
        const VideoInfo &info = (*reader)->info();
        QCOMPARE(info.codec, std::string("h264"));
        QCOMPARE(info.format.width, smallSize.width());
        QCOMPARE(info.format.height, smallSize.height());
        QCOMPARE(info.format.chromaShiftX + info.format.chromaShiftY, 2); // 4:2:0
        QCOMPARE(info.frameTimes.size(), std::size_t(30));
        for (std::size_t i = 0; i < 30; ++i) // microseconds are kept
            QVERIFY(std::abs(toSeconds(info.frameTimes[i]) - double(i) / 30) < 2e-6);
        QVERIFY(std::abs(toSeconds(info.duration) - job.durationS()) < 1e-3);
        // The table of contents stands before the pictures, so that the file plays while it is loaded.
        const std::string bytes = read(file());
        QVERIFY(bytes.find("moov") < bytes.find("mdat"));
    }
    void slowMotionTakesLonger()
    {
        AnnotatedVideoSettings slow = settings();
        slow.speed = 0.1;
        AnnotatedVideoJob job("Trial 2", slow); // two robots
        QVERIFY(runToEnd(job, *m_project, {}));
        const auto reader = VideoReader::open(file());
        QCOMPARE((*reader)->info().frameTimes.size(), std::size_t(30));
        QVERIFY(std::abs(toSeconds((*reader)->info().frameTimes[3]) - 1) < 2e-6);
    }
    void aFastCameraIsThinned()
    {
        const auto count = [](double framesPerS, double speed) {
            std::vector<Nanoseconds> times;
            for (int i = 0; i < framesPerS; ++i) // a second, with jitter
                times.push_back(fromSeconds((i + (i % 2 ? 0.03 : 0)) / framesPerS));
            return shownTimes(times, speed).size();
        };
        QCOMPARE(count(30, 1), std::size_t(30));
        QCOMPARE(count(60, 1), std::size_t(60));
        QCOMPARE(count(120, 1), std::size_t(60));
        QCOMPARE(count(240, 1), std::size_t(60));
        QCOMPARE(count(240, 0.25), std::size_t(240));
        QVERIFY(shownTimes({}, 1).empty());
    }

    void aPictureShowsViewsMapAndChart()
    {
        const TrialScenePtr scene = exampleScene({.frames = 60});
        const Nanoseconds now = scene->frameTimes()[40];
        for (const QSize size : {QSize(1280, 720), QSize(1920, 1080), QSize(720, 1280)}) {
            AnnotatedFrame painter(scene, look(size));
            const QImage image = painter.paint(now, greyViews(painter, *scene, now));
            QCOMPARE(image.size(), size);
            const ProfilePoint &point = scene->robots[0].analysis->profile.points[40];
            for (std::size_t view = 0; view < 2; ++view) {
                const Ellipse &seen = scene->observationAt(view, 0, 40)->ellipse;
                const double scale =
                    painter.fromImagePixels(view, {1, 0}).x() - painter.fromImagePixels(view, {0, 0}).x();
                const QPointF centre = painter.fromImagePixels(view, {seen.centrePx.x(), seen.centrePx.y()});
                const QPointF end =
                    centre + QPointF(std::cos(0.1), std::sin(0.1)) * (seen.semiMajorPx * scale);
                QVERIFY(hasColourNear(image, end, QColor(0x56, 0xb4, 0xe9))); // the outline
                const Eigen::Vector2d later = scene->robots[0].analysis->profile.points[55].position;
                const auto trail = scene->views[view].floorView->pixelFromWorld({later.x(), later.y(), 0.06});
                QVERIFY(hasColourNear(image, painter.fromImagePixels(view, {trail->x(), trail->y()}),
                                      QColor(0x56, 0xb4, 0xe9)));
            }
            QVERIFY(hasColourNear(image, painter.fromWorld(point.position),
                                  ThemeColours::of(lightPalette()).spike));
            // The cursor: a dot on the curve, and nothing there at another time.
            const QPointF dot = painter.fromChart(now, point.speedMps);
            QVERIFY(hasColourNear(image, dot, seriesColour(0, lightPalette())));
            const Nanoseconds early = scene->frameTimes()[5];
            const QImage before = painter.paint(early, greyViews(painter, *scene, early));
            const QRect stretch(painter.fromChart(now, 0).toPoint() - QPoint(8, 60), QSize(16, 50));
            QVERIFY(before.copy(stretch) != image.copy(stretch));
        }
    }
    void whatIsNotKnownHasNoPlace()
    {
        const TrialScenePtr whole = exampleScene({.frames = 10});
        TrialScene untracked = *whole;
        untracked.robots[0].analysis.reset();
        const AnnotatedFrame withMap(std::make_shared<TrialScene>(untracked), look());
        QVERIFY(withMap.hasMap() && !withMap.hasChart());
        for (SceneView &view : untracked.views)
            view.floorView.reset();
        const AnnotatedFrame bare(std::make_shared<TrialScene>(untracked), look());
        QVERIFY(!bare.hasMap() && !bare.hasChart());
        QCOMPARE(bare.floorSidePx(), 0);
        const AnnotatedFrame all(whole, look());
        QVERIFY(bare.viewSizePx(0).width() > all.viewSizePx(0).width() ||
                bare.viewSizePx(0) == all.viewSizePx(0));
        TrialScene alone = *whole;
        alone.views.resize(1);
        alone.robots[0].observations.resize(1);
        const AnnotatedFrame one(std::make_shared<TrialScene>(alone), look());
        QVERIFY(one.hasMap() && one.hasChart());
        QVERIFY(one.viewSizePx(0).width() > all.viewSizePx(0).width());
        QVERIFY(!painted(alone, Nanoseconds(0)).isNull());
        TrialScene many = *whole;
        while (many.views.size() < 5)
            many.views.push_back(many.views.front());
        QVERIFY(!painted(many, Nanoseconds(0)).isNull());
    }
    void aViewThatWasNotRecordingSaysSo()
    {
        const TrialScenePtr scene = exampleScene({.frames = 10});
        AnnotatedFrame painter(scene, look());
        std::vector<ViewMoment> moments = greyViews(painter, *scene, Nanoseconds(0));
        const QImage both = painter.paint(Nanoseconds(0), moments);
        moments[1] = {};
        const QImage without = painter.paint(Nanoseconds(0), moments);
        moments[1].frame = 3; // it was, but its picture is damaged
        const QImage damaged = painter.paint(Nanoseconds(0), moments);
        QVERIFY(without != both && damaged != both && damaged != without);
    }
    void namesAreLiteralAndKeepTheirPlace()
    {
        TrialScene scene = *exampleScene({.frames = 10});
        const auto shown = [&scene](const std::string &name) {
            scene.trial.name = scene.trial.teamName = scene.views[0].camera = name;
            return painted(scene, Nanoseconds(0));
        };
        const QImage plain = shown("Run"), markup = shown("<b>Run</b>"),
                     endless = shown(std::string(10'000, 'W')),
                     turned = shown(
                         "\u202eRun"); // NOLINT(misc-misleading-bidirectional): such a name is what is shown
        QVERIFY(markup != plain);      // the signs of it are shown
        // Neither the time nor the other view is touched by a name.
        for (const QRect &place : {QRect(1000, 0, 280, 44), QRect(660, 60, 600, 300)})
            for (const QImage &other : {markup, endless, turned})
                // edges are not smoothed alike each time
                QVERIFY(largestDifference(other.copy(place), plain.copy(place)) <= 8);
    }
    void aThemeIsChosen()
    {
        const TrialScenePtr scene = exampleScene({.frames = 10});
        AnnotationStyle dark = look();
        dark.palette = darkPalette();
        QVERIFY(painted(*scene, Nanoseconds(0)).pixelColor(3, 360).lightness() > 200);
        QVERIFY(painted(*scene, Nanoseconds(0), dark).pixelColor(3, 360).lightness() < 60);
    }

    void aCancelLeavesWhatWasThere()
    {
        std::ofstream(file()) << "....ftyp an older video";
        AnnotatedVideoJob job("Trial 1", settings());
        const CancelToken cancel;
        const auto made = runToEnd(job, *m_project, {cancel, [&cancel](double fraction, const Message &) {
                                                         if (fraction > 0.5)
                                                             cancel.cancel();
                                                     }});
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::Cancelled);
        QCOMPARE(left(), QStringList{QStringLiteral("run.mp4")});
        QCOMPARE(read(file()), std::string("....ftyp an older video"));
    }
    void aFullDiskIsSaid()
    {
        std::signal(SIGXFSZ, SIG_IGN); // as a full disk: what the system refuses to write
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        rlimit small = before;
        small.rlim_cur = 20'000;
        setrlimit(RLIMIT_FSIZE, &small);
        const std::string said = failure("Trial 1", settings());
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY2(said.starts_with("cannot write the video " + file().string() + ": "), said.c_str());
        QVERIFY2(said.ends_with("; check that the folder exists, may be written to and has free space"),
                 said.c_str());
        QCOMPARE(left(), QStringList());
    }
    void errorsAreSaid()
    {
        AnnotatedVideoSettings odd = settings(), fast = settings(), lost = settings(), again = settings();
        odd.sizePx = {641, 360};
        QCOMPARE(failure("Trial 1", odd),
                 std::string(
                     "annotated video of 'Trial 1': its size of 641x360 has an odd number of "
                     "pixels, or is not between 320x180 and 3840x2160; choose another, such as 1920x1080"));
        fast.speed = 2;
        QCOMPARE(failure("Trial 1", fast),
                 std::string("annotated video of 'Trial 1': its speed is not between 0.1 and 1; choose "
                             "another, such as 0.25"));
        const std::string said = failure("Trial 3", lost);
        QVERIFY2(said.starts_with("annotated video of 'Trial 3': the recording of camera A is not at '"),
                 said.c_str());
        const QString place = QString::fromStdString(said).section(u'\'', 3, 3);
        QDir().mkpath(QFileInfo(place).path());
        // a loop: for whoever may look everywhere, what cannot be looked at
        QFile::link(QFileInfo(place).fileName(), place);
        QCOMPARE(failure("Trial 3", lost), "file '" + place.toStdString() +
                                               "': it cannot be read (Too many levels of symbolic links); "
                                               "check that you may read the file");
        QFile::remove(place);
        again.target.existing = Existing::Refuse;
        std::ofstream(again.target.file) << "an older video";
        QCOMPARE(failure("Trial 1", again),
                 "file '" + file().string() + "': it already exists; choose another name or folder");
        AnnotatedVideoSettings nowhere = settings();
        nowhere.target = file().parent_path() / "no" / "run.mp4";
        QVERIFY(failure("Trial 1", nowhere).find("does not exist") != std::string::npos);
        nowhere.target = file("run.xyz");
        QVERIFY(failure("Trial 1", nowhere).find("neither .mkv nor .mp4") != std::string::npos);
        QVERIFY(failure("Trial 9", settings()).find("Trial 9") != std::string::npos);
        QCOMPARE(left(), QStringList{QStringLiteral("run.mp4")});
    }
};

ODOGRAPH_TEST(TestAnnotatedVideo, QApplication)
#include "tst_annotated_video.moc"
