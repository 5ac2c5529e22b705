// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_source.h"

#include "core/base/error.h"
#include "core/base/shortage.h"
#include "core/capture/aravis/aravis_address.h"
#include "core/capture/aravis/aravis_source.h"
#include "core/capture/internal/stand_in_source.h"
#include "core/capture/v4l2/v4l2_address.h"
#include "core/capture/v4l2/v4l2_source.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

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
    const Intrinsics &intrinsics = camera.view.camera().intrinsics();
    return {.uri = simulated + camera.name,
            .kind = "simulated",
            .name = ODO_TEXT("capture.simulated_camera", "Simulated camera %1")(Named::camera(camera.name)),
            .widthPx = intrinsics.widthPx,
            .heightPx = intrinsics.heightPx,
            .framesPerSecond = camera.framesPerSecond,
            .formats = {{formatWords("", intrinsics.widthPx, intrinsics.heightPx, camera.framesPerSecond)}}};
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
            return simulatedSceneSource(std::move(description), std::move(scene), static_cast<int>(i),
                                        Pace::Kind::RealTime, beginningOfTheTestbed());
        const CameraModel &intrinsics = camera.view.camera();
        return simulatedBoardSource(std::move(description), intrinsics, {},
                                    heldBoardPoses(intrinsics, {}, boardPoses, seed), Pace::Kind::RealTime);
    }
    return fail(ErrorCode::NotFound, quotedName(uri),
                ODO_TEXT("capture.no_simulated_camera", "simulated camera %1 does not exist")(name),
                ODO_TEXT("capture.take_simulated_camera", "use sim:A or sim:B"));
}

} // namespace

Message formatWords(const std::string &coding, int widthPx, int heightPx, double framesPerSecond)
{
    const std::string size = sizeText(widthPx, heightPx);
    const long long hundredths = std::llround(100 * framesPerSecond);
    const int decimals = hundredths % 100 == 0 ? 0 : hundredths % 10 == 0 ? 1 : 2;
    return ODO_TEXT("capture.format", "%1 at %2")(coding.empty() ? size : coding + ' ' + size,
                                                  quantity(framesPerSecond, decimals, "frames/s"));
}

Result<void> CameraSource::set(const std::string &id, double)
{
    return noSuchControl(description().uri, id);
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
    return fail(ErrorCode::NotFound, quotedName(uri),
                ODO_TEXT("capture.no_such_address", "no kind of camera has an address like this"),
                ODO_TEXT("capture.give_address",
                         "give one as v4l2:/dev/video0, aravis:192.168.1.20, sim:A or file:PATH"));
}

} // namespace

Result<std::unique_ptr<CameraSource>> openCamera(const std::string &uri)
{
    return orShortage(cameraAtAddress(uri), [&uri] { return openByKind(uri); });
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

namespace {

CameraSetting settingIn(std::string_view part)
{
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos)
        return {std::string(part), {}, {}};
    return {std::string(part), std::string(part.substr(0, equals)), std::string(part.substr(equals + 1))};
}

} // namespace

CameraUri splitCameraUri(std::string_view uri, std::string_view scheme)
{
    const std::string_view all = uri.substr(scheme.size());
    const std::size_t question = all.find('?');
    CameraUri split{std::string(all.substr(0, question))};
    if (question == std::string_view::npos)
        return split;
    for (std::string_view rest = all.substr(question + 1); !rest.empty();) {
        const std::size_t ampersand = rest.find('&');
        split.cameraSettings.push_back(settingIn(rest.substr(0, ampersand)));
        rest = ampersand == std::string_view::npos ? std::string_view() : rest.substr(ampersand + 1);
    }
    return split;
}

bool acceptsSettings(const std::string &uri)
{
    return uri.starts_with("v4l2:") || uri.starts_with("aravis:");
}

std::string withoutSettings(const std::string &uri)
{
    return acceptsSettings(uri) ? uri.substr(0, uri.find('?')) : uri;
}

std::string withSettings(const std::string &uri, const std::vector<CameraSetting> &cameraSettings)
{
    std::string whole = withoutSettings(uri);
    for (std::size_t i = 0; i < cameraSettings.size(); ++i)
        whole += (i == 0 ? '?' : '&') + cameraSettings[i].text;
    return whole;
}

namespace {

using namespace std::chrono_literals;

constexpr auto cameraWithin = 500ms;

CameraDescription knownOf(const std::string &uri)
{
    return {.uri = uri, .kind = uri.substr(0, uri.find(':')), .name = nameAlone(uri)};
}

class AwaitedSource : public CameraSource
{
public:
    using Open = std::function<Result<std::unique_ptr<CameraSource>>()>;

    AwaitedSource(const std::string &uri, Error why, Open open, Nanoseconds betweenAttempts)
        : m_known(knownOf(uri)), m_open(std::move(open)), m_betweenAttempts(betweenAttempts),
          m_why(std::move(why))
    {
        if (auto opener = startThread(cameraAtAddress(uri), [this] { await(); })) {
            m_opener = std::move(*opener);
        } else {
            m_why = opener.error();
            m_why.code = ErrorCode::InvalidInput; // nobody tries again
        }
    }
    ~AwaitedSource() override
    {
        stop();
        if (m_opener.joinable())
            m_opener.join();
    }

    const CameraDescription &description() const override
    {
        const CameraSource *source = camera();
        return source ? source->description() : m_known;
    }
    Result<CapturedFrame> next() override
    {
        CameraSource *source = nullptr;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait_for(lock, cameraWithin, [this] { return m_stopped || m_camera || isHopeless(); });
            if (m_stopped)
                return cancelled(nameAlone(m_known.uri));
            if (!m_camera && isHopeless())
                return tl::unexpected(m_why);
            if (!m_camera)
                return fail(ErrorCode::Unavailable, m_why.what, m_why.why, m_why.advice);
            source = m_camera.get();
        }
        return source->next();
    }
    void stop() override
    {
        const std::lock_guard lock(m_mutex);
        m_stopped = true;
        m_wake.notify_all();
        if (m_camera)
            m_camera->stop();
    }

