// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/tracking/observation.h"
#include "core/video/frame.h"

#include <memory>
#include <string>
#include <vector>

namespace odo {

/// A robot as the tracker needs to know it.
struct TrackTarget
{
    std::string name;
    RgbColour colour;
};

/// Follows one or more coloured robots through the frames of one view, on the chroma planes as decoded.
/// Feed every frame in order. Not thread-safe; one tracker a view.
class ColourTracker
{
public:
    explicit ColourTracker(std::vector<TrackTarget> targets);
    ~ColourTracker();
    ColourTracker(const ColourTracker &) = delete;
    ColourTracker &operator=(const ColourTracker &) = delete;

    /// One observation a target, in the order given to the constructor.
    std::vector<Observation> track(const Frame &frame);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
