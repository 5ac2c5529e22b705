// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_device.h"

#include "core/base/file_system.h"
#include "core/capture/camera_source.h"
#include "core/capture/v4l2/internal/v4l2_sysfs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
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
    std::error_code problem; // of another user's, or of one that has ended: not known
    const std::filesystem::path handles = process / "fd";
    return std::ranges::any_of(files::namesIn(handles, problem), [&](const std::string &name) {
        std::error_code closed;
        return files::linkTarget(handles / name, closed) == node;
    });
}

} // namespace

/// The names of the other programs that have a camera's node open, each once, in alphabetical order: as the
/// kernel reports them for the programs of the same user (of all to the administrator). Empty where it
/// reports none. Any thread; takes some milliseconds.
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
        return {ErrorCode::NotFound, what, ODO_TEXT("capture.not_there", "it is not connected"),
                ODO_TEXT("capture.plug_in_or_choose",
                         "plug it in, or choose a camera that odograph cameras lists")};
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
                         "its USB bus has no bandwidth left for its frames (the bus is full, not the disk)"),
                ODO_TEXT("capture.usb_bus_full_advice",
                         "plug it into a port whose bus no other camera uses, or choose MJPEG, a smaller "
                         "frame size or a lower rate (?format=MJPG&size=640x480&rate=30)")};
    default:
        return {ErrorCode::Unavailable, what,
                ODO_TEXT("capture.failed",
                         "it failed (%1)")(foreignWords(std::generic_category().message(errorNumber))),
                ODO_TEXT("capture.failed_advice", "if this continues, unplug it and plug it in again")};
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
                    ODO_TEXT("capture.gives_no_pictures", "%1 sends no frames")(Named::file(node)),
                    ODO_TEXT("capture.choose_listed", "choose a camera that odograph cameras lists"));
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

namespace {

/// A control with what the driver needs to set it.
struct Control
{
    CameraControl shown;
    __u32 id = 0, type = 0;
    std::vector<__s64> places; ///< in the driver's menu, of each choice
};

/// An automatic, the value that turns it off, and what it has moved.
struct Automatic
{
    __u32 id = 0;
    __s64 off = 0;
    std::array<__u32, 3> moved{};
};
constexpr std::array<Automatic, 9> automatics{{
    {V4L2_CID_EXPOSURE_AUTO,
     V4L2_EXPOSURE_MANUAL,
     {V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_CID_EXPOSURE, V4L2_CID_IRIS_ABSOLUTE}},
    {V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0, {}}, // lets the rate fall for the sake of the exposure
    {V4L2_CID_AUTOGAIN, 0, {V4L2_CID_GAIN, V4L2_CID_ANALOGUE_GAIN}},
    {V4L2_CID_ISO_SENSITIVITY_AUTO, V4L2_ISO_SENSITIVITY_MANUAL, {V4L2_CID_ISO_SENSITIVITY}},
    {V4L2_CID_AUTO_WHITE_BALANCE,
     0,
     {V4L2_CID_WHITE_BALANCE_TEMPERATURE, V4L2_CID_RED_BALANCE, V4L2_CID_BLUE_BALANCE}},
    {V4L2_CID_FOCUS_AUTO, 0, {V4L2_CID_FOCUS_ABSOLUTE}},
    {V4L2_CID_AUTOBRIGHTNESS, 0, {V4L2_CID_BRIGHTNESS}},
    {V4L2_CID_HUE_AUTO, 0, {V4L2_CID_HUE}},
    {V4L2_CID_CHROMA_AGC, 0, {V4L2_CID_CHROMA_GAIN}},
}};

std::string idOf(const std::string &name)
{
    std::string id;
    for (const char c : name) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) != 0)
            id += static_cast<char>(std::tolower(letter));
        else if (!id.empty() && id.back() != '_')
            id += '_';
    }
    return id.ends_with('_') ? id.substr(0, id.size() - 1) : id;
}

std::optional<CameraControl::Kind> kindOf(__u32 type)
{
    switch (type) {
    case V4L2_CTRL_TYPE_INTEGER:
    case V4L2_CTRL_TYPE_INTEGER64:
    case V4L2_CTRL_TYPE_BITMASK:
        return CameraControl::Kind::Integer;
    case V4L2_CTRL_TYPE_BOOLEAN:
    case V4L2_CTRL_TYPE_BUTTON:
        return CameraControl::Kind::Boolean;
    case V4L2_CTRL_TYPE_MENU:
    case V4L2_CTRL_TYPE_INTEGER_MENU:
        return CameraControl::Kind::Choice;
    default:
        return std::nullopt;
    }
}

