// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/view_background.h"

#include "core/video/frame_stream.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double wantedPerSecond = 10; // frames that are looked at
constexpr std::size_t learnedAhead = 4;

} // namespace

Result<std::optional<Background>> learnBackground(const RegisteredView &view, const CancelToken &cancel, const std::function<void()> &onPicture)
{
    auto stream = FrameStream::open(view.file, learnedAhead, cancel);
    if (!stream)
        return tl::unexpected(stream.error());
    const std::int64_t step = std::max<std::int64_t>(1, std::llround((*stream)->info().framesPerSecond / wantedPerSecond));
    BackgroundLearner learner;
    while (true) {
        if (cancel.isCancelled())
            return cancelled("tracking");
        auto frame = (*stream)->pop();
        if (!frame)
            return tl::unexpected(frame.error());
        if (!*frame)
            return learner.learned();
        if ((*frame)->index % step == 0)
            learner.add(**frame);
        onPicture();
    }
}

} // namespace odo
