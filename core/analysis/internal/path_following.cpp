// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/internal/path_following.h"

#include "core/analysis/gate_passages.h"
#include "core/analysis/motion_stretches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr double jumpPriceM3 = 0.5 * 0.1 * 0.1;
constexpr double jumpPriceM = 2; // times the square of the way that nothing explains, up to the price above
constexpr double freeStepM = 0.005;
constexpr std::size_t mostFeet = 8;

/// The straight pieces of a path with the station that each begins at.
class Pieces
{
public:
    explicit Pieces(const ReferencePath &path) : m_closed(path.closed)
    {
        const auto &points = path.points;
        for (std::size_t i = 0; i + (path.closed ? 0 : 1) < points.size(); ++i) {
            const Eigen::Vector2d way = points[(i + 1) % points.size()] - points[i];
            if (way.norm() <= 0)
                continue;
            m_pieces.push_back({points[i], way.normalized(), way.norm(), m_lengthM});
            m_lengthM += way.norm();
        }
    }

    double lengthM() const { return m_lengthM; }

    /// The feet of perpendiculars from a point that are nearer than those beside them, the nearest first.
    std::vector<PathPosition> feetOf(const Eigen::Vector2d &point)
    {
        const std::size_t count = m_pieces.size();
        m_squares.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            m_squares[i] = (point - m_pieces[i].at(m_pieces[i].nearest(point))).squaredNorm();
        std::vector<std::size_t> near;
        for (std::size_t i = 0; i < count; ++i) {
            const bool first = i == 0 && !m_closed, last = i + 1 == count && !m_closed;
            if ((first || m_squares[i] < m_squares[(i + count - 1) % count]) &&
                (last || m_squares[i] <= m_squares[(i + 1) % count]))
                near.push_back(i);
        }
        if (near.empty()) // all are equally far
            near.push_back(0);
        std::sort(near.begin(), near.end(),
                  [&](std::size_t a, std::size_t b) { return m_squares[a] < m_squares[b]; });
        near.resize(std::min(near.size(), mostFeet));
        std::vector<PathPosition> feet;
        for (const std::size_t i : near)
            feet.push_back(footOn(i, point));
        return feet;
    }

    /// How far it is along the path from one station to another, forwards positive; round a closed path the
    /// shorter way.
    double between(double from, double to) const
    {
        return m_closed ? std::remainder(to - from, m_lengthM) : to - from;
    }

private:
    struct Piece
    {
        Eigen::Vector2d start, direction;
        double lengthM, stationM;

        double nearest(const Eigen::Vector2d &point) const
        {
            return std::clamp(direction.dot(point - start), 0.0, lengthM);
        }
        Eigen::Vector2d at(double alongM) const { return start + alongM * direction; }
    };

    PathPosition footOn(std::size_t i, const Eigen::Vector2d &point) const
    {
        const Piece &piece = m_pieces[i];
        const double alongM = piece.nearest(point);
        const Eigen::Vector2d apart = point - piece.at(alongM);
        const Eigen::Vector2d left(-piece.direction.y(), piece.direction.x());
        PathPosition place;
        place.stationM = piece.stationM + alongM;
        // At a corner the perpendicular is that of neither piece.
        const bool aside = apart.norm() > 0 && (alongM <= 0 || alongM >= piece.lengthM);
        const double sign = left.dot(apart) < 0 ? -1 : 1;
        place.left = aside ? Eigen::Vector2d(sign * apart.normalized()) : left;
        place.offsetM = sign * apart.norm();
        const double reach = piece.direction.dot(point - piece.start);
        place.beyondEnd =
            !m_closed && ((i == 0 && reach < 0) || (i + 1 == m_pieces.size() && reach > piece.lengthM));
        return place;
    }

    std::vector<Piece> m_pieces;
    double m_lengthM = 0;
    bool m_closed;
    std::vector<double> m_squares;
};

