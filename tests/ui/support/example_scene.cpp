// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/example_scene.h"

#include "core/video/video_writer.h"

#include <QImage>
#include <QPainter>
#include <QtGlobal>
#include <cmath>
#include <random>

namespace odo {

namespace {

constexpr double framesPerSecond = 30, heightM = 0.06, markerX = 3.0, markerY = 2.2;

/// A camera that looks at a point, x to the right and y down.
FloorView lookingAt(const Eigen::Vector3d &from, const Eigen::Vector3d &target, const ExampleOptions &options)
{
    const Eigen::Vector3d z = (target - from).normalized(),
                          x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    Intrinsics intrinsics;
    intrinsics.widthPx = options.widthPx;
    intrinsics.heightPx = options.heightPx;
    intrinsics.fxPx = intrinsics.fyPx = 0.75 * options.widthPx;
    intrinsics.cxPx = (options.widthPx - 1) / 2.0;
    intrinsics.cyPx = (options.heightPx - 1) / 2.0;
    return FloorView(CameraModel::create(intrinsics).value(), {Eigen::Quaterniond(axes), from},
                     Eigen::Matrix<double, 6, 6>::Zero());
}

QPointF seen(const FloorView &view, double x, double y, double z)
{
    const auto pixel = view.pixelFromWorld({x, y, z});
    Q_ASSERT(pixel);
    return {pixel->x() + 0.5, pixel->y() + 0.5};
}

QImage paintedFrame(const FloorView &view, const std::vector<Eigen::Vector2d> &robots,
                    const ExampleOptions &options)
{
    QImage image(options.widthPx, options.heightPx, QImage::Format_RGB32);
    image.fill(QColor(104, 114, 124));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(186, 180, 166));
    constexpr double rim = 0.25;
    painter.drawPolygon(
        QPolygonF({seen(view, -rim, -rim, 0), seen(view, markerX + rim, -rim, 0),
                   seen(view, markerX + rim, markerY + rim, 0), seen(view, -rim, markerY + rim, 0)}));
    painter.setBrush(QColor(40, 40, 44));
    for (const QPointF &marker : {seen(view, 0, 0, 0), seen(view, markerX, 0, 0), seen(view, 0, markerY, 0),
                                  seen(view, markerX, markerY, 0)})
        painter.drawEllipse(marker, 3, 2);
    for (const Eigen::Vector2d &at : robots) {
        constexpr double half = 0.1;
        for (const double z : {0.0, heightM}) {
            painter.setBrush(z > 0 ? QColor(0xd7, 0x23, 0x28) : QColor(0x80, 0x18, 0x1c));
            painter.drawPolygon(QPolygonF(
                {seen(view, at.x() - half, at.y() - half, z), seen(view, at.x() + half, at.y() - half, z),
                 seen(view, at.x() + half, at.y() + half, z), seen(view, at.x() - half, at.y() + half, z)}));
        }
    }
    return image;
}

/// BT.601, limited range, 4:2:0.
Frame toFrame(const QImage &image, std::int64_t index, Nanoseconds time)
{
    FrameFormat format;
    format.width = image.width();
    format.height = image.height();
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < image.height(); ++y) {
        const auto *line = reinterpret_cast<const QRgb *>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x) {
            const double r = qRed(line[x]), g = qGreen(line[x]), b = qBlue(line[x]);
            buffer->yRow(y)[x] = std::uint8_t(16 + 0.257 * r + 0.504 * g + 0.098 * b);
            if (x % 2 == 0 && y % 2 == 0) {
                buffer->uRow(y / 2)[x / 2] = std::uint8_t(128 - 0.148 * r - 0.291 * g + 0.439 * b);
                buffer->vRow(y / 2)[x / 2] = std::uint8_t(128 + 0.439 * r - 0.368 * g - 0.071 * b);
            }
        }
    }
    return FrameBuffer::toFrame(std::move(buffer), index, time);
}

void writeVideo(const SceneView &view, const ExampleOptions &options)
{
    std::unique_ptr<VideoWriter> writer;
    const auto &times = view.recording.frameTimes;
    for (std::size_t i = 0; i < times.size(); ++i) {
        std::vector<Eigen::Vector2d> robots;
        for (int robot = 0; robot < options.robots; ++robot)
            robots.push_back(examplePosition(toSeconds(times[i]), robot));
        const Frame frame =
            toFrame(paintedFrame(*view.floorView, robots, options), std::int64_t(i), times[i]);
        if (!writer) {
            OutputTarget target = view.file;
            target.isOwnMedia = true;
            writer = VideoWriter::create(target, frame.format, {}).value();
        }
        if (!writer->write(frame))
            qFatal("the example video cannot be written");
    }
    if (!writer->finish())
        qFatal("the example video cannot be finished");
}

