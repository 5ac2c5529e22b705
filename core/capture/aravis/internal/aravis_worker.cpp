// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/aravis_worker.h"

#include "core/base/steady_now.h"
#include "core/capture/aravis/internal/aravis_controls.h"
#include "core/capture/aravis/internal/gvcp.h"
#include "core/capture/camera_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds popPatience = 20ms, retryEvery = 250ms, readClockEvery = 500ms;
constexpr int firstReadings = 4; // with the first frames, for the clock to be known at once
constexpr Nanoseconds shortestSilence = 200ms, longestStall = 3s;
constexpr double silentIntervals = 3;
constexpr auto runningPatience = 150ms;
constexpr int mostUnanswered = 2;

CameraDescription describe(const AravisAddress &address, const AravisDevice &device)
{
    const AravisMode &mode = device.mode();
    const AravisLocation &location = device.location();
    return {.uri = address.uri,
            .kind = "aravis",
            .name = foreignWords(location.vendor + " " + location.model),
            .widthPx = mode.widthPx,
            .heightPx = mode.heightPx,
            .framesPerSecond = mode.framesPerSecond,
            .serial = location.serial,
            .formats = {{formatWords(mode.format.name, mode.widthPx, mode.heightPx, mode.framesPerSecond),
                         mode.format.name, mode.widthPx, mode.heightPx}}};
}

/// With what can be done, in case it does not help itself.
Message takenUpByItself(Message advice)
{
    return joined(
        {std::move(advice), ODO_TEXT("capture.taken_up_by_itself", "Odograph reconnects automatically")},
        Join::Semicolon);
}

} // namespace

AravisWorker::AravisWorker(AravisAddress address, std::shared_ptr<AravisSession> session,
                           std::promise<Result<CameraDescription>> opened)
    : m_address(std::move(address)), m_session(std::move(session)), m_opened(std::move(opened))
{
}

void AravisWorker::remember(const std::string &id, double value)
{
    std::erase_if(m_settings, [&](const auto &one) { return one.first == id; });
    m_settings.emplace_back(id, value);
}

void AravisWorker::report(Message why, Message advice)
{
    m_session->setProblem(
        {ErrorCode::Unavailable, cameraAtAddress(m_address.uri), std::move(why), std::move(advice)});
}

void AravisWorker::run()
{
    auto device = takeUp();
    m_opened.set_value(device.map([&](const auto &opened) { return describe(m_address, *opened); }));
    const bool opened = device.has_value();
    while (opened && !m_session->isStopped()) {
        if (device) {
            takeFrames(**device);
            device->reset(); // of one that is gone: takes Aravis seconds
            m_times.interrupt();
            m_resumed = true;
        } else {
            m_session->setProblem(device.error());
            m_session->waitWithoutCamera(retryEvery);
        }
        if (!m_session->isStopped())
            device = takeUp();
        if (device && *device)
            ++m_counts.reconnections;
    }
    device = Opened(nullptr);
    m_session->end();
}

/// Where it is now. Errors: Unavailable also while another camera is in its place.
Result<AravisLocation> AravisWorker::findAgain()
{
    auto found = AravisDevice::find(m_address);
    if (found && m_location && found->serial != m_location->serial)
        return fail(ErrorCode::Unavailable, cameraAtAddress(m_address.uri),
                    ODO_TEXT("capture.other_serial_in_place",
                             "another camera (%1) has replaced camera %2")(found->serial, m_location->serial),
                    ODO_TEXT("capture.connect_right_camera",
                             "reconnect the original camera, or start over with this one"));
    return found;
}

/// A camera that was without power has forgotten how it was set. What is there the first time is what it is
/// to be.
Result<void> AravisWorker::setAsBefore(AravisDevice &device)
{
    const AravisMode &mode = device.mode();
    if (!m_location) {
        m_mode = mode;
        for (const CameraControl &control : readAravisControls(device.camera())) {
            if (!control.readOnly)
                remember(control.id, control.value);
        }
        return {};
    }
    if (mode.widthPx != m_mode.widthPx || mode.heightPx != m_mode.heightPx ||
        mode.format.code != m_mode.format.code)
        return fail(ErrorCode::Unavailable, cameraAtAddress(m_address.uri),
                    ODO_TEXT("capture.came_back_changed", "it came back with another frame size or format"),
                    ODO_TEXT("capture.set_as_before",
                             "restore its settings, or start over with size and format in its address"));
    for (const auto &[id, value] : m_settings)
        setAravisControl(device.camera(), m_address.uri, id, value);
    device.readExposure();
    if (m_holdWhenBack)
        holdAutomatics(&device);
    return {};
}

