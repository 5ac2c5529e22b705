// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/aravis_device.h"

#include "core/base/steady_now.h"
#include "core/capture/aravis/internal/aravis_library.h"
#include "core/capture/aravis/internal/gvcp.h"
#include "core/capture/camera_source.h"
#include "core/video/planes/camera_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

enum Code : std::uint32_t {
    Mono8 = 0x01080001,
    BayerGr8 = 0x01080008,
    BayerRg8 = 0x01080009,
    BayerGb8 = 0x0108000a,
    BayerBg8 = 0x0108000b,
    Rgb8 = 0x02180014,
    Bgr8 = 0x02180015
};

constexpr std::array<GenicamFormat, 7> formats{{{BayerRg8, "BayerRG8", 1},
                                                {BayerGr8, "BayerGR8", 1},
                                                {BayerGb8, "BayerGB8", 1},
                                                {BayerBg8, "BayerBG8", 1},
                                                {Rgb8, "RGB8", 3},
                                                {Bgr8, "BGR8", 3},
                                                {Mono8, "Mono8", 1}}};

} // namespace

std::span<const GenicamFormat> usableGenicamFormats()
{
    return formats;
}

std::optional<GenicamFormat> usableGenicamFormat(std::uint32_t code)
{
    const auto found = std::ranges::find(formats, code, &GenicamFormat::code);
    return found == formats.end() ? std::nullopt : std::optional(*found);
}

MessageArgument namesOfUsableFormats()
{
    std::vector<std::string> names;
    for (const GenicamFormat &format : formats)
        names.emplace_back(format.name);
    return listed(names, MessageArgument::Kind::Label, MessageArgument::Joint::Comma);
}

Message doesNotAnswer()
{
    return ODO_TEXT("capture.does_not_answer", "it does not answer");
}

Message checkPowerAndCable()
{
    return ODO_TEXT("capture.check_power_and_cable", "check its power and cable");
}

Frame genicamPlanes(const GenicamFormat &format, const std::uint8_t *bytes, int widthPx, int heightPx)
{
    const PlaneView raw{bytes, widthPx, heightPx, widthPx};
    const auto packed = [&](RgbView::Order order) {
        return RgbView{bytes, widthPx, heightPx, std::ptrdiff_t{3} * widthPx, order};
    };
    switch (format.code) {
    case BayerRg8:
        return bayerPlanes(raw, BayerOrder::Rggb, 0, {});
    case BayerGr8:
        return bayerPlanes(raw, BayerOrder::Grbg, 0, {});
    case BayerGb8:
        return bayerPlanes(raw, BayerOrder::Gbrg, 0, {});
    case BayerBg8:
        return bayerPlanes(raw, BayerOrder::Bggr, 0, {});
    case Rgb8:
        return rgbPlanes(packed(RgbView::Order::Rgb), 0, {});
    case Bgr8:
        return rgbPlanes(packed(RgbView::Order::Bgr), 0, {});
    default:
        return monoPlanes(raw, 0, {});
    }
}

