// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"

#include "core/base/units.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/registration_causes.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/homography.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr double leastHeightM = 0.05, mostHeightM = 100;
constexpr double nearestPixels = 1.0;     // markers closer than that are one and the same
constexpr double nearestPositions = 1e-3; // of the layout's extent
constexpr double tooClose = 0.01;         // of the layout's extent: of four markers each must count
constexpr double smallHeightM = 0.3, smallExtentM = 0.7; // below both, the numbers may well be centimetres
constexpr double leastSigmaPx = 1;   // a misfit below it needs no other explanation than noise
constexpr double carefulPx = 0.4;    // RMS of markers seen to 0.3 px and measured without an error
constexpr double worstMisfit = 0.01; // of the same: no plane
constexpr double worstSigma = 0.02;  // of the layout's extent on the floor
// Four markers leave two residuals, five leave four: so little that a badly wrong one may fit a wrong pose to
// a hundredth of the layout. Then only people's usual care reveals it (carefulMarkPx, carefulTapeM). For such
// errors the sum of the squares of four markers is χ² of two degrees of freedom: one in fifty lies beyond 8,
// where the program snaps to the marker hardly any; of five it has four, and nobody careful comes to 40. Of
// two million drawn layouts with a fault, those that passed all else had 9.5 and more, and 100.
constexpr double worstSumOfFour = 8, worstSumOfFive = 40;

tl::unexpected<Error> refuse(Message why, Message advice, ErrorCode code = ErrorCode::Undetermined)
{
    return fail(code, ODO_TEXT("calibration.floor_not_registered", "the floor cannot be registered"),
                std::move(why), std::move(advice));
}

Message correctLayout()
{
    return ODO_TEXT("calibration.correct_layout", "correct the layout");
}

Message nameEachMarker()
{
    return ODO_TEXT("calibration.name_each_marker", "give each marker a name of its own");
}

template <class Points>
Result<void> checkLabels(const Points &points, const MessageText &isThereTwice)
{
    std::set<std::string> seen;
    for (const auto &point : points) {
        if (!seen.insert(point.label).second)
            return refuse(isThereTwice(Named::marker(point.label)), nameEachMarker());
    }
    return {};
}

Result<void> checkNumbers(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels)
{
    for (const Marker &marker : layout.markers) {
        if (!marker.pointInWorld.allFinite())
            return refuse(
                ODO_TEXT("calibration.marker_place_no_number",
                         "the position of marker %1 is not a finite number")(Named::marker(marker.label)),
                correctLayout(), ErrorCode::InvalidInput);
    }
    for (const MarkerPixel &pixel : pixels) {
        if (!pixel.pixel.allFinite())
            return refuse(
                ODO_TEXT("calibration.marker_pixel_no_number",
                         "the pixel of marker %1 is not a finite number")(Named::marker(pixel.label)),
                correctPixels(), ErrorCode::InvalidInput);
    }
    return {};
}

Result<void> checkDistances(const std::vector<PointPair> &pairs, double extentM)
{
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (std::size_t j = i + 1; j < pairs.size(); ++j) {
            const MessageArgument one = Named::marker(pairs[i].label), other = Named::marker(pairs[j].label);
            const double apartM = (pairs[i].source - pairs[j].source).norm();
            if (apartM <= nearestPositions * extentM)
                return refuse(ODO_TEXT("calibration.markers_at_one_place",
                                       "markers %1 and %2 have the same floor position")(one, other),
                              correctLayout());
            if ((pairs[i].target - pairs[j].target).norm() < nearestPixels)
                return refuse(ODO_TEXT("calibration.markers_on_one_pixel",
                                       "markers %1 and %2 are on the same pixel")(one, other),
                              markWhereSeen());
            if (pairs.size() == 4 && apartM < tooClose * extentM)
                return refuse(ODO_TEXT("calibration.markers_too_close",
                                       "markers %1 and %2 are only %3 apart, too close for two of four")(
                                  one, other, millimetres(apartM)),
                              spreadMarkers());
        }
    }
    return {};
}

