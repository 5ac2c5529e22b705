// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_health.h"

#include "core/base/file_system.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace odo {

namespace {

constexpr double speedMS = 2; // a fast robot in a classroom

template <class... Values>
std::string text(const char *format, Values... values)
{
    char words[128];
    std::snprintf(words, sizeof words, format, values...);
    return words;
}

} // namespace

Error machineSleptError(Nanoseconds howLong)
{
    const double seconds = toSeconds(howLong);
    const std::string length = seconds < 120    ? text("%.0f s", seconds)
                               : seconds < 7200 ? text("%.0f min", seconds / 60)
                                                : text("%.0f h", seconds / 3600);
    return {ErrorCode::Unavailable, "this computer",
            "it slept for " + length + ", and nothing was recorded meanwhile",
            "what came before is kept; keep it awake while it records"};
}

Error slowCameraError(const std::string &uri, double framesPerSecond, double asked)
{
    return {ErrorCode::Unavailable, "camera " + uri,
            text("it takes only %.0f pictures a second of the %.0f it was asked for", framesPerSecond, asked),
            "give it more light or a shorter exposure, or ask for a lower rate"};
}

std::string healthWords(const ViewHealth &view)
{
    if (view.trouble)
        return view.trouble->error.message();
    if (view.state == ViewHealth::State::Starting)
        return "waiting for the first picture";
    std::string words = text("%.1f frames/s", view.framesPerSecond);
    if (view.slow)
        words += " (too slow)";
    const std::uint64_t lost = view.lostOnWire + view.lostByUs;
    words += lost == 0 ? std::string(", none lost") : ", " + std::to_string(lost) + " lost";
    if (lost > 0 && !view.hasWire)
        words += " because this machine is too slow";
    else if (view.lostOnWire > 0 && view.lostByUs > 0)
        words += " (" + std::to_string(view.lostOnWire) + " on the wire, " + std::to_string(view.lostByUs) +
                 " here)";
    else if (lost > 0)
        words += view.lostOnWire > 0 ? " on the wire" : " here";
    return words;
}

bool comesByWire(const std::string &kind)
{
    return kind != "simulated" && kind != "file";
}

std::string inStepWords(double p95S)
{
    return text("in step to %.1f ms; at %.0f m/s that is %.1f mm", 1000 * p95S, speedMS,
                1000 * speedMS * p95S);
}

std::string roomWords(const DiskHealth &disk)
{
    if (!disk.secondsLeft)
        return {};
    if (*disk.secondsLeft < 120)
        return text("room for %.0f s", std::floor(*disk.secondsLeft));
    if (*disk.secondsLeft < 3 * 3600)
        return text("room for %.0f min", std::floor(*disk.secondsLeft / 60));
    return text("room for %.0f h", std::floor(*disk.secondsLeft / 3600));
}

std::optional<DiskRoom> diskRoomOf(const std::filesystem::path &folder)
{
    std::error_code problem;
    const files::DiskSpace space = files::diskSpace(folder, problem);
    if (problem)
        return std::nullopt;
    return DiskRoom{space.freeBytes, space.bytes};
}

std::uint64_t DiskWatch::reserved(const DiskRoom &disk) const
{
    return std::min(mostReserved, disk.size / 20);
}

std::uint64_t DiskWatch::left(const DiskRoom &disk) const
{
    return disk.free - std::min(disk.free, reserved(disk));
}

} // namespace odo