std::string unitOf(__u32 id)
{
    switch (id) {
    case V4L2_CID_EXPOSURE_ABSOLUTE:
        return "100 µs";
    case V4L2_CID_WHITE_BALANCE_TEMPERATURE:
        return "K";
    default:
        return {};
    }
}

/// 0 or the errno.
int transfer(const V4l2Device &device, unsigned long request, const Control &control, __s64 &value)
{
    v4l2_ext_control one{};
    one.id = control.id;
    if (control.type == V4L2_CTRL_TYPE_INTEGER64)
        one.value64 = value;
    else
        one.value = static_cast<__s32>(value);
    v4l2_ext_controls all{};
    all.which = V4L2_CTRL_WHICH_CUR_VAL;
    all.count = 1;
    all.controls = &one;
    const int failure = device.call(request, &all);
    if (control.type == V4L2_CTRL_TYPE_INTEGER64)
        value = one.value64;
    else if (control.type == V4L2_CTRL_TYPE_BITMASK)
        value = static_cast<__u32>(one.value);
    else
        value = one.value;
    return failure;
}

void readMenu(const V4l2Device &device, const v4l2_query_ext_ctrl &query, Control &control)
{
    for (__s64 place = query.minimum; place <= query.maximum; ++place) {
        v4l2_querymenu item{};
        item.id = query.id;
        item.index = static_cast<__u32>(place);
        if (device.call(VIDIOC_QUERYMENU, &item) != 0)
            continue; // a choice that this camera does not have
        control.places.push_back(place);
        control.shown.choices.push_back(query.type == V4L2_CTRL_TYPE_INTEGER_MENU
                                            ? std::to_string(item.value)
                                            : std::string(reinterpret_cast<const char *>(item.name)));
    }
}

/// The driver's value as it is shown: of a menu the place among the choices.
double shownValue(const Control &control, __s64 value)
{
    if (control.shown.kind != CameraControl::Kind::Choice)
        return static_cast<double>(value);
    const auto found = std::ranges::find(control.places, value);
    return found == control.places.end() ? 0 : static_cast<double>(found - control.places.begin());
}

Control describe(const V4l2Device &device, const v4l2_query_ext_ctrl &query, CameraControl::Kind kind)
{
    Control control;
    control.id = query.id;
    control.type = query.type;
    control.shown.name = query.name;
    control.shown.id = idOf(query.name);
    control.shown.kind = kind;
    control.shown.minimum = static_cast<double>(query.minimum);
    control.shown.maximum = query.type == V4L2_CTRL_TYPE_BITMASK
                                ? static_cast<double>(static_cast<__u32>(query.maximum))
                                : static_cast<double>(query.maximum);
    control.shown.step = static_cast<double>(query.step);
    control.shown.unit = unitOf(query.id);
    control.shown.readOnly =
        (query.flags & (V4L2_CTRL_FLAG_READ_ONLY | V4L2_CTRL_FLAG_INACTIVE | V4L2_CTRL_FLAG_GRABBED)) != 0;
    if (kind == CameraControl::Kind::Choice) {
        readMenu(device, query, control);
        control.shown.minimum = 0;
        control.shown.maximum = static_cast<double>(control.places.size()) - 1;
        control.shown.step = 1;
    } else if (query.type == V4L2_CTRL_TYPE_BUTTON) {
        control.shown.maximum = control.shown.step = 1;
    }
    control.shown.standard = shownValue(control, query.default_value);
    __s64 value = query.default_value;
    if (query.type != V4L2_CTRL_TYPE_BUTTON && (query.flags & V4L2_CTRL_FLAG_WRITE_ONLY) == 0)
        transfer(device, VIDIOC_G_EXT_CTRLS, control, value);
    control.shown.value = shownValue(control, value);
    return control;
}

Result<std::vector<Control>> readControls(const V4l2Device &device, const std::string &uri)
{
    std::vector<Control> controls;
    v4l2_query_ext_ctrl query{};
    int failure = 0;
    for (;;) {
        query.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
        failure = device.call(VIDIOC_QUERY_EXT_CTRL, &query);
        if (failure != 0)
            break;
        const auto kind = kindOf(query.type);
        if (kind && (query.flags & V4L2_CTRL_FLAG_DISABLED) == 0)
            controls.push_back(describe(device, query, *kind));
    }
    if (failure != EINVAL && failure != ENOTTY) // how the end is signalled, also by a camera without controls
        return tl::unexpected(v4l2Failure(uri, failure));
    return controls;
}