Result<std::vector<PointPair>> commonMarkers(const MarkerLayout &layout,
                                             const std::vector<MarkerPixel> &pixels)
{
    ODO_TRY(checkLabels(layout.markers, ODO_TEXT("calibration.marker_twice_in_layout",
                                                 "marker %1 appears twice in the layout")));
    ODO_TRY(checkLabels(
        pixels, ODO_TEXT("calibration.marker_twice_in_picture", "marker %1 appears twice in the image")));
    ODO_TRY(checkNumbers(layout, pixels));
    std::vector<PointPair> pairs;
    std::vector<std::string> names;
    for (const Marker &marker : layout.markers) {
        const auto seen = std::ranges::find(pixels, marker.label, &MarkerPixel::label);
        if (seen == pixels.end())
            continue;
        pairs.push_back({marker.pointInWorld, seen->pixel, marker.label});
        names.push_back(marker.label);
    }
    std::vector<std::string> unknown;
    for (const MarkerPixel &pixel : pixels) {
        if (std::ranges::find(layout.markers, pixel.label, &Marker::label) == layout.markers.end())
            unknown.push_back(pixel.label);
    }
    if (pairs.size() >= 4)
        return pairs;
    const MessageArgument known = listed(names, MessageArgument::Kind::Marker);
    Message there = unknown.empty()
                        ? ODO_TEXT("calibration.common_markers", "they have %1 (%2)")(pairs.size(), known)
                        : ODO_TEXT("calibration.common_and_unknown_markers",
                                   "they have %1 (%2), and the layout does not contain %3")(
                              pairs.size(), known, listed(unknown, MessageArgument::Kind::Marker));
    return refuse(
        joined({ODO_TEXT("calibration.four_common_markers",
                         "the layout and the image must have four markers in common"),
                std::move(there)},
               Join::Semicolon),
        ODO_TEXT("calibration.mark_more", "mark more of the layout's markers, by their names in the layout"));
}

double extentM(const std::vector<PointPair> &pairs)
{
    std::vector<Vector2d> points;
    for (const PointPair &pair : pairs)
        points.push_back(pair.source);
    return extentOf(points);
}

double extentPx(const std::vector<PointPair> &pairs)
{
    std::vector<Vector2d> points;
    for (const PointPair &pair : pairs)
        points.push_back(pair.target);
    return extentOf(points);
}

/// The usual mistakes that explain a misfit, or else the advice where none does.
Message causesOr(const TriedMarkers &tried, Message otherwise)
{
    Message causes = likelyCauses(tried);
    return causes.isEmpty() ? otherwise : causes;
}

/// A pixel outside the image was never seen in it.
Result<void> checkPixels(const TriedMarkers &tried)
{
    const PointPair *outside = pixelOutside(tried.pairs, tried.camera);
    if (outside == nullptr)
        return {};
    const Intrinsics &lens = tried.camera.intrinsics();
    const double u = outside->target.x(), v = outside->target.y();
    const bool isU =
        std::abs(u - lens.widthPx / 2.0) * lens.heightPx > std::abs(v - lens.heightPx / 2.0) * lens.widthPx;
    return refuse(
        (isU ? ODO_TEXT("calibration.u_outside", "u = %1 of marker %2 is outside the image of %3")
             : ODO_TEXT("calibration.v_outside", "v = %1 of marker %2 is outside the image of %3"))(
            quantity(isU ? u : v, 0), Named::marker(outside->label), sizeText(lens.widthPx, lens.heightPx)),
        causesOr(tried, correctPixels()));
}

/// Mistakes without which the markers fit five times better, or as well as markers that are seen and measured
/// with care; empty where there is none.
Message clearMistake(const TriedMarkers &tried, const PlanePose &pose)
{
    // With the focal length free, four markers fit in nearly any order: that would prove nothing.
    if (pose.rmsPx < leastSigmaPx || (tried.focal == FocalLength::Free && tried.pairs.size() == 4))
        return {};
    return likelyCauses(tried, std::max(0.2 * pose.rmsPx, carefulPx));
}

Result<PlanePose> soundPose(const TriedMarkers &tried)
{
    auto pose = fitPlanePose(tried.pairs, tried.camera, tried.focal);
    if (!pose)
        return refuse(pose.error().why, causesOr(tried, pose.error().advice));
    if (pose->worldFromCamera.translation.z() <= 0)
        return refuse(
            joined({ODO_TEXT("calibration.markers_mirrored", "the markers are mirrored"),
                    ODO_TEXT("calibration.camera_below_floor",
                             "in this order the camera would be below the floor")},
                   Join::Colon),
            causesOr(tried, joined({ODO_TEXT("calibration.y_left_of_x",
                                             "seen from above, Y must point to the left of X"),
                                    ODO_TEXT("calibration.check_signs", "check the signs of the layout")},
                                   Join::Colon)));
    Message mistake = clearMistake(tried, *pose);
    if (!mistake.isEmpty())
        return refuse(
            ODO_TEXT("calibration.fit_only_to", "the markers fit only to %1")(quantity(pose->rmsPx, 1, "px")),
            std::move(mistake));
    return pose;
}

