// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/noise_clip.h"

#include "core/video/video_reader.h"
#include "core/video/video_writer.h"

#include <random>

namespace odo::test {

Result<void> writeNoiseClip(const std::filesystem::path &file, double seconds)
{
    constexpr int framesPerSecond = 30;
    const FrameFormat format{160, 96, 1, 1, ChromaSiting::Center, YuvMatrix::Bt601, true};
    auto writer = VideoWriter::create(file, format, {.codec = VideoCodec::Mjpeg});
    if (!writer)
        return tl::unexpected(writer.error());
    std::mt19937 random(1);
    for (int i = 0; i < seconds * framesPerSecond; ++i) {
        const auto buffer = std::make_shared<FrameBuffer>(format);
        for (int y = 0; y < format.height; ++y)
            std::generate_n(buffer->yRow(y), format.width,
                            [&] { return static_cast<std::uint8_t>(random()); });
        if (auto written =
                (*writer)->write(FrameBuffer::toFrame(buffer, i, fromSeconds(i / double(framesPerSecond))));
            !written)
            return written;
    }
    return (*writer)->finish();
}

bool playsWholly(const std::filesystem::path &file, std::size_t frames)
{
    const auto reader = VideoReader::open(file);
    if (!reader || (*reader)->info().frameTimes.size() != frames)
        return false;
    for (std::size_t i = 0; i < frames; ++i) {
        const auto frame = (*reader)->next();
        if (!frame || !*frame)
            return false;
    }
    return (*reader)->frameAt(static_cast<std::int64_t>(frames / 2)).has_value();
}

} // namespace odo::test
