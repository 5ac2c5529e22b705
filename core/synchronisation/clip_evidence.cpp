// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/clip_evidence.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double leastEvidenceScore = 0.5; // of an observation; uncertain ones only blur the answer
constexpr double disagreementSigmas = 4;
constexpr double nearSigmas = 5;
constexpr double rarely = 0.05;              // of the frames
constexpr double leastDisagreementS = 0.002; // less is no harm

std::optional<Eigen::Vector2d> positionSeen(const FloorView &view, const Observation &observation,
                                            double heightM)
{
    // a frame that repeats the one before shows nothing of its own time
    if (!observation.found || observation.duplicateFrame || observation.score < leastEvidenceScore ||
        observation.touchesBorder)
        return std::nullopt;
    return view.floorFromPixel(observation.ellipse.centrePx, heightM / 2);
}

/// What one view saw of the robots of a group in one frame.
struct GroupSight
{
    double timeS = 0;
    std::vector<Eigen::Vector2d> positions;
};

/// The observations of a view are of equal frames.
std::vector<GroupSight> sightsOf(const NamedView &view, const std::vector<NamedRobot> &robots,
                                 const std::vector<std::size_t> &group)
{
    std::vector<GroupSight> sights;
    if (!view.floorView)
        return sights;
    for (std::size_t i = 0; i < view.robots[group.front()].size(); ++i) {
        GroupSight &sight = sights.emplace_back();
        sight.timeS = toSeconds(view.robots[group.front()][i].time);
        for (const std::size_t robot : group) {
            if (const auto position =
                    positionSeen(*view.floorView, view.robots[robot][i], robots[robot].heightM.value_or(0)))
                sight.positions.push_back(*position);
        }
    }
    return sights;
}

/// How many of a group are there: as many as a view sees at once, more often than by mistake.
std::size_t robotsThere(const std::vector<std::vector<GroupSight>> &views, std::size_t most)
{
    for (std::size_t count = most; count > 1; --count) {
        for (const std::vector<GroupSight> &sights : views) {
            const auto seen = std::count_if(sights.begin(), sights.end(), [count](const GroupSight &sight) {
                return sight.positions.size() >= count;
            });
            if (double(seen) > rarely * double(sights.size()))
                return count;
        }
    }
    return 1;
}

std::vector<TimedPosition> middleTrack(const std::vector<GroupSight> &sights, std::size_t robotCount)
{
    std::vector<TimedPosition> track;
    for (const GroupSight &sight : sights) {
        if (sight.positions.size() != robotCount)
            continue;
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d &position : sight.positions)
            sum += position;
        track.push_back({sight.timeS, sum / double(robotCount)});
    }
    return track;
}

Message plusMinus(const ClipOffset &offset)
{
    return ODO_TEXT("synchronisation.offset", "%1 ±%2")(quantity(offset.offsetS, 3, "s"),
                                                        quantity(offset.sigmaS, 3, "s"));
}

MessageArgument namesOf(const MotionTrack &track)
{
    std::vector<Message> names;
    for (const std::string &robot : track.robots)
        names.push_back(quotedName(Named::robot(robot)));
    return listed(std::move(names));
}

bool disagree(const ClipOffset &a, const ClipOffset &b)
{
    return std::abs(a.offsetS - b.offsetS) >
           std::max(leastDisagreementS, disagreementSigmas * std::hypot(a.sigmaS, b.sigmaS));
}

/// The offset of the track that determines it best; if none does, the reason of the first.
Result<ClipOffset> fromMotion(const ClipEvidence &first, const ClipEvidence &second, const OffsetRange &range,
                              std::vector<Message> &remarks)
{
    std::optional<ClipOffset> best;
    std::size_t bestTrack = 0;
    std::optional<Error> whyNot;
    std::vector<std::optional<ClipOffset>> all;
    for (std::size_t i = 0; i < first.tracks.size() && i < second.tracks.size(); ++i) {
        const auto offset = estimateClipOffset(first.tracks[i].positions, second.tracks[i].positions, range);
        all.push_back(offset ? std::optional(*offset) : std::nullopt);
        if (!offset && !whyNot)
            whyNot = offset.error();
        if (offset && (!best || offset->sigmaS < best->sigmaS)) {
            best = *offset;
            bestTrack = i;
        }
    }
    if (!best)
        return tl::unexpected(*whyNot);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i] && disagree(*all[i], *best))
            remarks.push_back(
                ODO_TEXT("synchronisation.robots_disagree",
                         "robot %1 gives a time offset of %2, robot %3 gives %4; the second was used")(
                    namesOf(first.tracks[i]), plusMinus(*all[i]), namesOf(first.tracks[bestTrack]),
                    plusMinus(*best)));
    }
    return *best;
}

/// Whether there is anything to compare, and else why not.
Result<void> hasTracks(const ClipEvidence &first, const ClipEvidence &second)
{
    for (const ClipEvidence *view : {&first, &second}) {
        if (view->tracks.empty())
            return fail(ErrorCode::Undetermined, clipsSubject(), view->whyNoTracks, {});
    }
    return {};
}

} // namespace

std::vector<std::vector<MotionTrack>> motionTracks(const std::vector<NamedView> &views,
                                                   const std::vector<NamedRobot> &robots,
                                                   const std::vector<std::string> &names)
{
    std::vector<std::vector<MotionTrack>> tracks(views.size());
    for (const std::vector<std::size_t> &group : robotsOfLikeColours(robots)) {
        std::vector<std::string> together;
        for (const std::size_t robot : group)
            together.push_back(names[robot]);
        std::vector<std::vector<GroupSight>> sights;
        for (const NamedView &view : views)
            sights.push_back(sightsOf(view, robots, group));
        const std::size_t count = robotsThere(sights, group.size());
        for (std::size_t v = 0; v < views.size(); ++v) {
            if (views[v].floorView)
                tracks[v].push_back({together, middleTrack(sights[v], count)});
        }
    }
    return tracks;
}

