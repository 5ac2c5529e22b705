// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/internal/turning_smoother.h"

#include "core/base/percentile.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace odo {

namespace {

using Nodes = std::vector<TurnNode>;

constexpr double firstRateSigma = 10; // rad/s
constexpr double leastVariance = 1e-8, leastDensity = 1e-7;
constexpr double turnFreedom = 1, measurementFreedom = 8;
constexpr std::ptrdiff_t stepsAlike = 2; // to either side
constexpr int rounds = 15;
constexpr double scaleTrust = 10;

/// Of each step to the next node: the density of the acceleration, rad²/s³; of each node: a factor on the
/// measurement's variance.
struct TurnNoise
{
    std::vector<double> densities, factors;
};

Eigen::Matrix2d stepOf(double seconds)
{
    Eigen::Matrix2d step;
    step << 1, seconds, 0, 1;
    return step;
}

Eigen::Matrix2d noiseOf(double seconds, double density)
{
    Eigen::Matrix2d noise;
    noise << seconds * seconds / 3, seconds / 2, seconds / 2, 1;
    return density * seconds * noise;
}

struct TurnState
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero(); ///< heading and rate
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

double varianceOf(const TurnNode &node, double factor)
{
    return std::max(leastVariance, factor * node.variance);
}

/// The filter over one segment; the smoother where it is asked for.
class TurnFilter
{
public:
    /// With a constant density the two vectors have one value each.
    TurnFilter(const Nodes &nodes, std::span<const double> densities, std::span<const double> factors)
        : m_nodes(nodes), m_densities(densities), m_factors(factors)
    {
    }

    /// Twice the negative log likelihood of the innovations, without those that find the rate.
    double run()
    {
        m_predicted.resize(m_nodes.size());
        m_states.resize(m_nodes.size());
        double cost = 0;
        int taken = 0;
        for (std::size_t i = 0; i < m_nodes.size(); ++i) {
            TurnState state = i > 0 ? predicted(i) : start();
            m_predicted[i] = state;
            if (i > 0 && m_nodes[i].measured) {
                const double variance = state.covariance(0, 0) + varianceOf(m_nodes[i], at(m_factors, i)),
                             innovation = m_nodes[i].radians - state.mean[0];
                const Eigen::Vector2d gain = state.covariance.col(0) / variance;
                if (++taken > 2)
                    cost += std::log(variance) + innovation * innovation / variance;
                state.mean += gain * innovation;
                state.covariance -= gain * state.covariance.row(0);
            }
            m_states[i] = state;
        }
        return cost;
    }

    /// After run. changes: of each step, what its squared change of the rate is expected to be.
    std::vector<TurnState> smoothed(std::vector<double> &changes)
    {
        std::vector<TurnState> states = m_states;
        changes.assign(m_nodes.empty() ? 0 : m_nodes.size() - 1, 0);
        for (std::size_t i = changes.size(); i-- > 0;) {
            const TurnState &next = states[i + 1], &expected = m_predicted[i + 1];
            const Eigen::Matrix2d gain =
                m_states[i].covariance * stepOf(secondsOf(i)).transpose() * expected.covariance.inverse();
            states[i].mean += gain * (next.mean - expected.mean);
            states[i].covariance += gain * (next.covariance - expected.covariance) * gain.transpose();
            const double both = (gain * next.covariance)(1, 1), change = next.mean[1] - states[i].mean[1];
            changes[i] = change * change +
                         std::max(0.0, next.covariance(1, 1) + states[i].covariance(1, 1) - 2 * both);
        }
        return states;
    }

    double secondsOf(std::size_t step) const { return m_nodes[step + 1].timeS - m_nodes[step].timeS; }

private:
    static double at(std::span<const double> values, std::size_t i)
    {
        return values.size() == 1 ? values[0] : values[i];
    }
    TurnState start() const
    {
        TurnState state;
        state.mean[0] = m_nodes[0].radians;
        state.covariance.diagonal() << varianceOf(m_nodes[0], at(m_factors, 0)),
            firstRateSigma * firstRateSigma;
        return state;
    }
    TurnState predicted(std::size_t i) const
    {
        const double seconds = secondsOf(i - 1);
        const Eigen::Matrix2d step = stepOf(seconds);
        return {step * m_states[i - 1].mean, step * m_states[i - 1].covariance * step.transpose() +
                                                 noiseOf(seconds, at(m_densities, i - 1))};
    }

    const Nodes &m_nodes;
    std::span<const double> m_densities, m_factors;
    std::vector<TurnState> m_predicted, m_states;
};

/// The likeliest density, if it were the same throughout.
double likeliestDensity(const std::vector<Nodes> &segments, double scale)
{
    double best = 1, leastCost = std::numeric_limits<double>::infinity();
    for (double exponent = -4; exponent <= 3; exponent += 0.5) {
        const double density = std::pow(10, exponent);
        double cost = 0;
        for (const Nodes &nodes : segments)
            cost += TurnFilter(nodes, std::span(&density, 1), std::span(&scale, 1)).run();
        if (cost < leastCost) {
            leastCost = cost;
            best = density;
        }
    }
    return best;
}

/// Expectation maximisation over all segments.
class TurnLearning
{
public:
    explicit TurnLearning(const std::vector<Nodes> &segments)
        : m_segments(segments), m_leastScale(turnNoiseScale(segments)), m_scale(m_leastScale),
          m_density(likeliestDensity(segments, m_leastScale))
    {
        for (const Nodes &nodes : segments)
            m_noise.push_back({std::vector<double>(nodes.size() - 1, m_density),
                               std::vector<double>(nodes.size(), m_scale)});
    }

