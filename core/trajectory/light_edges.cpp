// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/light_edges.h"

#include "core/base/upper_median.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double leastStep = 0.006;       ///< of the logarithm, from picture to picture: less is no part of an edge
constexpr double leastChange = 0.06;      ///< of a whole edge
constexpr double stepSigmas = 5;          ///< times the usual step
constexpr double changeSigmas = 10;
constexpr double leastShare = 1.0 / 3;    ///< of the picture
constexpr std::size_t mostSteps = 3;
constexpr double longestEdgeS = 0.12;
constexpr std::size_t plateauFrames = 3;  ///< from which the level beside an edge is taken
constexpr std::size_t peakFrames = 3;     ///< fewer between two edges show the light between them in no picture whole
constexpr double gamma = 2.2;
constexpr double meanExposure = 2.0 / 3, exposureSigma = 0.24; ///< in frame intervals, of a half-done picture

/// Steps from picture first − 1 to picture last, all of one direction.
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
    double timeS(std::size_t picture) const { return toSeconds(m_levels[picture].time); }

    bool isEdge(const Run &run) const
    {
        const bool quick =
            run.last - run.first < mostSteps || timeS(run.last) - timeS(run.first - 1) < longestEdgeS;
        const bool large = std::abs(run.change) > std::max(leastChange, changeSigmas * m_usual);
        const bool wide = std::abs(run.share) > leastShare && (run.share > 0) == (run.change > 0);
        return quick && large && wide;
    }

    /// Median level of the pictures from `from` on, towards the clip's end or its start, no further than the next run.
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
        // The pictures that show it half done, the frame intervals about them, and how far each is.
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

} // namespace odo
