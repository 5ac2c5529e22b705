// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/background.h"
#include "core/tracking/colour_tracker.h"
#include "core/tracking/internal/silhouette_tracker.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace odo {

/// Follows all robots of a project through the frames of one view: those with a given chromatic colour by it
/// (ColourTracker), the others, and those whose whole outline is requested, by their silhouettes
/// (SilhouetteTracker). Feed every frame in order. Not thread-safe; one tracker a view.
class RobotTracker
{
public:
    /// background: of the view, without the robots; needed for robots of any look, which are found in no
    /// frame without one. Errors: those of ColourTracker. floor: of a registered view, before which what is
    /// too large for a robot is none. others: how many things besides the robots of any look are followed,
    /// for one of them may be the robot. area: where in the frames robots are searched.
    static Result<std::unique_ptr<RobotTracker>> create(const std::vector<TrackTarget> &targets,
                                                        std::optional<Background> background,
                                                        const std::optional<FloorView> &floor = {},
                                                        std::size_t others = 0, SearchedArea area = {});

    /// A first or a newer background of the same scene.
    void setBackground(Background background);

    /// As of ColourTracker; all of the frame where a robot of any look is followed.
    std::optional<PixelRect> neededRegion(Nanoseconds time) const;
    /// One observation a target, in the order given. seeds: where robots are in this frame.
    std::vector<Observation> track(const Frame &frame, std::span<const RobotSeed> seeds = {});
    /// One observation of each other thing in the frame tracked last; none where no robot is of any look.
    const std::vector<Observation> &others() const { return m_seenBesides; }
    /// As of ColourTracker; 0 for robots of any look.
    std::vector<double> sharesAlike() const;

private:
    RobotTracker() = default;

    std::unique_ptr<ColourTracker> m_byColour;
    std::unique_ptr<SilhouetteTracker> m_bySilhouette;
    std::vector<std::size_t> m_coloured,
        m_whole;               ///< targets; one whose whole outline is requested may be both
    std::size_t m_besides = 0; ///< other things to follow
    std::vector<Observation> m_seenBesides;
    std::vector<TrackTarget> m_targets;
    std::optional<FloorView> m_floor;
    SearchedArea m_area;
};

/// Whether some robot is to be measured by its silhouette, which takes a background.
bool needsBackground(const std::vector<TrackTarget> &targets);

} // namespace odo
