// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_source.h"

#include "core/base/shortage.h"
#include "core/capture/aravis/aravis_address.h"
#include "core/capture/aravis/aravis_source.h"
#include "core/capture/file_source.h"
#include "core/capture/simulated_source.h"
#include "core/capture/v4l2/v4l2_address.h"
#include "core/capture/v4l2/v4l2_source.h"
#include "core/simulation/board_poses.h"
#include "core/simulation/demo_robots.h"
#include "core/simulation/demo_testbed.h"

#include <chrono>
#include <cmath>
#include <locale>
#include <sstream>

namespace odo {

namespace {

constexpr const char *simulated = "sim:", *fromFile = "file:", *withBoard = "?board";
constexpr int boardPoses = 24;
constexpr std::uint32_t seed = 1;

/// A robot drives its circle all day long.
SimulatedScene livingTestbed()
{
    SimulatedScene scene = demoTestbed(seed);
    scene.robots = circlingRobots({});
    scene.durationS = 24 * 3600;
    return scene;
}

/// All simulated cameras of the program look at one testbed, which begins when the first one is opened.
std::chrono::steady_clock::time_point beginningOfTheTestbed()
{
    static const auto beginning = std::chrono::steady_clock::now();
    return beginning;
}

CameraDescription describe(const SimulatedCamera &camera)
{
    const Intrinsics &lens = camera.view.camera().intrinsics();
    return {.uri = simulated + camera.name,
            .kind = "simulated",
            .name = "Simulated camera " + camera.name,
            .widthPx = lens.widthPx,
            .heightPx = lens.heightPx,
            .framesPerSecond = camera.framesPerSecond,
            .formats = {formatWords("", lens.widthPx, lens.heightPx, camera.framesPerSecond)}};
}

Result<std::unique_ptr<CameraSource>> openSimulated(const std::string &uri)
{
    std::string name = uri.substr(std::string(simulated).size());
    const bool board = name.ends_with(withBoard);
    if (board)
        name.resize(name.size() - std::string(withBoard).size());
    SimulatedScene scene = livingTestbed();
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const SimulatedCamera &camera = scene.cameras[i];
        if (camera.name != name)
            continue;
        CameraDescription description = describe(camera);
        description.uri = uri;
        if (!board)
            return simulatedSceneSource(std::move(description), std::move(scene), static_cast<int>(i), Pace::Kind::RealTime,
                                        beginningOfTheTestbed());
        const CameraModel &lens = camera.view.camera();
        return simulatedBoardSource(std::move(description), lens, {}, heldBoardPoses(lens, {}, boardPoses, seed), Pace::Kind::RealTime);
    }
    return fail(ErrorCode::NotFound, "'" + uri + "'", "there is no simulated camera " + name, "take sim:A or sim:B");
}

} // namespace

std::string formatWords(const std::string &coding, int widthPx, int heightPx, double framesPerSecond)
{
    std::ostringstream words;
    words.imbue(std::locale::classic());
    if (!coding.empty())
        words << coding << ' ';
    words << widthPx << "×" << heightPx << " at " << std::round(100 * framesPerSecond) / 100 << " frames/s";
    return words.str();
}

Result<void> CameraSource::set(const std::string &id, double)
{
    return fail(ErrorCode::NotFound, "camera " + description().uri, "it has nothing named '" + id + "' that could be set", "leave it out");
}

namespace {

Result<std::unique_ptr<CameraSource>> openByKind(const std::string &uri)
{
    if (uri.starts_with(simulated))
        return openSimulated(uri);
    if (uri.starts_with(fromFile))
        return openFileSource(uri.substr(std::string(fromFile).size()), Pace::Kind::RealTime);
    if (isV4l2Address(uri))
        return openV4l2Source(uri);
    if (isAravisAddress(uri))
        return openAravisSource(uri);
    return fail(ErrorCode::NotFound, "'" + uri + "'", "no camera has such an address",
                "give one as v4l2:/dev/video0, aravis:192.168.1.20, sim:A or file:PATH");
}

} // namespace

Result<std::unique_ptr<CameraSource>> openCamera(const std::string &uri)
{
    return orShortage("camera " + uri, [&uri] { return openByKind(uri); });
}

std::vector<CameraDescription> listCameras()
{
    std::vector<CameraDescription> cameras;
    for (const SimulatedCamera &camera : livingTestbed().cameras)
        cameras.push_back(describe(camera));
    for (CameraDescription &camera : listV4l2Cameras())
        cameras.push_back(std::move(camera));
    for (CameraDescription &camera : listAravisCameras())
        cameras.push_back(std::move(camera));
    return cameras;
}

} // namespace odo
