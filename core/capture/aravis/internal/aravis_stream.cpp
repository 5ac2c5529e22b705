// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/aravis_stream.h"

#include "core/base/file_system.h"
#include "core/base/steady_now.h"
#include "core/capture/camera_source.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace odo {

namespace {

using namespace std::chrono_literals;

// Buffers for what comes while the worker is busy (at most half a second), within some memory.
constexpr std::size_t fewestBuffers = 8, mostBufferBytes = 128 << 20;
constexpr double bufferedS = 0.6;
// Packets wait in the kernel while the machine is busy elsewhere.
constexpr std::size_t leastReceiveBuffer = 4 << 20, mostReceiveBuffer = 32 << 20, framesInReceiveBuffer = 4;
constexpr Nanoseconds oldestArrival = 2s;

/// The socket of this process that is bound to a UDP port; -1 without one. Aravis does not give it out, and
/// sets its size only when the first frame has started, which loses that one.
int socketOfPort(std::uint16_t port)
{
    std::error_code error;
    for (const std::string &number : files::namesIn("/proc/self/fd", error)) {
        int handle = -1;
        std::from_chars(number.data(), number.data() + number.size(), handle);
        int type = 0;
        socklen_t length = sizeof type;
        sockaddr_in name{};
        socklen_t nameLength = sizeof name;
        if (getsockopt(handle, SOL_SOCKET, SO_TYPE, &type, &length) == 0 && type == SOCK_DGRAM &&
            getsockname(handle, reinterpret_cast<sockaddr *>(&name), &nameLength) == 0 &&
            name.sin_family == AF_INET && ntohs(name.sin_port) == port)
            return handle;
    }
    return -1;
}

/// What the kernel has granted, in bytes.
std::size_t setReceiveBuffer(int handle, std::size_t wanted)
{
    const int bytes = static_cast<int>(wanted);
    if (setsockopt(handle, SOL_SOCKET, SO_RCVBUFFORCE, &bytes, sizeof bytes) != 0)
        setsockopt(handle, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof bytes);
    int granted = 0;
    socklen_t length = sizeof granted;
    getsockopt(handle, SOL_SOCKET, SO_RCVBUF, &granted, &length);
    return static_cast<std::size_t>(granted) / 2; // the kernel doubles it for its own needs
}

Nanoseconds arrivalOf(ArvBuffer *buffer)
{
    // Aravis stamps by the clock of the day, which may be set; that it is not long ago is all that is taken
    // from it.
    const Nanoseconds now = steadyNow(), today = std::chrono::system_clock::now().time_since_epoch();
    const Nanoseconds ago =
        today - Nanoseconds(static_cast<std::int64_t>(arv_buffer_get_system_timestamp(buffer)));
    return ago >= 0ns && ago < oldestArrival ? now - ago : now;
}

} // namespace

Result<std::unique_ptr<AravisStream>> AravisStream::start(AravisDevice &device, const AravisAddress &address)
{
    const auto cannot = [&](const ArvFailure &failure) {
        return fail(
            ErrorCode::Unavailable, cameraAtAddress(address.uri),
            ODO_TEXT("capture.does_not_start", "it does not start (%1)")(failure.words()),
            ODO_TEXT("capture.does_not_start_advice", "check its cable, and that no other program uses it"));
    };
    ArvFailure failure;
    ArvPointer<ArvStream> created(arv_camera_create_stream(device.camera(), nullptr, nullptr, failure.out()));
    if (!created)
        return cannot(failure);
    std::unique_ptr<AravisStream> stream(new AravisStream(device, std::move(created)));
    if (device.location().onNetwork)
        stream->enlargeReceiveBuffer();
    const AravisMode &mode = device.mode();
    const auto wanted = std::max(fewestBuffers, static_cast<std::size_t>(bufferedS * mode.framesPerSecond));
    const std::size_t buffers = std::max(fewestBuffers, std::min(wanted, mostBufferBytes / mode.payload));
    for (std::size_t i = 0; i < buffers; ++i)
        arv_stream_push_buffer(stream->m_stream.get(), arv_buffer_new_allocate(mode.payload));
    arv_camera_start_acquisition(device.camera(), failure.out());
    if (failure)
        return cannot(failure);
    return stream;
}

