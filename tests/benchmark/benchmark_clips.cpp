// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/benchmark_clips.h"

#include "core/simulation/demo_testbed.h"
#include "core/simulation/internal/robot_body.h"
#include "core/simulation/renderer.h"

#include <limits>

namespace odo::test {

namespace {

using Eigen::Vector2d;

/// Blue tape and a brown patch lie about, as they do on floors; a flat disc has no sides that would belong to
/// it or not.
SimulatedScene sceneOfDiscs(double durationS, ChromaSiting siting)
{
    SimulatedScene scene = demoTestbed(21);
    scene.durationS = durationS;
    scene.cameras.erase(scene.cameras.begin() + 1, scene.cameras.end());
    scene.cameras[0].sensor.siting = siting;
    constexpr RgbColour colours[] = {{215, 35, 40}, {31, 157, 77}, {140, 50, 180}};
    for (int i = 0; i < 3; ++i) {
        SimulatedRobot disc;
        disc.name = "disc " + std::to_string(i);
        disc.colour = colours[i];
        disc.shape = SimulatedShape::Cylinder;
        disc.lengthM = disc.widthM = 0.2;
        disc.heightM = 0.0001;
        disc.motion = makeFigureEightMotion({1.5, 0.45 + 0.65 * i}, 0.9, 0.12, 4.0 + 0.7 * i, 0.8);
        scene.robots.push_back(std::move(disc));
    }
    scene.floor.patches.push_back({{45, 95, 190}, {{0.2, 0.75}, {2.8, 0.78}, {2.8, 0.82}, {0.2, 0.79}}});
    scene.floor.patches.push_back({{120, 85, 60}, {{2.6, 1.2}, {2.85, 1.2}, {2.85, 1.5}, {2.6, 1.5}}});
    return scene;
}

/// Outlines in the picture of the faces that are seen; the lens bends their edges, so these are walked in
/// parts.
std::vector<std::vector<Vector2d>> outlinesOf(const SimulatedScene &scene, std::size_t robot,
                                              std::int64_t frame)
{
    const FloorView &view = scene.cameras[0].view;
    const SimulatedRobot &body = scene.robots[robot];
    const MotionState state = body.motion->at(frameSceneTime(scene, 0, frame));
    std::vector<std::vector<Vector2d>> outlines;
    for (const BodyFace &face : visibleFaces(body, state, view.cameraInWorld())) {
        std::vector<Vector2d> &outline = outlines.emplace_back();
        constexpr int parts = 4;
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            for (int k = 0; k < parts; ++k) {
                const double part = static_cast<double>(k) / parts;
                const Eigen::Vector3d next = face.corners[(i + 1) % face.corners.size()];
                outline.push_back(view.pixelFromWorld((1 - part) * face.corners[i] + part * next).value());
            }
        }
    }
    return outlines;
}

Result<BenchmarkClip> provide(const std::filesystem::path &file, double durationS, ChromaSiting siting,
                              const VideoWriterOptions &options)
{
    BenchmarkClip clip{sceneOfDiscs(durationS, siting), file};
    if (!std::filesystem::exists(file)) {
        if (auto rendered = renderVideo(clip.scene, 0, file, options, {}); !rendered)
            return tl::unexpected(rendered.error());
    }
    return clip;
}

} // namespace

std::vector<TrackTarget> BenchmarkClip::targets(std::size_t robots) const
{
    std::vector<TrackTarget> targets;
    for (std::size_t i = 0; i < robots; ++i)
        targets.push_back({scene.robots[i].name, scene.robots[i].colour});
    return targets;
}

Vector2d BenchmarkClip::trueCentre(std::size_t robot, std::int64_t frame) const
{
    double twiceArea = 0;
    Vector2d moment = Vector2d::Zero();
    for (const std::vector<Vector2d> &outline : outlinesOf(scene, robot, frame)) {
        double twice = 0;
        Vector2d sum = Vector2d::Zero();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vector2d &p = outline[i], &q = outline[(i + 1) % outline.size()];
            const double cross = p.x() * q.y() - p.y() * q.x();
            twice += cross;
            sum += cross * (p + q) / 3;
        }
        twiceArea += std::abs(twice);
        moment += twice < 0 ? Vector2d(-sum) : sum;
    }
    return moment / twiceArea;
}

Vector2d BenchmarkClip::trueHalfSize(std::size_t robot, std::int64_t frame) const
{
    constexpr double far = std::numeric_limits<double>::max();
    Vector2d least(far, far), most(-far, -far);
    for (const std::vector<Vector2d> &outline : outlinesOf(scene, robot, frame)) {
        for (const Vector2d &point : outline) {
            least = least.cwiseMin(point);
            most = most.cwiseMax(point);
        }
    }
    return (most - least) / 2;
}

Result<BenchmarkClips> provideClips(const std::filesystem::path &folder, double durationS)
{
    const std::string name = "flat-discs-" + std::to_string(static_cast<int>(durationS)) + "s";
    VideoWriterOptions options;
    auto h264 = provide(folder / (name + ".mp4"), durationS, ChromaSiting::Left, options);
    if (!h264)
        return tl::unexpected(h264.error());
    options.codec = VideoCodec::Mjpeg;
    auto mjpeg = provide(folder / (name + ".mkv"), durationS, ChromaSiting::Center, options);
    if (!mjpeg)
        return tl::unexpected(mjpeg.error());
    return BenchmarkClips{std::move(*h264), std::move(*mjpeg)};
}

} // namespace odo::test
