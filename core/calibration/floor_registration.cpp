// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"

#include "core/base/coverage.h"
#include "core/base/units.h"
#include "core/calibration/internal/floor_lens.h"
#include "core/calibration/internal/marker_pairs.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/registration_causes.h"
#include "core/calibration/internal/registration_words.h"
#include "core/calibration/internal/residual_pattern.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/homography.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr double leastHeightM = 0.05, mostHeightM = 100;
constexpr double leastSigmaPx = 1;      // a misfit below it needs no other explanation than noise
constexpr double carefulPx = 0.4;       // RMS of markers seen to 0.3 px and measured without an error
constexpr double worstMisfit = 0.01;    // of the same: no plane
constexpr double worstSigma = 0.02;     // of the layout's extent on the floor
constexpr double worstFloorFocal = 0.1; // of itself: a focal length known worse is no estimate
// Four markers leave two residuals, five leave four: so little that a badly wrong one may fit a wrong pose to
// a hundredth of the layout. Then only people's usual care reveals it (carefulMarkPx, carefulTapeM). For such
// errors the sum of the squares of four markers is χ² of two degrees of freedom: one in fifty lies beyond 8,
// where the program snaps to the marker hardly any; of five it has four, and nobody careful comes to 40. Of
// two million drawn layouts with a fault, those that passed all else had 9.5 and more, and 100.
constexpr double worstSumOfFour = 8, worstSumOfFive = 40;

double extentPx(std::span<const PointPair> pairs)
{
    std::vector<Vector2d> points;
    for (const PointPair &pair : pairs)
        points.push_back(pair.target);
    return extentOf(points);
}

Message checkAll()
{
    return ODO_TEXT("calibration.check_all", "check the layout, the labels and the intrinsics");
}

