// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/internal/shadow_choice.h"

#include "core/trajectory/solid_choice.h"
#include "core/trajectory/view_disagreement.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

// what the darkest shadows leave of the light: each is tried where the one before it was tried or is better
constexpr float darkerShadows[] = {0.30F, 0.20F}, darkestOfAll = 0.15F, lighterShadows[] = {0.55F, 0.7F};
constexpr float nextDarker = 0.87F;    // where some of it is about as dark as the darkest
constexpr double leastAmbiguity = 0.1; // share of a robot's pixels, over the frames
constexpr double goodMisfit = 0.5;     // a quarter of a pixel
constexpr double less = 0.98;          // of the misfit
constexpr double clearlyLess = 0.9;    // where a shadow could as well be part of a robot that does not turn
constexpr double nearlyAsOften = 0.9;  // of the frames in which it was found
constexpr double unlikelyWorse = 0.12; // than a good misfit, by its share: of other shadows
constexpr double unlikelyNearby = 1.7; // times the misfit: of nearly the same shadows
constexpr float theSame = 0.97F;       // of a darkest shadow

/// The mean of one kind of ambiguity of a robot's outlines; 0 where it was measured by its colour.
class MeanAmbiguity
{
public:
    explicit MeanAmbiguity(float ShadowAmbiguity::*share) : m_share(share) {}
    void add(const std::vector<Observation> &observations)
    {
        for (const Observation &one : observations) {
            m_found += one.found;
            m_sum += one.found ? double(one.shadowAmbiguity.*m_share) : 0;
        }
    }
    double value() const { return m_sum / std::max(1.0, m_found); }

private:
    float ShadowAmbiguity::*m_share;
    double m_found = 0, m_sum = 0;
};

double meanAmbiguity(const std::vector<TrackedView> &tracked, std::size_t robot,
                     float ShadowAmbiguity::*share)
{
    MeanAmbiguity mean(share);
    for (const TrackedView &view : tracked)
        mean.add(view.series[robot].observations);
    return mean.value();
}

/// Whether solids explain the outlines of these robots better than before, by less than this share of the
/// misfit, and nothing of them was lost. A few outlines are easily explained, so more of them may be
/// explained less well.
bool areBetter(const std::vector<Outlines> &now, const std::vector<Outlines> &before, double share)
{
    double gain = 0; // of the logarithms
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (!now[i].misfit || now[i].found < nearlyAsOften * before[i].found)
            return false;
        gain += std::log(now[i].found * before[i].misfit.value_or(worstShapeMisfit) /
                         (std::max(1.0, before[i].found) * *now[i].misfit)) /
                double(now.size());
    }
    return gain > -std::log(share);
}

} // namespace

bool isInParts(const std::vector<TrackedView> &tracked)
{
    return std::ranges::any_of(tracked, [](const TrackedView &view) {
        MeanAmbiguity mean(&ShadowAmbiguity::apart);
        for (const ObservationSeries &series : view.series)
            mean.add(series.observations);
        for (const std::vector<Observation> &other : view.others)
            mean.add(other);
        return mean.value() > leastAmbiguity;
    });
}

ShadowChoice::ShadowChoice(const std::vector<RegisteredView> &views, const std::vector<RobotRecord> &robots,
                           SettledViews &best, TrackAgain again)
    : m_views(views), m_robots(robots), m_best(best), m_again(std::move(again))
{
}

Outlines ShadowChoice::outlinesOf(SettledViews &seen, std::size_t robot) const
{
    Outlines outlines{robot, 0, {}};
    for (const TrackedView &view : seen.views)
        outlines.found += double(std::ranges::count_if(view.series[robot].observations, &Observation::found));
    std::vector<ViewTrack> tracks = takeViewTracks(m_views, seen.views, robot);
    outlines.misfit = misfitOfOutlines(tracks, shapeOf(m_robots[robot]));
    returnObservations(std::move(tracks), seen.views, robot);
    return outlines;
}

/// Robots of which much may be such a shadow, and whose outlines are not explained well already.
/// misfitOfNone: counts where no solid explains them at all.
std::vector<Outlines> ShadowChoice::uncertain(float ShadowAmbiguity::*share, double misfitOfNone)
{
    std::vector<Outlines> uncertain;
    for (std::size_t r = 0; r < m_robots.size(); ++r) {
        if (meanAmbiguity(m_best.views, r, share) <= leastAmbiguity)
            continue;
        Outlines outlines = outlinesOf(m_best, r);
        if (outlines.misfit.value_or(misfitOfNone) > goodMisfit)
            uncertain.push_back(outlines);
    }
    return uncertain;
}