/// "its numbers look like metres, with the camera 1.70 m above the floor", for the unit that makes the
/// camera's height the most ordinary; if none does, the required unit.
Message likelyUnit(double heightM)
{
    struct Unit
    {
        const MessageText &name;
        double factor;
    };
    constexpr double ordinaryM = 1.8;
    const Unit *best = nullptr;
    static const Unit units[] = {{ODO_TEXT("calibration.metres", "metres"), 1000},
                                 {ODO_TEXT("calibration.inches", "inches"), 25.4},
                                 {ODO_TEXT("calibration.centimetres", "centimetres"), 10},
                                 {ODO_TEXT("calibration.thousandths_of_mm", "thousandths of a mm"), 1e-3},
                                 {ODO_TEXT("calibration.tenths_of_mm", "tenths of a mm"), 0.1}};
    const auto strangeness = [&](const Unit &unit) {
        return std::abs(std::log(heightM * unit.factor / ordinaryM));
    };
    for (const Unit &unit : units) {
        if (best == nullptr || strangeness(unit) < strangeness(*best))
            best = &unit;
    }
    if (strangeness(*best) > std::log(4.0))
        return ODO_TEXT("calibration.layout_in_mm", "it must be in mm");
    return ODO_TEXT("calibration.likely_unit",
                    "its numbers look like %1, with the camera %2 above the floor")(
        best->name, quantity(heightM * best->factor, 2, "m"));
}

Message unitAdvice(double heightM)
{
    return joined({ODO_TEXT("calibration.check_unit", "check the unit of the layout"), likelyUnit(heightM)},
                  Join::Colon);
}

Result<void> checkPosition(const PlanePose &pose)
{
    const double heightM = pose.worldFromCamera.translation.z();
    if (heightM < leastHeightM)
        return refuse(ODO_TEXT("calibration.camera_too_low",
                               "the camera would be only %1 above the floor")(millimetres(heightM)),
                      unitAdvice(heightM));
    if (heightM > mostHeightM)
        return refuse(ODO_TEXT("calibration.camera_too_high",
                               "the camera would be %1 above the floor")(quantity(heightM, 0, "m")),
                      unitAdvice(heightM));
    return {};
}

double markerSigmaPx(const PlanePose &pose, std::size_t markers)
{
    const double freedom = 2.0 * static_cast<double>(markers) - (pose.focalSigmaPx ? 7 : 6);
    return markSigmaPx(freedom * pose.sigmaPx * pose.sigmaPx, freedom);
}

/// The lens of a pose; where its focal length was estimated, with the covariance of that: one number, by
/// which both focal lengths scale.
CameraModel intrinsicsOf(const PlanePose &pose)
{
    Intrinsics intrinsics = pose.camera.intrinsics();
    if (!pose.focalSigmaPx)
        return pose.camera;
    const auto values = static_cast<Eigen::Index>(4 + intrinsics.distortion.size());
    Eigen::VectorXd byScale = Eigen::VectorXd::Zero(values);
    byScale.head<2>() << intrinsics.fxPx, intrinsics.fyPx;
    const double sigma = *pose.focalSigmaPx / intrinsics.fxPx;
    intrinsics.covariance = sigma * sigma * byScale * byScale.transpose();
    return CameraModel::create(std::move(intrinsics)).value_or(pose.camera);
}

FloorView viewOf(const PlanePose &pose, const CameraModel &lens, const std::vector<PointPair> &pairs)
{
    const double sigmaPx = markerSigmaPx(pose, pairs.size());
    std::vector<Vector2d> positions;
    for (const PointPair &pair : pairs)
        positions.push_back(pair.source);
    return FloorView(lens, pose.worldFromCamera, sigmaPx * sigmaPx * pose.inverseNormal,
                     poseByIntrinsics(lens, pose.worldFromCamera, positions));
}

