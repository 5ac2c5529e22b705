// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/flash_synchronisation.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/synchronisation/internal/event_pairs.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

/// of the logarithm, from frame to frame: less is no part of an edge
constexpr double leastStep = 0.006;
constexpr double leastChange = 0.06; ///< of a whole edge
constexpr double stepSigmas = 5;     ///< times the usual step
constexpr double changeSigmas = 10;
constexpr double leastShare = 1.0 / 3; ///< of the frame
constexpr std::size_t mostSteps = 3;
constexpr double longestEdgeS = 0.12;
constexpr std::size_t plateauFrames = 3; ///< from which the level beside an edge is taken
/// fewer between two edges show the light between them in no complete frame
constexpr std::size_t peakFrames = 3;
constexpr double gamma = 2.2;
constexpr double meanExposure = 2.0 / 3,
                 exposureSigma = 0.24; ///< in frame intervals, of a frame taken during the change

/// Steps from frame first − 1 to frame last, all of one direction.
struct Run
{
    std::size_t first = 0, last = 0;
    double change = 0, share = 0;
};

std::vector<double> stepsOf(const std::vector<LightLevel> &levels)
{
    std::vector<double> steps(levels.size(), 0.0);
    for (std::size_t i = 1; i < levels.size(); ++i)
        steps[i] = std::log(levels[i].level / levels[i - 1].level);
    return steps;
}

/// σ of a usual step: noise, the beat of lamps, robots that pass.
double usualStep(const std::vector<double> &steps)
{
    std::vector<double> sizes;
    for (const double step : steps)
        sizes.push_back(std::abs(step));
    return 1.4826 * upperMedian(std::move(sizes));
}

std::vector<Run> runsOf(const std::vector<LightLevel> &levels, const std::vector<double> &steps, double least)
{
    std::vector<Run> runs;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        if (std::abs(steps[i]) < least)
            continue;
        const bool goesOn =
            !runs.empty() && runs.back().last + 1 == i && (runs.back().change > 0) == (steps[i] > 0);
        if (!goesOn)
            runs.push_back({i, i, 0, 0});
        runs.back().last = i;
        runs.back().change += steps[i];
        runs.back().share += levels[i].changedShare;
    }
    return runs;
}

class EdgeFinder
{
public:
    explicit EdgeFinder(const std::vector<LightLevel> &levels)
        : m_levels(levels), m_steps(stepsOf(levels)), m_usual(usualStep(m_steps)),
          m_runs(runsOf(levels, m_steps, std::max(leastStep, stepSigmas * m_usual)))
    {
    }

    std::vector<LightEdge> edges() const
    {
        std::vector<LightEdge> found;
        for (std::size_t r = 0; r < m_runs.size(); ++r) {
            if (isEdge(m_runs[r]))
                found.push_back(edgeOf(r));
        }
        return found;
    }

private:
    double timeS(std::size_t image) const { return toSeconds(m_levels[image].time); }

    bool isEdge(const Run &run) const
    {
        const bool quick =
            run.last - run.first < mostSteps || timeS(run.last) - timeS(run.first - 1) < longestEdgeS;
        const bool large = std::abs(run.change) > std::max(leastChange, changeSigmas * m_usual);
        const bool wide = std::abs(run.share) > leastShare && (run.share > 0) == (run.change > 0);
        return quick && large && wide;
    }

    /// Median level of the frames from `from` on, towards the clip's end or its start, no further than the
    /// next run.
    double plateau(std::size_t from, std::size_t until) const
    {
        std::vector<double> levels;
        const std::size_t count = std::min(plateauFrames, from > until ? from - until + 1 : until - from + 1);
        for (std::size_t i = 0; i < count; ++i)
            levels.push_back(m_levels[from > until ? from - i : from + i].level);
        return upperMedian(std::move(levels));
    }