namespace {

/// What each kind of evidence says of the offset.
struct Answers
{
    Result<ClipOffset> motion, flash, sound;
};

Result<ClipOffset> fromSound(const ClipEvidence &first, const ClipEvidence &second)
{
    for (const ClipEvidence *view : {&first, &second}) {
        if (!view->sound)
            return fail(ErrorCode::Undetermined, clipsSubject(), view->whyNoSound, clapForSound());
    }
    return estimateSoundOffset(*first.sound, *second.sound, soundDelay(first.microphone, second.microphone));
}

Answers answersOf(const ClipEvidence &first, const ClipEvidence &second, const OffsetRange &range,
                  std::vector<Message> &remarks)
{
    Answers all{ClipOffset{}, estimateFlashOffset(first.light, second.light), fromSound(first, second)};
    if (auto has = hasTracks(first, second); !has) {
        all.motion = tl::unexpected(has.error());
        return all;
    }
    all.motion = fromMotion(first, second, range, remarks);
    for (const Result<ClipOffset> *other : {&all.sound, &all.flash}) {
        if (all.motion || !*other)
            continue;
        const double halfWidthS = nearSigmas * (*other)->sigmaS;
        if (auto near = fromMotion(first, second, {(*other)->offsetS, halfWidthS}, remarks))
            all.motion = near;
    }
    return all;
}

tl::unexpected<Error> noneTells(const Answers &answers)
{
    const Message &motion = answers.motion.error().why, &flash = answers.flash.error().why,
                  &sound = answers.sound.error().why;
    if (sound.isEmpty())
        return fail(ErrorCode::Undetermined, clipsSubject(),
                    ODO_TEXT("synchronisation.neither_tells", "%1, and %2")(motion, flash),
                    answers.flash.error().advice);
    return fail(
        ErrorCode::Undetermined, clipsSubject(),
        ODO_TEXT("synchronisation.none_tells", "%1, %2, and %3")(motion, flash, sound),
        ODO_TEXT("synchronisation.flash_or_clap",
                 "flash the room lights or clap twice while both cameras record, or give --sync SECONDS"));
}

Message saidBy(OffsetSource source, const ClipOffset &offset)
{
    if (source == OffsetSource::Sound)
        return ODO_TEXT("synchronisation.by_sound", "%1 by the sound")(plusMinus(offset));
    return source == OffsetSource::Flash
               ? ODO_TEXT("synchronisation.by_flash", "%1 by the flash of light")(plusMinus(offset))
               : ODO_TEXT("synchronisation.by_motion", "%1 by the motion")(plusMinus(offset));
}

Message disagreement(const FoundOffset &used, OffsetSource other, const ClipOffset &offset)
{
    if (used.from == OffsetSource::Motion && other == OffsetSource::Flash)
        return ODO_TEXT(
            "synchronisation.flash_disagrees",
            "the motion gives a time offset of %1, the flash of light gives %2; the motion was used")(
            plusMinus(used.clock), plusMinus(offset));
    return ODO_TEXT("synchronisation.ways_disagree",
                    "the time offsets found disagree: %1; the first was used")(
        listed({saidBy(used.from, used.clock), saidBy(other, offset)}));
}

/// On an offset that the motion does not give: how well it is known, and why not better.
void remarkOnSource(FoundOffset &found, const Answers &answers)
{
    if (answers.motion || found.from == OffsetSource::Motion)
        return;
    const MessageArgument sigma = quantity(1e3 * found.clock.sigmaS, 1, "ms");
    found.remarks.push_back(
        found.from == OffsetSource::Flash
            ? ODO_TEXT("synchronisation.from_flash", "measured by a flash of light to only ±%1, because %2")(
                  sigma, answers.motion.error().why)
            : ODO_TEXT("synchronisation.from_sound",
                       "measured by the sound to only ±%1, because %2")(sigma, answers.motion.error().why));
}

Result<FoundOffset> findBy(const ClipEvidence &first, const ClipEvidence &second, const OffsetRange &range,
                           OffsetSource source)
{
    FoundOffset found{{}, source, {}};
    if (source == OffsetSource::Sound)
        found.clock = ODO_TRY(fromSound(first, second));
    else if (source == OffsetSource::Flash)
        found.clock = ODO_TRY(estimateFlashOffset(first.light, second.light));
    else {
        ODO_TRY(hasTracks(first, second));
        found.clock = ODO_TRY(fromMotion(first, second, range, found.remarks));
    }
    return found;
}

} // namespace

Result<FoundOffset> findClipOffset(const ClipEvidence &first, const ClipEvidence &second,
                                   const OffsetRange &range, OffsetSource allowed)
{
    if (allowed != OffsetSource::Any)
        return findBy(first, second, range, allowed);
    FoundOffset found;
    const Answers answers = answersOf(first, second, range, found.remarks);
    const std::array all{std::pair(OffsetSource::Motion, &answers.motion),
                         std::pair(OffsetSource::Sound, &answers.sound),
                         std::pair(OffsetSource::Flash, &answers.flash)};
    const Result<ClipOffset> *best = nullptr;
    for (const auto &[source, answer] : all) {
        if (*answer && (!best || (*answer)->sigmaS < (*best)->sigmaS)) {
            best = answer;
            found.from = source;
        }
    }
    if (!best)
        return noneTells(answers);
    found.clock = **best;
    for (const auto &[source, answer] : all) {
        if (*answer && disagree(found.clock, **answer))
            found.remarks.push_back(disagreement(found, source, **answer));
    }
    remarkOnSource(found, answers);
    return found;
}

} // namespace odo
