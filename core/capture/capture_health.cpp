// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_health.h"

#include "core/base/file_system.h"
#include "core/capture/camera_source.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double speedMS = 2; // a fast robot in a classroom

} // namespace

Error machineSleptError(Nanoseconds howLong)
{
    const double seconds = toSeconds(howLong);
    const MessageArgument length = seconds < 120    ? quantity(seconds, 0, "s")
                                   : seconds < 7200 ? quantity(seconds / 60, 0, "min")
                                                    : quantity(seconds / 3600, 0, "h");
    return {ErrorCode::Unavailable, ODO_TEXT("capture.this_computer", "this computer"),
            ODO_TEXT("capture.machine_slept", "it slept for %1 and recorded nothing meanwhile")(length),
            joined({ODO_TEXT("capture.kept_before_sleep", "the recording up to then is kept"),
                    ODO_TEXT("capture.keep_awake", "keep it awake while it records")},
                   Join::Semicolon)};
}

Error slowCameraError(const std::string &uri, double framesPerSecond, double asked)
{
    return {
        ErrorCode::Unavailable, cameraAtAddress(uri),
        ODO_TEXT("capture.slow_camera", "it delivers only %1 frames per second instead of the requested %2")(
            quantity(framesPerSecond, 0), quantity(asked, 0)),
        ODO_TEXT("capture.slow_camera_advice",
                 "give it more light or a shorter exposure, or ask for a lower rate")};
}

Message healthWords(const ViewHealth &view)
{
    if (view.warning)
        return wholeMessage(view.warning->error);
    if (view.state == ViewHealth::State::Starting)
        return ODO_TEXT("capture.waiting_for_first_picture", "waiting for the first frame");
    MessageArgument rate = quantity(view.framesPerSecond, 1, "frames/s");
    if (view.slow)
        rate = ODO_TEXT("capture.rate_too_slow", "%1 (too slow)")(rate);
    const std::uint64_t lost = view.lostOnWire + view.lostByUs;
    if (lost == 0)
        return ODO_TEXT("capture.none_lost", "%1, none lost")(rate);
    if (!view.hasWire)
        return ODO_TEXT("capture.lost_by_slow_machine", "%1, %2 lost because this machine is too slow")(rate,
                                                                                                        lost);
    if (view.lostOnWire > 0 && view.lostByUs > 0)
        return ODO_TEXT("capture.lost_on_wire_and_here",
                        "%1, %2 lost (%3 on the wire, %4 here)")(rate, lost, view.lostOnWire, view.lostByUs);
    return view.lostOnWire > 0 ? ODO_TEXT("capture.lost_on_wire", "%1, %2 lost on the wire")(rate, lost)
                               : ODO_TEXT("capture.lost_here", "%1, %2 lost here")(rate, lost);
}

bool comesByWire(const std::string &kind)
{
    return kind != "simulated" && kind != "file";
}

Message synchronisationWords(double p95S)
{
    return joined({ODO_TEXT("capture.in_step", "synchronised to %1")(quantity(1000 * p95S, 1, "ms")),
                   ODO_TEXT("capture.in_step_as_way", "at %1 that is %2")(
                       quantity(speedMS, 0, "m/s"), quantity(1000 * speedMS * p95S, 1, "mm"))},
                  Join::Semicolon);
}

Message remainingTimeText(const DiskHealth &disk)
{
    if (!disk.secondsLeft)
        return {};
    const double seconds = *disk.secondsLeft;
    return ODO_TEXT("capture.room_for", "remaining recording time %1")(
        seconds < 120        ? quantity(std::floor(seconds), 0, "s")
        : seconds < 3 * 3600 ? quantity(std::floor(seconds / 60), 0, "min")
                             : quantity(std::floor(seconds / 3600), 0, "h"));
}

std::optional<DiskCapacity> diskCapacityOf(const std::filesystem::path &folder)
{
    std::error_code problem;
    const files::DiskSpace space = files::diskSpace(folder, problem);
    if (problem)
        return std::nullopt;
    return DiskCapacity{space.freeBytes, space.bytes};
}

std::uint64_t DiskWatch::reserved(const DiskCapacity &disk) const
{
    return std::min(mostReserved, disk.size / 20);
}

std::uint64_t DiskWatch::left(const DiskCapacity &disk) const
{
    return disk.free - std::min(disk.free, reserved(disk));
}

} // namespace odo
