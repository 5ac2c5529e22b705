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

Message wordsOf(const CameraPositionCheck &check, const std::string &name,
                const std::vector<std::string> &moved)
{
    const MessageArgument camera = Named::camera(name),
                          inImage = quantity(check.shiftPx, check.shiftPx < 10 ? 1 : 0, "px"),
                          onFloor = quantity(toMillimetres(check.shiftM), check.shiftM < 0.01 ? 1 : 0, "mm");
    Message words;
    switch (check.verdict) {
    case CameraPositionCheck::Verdict::Still:
        words = joined(
            {ODO_TEXT("calibration.camera_still", "%1 has not moved")(camera),
             ODO_TEXT("calibration.markers_in_place", "%1 markers are within %2 = %3 of their positions.")(
                 check.markers.size(), inImage, onFloor)},
            Join::Colon);
        break;
    case CameraPositionCheck::Verdict::CameraMoved:
        words = joined(
            {ODO_TEXT("calibration.camera_moved", "%1 has moved %2 = %3")(camera, inImage, onFloor),
             ODO_TEXT("calibration.register_before_recording", "register it again before you record.")},
            Join::Colon);
        break;
    case CameraPositionCheck::Verdict::MarkersMoved:
        words =
            moved.size() == 1
                ? joined({ODO_TEXT("calibration.marker_moved", "Marker %1 has moved %2 = %3, %4 has not")(
                              Named::marker(moved.front()), inImage, onFloor, camera),
                          ODO_TEXT("calibration.put_marker_back",
                                   "move it back, or measure the markers again and register all cameras.")},
                         Join::Colon)
                : joined({ODO_TEXT("calibration.markers_moved", "Markers %1 have moved %2 = %3, %4 has not")(
                              listed(moved, MessageArgument::Kind::Marker), inImage, onFloor, camera),
                          ODO_TEXT("calibration.put_markers_back",
                                   "move them back, or measure the markers again and register all cameras.")},
                         Join::Colon);
        break;
    }
    if (check.missing.empty())
        return words;
    return joined({std::move(words), ODO_TEXT("calibration.not_found_again", "Not found again: %1.")(
                                         listed(check.missing, MessageArgument::Kind::Marker))},
                  Join::Space);
}

} // namespace