    LightEdge edgeOf(std::size_t r) const
    {
        const Run &run = m_runs[r];
        const std::size_t before = run.first - 1;
        const std::size_t start = r > 0 ? m_runs[r - 1].last : 0,
                          end = r + 1 < m_runs.size() ? m_runs[r + 1].first - 1 : m_levels.size() - 1;
        const double from = plateau(before, std::min(start, before)), to = plateau(run.last, end);
        LightEdge edge{0, 0, run.change > 0, run.change};
        // The frames that show it half done, the frame intervals about them, and how far each is.
        double behindS = 0, uncertainS = 0, intervalS = timeS(run.last) - timeS(before);
        const std::size_t halfDone = run.last - run.first;
        for (std::size_t i = run.first; i < run.last; ++i) {
            const double coded = share(m_levels[i].level, from, to, 1),
                         light = share(m_levels[i].level, from, to, gamma);
            const double aboutS = (timeS(i + 1) - timeS(i - 1)) / 2;
            behindS += ((coded + light) / 2 - 0.5) * aboutS * (halfDone == 1 ? meanExposure : 1.0);
            uncertainS += std::abs(coded - light) / 2 * aboutS;
            if (halfDone == 1)
                uncertainS = std::hypot(uncertainS, exposureSigma * ((coded + light) / 2 - 0.5) * aboutS);
        }
        intervalS /= double(halfDone + 1);
        edge.timeS = (timeS(before) + timeS(run.last)) / 2 - behindS;
        const bool peak = (r > 0 && run.first - m_runs[r - 1].last < peakFrames) ||
                          (r + 1 < m_runs.size() && end + 1 - run.last < peakFrames);
        if (peak)
            edge.sigmaS = intervalS / std::sqrt(6.0);
        else if (halfDone == 0)
            edge.sigmaS = intervalS / std::sqrt(12.0);
        else
            edge.sigmaS = std::hypot(uncertainS, halfDone > 1 ? 0.1 * intervalS : 0.0);
        edge.sigmaS = std::hypot(edge.sigmaS, intervalS * m_usual / std::abs(run.change));
        return edge;
    }

    static double share(double level, double from, double to, double power)
    {
        const double low = std::pow(from, power), high = std::pow(to, power);
        return std::clamp((std::pow(level, power) - low) / (high - low), 0.0, 1.0);
    }

    const std::vector<LightLevel> &m_levels;
    const std::vector<double> m_steps;
    const double m_usual;
    const std::vector<Run> m_runs;
};

} // namespace

std::vector<LightEdge> findLightEdges(const std::vector<LightLevel> &levels)
{
    if (levels.size() < 2 * plateauFrames)
        return {};
    return EdgeFinder(levels).edges();
}

namespace {

constexpr double forAPair = 5.7;     ///< log-likelihood: ln 300
constexpr double againstAMiss = 2.3; ///< ln 10
constexpr double clearLead = 5;      ///< ln 150
constexpr double shutterSigma = 0.1; ///< of the frame interval
constexpr double toleranceSigmas = 4;
constexpr double usualRate = 2e-4;     ///< by which clocks may differ while edges are paired
constexpr std::size_t mostEdges = 200; ///< more is a flickering lamp, which gives no offset

/// What speaks for an offset, and against it.
struct Proposal
{
    double offsetS = 0;
    std::vector<EventPair> pairs;
    std::size_t missed = 0;

    double likelihood() const { return forAPair * double(pairs.size()) - againstAMiss * double(missed); }
};

class EdgePairing
{
public:
    EdgePairing(const LightCourse &first, const LightCourse &second) : m_first(first), m_second(second) {}

    std::vector<Proposal> proposals() const
    {
        std::vector<Proposal> all;
        for (const LightEdge &a : m_first.edges) {
            for (const LightEdge &b : m_second.edges) {
                if (a.brighter == b.brighter)
                    all.push_back(proposal(a, b));
            }
        }
        return all;
    }

private:
    double varianceOf(const LightEdge &a, const LightEdge &b) const
    {
        return a.sigmaS * a.sigmaS + b.sigmaS * b.sigmaS;
    }
    double toleranceS(const LightEdge &a, const LightEdge &b, double sinceS) const
    {
        const double shutterS = shutterSigma * std::hypot(m_first.frameS, m_second.frameS);
        return toleranceSigmas * std::sqrt(varianceOf(a, b) + shutterS * shutterS) +
               usualRate * std::abs(sinceS);
    }
    /// Whether an edge at a time of a view is far enough from its ends to be seen.
    static bool isWithin(const LightCourse &view, double timeS)
    {
        const double marginS = 3 * view.frameS;
        return timeS > marginS && timeS < view.durationS - marginS;
    }

