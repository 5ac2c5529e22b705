// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/spike_flags.h"
#include "core/trajectory/internal/track_profile.h"

#include "tests/trajectory/synthetic_trial.h"

namespace odo::test {

/// One run's samples and points.
struct Run
{
    std::vector<Sample> samples;
    std::vector<ProfilePoint> points;
};

/// A course as a profile without error, with a stated σ of the track and of the calibration.
inline Run exactly(const Course &course, double durationS, double sigmaM = 0,
                   Eigen::Matrix2d common = Eigen::Matrix2d::Zero(), double framesPerSecond = 30)
{
    Run run;
    for (int i = 0; i <= durationS * framesPerSecond; ++i) {
        Sample sample;
        sample.frame = i;
        sample.time = fromSeconds(i / framesPerSecond);
        const Truth truth = course(i / framesPerSecond);
        sample.position = truth.position;
        sample.covariance = Eigen::Matrix2d::Identity() * sigmaM * sigmaM;
        sample.commonCovariance = common;
        MotionEstimate estimate;
        estimate.mean << truth.position, truth.velocity, truth.acceleration;
        estimate.covariance.setIdentity();
        estimate.covariance *= sigmaM * sigmaM;
        run.samples.push_back(sample);
        run.points.push_back(makePoint(estimate, common));
    }
    return run;
}

/// A course measured with noise, flagged and smoothed as the analysis does it.
inline Run smoothed(const Course &course, double durationS, double sigmaM, std::mt19937 &random)
{
    Run run = exactly(course, durationS, sigmaM);
    std::normal_distribution<double> noise(0, sigmaM);
    for (Sample &sample : run.samples)
        *sample.position += Eigen::Vector2d(noise(random), noise(random));
    const SpikeVerdict verdict = flagSpikes(run.samples, {});
    run.points = makePoints(run.samples, verdict.changes, {}, verdict.noise);
    return run;
}

} // namespace odo::test
