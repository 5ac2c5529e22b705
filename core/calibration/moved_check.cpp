// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/moved_check.h"

#include "core/base/units.h"
#include "core/base/upper_median.h"
#include "core/calibration/mark_noise.h"
#include "core/calibration/marker_detection.h"
#include "core/calibration/marker_snap.h"
#include "core/calibration/tag_detection.h"
#include "core/calibration/wording.h"

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

} // namespace odo