/// A foot with the cheapest way to it.
struct Node
{
    PathPosition place;
    double cost = 0;
    std::size_t from = 0;
};

double priceOfStep(const Pieces &pieces, const PathPosition &from, const PathPosition &to, double drivenM)
{
    // On the inside of a bend the station runs ahead of the robot.
    const double unexplained =
        std::max(0.0, std::abs(pieces.between(from.stationM, to.stationM)) - 2 * drivenM - freeStepM);
    return std::min(jumpPriceM3, jumpPriceM * unexplained * unexplained);
}

void reach(const Pieces &pieces, const std::vector<Node> &before, Node &node, double drivenM)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < before.size(); ++k) {
        const double price = priceOfStep(pieces, before[k].place, node.place, drivenM);
        if (before[k].cost + price >= least)
            continue;
        least = before[k].cost + price;
        node.from = k;
        node.place.jumped = price >= jumpPriceM3;
    }
    node.cost = least + std::pow(node.place.offsetM, 2) * drivenM;
}

} // namespace

double lengthOf(const ReferencePath &path)
{
    return Pieces(path).lengthM();
}

std::vector<PathPosition> followPath(const ReferencePath &path,
                                     const std::vector<MeasuredPosition> &positions)
{
    Pieces pieces(path);
    std::vector<std::vector<Node>> steps;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        std::vector<Node> nodes;
        for (const PathPosition &foot : pieces.feetOf(positions[i].point->position)) {
            Node node{foot, 0, 0};
            if (i > 0)
                reach(pieces, steps.back(), node,
                      (positions[i].point->position - positions[i - 1].point->position).norm());
            nodes.push_back(node);
        }
        steps.push_back(std::move(nodes));
    }
    std::vector<PathPosition> followed(positions.size());
    if (positions.empty())
        return followed;
    const auto cheaper = [](const Node &a, const Node &b) { return a.cost < b.cost; };
    auto at = static_cast<std::size_t>(std::min_element(steps.back().begin(), steps.back().end(), cheaper) -
                                       steps.back().begin());
    for (std::size_t i = positions.size(); i-- > 0;) {
        followed[i] = steps[i][at].place;
        at = steps[i][at].from;
    }
    return followed;
}

double completedShare(const ReferencePath &path, const std::vector<PathPosition> &followed)
{
    constexpr auto marks = static_cast<std::size_t>(1 / completedResolution);
    const Pieces pieces(path);
    std::vector<bool> passed(marks);
    for (std::size_t i = 1; i < followed.size(); ++i) {
        if (followed[i].jumped)
            continue;
        const double from = followed[i - 1].stationM, step = pieces.between(from, followed[i].stationM);
        const double low = std::min(from, from + step) / pieces.lengthM() * marks;
        const double high = std::max(from, from + step) / pieces.lengthM() * marks;
        // A mark is passed when its middle is.
        for (double mark = std::ceil(low - 0.5); mark + 0.5 <= high; mark += 1)
            passed[static_cast<std::size_t>(static_cast<long>(mark) + static_cast<long>(marks)) % marks] =
                true;
    }
    return static_cast<double>(std::count(passed.begin(), passed.end(), true)) / marks;
}

