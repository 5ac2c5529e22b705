// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_registration.h"

#include "core/base/units.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/lens_influence.h"
#include "core/geometry/homography.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr const char *floorRegistration = "the floor cannot be registered";
constexpr double leastHeightM = 0.05, mostHeightM = 100;
constexpr double nearestPixels = 1.0;  // markers closer than that are one and the same
constexpr double nearestPlaces = 1e-3; // of the layout's extent
constexpr double tooClose = 0.01;      // of the layout's extent: of four markers each must count
constexpr double smallHeightM = 0.3, smallExtentM = 0.7; // below both, the numbers may well be centimetres
constexpr double leastDoubtPx = 1;       // a misfit below it needs no other explanation than noise
constexpr double carefulPx = 0.4;        // RMS of markers seen to 0.3 px and measured without an error
constexpr double otherOrderFits = 0.005; // of the markers' extent in the picture
constexpr double worstMisfit = 0.01;     // of the same: no plane
constexpr double worstSigma = 0.02;      // of the layout's extent on the floor
// Four markers leave two residuals, five leave four: so little that one put quite wrongly may fit a wrong
// pose to a hundredth of the layout. What tells it then is how careful people are: a pixel, and 2 mm and half
// a millimetre a metre by a tape. For such errors the sum of the squares of four markers is χ² of two degrees
// of freedom: one in fifty lies beyond 8, where the program snaps to the marker hardly any; of five it has
// four, and nobody careful comes to 40. Of two million drawn layouts with a fault, those that passed all else
// had 9.5 and more, and 100.
constexpr double carefulMarkPx = 1, carefulTapeM = 0.002, carefulTapeShare = 0.0005;
constexpr double worstSumOfFour = 8, worstSumOfFive = 40;

tl::unexpected<Error> refuse(std::string why, std::string advice)
{
    return fail(ErrorCode::Undetermined, floorRegistration, std::move(why), std::move(advice));
}

template <class Points>
Result<void> checkLabels(const Points &points, const char *where)
{
    std::set<std::string> seen;
    for (const auto &point : points) {
        if (!seen.insert(point.label).second)
            return refuse("marker " + point.label + " stands twice in " + where,
                          "give each marker a name of its own");
    }
    return {};
}

Result<void> checkNumbers(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels)
{
    for (const Marker &marker : layout.markers) {
        if (!marker.pointInWorld.allFinite())
            return fail(ErrorCode::InvalidInput, floorRegistration,
                        "the place of marker " + marker.label + " is not a finite number",
                        "correct the layout");
    }
    for (const MarkerPixel &pixel : pixels) {
        if (!pixel.pixel.allFinite())
            return fail(ErrorCode::InvalidInput, floorRegistration,
                        "the pixel of marker " + pixel.label + " is not a finite number",
                        "correct the pixels");
    }
    return {};
}

Result<void> checkDistances(const std::vector<PointPair> &pairs, double extentM)
{
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        for (std::size_t j = i + 1; j < pairs.size(); ++j) {
            const std::string both = "markers " + pairs[i].label + " and " + pairs[j].label;
            if ((pairs[i].source - pairs[j].source).norm() <= nearestPlaces * extentM)
                return refuse(both + " lie at one place of the floor", "correct the layout");
            if ((pairs[i].target - pairs[j].target).norm() < nearestPixels)
                return refuse(both + " lie on one pixel", "mark each of them where it is seen");
            const double apartM = (pairs[i].source - pairs[j].source).norm();
            if (pairs.size() == 4 && apartM < tooClose * extentM)
                return refuse(both + " lie only " + millimetres(apartM) + " apart, too close for two of four",
                              "spread the markers over the floor");
        }
    }
    return {};
}