    std::vector<std::vector<TurnEstimate>> run()
    {
        for (int round = 0; round < rounds; ++round)
            improve();
        std::vector<std::vector<TurnEstimate>> estimates;
        for (std::size_t s = 0; s < m_segments.size(); ++s) {
            std::vector<TurnEstimate> &own = estimates.emplace_back();
            for (const auto &[mean, covariance] : smoothed(s)) {
                const Eigen::Vector2d sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
                own.push_back({mean[0], sigma[0], mean[1], sigma[1]});
            }
        }
        return estimates;
    }

private:
    /// Also sets m_changes: densities, as the segment's changes of the rate show them.
    std::vector<TurnState> smoothed(std::size_t segment)
    {
        TurnFilter filter(m_segments[segment], m_noise[segment].densities, m_noise[segment].factors);
        filter.run();
        auto states = filter.smoothed(m_changes);
        for (std::size_t i = 0; i < m_changes.size(); ++i)
            m_changes[i] /= filter.secondsOf(i);
        return states;
    }

    void improve()
    {
        m_sumOfDensities = m_steps = m_sumOfVariances = m_measured = 0;
        for (std::size_t s = 0; s < m_segments.size(); ++s) {
            const std::vector<TurnState> states = smoothed(s);
            weighMeasurements(s, states);
            weighSteps(s);
        }
        const double density = std::max(leastDensity, m_sumOfDensities / m_steps),
                     scale = std::max(m_leastScale, m_sumOfVariances / m_measured);
        for (TurnNoise &noise : m_noise) {
            for (double &one : noise.densities)
                one *= density;
            for (double &one : noise.factors)
                one *= scale;
        }
        m_density = density;
        m_scale = scale;
    }

    /// Leaves in the factors how much less each measurement counts than others.
    void weighMeasurements(std::size_t segment, const std::vector<TurnState> &states)
    {
        for (std::size_t i = 0; i < states.size(); ++i) {
            const TurnNode &node = m_segments[segment][i];
            double &factor = m_noise[segment].factors[i];
            factor = 1;
            if (!node.measured)
                continue;
            const double away = node.radians - states[i].mean[0],
                         variance = (away * away + states[i].covariance(0, 0)) /
                                    std::max(leastVariance, node.variance),
                         weight = (measurementFreedom + 1) / (measurementFreedom + variance / m_scale);
            factor = 1 / weight;
            m_sumOfVariances += weight * variance;
            m_measured += 1;
        }
    }

    /// The same of the steps, with their neighbours.
    void weighSteps(std::size_t segment)
    {
        std::vector<double> &densities = m_noise[segment].densities;
        const auto count = static_cast<std::ptrdiff_t>(densities.size());
        for (std::ptrdiff_t i = 0; i < count; ++i) {
            const std::ptrdiff_t first = std::max(std::ptrdiff_t(0), i - stepsAlike),
                                 last = std::min(count - 1, i + stepsAlike);
            double sum = 0;
            for (std::ptrdiff_t k = first; k <= last; ++k)
                sum += m_changes[static_cast<std::size_t>(k)];
            const double weight = (turnFreedom + double(last - first + 1)) / (turnFreedom + sum / m_density);
            densities[static_cast<std::size_t>(i)] = 1 / weight;
            m_sumOfDensities += weight * m_changes[static_cast<std::size_t>(i)];
            m_steps += 1;
        }
    }

    const std::vector<Nodes> &m_segments;
    double m_leastScale, m_scale, m_density;
    std::vector<TurnNoise> m_noise;
    std::vector<double> m_changes;
    double m_sumOfDensities = 0, m_steps = 0, m_sumOfVariances = 0, m_measured = 0;
};

} // namespace

double turnNoiseScale(const std::vector<std::vector<TurnNode>> &segments)
{
    constexpr std::size_t inARow = 5;
    constexpr double medianOfNormal = 0.6745; // of its amount
    std::vector<double> differences;
    for (const Nodes &nodes : segments) {
        for (std::size_t first = 0; first + inARow <= nodes.size(); ++first) {
            const auto row = std::span(nodes).subspan(first, inARow);
            if (!std::ranges::all_of(row, &TurnNode::measured))
                continue;
            double sum = 0, variance = 0;
            for (const TurnNode &one : row) {
                double weight = 1;
                for (const TurnNode &other : row)
                    weight /= &one == &other ? 1 : (one.timeS - other.timeS) / (row[1].timeS - row[0].timeS);
                sum += weight * one.radians;
                variance += weight * weight * std::max(leastVariance, one.variance);
            }
            differences.push_back(std::abs(sum) / std::sqrt(variance));
        }
    }
    const auto count = static_cast<double>(differences.size());
    const double sigma = differences.empty() ? 1 : median(std::move(differences)) / medianOfNormal;
    return (count * sigma * sigma + scaleTrust) / (count + scaleTrust);
}

std::vector<std::vector<TurnEstimate>> smoothTurning(const std::vector<std::vector<TurnNode>> &segments)
{
    return segments.empty() ? std::vector<std::vector<TurnEstimate>>() : TurnLearning(segments).run();
}

} // namespace odo
