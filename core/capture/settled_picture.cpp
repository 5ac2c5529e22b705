// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/settled_picture.h"

namespace odo {

namespace {

constexpr double settlingS = 0.5;
constexpr int mostRefusals = 6; // of half a second each: then the camera will not come

} // namespace

Result<Frame> settledPicture(CameraSource &camera, const JobControl &control)
{
    int refusals = 0;
    std::optional<Nanoseconds> first;
    for (;;) {
        auto captured = camera.next();
        if (control.isCancelled())
            return cancelled("the picture");
        if (!captured && (captured.error().code != ErrorCode::Unavailable || ++refusals == mostRefusals))
            return tl::unexpected(captured.error());
        if (!captured)
            continue;
        if (!first)
            first = captured->frame.time;
        if (toSeconds(captured->frame.time - *first) >= settlingS)
            return std::move(captured->frame);
    }
}

} // namespace odo
