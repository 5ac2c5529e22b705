// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/chroma_density.h"
#include "core/tracking/observation.h"
#include "core/video/frame.h"

#include <optional>
#include <vector>

namespace odo {

/// A frame as all followers share it; what several need is made once.
class TrackedFrame
{
public:
    explicit TrackedFrame(const Frame &frame);
    TrackedFrame(const TrackedFrame &) = delete;
    TrackedFrame &operator=(const TrackedFrame &) = delete;

    const Frame &frame() const { return *m_frame; }
    const ChromaGrid &grid() const { return m_grid; }
    double timeS() const { return toSeconds(m_frame->time); }
    int searchStep() const { return m_searchStep; }
    double imageAreaPx() const { return static_cast<double>(m_frame->format.width) * m_frame->format.height; }
    double lumaPerSample() const { return m_grid.scale.prod(); }
    /// Makes sure that the whole frame can be read, not only the part that was decoded. False when the rest
    /// is damaged.
    bool complete();
    /// Density of all chroma of the frame outside a rectangle (empty: of the whole frame). Needs a complete
    /// frame.
    ChromaDensity backgroundWithout(const ChromaRect &rect);

private:
    const Frame *m_frame;
    std::optional<Frame> m_whole; ///< where a part was given and more was needed
    ChromaGrid m_grid;
    int m_searchStep = 1, m_countStep = 1;
    std::optional<ChromaDensity> m_counts; ///< of the whole frame, once they were needed
};

/// Recognises a frame that repeats the one before it, byte for byte: a camera or a recorder that was late
/// delivers such. Compares every 16th row first, so a new frame costs next to nothing. Of frames that were
/// decoded in part, the common part is compared first and, if that is equal, the whole frames. Keeps a share
/// in the last frame.
class DuplicateDetector
{
public:
    bool repeatsTheLast(const Frame &frame);

private:
    std::optional<Frame> m_last;
};

/// Observations as those of a frame, which repeats the one before it or does not.
void stamp(std::vector<Observation> &observations, const Frame &frame, bool repeats);

} // namespace odo
