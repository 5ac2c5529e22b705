// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_stream.h"

#include "core/base/steady_now.h"
#include "core/capture/camera_source.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <linux/videodev2.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <sys/mman.h>
#include <unistd.h>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds resolution = 1us; // of the time that drivers report
constexpr Nanoseconds largestDelay =
    1s; // from taking to delivery; beyond it a time is not of this machine's clock

/// Of times that wrap.
Nanoseconds between(std::uint64_t earlier, std::uint64_t later)
{
    return Nanoseconds(static_cast<std::int64_t>(later - earlier));
}

} // namespace

void V4l2Stamps::restart(double framesPerSecond)
{
    if (!m_first)
        m_lostRate = framesPerSecond;
}

/// A number may repeat (a driver that rounds its times); the one that it leaves out later is then no loss.
void V4l2Stamps::count(std::uint32_t sequence, Nanoseconds arrival)
{
    const auto step = static_cast<std::int32_t>(sequence - m_lastSequence);
    m_lastSequence = sequence;
    if (m_first)
        return;
    if (m_lostRate > 0) {
        const double missed = toSeconds(arrival - m_lastArrival) * m_lostRate;
        m_stamp.sequence += static_cast<std::uint64_t>(std::max(1L, std::lround(missed)));
        m_repeated = 0;
    } else if (step <= 0) {
        m_repeated += step == 0;
        ++m_stamp.sequence;
    } else {
        const std::uint64_t repaid =
            std::min<std::uint64_t>(static_cast<std::uint64_t>(step) - 1, m_repeated);
        m_repeated -= repaid;
        m_stamp.sequence += static_cast<std::uint64_t>(step) - repaid;
    }
}

/// By the driver's times, unless they contradict the arrivals: then the arrivals bridge the jump.
void V4l2Stamps::advance(std::uint64_t time, Nanoseconds arrival)
{
    const Nanoseconds step = between(m_lastTime, time), arrived = arrival - m_lastArrival;
    m_lastTime = time;
    if (m_first)
        return;
    const bool sound = step > 0ns && std::chrono::abs(step - arrived) < largestDelay;
    m_isTrusted = m_isTrusted && sound;
    m_stamp.time += sound ? step : std::max(arrived, resolution);
}

V4l2Stamps::Stamp V4l2Stamps::next(const V4l2BufferStamp &buffer, Nanoseconds arrival)
{
    count(buffer.sequence, arrival);
    advance(buffer.time, arrival);
    m_first = false;
    m_lostRate = 0;
    m_lastArrival = arrival;
    const Nanoseconds age = between(buffer.time, static_cast<std::uint64_t>(arrival.count()));
    m_isTrusted = m_isTrusted && buffer.isMonotonic && age >= 0ns && age < largestDelay;
    m_stamp.clock.reset();
    if (m_isTrusted) {
        const Nanoseconds host(static_cast<std::int64_t>(buffer.time));
        m_stamp.clock = {m_stamp.time, host, host + resolution};
    }
    return m_stamp;
}

namespace {

constexpr double heldS = 1.0 / 3;
constexpr int fewestHeld = 6;

v4l2_buffer bufferOf(unsigned index)
{
    v4l2_buffer buffer{};
    buffer.index = index;
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    return buffer;
}

/// Unsigned, because the reported value may wrap.
std::uint64_t nanosecondsOf(const timeval &time)
{
    return static_cast<std::uint64_t>(time.tv_sec) * 1'000'000'000 +
           static_cast<std::uint64_t>(time.tv_usec) * 1'000;
}

} // namespace

V4l2Stream::V4l2Stream(std::shared_ptr<V4l2Device> device)
    : m_device(std::move(device)), m_format(std::make_unique<v4l2_pix_format>())
{
}

V4l2Stream::~V4l2Stream()
{
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    m_device->call(VIDIOC_STREAMOFF, &type);
    for (const auto &buffer : m_buffers)
        munmap(buffer.data(), buffer.size());
    v4l2_requestbuffers none{};
    none.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    none.memory = V4L2_MEMORY_MMAP;
    m_device->call(VIDIOC_REQBUFS, &none);
}

Result<std::unique_ptr<V4l2Stream>> V4l2Stream::start(std::shared_ptr<V4l2Device> device,
                                                      const V4l2Mode &mode, const std::string &uri)
{
    std::unique_ptr<V4l2Stream> stream(new V4l2Stream(std::move(device)));
    int failure = stream->setMode(mode);
    if (failure == 0 && (stream->m_format->pixelformat != mode.format ||
                         static_cast<int>(stream->m_format->width) != mode.widthPx ||
                         static_cast<int>(stream->m_format->height) != mode.heightPx))
        return fail(ErrorCode::Unavailable, cameraAtAddress(uri),
                    ODO_TEXT("capture.mode_not_taken", "it rejects %1")(modeWords(mode)),
                    ODO_TEXT("capture.ask_for_other_mode", "choose another size or format"));
    if (failure == 0)
        failure = stream->makeBuffers();
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (failure == 0)
        failure = stream->m_device->call(VIDIOC_STREAMON, &type);
    if (failure != 0)
        return tl::unexpected(v4l2Failure(*stream->m_device, uri, failure));
    return stream;
}