    /// The offset at which a and b are one, and what becomes of the other edges: each is paired with the
    /// nearest.
    Proposal proposal(const LightEdge &a, const LightEdge &b) const
    {
        Proposal result;
        result.offsetS = a.timeS - b.timeS;
        std::vector<bool> taken(m_second.edges.size(), false);
        for (const LightEdge &edge : m_first.edges) {
            const double there = edge.timeS - result.offsetS;
            std::optional<std::size_t> best;
            for (std::size_t i = 0; i < m_second.edges.size(); ++i) {
                const LightEdge &other = m_second.edges[i];
                const double apartS = std::abs(other.timeS - there);
                if (!taken[i] && other.brighter == edge.brighter &&
                    apartS < toleranceS(edge, other, edge.timeS - a.timeS) &&
                    (!best || apartS < std::abs(m_second.edges[*best].timeS - there)))
                    best = i;
            }
            if (best) {
                taken[*best] = true;
                const LightEdge &other = m_second.edges[*best];
                result.pairs.push_back({edge.timeS, other.timeS, varianceOf(edge, other)});
            } else if (isWithin(m_second, there)) {
                ++result.missed;
            }
        }
        for (std::size_t i = 0; i < m_second.edges.size(); ++i) {
            if (!taken[i] && isWithin(m_first, m_second.edges[i].timeS + result.offsetS))
                ++result.missed;
        }
        return result;
    }

    const LightCourse &m_first, &m_second;
};

ClipOffset flashOffset(const Proposal &proposal, double shutterS)
{
    const ClockLine line = clockLineThrough(proposal.pairs);
    ClipOffset result;
    result.offsetS = line.offsetS;
    result.sigmaS = std::hypot(line.offsetSigmaS, shutterS);
    result.rate = line.rate;
    result.rateSigma = line.rateSigma;
    result.score = double(proposal.pairs.size()) / double(proposal.pairs.size() + proposal.missed);
    return result;
}

/// Whether two proposals pair the same edges, some of them at least. They come from different pairs, and
/// their offsets differ by what the clocks gained from one to the other.
bool isSame(const Proposal &a, const Proposal &b)
{
    return std::any_of(a.pairs.begin(), a.pairs.end(), [&b](const EventPair &pair) {
        return std::any_of(b.pairs.begin(), b.pairs.end(), [&pair](const EventPair &other) {
            return pair.firstS == other.firstS && pair.secondS == other.secondS;
        });
    });
}

} // namespace

LightCourse lightCourseOf(const std::vector<LightLevel> &levels)
{
    LightCourse course{findLightEdges(levels), 0, 0};
    std::vector<double> intervals;
    for (std::size_t i = 1; i < levels.size(); ++i)
        intervals.push_back(toSeconds(levels[i].time - levels[i - 1].time));
    if (!intervals.empty()) {
        course.frameS = upperMedian(std::move(intervals));
        course.durationS = toSeconds(levels.back().time) + course.frameS;
    }
    return course;
}

Result<ClipOffset> estimateFlashOffset(const LightCourse &first, const LightCourse &second)
{
    if (first.edges.empty() && second.edges.empty())
        return undeterminedOffset(
            ODO_TEXT("synchronisation.no_flash", "neither view shows a flash of light"));
    if (first.edges.empty() || second.edges.empty())
        return undeterminedOffset(
            ODO_TEXT("synchronisation.one_flash", "only one of the views shows a flash of light"));
    if (std::max(first.edges.size(), second.edges.size()) > mostEdges)
        return undeterminedOffset(ODO_TEXT("synchronisation.light_flickers", "the light flickers"));
    const std::vector<Proposal> proposals = EdgePairing(first, second).proposals();
    const auto best =
        std::max_element(proposals.begin(), proposals.end(), [](const Proposal &a, const Proposal &b) {
            return a.likelihood() < b.likelihood();
        });
    if (best == proposals.end() || best->likelihood() <= 0)
        return undeterminedOffset(
            ODO_TEXT("synchronisation.other_flashes", "the flashes of light in the views do not match"));
    for (const Proposal &rival : proposals) {
        if (!isSame(*best, rival) && rival.likelihood() > best->likelihood() - clearLead)
            return undeterminedOffset(
                ODO_TEXT("synchronisation.flashes_fit_alike",
                         "the flashes of light fit equally well at time offsets of %1 and %2")(
                    quantity(best->offsetS, 2, "s"), quantity(rival.offsetS, 2, "s")));
    }
    return flashOffset(*best, shutterSigma * std::hypot(first.frameS, second.frameS));
}

} // namespace odo
