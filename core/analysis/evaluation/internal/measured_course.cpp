// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/evaluation/internal/measured_course.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

double squareOf(double value)
{
    return value * value;
}

} // namespace

MeasuredCourse::MeasuredCourse(const Profile &profile)
{
    const std::vector<double> travelled = distanceTravelled(profile.samples, profile.points);
    double acrossGapsM = 0;
    for (const RunInstant &instant : validInstants(profile.samples, profile.points)) {
        if (!instant.measured)
            continue;
        const bool isFirst = m_instants.empty();
        const bool begins = !isFirst && (!instant.joined || instant.bridgedS > 0);
        if (!isFirst && !instant.joined)
            acrossGapsM += distanceBetween(m_instants.back(), instant);
        m_pieces.push_back(isFirst ? 0 : m_pieces.back() + (begins ? 1 : 0));
        m_travelledM.push_back(travelled[std::size_t(instant.point - profile.points.data())] + acrossGapsM);
        m_instants.push_back(instant);
    }
}

double MeasuredCourse::stepS() const
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < m_instants.size(); ++i)
        steps.push_back(m_instants[i].timeS - m_instants[i - 1].timeS);
    return steps.empty() ? 0 : upperMedian(std::move(steps));
}

bool MeasuredCourse::isJoined(std::size_t i) const
{
    return m_pieces[i] == m_pieces[i - 1];
}

std::optional<CoursePose> MeasuredCourse::at(double timeS) const
{
    const auto after = std::ranges::lower_bound(m_instants, timeS, {}, &RunInstant::timeS);
    if (after == m_instants.end())
        return std::nullopt;
    const auto i = std::size_t(after - m_instants.begin());
    const bool isAtInstant = after->timeS == timeS;
    if (!isAtInstant && (i == 0 || !isJoined(i)))
        return std::nullopt;
    const RunInstant &to = *after, &from = isAtInstant ? to : m_instants[i - 1];
    const double stepS = to.timeS - from.timeS;
    const double part = isAtInstant ? 1 : (timeS - from.timeS) / stepS;
    const auto mean = [&](double a, double b) { return (1 - part) * a + part * b; };
    CoursePose pose;
    if (isAtInstant) {
        pose.position = to.point->position;
        pose.velocity = to.point->velocity;
    } else {
        const CubicPath path(from, to);
        pose.position = {path.x.value(part), path.y.value(part)};
        pose.velocity = path.velocity(part);
    }
    const auto variance = [](const RunInstant &instant) {
        return squareOf(instant.point->sigmaXM) + squareOf(instant.point->sigmaYM);
    };
    pose.varianceM2 = mean(variance(from), variance(to));
    const double commonM2 = 2 * mean(squareOf(from.commonSigmaM), squareOf(to.commonSigmaM));
    pose.ownVarianceM2 = std::max(0.0, pose.varianceM2 - commonM2);
    pose.sigmaVelocityMps = mean(from.point->sigmaSpeedMps, to.point->sigmaSpeedMps);
    const auto &before = from.point->body, &behind = to.point->body;
    if (before && behind && before->isFrontKnown() && behind->isFrontKnown()) {
        pose.headingRad = isAtInstant ? behind->radians
                                      : CubicStep{before->radians, behind->radians, before->turnRateRadps,
                                                  behind->turnRateRadps, stepS}
                                            .value(part);
        pose.sigmaHeadingRad = mean(before->sigmaRad, behind->sigmaRad);
    }
    pose.piece = m_pieces[i];
    return pose;
}

double MeasuredCourse::travelledAt(double timeS) const
{
    const auto after = std::ranges::lower_bound(m_instants, timeS, {}, &RunInstant::timeS);
    const auto i = std::size_t(after - m_instants.begin());
    if (i == 0 || after->timeS == timeS)
        return m_travelledM[i];
    const double part = (timeS - m_instants[i - 1].timeS) / (after->timeS - m_instants[i - 1].timeS);
    return (1 - part) * m_travelledM[i - 1] + part * m_travelledM[i];
}

double MeasuredCourse::pathBetween(double fromS, double toS) const
{
    return travelledAt(toS) - travelledAt(fromS);
}

} // namespace odo