int V4l2Stream::setMode(const V4l2Mode &mode)
{
    v4l2_format format{};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    format.fmt.pix.pixelformat = mode.format;
    format.fmt.pix.width = static_cast<__u32>(mode.widthPx);
    format.fmt.pix.height = static_cast<__u32>(mode.heightPx);
    format.fmt.pix.field = V4L2_FIELD_ANY;
    if (const int failure = m_device->call(VIDIOC_S_FMT, &format); failure != 0)
        return failure;
    *m_format = format.fmt.pix;
    v4l2_streamparm parameters{};
    parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    parameters.parm.capture.timeperframe = {mode.periodNumerator, mode.periodDenominator};
    m_framesPerSecond = mode.framesPerSecond();
    const int failure = m_device->call(VIDIOC_S_PARM, &parameters);
    const v4l2_fract &period = parameters.parm.capture.timeperframe;
    if (failure == 0 && period.numerator > 0)
        m_framesPerSecond = static_cast<double>(period.denominator) / period.numerator;
    return failure == ENOTTY || failure == EINVAL ? 0 : failure; // a driver that has one rate only
}

int V4l2Stream::makeBuffers()
{
    v4l2_requestbuffers request{};
    request.count = static_cast<__u32>(
        std::clamp(static_cast<int>(std::ceil(heldS * m_framesPerSecond)), fewestHeld, VIDEO_MAX_FRAME));
    request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    request.memory = V4L2_MEMORY_MMAP;
    if (const int failure = m_device->call(VIDIOC_REQBUFS, &request); failure != 0)
        return failure;
    for (__u32 i = 0; i < request.count; ++i) {
        v4l2_buffer buffer = bufferOf(i);
        if (const int failure = m_device->call(VIDIOC_QUERYBUF, &buffer); failure != 0)
            return failure;
        void *memory = mmap(nullptr, buffer.length, PROT_READ | PROT_WRITE, MAP_SHARED,
                            m_device->descriptor(), buffer.m.offset);
        if (memory == MAP_FAILED)
            return errno;
        m_buffers.emplace_back(static_cast<std::uint8_t *>(memory), buffer.length);
        if (const int failure = giveBack(i); failure != 0)
            return failure;
    }
    return 0;
}

int V4l2Stream::take(Buffer &taken)
{
    v4l2_buffer buffer = bufferOf(0);
    if (const int failure = m_device->call(VIDIOC_DQBUF, &buffer); failure != 0)
        return failure;
    const std::span<std::uint8_t> memory = m_buffers[buffer.index];
    taken.index = buffer.index;
    taken.bytes = memory.first(std::min<std::size_t>(buffer.bytesused, memory.size()));
    taken.isDamaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
    taken.stamp = {buffer.sequence, nanosecondsOf(buffer.timestamp),
                   (buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC};
    if (taken.stamp.isMonotonic) // a clock that stands still while the machine sleeps
        taken.stamp.time += static_cast<std::uint64_t>(machineSlept().count());
    return 0;
}

int V4l2Stream::giveBack(unsigned index)
{
    v4l2_buffer buffer = bufferOf(index);
    return m_device->call(VIDIOC_QBUF, &buffer);
}

V4l2Watch::V4l2Watch()
    : m_wake(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), m_nodes(inotify_init1(IN_CLOEXEC | IN_NONBLOCK))
{
    // A node may be used only once its owner was set.
    inotify_add_watch(m_nodes, "/dev", IN_CREATE | IN_ATTRIB | IN_MOVED_TO);
}

V4l2Watch::~V4l2Watch()
{
    close(m_nodes);
    close(m_wake);
}

void V4l2Watch::stop()
{
    m_stopped = true;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written =
        ::write(m_wake, &one, sizeof one); // fails only when it is awake already
}

void V4l2Watch::forgetChanges() const
{
    std::array<char, 4096> events{};
    while (read(m_nodes, events.data(), events.size()) > 0) {
    }
}

bool V4l2Watch::wait(int camera, std::chrono::steady_clock::time_point until)
{
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
    std::array<pollfd, 2> waiting{{{m_wake, POLLIN, 0}, {camera < 0 ? m_nodes : camera, POLLIN, 0}}};
    poll(waiting.data(), waiting.size(), static_cast<int>(std::max<std::int64_t>(left, 0)));
    if (camera >= 0)
        return (waiting[1].revents & (POLLERR | POLLHUP | POLLNVAL)) == 0;
    forgetChanges();
    return true;
}

} // namespace odo
