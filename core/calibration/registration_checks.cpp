// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/registration_checks.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/tag_detection.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/marker_detection.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double mostFitPx = 2;         // a bad registration must not make the alarm deaf
constexpr double movedFrom = 4;         // σ of the difference
constexpr std::size_t provesCamera = 3; // markers that lie still

MarkerShift shiftOf(const FloorView &view, const MarkerPixel &stored, const MarkerPixel &found,
                    double limitPx)
{
    MarkerShift shift{stored.label, stored.pixel, found.pixel, (found.pixel - stored.pixel).norm(), 0,
                      limitPx};
    const auto before = view.floorFromPixel(stored.pixel, 0), now = view.floorFromPixel(found.pixel, 0);
    if (before && now)
        shift.shiftM = (*now - *before).norm();
    return shift;
}

double median(const std::vector<MarkerShift> &markers, double MarkerShift::*value, bool movedOnly)
{
    std::vector<double> values;
    for (const MarkerShift &marker : markers) {
        if (!movedOnly || marker.isMoved())
            values.push_back(marker.*value);
    }
    return values.empty() ? 0 : upperMedian(values);
}

std::string amount(const MovedCheck &check)
{
    return formatNumber(check.shiftPx, check.shiftPx < 10 ? 1 : 0) +
           " px = " + formatNumber(toMillimetres(check.shiftM), check.shiftM < 0.01 ? 1 : 0) + " mm";
}

std::string wordsOf(const MovedCheck &check, const std::string &camera, const std::vector<std::string> &moved)
{
    std::string words;
    switch (check.verdict) {
    case MovedCheck::Verdict::Still:
        words = camera + " stands where it was registered: " + std::to_string(check.markers.size()) +
                " markers lie within " + amount(check) + " of their places.";
        break;
    case MovedCheck::Verdict::CameraMoved:
        words = camera + " has moved " + amount(check) + ": register it again before you record.";
        break;
    case MovedCheck::Verdict::MarkersMoved:
        words = std::string(moved.size() == 1 ? "Marker " : "Markers ") + listed(moved) +
                (moved.size() == 1 ? " has" : " have") + " moved " + amount(check) + ", " + camera +
                " has not: put " + (moved.size() == 1 ? "it" : "them") +
                " back, or measure again and register all cameras.";
        break;
    }
    if (!check.missing.empty())
        words += " Not found again: " + listed(check.missing) + ".";
    return words;
}

} // namespace

std::vector<MarkerPixel> findAgain(const Frame &frame, const MarkerLayout &layout,
                                   const std::vector<MarkerPixel> &stored, const CameraModel &camera)
{
    const auto tags = findTags(frame);
    std::vector<MarkerPixel> found;
    for (const MarkerPixel &marker : stored) {
        const auto place = std::ranges::find(layout.markers, marker.label, &Marker::label);
        const auto isIt = [&](const SeenTag &tag) { return tag.number == place - layout.markers.begin(); };
        if (place != layout.markers.end() && std::ranges::count_if(tags, isIt) == 1) {
            found.push_back({marker.label, std::ranges::find_if(tags, isIt)->pixel});
            continue;
        }
        const SnappedMarker snapped = snapToMarker(frame, marker.pixel);
        if (snapped.kind != SnappedMarker::Kind::None && snapped.kind != SnappedMarker::Kind::Tag)
            found.push_back({marker.label, snapped.pixel});
    }
    if (found.size() >= 2)
        return found;
    if (const auto anywhere = findMarkers(frame, layout, {camera, true, {}}))
        return *anywhere;
    return found;
}

Result<MovedCheck> checkMoved(const std::string &camera, const FloorView &view,
                              const std::vector<MarkerPixel> &stored, const std::vector<MarkerPixel> &found,
                              double fitPx)
{
    MovedCheck check;
    const double limitPx = movedFrom * std::sqrt(2.0) * std::clamp(fitPx, usualMarkSigmaPx, mostFitPx);
    std::vector<std::string> moved;
    for (const MarkerPixel &marker : stored) {
        const auto again = std::ranges::find(found, marker.label, &MarkerPixel::label);
        if (again == found.end()) {
            check.missing.push_back(marker.label);
            continue;
        }
        check.markers.push_back(shiftOf(view, marker, *again, limitPx));
        if (check.markers.back().isMoved())
            moved.push_back(marker.label);
    }
    if (check.markers.size() < 2)
        return fail(ErrorCode::Undetermined, "whether " + camera + " has moved cannot be told",
                    std::to_string(check.markers.size()) + " of its " + std::to_string(stored.size()) +
                        " markers were found again, two are needed",
                    "clear the view of the markers; if they are gone or the camera looks elsewhere, register "
                    "it again");
    if (!moved.empty())
        check.verdict = check.markers.size() - moved.size() >= provesCamera
                            ? MovedCheck::Verdict::MarkersMoved
                            : MovedCheck::Verdict::CameraMoved;
    check.shiftPx = median(check.markers, &MarkerShift::shiftPx, !moved.empty());
    check.shiftM = median(check.markers, &MarkerShift::shiftM, !moved.empty());
    check.words = wordsOf(check, camera, moved);
    return check;
}