/// Fills the errors of the markers and the σ of the floor among them.
Result<void> measureMarkers(const std::vector<PointPair> &pairs, const FloorView &view,
                            FloorRegistration &registration)
{
    double squares = 0;
    for (const PointPair &pair : pairs) {
        const auto seen = view.locate(pair.target, Eigen::Matrix2d::Zero(), 0);
        const auto back = view.pixelFromWorld({pair.source.x(), pair.source.y(), 0});
        if (!seen || !back)
            return refuse(ODO_TEXT("calibration.marker_beyond_horizon",
                                   "marker %1 would be at or beyond the horizon")(Named::marker(pair.label)),
                          ODO_TEXT("calibration.check_place_and_pixel", "check its position and its pixel"));
        const double errorM = (seen->pointInWorld - pair.source).norm();
        registration.markers.push_back({pair.label, errorM, (*back - pair.target).norm()});
        squares += errorM * errorM;
        registration.floorSigmaM = std::max(registration.floorSigmaM, largestSigmaM(*seen));
    }
    registration.rmsM = std::sqrt(squares / static_cast<double>(pairs.size()));
    return {};
}

/// The sum of the squares of the markers' errors, each by what a careful person may leave in the image and on
/// the floor together: where a marker's error is e in pixels and E in metres, a metre is e / E pixels long
/// there.
double carelessness(const std::vector<MarkerError> &markers, double layoutM)
{
    const double tapeM = carefulTapeM(layoutM);
    double sum = 0;
    for (const MarkerError &marker : markers) {
        if (marker.errorPx > 0 && marker.errorM > 0)
            sum += 1 / (std::pow(carefulMarkPx / marker.errorPx, 2) + std::pow(tapeM / marker.errorM, 2));
    }
    return sum;
}

Message lensWords(const PlanePose &pose, bool intrinsicsKnown)
{
    if (intrinsicsKnown)
        return {};
    const MessageArgument focal = quantity(pose.camera.intrinsics().fxPx, 0, "px");
    return joined(
        {pose.focalSigmaPx
             ? ODO_TEXT("calibration.focal_length_estimated",
                        "The lens is not calibrated: no distortion was assumed, and the focal length was "
                        "estimated from the markers (%1 ± %2).")(focal, quantity(*pose.focalSigmaPx, 0))
             : ODO_TEXT("calibration.focal_length_guessed",
                        "The lens is not calibrated: no distortion was assumed, and the focal length was "
                        "guessed (%1) because this view does not determine it.")(focal),
         calibrateToRely()},
        Join::Space);
}

/// "O, U and V", which lie the most on one line, of the four that lie the least on one.
MessageArgument flattestOf(const std::vector<PointPair> &pairs)
{
    std::vector<Vector2d> points;
    for (const PointPair &pair : pairs)
        points.push_back(pair.source);
    const auto three = widestQuadrilateral(points).flattest;
    std::vector<std::string> names;
    for (const int i : three)
        names.push_back(pairs[static_cast<std::size_t>(i)].label);
    return listed(names, MessageArgument::Kind::Marker);
}

/// A table top is possible, a floor whose centimetres were read as mm is likelier.
Message unitWords(const FloorRegistration &registration, double layoutM)
{
    const double heightM = registration.worldFromCamera.translation.z();
    if (heightM >= smallHeightM || layoutM >= smallExtentM)
        return {};
    return joined(
        {ODO_TEXT("calibration.camera_stands_low",
                  "The camera would be only %1 above the floor")(millimetres(heightM)),
         joined({ODO_TEXT("calibration.layout_not_in_mm", "if that is wrong, the layout is not in mm"),
                 likelyUnit(heightM), ODO_TEXT("calibration.convert_unit", "convert its unit.")},
                Join::Semicolon)},
        Join::Colon);
}

/// With four corners of a rectangle, a floor that is mirrored fits as well as the right one.
Message mirrorWords()
{
    return joined({ODO_TEXT("calibration.camera_upside_down", "The camera would be upside down"),
                   ODO_TEXT("calibration.floor_may_be_mirrored",
                            "if it is not, v is counted from below, and the labels are mirrored.")},
                  Join::Semicolon);
}

/// The pixels are those of another camera, too.
Message otherCameraWords(const TriedMarkers &tried)
{
    for (const OtherCamera &other : tried.context.others) {
        if (const auto apartPx = markersApartPx(other, tried.pairs))
            return ODO_TEXT("calibration.same_as_other_camera",
                            "Camera '%1' sees the markers at the same pixels (to %2): check that the views "
                            "are not swapped.")(Named::camera(other.name), quantity(*apartPx, 1, "px"));
    }
    return {};
}

