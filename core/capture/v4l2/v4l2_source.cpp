// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_source.h"

#include "core/base/steady_now.h"
#include "core/capture/camera_source.h"
#include "core/capture/v4l2/internal/v4l2_device.h"
#include "core/capture/v4l2/internal/v4l2_mode.h"
#include "core/capture/v4l2/internal/v4l2_stream.h"
#include "core/capture/v4l2/internal/v4l2_sysfs.h"
#include "core/capture/v4l2/v4l2_address.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <linux/videodev2.h>
#include <mutex>

namespace odo {

namespace {

constexpr const char *kind = "v4l2";

std::vector<CameraFormat> formatsOf(const std::vector<V4l2Mode> &modes)
{
    std::vector<V4l2Mode> fastest;
    for (const V4l2Mode &mode : modes) {
        const auto same = std::ranges::find_if(fastest, [&](const V4l2Mode &other) {
            return other.format == mode.format && other.widthPx == mode.widthPx &&
                   other.heightPx == mode.heightPx;
        });
        if (same == fastest.end())
            fastest.push_back(mode);
        else if (mode.framesPerSecond() > same->framesPerSecond())
            *same = mode;
    }
    sortByMerit(fastest);
    std::vector<CameraFormat> formats;
    for (const V4l2Mode &mode : fastest)
        formats.push_back({modeWords(mode), fourccWords(mode.format), mode.widthPx, mode.heightPx});
    return formats;
}

/// Cameras that may not be opened. Only the first node of a camera is named: whether another one captures
/// video cannot be asked.
std::vector<CameraDescription> forbiddenCameras()
{
    std::vector<CameraDescription> cameras;
    for (const int number : v4l2Sysfs::nodeNumbers()) {
        const std::filesystem::path node = v4l2Sysfs::nodeOf(number);
        const std::string uri = std::string(v4l2Scheme) + node.string();
        if (v4l2Sysfs::indexOf(node) != "0")
            continue;
        const auto device = V4l2Device::open(node, uri);
        if (!device && device.error().code == ErrorCode::Io)
            cameras.push_back(
                {.uri = uri,
                 .kind = kind,
                 .name = foreignWords(v4l2Sysfs::nameOf(node)),
                 .formats = {{joined({device.error().why, device.error().advice}, Join::Semicolon)}}});
    }
    return cameras;
}

} // namespace

/// An open camera for people, by its node; of each format and size the fastest mode is named, the best first.
CameraDescription describeV4l2(const V4l2Device &device, const std::vector<V4l2Mode> &modes,
                               const V4l2Mode &chosen)
{
    return {.uri = std::string(v4l2Scheme) + device.node().string(),
            .kind = kind,
            .name = foreignWords(device.identity().name),
            .widthPx = chosen.widthPx,
            .heightPx = chosen.heightPx,
            .framesPerSecond = chosen.framesPerSecond(),
            .serial = device.identity().serial,
            .formats = formatsOf(modes)};
}

std::vector<CameraDescription> listV4l2Cameras()
{
    std::vector<CameraDescription> cameras;
    for (const auto &device : openV4l2Devices()) {
        const std::vector<V4l2Mode> modes = v4l2Modes(*device);
        const auto mode = chooseMode(modes, {}, device->node().string());
        if (!mode)
            continue; // nothing that can be read
        cameras.push_back(describeV4l2(*device, modes, *mode));
        cameras.back().busy = device->isBusy();
    }
    for (CameraDescription &camera : forbiddenCameras())
        cameras.push_back(std::move(camera));
    return cameras;
}

namespace {

using namespace std::chrono_literals;
using Time = std::chrono::steady_clock::time_point;

constexpr auto usualSilence = 500ms;
constexpr auto longestBeginning = 1500ms; ///< many a camera needs a second to its first frame
constexpr auto betweenAttempts = 100ms;
constexpr int silencesBeforeRestart = 4;
constexpr double framesInSilence = 2.5; ///< the wait is longer for a camera slower than that

Time now()
{
    return std::chrono::steady_clock::now();
}

void remember(V4l2Settings &settings, const std::string &id, double value)
{
    std::erase_if(settings, [&](const auto &setting) { return setting.first == id; });
    settings.emplace_back(id, value);
}

class V4l2Source : public CameraSource
{
public:
    V4l2Source(CameraDescription description, V4l2Mode mode, V4l2KnownCamera camera,
               std::shared_ptr<V4l2Device> device, std::unique_ptr<V4l2Stream> stream)
        : m_description(std::move(description)), m_mode(mode), m_camera(std::move(camera))
    {
        begin(std::move(device), std::move(stream));
    }
    const CameraDescription &description() const override { return m_description; }
    Result<CapturedFrame> next() override;
    void stop() override { m_watch.stop(); }
    CameraCounts counts() const override;
    Result<std::vector<CameraControl>> controls() override;
    Result<void> set(const std::string &id, double value) override;
    std::vector<Message> holdAutomatics() override;
    void releaseAutomatics() override;

private:
    void begin(std::shared_ptr<V4l2Device> device, std::unique_ptr<V4l2Stream> stream);
    void lose(const Error &why);
    void notePassing(Error problem);
    bool takeUp();
    void restore(const V4l2Device &device);
    std::optional<CapturedFrame> takeFrame();
    std::optional<CapturedFrame> read(const V4l2Stream::Buffer &buffer);
    void noteSilence();
    std::chrono::nanoseconds patience() const;
    Result<std::shared_ptr<V4l2Device>> device() const;