namespace {

using namespace std::chrono_literals;

constexpr auto openingPatience = 300ms;
constexpr int mostQuestions = 3; // one may be lost
constexpr int offsetStep = 16;   // a multiple of what cameras demand
constexpr std::int64_t nanosecondsPerSecond = 1'000'000'000;
constexpr double rateWhereUntold = 30;
// A delayed reading is tried again.
constexpr int mostReadings = 3;
constexpr Nanoseconds shortRoundTrip = 200us;

bool has(ArvCamera *camera, const char *feature)
{
    return arv_camera_is_feature_available(camera, feature, ArvFailure().out());
}

/// Of a frame, as its sensor is read out now; zeros where it is not reported.
std::pair<int, int> largestSize(ArvCamera *camera)
{
    ArvFailure failure;
    const auto width = arv_camera_get_integer(camera, "WidthMax", failure.out());
    const auto height = failure ? 0 : arv_camera_get_integer(camera, "HeightMax", failure.out());
    return failure ? std::pair(0, 0) : std::pair(static_cast<int>(width), static_cast<int>(height));
}

std::optional<GvcpCamera> whoIsAt(const std::string &address)
{
    std::optional<GvcpCamera> camera;
    for (int i = 0; i < mostQuestions && !camera; ++i)
        camera = askGvcpCamera(address, openingPatience);
    return camera;
}

tl::unexpected<Error> noAnswerTo(const AravisAddress &address)
{
    return fail(ErrorCode::Unavailable, cameraAtAddress(address.uri), doesNotAnswer(),
                ODO_TEXT("capture.check_power_and_network",
                         "check its power and cable, and that this computer has an address in the camera's "
                         "network"));
}

tl::unexpected<Error> inUse(const AravisAddress &address)
{
    return fail(ErrorCode::Unavailable, cameraAtAddress(address.uri), usedByAnotherProgram(),
                joined({closeThatProgram(),
                        ODO_TEXT("capture.free_after_crash",
                                 "a camera whose program has crashed is free again after some seconds")},
                       Join::Semicolon));
}

/// A stamp in nanoseconds, as Aravis makes them of ticks.
Nanoseconds ticksToTime(std::int64_t ticks, std::int64_t perSecond)
{
    return Nanoseconds(ticks / perSecond * nanosecondsPerSecond +
                       ticks % perSecond * nanosecondsPerSecond / perSecond);
}

} // namespace

Result<AravisLocation> AravisDevice::find(const AravisAddress &address)
{
    if (isIpAddress(address.location)) {
        const auto camera = whoIsAt(address.location);
        if (!camera)
            return noAnswerTo(address);
        return AravisLocation{camera->address, true, camera->vendor, camera->model, camera->serial};
    }
    for (const UsbVisionCamera &camera : AravisLibrary::instance().usbCameras()) {
        if (camera.serial == address.location)
            return AravisLocation{camera.id, false, camera.vendor, camera.model, camera.serial};
    }
    for (const GvcpCamera &camera : discoverGvcpCameras()) {
        if (camera.serial == address.location)
            return AravisLocation{camera.address, true, camera.vendor, camera.model, camera.serial};
    }
    return fail(ErrorCode::Unavailable, cameraAtAddress(address.uri),
                ODO_TEXT("capture.serial_does_not_answer", "no camera of this serial number answers"),
                ODO_TEXT("capture.serial_advice",
                         "check its power and cable; odograph cameras lists those that answer"));
}

Result<std::unique_ptr<AravisDevice>> AravisDevice::open(const AravisLocation &location,
                                                         const AravisAddress &wanted)
{
    if (location.onNetwork) {
        const auto controlled = isGvcpControlled(location.openId, openingPatience);
        if (!controlled)
            return noAnswerTo(wanted);
        if (*controlled)
            return inUse(wanted);
    }
    ArvPointer<ArvCamera> camera;
    ArvFailure failure;
    {
        const std::lock_guard lock(AravisLibrary::instance().openMutex());
        camera.reset(arv_camera_new(location.openId.c_str(), failure.out()));
    }
    if (!camera)
        return fail(
            ErrorCode::Unavailable, cameraAtAddress(wanted.uri),
            ODO_TEXT("capture.cannot_be_opened", "it cannot be opened (%1)")(failure.words()),
            location.onNetwork
                ? ODO_TEXT("capture.check_cable_and_address", "check its cable and address")
                : ODO_TEXT("capture.check_usb_rights",
                           "check that you may use it (a udev rule), and that no other program does"));
    std::unique_ptr<AravisDevice> device(new AravisDevice(location, std::move(camera)));
    // Aravis opens a camera that another program has got hold of meanwhile, and cannot do anything with it.
    if (location.onNetwork &&
        !arv_gv_device_is_controller(ARV_GV_DEVICE(arv_camera_get_device(device->camera()))))
        return inUse(wanted);
    ODO_TRY(device->setUp(wanted));
    return device;
}

