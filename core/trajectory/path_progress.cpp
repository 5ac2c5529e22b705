// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/path_progress.h"

#include "core/trajectory/cubic_step.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double slowestMps = 1e-3; // a place that hardly moves says nothing of its time

/// A place with respect to the path, which goes on straight beyond the ends of an open one.
struct Foot
{
    double stationM = 0, offsetM = 0;
    Eigen::Vector2d along;
};

Foot footOf(const ReferencePath &path, double lengthM, const PathPlace &place,
            const Eigen::Vector2d &position)
{
    if (!place.beyondEnd)
        return {place.stationM, place.offsetM, {place.left.y(), -place.left.x()}};
    const std::vector<Eigen::Vector2d> &points = path.points;
    const bool before = place.stationM < lengthM / 2;
    const Eigen::Vector2d end = before ? points.front() : points.back();
    const Eigen::Vector2d along = (before ? points[1] - end : end - points[points.size() - 2]).normalized();
    const Eigen::Vector2d apart = position - end;
    return {place.stationM + along.dot(apart), along.x() * apart.y() - along.y() * apart.x(), along};
}

double mix(double a, double b, double part)
{
    return a + part * (b - a);
}

} // namespace

std::vector<PathProgress> progressAlong(const ReferencePath &path, const std::vector<Sample> &samples,
                                        const std::vector<ProfilePoint> &points, double reachM)
{
    const std::vector<MeasuredPlace> places = measuredPlaces(samples, points);
    const std::vector<PathPlace> followed = followPath(path, places);
    const double lengthM = lengthOf(path);
    std::vector<PathProgress> progress;
    double stationM = 0, wayM = 0; // of the place before
    bool joined = false;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ProfilePoint &point = *places[i].point;
        const Foot foot = footOf(path, lengthM, followed[i], point.position);
        if (i == 0)
            wayM = foot.stationM;
        else
            wayM +=
                path.closed ? std::remainder(foot.stationM - stationM, lengthM) : foot.stationM - stationM;
        stationM = foot.stationM;
        joined = joined && places[i].joined && !followed[i].jumped;
        if (std::abs(foot.offsetM) > reachM) {
            joined = false;
            continue;
        }
        progress.push_back({places[i].timeS, wayM, foot.along.dot(point.velocity),
                            sigmaAlong(places[i].own, foot.along), sigmaAlong(places[i].common, foot.along),
                            point.speedMps, point.sigmaSpeedMps, foot.offsetM, joined});
        joined = true;
    }
    return progress;
}

double Arrival::sigmaS() const
{
    return std::hypot(ownSigmaS, commonSigmaS);
}

FirstArrivals::FirstArrivals(const std::vector<PathProgress> &progress, double fromS)
{
    std::optional<double> furthestM;
    for (std::size_t i = 0; i < progress.size(); ++i) {
        const PathProgress &here = progress[i];
        if (here.timeS < fromS)
            continue;
        const bool hasStep = i > 0 && here.joined && here.timeS > progress[i - 1].timeS;
        const double startM = hasStep ? progress[i - 1].wayM : here.wayM;
        const double fromM = std::max(furthestM.value_or(startM), startM);
        if (hasStep && here.wayM > fromM)
            m_steps.push_back({fromM, here.wayM, progress[i - 1], here});
        furthestM = std::max(furthestM.value_or(here.wayM), here.wayM);
    }
}

const FirstArrivals::Step *FirstArrivals::stepAt(double wayM) const
{
    const auto step = std::lower_bound(m_steps.begin(), m_steps.end(), wayM,
                                       [](const Step &each, double wanted) { return each.toM < wanted; });
    return step == m_steps.end() || wayM < step->fromM ? nullptr : &*step;
}

double FirstArrivals::partAt(const Step &step, double wayM)
{
    const double stepS = step.after.timeS - step.before.timeS;
    if (step.before.wayM >= wayM || step.after.wayM <= wayM) // at one of the two places
        return step.before.wayM >= wayM ? 0 : 1;
    return CubicStep{step.before.wayM - wayM, step.after.wayM - wayM, step.before.rateMps, step.after.rateMps,
                     stepS}
        .root();
}

std::optional<double> FirstArrivals::timeAt(double wayM) const
{
    const Step *step = stepAt(wayM);
    if (!step)
        return std::nullopt;
    return mix(step->before.timeS, step->after.timeS, partAt(*step, wayM));
}

double FirstArrivals::sigmaOf(double timeS, double wayM, double sigmaM, double rateMps) const
{
    if (sigmaM <= 0)
        return 0;
    const auto sooner = timeAt(wayM - sigmaM), later = timeAt(wayM + sigmaM);
    if (sooner && later)
        return (*later - *sooner) / 2;
    if (sooner || later)
        return sooner ? timeS - *sooner : *later - timeS;
    return sigmaM / std::max(slowestMps, rateMps);
}

std::optional<Arrival> FirstArrivals::at(double wayM) const
{
    const Step *step = stepAt(wayM);
    if (!step)
        return std::nullopt;
    const PathProgress &a = step->before, &b = step->after;
    const double part = partAt(*step, wayM), rate = mix(a.rateMps, b.rateMps, part);
    Arrival arrival;
    arrival.timeS = mix(a.timeS, b.timeS, part);
    arrival.ownSigmaS = sigmaOf(arrival.timeS, wayM, mix(a.ownSigmaM, b.ownSigmaM, part), rate);
    arrival.commonSigmaS = sigmaOf(arrival.timeS, wayM, mix(a.commonSigmaM, b.commonSigmaM, part), rate);
    arrival.speedMps = mix(a.speedMps, b.speedMps, part);
    arrival.sigmaSpeedMps = mix(a.sigmaSpeedMps, b.sigmaSpeedMps, part);
    arrival.offsetM = mix(a.offsetM, b.offsetM, part);
    return arrival;
}

} // namespace odo
