// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/series_blobs.h"

#include <cstdlib>

namespace {

using namespace odo;

/// Reads a series and, where it is one, packs it again, which must give the bytes it was read from where
/// `isExact`.
template <class Value, class Unpack, class Pack>
void roundTrip(const QByteArray &bytes, Unpack unpack, Pack pack, bool isExact)
{
    std::vector<Value> values;
    if (unpack(bytes, Message(), values) &&
        (pack(values).size() != bytes.size() || (isExact && pack(values) != bytes)))
        std::abort();
}

} // namespace

/// The packed columns of a project: as the kind that their first byte says, and as all others.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t count)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(count));
    roundTrip<Nanoseconds>(bytes, unpackTimes, packTimes, false);
    roundTrip<RawTime>(bytes, unpackRawTimes, packRawTimes, false);
    roundTrip<ClockReading>(bytes, unpackClockReadings, packClockReadings, false);
    roundTrip<Observation>(bytes, unpackObservations, packObservations, false);
    roundTrip<Sample>(bytes, unpackSamples, packSamples, false);
    roundTrip<ProfilePoint>(bytes, unpackPoints, packPoints, false);
    TruthSeries truth;
    static_cast<void>(unpackTruth(bytes, Message(), truth));
    CalibrationImage image;
    static_cast<void>(unpackCorners(bytes, Message(), image));
    static_cast<void>(unpackNumbers(bytes, Message()));
    static_cast<void>(unpackSquare(bytes, Message()));
    return 0;
}