Result<void> write(const V4l2Device &device, const std::string &uri, const Control &control, __s64 value)
{
    switch (const int failure = transfer(device, VIDIOC_S_EXT_CTRLS, control, value)) {
    case 0:
        return {};
    case EACCES:
    case EINVAL:
    case ERANGE:
        return fail(
            ErrorCode::InvalidInput, cameraAtAddress(uri),
            ODO_TEXT("capture.control_value_refused", "it rejects this value of %1")(control.shown.name),
            ODO_TEXT("capture.choose_another_value", "choose another one"));
    default:
        return tl::unexpected(v4l2Failure(uri, failure));
    }
}

const Control *find(const std::vector<Control> &controls, __u32 id)
{
    const auto found = std::ranges::find(controls, id, &Control::id);
    return found == controls.end() ? nullptr : &*found;
}

/// Whether it is off afterwards.
bool turnOff(const V4l2Device &device, const std::string &uri, const Control &control, __s64 off,
             V4l2Held &held)
{
    const double shown = shownValue(control, off);
    const bool hasIt =
        control.places.empty() || std::ranges::find(control.places, off) != control.places.end();
    if (hasIt && control.shown.value == shown) {
        held.settings.emplace_back(control.shown.id, shown);
        return true;
    }
    if (!hasIt || control.shown.readOnly || !write(device, uri, control, off))
        return false;
    held.settings.emplace_back(control.shown.id, shown);
    held.automatics.emplace_back(control.shown.id, control.shown.value);
    return true;
}

} // namespace

Result<std::vector<CameraControl>> v4l2Controls(const V4l2Device &device, const std::string &uri)
{
    auto controls = ODO_TRY(readControls(device, uri));
    std::vector<CameraControl> shown;
    for (Control &control : controls)
        shown.push_back(std::move(control.shown));
    return shown;
}

Result<void> setV4l2Control(const V4l2Device &device, const std::string &uri, const std::string &id,
                            double value)
{
    const auto controls = ODO_TRY(readControls(device, uri));
    const auto found =
        std::ranges::find(controls, id, [](const Control &control) { return control.shown.id; });
    if (found == controls.end())
        return noSuchControl(uri, id);
    const CameraControl &shown = found->shown;
    if (shown.readOnly)
        return fail(
            ErrorCode::InvalidInput, cameraAtAddress(uri),
            ODO_TEXT("capture.control_inactive", "%1 cannot be set in the camera's current mode")(shown.name),
            ODO_TEXT("capture.turn_off_automatic_first",
                     "first turn off the automatic mode that controls it"));
    if (!(value >= shown.minimum && value <= shown.maximum))
        return fail(ErrorCode::InvalidInput, cameraAtAddress(uri),
                    controlGoes(shown.name, quantity(shown.minimum, 0), quantity(shown.maximum, 0)),
                    ODO_TEXT("capture.choose_value_between", "choose a value between"));
    if (found->type == V4L2_CTRL_TYPE_BUTTON && value == 0)
        return {};
    const auto rounded = static_cast<__s64>(std::llround(value));
    return write(device, uri, *found,
                 found->places.empty() ? rounded : found->places[static_cast<std::size_t>(rounded)]);
}

V4l2Held holdV4l2Automatics(const V4l2Device &device, const std::string &uri)
{
    V4l2Held held;
    const auto controls = readControls(device, uri);
    if (!controls)
        return held;
    for (const Automatic &automatic : automatics) {
        const Control *control = find(*controls, automatic.id);
        if (!control)
            continue;
        if (!turnOff(device, uri, *control, automatic.off, held)) {
            held.stillOn.push_back(foreignWords(control->shown.name));
            continue;
        }
        // Many a camera falls back to what was set by hand before: it is to stay where the automatic had it.
        for (const __u32 id : automatic.moved) {
            const Control *moved = id == 0 ? nullptr : find(*controls, id);
            if (moved && setV4l2Control(device, uri, moved->shown.id, moved->shown.value))
                held.settings.emplace_back(moved->shown.id, moved->shown.value);
        }
    }
    return held;
}

} // namespace odo