AravisDevice::AravisDevice(AravisLocation location, ArvPointer<ArvCamera> camera)
    : m_location(std::move(location)), m_camera(std::move(camera))
{
}

// Aravis's signal control-lost is not listened to: while it is being emitted it holds the device, and where
// that is the last hold its heartbeat thread destroys the device, waits for itself and aborts the program.
bool AravisDevice::isLost() const
{
    return m_location.onNetwork &&
           !arv_gv_device_is_controller(ARV_GV_DEVICE(arv_camera_get_device(m_camera.get())));
}

tl::unexpected<Error> AravisDevice::refused(const AravisAddress &wanted, Message why,
                                            const ArvFailure &failure) const
{
    if (failure.is(ARV_DEVICE_ERROR_TIMEOUT))
        return noAnswerTo(wanted);
    return fail(
        ErrorCode::InvalidInput, cameraAtAddress(wanted.uri), std::move(why),
        ODO_TEXT("capture.ask_for_something_else", "use another value, or leave the choice to the camera"));
}

/// The order matters: the frame format sets the bounds of the rate, and setting the rate turns a
/// trigger off.
Result<void> AravisDevice::setUp(const AravisAddress &wanted)
{
    arv_camera_set_range_check_policy(m_camera.get(), ARV_RANGE_CHECK_POLICY_ENABLE);
    return chooseSize(wanted)
        .and_then([&] { return chooseFormat(wanted); })
        .and_then([&] { return choosePace(wanted); })
        .and_then([&] { return setUpTransport(wanted); })
        .and_then([&] { return readBack(wanted); });
}

Result<void> AravisDevice::chooseSize(const AravisAddress &wanted)
{
    if (!wanted.sizePx)
        return {};
    const auto [width, height] = *wanted.sizePx;
    const auto [sensorWidth, sensorHeight] = largestSize(m_camera.get());
    ArvFailure failure;
    if (sensorWidth > 0 && (width > sensorWidth || height > sensorHeight))
        return fail(ErrorCode::InvalidInput, cameraAtAddress(wanted.uri),
                    ODO_TEXT("capture.largest_picture", "its frames have at most %1 pixels")(
                        std::to_string(sensorWidth) + "x" + std::to_string(sensorHeight)),
                    ODO_TEXT("capture.ask_within_sensor", "choose a size within that"));
    const auto middle = [](int sensor, int size) {
        return std::max(0, (sensor - size) / 2 / offsetStep * offsetStep);
    };
    arv_camera_set_region(m_camera.get(), middle(sensorWidth, width), middle(sensorHeight, height), width,
                          height, failure.out());
    if (failure)
        return refused(wanted,
                       ODO_TEXT("capture.size_not_taken", "it rejects this size (%1)")(failure.words()),
                       failure);
    return {};
}

Result<void> AravisDevice::chooseFormat(const AravisAddress &wanted)
{
    ArvFailure failure;
    if (wanted.format) {
        arv_camera_set_pixel_format_from_string(m_camera.get(), wanted.format->c_str(), failure.out());
        if (failure)
            return refused(wanted,
                           ODO_TEXT("capture.no_such_format", "it has no format %1 (%2)")(*wanted.format,
                                                                                          failure.words()),
                           failure);
        return {};
    }
    unsigned count = 0;
    const ArvList<gint64> offered(
        arv_camera_dup_available_pixel_formats(m_camera.get(), &count, failure.out()));
    for (const GenicamFormat &format : usableGenicamFormats()) {
        if (std::find(offered.get(), offered.get() + count, gint64{format.code}) == offered.get() + count)
            continue;
        arv_camera_set_pixel_format(m_camera.get(), format.code, failure.out());
        if (!failure)
            return {};
    }
    return fail(ErrorCode::InvalidInput, cameraAtAddress(wanted.uri),
                ODO_TEXT("capture.no_usable_format", "it offers no supported pixel format"),
                ODO_TEXT("capture.take_camera_with_format",
                         "use a camera that offers one of %1")(namesOfUsableFormats()));
}

