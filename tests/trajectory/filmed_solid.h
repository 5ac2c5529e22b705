// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "tests/trajectory/synthetic_trial.h"

#include <Eigen/Eigenvalues>
#include <string>

namespace odo::test {

inline Ellipse ellipseOf(const RegionMoments &moments)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(moments.covariancePx2);
    const Eigen::Vector2d axis = solver.eigenvectors().col(1);
    return {moments.centrePx, 2 * std::sqrt(solver.eigenvalues()[1]), 2 * std::sqrt(solver.eigenvalues()[0]),
            std::atan2(axis.y(), axis.x())};
}

inline double headingOf(const Truth &truth)
{
    return truth.headingRad.value_or(std::atan2(truth.velocity.y(), truth.velocity.x()));
}

/// What a view sees of a solid that runs a course with its length ahead.
inline ViewTrack filmSolid(const std::string &name, const FloorView &view, const SolidShape &shape,
                           const Course &course, double noisePx, std::mt19937 &random)
{
    FilmSettings settings;
    settings.noisePx = noisePx;
    ViewTrack track = film(name, view, course, settings, random);
    std::normal_distribution<double> noise(0, noisePx);
    for (Observation &observation : track.observations) {
        const Truth truth = course(toSeconds(observation.time));
        const auto moments = silhouetteMoments(view, shape, truth.position, headingOf(truth));
        observation.ellipse = ellipseOf(*moments);
        observation.ellipse.centrePx += Eigen::Vector2d(noise(random), noise(random));
        observation.ellipse.semiMajorPx += noise(random);
        observation.ellipse.semiMinorPx += noise(random);
        observation.areaPx = moments->areaPx2 * (1 + 0.02 * noise(random));
    }
    return track;
}

/// The same with the support of each outline, as it is measured of a silhouette.
inline ViewTrack filmSilhouette(const std::string &name, const FloorView &view, const SolidShape &shape,
                                const Course &course, double noisePx, std::mt19937 &random)
{
    ViewTrack track = filmSolid(name, view, shape, course, noisePx, random);
    std::normal_distribution<double> noise(0, noisePx);
    for (Observation &observation : track.observations) {
        const Truth truth = course(toSeconds(observation.time));
        observation.supportPx =
            *silhouetteSupport(view, shape, truth.position, headingOf(truth), observation.ellipse.centrePx);
        for (float &reach : observation.supportPx)
            reach += float(noise(random));
    }
    return track;
}

/// The same of the convex hull of some points, which need not be a solid of levels. Robot's frame, metres.
inline ViewTrack filmHull(const std::string &name, const FloorView &view,
                          const std::vector<Eigen::Vector3d> &body, const Course &course, double noisePx,
                          std::mt19937 &random)
{
    ViewTrack track = film(name, view, course, {}, random);
    std::normal_distribution<double> noise(0, noisePx);
    for (Observation &observation : track.observations) {
        const Truth truth = course(toSeconds(observation.time));
        const Eigen::AngleAxisd turn(headingOf(truth), Eigen::Vector3d::UnitZ());
        std::vector<Eigen::Vector2d> points;
        for (const Eigen::Vector3d &point : body)
            points.push_back(*view.pixelFromWorld(
                turn * point + Eigen::Vector3d(truth.position.x(), truth.position.y(), 0)));
        const RegionMoments moments = polygonMoments(convexHull(points));
        observation.ellipse = ellipseOf(moments);
        observation.ellipse.centrePx += Eigen::Vector2d(noise(random), noise(random));
        observation.areaPx = moments.areaPx2;
        observation.supportPx = supportOf(points, observation.ellipse.centrePx);
        for (float &reach : observation.supportPx)
            reach += float(noise(random));
    }
    return track;
}

} // namespace odo::test
