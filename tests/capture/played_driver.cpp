// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/capture/played_driver.h"

#include "core/capture/v4l2/internal/v4l2_sysfs.h"

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace odo::test {

namespace {

constexpr std::uint32_t frameBytes = 2 * PlayedDriver::width * PlayedDriver::height, bufferBytes = 8192,
                        mostBuffers = 32;
constexpr Nanoseconds longestCall = std::chrono::milliseconds(5);
static_assert(frameBytes <= bufferBytes && bufferBytes % 4096 == 0);

std::atomic<PlayedDriver *> onlyOne = nullptr;

Nanoseconds monotonicNow()
{
    return std::chrono::steady_clock::now().time_since_epoch();
}

template <std::size_t size>
void write(__u8 (&into)[size], const char *text)
{
    std::strncpy(reinterpret_cast<char *>(into), text, size - 1);
}

} // namespace

PlayedDriver::PlayedDriver()
    : m_node(m_folder.filePath(QStringLiteral("video0")).toStdString()),
      m_memory(::open(m_node.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600))
{
    if (m_memory < 0 || ftruncate(m_memory, mostBuffers * bufferBytes) != 0)
        qFatal("the played driver has no file");
    onlyOne = this;
}

PlayedDriver::~PlayedDriver()
{
    onlyOne = nullptr;
    ::close(m_memory);
}

PlayedDriver *PlayedDriver::present()
{
    return onlyOne;
}

PlayedDriver *PlayedDriver::atDescriptor(int descriptor)
{
    PlayedDriver *driver = onlyOne;
    std::error_code error;
    return driver && std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error) ==
                         driver->m_node
               ? driver
               : nullptr;
}

int PlayedDriver::call(unsigned long request, void *argument)
{
    if (isUnplugged)
        return ENODEV;
    const int described = describe(request, argument);
    return described == ENOTTY ? stream(request, argument) : described;
}

/// What it is, and the one mode that it has.
int PlayedDriver::describe(unsigned long request, void *argument)
{
    switch (request) {
    case VIDIOC_QUERYCAP: {
        auto &capability = *static_cast<v4l2_capability *>(argument);
        write(capability.driver, "played");
        write(capability.card, "Played webcam");
        write(capability.bus_info, "usb-played-1");
        capability.capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
        return 0;
    }
    case VIDIOC_ENUM_FMT: {
        auto &format = *static_cast<v4l2_fmtdesc *>(argument);
        format.pixelformat = V4L2_PIX_FMT_YUYV;
        return format.index == 0 ? 0 : EINVAL;
    }
    case VIDIOC_ENUM_FRAMESIZES: {
        auto &size = *static_cast<v4l2_frmsizeenum *>(argument);
        size.type = V4L2_FRMSIZE_TYPE_DISCRETE;
        size.discrete = {width, height};
        return size.index == 0 ? 0 : EINVAL;
    }
    case VIDIOC_ENUM_FRAMEINTERVALS: {
        auto &interval = *static_cast<v4l2_frmivalenum *>(argument);
        interval.type = V4L2_FRMIVAL_TYPE_DISCRETE;
        interval.discrete = {1, rate};
        return interval.index == 0 ? 0 : EINVAL;
    }
    case VIDIOC_S_FMT: {
        auto &image = static_cast<v4l2_format *>(argument)->fmt.pix;
        image.bytesperline = 2 * width;
        image.sizeimage = frameBytes;
        return 0;
    }
    case VIDIOC_S_PARM:
        static_cast<v4l2_streamparm *>(argument)->parm.capture.timeperframe = {1, rate};
        return 0;
    default:
        return ENOTTY;
    }
}

int PlayedDriver::stream(unsigned long request, void *argument)
{
    const std::lock_guard lock(m_mutex);
    switch (request) {
    case VIDIOC_REQBUFS: {
        auto &wanted = *static_cast<v4l2_requestbuffers *>(argument);
        m_buffers = wanted.count = std::min<std::uint32_t>(wanted.count, mostBuffers);
        m_free.clear();
        return 0;
    }
    case VIDIOC_QUERYBUF: {
        auto &buffer = *static_cast<v4l2_buffer *>(argument);
        buffer.length = bufferBytes;
        buffer.m.offset = buffer.index * bufferBytes;
        return buffer.index < m_buffers ? 0 : EINVAL;
    }
    case VIDIOC_QBUF:
        m_free.push_back(static_cast<v4l2_buffer *>(argument)->index);
        return 0;
    case VIDIOC_STREAMON:
        if (streamOnFailure != 0)
            return streamOnFailure;
        m_due = monotonicNow();
        m_sequence = 0;
        return 0;
    case VIDIOC_STREAMOFF:
        m_due.reset();
        return 0;
    case VIDIOC_DQBUF:
        return giveOut(*static_cast<v4l2_buffer *>(argument));
    default:
        return ENOTTY;
    }
}

/// Waits a moment where no picture is due: a file, unlike a camera, always seems to have something to be
/// read. The mutex is held.
int PlayedDriver::giveOut(v4l2_buffer &buffer)
{
    if (!m_due || m_free.empty())
        return EINVAL;
    std::this_thread::sleep_for(std::clamp(*m_due - monotonicNow(), Nanoseconds(0), longestCall));
    if (*m_due > monotonicNow())
        return EAGAIN;
    buffer.index = m_free.front();
    m_free.erase(m_free.begin());
    buffer.bytesused = frameBytes;
    buffer.flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
    buffer.sequence = m_sequence++;
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(*m_due);
    buffer.timestamp = {whole.count(),
                        std::chrono::duration_cast<std::chrono::microseconds>(*m_due - whole).count()};
    *m_due += Nanoseconds(std::chrono::seconds(1)) / framesPerSecond.load();
    return 0;
}

} // namespace odo::test

namespace odo::v4l2Sysfs {

std::vector<int> nodeNumbers()
{
    const auto *driver = test::PlayedDriver::present();
    return driver && !driver->isUnplugged ? std::vector<int>{0} : std::vector<int>{};
}
std::filesystem::path nodeOf(int)
{
    return test::PlayedDriver::present()->node();
}
std::string nameOf(const std::filesystem::path &)
{
    return "Played webcam";
}
std::string indexOf(const std::filesystem::path &)
{
    return "0";
}
std::string serialOf(const std::filesystem::path &)
{
    return "PLAYED-1";
}

} // namespace odo::v4l2Sysfs

extern "C" int ioctl(int descriptor, unsigned long request, ...) noexcept
{
    va_list arguments;
    va_start(arguments, request);
    void *argument = va_arg(arguments, void *);
    va_end(arguments);
    odo::test::PlayedDriver *driver = odo::test::PlayedDriver::atDescriptor(descriptor);
    if (!driver)
        return static_cast<int>(syscall(SYS_ioctl, descriptor, request, argument));
    errno = driver->call(request, argument);
    return errno == 0 ? 0 : -1;
}