std::vector<MarkerPixel> findAgain(const Frame &frame, const MarkerLayout &layout,
                                   const std::vector<MarkerPixel> &stored, const CameraModel &camera)
{
    const auto tags = findTags(frame);
    std::vector<MarkerPixel> found;
    for (const MarkerPixel &marker : stored) {
        const auto position = std::ranges::find(layout.markers, marker.label, &Marker::label);
        const auto isIt = [&](const SeenTag &tag) { return tag.number == position - layout.markers.begin(); };
        if (position != layout.markers.end() && std::ranges::count_if(tags, isIt) == 1) {
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

Message cameraMovement(MessageArgument camera)
{
    return ODO_TEXT("calibration.whether_moved", "cannot determine whether %1 has moved")(std::move(camera));
}

Result<CameraPositionCheck> checkCameraPosition(const std::string &camera, const FloorView &view,
                                                const std::vector<MarkerPixel> &stored,
                                                const std::vector<MarkerPixel> &found, double fitPx)
{
    CameraPositionCheck check;
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
        return fail(ErrorCode::Undetermined, cameraMovement(Named::camera(camera)),
                    ODO_TEXT("calibration.too_few_found_again",
                             "%1 of its %2 markers were found again, two are needed")(check.markers.size(),
                                                                                      stored.size()),
                    joined({ODO_TEXT("calibration.clear_view", "clear the view of the markers"),
                            ODO_TEXT("calibration.register_if_gone",
                                     "if they are gone or the camera points elsewhere, register it again")},
                           Join::Semicolon));
    if (!moved.empty())
        check.verdict = check.markers.size() - moved.size() >= provesCamera
                            ? CameraPositionCheck::Verdict::MarkersMoved
                            : CameraPositionCheck::Verdict::CameraMoved;
    check.shiftPx = median(check.markers, &MarkerShift::shiftPx, !moved.empty());
    check.shiftM = median(check.markers, &MarkerShift::shiftM, !moved.empty());
    check.words = wordsOf(check, camera, moved);
    return check;
}

namespace {

using Eigen::Vector2d;

constexpr double agreesWithin = 2.5; // σ
constexpr double shortestPx = 2;

struct Measured
{
    double lengthM = 0, varianceM2 = 0;
};

tl::unexpected<Error> refuseLength(Message why, Message advice)
{
    return fail(ErrorCode::InvalidInput,
                ODO_TEXT("calibration.length_unmeasured", "the length cannot be measured"), std::move(why),
                std::move(advice));
}

Eigen::Matrix2d noiseOf(double sigmaPx)
{
    return sigmaPx * sigmaPx * Eigen::Matrix2d::Identity();
}

Result<Measured> measure(const SeenLength &seen, double heightM)
{
    if ((seen.fromPixel - seen.toPixel).norm() < shortestPx)
        return refuseLength(
            ODO_TEXT("calibration.ends_on_one_pixel",
                     "both ends are on the same pixel of camera '%1'")(Named::camera(seen.camera)),
            ODO_TEXT("calibration.mark_two_ends", "mark each end at its own position in the image"));
    const auto from = seen.view->locate(seen.fromPixel, noiseOf(seen.fromSigmaPx), heightM);
    const auto to = seen.view->locate(seen.toPixel, noiseOf(seen.toSigmaPx), heightM);
    if (!from || !to)
        return refuseLength(
            (from ? ODO_TEXT("calibration.second_end_beyond",
                             "the second end is at or beyond the horizon of camera '%1'")
                  : ODO_TEXT("calibration.first_end_beyond",
                             "the first end is at or beyond the horizon of camera '%1'"))(
                Named::camera(seen.camera)),
            ODO_TEXT("calibration.lay_stick_nearer", "put the stick on the floor, nearer to the camera"));
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

Message judgement(const LengthCheck &check, double givenM)
{
    const double difference = *check.differenceM, allowed = agreesWithin * check.sigmaM;
    Message off =
        (difference < 0 ? ODO_TEXT("calibration.length_shorter", "It is %1 shorter than the %2 entered")
                        : ODO_TEXT("calibration.length_longer", "It is %1 longer than the %2 entered"))(
            millimetres(std::abs(difference)), millimetres(givenM));
    if (std::abs(difference) <= allowed)
        return joined({std::move(off), ODO_TEXT("calibration.inside_expected_error",
                                                "within the limit of %1 (2.5 σ).")(millimetres(allowed))},
                      Join::Colon);
    return joined({joined({std::move(off), ODO_TEXT("calibration.outside_expected_error",
                                                    "beyond the limit of %1 (2.5 σ).")(millimetres(allowed))},
                          Join::Colon),
                   ODO_TEXT("calibration.check_length",
                            "Check the length itself, that it is on the floor, and the marker positions.")},
                  Join::Space);
}

} // namespace

Result<LengthCheck> checkLength(std::span<const SeenLength> seen, std::optional<double> givenM,
                                double heightM)
{
    if (seen.empty())
        return refuseLength(ODO_TEXT("calibration.length_unseen", "no camera shows it"),
                            ODO_TEXT("calibration.mark_ends_in_one", "mark its ends in at least one image"));
    if (givenM && !(*givenM > 0 && std::isfinite(*givenM)))
        return refuseLength(
            ODO_TEXT("calibration.told_length_not_positive", "the entered length is not above 0"),
            ODO_TEXT("calibration.give_taped_length", "enter the length measured with a tape"));
    double information = 0, weighted = 0;
    std::vector<Measured> each;
    for (const SeenLength &one : seen) {
        const auto measured = ODO_TRY(measure(one, heightM));
        each.push_back(measured);
        information += 1 / measured.varianceM2;
        weighted += measured.lengthM / measured.varianceM2;
    }
    LengthCheck check;
    check.lengthM = weighted / information;
    check.sigmaM = std::sqrt(1 / information);
    std::vector<Message> sentences{ODO_TEXT("calibration.length_is", "The length is %1 ± %2.")(
        millimetres(check.lengthM), millimetres(check.sigmaM))};
    for (std::size_t i = 0; i < each.size(); ++i) {
        const double off = each[i].lengthM - check.lengthM;
        if (each.size() > 1 && std::abs(off) > agreesWithin * std::sqrt(each[i].varianceM2)) {
            check.agrees = false;
            sentences.push_back(joined(
                {ODO_TEXT("calibration.camera_alone_says", "Camera '%1' alone measures %2")(
                     Named::camera(seen[i].camera), millimetres(each[i].lengthM)),
                 ODO_TEXT(
                     "calibration.look_at_ends",
                     "check that the same ends are marked in each image; if they are, register it again.")},
                Join::Colon));
        }
    }
    if (givenM) {
        check.differenceM = check.lengthM - *givenM;
        check.agrees = check.agrees && std::abs(*check.differenceM) <= agreesWithin * check.sigmaM;
        sentences.push_back(judgement(check, *givenM));
    }
    check.words = joined(std::move(sentences), Join::Space);
    return check;
}

} // namespace odo
