// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/track_scale.h"

#include "core/exchange/table/internal/course.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr double fastRobot = 3, fastVehicle = 40; // m/s; the first where the unit is a guess
constexpr double wideFloorM = 20, slowRobot = 0.005, smallFloorM = 0.02, usualRobot = 0.5;
constexpr double clearlyLess = 3; // of two spreads
constexpr double leastOfOther = 0.1;

/// Orientations are about the file's Z axis.
void takeAxes(RawTrack &track, FloorAxes axes)
{
    if (axes == FloorAxes::Xy)
        return;
    if (axes == FloorAxes::Yz)
        track.x = track.y;
    track.y = track.z;
    if (axes == FloorAxes::Xz)
        track.columns.y = *track.columns.z;
    else
        track.columns.x = track.columns.y, track.columns.y = *track.columns.z;
    track.headings.clear();
    track.sigmas.clear();
}

double middleOf(const std::vector<double> &values)
{
    std::vector<double> known;
    std::ranges::copy_if(values, std::back_inserter(known),
                         [](double value) { return std::isfinite(value); });
    return percentileOf(std::move(known), 50);
}

/// "mm" behind a number, where the header says it.
std::string unitWord(const LengthColumn &column)
{
    return column.unit ? std::string(wordOf(*column.unit)) : std::string();
}

int decimalsFor(double value)
{
    return value < 1 ? 3 : value < 100 ? 2 : 0;
}

/// As a person, the header or the format says it.
std::optional<LengthUnit> saidUnit(const RawTrack &track, TrackFormat format, const TrackReading &reading)
{
    if (reading.unit)
        return reading.unit;
    if (reading.pixelM)
        return LengthUnit::Pixel;
    if (track.columns.x.unit)
        return track.columns.x.unit;
    if (format == TrackFormat::Euroc || format == TrackFormat::RosBag)
        return LengthUnit::Metre;
    if (format == TrackFormat::DeepLabCut || format == TrackFormat::Sleap)
        return LengthUnit::Pixel;
    return std::nullopt;
}

bool isPlausible(double speedMps, double floorM)
{
    return speedMps <= fastRobot && floorM <= wideFloorM;
}

/// The unit that gives the speed most like a robot's; none where another one does nearly as well.
std::optional<LengthUnit> likelyUnit(double speed, double floor)
{
    constexpr double clearly = 3; // times nearer
    std::optional<LengthUnit> likely;
    double least = std::numeric_limits<double>::max(), next = least;
    for (const LengthUnit unit : {LengthUnit::Centimetre, LengthUnit::Millimetre}) {
        const double speedMps = speed / perMetre(unit), floorM = floor / perMetre(unit);
        if (!isPlausible(speedMps, floorM) || speedMps < slowRobot || floorM < smallFloorM)
            continue;
        const double off = std::abs(std::log(speedMps / usualRobot));
        next = std::min(next, std::max(off, least));
        if (off < least) {
            least = off;
            likely = unit;
        }
    }
    return next - least > std::log(clearly) ? likely : std::nullopt;
}

/// Metres below a header that says millimetres: a course of a millimetre, as smooth as that of a robot.
Result<void> checkNotTiny(const RawTrack &track, TrackFormat format, double speed, double floor,
                          const Understanding &how)
{
    constexpr double tinyM = 0.01, leastSteps = 12; // a robot at rest gets no farther than a few of its steps
    const double saidM = floor / perMetre(*track.columns.x.unit);
    const bool isOfPerson = format == TrackFormat::Csv || format == TrackFormat::Tracker;
    if (!isOfPerson || saidM == floor || saidM > tinyM || floor < smallFloorM || speed < slowRobot ||
        !isPlausible(speed, floor) || floor < leastSteps * courseOf(track).usualStep)
        return {};
    return how.wrong(
        track.lines.front(),
        ODO_TEXT("exchange.too_small_as_said",
                 "in the unit that its header gives, its positions stay within %1")(
            quantity(toMillimetres(saidM), 1, "mm")),
        ODO_TEXT("exchange.choose_likely_unit", "choose their unit: m, cm, mm, in, ft or px; %1 is likely")(
            std::string(wordOf(LengthUnit::Metre))));
}

tl::unexpected<Error> pixelsAreNoLengths(TrackFormat format, const RawTrack &track, const Understanding &how)
{
    const bool isFormat = format == TrackFormat::DeepLabCut || format == TrackFormat::Sleap;
    return how.wrong(
        track.lines.empty() ? 0 : track.lines.front(),
        isFormat && !how.reading.unit
            ? ODO_TEXT("exchange.format_has_pixels", "%1 writes positions in pixels, which are no lengths")(
                  std::string(trackFormatName(format)))
            : ODO_TEXT("exchange.positions_are_pixels", "its positions are in pixels, which are no lengths"),
        ODO_TEXT("exchange.give_pixel_length",
                 "give how long a pixel is on the floor, or choose another unit of the positions"));
}

} // namespace

