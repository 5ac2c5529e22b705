// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/acceptance/scenes/scene_media.h"

#include "core/exchange/labelled_points.h"
#include "core/files/output_file.h"
#include "core/simulation/renderer.h"
#include "core/video/image.h"
#include "tests/acceptance/scenes/scene_recipe.h"

#include <fstream>
#include <numbers>
#include <sstream>
#include <thread>

namespace odo::test {

namespace {

namespace fs = std::filesystem;

constexpr double boardNoise = 1.5; // of 255

std::string contentOf(const fs::path &file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
}

Result<void> writeBoards(const AccuracyScene &scene, const SceneMedia &media, std::size_t camera)
{
    const SimulatedCamera &cam = scene.scene.cameras[camera];
    SimulatedBoard board;
    const std::uint32_t seed = scene.scene.seed + static_cast<std::uint32_t>(camera);
    int number = 0;
    for (const RigidTransform &pose : heldBoardPoses(cam.view.camera(), board, boardImages, seed)) {
        board.cameraFromBoard = pose;
        const Frame image =
            renderBoard(cam.view.camera(), board, boardNoise, seed + 1000u * std::uint32_t(number));
        if (auto written = writeImage(image, media.board(cam, number)); !written)
            return written;
        ++number;
    }
    return {};
}

Result<void> renderCamera(const AccuracyScene &scene, const SceneMedia &media, std::size_t camera)
{
    if (auto written = writeBoards(scene, media, camera); !written)
        return written;
    return renderVideo(scene.scene, static_cast<int>(camera), media.video(scene.scene.cameras[camera]),
                       scene.recording, {});
}

Result<void> writeTruth(const AccuracyScene &scene, const SceneMedia &media)
{
    for (const SimulatedRobot &robot : scene.scene.robots) {
        std::ostringstream text;
        text << "t_s,x_mm,y_mm,heading_deg\n";
        for (std::int64_t frame = 0; frame < frameCount(scene.scene, 0); ++frame) {
            const MotionState state = robot.motion->at(frameSceneTime(scene.scene, 0, frame));
            text << toSeconds(frameStamp(scene.scene, 0, frame)) << ',' << 1000 * state.position.x() << ','
                 << 1000 * state.position.y() << ',' << state.headingRad * 180 / std::numbers::pi << '\n';
        }
        if (auto written = writeOutput(media.truth(robot), text.str()); !written)
            return written;
    }
    return {};
}

} // namespace

fs::path SceneMedia::board(const SimulatedCamera &camera, int number) const
{
    return folder / "boards" /
           (camera.name + (number < 9 ? "_0" : "_") + std::to_string(number + 1) + ".png");
}

Result<SceneMedia> provideMedia(const AccuracyScene &scene, const fs::path &folder)
{
    SceneMedia media{folder};
    const fs::path recipeFile = folder / "recipe.txt";
    const std::string recipe = recipeOf(scene);
    if (contentOf(recipeFile) == recipe)
        return media;
    fs::remove_all(folder);
    fs::create_directories(folder / "boards");
    if (auto written = writeLayoutCsv(media.layout(), scene.scene.floor.markers); !written)
        return tl::unexpected(written.error());
    if (auto written = writeTruth(scene, media); !written)
        return tl::unexpected(written.error());
    std::vector<Result<void>> results(scene.scene.cameras.size());
    std::vector<std::thread> threads;
    for (std::size_t camera = 0; camera < results.size(); ++camera)
        threads.emplace_back([&, camera] { results[camera] = renderCamera(scene, media, camera); });
    for (std::thread &thread : threads)
        thread.join();
    for (const auto &result : results) {
        if (!result)
            return tl::unexpected(result.error());
    }
    // Written last: without it the folder is not complete.
    if (auto written = writeOutput(recipeFile, recipe); !written)
        return tl::unexpected(written.error());
    return media;
}

} // namespace odo::test
