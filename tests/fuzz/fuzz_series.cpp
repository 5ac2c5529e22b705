// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/series_blobs.h"

#include <cstdlib>

namespace {

using namespace odo;

/// Reads a series and, where it is one, packs it again: into as many bytes, or fewer where columns hold
/// nothing, that are read and packed as they are.
template <class Value, class Unpack, class Pack>
void roundTrip(const QByteArray &bytes, Unpack unpack, Pack pack)
{
    std::vector<Value> values, again;
    if (!unpack(bytes, Message(), values))
        return;
    const QByteArray packed = pack(values);
    if (packed.size() > bytes.size() || !unpack(packed, Message(), again) || pack(again) != packed)
        std::abort();
}

} // namespace

/// The packed columns of a project: as the kind that their first byte says, and as all others.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(count));
    roundTrip<Nanoseconds>(bytes, unpackTimes, packTimes);
    roundTrip<RawTime>(bytes, unpackRawTimes, packRawTimes);
    roundTrip<ClockReading>(bytes, unpackClockReadings, packClockReadings);
    roundTrip<Observation>(bytes, unpackObservations, packObservations);
    roundTrip<Sample>(bytes, unpackSamples, packSamples);
    roundTrip<ProfilePoint>(bytes, unpackPoints, packPoints);
    TruthSeries truth;
    static_cast<void>(unpackTruth(bytes, Message(), truth));
    CalibrationImage image;
    static_cast<void>(unpackCorners(bytes, Message(), image));
    static_cast<void>(unpackNumbers(bytes, Message()));
    static_cast<void>(unpackSquare(bytes, Message()));
    return 0;
}