Message fitOnlyTo(double rmsPx)
{
    return ODO_TEXT("calibration.fit_only_to", "the markers fit only to %1")(quantity(rmsPx, 1, "px"));
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
    return refuseFloor(
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

/// A fit, and the σ of one coordinate of a marker's pixel by its residuals.
struct Fit
{
    PlanePose pose;
    double sigmaPx = 0;
    double studentFactor = 1;               ///< that it contains
    std::optional<FloorLens> estimatedLens; ///< where none was calibrated
};

Result<Fit> fitMarkers(const TriedMarkers &tried)
{
    auto pose = fitPlanePose(tried.pairs, tried.camera, tried.focal);
    if (!pose)
        return refuseFloor(pose.error().why, causesOr(tried, pose.error().advice));
    if (pose->worldFromCamera.translation.z() <= 0)
        return refuseFloor(
            joined({ODO_TEXT("calibration.markers_mirrored", "the markers are mirrored"),
                    ODO_TEXT("calibration.camera_below_floor",
                             "in this order the camera would be below the floor")},
                   Join::Colon),
            causesOr(tried, joined({ODO_TEXT("calibration.y_left_of_x",
                                             "seen from above, Y must point to the left of X"),
                                    ODO_TEXT("calibration.check_signs", "check the signs of the layout")},
                                   Join::Colon)));
    if (tried.focal == FocalLength::Known) {
        const double freedom = 2.0 * double(tried.pairs.size()) - 6;
        const double squaresPx2 = freedom * pose->sigmaPx * pose->sigmaPx;
        return Fit{*pose, markSigmaPx(squaresPx2, freedom), markStudentFactor(squaresPx2, freedom),
                   std::nullopt};
    }
    auto lens = fitFloorLens(tried.pairs, *pose);
    if (!lens)
        return refuseFloor(pointsUndetermined(), causesOr(tried, spreadMarkers()));
    return Fit{lens->pose, lens->pose.sigmaPx, lens->studentFactor, std::move(lens)};
}

/// A fit that no usual mistake explains better.
Result<Fit> soundFit(const TriedMarkers &tried)
{
    auto fit = ODO_TRY(fitMarkers(tried));
    Message mistake = clearMistake(tried, fit.pose);
    if (!mistake.isEmpty())
        return refuseFloor(fitOnlyTo(fit.pose.rmsPx), std::move(mistake));
    return fit;
}

/// "O, U and V", which lie the most on one line, of the four that lie the least on one.
MessageArgument flattestOf(std::span<const PointPair> pairs)
{
    const auto three = widestQuadrilateral(positionsOf(pairs)).flattest;
    std::vector<std::string> names;
    for (const int i : three)
        names.push_back(pairs[static_cast<std::size_t>(i)].label);
    return listed(names, MessageArgument::Kind::Marker);
}

Result<void> checkPosition(const PlanePose &pose)
{
    const double heightM = pose.worldFromCamera.translation.z();
    if (heightM < leastHeightM)
        return refuseFloor(ODO_TEXT("calibration.camera_too_low",
                                    "the camera would be only %1 above the floor")(millimetres(heightM)),
                           unitAdvice(heightM));
    if (heightM > mostHeightM)
        return refuseFloor(ODO_TEXT("calibration.camera_too_high",
                                    "the camera would be %1 above the floor")(quantity(heightM, 0, "m")),
                           unitAdvice(heightM));
    return {};
}

/// isPatterned: the residuals do not average out.
FloorView viewOf(const Fit &fit, bool isPatterned, const std::vector<PointPair> &pairs)
{
    const PlanePose &pose = fit.pose;
    const double alike = isPatterned ? std::max(1.0, double(pairs.size()) / 4) : 1;
    return FloorView(pose.camera, pose.worldFromCamera,
                     alike * fit.sigmaPx * fit.sigmaPx * pose.inverseNormal,
                     poseByIntrinsics(pose.camera, pose.worldFromCamera, positionsOf(pairs)));
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
            return refuseFloor(
                ODO_TEXT("calibration.marker_beyond_horizon",
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

/// Refuses a fit by its residuals and its σ. studentFactor: of the stated σ; it says nothing of the layout.
Result<void> checkFit(const FloorRegistration &registration, const TriedMarkers &tried, double layoutM,
                      double studentFactor)
{
    const double sigmaM = registration.floorSigmaM / studentFactor;
    const auto &pairs = tried.pairs;
    if (registration.rmsPx > worstMisfit * extentPx(pairs)) {
        const auto worst = std::ranges::max_element(registration.markers, {}, &MarkerError::errorPx);
        return refuseFloor(
            joined({ODO_TEXT("calibration.no_flat_floor", "the markers do not fit a flat floor"),
                    ODO_TEXT("calibration.misfit_most_at", "%1 RMS, most at %2 (%3)")(
                        quantity(registration.rmsPx, 1, "px"), Named::marker(worst->label),
                        quantity(worst->errorPx, 1, "px"))},
                   Join::Colon),
            causesOr(tried, checkAll()));
    }
    if (sigmaM > worstSigma * layoutM && registration.rmsPx > leastSigmaPx)
        return refuseFloor(fitOnlyTo(registration.rmsPx), causesOr(tried, checkAll()));
    if (sigmaM > worstSigma * layoutM)
        return refuseFloor(
            ODO_TEXT("calibration.markers_nearly_on_line",
                     "the markers are so close to one line (%1 the most) that the floor uncertainty is ±%2")(
                flattestOf(pairs), millimetres(sigmaM)),
            spreadMarkers());
    const double most = pairs.size() == 4 ? worstSumOfFour : worstSumOfFive;
    if (pairs.size() <= 5 && carelessness(registration.markers, layoutM) > most)
        return refuseFloor(
            joined({ODO_TEXT("calibration.misfit_unexplained",
                             "the %1 markers misfit by %2 (%3), and are too few to identify the wrong one")(
                        pairs.size(), quantity(registration.rmsPx, 1, "px"), millimetres(registration.rmsM)),
                    ODO_TEXT("calibration.wrong_by_more", "it may be wrong by much more")},
                   Join::Semicolon),
            causesOr(tried,
                     ODO_TEXT("calibration.measure_again", "mark and remeasure them, or add another")));
    return {};
}

} // namespace

Result<FloorRegistration> registerFloor(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels,
                                        const CameraModel &camera, bool intrinsicsKnown,
                                        const RegistrationContext &context)
{
    const auto pairs = ODO_TRY(commonMarkers(layout, pixels));
    const double layoutM = extentOf(positionsOf(pairs));
    ODO_TRY(checkDistances(pairs, layoutM));
    const TriedMarkers tried{pairs, camera, intrinsicsKnown ? FocalLength::Known : FocalLength::Free,
                             context};
    ODO_TRY(checkPixels(tried));
    const auto fit = ODO_TRY(soundFit(tried));
    ODO_TRY(checkPosition(fit.pose));
    const ResidualJudgement residuals = judgeResiduals(pairs, fit.pose, intrinsicsKnown);
    const bool isPatterned = residuals.pattern != ResidualPattern::None && !residuals.isOneMarker;
    const FloorView view = viewOf(fit, isPatterned, pairs);

    FloorRegistration registration;
    registration.intrinsics = fit.pose.camera.intrinsics();
    registration.worldFromCamera = fit.pose.worldFromCamera;
    registration.rmsPx = fit.pose.rmsPx;
    registration.poseCovariance = view.poseCovariance();
    registration.residualPattern = residuals.pattern;
    ODO_TRY(measureMarkers(pairs, view, registration));
    ODO_TRY(checkFit(registration, tried, layoutM, fit.studentFactor));
    registration.verdict =
        registrationWords({registration, view, layout, tried, fit.pose, fit.estimatedLens, residuals});
    return registration;
}

IntrinsicsSource intrinsicsSourceOf(const Intrinsics &lens, bool isCalibrated)
{
    if (isCalibrated)
        return IntrinsicsSource::Calibration;
    const bool isDetermined =
        lens.covariance.rows() > 4 && std::sqrt(lens.covariance(0, 0)) < worstFloorFocal * lens.fxPx;
    return isDetermined ? IntrinsicsSource::Floor : IntrinsicsSource::Assumed;
}

namespace {

constexpr double priorFreedom = 4;

/// χ² that one case of a thousand exceeds (Wilson and Hilferty 1931): 2.5 % too large at one degree of
/// freedom, less beyond.
double rareChiSquared(double freedom)
{
    constexpr double z = 3.0902; // of the normal distribution
    const double spread = 2 / (9 * freedom);
    return freedom * std::pow(1 - spread + z * std::sqrt(spread), 3);
}

} // namespace

double markStudentFactor(double squaresPx2, double freedom, double believedPx)
{
    constexpr double least = 2, most = 1e6; // of one residual it would be seven
    if (freedom < 1 || squaresPx2 <= rareChiSquared(freedom) * believedPx * believedPx)
        return 1;
    return studentT95(static_cast<int>(std::clamp(freedom, least, most))) / coverage95;
}

double markSigmaPx(double squaresPx2, double freedom, double believedPx)
{
    freedom = std::max(0.0, freedom);
    if (const double factor = markStudentFactor(squaresPx2, freedom, believedPx); factor > 1)
        return factor * std::sqrt(squaresPx2 / freedom);
    return std::sqrt((priorFreedom * believedPx * believedPx + squaresPx2) / (priorFreedom + freedom));
}

} // namespace odo
