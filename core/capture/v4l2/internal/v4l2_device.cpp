// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_device.h"

#include "core/base/file_system.h"
#include "core/capture/camera_errors.h"
#include "core/capture/v4l2/internal/v4l2_sysfs.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <linux/videodev2.h>
#include <set>
#include <string>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace odo {

namespace {

/// Links are read, never followed: what lies behind them may hang.
bool holds(const std::filesystem::path &process, const std::filesystem::path &node)
{
    std::error_code problem; // of another user's, or one that has ended: then it is not told
    const std::filesystem::path handles = process / "fd";
    return std::ranges::any_of(files::namesIn(handles, problem), [&](const std::string &name) {
        std::error_code closed;
        return files::linkTarget(handles / name, closed) == node;
    });
}

} // namespace

/// The names of the other programs that have a camera's node open, each once, in alphabetical order: as the
/// kernel tells it of the programs of the same user (of all to the administrator). Empty where it tells of
/// none. Any thread; takes some milliseconds.
std::vector<std::string> programsThatHold(const std::filesystem::path &node)
{
    std::error_code problem;
    const std::filesystem::path real = files::realPath(node, problem);
    if (problem)
        return {};
    const std::string own = std::to_string(::getpid());
    std::set<std::string> names;
    for (const std::string &number : files::namesIn("/proc", problem)) {
        const std::filesystem::path process = std::filesystem::path("/proc") / number;
        if (number == own || !std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; }) ||
            !holds(process, real))
            continue;
        std::string name;
        std::ifstream input(process / "comm");
        if (std::getline(input, name) && !name.empty())
            names.insert(name);
    }
    return {names.begin(), names.end()};
}

namespace {

template <std::size_t size>
std::string textOf(const __u8 (&bytes)[size])
{
    const auto end = std::find(std::begin(bytes), std::end(bytes), 0);
    return {std::begin(bytes), end};
}

} // namespace

Error v4l2Failure(const std::string &uri, int errorNumber)
{
    const Message what = cameraAtAddress(uri);
    switch (errorNumber) {
    case ENOENT:
        return {ErrorCode::NotFound, what, ODO_TEXT("capture.not_there", "it is not there"),
                ODO_TEXT("capture.plug_in_or_choose",
                         "plug it in, or choose one of those that odograph cameras lists")};
    case EACCES:
    case EPERM:
        return {ErrorCode::Io, what, ODO_TEXT("capture.forbidden", "you may not use it"),
                ODO_TEXT("capture.forbidden_advice",
                         "join the group video (sudo usermod -aG video YOUR-NAME) and log in again")};
    case EBUSY:
        return {ErrorCode::Unavailable, what, usedByAnotherProgram(), closeThatProgram()};
    case ENODEV:
    case ENXIO:
        return {ErrorCode::Unavailable, what, ODO_TEXT("capture.unplugged", "it was unplugged"),
                ODO_TEXT("capture.plug_in_again", "plug it in again")};
    case ENOSPC:
        return {ErrorCode::Unavailable, what,
                ODO_TEXT("capture.usb_bus_full",
                         "its USB bus has no room left for its pictures (the bus is full, not the disk)"),
                ODO_TEXT("capture.usb_bus_full_advice",
                         "plug it in where it shares no bus with another camera, or choose MJPEG, a "
                         "smaller picture or a lower rate (?format=MJPG&size=640x480&rate=30)")};
    default:
        return {ErrorCode::Unavailable, what,
                ODO_TEXT("capture.failed",
                         "it failed (%1)")(foreignWords(std::generic_category().message(errorNumber))),
                ODO_TEXT("capture.failed_advice", "unplug it and plug it in again if that lasts")};
    }
}

Error v4l2Failure(const V4l2Device &device, const std::string &uri, int errorNumber)
{
    Error failure = v4l2Failure(uri, errorNumber);
    if (errorNumber != EBUSY)
        return failure;
    const std::vector<std::string> names = programsThatHold(device.node());
    if (!names.empty())
        failure.why = ODO_TEXT("capture.used_by_program", "another program uses it (open in %1)")(
            listed(names, MessageArgument::Kind::Label, MessageArgument::Joint::Comma));
    return failure;
}

Result<std::shared_ptr<V4l2Device>> V4l2Device::open(const std::filesystem::path &node,
                                                     const std::string &uri)
{
    const int descriptor = ::open(node.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return tl::unexpected(v4l2Failure(uri, errno));
    const std::shared_ptr<V4l2Device> device(new V4l2Device(node, descriptor));
    v4l2_capability capability{};
    const int failure = device->call(VIDIOC_QUERYCAP, &capability);
    if (failure != 0 && failure != ENOTTY && failure != EINVAL)
        return tl::unexpected(v4l2Failure(uri, failure));
    constexpr __u32 needed = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
    const __u32 abilities =
        capability.capabilities & V4L2_CAP_DEVICE_CAPS ? capability.device_caps : capability.capabilities;
    if (failure != 0 || (abilities & needed) != needed)
        return fail(ErrorCode::InvalidInput, cameraAtAddress(uri),
                    ODO_TEXT("capture.gives_no_pictures", "%1 gives no pictures")(Named::file(node)),
                    ODO_TEXT("capture.choose_listed", "choose one of those that odograph cameras lists"));
    device->m_identity = {textOf(capability.driver), textOf(capability.card), textOf(capability.bus_info),
                          v4l2Sysfs::serialOf(node), v4l2Sysfs::indexOf(node)};
    return device;
}

V4l2Device::~V4l2Device()
{
    ::close(m_descriptor);
}

int V4l2Device::call(unsigned long request, void *argument) const
{
    int result = 0;
    do {
        result = ::ioctl(m_descriptor, request, argument);
    } while (result < 0 && errno == EINTR);
    return result < 0 ? errno : 0;
}

bool V4l2Device::isBusy() const
{
    v4l2_requestbuffers
        none{}; // asking for no buffers is refused while they are another's, and does nothing otherwise
    none.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    none.memory = V4L2_MEMORY_MMAP;
    return call(VIDIOC_REQBUFS, &none) == EBUSY;
}

std::vector<std::shared_ptr<V4l2Device>> openV4l2Devices()
{
    std::vector<std::shared_ptr<V4l2Device>> devices;
    for (const int number : v4l2Sysfs::nodeNumbers()) {
        const std::filesystem::path node = v4l2Sysfs::nodeOf(number);
        if (auto device = V4l2Device::open(node, node.string()))
            devices.push_back(std::move(*device));
    }
    return devices;
}

} // namespace odo
