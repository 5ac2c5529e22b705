// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/robot_tracker.h"

#include "core/tracking/internal/tracked_frame.h"

#include <algorithm>

namespace odo {

namespace {

bool bySilhouette(const TrackTarget &target)
{
    return target.wholeOutline || !isFoundByColour(target);
}

/// Those of some targets, by their numbers among them.
std::vector<RobotSeed> seedsOf(const std::vector<std::size_t> &targets, std::span<const RobotSeed> seeds)
{
    std::vector<RobotSeed> own;
    for (const RobotSeed &seed : seeds)
        if (const auto at = std::ranges::find(targets, seed.target); at != targets.end())
            own.push_back({std::size_t(at - targets.begin()), seed.pixel});
    return own;
}

} // namespace

bool needsBackground(const std::vector<TrackTarget> &targets)
{
    return std::ranges::any_of(targets, bySilhouette);
}

Result<std::unique_ptr<RobotTracker>> RobotTracker::create(const std::vector<TrackTarget> &targets,
                                                           std::optional<Background> background,
                                                           const std::optional<FloorView> &floor,
                                                           std::size_t others, SearchedArea area)
{
    std::unique_ptr<RobotTracker> tracker(new RobotTracker);
    tracker->m_floor = floor;
    std::vector<TrackTarget> coloured;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (bySilhouette(targets[i]))
            tracker->m_whole.push_back(i);
        if (!isFoundByColour(targets[i]))
            continue;
        tracker->m_coloured.push_back(i);
        coloured.push_back(targets[i]);
    }
    tracker->m_targets = targets;
    tracker->m_besides = std::ranges::all_of(targets, isFoundByColour) ? 0 : others;
    if (tracker->m_whole.empty() || !coloured.empty()) {
        tracker->m_byColour = ODO_TRY(ColourTracker::create(std::move(coloured), area));
    }
    tracker->m_area = std::move(area);
    if (background)
        tracker->setBackground(std::move(*background));
    return tracker;
}

void RobotTracker::setBackground(Background background)
{
    if (m_bySilhouette)
        m_bySilhouette->setBackground(std::move(background));
    else if (!m_whole.empty())
        m_bySilhouette = std::make_unique<SilhouetteTracker>(std::move(background), m_whole.size(), m_floor,
                                                             m_besides, m_area);
}

std::optional<PixelRect> RobotTracker::neededRegion(Nanoseconds time) const
{
    return m_whole.empty() ? m_byColour->neededRegion(time) : std::nullopt;
}

std::vector<Observation> RobotTracker::track(const Frame &frame, std::span<const RobotSeed> seeds)
{
    std::vector<Observation> coloured =
        m_byColour ? m_byColour->track(frame, seedsOf(m_coloured, seeds)) : std::vector<Observation>();
    if (m_whole.empty())
        return coloured;
    std::vector<Observation> all(m_targets.size()), elsewhere;
    stamp(all, frame, false);
    std::vector<SilhouetteCue> cues(m_whole.size());
    for (std::size_t i = 0; i < m_coloured.size(); ++i) {
        const auto own = std::ranges::find(m_whole, m_coloured[i]);
        if (own != m_whole.end()) {
            cues[std::size_t(own - m_whole.begin())] = {&coloured[i],
                                                        chromaOf(*m_targets[*own].colour, frame.format)};
        } else {
            all[m_coloured[i]] = coloured[i];
            elsewhere.push_back(coloured[i]);
        }
    }
    if (m_bySilhouette) {
        std::vector<Observation> whole =
            m_bySilhouette->track(frame, elsewhere, cues, seedsOf(m_whole, seeds));
        for (std::size_t i = 0; i < m_whole.size(); ++i)
            all[m_whole[i]] = std::move(whole[i]);
        m_seenBesides.assign(std::make_move_iterator(whole.begin() + std::ptrdiff_t(m_whole.size())),
                             std::make_move_iterator(whole.end()));
    }
    return all;
}

std::vector<double> RobotTracker::sharesAlike() const
{
    std::vector<double> shares(m_targets.size());
    for (std::size_t i = 0; m_byColour && i < m_byColour->sharesAlike().size(); ++i)
        shares[m_coloured[i]] = m_byColour->sharesAlike()[i];
    return shares;
}

} // namespace odo