namespace {

constexpr double slowestMps = 1e-3; // a position that hardly moves does not determine its time

/// A position with respect to the path, which continues straight beyond the ends of an open one.
struct Foot
{
    double stationM = 0, offsetM = 0;
    Eigen::Vector2d along;
};

Foot footOf(const ReferencePath &path, double lengthM, const PathPosition &place,
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
    const std::vector<MeasuredPosition> positions = measuredPositions(samples, points);
    const std::vector<PathPosition> followed = followPath(path, positions);
    const double lengthM = lengthOf(path);
    std::vector<PathProgress> progress;
    double stationM = 0, pathM = 0; // of the position before
    bool joined = false;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const ProfilePoint &point = *positions[i].point;
        const Foot foot = footOf(path, lengthM, followed[i], point.position);
        if (i == 0)
            pathM = foot.stationM;
        else
            pathM +=
                path.closed ? std::remainder(foot.stationM - stationM, lengthM) : foot.stationM - stationM;
        stationM = foot.stationM;
        joined = joined && positions[i].joined && !followed[i].jumped;
        if (std::abs(foot.offsetM) > reachM) {
            joined = false;
            continue;
        }
        progress.push_back({positions[i].timeS, pathM, foot.along.dot(point.velocity),
                            sigmaAlong(positions[i].own, foot.along),
                            sigmaAlong(positions[i].common, foot.along), point.speedMps, point.sigmaSpeedMps,
                            foot.offsetM, joined});
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
        const double startM = hasStep ? progress[i - 1].pathM : here.pathM;
        const double fromM = std::max(furthestM.value_or(startM), startM);
        if (hasStep && here.pathM > fromM)
            m_steps.push_back({fromM, here.pathM, progress[i - 1], here});
        furthestM = std::max(furthestM.value_or(here.pathM), here.pathM);
    }
}

const FirstArrivals::Step *FirstArrivals::stepAt(double pathM) const
{
    const auto step = std::lower_bound(m_steps.begin(), m_steps.end(), pathM,
                                       [](const Step &each, double wanted) { return each.toM < wanted; });
    return step == m_steps.end() || pathM < step->fromM ? nullptr : &*step;
}

double FirstArrivals::partAt(const Step &step, double pathM)
{
    const double stepS = step.after.timeS - step.before.timeS;
    if (step.before.pathM >= pathM || step.after.pathM <= pathM) // at one of the two positions
        return step.before.pathM >= pathM ? 0 : 1;
    return CubicStep{step.before.pathM - pathM, step.after.pathM - pathM, step.before.rateMps,
                     step.after.rateMps, stepS}
        .root();
}

std::optional<double> FirstArrivals::timeAt(double pathM) const
{
    const Step *step = stepAt(pathM);
    if (!step)
        return std::nullopt;
    return mix(step->before.timeS, step->after.timeS, partAt(*step, pathM));
}

double FirstArrivals::sigmaOf(double timeS, double pathM, double sigmaM, double rateMps) const
{
    if (sigmaM <= 0)
        return 0;
    const auto sooner = timeAt(pathM - sigmaM), later = timeAt(pathM + sigmaM);
    if (sooner && later)
        return (*later - *sooner) / 2;
    if (sooner || later)
        return sooner ? timeS - *sooner : *later - timeS;
    return sigmaM / std::max(slowestMps, rateMps);
}

std::optional<Arrival> FirstArrivals::at(double pathM) const
{
    const Step *step = stepAt(pathM);
    if (!step)
        return std::nullopt;
    const PathProgress &a = step->before, &b = step->after;
    const double part = partAt(*step, pathM), rate = mix(a.rateMps, b.rateMps, part);
    Arrival arrival;
    arrival.timeS = mix(a.timeS, b.timeS, part);
    arrival.ownSigmaS = sigmaOf(arrival.timeS, pathM, mix(a.ownSigmaM, b.ownSigmaM, part), rate);
    arrival.commonSigmaS = sigmaOf(arrival.timeS, pathM, mix(a.commonSigmaM, b.commonSigmaM, part), rate);
    arrival.speedMps = mix(a.speedMps, b.speedMps, part);
    arrival.sigmaSpeedMps = mix(a.sigmaSpeedMps, b.sigmaSpeedMps, part);
    arrival.offsetM = mix(a.offsetM, b.offsetM, part);
    return arrival;
}

std::string_view alignByWord(AlignBy by)
{
    switch (by) {
    case AlignBy::StartGate:
        return "start_gate";
    case AlignBy::MotionOnset:
        return "motion_onset";
    case AlignBy::Distance:
        return "distance";
    case AlignBy::ByHand:
        break;
    }
    return "hand";
}