Result<std::vector<PointPair>> commonMarkers(const MarkerLayout &layout,
                                             const std::vector<MarkerPixel> &pixels)
{
    if (auto sound = checkLabels(layout.markers, "the layout"); !sound)
        return tl::unexpected(sound.error());
    if (auto sound = checkLabels(pixels, "the picture"); !sound)
        return tl::unexpected(sound.error());
    if (auto sound = checkNumbers(layout, pixels); !sound)
        return tl::unexpected(sound.error());
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
    if (pairs.size() < 4)
        return refuse("four markers are needed that the layout and the picture have in common; there are " +
                          std::to_string(pairs.size()) + " (" + listed(names) + ")" +
                          (unknown.empty() ? "" : ", and the layout does not know " + listed(unknown)),
                      "mark more of the layout's markers, under the layout's names");
    return pairs;
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

/// The advice after a misfit: what exchange would mend it, where there is one.
std::string orderAdvice(const std::vector<PointPair> &pairs, const CameraModel &camera, FocalLength focal,
                        const std::string &otherwise)
{
    const std::string better = betterOrder(pairs, camera, focal, otherOrderFits * extentPx(pairs));
    return better.empty() ? otherwise : better + ": check these labels";
}

/// Words about an order of the labels that fits five times better, or as well as markers that are seen and
/// measured with care; empty where there is none.
std::string doubtOfOrder(const std::vector<PointPair> &pairs, const PlanePose &pose,
                         const CameraModel &camera, FocalLength focal)
{
    // With the focal length free, four markers fit in nearly any order: that would prove nothing.
    if (pose.rmsPx < leastDoubtPx || (focal == FocalLength::Free && pairs.size() == 4))
        return "";
    return betterOrder(pairs, camera, focal, std::max(0.2 * pose.rmsPx, carefulPx));
}

Result<PlanePose> soundPose(const std::vector<PointPair> &pairs, const CameraModel &camera, FocalLength focal)
{
    auto pose = fitPlanePose(pairs, camera, focal);
    if (!pose)
        return refuse(pose.error().why, orderAdvice(pairs, camera, focal, pose.error().advice));
    if (pose->worldFromCamera.translation.z() <= 0)
        return refuse(
            "the markers are mirrored: seen in this order the camera would be below the floor",
            orderAdvice(pairs, camera, focal,
                        "seen from above, Y must point to the left of X: check the signs of the layout"));
    const std::string better = doubtOfOrder(pairs, *pose, camera, focal);
    if (!better.empty())
        return refuse("the markers fit only to " + formatNumber(pose->rmsPx, 1) + " px, but " + better,
                      "check these labels");
    return pose;
}

/// "metres, then it would stand 1.70 m above the floor", of the unit that makes the camera's height the most
/// ordinary; empty where none does.
std::string likelyUnit(double heightM)
{
    struct Unit
    {
        const char *name;
        double factor;
    };
    constexpr double ordinaryM = 1.8;
    const Unit *best = nullptr;
    static constexpr Unit units[] = {{"metres", 1000},
                                     {"inches", 25.4},
                                     {"centimetres", 10},
                                     {"thousandths of a mm", 1e-3},
                                     {"tenths of a mm", 0.1}};
    const auto strangeness = [&](const Unit &unit) {
        return std::abs(std::log(heightM * unit.factor / ordinaryM));
    };
    for (const Unit &unit : units) {
        if (best == nullptr || strangeness(unit) < strangeness(*best))
            best = &unit;
    }
    if (strangeness(*best) > std::log(4.0))
        return "";
    return std::string(best->name) + ", then it would stand " + formatNumber(heightM * best->factor, 2) +
           " m above the floor";
}

std::string unitAdvice(double heightM)
{
    const std::string likely = likelyUnit(heightM);
    return "check the unit of the layout: " +
           (likely.empty() ? "it is given in mm" : "its numbers look like " + likely);
}

Result<void> checkPlace(const PlanePose &pose)
{
    const double heightM = pose.worldFromCamera.translation.z();
    if (heightM < leastHeightM)
        return refuse("the camera would stand only " + millimetres(heightM) + " above the floor",
                      unitAdvice(heightM));
    if (heightM > mostHeightM)
        return refuse("the camera would stand " + formatNumber(heightM, 0) + " m above the floor",
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
CameraModel lensOf(const PlanePose &pose)
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
    std::vector<Vector2d> places;
    for (const PointPair &pair : pairs)
        places.push_back(pair.source);
    return FloorView(lens, pose.worldFromCamera, sigmaPx * sigmaPx * pose.inverseNormal,
                     poseByLens(lens, pose.worldFromCamera, places));
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
            return refuse("marker " + pair.label + " would lie at or beyond the horizon",
                          "check its place and its pixel");
        const double errorM = (seen->pointInWorld - pair.source).norm();
        registration.markers.push_back({pair.label, errorM, (*back - pair.target).norm()});
        squares += errorM * errorM;
        registration.floorSigmaM = std::max(registration.floorSigmaM, largestSigmaM(*seen));
    }
    registration.rmsM = std::sqrt(squares / static_cast<double>(pairs.size()));
    return {};
}

/// The sum of the squares of the markers' errors, each by what a careful person may leave in the picture and
/// on the floor together: where a marker's error is e in pixels and E in metres, a metre is e / E pixels long
/// there.
double carelessness(const std::vector<MarkerError> &markers, double layoutM)
{
    const double tapeM = carefulTapeM + carefulTapeShare * layoutM;
    double sum = 0;
    for (const MarkerError &marker : markers) {
        if (marker.errorPx > 0 && marker.errorM > 0)
            sum += 1 / (std::pow(carefulMarkPx / marker.errorPx, 2) + std::pow(tapeM / marker.errorM, 2));
    }
    return sum;
}

std::string lensWords(const PlanePose &pose, bool intrinsicsKnown)
{
    if (intrinsicsKnown)
        return "";
    const std::string focal = formatNumber(pose.camera.intrinsics().fxPx, 0) + " px";
    std::string words = " The camera was taken as free of distortion, its focal length ";
    if (pose.focalSigmaPx)
        words += "estimated from the markers (" + focal + " ± " + formatNumber(*pose.focalSigmaPx, 0) + ").";
    else
        words += "guessed (" + focal + "), since this view does not determine it.";
    return words + " Calibrate it for positions to rely on.";
}

/// " (O, U and V the most)", of the four that lie the least on one line.
std::string flattestOf(const std::vector<PointPair> &pairs)
{
    std::vector<Vector2d> points;
    for (const PointPair &pair : pairs)
        points.push_back(pair.source);
    const auto three = widestQuadrilateral(points).flattest;
    std::vector<std::string> names;
    for (const int i : three)
        names.push_back(pairs[static_cast<std::size_t>(i)].label);
    return " (" + listed(names) + " the most)";
}

/// A table top is possible, a floor whose centimetres were read as mm is likelier.
std::string unitWords(const FloorRegistration &registration, double layoutM)
{
    const double heightM = registration.worldFromCamera.translation.z();
    if (heightM >= smallHeightM || layoutM >= smallExtentM)
        return "";
    return " The camera would stand only " + millimetres(heightM) +
           " above the floor: if that is wrong, the layout's numbers are no mm; convert its unit.";
}

std::string verdictOf(const FloorRegistration &registration, const PlanePose &pose, double layoutM,
                      bool intrinsicsKnown)
{
    const double sigmaM = registration.floorSigmaM;
    const double worse = std::max(registration.rmsM, sigmaM);
    const auto worst = std::ranges::max_element(registration.markers, {}, &MarkerError::errorM);
    std::string verdict = registrationGrade(worse, layoutM) + std::to_string(registration.markers.size()) +
                          " markers fit to " + millimetres(registration.rmsM) + " RMS (worst " +
                          worst->label + ", " + millimetres(worst->errorM) +
                          "), and the floor among them is known to ±" + millimetres(sigmaM) + ".";
    if (registration.markers.size() == 4)
        verdict += " Four markers hardly check one another; a fifth would.";
    return verdict + lensWords(pose, intrinsicsKnown);
}

} // namespace

