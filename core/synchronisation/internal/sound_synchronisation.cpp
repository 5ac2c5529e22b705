// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/sound_synchronisation.h"

#include "core/synchronisation/internal/event_pairs.h"
#include "core/synchronisation/internal/sound_correlation.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double soundSpeed = 343;           ///< m/s
constexpr double unknownWayM = 1.5;          ///< σ of the difference of the ways
constexpr double stampSigmaS = 0.002 * 1.41; ///< of both cameras: sound against frames
constexpr double clockSigma = 50e-6;
constexpr double leastSigmaS = 0.0002, onsetSigmaS = 0.0008;
constexpr double standsOut = 5;        ///< strength of an onset
constexpr std::size_t mostEvents = 60; ///< the strongest
constexpr std::size_t mostProposals = 24;
constexpr std::size_t mostWaves = 6;  ///< of a proposal are compared
constexpr double leastOverlap = 0.15; ///< of the shorter view
constexpr double anchorToleranceS = 0.006, onsetToleranceS = 0.0025;
constexpr double waveToleranceS = 0.03; ///< of onsets that are too slow to be timed but whose waves are alike
constexpr double usualDrift = 1.5e-4;   ///< by which clocks may differ
constexpr double rateTrialS = 0.003;    ///< what a step between the rates tried makes at the farthest event
constexpr double countedApartS = 0.1;   ///< of two events that each count
constexpr double comparedPart = 0.5;    ///< of the strongest: the waves are compared
constexpr double soundS = 0.4;          ///< a sound lasts, with what follows in it
constexpr double strongPart = 0.6;      ///< of the strongest: the other view must have heard it
constexpr std::size_t manyBeats = 8;
constexpr double withinS = 10;
constexpr double forWaves = 9; ///< log-likelihood
constexpr double mostPaired = 0.95;
constexpr double againstAMissedSound = 2.3; ///< ln 10
constexpr double enoughEvidence = 11, clearSoundLead = 5;

std::vector<SoundEvent> strongest(std::vector<SoundEvent> events)
{
    std::ranges::sort(events, std::greater{}, &SoundEvent::strength);
    events.resize(std::min(events.size(), mostEvents));
    return events;
}

/// An event of the first view with its counterpart in the second.
struct SoundPair
{
    double firstS = 0, secondS = 0;
    double strength = 0; ///< of the weaker
    bool isAlike = false;
    double sigmaS = onsetSigmaS;

    double offsetS() const { return firstS - secondS; }
};

/// What speaks for an offset, and against it.
struct SoundProposal
{
    std::vector<SoundPair> pairs;
    double evidence = 0;
};

class SoundPairing
{
public:
    SoundPairing(const SoundCourse &first, const SoundCourse &second)
        : m_first(first), m_second(second), m_firstEvents(strongest(first.onsets.events)),
          m_secondEvents(strongest(second.onsets.events))
    {
    }

    std::vector<SoundProposal> proposals() const
    {
        std::vector<SoundProposal> all;
        for (const CurveLag &lag :
             correlationPeaks(m_first.onsets.curve, m_second.onsets.curve, mostProposals)) {
            const double offsetS =
                m_first.onsets.firstS - m_second.onsets.firstS + lag.steps * SoundOnsets::stepS;
            if (overlapS(offsetS) <
                leastOverlap * std::min(m_first.track.durationS(), m_second.track.durationS()))
                continue;
            if (auto proposal = proposalAt(offsetS); !proposal.pairs.empty())
                all.push_back(std::move(proposal));
        }
        return all;
    }

private:
    double overlapS(double offsetS) const
    {
        return std::min(m_first.onsets.endS(), m_second.onsets.endS() + offsetS) -
               std::max(m_first.onsets.firstS, m_second.onsets.firstS + offsetS);
    }
    static bool isWithin(const SoundCourse &view, double timeS)
    {
        return timeS > view.onsets.firstS + countedApartS && timeS < view.onsets.endS() - countedApartS;
    }
    /// Whether it is part of a sound that began before, as of a whistle.
    static bool isWithinSound(const std::vector<SoundEvent> &events, const SoundEvent &event)
    {
        return std::ranges::any_of(events, [&event](const SoundEvent &before) {
            return before.timeS < event.timeS && event.timeS - before.timeS < soundS;
        });
    }
    static const SoundEvent *nearest(const std::vector<SoundEvent> &events, double timeS, double withinS)
    {
        const SoundEvent *best = nullptr;
        for (const SoundEvent &event : events)
            if (std::abs(event.timeS - timeS) < withinS &&
                (!best || std::abs(event.timeS - timeS) < std::abs(best->timeS - timeS)))
                best = &event;
        return best;
    }