namespace {

using Eigen::Vector2d;

constexpr const char *lengthMeasurement = "the length cannot be measured";
constexpr double agreesWithin = 2.5; // σ
constexpr double shortestPx = 2;

struct Measured
{
    double lengthM = 0, varianceM2 = 0;
};

Eigen::Matrix2d noiseOf(double sigmaPx)
{
    return sigmaPx * sigmaPx * Eigen::Matrix2d::Identity();
}

Result<Measured> measure(const SeenLength &seen, double heightM)
{
    if ((seen.fromPixel - seen.toPixel).norm() < shortestPx)
        return fail(ErrorCode::InvalidInput, lengthMeasurement,
                    "both ends lie on one pixel of camera '" + seen.camera + "'",
                    "mark the two ends where they are seen");
    const auto from = seen.view->locate(seen.fromPixel, noiseOf(seen.fromSigmaPx), heightM);
    const auto to = seen.view->locate(seen.toPixel, noiseOf(seen.toSigmaPx), heightM);
    if (!from || !to)
        return fail(ErrorCode::InvalidInput, lengthMeasurement,
                    std::string("the ") + (from ? "second" : "first") +
                        " end lies at or beyond the horizon of camera '" + seen.camera + "'",
                    "lay the stick on the floor, nearer to the camera");
    const Vector2d along = to->pointInWorld - from->pointInWorld;
    const double length = along.norm();
    const Vector2d unit = along / length;
    const Eigen::Matrix2d shared = seen.view->sharedCovariance(from->pointInWorld, to->pointInWorld, heightM)
                                       .value_or(Eigen::Matrix2d::Zero());
    const Eigen::Matrix2d covariance = from->pixelCovariance + to->pixelCovariance +
                                       from->calibrationCovariance + to->calibrationCovariance - shared -
                                       shared.transpose();
    return Measured{length, unit.dot(covariance * unit)};
}

std::string judgement(const LengthCheck &check, double toldM)
{
    const double difference = *check.differenceM;
    const std::string off = " It is " + millimetres(std::abs(difference)) +
                            (difference < 0 ? " shorter" : " longer") + " than the " + millimetres(toldM) +
                            " told: ";
    const double allowed = agreesWithin * check.sigmaM;
    if (std::abs(difference) <= allowed)
        return off + "inside the expected error of " + millimetres(allowed) + ".";
    return off + "outside the expected error of " + millimetres(allowed) +
           ". Check the length itself, whether it lies on the floor, and the places of the markers.";
}

} // namespace

Result<LengthCheck> checkLength(std::span<const SeenLength> seen, std::optional<double> toldM, double heightM)
{
    if (seen.empty())
        return fail(ErrorCode::InvalidInput, lengthMeasurement, "no camera was given that sees it",
                    "mark its ends in one picture at least");
    if (toldM && !(*toldM > 0 && std::isfinite(*toldM)))
        return fail(ErrorCode::InvalidInput, lengthMeasurement, "the told length is not above 0",
                    "give the length as it was measured with a tape");
    double information = 0, weighted = 0;
    std::vector<Measured> each;
    for (const SeenLength &one : seen) {
        const auto measured = measure(one, heightM);
        if (!measured)
            return tl::unexpected(measured.error());
        each.push_back(*measured);
        information += 1 / measured->varianceM2;
        weighted += measured->lengthM / measured->varianceM2;
    }
    LengthCheck check;
    check.lengthM = weighted / information;
    check.sigmaM = std::sqrt(1 / information);
    check.words = "The length is " + millimetres(check.lengthM) + " ± " + millimetres(check.sigmaM) + ".";
    for (std::size_t i = 0; i < each.size(); ++i) {
        const double off = each[i].lengthM - check.lengthM;
        if (each.size() > 1 && std::abs(off) > agreesWithin * std::sqrt(each[i].varianceM2)) {
            check.agrees = false;
            check.words +=
                " Camera '" + seen[i].camera + "' alone says " + millimetres(each[i].lengthM) +
                ": look whether the same ends are marked in each picture, and register it again if they are.";
        }
    }
    if (toldM) {
        check.differenceM = check.lengthM - *toldM;
        check.agrees = check.agrees && std::abs(*check.differenceM) <= agreesWithin * check.sigmaM;
        check.words += judgement(check, *toldM);
    }
    return check;
}

} // namespace odo