std::optional<AlignedMoment> startGateMoment(const Task &task, const std::vector<Sample> &samples,
                                             const std::vector<ProfilePoint> &points)
{
    const auto start = std::find_if(task.gates.begin(), task.gates.end(), [](const Gate &gate) {
        return gate.role == GateRole::Start || gate.role == GateRole::StartFinish;
    });
    if (start == task.gates.end())
        return std::nullopt;
    const std::vector<GatePassage> passages = findPassages({*start}, samples, points);
    if (passages.empty())
        return std::nullopt;
    const GatePassage &first = passages.front();
    const double own = std::sqrt(std::max(0.0, std::pow(first.sigmaS, 2) - std::pow(first.commonSigmaS, 2)));
    return AlignedMoment{toSeconds(first.time), own, first.commonSigmaS};
}

std::optional<AlignedMoment> onsetMoment(const std::vector<Sample> &samples,
                                         const std::vector<ProfilePoint> &points)
{
    const std::vector<RunInstant> instants = validInstants(samples, points);
    const std::vector<MotionStretch> motions = findMotions(instants);
    if (motions.empty() || motions.front().first == 0)
        return std::nullopt;
    return AlignedMoment{motions.front().startS, sigmaOfMoment(instants, motions.front().first), 0};
}

AlignedMoment handMoment(double timeS, const std::vector<Sample> &samples)
{
    if (samples.size() < 2)
        return {timeS, 0, 0};
    const double wholeS = toSeconds(samples.back().time - samples.front().time);
    return {timeS, wholeS / static_cast<double>(samples.size() - 1) / std::sqrt(12.0), 0};
}

std::optional<double> firstMotionS(const std::vector<Sample> &samples,
                                   const std::vector<ProfilePoint> &points)
{
    const std::vector<MotionStretch> motions = findMotions(validInstants(samples, points));
    if (motions.empty())
        return std::nullopt;
    return motions.front().startS;
}

namespace {

constexpr double leastStepM = 0.005;
constexpr double closingShare = 0.05, leastClosingM = 0.03; // of the extent: how near to its start a lap ends
constexpr double sameDirection = 0.707;                     // cosine of 45°

/// Where the first lap ends: nearest to the start after having been far from it; 0: it never comes back.
std::size_t endOfLap(const std::vector<Eigen::Vector2d> &points, double extentM)
{
    const auto away = [&](std::size_t i) { return (points[i] - points.front()).norm(); };
    const auto direction = [&](std::size_t i) { return (points[i + 1] - points[i]).normalized(); };
    bool wasFar = false;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        wasFar = wasFar || away(i) > extentM / 2;
        const bool isBack = wasFar && away(i) < std::max(leastClosingM, closingShare * extentM);
        if (isBack && away(i) <= away(i + 1) && direction(i).dot(direction(0)) > sameDirection)
            return i;
    }
    return 0;
}

} // namespace

double extentOf(const ReferencePath &path)
{
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d &point : path.points)
        box.extend(point);
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

ReferencePath pathOfRun(const std::vector<Sample> &samples, const std::vector<ProfilePoint> &points)
{
    const std::vector<RunInstant> instants = validInstants(samples, points);
    const std::vector<MotionStretch> motions = findMotions(instants);
    ReferencePath path;
    if (motions.empty())
        return path;
    for (std::size_t i = motions.front().first; i <= motions.back().last; ++i) {
        const Eigen::Vector2d &place = instants[i].point->position;
        if (path.points.empty() || (place - path.points.back()).norm() >= leastStepM)
            path.points.push_back(place);
    }
    if (path.points.size() < 2)
        return {};
    if (const std::size_t end = endOfLap(path.points, extentOf(path)); end > 0) {
        path.points.resize(end); // the straight piece back to the start takes the place of the last step
        path.closed = true;
    }
    return path;
}

ReferencePath reversed(ReferencePath path)
{
    std::reverse(path.points.begin() + (path.closed ? 1 : 0), path.points.end());
    return path;
}

} // namespace odo