    /// The pairs under a rate, where the clocks have this offset at anchorS of the first.
    std::vector<SoundPair> pairsAt(double offsetS, double anchorS, double rate) const
    {
        std::vector<SoundPair> pairs;
        for (const SoundEvent &event : m_firstEvents) {
            const double thereS = event.timeS - offsetS + rate * (event.timeS - anchorS);
            if (const SoundEvent *other = nearest(m_secondEvents, thereS, onsetToleranceS))
                pairs.push_back({event.timeS, other->timeS, std::min(event.strength, other->strength)});
        }
        return pairs;
    }

    SoundProposal proposalAt(double offsetS) const
    {
        const SoundEvent *anchor = nullptr; // the events are in order of strength
        double anchoredS = offsetS;
        for (const SoundEvent &event : m_firstEvents) {
            if (!isWithin(m_second, event.timeS - offsetS))
                continue;
            const SoundEvent *other = nearest(m_secondEvents, event.timeS - offsetS, anchorToleranceS);
            if (!anchor || other) {
                anchor = &event;
                anchoredS = other ? event.timeS - other->timeS : offsetS;
            }
            if (other)
                break;
        }
        if (!anchor)
            return {};
        double farthestS = 0;
        for (const SoundEvent &event : m_firstEvents)
            farthestS = std::max(farthestS, std::abs(event.timeS - anchor->timeS));
        const int rates = int(usualDrift * farthestS / rateTrialS);
        SoundProposal best;
        double bestRate = 0;
        for (int i = -rates; i <= rates; ++i) {
            const double rate = rates > 0 ? usualDrift * i / rates : 0;
            SoundProposal proposal{pairsAt(anchoredS, anchor->timeS, rate), 0};
            proposal.evidence = evidenceOf(proposal.pairs, anchoredS, anchor->timeS, rate);
            if (i == -rates || proposal.evidence > best.evidence) {
                best = std::move(proposal);
                bestRate = rate;
            }
        }
        compareAll(best, anchoredS, anchor->timeS, bestRate);
        best.evidence =
            evidenceOf(best.pairs, anchoredS, anchor->timeS, bestRate) - std::log(double(2 * rates + 1));
        return best;
    }

    /// Compares the waves of the strongest events, also of such that have no counterpart among the onsets of
    /// the second view.
    void compareAll(SoundProposal &proposal, double offsetS, double anchorS, double rate) const
    {
        std::size_t compared = 0;
        for (const SoundEvent &event : m_firstEvents) {
            const auto pair = std::ranges::find(proposal.pairs, event.timeS, &SoundPair::firstS);
            const double thereS = pair != proposal.pairs.end()
                                      ? pair->secondS
                                      : event.timeS - offsetS + rate * (event.timeS - anchorS);
            if (!isWithin(m_second, thereS) ||
                (pair == proposal.pairs.end() && !nearest(m_secondEvents, thereS, waveToleranceS)))
                continue;
            if (event.strength < comparedPart * m_firstEvents.front().strength || ++compared > mostWaves)
                return;
            const WaveLikeness waves = compareWaves({m_first.track, m_first.usual}, event.timeS,
                                                    {m_second.track, m_second.usual}, thereS);
            if (!waves.isAlike)
                continue;
            const SoundPair alike{event.timeS, thereS - waves.lagS, event.strength, true, waves.sigmaS};
            if (pair == proposal.pairs.end())
                proposal.pairs.push_back(alike);
            else
                *pair = alike;
        }
    }