Result<FloorRegistration> registerFloor(const MarkerLayout &layout, const std::vector<MarkerPixel> &pixels,
                                        const CameraModel &camera, bool intrinsicsKnown)
{
    const auto pairs = commonMarkers(layout, pixels);
    if (!pairs)
        return tl::unexpected(pairs.error());
    const double layoutM = extentM(*pairs);
    if (auto sound = checkDistances(*pairs, layoutM); !sound)
        return tl::unexpected(sound.error());
    const FocalLength focal = intrinsicsKnown ? FocalLength::Known : FocalLength::Free;
    const auto pose = soundPose(*pairs, camera, focal);
    if (!pose)
        return tl::unexpected(pose.error());
    if (auto sound = checkPlace(*pose); !sound)
        return tl::unexpected(sound.error());

    FloorRegistration registration;
    const CameraModel lens = lensOf(*pose);
    registration.intrinsics = lens.intrinsics();
    registration.worldFromCamera = pose->worldFromCamera;
    registration.rmsPx = pose->rmsPx;
    const FloorView view = viewOf(*pose, lens, *pairs);
    registration.poseCovariance = view.poseCovariance();
    if (auto measured = measureMarkers(*pairs, view, registration); !measured)
        return tl::unexpected(measured.error());
    if (registration.rmsPx > worstMisfit * extentPx(*pairs)) {
        const auto worst = std::ranges::max_element(registration.markers, {}, &MarkerError::errorPx);
        return refuse("the markers do not fit a flat floor: " + formatNumber(registration.rmsPx, 1) +
                          " px RMS, most at " + worst->label + " (" + formatNumber(worst->errorPx, 1) +
                          " px)",
                      "check the layout, the labels and the intrinsics");
    }
    if (registration.floorSigmaM > worstSigma * layoutM)
        return refuse("the markers lie so nearly on one line" + flattestOf(*pairs) +
                          " that the floor is known only to ±" + millimetres(registration.floorSigmaM),
                      "spread the markers over the floor");
    const double most = pairs->size() == 4 ? worstSumOfFour : worstSumOfFive;
    if (pairs->size() <= 5 && carelessness(registration.markers, layoutM) > most)
        return refuse(
            "the " + std::to_string(pairs->size()) + " markers misfit by " +
                formatNumber(registration.rmsPx, 1) + " px (" + millimetres(registration.rmsM) +
                ") and check one another too little to tell which of them; it may be wrong by much more",
            "mark and measure them again, or add another");
    registration.verdict = verdictOf(registration, *pose, layoutM, intrinsicsKnown);
    registration.verdict += unitWords(registration, layoutM);
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
