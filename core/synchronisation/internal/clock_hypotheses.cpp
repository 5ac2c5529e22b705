// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/clock_hypotheses.h"

#include "core/synchronisation/frame_rate_labels.h"
#include "core/synchronisation/internal/clip_synchronisation.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t mostRates = 61, mostSettled = 6, mostMoved = 6;
constexpr double againstMoved = 3, movedBehind = 25; ///< the likeliest
constexpr double rateApartFrames = 1.5;              ///< over the whole time

/// Rates from −2 to 2 %, no further apart than the tracks can tell, then those of wrong labels.
std::vector<double> ratesToTry(double spanS, double frameS)
{
    const auto aside = std::min(mostRates / 2, std::size_t(std::ceil(largestClockRate * spanS / frameS)));
    std::vector<double> rates{0};
    for (std::size_t i = 1; i <= aside; ++i) {
        rates.push_back(largestClockRate * double(i) / double(aside));
        rates.push_back(-rates.back());
    }
    for (const double rate : labelRates()) {
        const bool isNew = std::none_of(rates.begin(), rates.end(), [&](double other) {
            return std::abs(other - rate) * spanS < frameS;
        });
        if (isNew)
            rates.push_back(rate);
    }
    return rates;
}

/// Weighs relations against one another, the likeliest first.
void rank(std::vector<ClockHypothesis> &all, double frameS)
{
    const auto best = std::min_element(all.begin(), all.end(), [](const auto &a, const auto &b) {
        return a.clocks.variance < b.clocks.variance;
    });
    if (best == all.end())
        return;
    const double independent = independentMoments(best->clocks, frameS);
    std::size_t most = 0;
    for (const ClockHypothesis &one : all)
        most = std::max(most, one.clocks.pairs);
    for (ClockHypothesis &one : all)
        one.likelihood = clockLikelihood(one.clocks, independent) -
                         againstUnseenS * frameS * double(most - one.clocks.pairs) - one.against;
    std::sort(all.begin(), all.end(),
              [](const auto &a, const auto &b) { return a.likelihood > b.likelihood; });
}

/// Weighs relations, and beside those with steps the same with their steps at other moments: a step finder
/// that is right to the frame goes before them unless they are clearly better.
void settle(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
            std::vector<ClockHypothesis> &all)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    rank(all, frameS);
    const std::size_t count = std::min(all.size(), mostMoved);
    for (std::size_t i = 0; i < count; ++i) {
        if (all[i].clocks.steps() == 0 || all.front().likelihood - all[i].likelihood > movedBehind)
            continue;
        SteppedClocks moved = all[i].clocks;
        if (moveSteps(first, second, moved, moved.clock.rate != 0))
            all.push_back({std::move(moved), againstMoved});
    }
    rank(all, frameS);
}

/// The best courses of rates that are apart, and that of equal rates, which most clocks have.
std::vector<LagCourse> settled(std::vector<LagCourse> courses, double apart)
{
    std::sort(courses.begin(), courses.end(),
              [](const LagCourse &a, const LagCourse &b) { return a.cost < b.cost; });
    std::vector<LagCourse> kept;
    for (LagCourse &course : courses) {
        const bool isNew = std::ranges::none_of(
            kept, [&](const LagCourse &one) { return std::abs(one.rate - course.rate) < apart; });
        if (course.rate == 0 || (isNew && kept.size() < mostSettled))
            kept.push_back(std::move(course));
    }
    return kept;
}

/// Relations that bring fewer moments together explain little of the tracks.
std::size_t enoughPairs(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second)
{
    return std::max(fewestPairs, std::min(first.size(), second.size()) / 2);
}

/// A course with its steps, and the others that are tried with it.
void addRelations(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                  const LagCourse &course, bool withRate, std::vector<ClockHypothesis> &all)
{
    const std::size_t enough = enoughPairs(first, second);
    auto clocks = steppedClocks(first, second, course, withRate);
    if (!clocks || clocks->pairs < enough)
        return;
    for (SteppedClocks &one : withBetterSteps(first, second, std::move(*clocks), course.noiseM, withRate))
        if (one.pairs >= enough)
            all.push_back({std::move(one)});
}

} // namespace

std::vector<ClockHypothesis> hypothesesAbout(const std::vector<TimedPosition> &first,
                                             const std::vector<TimedPosition> &second, const LagRange &range,
                                             const Fit &fit)
{
    LagCourse course = LagSearch(first, second, range).courseAt(fit.clock.rate);
    std::vector<ClockHypothesis> all;
    const LagPiece whole{first.front().timeS, first.back().timeS, fit.clock.offsetS};
    for (const std::vector<LagPiece> &pieces : {std::vector{whole}, course.pieces}) {
        course.pieces = pieces;
        addRelations(first, second, course, fit.clock.rate != 0, all);
    }
    ClockHypothesis constant;
    constant.clocks.clock = fit.clock;
    constant.clocks.variance = fit.agreement.variance;
    constant.clocks.correlatedS = fit.agreement.correlatedS;
    constant.clocks.pairs = fit.pairs;
    all.push_back(constant);
    settle(first, second, all);
    return all;
}

std::vector<ClockHypothesis> clockHypotheses(const std::vector<TimedPosition> &first,
                                             const std::vector<TimedPosition> &second, const LagRange &range,
                                             std::vector<ClockHypothesis> known)
{
    const double frameS = std::max(medianStepS(first), 1e-3),
                 spanS = first.back().timeS - first.front().timeS;
    const LagSearch search(first, second, range);
    std::vector<LagCourse> courses;
    double noiseM = HUGE_VAL;
    for (const double rate : ratesToTry(spanS, frameS)) {
        courses.push_back(search.courseAt(rate));
        if (!courses.back().pieces.empty())
            noiseM = std::min(noiseM, courses.back().noiseM);
    }
    for (LagCourse &course : courses)
        course = search.courseAt(course.rate, noiseM);
    courses = settled(std::move(courses), rateApartFrames * frameS / spanS);
    std::vector<ClockHypothesis> found = std::move(known);
    for (const LagCourse &course : courses) {
        for (const bool withRate : {true, false}) {
            if (!withRate && course.rate != 0)
                continue;
            addRelations(first, second, course, withRate, found);
        }
    }
    settle(first, second, found);
    return found;
}

} // namespace odo
