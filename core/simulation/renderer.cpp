// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/renderer.h"

#include "core/simulation/internal/exposure.h"
#include "core/simulation/internal/floor_painter.h"
#include "core/simulation/internal/polygon_layer.h"
#include "core/simulation/internal/sensor.h"
#include "core/simulation/scene.h"
#include "core/simulation/tag_pattern.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <random>

namespace odo {

namespace {

/// Room for the chroma filter on all sides, on even pixels.
PixelRect dirtyRect(const PixelRect &bounds, const PixelRect &image)
{
    constexpr int margin = 4;
    const PixelRect even = {(bounds.x0 - margin) & ~1, (bounds.y0 - margin) & ~1,
                            (bounds.x1 + margin + 1) & ~1, (bounds.y1 + margin + 1) & ~1};
    return even.clipped(image);
}

/// Joins rectangles until no two meet.
std::vector<PixelRect> disjoint(const std::vector<PixelRect> &rects)
{
    std::vector<PixelRect> result;
    for (PixelRect rect : rects) {
        // Every rectangle it touches is merged into it, until it touches none.
        for (auto other = result.begin(); other != result.end();) {
            if (!other->meets(rect)) {
                ++other;
                continue;
            }
            rect = rect.united(*other);
            result.erase(other);
            other = result.begin();
        }
        result.push_back(rect);
    }
    return result;
}

void checkRobots([[maybe_unused]] const std::vector<SimulatedRobot> &robots)
{
    for ([[maybe_unused]] const SimulatedRobot &robot : robots)
        assert(robot.motion && robot.lengthM > 0 && robot.widthM > 0 && robot.heightM > 0);
}

const SimulatedCamera &checkedCamera(const SimulatedScene &scene, int camera)
{
    assert(camera >= 0 && camera < static_cast<int>(scene.cameras.size()));
    checkRobots(scene.robots);
    const SimulatedCamera &checked = scene.cameras[static_cast<std::size_t>(camera)];
    assert(checked.framesPerSecond > 0 && checked.sensor.exposureS >= 0 && checked.sensor.noiseSigma >= 0);
    return checked;
}

} // namespace

struct SceneRenderer::Impl
{
    Impl(SimulatedScene theScene, int theCamera)
        : scene(std::move(theScene)), camera(theCamera), settings(checkedCamera(scene, camera)),
          outline(settings.view.camera(), settings.view.cameraFromWorld()),
          still(paintFloor(scene.floor, settings.view)),
          sensor(settings.sensor, outline.imageRect().x1, outline.imageRect().y1,
                 randomHash(scene.seed, static_cast<std::uint64_t>(camera)))
    {
        sensor.take(still);
        sensor.keepStill();
    }

    void paint(const std::vector<PaintedThing> &things)
    {
        for (const PixelRect &rect : dirty)
            sensor.restore(rect);
        dirty.clear();
        for (const PaintedThing &thing : things)
            dirty.push_back(dirtyRect(thing.bounds, outline.imageRect()));
        dirty = disjoint(dirty);
        for (const PixelRect &rect : dirty) {
            RgbImage part = still.part(rect);
            for (const PaintedThing &thing : things) {
                if (!thing.bounds.meets(rect))
                    continue;
                PolygonLayer layer(thing.bounds);
                for (const PaintedPiece &piece : thing.pieces)
                    layer.add(piece.outline, piece.colour, piece.weight);
                layer.paintOver(part);
            }
            sensor.take(part);
        }
    }

