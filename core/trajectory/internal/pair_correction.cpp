// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/pair_correction.h"

#include "core/base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace odo {

Eigen::Vector2d turnedOnPlane(const Eigen::Vector3d &cameraInWorld, const Eigen::Vector3d &rotation,
                              const Eigen::Vector2d &position, double planeM)
{
    const double angle = rotation.norm();
    if (angle == 0)
        return position;
    const Eigen::Vector3d ray = Eigen::AngleAxisd(angle, rotation / angle) *
                                (Eigen::Vector3d(position.x(), position.y(), planeM) - cameraInWorld);
    const Eigen::Vector3d at = cameraInWorld + ray * ((planeM - cameraInWorld.z()) / ray.z());
    return at.head<2>();
}

std::vector<ViewTrack> correctedViews(const ViewTrack &a, const ViewTrack &b,
                                      const PairCorrection &correction)
{
    std::vector<ViewTrack> views{a, b};
    views[1].startOffset -= fromSeconds(correction.laterS - correction.laterPerS * correction.aboutS);
    views[1].clockRate += correction.laterPerS;
    const std::array turns{correction.turnA, correction.turnB};
    for (std::size_t v = 0; v < turns.size(); ++v) {
        if (turns[v].isZero())
            continue;
        if (correction.since) {
            views.push_back(views[v]);
            for (std::size_t before = 0; before < 2; ++before)
                for (Observation &one : before == 1 ? views.back().observations : views[v].observations)
                    one.found = one.found && (timeOf(views[v], one) < *correction.since) == (before == 1);
        }
        RigidTransform pose = views[v].floorView->worldFromCamera();
        pose.rotation = Eigen::AngleAxisd(turns[v].norm(), turns[v].normalized()) * pose.rotation;
        views[v].floorView =
            FloorView(views[v].floorView->camera(), pose, views[v].floorView->poseCovariance());
    }
    return views;
}

namespace {

/// At times so much later; between two that are seen.
std::vector<Sighting> shifted(const std::vector<Sighting> &sightings, const PairCorrection &correction)
{
    std::vector<Sighting> all = sightings;
    std::size_t right = 1;
    for (Sighting &one : all) {
        const double timeS = toSeconds(one.time),
                     wantedS = timeS - correction.laterS - correction.laterPerS * (timeS - correction.aboutS);
        while (right + 1 < sightings.size() && toSeconds(sightings[right].time) < wantedS)
            ++right;
        while (right > 1 && toSeconds(sightings[right - 1].time) > wantedS)
            --right;
        const Sighting &before = sightings[right - 1], &behind = sightings[right];
        const double share =
            (wantedS - toSeconds(before.time)) / std::max(1e-9, toSeconds(behind.time - before.time));
        const bool isBetween = before.seen && behind.seen && share >= 0 && share <= 1;
        const Nanoseconds time = one.time;
        one = share < 0.5 ? before : behind;
        one.time = time;
        one.seen = isBetween;
        if (isBetween)
            one.position.pointInWorld =
                (1 - share) * before.position.pointInWorld + share * behind.position.pointInWorld;
    }
    return all;
}

} // namespace

std::vector<std::vector<Sighting>> withoutCorrection(std::vector<std::vector<Sighting>> corrected,
                                                     const FloorView &viewA, const FloorView &viewB,
                                                     const PairCorrection &correction, double planeM)
{
    const std::array turns{std::pair(&viewA, correction.turnA), std::pair(&viewB, correction.turnB)};
    std::size_t earlier = turns.size();
    for (std::size_t v = 0; v < turns.size(); ++v) {
        const auto &[view, turn] = turns[v];
        if (turn.isZero())
            continue;
        for (Sighting &one : corrected[v])
            one.position.pointInWorld =
                turnedOnPlane(view->cameraInWorld(), -turn, one.position.pointInWorld, planeM);
        if (!correction.since)
            continue;
        for (std::size_t i = 0; i < corrected[v].size(); ++i)
            if (corrected[v][i].time < *correction.since)
                corrected[v][i] = corrected[earlier][i];
        ++earlier;
    }
    corrected.resize(turns.size());
    if ((correction.laterS != 0 || correction.laterPerS != 0) && corrected[1].size() > 1)
        corrected[1] = shifted(corrected[1], correction);
    return corrected;
}

} // namespace odo
