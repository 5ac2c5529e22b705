// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"

#include <cmath>
#include <functional>
#include <optional>
#include <random>

namespace odo::test {

/// Exact motion of a robot's centre.
struct Truth
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero(),
                    acceleration = Eigen::Vector2d::Zero();
    std::optional<double> headingRad = {}; ///< of its body; empty: it drives ahead
};
using Course = std::function<Truth(double timeS)>;

/// x = a·sin ωt, y = b·sin 2ωt.
inline Course figureEight(double a, double b, double periodS)
{
    return [=](double t) {
        const double w = 2 * M_PI / periodS;
        Truth truth;
        truth.position = {a * std::sin(w * t), b * std::sin(2 * w * t)};
        truth.velocity = {a * w * std::cos(w * t), 2 * b * w * std::cos(2 * w * t)};
        truth.acceleration = {-a * w * w * std::sin(w * t), -4 * b * w * w * std::sin(2 * w * t)};
        return truth;
    };
}

/// Rests, accelerates evenly along +x up to a speed, and keeps it.
inline Course hardStart(double startS, double accelMps2, double speedMps)
{
    return [=](double t) {
        const double ramp = speedMps / accelMps2, run = std::max(0.0, t - startS);
        Truth truth;
        truth.position.x() = -1 + (run < ramp ? accelMps2 * run * run / 2
                                              : accelMps2 * ramp * ramp / 2 + speedMps * (run - ramp));
        truth.velocity.x() = std::min(accelMps2 * run, speedMps);
        truth.acceleration.x() = run > 0 && run < ramp ? accelMps2 : 0;
        return truth;
    };
}

inline FloorView
cameraLookingAt(Eigen::Vector3d place, Eigen::Vector3d target,
                const Eigen::Matrix<double, 6, 6> &poseCovariance = Eigen::Matrix<double, 6, 6>::Zero())
{
    Intrinsics lens;
    lens.widthPx = 1280;
    lens.heightPx = 720;
    lens.fxPx = lens.fyPx = 950;
    lens.cxPx = 639.5;
    lens.cyPx = 359.5;
    Eigen::Matrix3d axes;
    axes.col(2) = (target - place).normalized();
    axes.col(0) = axes.col(2).cross(Eigen::Vector3d::UnitZ()).normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return FloorView(*CameraModel::create(lens), {Eigen::Quaterniond(axes), place}, poseCovariance);
}

/// Two oblique cameras 2 m high on neighbouring sides of a floor of some 3 m × 3 m.
inline FloorView cameraA()
{
    return cameraLookingAt({-2.2, -2.6, 2}, {0, 0, 0});
}
inline FloorView cameraB()
{
    return cameraLookingAt({2.6, -2.2, 2}, {0, 0, 0});
}
inline FloorView cameraC()
{
    return cameraLookingAt({0.3, 3.2, 2}, {0, 0, 0});
}

struct FilmSettings
{
    double framesPerSecond = 30;
    double durationS = 10;
    double startS = 0;    ///< of the first frame on the course's clock
    double planeM = 0.03; ///< height of the point that is seen
    double noisePx = 0.3;
    double jitterS = 0;  ///< the frame times scatter evenly by ± this
    double driftPpm = 0; ///< the view's clock runs faster than the course's by this
};

/// What a view sees of a course: pixels of the robot's centre with white noise and its true covariance.
inline ViewTrack film(const std::string &name, const FloorView &view, const Course &course,
                      const FilmSettings &settings, std::mt19937 &random)
{
    ViewTrack track{name, view, fromSeconds(settings.startS), {}};
    std::normal_distribution<double> noise(0, 1);
    std::uniform_real_distribution<double> jitter(-1, 1);
    const auto count = static_cast<int>(settings.durationS * settings.framesPerSecond);
    for (int i = 0; i < count; ++i) {
        Observation observation;
        observation.frame = i;
        const double t = i / settings.framesPerSecond + (i > 0 ? settings.jitterS * jitter(random) : 0);
        observation.time = fromSeconds(t);
        const Truth truth = course(settings.startS + t / (1 + settings.driftPpm * 1e-6));
        const auto pixel = view.pixelFromWorld({truth.position.x(), truth.position.y(), settings.planeM});
        observation.found = pixel.has_value();
        if (pixel) {
            observation.ellipse.centrePx =
                *pixel + settings.noisePx * Eigen::Vector2d(noise(random), noise(random));
            observation.ellipse.semiMajorPx = 40;
            observation.ellipse.semiMinorPx = 25;
            observation.areaPx = 3000;
        }
        const double sigma = std::max(settings.noisePx, 1e-3);
        observation.centreCovariancePx2 = Eigen::Matrix2d::Identity() * sigma * sigma;
        observation.score = 0.9;
        track.observations.push_back(observation);
    }
    return track;
}

/// Root mean square errors over the valid points.
struct Errors
{
    double positionM = 0, velocityMps = 0, accelMps2 = 0;
    int points = 0;
};

inline Errors errorsOf(const Profile &profile, const Course &course)
{
    Errors errors;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        if (!point.valid)
            continue;
        const Truth truth = course(toSeconds(profile.samples[i].time));
        errors.positionM += (point.position - truth.position).squaredNorm();
        errors.velocityMps += (point.velocity - truth.velocity).squaredNorm();
        errors.accelMps2 += (point.acceleration - truth.acceleration).squaredNorm();
        ++errors.points;
    }
    errors.positionM = std::sqrt(errors.positionM / errors.points);
    errors.velocityMps = std::sqrt(errors.velocityMps / errors.points);
    errors.accelMps2 = std::sqrt(errors.accelMps2 / errors.points);
    return errors;
}

} // namespace odo::test