    SimulatedScene scene;
    const int camera;
    const SimulatedCamera &settings;
    const ImageOutline outline;
    const RgbImage still;
    Sensor sensor;
    std::vector<PixelRect> dirty; ///< where the sensor differs from the still frame; disjoint
};

SceneRenderer::SceneRenderer(SimulatedScene scene, int camera)
    : m_impl(std::make_unique<Impl>(std::move(scene), camera))
{
}

SceneRenderer::~SceneRenderer() = default;

std::int64_t SceneRenderer::frameCount() const
{
    return odo::frameCount(m_impl->scene, m_impl->camera);
}

void SceneRenderer::setRobots(std::vector<SimulatedRobot> robots)
{
    checkRobots(robots);
    m_impl->scene.robots = std::move(robots);
}

Frame SceneRenderer::render(std::int64_t frame)
{
    Impl &d = *m_impl;
    assert(frame >= 0);
    const double timeS = frameSceneTime(d.scene, d.camera, frame);
    d.paint(thingsInExposure(d.scene, d.camera, d.outline, timeS));
    const auto image = static_cast<std::uint64_t>(sourceFrame(d.scene, d.camera, frame));
    const SensorModel &model = d.settings.sensor;
    const double gain =
        gainInExposure(model, timeS) * lightInExposure(d.scene.lights, model.exposureS, timeS);
    return FrameBuffer::toFrame(d.sensor.read(gain, image), frame, frameStamp(d.scene, d.camera, frame));
}

namespace {

Message renderingOf(const std::filesystem::path &file)
{
    return ODO_TEXT("simulation.rendering", "rendering %1")(Named::file(file));
}

} // namespace

Result<void> renderVideo(const SimulatedScene &scene, int camera, const OutputTarget &target,
                         const VideoWriterOptions &options, const JobControl &control)
{
    const std::filesystem::path &file = target.file;
    SceneRenderer renderer(scene, camera);
    const std::int64_t count = renderer.frameCount();
    if (count == 0)
        return fail(ErrorCode::InvalidInput,
                    ODO_TEXT("simulation.cannot_render", "cannot render %1")(Named::file(file)),
                    ODO_TEXT("simulation.no_frame", "camera %1 takes no frame during the scene")(
                        Named::camera(scene.cameras[static_cast<std::size_t>(camera)].name)),
                    ODO_TEXT("simulation.lengthen_scene",
                             "give the scene a longer duration or start the camera earlier"));
    std::unique_ptr<VideoWriter> writer;
    for (std::int64_t i = 0; i < count; ++i) {
        if (control.isCancelled())
            return cancelled(renderingOf(file));
        const Frame frame = renderer.render(i);
        if (!writer) {
            writer = ODO_TRY(VideoWriter::create(target, frame.format, options));
        }
        ODO_TRY(writer->write(frame));
        control.report(static_cast<double>(i + 1) / static_cast<double>(count), renderingOf(file.filename()));
    }
    return writer->finish();
}

namespace {

const Rgb wall(118, 116, 112, 0), boardWhite(236, 236, 234, 0), boardBlack(24, 24, 26, 0);

class BoardPainter
{
public:
    BoardPainter(const CameraModel &camera, const SimulatedBoard &board)
        : m_board(board), m_outline(camera, board.cameraFromBoard), m_image(m_outline.imageRect())
    {
    }

    RgbImage paint()
    {
        const PixelRect rect = m_image.rect();
        for (int y = rect.y0; y < rect.y1; ++y)
            std::fill_n(m_image.row(y), rect.width(), wall);
        PolygonLayer paper(rect);
        const double s = m_board.squareM;
        // A rim of one square of white around the outermost squares.
        addRectangle(paper, {-2 * s, -2 * s}, {(m_board.columns + 1) * s, (m_board.rows + 1) * s},
                     boardWhite);
        paper.paintOver(m_image);

        PolygonLayer ink(rect);
        int marker = 0;
        for (int row = 0; row <= m_board.rows; ++row) {
            for (int column = 0; column <= m_board.columns; ++column) {
                const Eigen::Vector2d corner((column - 1) * s, (row - 1) * s);
                if ((row + column) % 2 == 0)
                    addRectangle(ink, corner, corner + Eigen::Vector2d(s, s), boardBlack);
                else if (m_board.charuco)
                    addMarker(ink, corner, marker++);
            }
        }
        ink.paintOver(m_image);
        return std::move(m_image);
    }

private:
    void addRectangle(PolygonLayer &layer, const Eigen::Vector2d &lower, const Eigen::Vector2d &upper,
                      const Rgb &colour) const
    {
        const std::vector<Eigen::Vector3d> corners = {{lower.x(), lower.y(), 0},
                                                      {upper.x(), lower.y(), 0},
                                                      {upper.x(), upper.y(), 0},
                                                      {lower.x(), upper.y(), 0}};
        layer.add(m_outline.of(corners), colour);
    }

