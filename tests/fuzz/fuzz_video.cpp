// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image.h"
#include "core/video/sound_track.h"
#include "core/video/video_reader.h"
#include "tests/fuzz/fuzz_file.h"

namespace {

void show(const odo::Result<odo::Frame> &frame)
{
    if (frame)
        static_cast<void>(odo::toScreen(*frame, 16, 12));
}

} // namespace

/// An imported video: its sound, its header and packets, the first frames, a part of one, and the last one by
/// seeking. Pictures of a size that would only be slow are not decoded.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    constexpr int mostPixels = 1 << 18;
    static fuzz::File file(".mkv");
    const auto path = file.holding(bytes, count);
    static_cast<void>(readSound(path, {}));
    const auto reader = VideoReader::open(path);
    if (!reader)
        return 0;
    const VideoInfo info = (*reader)->info();
    if (info.format.width > mostPixels / info.format.height)
        return 0;
    for (int i = 0; i < 3; ++i) {
        auto frame = (*reader)->next();
        if (frame && !*frame)
            break;
        if (frame)
            show(std::move(**frame));
    }
    if ((*reader)->decodesRegions())
        static_cast<void>((*reader)->next(PixelRect{0, 0, 8, 8}));
    show((*reader)->frameAt(static_cast<std::int64_t>(info.frameTimes.size()) - 1));
    show((*reader)->frameAt(0));
    return 0;
}