    /// The logarithm of how much likelier the onsets are if this is the offset than by chance.
    double evidenceOf(const std::vector<SoundPair> &pairs, double offsetS, double anchorS, double rate) const
    {
        const double chance = std::clamp(double(m_secondEvents.size()) * 2 * onsetToleranceS /
                                             std::max(1.0, m_second.track.durationS()),
                                         1e-4, 0.3);
        double evidence = 0;
        std::vector<double> counted;
        double paired = 0, alone = 0;
        for (const SoundEvent &event : m_firstEvents) {
            const double thereS = event.timeS - offsetS + rate * (event.timeS - anchorS);
            const auto pair = std::ranges::find(pairs, event.timeS, &SoundPair::firstS);
            const bool isPaired = pair != pairs.end();
            if ((!isPaired && isWithinSound(m_firstEvents, event)) || !isWithin(m_second, thereS) ||
                std::ranges::any_of(counted,
                                    [&](double atS) { return std::abs(atS - event.timeS) < countedApartS; }))
                continue;
            counted.push_back(event.timeS);
            (isPaired ? paired : alone) += 1;
            if (isPaired && pair->isAlike)
                evidence += forWaves;
            if (event.strength > strongPart * m_firstEvents.front().strength && !isPaired &&
                !nearest(m_secondEvents, thereS, countedApartS))
                evidence -= againstAMissedSound;
        }
        for (const SoundEvent &event : m_secondEvents) {
            const double thereS = event.timeS + offsetS;
            if (event.strength > strongPart * m_secondEvents.front().strength && isWithin(m_first, thereS) &&
                !nearest(m_firstEvents, thereS, countedApartS) && !isWithinSound(m_secondEvents, event))
                evidence -= againstAMissedSound;
        }
        const double share = std::clamp(paired / std::max(1.0, paired + alone), chance, mostPaired);
        return evidence + paired * std::log(share / chance) + alone * std::log((1 - share) / (1 - chance));
    }

    const SoundCourse &m_first, &m_second;
    const std::vector<SoundEvent> m_firstEvents, m_secondEvents;
};

/// Whether two proposals pair events alike, some of them at least.
bool isSameProposal(const SoundProposal &a, const SoundProposal &b)
{
    return std::ranges::any_of(a.pairs, [&b](const SoundPair &pair) {
        return std::ranges::any_of(b.pairs, [&pair](const SoundPair &other) {
            return pair.firstS == other.firstS && std::abs(pair.secondS - other.secondS) < onsetToleranceS;
        });
    });
}

ClipOffset soundOffset(const SoundProposal &proposal, const SoundDelay &delay)
{
    std::vector<EventPair> pairs;
    double middleS = 0, weights = 0;
    for (const SoundPair &pair : proposal.pairs) {
        const double variance = pair.sigmaS * pair.sigmaS;
        pairs.push_back({pair.firstS, pair.secondS, variance});
        middleS += pair.secondS / variance;
        weights += 1 / variance;
    }
    const ClockLine line = clockLineThrough(pairs);
    ClipOffset result;
    result.offsetS = line.offsetS + delay.delayS;
    result.rate = line.rate;
    result.rateSigma = line.rateSigma;
    double clockS = 0;
    if (line.rate == 0)
        clockS = (line.rateSigma > 0 ? std::min(clockSigma, line.rateSigma) : clockSigma) *
                 std::abs(middleS / weights);
    result.sigmaS = std::sqrt(std::pow(std::max(leastSigmaS, line.offsetSigmaS), 2) + clockS * clockS +
                              delay.sigmaS * delay.sigmaS + stampSigmaS * stampSigmaS);
    return result;
}