    void addMarker(PolygonLayer &ink, const Eigen::Vector2d &squareCorner, int id) const
    {
        const TagPattern pattern = arucoPattern(id);
        const double side = m_board.squareM * m_board.markerRatio, cell = side / pattern.side;
        const Eigen::Vector2d start = squareCorner + Eigen::Vector2d::Constant((m_board.squareM - side) / 2);
        for (int row = 0; row < pattern.side; ++row)
            for (int column = 0; column < pattern.side; ++column)
                if (pattern.isBlack(column, row))
                    addRectangle(ink, start + cell * Eigen::Vector2d(column, row),
                                 start + cell * Eigen::Vector2d(column + 1, row + 1), boardBlack);
    }

    const SimulatedBoard &m_board;
    const ImageOutline m_outline;
    RgbImage m_image;
};

} // namespace

Frame renderBoard(const CameraModel &camera, const SimulatedBoard &board, double noiseSigma,
                  std::uint32_t seed)
{
    assert(board.columns > 0 && board.rows > 0 && board.squareM > 0 && noiseSigma >= 0);
    assert(board.markerRatio > 0 && board.markerRatio < 1);
    const RgbImage image = BoardPainter(camera, board).paint();
    SensorModel model;
    model.noiseSigma = noiseSigma;
    Sensor sensor(model, image.rect().width(), image.rect().height(), seed);
    sensor.take(image);
    return FrameBuffer::toFrame(sensor.read(1.0, 0), 0, Nanoseconds{0});
}

namespace {

constexpr double borderPx = 8; // a corner nearer to the edge than this lacks its surroundings

bool allCornersVisible(const CameraModel &camera, const SimulatedBoard &board,
                       const RigidTransform &cameraFromBoard)
{
    // One square beyond the inner corners, so that the outer squares are in the frame as well.
    for (const double column : {-1.0, double(board.columns)}) {
        for (const double row : {-1.0, double(board.rows)}) {
            const Eigen::Vector3d corner(column * board.squareM, row * board.squareM, 0);
            const auto pixel = camera.project(cameraFromBoard * corner);
            if (!pixel || pixel->x() < borderPx || pixel->y() < borderPx ||
                pixel->x() > camera.intrinsics().widthPx - 1 - borderPx ||
                pixel->y() > camera.intrinsics().heightPx - 1 - borderPx)
                return false;
        }
    }
    return true;
}

RigidTransform randomPose(const CameraModel &camera, const SimulatedBoard &board, std::mt19937 &random)
{
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const Intrinsics &intrinsics = camera.intrinsics();
    const double boardWidthM = (board.columns + 1) * board.squareM;
    const double share = uniform(0.3, 0.7); // of the frame's width
    const double distanceM = intrinsics.fxPx * boardWidthM / (share * intrinsics.widthPx);
    const Eigen::Vector2d target(uniform(0.2, 0.8) * intrinsics.widthPx,
                                 uniform(0.2, 0.8) * intrinsics.heightPx);
    const double tilt = uniform(0.2, 0.7), towards = uniform(0, 2 * std::numbers::pi);
    RigidTransform pose;
    pose.rotation = Eigen::AngleAxisd(uniform(-0.3, 0.3), Eigen::Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(tilt, Eigen::Vector3d(std::cos(towards), std::sin(towards), 0));
    const Eigen::Vector3d middle((board.columns - 1) * board.squareM / 2,
                                 (board.rows - 1) * board.squareM / 2, 0);
    const Eigen::Vector3d position((target.x() - intrinsics.cxPx) / intrinsics.fxPx * distanceM,
                                   (target.y() - intrinsics.cyPx) / intrinsics.fyPx * distanceM, distanceM);
    pose.translation = position - pose.rotation * middle;
    return pose;
}

} // namespace

std::vector<RigidTransform> heldBoardPoses(const CameraModel &camera, const SimulatedBoard &board, int count,
                                           std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::vector<RigidTransform> poses;
    while (static_cast<int>(poses.size()) < count) {
        const RigidTransform pose = randomPose(camera, board, random);
        if (allCornersVisible(camera, board, pose))
            poses.push_back(pose);
    }
    return poses;
}

} // namespace odo
