// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/track_file.h"
#include "tests/fuzz/fuzz_file.h"

#include <cmath>
#include <optional>

namespace {

void require(bool isSo, const char *what)
{
    if (isSo)
        return;
    std::fprintf(stderr, "a track was read, but %s\n", what);
    std::abort();
}

} // namespace

/// A finished track: a table, TUM or Tracker's text. What is read must be what trajectories are made of.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".csv");
    const auto &held = file.holding(bytes, count);
    TrackReading told; // what a person can say makes other ways through the reader
    if (count > 0) {
        const unsigned choice = bytes[count - 1];
        told.unit = (choice & 1) != 0 ? std::optional(LengthUnit::Millimetre) : std::nullopt;
        told.rate = (choice & 2) != 0 ? std::optional(30.0) : std::nullopt;
        told.axes = (choice & 4) != 0 ? std::optional(FloorAxes::Xz) : std::nullopt;
        told.decimal = (choice & 8) != 0 ? std::optional(DecimalSign::Comma) : std::nullopt;
        told.pixelM = (choice & 16) != 0 ? std::optional(0.002) : std::nullopt;
    }
    const auto read = readTrackFile(held, told, {});
    if (!read)
        return 0;
    require(!read->tracks.empty(), "there is none");
    for (const FileTrack &track : read->tracks) {
        for (std::size_t i = 0; i < track.positions.size(); ++i) {
            const ImportedPosition &one = track.positions[i];
            require(i == 0 || one.time > track.positions[i - 1].time, "its times do not increase");
            require(!one.position || one.position->allFinite(), "a place is no number");
        }
    }
    return 0;
}
