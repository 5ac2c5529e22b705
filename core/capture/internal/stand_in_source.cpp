// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/internal/stand_in_source.h"

#include "core/base/error.h"
#include "core/base/steady_now.h"
#include "core/simulation/demo_testbed.h"
#include "core/video/video_reader.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace odo {

bool Pace::waitUntil(Nanoseconds time)
{
    std::unique_lock lock(m_mutex);
    if (!m_start)
        m_start = std::chrono::steady_clock::now() - time;
    if (m_kind == Kind::RealTime)
        m_wake.wait_until(lock, *m_start + time, [this] { return m_stopped; });
    return !m_stopped;
}

Nanoseconds Pace::lateness(Nanoseconds time) const
{
    return m_kind == Kind::RealTime ? std::chrono::steady_clock::now() - (*m_start + time) : Nanoseconds(0);
}

void Pace::stop()
{
    const std::lock_guard lock(m_mutex);
    m_stopped = true;
    m_wake.notify_all();
}

namespace {

constexpr double holdS = 1.0, moveS = 0.5;
constexpr double boardNoise = 2; // of 255

/// What the simulated cameras share: counting, time stamps, pace.
class SimulatedSource : public CameraSource
{
public:
    SimulatedSource(CameraDescription description, Pace::Kind pace, Pace::Start start = std::nullopt)
        : m_description(std::move(description)), m_pace(pace, start)
    {
    }
    const CameraDescription &description() const override { return m_description; }
    void stop() override { m_pace.stop(); }

    Result<CapturedFrame> next() override
    {
        double timeS = timeOf(m_sequence);
        if (!m_pace.waitUntil(fromSeconds(timeS)))
            return cancelled(nameAlone(m_description.uri));
        // Who asks too late has lost what the camera took meanwhile, as with a real one.
        const double lateS = toSeconds(m_pace.lateness(fromSeconds(timeS)));
        m_sequence += static_cast<std::uint64_t>(std::max(0.0, lateS) * m_description.framesPerSecond);
        timeS = timeOf(m_sequence);
        const Nanoseconds arrival = steadyNow(); // painting is this program's work, not the camera's
        CapturedFrame captured{paint(timeS), m_sequence++, arrival};
        captured.frame.index = static_cast<std::int64_t>(captured.sequence);
        captured.frame.time = fromSeconds(timeS);
        return captured;
    }

protected:
    virtual Frame paint(double timeS) = 0;
    virtual double timeOf(std::uint64_t sequence) const
    {
        return static_cast<double>(sequence) / m_description.framesPerSecond;
    }
    std::uint64_t sequence() const { return m_sequence; }

private:
    CameraDescription m_description;
    Pace m_pace;
    std::uint64_t m_sequence = 0;
};

class BoardSource : public SimulatedSource
{
public:
    BoardSource(CameraDescription description, CameraModel camera, const SimulatedBoard &board,
                std::vector<RigidTransform> poses, Pace::Kind pace)
        : SimulatedSource(std::move(description), pace), m_camera(std::move(camera)), m_board(board),
          m_poses(std::move(poses))
    {
    }

private:
    Frame paint(double timeS) override
    {
        const double turns = timeS / (holdS + moveS);
        const auto pose = static_cast<std::size_t>(turns);
        const double moved = std::max(0.0, (turns - std::floor(turns)) * (holdS + moveS) - holdS) / moveS;
        const RigidTransform &from = m_poses[pose % m_poses.size()],
                             &to = m_poses[(pose + 1) % m_poses.size()];
        m_board.cameraFromBoard.rotation = from.rotation.slerp(moved, to.rotation);
        m_board.cameraFromBoard.translation = (1 - moved) * from.translation + moved * to.translation;
        return renderBoard(m_camera, m_board, boardNoise, static_cast<std::uint32_t>(sequence()));
    }