Message verdictOf(const FloorRegistration &registration, const TriedMarkers &tried, const PlanePose &pose,
                  double layoutM, bool intrinsicsKnown)
{
    const double sigmaM = registration.floorSigmaM;
    const auto worst = std::ranges::max_element(registration.markers, {}, &MarkerError::errorM);
    Message hardly;
    if (registration.markers.size() == 4)
        hardly = hardlyChecked(
            ODO_TEXT("calibration.four_markers_unchecked", "Four markers are too few to check each other"));
    Message fit =
        ODO_TEXT("calibration.markers_fit", "%1 markers fit to %2 RMS (worst %3, %4); floor uncertainty ±%5")(
            registration.markers.size(), millimetres(registration.rmsM), Named::marker(worst->label),
            millimetres(worst->errorM), millimetres(sigmaM));
    const bool mirrored = mayBeMirrored(tried, pose);
    return joined({mirrored
                       ? uncertainVerdict(std::move(fit))
                       : registrationVerdict(std::max(registration.rmsM, sigmaM), layoutM, std::move(fit)),
                   mirrored ? mirrorWords() : Message(), otherCameraWords(tried), std::move(hardly),
                   lensWords(pose, intrinsicsKnown), unitWords(registration, layoutM)},
                  Join::Space);
}

} // namespace

Result<FloorRegistration> registerFloor(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels,
                                        const CameraModel &camera, bool intrinsicsKnown,
                                        const RegistrationContext &context)
{
    const auto pairs = ODO_TRY(commonMarkers(layout, pixels));
    const double layoutM = extentM(pairs);
    ODO_TRY(checkDistances(pairs, layoutM));
    const TriedMarkers tried{pairs, camera, intrinsicsKnown ? FocalLength::Known : FocalLength::Free,
                             context};
    ODO_TRY(checkPixels(tried));
    const auto pose = ODO_TRY(soundPose(tried));
    ODO_TRY(checkPosition(pose));

    FloorRegistration registration;
    const CameraModel lens = intrinsicsOf(pose);
    registration.intrinsics = lens.intrinsics();
    registration.worldFromCamera = pose.worldFromCamera;
    registration.rmsPx = pose.rmsPx;
    const FloorView view = viewOf(pose, lens, pairs);
    registration.poseCovariance = view.poseCovariance();
    ODO_TRY(measureMarkers(pairs, view, registration));
    if (registration.rmsPx > worstMisfit * extentPx(pairs)) {
        const auto worst = std::ranges::max_element(registration.markers, {}, &MarkerError::errorPx);
        return refuse(joined({ODO_TEXT("calibration.no_flat_floor", "the markers do not fit a flat floor"),
                              ODO_TEXT("calibration.misfit_most_at", "%1 RMS, most at %2 (%3)")(
                                  quantity(registration.rmsPx, 1, "px"), Named::marker(worst->label),
                                  quantity(worst->errorPx, 1, "px"))},
                             Join::Colon),
                      causesOr(tried, ODO_TEXT("calibration.check_all",
                                               "check the layout, the labels and the intrinsics")));
    }
    if (registration.floorSigmaM > worstSigma * layoutM)
        return refuse(
            ODO_TEXT("calibration.markers_nearly_on_line",
                     "the markers are so close to one line (%1 the most) that the floor uncertainty is ±%2")(
                flattestOf(pairs), millimetres(registration.floorSigmaM)),
            spreadMarkers());
    const double most = pairs.size() == 4 ? worstSumOfFour : worstSumOfFive;
    if (pairs.size() <= 5 && carelessness(registration.markers, layoutM) > most)
        return refuse(
            joined({ODO_TEXT("calibration.misfit_unexplained",
                             "the %1 markers misfit by %2 (%3), and are too few to identify the wrong one")(
                        pairs.size(), quantity(registration.rmsPx, 1, "px"), millimetres(registration.rmsM)),
                    ODO_TEXT("calibration.wrong_by_more", "it may be wrong by much more")},
                   Join::Semicolon),
            causesOr(tried,
                     ODO_TEXT("calibration.measure_again", "mark and remeasure them, or add another")));
    registration.verdict = verdictOf(registration, tried, pose, layoutM, intrinsicsKnown);
    return registration;
}

namespace {

constexpr double priorFreedom = 4;
constexpr double refutedBeyond = 3; // times the prior

} // namespace

double markSigmaPx(double squaresPx2, double freedom)
{
    freedom = std::max(0.0, freedom);
    if (freedom >= 1 && std::sqrt(squaresPx2 / freedom) > refutedBeyond * usualMarkSigmaPx)
        return std::sqrt(squaresPx2 / freedom);
    return std::sqrt((priorFreedom * usualMarkSigmaPx * usualMarkSigmaPx + squaresPx2) /
                     (priorFreedom + freedom));
}

} // namespace odo
