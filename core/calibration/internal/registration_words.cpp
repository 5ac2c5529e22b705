// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/registration_words.h"

#include "core/base/units.h"
#include "core/calibration/accuracy_map.h"
#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr double smallHeightM = 0.3, smallExtentM = 0.7; // below both, the numbers may well be centimetres
constexpr double growsBy = 1.5;                          // a σ elsewhere that is worth a word
constexpr int positionsAcross = 12;
constexpr std::size_t leastHeldOut = 8;

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

/// The largest σ of the floor over the layout and a margin about it, as far as the image shows it.
double largestOver(const FloorView &view, const MarkerLayout &layout, double marginM)
{
    const AccuracyMap map = accuracyMap(std::span(&view, 1), gridOver(layout, marginM, positionsAcross), 0);
    double largestM = 0;
    for (const double sigmaM : map.cameraSigmaM.front())
        largestM = sigmaM > largestM ? sigmaM : largestM; // never where it is not seen, NaN
    return largestM;
}

Message estimatedLensWords(const FloorLens &lens, std::size_t markers)
{
    const Intrinsics &intrinsics = lens.pose.camera.intrinsics();
    const bool isSaid =
        markers >= leastHeldOut && intrinsicsSourceOf(intrinsics, false) == IntrinsicsSource::Floor;
    return joined({lensWords(intrinsics),
                   isSaid ? ODO_TEXT("calibration.held_out_markers",
                                     "Markers that are left out one by one are predicted to %1 RMS.")(
                                quantity(lens.heldOutPx, 1, "px"))
                          : Message(),
                   calibrateToRely()},
                  Join::Space);
}

Message levelled(const RegistrationFacts &facts, double sigmaM, double layoutM, Message fit)
{
    const double worseM = std::max(facts.registration.rmsM, sigmaM);
    // A pattern is no chance, however small.
    const bool isPatterned = facts.residuals.pattern != ResidualPattern::None;
    return isPatterned && isGoodRegistration(worseM, layoutM)
               ? usableVerdict(std::move(fit))
               : registrationVerdict(worseM, layoutM, std::move(fit));
}

/// Beyond the markers a lens that nobody calibrated errs the most.
Message beyondWords(const RegistrationFacts &facts, double sigmaM, double layoutM)
{
    if (!facts.estimatedLens)
        return {};
    const double marginM = 0.5 * layoutM, beyondM = largestOver(facts.view, facts.layout, marginM);
    if (beyondM < growsBy * sigmaM)
        return {};
    return ODO_TEXT("calibration.grows_beyond", "Beyond the markers it grows, to ±%1 within %2 of them.")(
        millimetres(beyondM), quantity(marginM, 1, "m"));
}

double extentM(const MarkerLayout &layout)
{
    std::vector<Vector2d> points;
    for (const Marker &marker : layout.markers)
        points.push_back(marker.pointInWorld);
    return extentOf(points);
}

} // namespace

Message unitAdvice(double heightM)
{
    return joined({ODO_TEXT("calibration.check_unit", "check the unit of the layout"), likelyUnit(heightM)},
                  Join::Colon);
}

Message lensWords(const Intrinsics &lens)
{
    const MessageArgument focal = quantity(lens.fxPx, 0, "px");
    const MessageArgument sigma = quantity(std::sqrt(lens.covariance(0, 0)), 0);
    if (intrinsicsSourceOf(lens, false) == IntrinsicsSource::Assumed)
        return ODO_TEXT("calibration.lens_assumed",
                        "The lens is not calibrated, and the markers hardly determine it (focal length %1 ± "
                        "%2): what is not known of it is in the uncertainty.")(focal, sigma);
    return ODO_TEXT("calibration.lens_from_floor",
                    "The lens is not calibrated: focal length (%1 ± %2) and distortion (k1 %3 ± %4) were "
                    "estimated from the markers.")(focal, sigma, quantity(lens.distortion[0], 3),
                                                   quantity(std::sqrt(lens.covariance(4, 4)), 3));
}

Message registrationWords(const RegistrationFacts &facts)
{
    const FloorRegistration &registration = facts.registration;
    const double layoutM = extentM(facts.layout);
    const double sigmaM = std::max(registration.floorSigmaM, largestOver(facts.view, facts.layout, 0));
    const auto worst = std::ranges::max_element(registration.markers, {}, &MarkerError::errorM);
    Message fit =
        ODO_TEXT("calibration.markers_fit", "%1 markers fit to %2 RMS (worst %3, %4); floor uncertainty ±%5")(
            registration.markers.size(), millimetres(registration.rmsM), Named::marker(worst->label),
            millimetres(worst->errorM), millimetres(sigmaM));
    Message hardly;
    if (registration.markers.size() == 4)
        hardly = hardlyChecked(
            ODO_TEXT("calibration.four_markers_unchecked", "Four markers are too few to check each other"));
    const bool mirrored = mayBeMirrored(facts.tried, facts.pose);
    return joined(
        {mirrored ? uncertainVerdict(std::move(fit)) : levelled(facts, sigmaM, layoutM, std::move(fit)),
         mirrored ? mirrorWords() : Message(), facts.residuals.words, otherCameraWords(facts.tried),
         std::move(hardly), beyondWords(facts, sigmaM, layoutM),
         facts.estimatedLens ? estimatedLensWords(*facts.estimatedLens, registration.markers.size())
                             : Message(),
         unitWords(registration, layoutM)},
        Join::Space);
}

} // namespace odo