    CameraModel m_camera;
    SimulatedBoard m_board;
    std::vector<RigidTransform> m_poses;
};

class SceneSource : public SimulatedSource
{
public:
    SceneSource(CameraDescription description, SimulatedScene scene, int camera, Pace::Kind pace,
                Pace::Start start)
        : SimulatedSource(std::move(description), pace, start), m_renderer(scene, camera),
          m_scene(std::move(scene)), m_camera(camera)
    {
    }
    void showRobots(const std::vector<RobotAppearance> &robots) override
    {
        std::vector<SimulatedRobot> circling = circlingRobots(robots);
        const std::lock_guard lock(m_mutex);
        m_toShow = std::move(circling);
    }

private:
    std::optional<std::vector<SimulatedRobot>> takeToShow()
    {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_toShow, std::nullopt);
    }
    Frame paint(double) override
    {
        if (auto robots = takeToShow())
            m_renderer.setRobots(std::move(*robots));
        return m_renderer.render(static_cast<std::int64_t>(sequence()) % m_renderer.frameCount());
    }
    double timeOf(std::uint64_t sequence) const override
    {
        const auto frames = static_cast<std::uint64_t>(m_renderer.frameCount());
        const std::uint64_t rounds = sequence / frames;
        return static_cast<double>(rounds) * m_scene.durationS +
               frameSceneTime(m_scene, m_camera, static_cast<std::int64_t>(sequence % frames));
    }

    SceneRenderer m_renderer;
    SimulatedScene m_scene;
    int m_camera;
    std::mutex m_mutex;
    std::optional<std::vector<SimulatedRobot>> m_toShow; ///< from the next frame on
};

} // namespace

std::unique_ptr<CameraSource> simulatedBoardSource(CameraDescription description, CameraModel camera,
                                                   const SimulatedBoard &board,
                                                   std::vector<RigidTransform> cameraFromBoard,
                                                   Pace::Kind pace)
{
    return std::make_unique<BoardSource>(std::move(description), std::move(camera), board,
                                         std::move(cameraFromBoard), pace);
}

std::unique_ptr<CameraSource> simulatedSceneSource(CameraDescription description, SimulatedScene scene,
                                                   int camera, Pace::Kind pace, Pace::Start start)
{
    return std::make_unique<SceneSource>(std::move(description), std::move(scene), camera, pace, start);
}

namespace {

class FileSource : public CameraSource
{
public:
    FileSource(std::unique_ptr<VideoReader> reader, CameraDescription description, Pace::Kind pace)
        : m_reader(std::move(reader)), m_description(std::move(description)), m_pace(pace)
    {
    }
    const CameraDescription &description() const override { return m_description; }
    void stop() override { m_pace.stop(); }

    Result<CapturedFrame> next() override
    {
        auto frame = ODO_TRY(m_reader->next());
        if (!frame)
            return fail(ErrorCode::Io, nameAlone(m_description.uri),
                        ODO_TEXT("capture.video_has_ended", "the video has ended"),
                        ODO_TEXT("capture.open_video_again", "open it again to see it from the start"));
        if (!m_pace.waitUntil(frame->time))
            return cancelled(nameAlone(m_description.uri));
        CapturedFrame captured{std::move(*frame), 0, steadyNow()};
        captured.sequence = static_cast<std::uint64_t>(captured.frame.index);
        return captured;
    }

private:
    std::unique_ptr<VideoReader> m_reader;
    CameraDescription m_description;
    Pace m_pace;
};

} // namespace

Result<std::unique_ptr<CameraSource>> openFileSource(const std::filesystem::path &file, Pace::Kind pace)
{
    auto reader = ODO_TRY(VideoReader::open(file));
    const VideoInfo &info = reader->info();
    CameraDescription description{"file:" + file.string(),      "file",
                                  fileSubject(file.filename()), info.format.width,
                                  info.format.height,           info.framesPerSecond};
    return std::make_unique<FileSource>(std::move(reader), std::move(description), pace);
}

} // namespace odo
