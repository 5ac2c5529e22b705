// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/track_frame.h"

#include "core/analysis/quantity_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// The direction of the first clear motion; 0 where there is none.
double firstDirection(const Profile &profile)
{
    for (const ProfilePoint &point : profile.points)
        if (const auto course = point.valid ? courseOf(point) : std::nullopt)
            return course->headingRad;
    return 0;
}

double turnedSigma(double along, double across, double cosine, double sine)
{
    return std::hypot(cosine * along, sine * across);
}

} // namespace

std::optional<TrackFrame> trackFrameFromWord(std::string_view word)
{
    if (word == "floor")
        return TrackFrame::Floor;
    if (word == "start")
        return TrackFrame::Start;
    return std::nullopt;
}

Profile inFrame(Profile profile, TrackFrame frame)
{
    const auto first = std::ranges::find_if(profile.points, &ProfilePoint::valid);
    if (frame == TrackFrame::Floor || first == profile.points.end())
        return profile;
    const Eigen::Vector2d origin = first->position;
    const Nanoseconds start = profile.samples[static_cast<std::size_t>(first - profile.points.begin())].time;
    const double direction = firstDirection(profile);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-direction).toRotationMatrix();
    const double cosine = std::cos(direction), sine = std::sin(direction);
    for (ProfilePoint &point : profile.points) {
        point.position = turn * (point.position - origin);
        point.velocity = turn * point.velocity;
        point.acceleration = turn * point.acceleration;
        const double sigmaX = turnedSigma(point.sigmaXM, point.sigmaYM, cosine, sine);
        point.sigmaYM = turnedSigma(point.sigmaYM, point.sigmaXM, cosine, sine);
        point.sigmaXM = sigmaX;
        if (point.body)
            point.body->radians -= direction;
    }
    for (Sample &sample : profile.samples) {
        sample.time -= start;
        if (sample.position)
            sample.position = turn * (*sample.position - origin);
        sample.covariance = turn * sample.covariance * turn.transpose();
        sample.commonCovariance = turn * sample.commonCovariance * turn.transpose();
        if (sample.heading)
            sample.heading->radians -= direction;
    }
    for (Spike &spike : profile.spikes)
        spike.time -= start;
    for (GatePassage &passage : profile.passages)
        passage.time -= start;
    for (TimeSpan &gap : profile.gaps) {
        gap.begin -= start;
        gap.end -= start;
    }
    return profile;
}

} // namespace odo