    CameraCounts counts() const override
    {
        const CameraSource *source = camera();
        return source ? source->counts() : CameraCounts{};
    }
    Result<std::vector<CameraControl>> controls() override
    {
        if (CameraSource *source = camera())
            return source->controls();
        return notThere();
    }
    Result<void> set(const std::string &id, double value) override
    {
        if (CameraSource *source = camera())
            return source->set(id, value);
        return notThere();
    }
    std::vector<Message> holdAutomatics() override
    {
        {
            const std::lock_guard lock(m_mutex);
            if (!m_camera) {
                m_isHoldMissed = true;
                return {};
            }
        }
        return camera()->holdAutomatics();
    }
    void showRobots(const std::vector<RobotAppearance> &robots) override
    {
        const std::lock_guard lock(m_mutex);
        m_robots = robots;
        if (m_camera)
            m_camera->showRobots(robots);
    }
    void releaseAutomatics() override
    {
        {
            const std::lock_guard lock(m_mutex);
            m_isHoldMissed = false;
        }
        if (CameraSource *source = camera())
            source->releaseAutomatics();
    }

private:
    bool isHopeless() const { return m_why.code == ErrorCode::InvalidInput; }
    /// Once it is there it stays.
    CameraSource *camera() const
    {
        const std::lock_guard lock(m_mutex);
        return m_camera.get();
    }
    tl::unexpected<Error> notThere() const
    {
        const std::lock_guard lock(m_mutex);
        return fail(ErrorCode::Unavailable, m_why.what, m_why.why, m_why.advice);
    }

    /// With the mutex held.
    void adopt(std::unique_ptr<CameraSource> camera)
    {
        m_camera = std::move(camera);
        if (m_robots)
            m_camera->showRobots(*m_robots);
    }

    /// The thread that opens it.
    void await()
    {
        std::unique_lock lock(m_mutex);
        while (!m_camera && !isHopeless() &&
               !m_wake.wait_for(lock, m_betweenAttempts, [this] { return m_stopped; })) {
            lock.unlock();
            auto opened = orShortage(cameraAtAddress(m_known.uri), m_open);
            lock.lock();
            if (!opened)
                m_why = opened.error();
            else if (!m_stopped)
                adopt(std::move(*opened));
            m_wake.notify_all();
        }
        if (!m_camera || !m_isHoldMissed)
            return;
        lock.unlock();
        m_camera->holdAutomatics();
    }

    const CameraDescription m_known;
    const Open m_open;
    const Nanoseconds m_betweenAttempts;
    mutable std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_wake;
    std::unique_ptr<CameraSource> m_camera; ///< set once
    Error m_why;
    bool m_stopped = false, m_isHoldMissed = false;
    std::optional<std::vector<RobotAppearance>> m_robots; ///< that it is to show
    std::thread m_opener;                                 ///< last, so that it begins when all is there
};

} // namespace

std::unique_ptr<CameraSource> awaitCamera(const std::string &uri, Error why,
                                          std::function<Result<std::unique_ptr<CameraSource>>()> open,
                                          Nanoseconds betweenAttempts)
{
    return std::make_unique<AwaitedSource>(uri, std::move(why), std::move(open), betweenAttempts);
}

namespace {

constexpr double settlingS = 0.5;
constexpr int mostRefusals = 6; // of half a second each: then the camera will not come

} // namespace

Result<Frame> settledFrame(CameraSource &camera, const JobControl &control)
{
    int refusals = 0;
    std::optional<Nanoseconds> first;
    for (;;) {
        auto captured = camera.next();
        if (control.isCancelled())
            return cancelled(ODO_TEXT("capture.the_picture", "the frame"));
        if (!captured && (captured.error().code != ErrorCode::Unavailable || ++refusals == mostRefusals))
            return tl::unexpected(captured.error());
        if (!captured)
            continue;
        if (!first)
            first = captured->frame.time;
        if (toSeconds(captured->frame.time - *first) >= settlingS)
            return std::move(captured->frame);
    }
}

Message cameraAtAddress(const std::string &uri)
{
    return ODO_TEXT("capture.camera_at_address", "camera %1")(uri);
}

tl::unexpected<Error> notUnderstood(const std::string &uri, const std::string &part, Message advice)
{
    return fail(ErrorCode::InvalidInput, cameraAtAddress(uri),
                ODO_TEXT("capture.part_not_understood", "'%1' is not valid")(part), std::move(advice));
}

tl::unexpected<Error> noSuchControl(const std::string &uri, const std::string &id)
{
    return fail(ErrorCode::NotFound, cameraAtAddress(uri),
                ODO_TEXT("capture.no_such_control", "it has no setting '%1'")(id),
                ODO_TEXT("capture.leave_control_out", "leave it out"));
}

Message controlGoes(const std::string &name, MessageArgument from, MessageArgument to)
{
    return ODO_TEXT("capture.control_goes", "%1 ranges from %2 to %3")(name, std::move(from), std::move(to));
}

Message usedByAnotherProgram()
{
    return ODO_TEXT("capture.used_by_another_program", "another program uses it");
}

Message closeThatProgram()
{
    return ODO_TEXT("capture.close_that_program", "close that program");
}

Message notRegisteredToFloor()
{
    return ODO_TEXT("capture.not_registered", "it is not registered to the floor");
}

} // namespace odo