double strongestOf(const SoundCourse &view)
{
    double most = 0;
    for (const SoundEvent &event : view.onsets.events)
        most = std::max(most, event.strength);
    return most;
}

/// Whether many onsets of about one strength follow one another, of which none can be said to be the one.
bool hasBeats(const SoundCourse &view)
{
    std::vector<double> timesS;
    for (const SoundEvent &event : view.onsets.events)
        if (event.strength > strongPart * strongestOf(view))
            timesS.push_back(event.timeS);
    for (std::size_t i = manyBeats; i < timesS.size(); ++i)
        if (timesS[i] - timesS[i - manyBeats] < withinS)
            return true;
    return false;
}

/// Why no offset is found, with the advice common to all searches by sound.
tl::unexpected<Error> undeterminedBySound(Message why)
{
    return fail(ErrorCode::Undetermined, clipsSubject(), std::move(why), clapForSound());
}

} // namespace

Message clapForSound()
{
    return ODO_TEXT(
        "synchronisation.clap_twice",
        "clap twice near the middle of the floor while both cameras record, or give --sync SECONDS");
}

SoundDelay soundDelay(const std::optional<MicrophonePosition> &first,
                      const std::optional<MicrophonePosition> &second)
{
    if (!first || !second)
        return {0, unknownWayM / soundSpeed};
    const Eigen::Vector3d middle(first->floorMiddle.x(), first->floorMiddle.y(), 0);
    const Eigen::Vector3d toFirst = first->camera - middle, toSecond = second->camera - middle;
    // how the difference of the ways changes along the floor; of a disc, σ along a line is half its radius
    const Eigen::Vector2d slope = (toFirst.normalized() - toSecond.normalized()).head<2>();
    return {(toSecond.norm() - toFirst.norm()) / soundSpeed,
            slope.norm() * first->floorRadiusM / 2 / soundSpeed};
}

SoundCourse soundCourseOf(SoundTrack track)
{
    SoundOnsets onsets = findSoundOnsets(track);
    UsualSound usual = usualSoundOf(track);
    return {std::move(track), std::move(onsets), std::move(usual)};
}

Result<ClipOffset> estimateSoundOffset(const SoundCourse &first, const SoundCourse &second,
                                       const SoundDelay &delay)
{
    if (std::min(strongestOf(first), strongestOf(second)) < standsOut)
        return undeterminedBySound(ODO_TEXT("synchronisation.no_loud_sound",
                                            "no clap, knock or whistle is heard clearly in both clips"));
    if (hasBeats(first) || hasBeats(second))
        return undeterminedBySound(ODO_TEXT("synchronisation.sound_beats",
                                            "the sound is full of beats that are alike, as in music"));
    const std::vector<SoundProposal> proposals = SoundPairing(first, second).proposals();
    const auto best = std::ranges::max_element(proposals, {}, &SoundProposal::evidence);
    if (best == proposals.end() || best->evidence < enoughEvidence)
        return undeterminedBySound(
            ODO_TEXT("synchronisation.other_sounds", "the loud sounds of the clips do not match"));
    double next = 0;
    for (const SoundProposal &rival : proposals) {
        if (isSameProposal(*best, rival))
            continue;
        next = std::max(next, rival.evidence);
        if (rival.evidence > best->evidence - clearSoundLead)
            return undeterminedBySound(
                ODO_TEXT("synchronisation.sounds_fit_alike",
                         "the sounds of the clips fit equally well at time offsets of %1 and %2")(
                    quantity(best->pairs.front().offsetS(), 2, "s"),
                    quantity(rival.pairs.front().offsetS(), 2, "s")));
    }
    ClipOffset result = soundOffset(*best, delay);
    result.score = 1 - next / best->evidence;
    return result;
}

} // namespace odo