    const CameraDescription m_description;
    const V4l2Mode m_mode;
    const V4l2KnownCamera m_camera;
    V4l2Watch m_watch;

    // Of the thread that calls next().
    std::unique_ptr<V4l2Stream> m_stream; ///< none while the camera is lost
    std::unique_ptr<V4l2Frames> m_frames;
    V4l2Stamps m_stamps;
    Error m_problem;          ///< the last one
    bool m_begins = true;     ///< no intact frame since the stream started
    bool m_atOnce = false;    ///< it was lost while it delivered, and is to be taken up without waiting
    bool m_isDamaged = false; ///< what came since the last intact frame was damaged
    int m_silences = 0;       ///< in a row

    mutable std::mutex m_mutex; ///< guards what follows
    std::shared_ptr<V4l2Device> m_device;
    CameraCounts m_counts;
    V4l2Settings m_settings;
    V4l2Settings m_automatics;   ///< that are held, with their previous values
    bool m_isHoldMissed = false; ///< it was not there when its automatics were to be held
};

void V4l2Source::begin(std::shared_ptr<V4l2Device> device, std::unique_ptr<V4l2Stream> stream)
{
    m_stream = std::move(stream);
    m_frames = std::make_unique<V4l2Frames>(m_stream->format());
    m_begins = true;
    m_silences = 0;
    const std::lock_guard lock(m_mutex);
    m_device = std::move(device);
}

void V4l2Source::lose(const Error &why)
{
    notePassing(why);
    m_atOnce = !m_begins;
    m_stamps.restart(m_description.framesPerSecond);
    m_stream.reset();
    std::shared_ptr<V4l2Device> device; // a node that is held cannot come back; closing it takes a while
    const std::lock_guard lock(m_mutex);
    device.swap(m_device);
}

/// Any problem of a camera that once worked may pass.
void V4l2Source::notePassing(Error problem)
{
    m_problem = std::move(problem);
    m_problem.code = ErrorCode::Unavailable;
}

bool V4l2Source::takeUp()
{
    const auto found = m_camera.find();
    if (!found) {
        notePassing(found.error());
        return false;
    }
    auto stream = V4l2Stream::start(*found, m_mode, m_description.uri);
    if (!stream) {
        notePassing(stream.error());
        return false;
    }
    begin(*found, std::move(*stream));
    restore(**found);
    return true;
}

/// Camera calls block, so that none is made under the lock.
void V4l2Source::restore(const V4l2Device &device)
{
    V4l2Settings settings;
    bool hold = false;
    {
        const std::lock_guard lock(m_mutex);
        ++m_counts.reconnections;
        settings = m_settings;
        hold = m_isHoldMissed;
        m_isHoldMissed = false;
    }
    for (const auto &[id, value] : settings)
        (void)setV4l2Control(device, m_description.uri, id,
                             value); // what cannot be set now could not be set then
    if (hold)
        holdAutomatics();
}

std::optional<CapturedFrame> V4l2Source::read(const V4l2Stream::Buffer &buffer)
{
    const Nanoseconds arrival = steadyNow();
    const V4l2Stamps::Stamp stamp = m_stamps.next(buffer.stamp, arrival);
    auto decoded = buffer.isDamaged ? std::nullopt : m_frames->read(buffer.bytes);
    if (!decoded) {
        m_isDamaged = true;
        const std::lock_guard lock(m_mutex);
        ++m_counts.damaged;
        return std::nullopt;
    }
    m_begins = m_isDamaged = false;
    m_silences = 0;
    CapturedFrame captured{std::move(decoded->frame), stamp.sequence, arrival, std::move(decoded->jpeg),
                           stamp.clock};
    captured.frame.index = static_cast<std::int64_t>(stamp.sequence);
    captured.frame.time = stamp.time;
    return captured;
}

std::optional<CapturedFrame> V4l2Source::takeFrame()
{
    std::optional<CapturedFrame> captured;
    while (!captured) {
        V4l2Stream::Buffer buffer;
        int failure = m_stream->take(buffer);
        if (failure == EAGAIN)
            break;
        if (failure == 0) {
            captured = read(buffer);
            failure = m_stream->giveBack(buffer.index);
        }
        if (failure != 0) {
            lose(v4l2Failure(m_description.uri, failure));
            break;
        }
    }
    return captured;
}

std::chrono::nanoseconds V4l2Source::patience() const
{
    const auto usual = m_begins && m_stream ? longestBeginning : usualSilence;
    return std::max<std::chrono::nanoseconds>(usual,
                                              fromSeconds(framesInSilence / m_description.framesPerSecond));
}

/// A connected camera that sends nothing: in the end it is restarted.
void V4l2Source::noteSilence()
{
    const Message what = cameraAtAddress(m_description.uri);
    if (m_isDamaged)
        notePassing({ErrorCode::Unavailable, what,
                     ODO_TEXT("capture.all_pictures_damaged", "all its frames arrive damaged"),
                     ODO_TEXT("capture.damaged_advice",
                              "try another cable or port, or choose a lower rate or a smaller frame size")});
    else
        notePassing({ErrorCode::Unavailable, what,
                     ODO_TEXT("capture.there_but_silent", "it is connected but sends no frames"),
                     ODO_TEXT("capture.there_but_silent_advice",
                              "check its cable; if this continues, plug it in again")});
    if (++m_silences == silencesBeforeRestart)
        lose(Error(m_problem));
}

Result<CapturedFrame> V4l2Source::next()
{
    Time deadline = now() + patience();
    bool isSound = true;
    while (!m_watch.isStopped()) {
        m_atOnce = false;
        if (!m_stream) {
            if (takeUp())
                deadline = now() + patience();
        } else if (auto captured = takeFrame()) {
            return std::move(*captured);
        } else if (m_stream && !isSound) {
            lose(v4l2Failure(m_description.uri, EIO));
        }
        if (m_atOnce)
            continue;
        if (now() >= deadline) {
            if (m_stream)
                noteSilence();
            return tl::unexpected(m_problem);
        }
        isSound = m_watch.wait(m_stream ? m_stream->descriptor() : -1,
                               m_stream ? deadline : std::min(deadline, now() + betweenAttempts));
    }
    return cancelled(cameraAtAddress(m_description.uri));
}

CameraCounts V4l2Source::counts() const
{
    const std::lock_guard lock(m_mutex);
    return m_counts;
}

Result<std::shared_ptr<V4l2Device>> V4l2Source::device() const
{
    const std::lock_guard lock(m_mutex);
    if (!m_device)
        return tl::unexpected(v4l2Failure(m_description.uri, ENODEV));
    return m_device;
}

Result<std::vector<CameraControl>> V4l2Source::controls()
{
    return device().and_then([this](const auto &open) { return v4l2Controls(*open, m_description.uri); });
}

Result<void> V4l2Source::set(const std::string &id, double value)
{
    const auto open = ODO_TRY(device());
    ODO_TRY(setV4l2Control(*open, m_description.uri, id, value));
    const std::lock_guard lock(m_mutex);
    remember(m_settings, id, value);
    return {};
}

std::vector<Message> V4l2Source::holdAutomatics()
{
    const auto open = device();
    if (!open) {
        const std::lock_guard lock(m_mutex);
        m_isHoldMissed = true;
        return {};
    }
    V4l2Held held = holdV4l2Automatics(**open, m_description.uri);
    const std::lock_guard lock(m_mutex);
    for (const auto &[id, value] : held.settings)
        remember(m_settings, id, value);
    for (const auto &[id, value] : held.automatics)
        remember(m_automatics, id, value);
    return std::move(held.stillOn);
}

void V4l2Source::releaseAutomatics()
{
    const auto open = device();
    V4l2Settings automatics;
    {
        const std::lock_guard lock(m_mutex);
        m_isHoldMissed = false;
        automatics = std::exchange(m_automatics, {});
        for (const auto &[id, value] : automatics)
            remember(m_settings, id, value); // one that is away now is to have them when it is back
    }
    for (const auto &[id, value] : automatics) {
        if (open)
            (void)setV4l2Control(**open, m_description.uri, id, value); // gone meanwhile: as if it were away
    }
}

} // namespace

Result<std::unique_ptr<CameraSource>> openV4l2Source(const std::string &uri)
{
    const auto address = ODO_TRY(parseV4l2Address(uri));
    auto device = ODO_TRY(openV4l2Device(address));
    const std::vector<V4l2Mode> modes = v4l2Modes(*device);
    const auto mode = ODO_TRY(chooseMode(modes, address.request, uri));
    auto stream = ODO_TRY(V4l2Stream::start(device, mode, uri));
    CameraDescription description = describeV4l2(*device, modes, mode);
    description.uri = uri;
    description.framesPerSecond = stream->framesPerSecond();
    V4l2KnownCamera camera(address, *device);
    return std::make_unique<V4l2Source>(std::move(description), mode, std::move(camera), std::move(device),
                                        std::move(stream));
}

} // namespace odo