/// Takes them for what they are where solids then explain the outlines of these robots better.
bool ShadowChoice::tryShadow(const Background::Shadow &shadow, std::vector<Outlines> &known, double share)
{
    if (known.empty())
        return false;
    auto again = m_again(shadow);
    if (!again) // what was found before stays
        return false;
    std::vector<Outlines> now;
    for (const Outlines &before : known)
        now.push_back(outlinesOf(*again, before.robot));
    const bool better = areBetter(now, known, share);
    const auto note = [&](const Background::Shadow &with, const SettledViews &seen,
                          const std::vector<Outlines> &found, double evenShare) {
        for (const Outlines &outlines : found) {
            Tried &tried = m_tried.emplace_back(Tried{with, outlines, evenShare, {}});
            for (const TrackedView &view : seen.views) {
                auto &centres = tried.centres.emplace_back();
                for (const Observation &one : view.series[outlines.robot].observations)
                    if (one.found)
                        centres.emplace(one.frame, one.ellipse.centrePx);
            }
        }
    };
    if (better) {
        note(m_shadow, m_best, known, 1 / share);
        std::swap(m_best, *again);
        std::swap(known, now);
        m_shadow = shadow;
    } else {
        note(shadow, *again, now, share);
    }
    return better;
}

bool ShadowChoice::tryDarkest(float darkest, std::vector<Outlines> &known, double share)
{
    Background::Shadow shadow = m_shadow;
    shadow.darkest = darkest;
    const bool isKnown = std::ranges::any_of(m_tried, [&](const Tried &tried) {
        return tried.shadow.tint == shadow.tint && tried.shadow.connects == shadow.connects &&
               tried.shadow.darkest > theSame * darkest && theSame * tried.shadow.darkest < darkest;
    });
    return !isKnown && tryShadow(shadow, known, share);
}

void ShadowChoice::search(bool inParts)
{
    if (inParts) {
        std::vector<Outlines> ofParts;
        for (std::size_t r = 0; r < m_robots.size(); ++r)
            if (!namedRobot(m_robots[r]).colour)
                ofParts.push_back(outlinesOf(m_best, r));
        Background::Shadow connecting = m_shadow;
        connecting.connects = true;
        tryShadow(connecting, ofParts, less);
    }
    std::vector<Outlines> tinted = uncertain(&ShadowAmbiguity::tinted, 0);
    Background::Shadow ofOtherHue = m_shadow;
    ofOtherHue.tint = Background::strongTint;
    tryShadow(ofOtherHue, tinted, clearlyLess);
    std::vector<Outlines> deep = uncertain(&ShadowAmbiguity::deep, 0);
    bool isDeepest = false;
    for (const float darkest : darkerShadows)
        isDeepest = tryDarkest(darkest, deep, less);
    if (isDeepest)
        tryDarkest(darkestOfAll, deep, less);
    if (m_shadow.darkest == Background::Shadow().darkest) {
        std::vector<Outlines> light = uncertain(&ShadowAmbiguity::light, worstShapeMisfit);
        for (const float darkest : lighterShadows)
            if (!tryDarkest(darkest, light, clearlyLess))
                break;
    }
    searchNearby();
}

/// Goes on to a little darker or lighter ones while that is clearly better.
void ShadowChoice::searchNearby()
{
    std::vector<Outlines> near = uncertain(&ShadowAmbiguity::near, 0);
    for (const float factor : {nextDarker, 1 / nextDarker}) {
        const float before = m_shadow.darkest;
        while (tryDarkest(std::clamp(factor * m_shadow.darkest, darkestOfAll, lighterShadows[1]), near,
                          clearlyLess)) {
        }
        if (m_shadow.darkest != before)
            break;
    }
}

/// How likely it is that these are the right ones: where a solid explains the outlines nearly as well as
/// those that are kept, and those not well. The worse those are explained, the less the misfits tell.
double ShadowChoice::likelihoodOf(const Tried &other, const Outlines &kept) const
{
    constexpr float nearby = 0.8F;
    if (!other.outlines.misfit || kept.misfit.value_or(0) <= goodMisfit ||
        other.outlines.found < nearlyAsOften * kept.found)
        return 0;
    const float ratio = other.shadow.darkest / m_shadow.darkest;
    const bool isNearby = ratio != 1 && ratio > nearby && ratio < 1 / nearby &&
                          other.shadow.tint == m_shadow.tint && other.shadow.connects == m_shadow.connects;
    const double even = isNearby ? 1 : other.evenShare,
                 unlikely = isNearby ? unlikelyNearby : 1 + unlikelyWorse * *kept.misfit / goodMisfit,
                 worse = std::log(*other.outlines.misfit / (even * *kept.misfit)) / std::log(unlikely);
    return std::clamp(1 - worse, 0.0, 1.0);
}

void ShadowChoice::addUncertainty()
{
    std::map<std::size_t, Outlines> kept; // by robot
    for (const Tried &other : m_tried)
        if (const std::size_t robot = other.outlines.robot; !kept.contains(robot))
            kept.emplace(robot, outlinesOf(m_best, robot));
    for (const Tried &other : m_tried) {
        const double likelihood = likelihoodOf(other, kept.at(other.outlines.robot)),
                     share = likelihood / (1 + likelihood);
        for (std::size_t v = 0; share > 0 && v < m_best.views.size(); ++v) {
            for (Observation &its : m_best.views[v].series[other.outlines.robot].observations) {
                const auto there = other.centres[v].find(its.frame);
                if (!its.found || there == other.centres[v].end())
                    continue;
                const Eigen::Vector2d away = there->second - its.ellipse.centrePx;
                its.lastingCovariancePx2 += share * away * away.transpose();
            }
        }
    }
}

} // namespace odo