Result<void> AravisDevice::choosePace(const AravisAddress &wanted)
{
    ArvCamera *camera = m_camera.get();
    ArvFailure failure;
    arv_camera_set_acquisition_mode(camera, ARV_ACQUISITION_MODE_CONTINUOUS, failure.out());
    if (wanted.framesPerSecond) {
        arv_camera_set_frame_rate(camera, *wanted.framesPerSecond, failure.out());
        if (failure)
            return refused(wanted,
                           ODO_TEXT("capture.rate_not_taken", "it rejects this rate (%1)")(failure.words()),
                           failure);
    } else {
        arv_camera_clear_triggers(camera, failure.out());
    }
    if (wanted.exposure) {
        if (arv_camera_is_exposure_auto_available(camera, failure.out()))
            arv_camera_set_exposure_time_auto(camera, ARV_AUTO_OFF, failure.out());
        arv_camera_set_exposure_time(camera, toSeconds(*wanted.exposure) * 1e6, failure.out());
        if (failure)
            return refused(
                wanted,
                ODO_TEXT("capture.exposure_not_taken", "it rejects this exposure (%1)")(failure.words()),
                failure);
    }
    if (wanted.gain) {
        if (arv_camera_is_gain_auto_available(camera, failure.out()))
            arv_camera_set_gain_auto(camera, ARV_AUTO_OFF, failure.out());
        arv_camera_set_gain(camera, *wanted.gain, failure.out());
        if (failure)
            return refused(wanted,
                           ODO_TEXT("capture.gain_not_taken", "it rejects this gain (%1)")(failure.words()),
                           failure);
    }
    if (wanted.trigger == AravisAddress::Trigger::Software) {
        arv_camera_set_trigger(camera, "Software", failure.out());
        if (failure)
            return refused(
                wanted,
                ODO_TEXT("capture.no_software_trigger", "it has no software trigger (%1)")(failure.words()),
                failure);
    }
    return {};
}

Result<void> AravisDevice::setUpTransport(const AravisAddress &wanted)
{
    ArvCamera *camera = m_camera.get();
    if (!m_location.onNetwork) {
        arv_camera_uv_set_usb_mode(camera, ARV_UV_USB_MODE_ASYNC);
        return {};
    }
    ArvFailure failure;
    if (wanted.packetSize)
        arv_camera_gv_set_packet_size(camera, *wanted.packetSize, failure.out());
    else if (has(camera, "GevSCPSFireTestPacket"))
        arv_camera_gv_auto_packet_size(camera, failure.out());
    if (failure && wanted.packetSize)
        return refused(
            wanted,
            ODO_TEXT("capture.packet_size_not_taken", "it rejects this packet size (%1)")(failure.words()),
            failure);
    if (wanted.packetDelay)
        arv_camera_gv_set_packet_delay(camera, wanted.packetDelay->count(), failure.out());
    if (failure && wanted.packetDelay)
        return refused(
            wanted,
            ODO_TEXT("capture.packet_delay_not_taken", "it rejects this packet delay (%1)")(failure.words()),
            failure);
    arv_camera_gv_set_packet_size_adjustment(camera, ARV_GV_PACKET_SIZE_ADJUSTMENT_NEVER);
    // Packet sockets, which root would get, hold packets back for 5 ms and lose some at the start.
    arv_camera_gv_set_stream_options(camera, ARV_GV_STREAM_OPTION_PACKET_SOCKET_DISABLED);
    return {};
}