AravisStream::AravisStream(AravisDevice &device, ArvPointer<ArvStream> stream)
    : m_device(device), m_stream(std::move(stream))
{
}

AravisStream::~AravisStream()
{
    if (!m_abandoned)
        arv_camera_stop_acquisition(m_device.camera(), ArvFailure().out());
}

void AravisStream::enlargeReceiveBuffer()
{
    const std::size_t wanted =
        std::clamp(framesInReceiveBuffer * m_device.mode().payload, leastReceiveBuffer, mostReceiveBuffer);
    // Fixed at no size: Aravis leaves it to us.
    g_object_set(m_stream.get(), "socket-buffer", ARV_GV_STREAM_SOCKET_BUFFER_FIXED, "socket-buffer-size", 0,
                 nullptr);
    const int handle = socketOfPort(arv_gv_stream_get_port(ARV_GV_STREAM(m_stream.get())));
    const std::size_t granted = handle < 0 ? 0 : setReceiveBuffer(handle, wanted);
    if (granted < std::min(wanted, 2 * m_device.mode().payload))
        m_warning = joined(
            {ODO_TEXT("capture.receive_buffer_granted", "the system keeps only %1 of the network's packets")(
                 quantity(static_cast<double>(granted / 1024), 0, "kB")),
             ODO_TEXT("capture.set_receive_buffer",
                      "sysctl -w net.core.rmem_max=%1")(std::to_string(wanted))},
            Join::Semicolon);
}

std::optional<AravisFrame> AravisStream::next(Nanoseconds patience)
{
    const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(patience).count();
    ArvBuffer *buffer = arv_stream_timeout_pop_buffer(
        m_stream.get(), static_cast<guint64>(std::max<std::int64_t>(0, microseconds)));
    if (!buffer)
        return std::nullopt;
    auto received = frameIn(buffer);
    arv_stream_push_buffer(m_stream.get(), buffer);
    return received;
}

/// Aravis reports success for a frame smaller than its buffer: compare its size.
std::optional<AravisFrame> AravisStream::frameIn(ArvBuffer *buffer)
{
    const ArvBufferStatus status = arv_buffer_get_status(buffer);
    if (status == ARV_BUFFER_STATUS_CLEARED || status == ARV_BUFFER_STATUS_ABORTED)
        return std::nullopt;
    const AravisMode &mode = m_device.mode();
    std::size_t size = 0;
    const void *bytes =
        status == ARV_BUFFER_STATUS_SUCCESS ? arv_buffer_get_image_data(buffer, &size) : nullptr;
    if (!bytes || size < mode.imageSize() || arv_buffer_get_image_width(buffer) != mode.widthPx ||
        arv_buffer_get_image_height(buffer) != mode.heightPx ||
        arv_buffer_get_image_pixel_format(buffer) != mode.format.code) {
        ++m_damaged;
        return std::nullopt;
    }
    AravisFrame received;
    received.arrival = arrivalOf(buffer);
    received.frame =
        genicamPlanes(mode.format, static_cast<const std::uint8_t *>(bytes), mode.widthPx, mode.heightPx);
    received.id = arv_buffer_get_frame_id(buffer);
    received.stamp = Nanoseconds(static_cast<std::int64_t>(arv_buffer_get_timestamp(buffer)));
    return received;
}

std::uint64_t AravisStream::resent() const
{
    if (!m_device.location().onNetwork)
        return 0;
    guint64 resent = 0, missing = 0;
    arv_gv_stream_get_statistics(ARV_GV_STREAM(m_stream.get()), &resent, &missing);
    return resent;
}

std::uint64_t AravisStream::unbuffered() const
{
    guint64 completed = 0, failed = 0, underruns = 0;
    arv_stream_get_statistics(m_stream.get(), &completed, &failed, &underruns);
    return underruns;
}

} // namespace odo