void makeOneUnit(RawTrack &track)
{
    const auto bring = [&](LengthColumn &column, std::vector<double> &values) {
        const auto unit = track.columns.x.unit;
        if (!unit || !column.unit || *column.unit == *unit || *column.unit == LengthUnit::Pixel ||
            *unit == LengthUnit::Pixel)
            return;
        for (double &value : values)
            value = value * perMetre(*unit) / perMetre(*column.unit);
        column.unit = unit;
    };
    bring(track.columns.y, track.y);
    if (track.columns.z)
        bring(*track.columns.z, track.z);
}

Result<void> chooseAxes(RawTrack &track, TrackFormat format, Understanding &how)
{
    const bool hasZ = std::ranges::any_of(track.z, [](double z) { return std::isfinite(z); });
    if (how.reading.axes && *how.reading.axes != FloorAxes::Xy) {
        if (!hasZ)
            return how.wrong(0, ODO_TEXT("exchange.no_third_axis", "it has no third coordinate"),
                             ODO_TEXT("exchange.choose_axes_xy", "choose the axes x and y"));
        how.facts.push_back(ODO_TEXT("exchange.axes_given",
                                     "floor axes: %1 of the file")(std::string(wordOf(*how.reading.axes))));
        takeAxes(track, *how.reading.axes);
        return {};
    }
    if (how.reading.axes || !hasZ || measuredRows(track).size() < enoughForCourse)
        return {};
    const double x = spreadOf(track.x), y = spreadOf(track.y), z = spreadOf(track.z);
    const bool isYUp = z > clearlyLess * y && z > leastOfOther * x && y <= x;
    const bool isXUp = z > clearlyLess * x && z > leastOfOther * y && x < y;
    if (!isYUp && !isXUp)
        return {};
    const FloorAxes likely = isYUp ? FloorAxes::Xz : FloorAxes::Yz;
    const std::string up = isYUp ? "y" : "x", unit = unitWord(track.columns.x);
    const MessageArgument stays =
        quantity(middleOf(isYUp ? track.y : track.x), decimalsFor(isYUp ? x : y), unit);
    if (format == TrackFormat::Trc || format == TrackFormat::Kitti) {
        how.facts.push_back(
            ODO_TEXT("exchange.axes_seen", "floor axes: %1 of the file, as its %2 stays near %3")(
                std::string(wordOf(likely)), up, stays));
        takeAxes(track, likely);
        return {};
    }
    return how.wrong(
        0,
        ODO_TEXT("exchange.axes_unclear", "its z varies by %1 while its %2 stays near %3")(
            quantity(z, decimalsFor(z), unit), up, stays),
        ODO_TEXT("exchange.choose_axes",
                 "choose the axes of the floor: %1, or xy if that is right")(std::string(wordOf(likely))));
}

Result<double> unitsPerMetre(const RawTrack &track, TrackFormat format, const std::vector<Nanoseconds> &times,
                             Understanding &how)
{
    const auto said = saidUnit(track, format, how.reading);
    if (said == LengthUnit::Pixel) {
        if (!how.reading.pixelM)
            return pixelsAreNoLengths(format, track, how);
        how.facts.push_back(ODO_TEXT("exchange.pixel_is",
                                     "a pixel is %1")(quantity(toMillimetres(*how.reading.pixelM), 3, "mm")));
        return 1 / *how.reading.pixelM;
    }
    if (how.reading.unit)
        return perMetre(*said);
    const double perSaid = said ? perMetre(*said) : 1;
    if (measuredRows(track).size() < enoughForCourse)
        return perSaid;
    const double speed = typicalSpeed(track, times), floor = std::max(spreadOf(track.x), spreadOf(track.y));
    if (track.columns.x.unit && speed / perSaid > fastVehicle)
        return how.wrong(
            track.lines.front(),
            ODO_TEXT("exchange.too_fast_as_said", "in the units that it gives, the robot would drive at %1")(
                quantity(speed / perSaid, 0, "m/s")),
            ODO_TEXT("exchange.check_both_units", "choose the units of its times and positions"));
    if (track.columns.x.unit) {
        ODO_TRY(checkNotTiny(track, format, speed, floor, how));
        return perSaid;
    }
    const bool isOfFormat = said || format == TrackFormat::Tum || format == TrackFormat::Kitti;
    if (isOfFormat && speed <= fastVehicle)
        return 1.0;
    if (!isOfFormat && isPlausible(speed, floor)) {
        how.facts.push_back(
            ODO_TEXT("exchange.positions_as_metres", "its positions have no unit and were read as metres"));
        return 1.0;
    }
    const auto likely = likelyUnit(speed, floor);
    return how.wrong(track.lines.front(),
                     speed > fastRobot
                         ? ODO_TEXT("exchange.too_fast_in_metres",
                                    "its positions have no unit, and in metres the robot would drive at %1")(
                               quantity(speed, 0, "m/s"))
                         : ODO_TEXT("exchange.too_wide_in_metres",
                                    "its positions have no unit, and in metres the floor would be %1 wide")(
                               quantity(floor, 0, "m")),
                     likely ? ODO_TEXT("exchange.choose_likely_unit",
                                       "choose their unit: m, cm, mm, in, ft or px; %1 is likely")(
                                  std::string(wordOf(*likely)))
                            : ODO_TEXT("exchange.choose_unit", "choose their unit: m, cm, mm, in, ft or px"));
}

} // namespace odo