Result<void> AravisDevice::readBack(const AravisAddress &wanted)
{
    ArvCamera *camera = m_camera.get();
    ArvFailure failure;
    const auto format = usableGenicamFormat(arv_camera_get_pixel_format(camera, failure.out()));
    if (failure)
        return refused(
            wanted,
            ODO_TEXT("capture.format_not_told", "it does not report its pixel format (%1)")(failure.words()),
            failure);
    if (!format)
        return fail(ErrorCode::InvalidInput, cameraAtAddress(wanted.uri),
                    ODO_TEXT("capture.format_not_understood", "its pixel format is not supported"),
                    ODO_TEXT("capture.ask_for_usable_format", "choose one of %1")(namesOfUsableFormats()));
    m_mode.format = *format;
    int x = 0, y = 0;
    arv_camera_get_region(camera, &x, &y, &m_mode.widthPx, &m_mode.heightPx, failure.out());
    if (failure)
        return refused(wanted,
                       ODO_TEXT("capture.size_not_told",
                                "it does not report its width and height (%1)")(failure.words()),
                       failure);
    if (m_mode.widthPx < 2 || m_mode.heightPx < 2)
        return fail(ErrorCode::InvalidInput, cameraAtAddress(wanted.uri),
                    ODO_TEXT("capture.pictures_without_size", "its frames have no size"),
                    ODO_TEXT("capture.set_width_and_height", "set its width and height"));
    m_mode.payload = arv_camera_get_payload(camera, failure.out());
    if (failure)
        return refused(wanted,
                       ODO_TEXT("capture.payload_not_told",
                                "it does not report how many bytes a frame has (%1)")(failure.words()),
                       failure);
    m_mode.payload = std::max(m_mode.payload, m_mode.imageSize());
    m_mode.framesPerSecond = arv_camera_get_frame_rate(camera, failure.out());
    const bool untold = failure || !(m_mode.framesPerSecond > 0);
    if (untold || wanted.trigger == AravisAddress::Trigger::Software)
        m_mode.framesPerSecond = wanted.framesPerSecond.value_or(rateWhereUntold);
    readExposure();
    if (has(camera, "GevTimestampControlLatch") && has(camera, "GevTimestampValue")) {
        m_ticksPerSecond = arv_camera_get_integer(camera, "GevTimestampTickFrequency", failure.out());
        if (!failure && m_ticksPerSecond > 0)
            m_latch = Latch::Gige;
    } else if (has(camera, "TimestampLatch") && has(camera, "TimestampLatchValue")) {
        m_latch = Latch::Sfnc;
        m_ticksPerSecond = nanosecondsPerSecond;
    }
    return {};
}

void AravisDevice::readExposure()
{
    ArvFailure failure;
    const double microseconds = arv_camera_get_exposure_time(m_camera.get(), failure.out());
    m_mode.exposure = failure || !(microseconds > 0) ? Nanoseconds(0) : fromSeconds(microseconds * 1e-6);
}

std::optional<ClockReading> AravisDevice::readClockOnce()
{
    ArvFailure failure;
    ClockReading reading;
    reading.before = steadyNow();
    arv_camera_execute_command(m_camera.get(),
                               m_latch == Latch::Gige ? "GevTimestampControlLatch" : "TimestampLatch",
                               failure.out());
    reading.after = steadyNow();
    if (failure)
        return std::nullopt;
    const std::int64_t ticks = arv_camera_get_integer(
        m_camera.get(), m_latch == Latch::Gige ? "GevTimestampValue" : "TimestampLatchValue", failure.out());
    if (failure)
        return std::nullopt;
    reading.device = ticksToTime(ticks, m_ticksPerSecond);
    return reading;
}

std::optional<ClockReading> AravisDevice::readClock()
{
    std::optional<ClockReading> best;
    const auto roundTrip = [](const ClockReading &reading) { return reading.after - reading.before; };
    for (int i = 0;
         m_latch != Latch::None && i < mostReadings && !(best && roundTrip(*best) < shortRoundTrip); ++i) {
        const auto reading = readClockOnce();
        if (!reading)
            break;
        if (!best || roundTrip(*reading) < roundTrip(*best))
            best = reading;
    }
    return best;
}

bool AravisDevice::fireTrigger()
{
    ArvFailure failure;
    arv_camera_software_trigger(m_camera.get(), failure.out());
    return !failure;
}

} // namespace odo
