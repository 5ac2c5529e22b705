// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/internal/clip_frames.h"

#include "core/video/video_reader.h"

#include <algorithm>
#include <optional>

namespace odo {

namespace {

constexpr Nanoseconds shortestPart = std::chrono::milliseconds(250);
constexpr int mostParts = 240;

} // namespace

double edgeStrength(const Frame &frame)
{
    std::uint64_t sum = 0;
    std::uint64_t count = 0;
    for (int y = 0; y + 1 < frame.y.height; y += 2) {
        const std::uint8_t *row = frame.y.row(y), *below = frame.y.row(y + 1);
        std::uint32_t ofRow = 0; // at most 32,000 · 2 · 255², below 2³²
        for (int x = 0; x + 1 < frame.y.width; ++x) {
            const int across = row[x + 1] - row[x], down = below[x] - row[x];
            ofRow += static_cast<std::uint32_t>(across * across + down * down);
        }
        sum += ofRow;
        count += static_cast<std::uint64_t>(std::max(frame.y.width - 1, 0));
    }
    return count > 0 ? static_cast<double>(sum) / static_cast<double>(count) : 0;
}

Result<void> visitSharpestFrames(const std::filesystem::path &file,
                                 const std::function<bool(const Frame &, const std::string &)> &visit,
                                 const CancelToken &cancel)
{
    auto reader = ODO_TRY(VideoReader::open(file, cancel));
    const Nanoseconds part = std::max(shortestPart, reader->info().duration / mostParts);
    const std::string name = file.filename().string();
    std::optional<Frame> sharpest;
    double most = 0;
    Nanoseconds::rep current = 0;
    const auto give = [&] {
        const bool goesOn = !sharpest || visit(*sharpest, name + "@" + std::to_string(sharpest->index));
        sharpest.reset();
        return goesOn;
    };
    for (;;) {
        const auto next = ODO_TRY(reader->next());
        if (!next) {
            give();
            return {};
        }
        const Nanoseconds::rep its = next->time / part;
        if (its != current && !give())
            return {};
        current = its;
        const double strength = edgeStrength(*next);
        if (!sharpest || strength > most) {
            sharpest = *next;
            most = strength;
        }
    }
}

} // namespace odo
