// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that are no plain boxes, without a word about them or with their colour told, from the videos to the curves.
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/video_reader.h"
#include "core/workflow/view_tracking.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;

namespace {

using Vector = Eigen::Vector3d;

struct Look
{
    const char *name;
    RgbColour body, deck;
    bool hasWheels = true;
    double boxFromM = 0; ///< above the floor, without wheels
};

SimulatedRobot robotOf(const Look &look, std::shared_ptr<const Motion> motion)
{
    SimulatedRobot robot;
    robot.name = look.name;
    robot.heightM = 0.11;
    robot.motion = std::move(motion);
    const auto add = [&robot](SimulatedShape shape, RgbColour colour, Vector centre, Vector size) {
        robot.parts.push_back({shape, colour, std::move(centre), std::move(size)});
    };
    const double from = look.hasWheels ? 0.022 : look.boxFromM;
    add(SimulatedShape::Box, look.body, {0, 0, (from + 0.06) / 2}, {0.24, 0.14, 0.06 - from});
    add(SimulatedShape::Box, look.deck, {-0.03, 0, 0.085}, {0.11, 0.1, 0.05});
    if (look.hasWheels)
        for (const double x : {0.075, -0.075})
            for (const double y : {0.085, -0.085})
                add(SimulatedShape::Wheel, {28, 28, 30}, {x, y, 0.034}, {0.068, 0.028, 0.068});
    return robot;
}

struct Figures
{
    double foundShare = 0, rmsM = 0, insideShare = 0, velocityRms = 0, accelerationRms = 0;
    int spikes = 0;
};

Figures compared(const Profile &profile, const SimulatedScene &scene)
{
    Figures figures;
    double count = 0;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        figures.foundShare += profile.samples[i].position.has_value() / double(profile.points.size());
        const ProfilePoint &point = profile.points[i];
        if (!point.valid)
            continue;
        const MotionState truth = scene.robots.front().motion->at(sceneTimeOfStamp(scene, 0, profile.samples[i].time));
        const Eigen::Vector2d off = point.position - truth.position;
        figures.rmsM += off.squaredNorm();
        figures.velocityRms += (point.velocity - truth.velocity).squaredNorm();
        figures.accelerationRms += (point.acceleration - truth.acceleration).squaredNorm();
        figures.insideShare += (std::abs(off.x()) < 1.96 * point.sigmaXM) + (std::abs(off.y()) < 1.96 * point.sigmaYM);
        count += 1;
    }
    figures.rmsM = std::sqrt(figures.rmsM / count);
    figures.velocityRms = std::sqrt(figures.velocityRms / count);
    figures.accelerationRms = std::sqrt(figures.accelerationRms / count);
    figures.insideShare /= 2 * count;
    figures.spikes = int(profile.spikes.size());
    return figures;
}

} // namespace

class TestAnyLook : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void isMeasured_data()
    {
        QTest::addColumn<int>("look");
        QTest::addColumn<int>("way");
        QTest::addColumn<bool>("isColourTold");
        QTest::newRow("red rover, black wheels, in lamp light") << 0 << 0 << false;
        QTest::newRow("white") << 1 << 0 << false;
        QTest::newRow("black") << 2 << 1 << false;
        QTest::newRow("grey box that stands for most of the time") << 3 << 2 << false;
        QTest::newRow("red rover, black wheels, its colour told") << 0 << 0 << true;
        QTest::newRow("blue box 8 mm above the floor, its colour told") << 4 << 0 << true;
    }
    void isMeasured()
    {
        QFETCH(int, look);
        QFETCH(int, way);
        QFETCH(bool, isColourTold);
        const Look looks[] = {{"red", {200, 35, 40}, {215, 205, 160}}, {"white", {240, 240, 236}, {30, 60, 140}}, {"black", {32, 32, 34}, {44, 44, 46}}, {"grey", {70, 70, 73}, {235, 235, 235}, false},
                              {"blue", {30, 70, 190}, {30, 70, 190}, false, 0.008}};
        SimulatedScene scene = demoTestbed(std::uint32_t(31 + look));
        scene.durationS = way == 2 ? 14 : 8;
        scene.lamps = {Lamp{{0.4, 0.2, 2.4}, 0.12, 0.3}};
        const std::shared_ptr<const Motion> ways[] = {makeFigureEightMotion({1.5, 1.1}, 0.9, 0.55, 6, 0.5), makeCircleMotion({1.5, 1.1}, 0.7, 0.7, 0.6),
                                                      makeLineMotion({0.6, 0.7}, {2.4, 1.5}, 10, 3)};
        scene.robots = {robotOf(looks[look], ways[way])};
        const QTemporaryDir folder;
        std::vector<RegisteredView> views(2);
        for (int camera = 0; camera < 2; ++camera) {
            RegisteredView &view = views[std::size_t(camera)];
            view.file = folder.filePath(QString::number(camera) + QStringLiteral(".mp4")).toStdString();
            QVERIFY(renderVideo(scene, camera, view.file, {}, {}));
            view.recording.cameraName = scene.cameras[std::size_t(camera)].name;
            view.recording.frameTimes = (*VideoReader::open(view.file))->info().frameTimes;
            view.recording.startOffsetS = scene.cameras[std::size_t(camera)].startOffsetS - scene.cameras[0].startOffsetS;
            view.floorView = scene.cameras[std::size_t(camera)].view;
        }
        RobotRecord robot;
        robot.name = looks[look].name;
        if (isColourTold)
            robot.colour = looks[look].body;
        auto tracked = trackViews(views, {robot}, {});
        QVERIFY(tracked.has_value());
        const auto profile = analyse(takeViewTracks(views, *tracked, 0), shapeOf(robot), {});
        QVERIFY2(profile.has_value(), profile ? "" : profile.error().message().c_str());
        const Figures figures = compared(*profile, scene);
        const QString words = QStringLiteral("found %1, %2 mm, %3 inside, %4 mm/s, %5 mm/s2, %6 spikes").arg(figures.foundShare).arg(1e3 * figures.rmsM)
                                  .arg(figures.insideShare).arg(1e3 * figures.velocityRms).arg(1e3 * figures.accelerationRms).arg(figures.spikes);
        qInfo("%s", qPrintable(words));
        QVERIFY2(figures.foundShare > 0.99 && figures.rmsM < 0.004 && figures.insideShare > 0.9 && figures.spikes <= 1, qPrintable(words));
    }
};

QTEST_GUILESS_MAIN(TestAnyLook)
#include "tst_any_look.moc"