Result<void> AravisWorker::set(AravisDevice &device, const std::string &id, double value)
{
    auto done = setAravisControl(device.camera(), m_address.uri, id, value);
    if (done)
        remember(id, value);
    device.readExposure();
    return done;
}

std::vector<Message> AravisWorker::holdAutomatics(AravisDevice *device)
{
    m_holdWhenBack = !device;
    if (!device)
        return {exposureAndGain()};
    HeldAutomatics held = holdAravisAutomatics(device->camera());
    for (const auto &[id, value] : held.settings)
        remember(id, value);
    m_automatics.insert(m_automatics.end(), held.automatics.begin(), held.automatics.end());
    device->readExposure();
    return held.notHeld;
}

void AravisWorker::releaseAutomatics(AravisDevice *device)
{
    m_holdWhenBack = false;
    for (const auto &[id, value] : std::exchange(m_automatics, {})) {
        remember(id, value);
        if (device)
            setAravisControl(device->camera(), m_address.uri, id, value);
    }
    if (device)
        device->readExposure();
}

AravisWorker::Opened AravisWorker::takeUp()
{
    // A camera that was found by its serial number is most likely where it was; a search takes two
    // seconds.
    const bool where = m_location && m_location->onNetwork && !isIpAddress(m_address.location);
    const auto there = where ? askGvcpCamera(m_location->openId, runningPatience) : std::nullopt;
    auto location = ODO_TRY(there && there->serial == m_location->serial ? Result<AravisLocation>(*m_location)
                                                                         : findAgain());
    auto device = ODO_TRY(AravisDevice::open(location, m_address));
    ODO_TRY(setAsBefore(*device));
    m_location = location;
    m_reading.reset();
    m_readings = 0;
    return device;
}

void AravisWorker::takeFrames(AravisDevice &device)
{
    auto stream = AravisStream::start(device, m_address);
    if (!stream)
        return m_session->setProblem(stream.error());
    m_before = m_counts;
    m_lastFrame = steadyNow();
    m_unanswered = 0;
    m_damagedBefore = m_unbuffered = 0;
    while (!m_session->isStopped()) {
        m_session->runTasks(&device);
        const Nanoseconds patience = std::min(popPatience, fireIfDue(device));
        if (auto received = (*stream)->next(patience))
            deliver(device, **stream, std::move(*received));
        else if (!stillStreams(device, **stream))
            return;
        updateCounts(**stream);
    }
}

void AravisWorker::updateCounts(const AravisStream &stream)
{
    m_counts.damaged = m_before.damaged + stream.damaged();
    m_counts.resent = m_before.resent + stream.resent();
    m_session->count(m_counts);
}

/// How long until the next one. All cameras that are fired by the same rate keep to the same grid of the
/// steady clock, so that they see the same moments without knowing of one another.
Nanoseconds AravisWorker::fireIfDue(AravisDevice &device)
{
    if (m_address.trigger != AravisAddress::Trigger::Software)
        return Nanoseconds::max();
    const Nanoseconds interval = fromSeconds(1 / device.mode().framesPerSecond), now = steadyNow();
    if (now >= m_nextFire) {
        // A camera that is gone would hold us up: one that is silent is asked before.
        const bool silent = now - m_lastFrame > shortestSilence + interval;
        if (m_nextFire != 0ns && (!silent || !device.location().onNetwork ||
                                  askGvcpCamera(device.location().openId, runningPatience)))
            device.fireTrigger();
        m_nextFire = (steadyNow() / interval + 1) * interval;
    }
    return std::max(m_nextFire - steadyNow(), Nanoseconds(0));
}

/// Asks before it touches a camera that may be gone: that would take Aravis seconds.
void AravisWorker::readClockIfDue(AravisDevice &device)
{
    const Nanoseconds now = steadyNow();
    if (m_readings >= firstReadings && now < m_nextReading)
        return;
    m_nextReading = now + readClockEvery;
    ++m_readings;
    if (device.location().onNetwork && !askGvcpCamera(device.location().openId, runningPatience))
        return;
    if (const auto reading = device.readClock()) {
        m_reading = reading;
        m_readingIsNew = true;
    }
}