Profile exampleProfile(const std::vector<Nanoseconds> &times, int robot)
{
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, 0.0015);
    Profile profile;
    profile.heightM = heightM;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = toSeconds(times[i]), h = 1e-3;
        const Eigen::Vector2d p = examplePosition(t, robot);
        const Eigen::Vector2d after = examplePosition(t + h, robot), before = examplePosition(t - h, robot);
        ProfilePoint point;
        point.position = p;
        point.velocity = (after - before) / (2 * h);
        point.acceleration = (after - 2 * p + before) / (h * h);
        point.sigmaXM = point.sigmaYM = 0.002;
        point.speedMps = point.velocity.norm();
        point.sigmaSpeedMps = 0.02;
        point.accelMps2 = point.acceleration.norm();
        point.sigmaAccelMps2 = 0.2;
        point.valid = true;
        profile.points.push_back(point);
        Sample sample;
        sample.time = times[i];
        sample.frame = std::int64_t(i);
        sample.position = p + Eigen::Vector2d(noise(random), noise(random));
        sample.views = 3;
        profile.samples.push_back(sample);
    }
    const auto spike = [&](double part, SampleFlags flags, const char *reason) {
        const auto index = static_cast<std::size_t>(part * double(times.size()));
        profile.samples[index].flags = flags;
        *profile.samples[index].position += Eigen::Vector2d(0.06, 0.05);
        profile.spikes.push_back({std::int64_t(index), times[index], flags, foreignWords(reason)});
    };
    if (robot == 0) {
        spike(0.33, flagBit(SampleFlag::ViewsDisagree), "views disagree by 84 mm");
        spike(0.52, flagBit(SampleFlag::Jump), "jump of 212 mm");
        spike(0.80, flagBit(SampleFlag::ByHand), "low score in A, B used");
    }
    profile.metrics = {{"duration", "s", 9.84, 0.02},     {"path_length", "m", 11.42, 0.03},
                       {"mean_speed", "m/s", 1.16, 0.01}, {"max_speed", "m/s", 2.06, 0.02},
                       {"max_accel", "m/s²", 3.12, 0.2},  {"moving_time", "s", 9.2, 0.03},
                       {"stops", "1", 2, std::nullopt}};
    return profile;
}

SceneView exampleView(const char *name, const Eigen::Vector3d &from, const std::vector<Nanoseconds> &times,
                      const ExampleOptions &options)
{
    SceneView view;
    view.camera = name;
    view.recording.cameraName = name;
    view.recording.widthPx = options.widthPx;
    view.recording.heightPx = options.heightPx;
    view.recording.framesPerSecond = framesPerSecond;
    view.recording.frameTimes = times;
    view.file = options.videoFolder / (std::string(name) + ".mkv");
    view.floorView = lookingAt(from, {1.5, 1.1, 0}, options);
    view.registration.emplace();
    view.registration->worldFromCamera = view.floorView->worldFromCamera();
    view.registration->poseCovariance.setZero();
    view.registration->rmsPx = 0.4;
    view.registration->rmsM = 0.0016;
    return view;
}

} // namespace

Eigen::Vector2d examplePosition(double seconds, int robot)
{
    // A figure eight whose phase runs unevenly, so that the speed has hills and valleys; starts from rest.
    const double t = std::max(0.0, seconds - 0.7 * robot);
    const double phase = 1.1 * t * t / (t + 1.0) + 0.25 * (1 - std::cos(2 * t));
    return {1.5 + 0.95 * std::sin(phase), 1.1 + 0.62 * std::sin(2 * phase)};
}

TrialScenePtr exampleScene(const ExampleOptions &options)
{
    auto scene = std::make_shared<TrialScene>();
    std::vector<Nanoseconds> times;
    for (int i = 0; i < options.frames; ++i)
        times.push_back(fromSeconds(i / framesPerSecond));
    scene->trial.name = "Trial 3";
    scene->trial.teamName = "Falcon";
    scene->trial.syncMethod = "auto";
    scene->trial.syncOffsetSigmaS = 0.0012;
    scene->layout = MarkerLayout{
        "floor", {{"O", {0, 0}}, {"U", {markerX, 0}}, {"V", {0, markerY}}, {"D", {markerX, markerY}}}};
    scene->views.push_back(exampleView("A", {1.2, -2.2, 2.0}, times, options));
    scene->views.push_back(exampleView("B", {4.4, -1.2, 2.1}, times, options));
    scene->views[1].recording.syncMethod = scene->trial.syncMethod;
    scene->views[1].recording.startOffsetSigmaS = scene->trial.syncOffsetSigmaS;
    for (int robot = 0; robot < options.robots; ++robot) {
        SceneRobot shown;
        shown.robot.name = robot == 0 ? "Red 2" : "Blue 1";
        shown.robot.colour = {0xd7, 0x23, 0x28};
        shown.analysis.emplace();
        shown.analysis->profile = exampleProfile(times, robot);
        for (const SceneView &view : scene->views) {
            std::vector<Observation> observations;
            for (std::size_t i = 0; i < times.size(); ++i) {
                const Eigen::Vector2d p = examplePosition(toSeconds(times[i]), robot);
                Observation observation;
                observation.frame = std::int64_t(i);
                observation.time = times[i];
                observation.found = true;
                observation.ellipse = {*view.floorView->pixelFromWorld({p.x(), p.y(), heightM}),
                                       0.03 * options.widthPx, 0.015 * options.widthPx, 0.1};
                observation.score = 0.9;
                observations.push_back(observation);
            }
            shown.observations.push_back(std::move(observations));
        }
        scene->robots.push_back(std::move(shown));
    }
    if (!options.videoFolder.empty()) {
        for (const SceneView &view : scene->views)
            writeVideo(view, options);
    }
    return scene;
}

} // namespace odo