void AravisWorker::deliver(AravisDevice &device, AravisStream &stream, AravisFrame received)
{
    // The stamp is of the start of the exposure (SFNC), the frame's time of its middle.
    const Nanoseconds middle = received.stamp + device.mode().exposure / 2;
    if (!m_times.goesOn(middle, received.arrival))
        m_nextReading = Nanoseconds(0);
    readClockIfDue(device);
    CapturedFrame captured;
    captured.hostTime = received.arrival;
    captured.frame = std::move(received.frame);
    captured.frame.time = m_times.location(middle, received.arrival, m_reading);
    if (std::exchange(m_resumed, false) && m_lastTime) {
        const double missed =
            toSeconds(captured.frame.time - *m_lastTime) * device.mode().framesPerSecond - 1;
        m_numbering.interrupt(static_cast<std::uint64_t>(std::max(0.0, std::round(missed))));
    }
    captured.sequence = m_numbering.number(received.id);
    captured.lostHere = m_lastTime ? lostHere(stream, captured.sequence) : 0;
    m_lastTime = captured.frame.time;
    m_lastSequence = captured.sequence;
    captured.frame.index = static_cast<std::int64_t>(captured.sequence);
    if (std::exchange(m_readingIsNew, false))
        captured.clock =
            ClockReading{m_times.onScale(m_reading->device), m_reading->before, m_reading->after};
    m_lastFrame = steadyNow();
    m_unanswered = 0;
    m_damagedBefore = stream.damaged();
    m_session->deliver(std::move(captured));
}

/// The part of the gap before a frame that this thread lost because it was waiting for an answer of the
/// camera. The buffers that were full by then come first, without a gap.
std::uint64_t AravisWorker::lostHere(const AravisStream &stream, std::uint64_t sequence)
{
    const std::uint64_t gap = sequence - m_lastSequence - 1;
    if (gap == 0)
        return 0;
    const std::uint64_t before = std::exchange(m_unbuffered, stream.unbuffered());
    return std::min(gap, m_unbuffered - before);
}

/// Whether to keep waiting for frames when none came for a moment. Reports the problem.
bool AravisWorker::stillStreams(AravisDevice &device, AravisStream &stream)
{
    const AravisMode &mode = device.mode();
    const Nanoseconds silence = steadyNow() - m_lastFrame;
    const Nanoseconds usual = fromSeconds(silentIntervals / mode.framesPerSecond) + mode.exposure;
    if (silence < std::max(shortestSilence, usual))
        return true;
    if (!device.location().onNetwork) {
        report(ODO_TEXT("capture.sends_no_pictures", "it sends no frames"),
               takenUpByItself(ODO_TEXT("capture.check_cable", "check its cable")));
        if (silence < longestStall + usual)
            return true;
        stream.abandon();
        return false;
    }
    const auto controlled = isGvcpControlled(device.location().openId, runningPatience);
    if (!controlled) {
        report(doesNotAnswer(), takenUpByItself(checkPowerAndCable()));
        if (++m_unanswered < mostUnanswered)
            return true;
        stream.abandon();
        return false;
    }
    m_unanswered = 0;
    if (!*controlled || device.isLost()) {
        report(ODO_TEXT("capture.has_been_away", "the connection was lost"),
               ODO_TEXT("capture.wait_for_it", "wait: Odograph is reconnecting"));
        return false;
    }
    if (stream.damaged() > m_damagedBefore)
        report(ODO_TEXT("capture.pictures_incomplete", "its frames arrive incomplete"),
               stream.warning().isEmpty()
                   ? joined({ODO_TEXT("capture.check_cable_and_network", "check its cable and the network"),
                             ODO_TEXT("capture.ask_for_less", "choose a smaller size or a lower rate")},
                            Join::Semicolon)
                   : stream.warning());
    else
        report(
            ODO_TEXT("capture.answers_but_silent", "it answers but sends no frames"),
            ODO_TEXT("capture.answers_but_silent_advice", "check its trigger and this computer's firewall"));
    return silence < longestStall + usual;
}

} // namespace odo
