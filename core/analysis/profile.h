// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/task.h"
#include "core/base/message.h"
#include "core/base/units.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// Why a sample is flagged; bits of SampleFlags. The names in words are those of the command line (flagName).
enum class SampleFlag : std::uint32_t {
    Jump = 1u << 0,              ///< too far from where the neighbours put it
    SpeedLimit = 1u << 1,        ///< faster than the task's or robot's limit
    AccelerationLimit = 1u << 2, ///< harder than the limit
    ViewsDisagree = 1u << 3,  ///< the views' floor positions differ. Alone: the wrong ones were left out and
                              ///< the rest is used, or all are, with a covariance that covers their
                              ///< distance; with Jump: none could be trusted
    LowScore = 1u << 4,       ///< the tracker was not sure
    Lost = 1u << 5,           ///< no view found the robot
    DuplicateFrame = 1u << 6, ///< the camera repeated a frame
    Interpolated = 1u << 7,   ///< the profile bridges a gap here
    ByHand = 1u << 8,         ///< a manual override: with Jump a spike, else valid
};
using SampleFlags = std::uint32_t;

constexpr SampleFlags flagBit(SampleFlag flag)
{
    return static_cast<SampleFlags>(flag);
}
constexpr bool hasFlag(SampleFlags flags, SampleFlag flag)
{
    return (flags & flagBit(flag)) != 0;
}
/// "jump", "speed_limit", ...
std::string_view flagName(SampleFlag flag);
/// All set names joined by '|', in the order of the bits.
std::string flagNames(SampleFlags flags);
/// Flags with each of which a sample is not used.
constexpr SampleFlags rejectingFlags =
    flagBit(SampleFlag::Jump) | flagBit(SampleFlag::SpeedLimit) | flagBit(SampleFlag::AccelerationLimit) |
    flagBit(SampleFlag::LowScore) | flagBit(SampleFlag::Lost) | flagBit(SampleFlag::DuplicateFrame);
/// True when the raw position is not used by the smoother (spike or nothing measured). ViewsDisagree by
/// itself does not reject: the position is that of the views which agree with one another, or with the
/// motion.
constexpr bool isRejected(SampleFlags flags)
{
    return (flags & rejectingFlags) != 0;
}

/// Where a robot's front points, measured at one time: anticlockwise from the world's X.
struct MeasuredHeading
{
    double radians = 0;
    double sigmaRad = 0;       ///< frame to frame
    double commonSigmaRad = 0; ///< of what neighbouring frames share, with unknownFrontSigmaRad on top
    bool operator==(const MeasuredHeading &) const = default;
};
/// Added to σ of a heading that shows how the body turns, but not which of its sides is the front.
inline constexpr double unknownFrontSigmaRad = 3.141592653589793;

/// One robot at one time on the floor: the fused measurement, before smoothing. World frame, metres.
struct Sample
{
    Nanoseconds time{0};                                  ///< since the first view's first frame
    std::int64_t frame = 0;                               ///< frame of the first view
    std::optional<Eigen::Vector2d> position;              ///< empty when no view found the robot
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< frame to frame, m²
    /// calibration and what all outlines share, m²
    Eigen::Matrix2d commonCovariance = Eigen::Matrix2d::Zero();
    std::uint32_t views = 0;                 ///< bit i: view i was used
    std::optional<double> viewDisagreementM; ///< largest distance between two views' positions
    SampleFlags flags = 0;
    std::optional<MeasuredHeading> heading = {}; ///< of the body, where it was measured
    /// Since the sample before, an unknown time passed: the motion begins again here. Not stored; what
    /// follows from it is.
    bool isAfterBreak = false;
};

/// Whether the smoother uses a sample: it has a position, and that is not rejected.
inline bool isUsed(const Sample &sample)
{
    return sample.position && !isRejected(sample.flags);
}

/// The smoothed heading of a robot's body, and how fast it turns: anticlockwise, also on the spot.
struct BodyHeading
{
    double radians = 0, sigmaRad = 0; ///< without steps of a whole turn; σ with the common part
    double turnRateRadps = 0, sigmaTurnRateRadps = 0;
    bool isFrontKnown() const { return sigmaRad < unknownFrontSigmaRad; }
    bool operator==(const BodyHeading &) const = default;
};

/// The smoothed state at one sample's time. World frame, SI.
struct ProfilePoint
{
    Eigen::Vector2d position, velocity, acceleration;
    double sigmaXM = 0, sigmaYM = 0; ///< of the position, common part included
    double speedMps = 0, sigmaSpeedMps = 0;
    double accelMps2 = 0, sigmaAccelMps2 = 0; ///< |a|
    bool valid = false; ///< false in long gaps and before the first or after the last sighting
    std::optional<BodyHeading> body = {}; ///< empty: only its motion is known
};

/// A named metric with its uncertainty. Unit of the value: as named ("s", "m", "m/s", "m/s²", "rad/s", "mm",
/// "1").
struct Metric
{
    std::string name; ///< stable identifier, e.g. "max_speed"
    std::string unit;
    double value = 0;
    std::optional<double> sigma;
    /// The robot was not measured all the time, or hardly known for some of it (max_turn_rate), and what it
    /// did meanwhile can only make the value larger. Metrics of such a run are of its measured part.
    bool isAtLeast = false;
};

/// A spike, described for a person.
struct Spike
{
    std::int64_t sampleIndex = 0;
    Nanoseconds time{0};
    SampleFlags flags = 0;
    Message reason; ///< such as "views disagree by 84 mm"
};

/// A robot's passing of a gate, in the gate's direction.
struct GatePassage
{
    std::string gate; ///< its name
    GateRole role = GateRole::Split;
    Nanoseconds time{0};     ///< since the first view's first frame, interpolated between frames
    double sigmaS = 0;       ///< all of it
    double commonSigmaS = 0; ///< the calibration's part: the same at each passage of a gate at one speed
};

/// What can make views contradict each other, and what of it their positions tell.
struct ContradictionCause
{
    enum class Kind {
        CameraMoved,  ///< since its registration
        CamerasMoved, ///< two of them
        Offset,       ///< the time offset of a view is wrong
        ClockRate,    ///< it changes along the run
        Height,       ///< the height that was given for the robot is wrong
    };
    Kind kind = Kind::CameraMoved;
    std::size_t view = 0, otherView = 0; ///< numbers; the second of CamerasMoved
    double size = 0;                     ///< px in the image, s, s of a second, or m of the robot's top
    std::optional<Nanoseconds> since;    ///< it began during the run
};

/// Views contradict each other by more than their errors allow for.
struct ViewsContradiction
{
    /// The likeliest first, and others that explain it as well; empty: none explains it.
    std::vector<ContradictionCause> causes;
    double apartM = 0; ///< median distance of two views' positions where they contradict each other
};

/// Height of the plane onto which a robot's silhouette is projected: its centre is, to first order, the image
/// of the body's centre, at half its height.
constexpr double silhouettePlaneM(double heightM)
{
    return heightM / 2;
}

/// One robot's samples and the curves derived from them; samples (or flags) and points have equal length.
struct Profile
{
    std::vector<Sample> samples;
    std::vector<ProfilePoint> points;
    std::vector<Spike> spikes;
    std::vector<Metric> metrics;
    std::vector<GatePassage> passages; ///< in order of time; none without a task
    std::vector<TimeSpan> gaps; ///< between the first and the last valid point, when nothing was measured
    double measuredS = 0;       ///< from the first to the last valid point, without the gaps
    /// Of a long imported track, whose samples are not held: the flags of each of them. Empty otherwise.
    std::vector<SampleFlags> flags;
    double heightM = 0; ///< of the robot's top; its median where it varies
    bool heightEstimated = false;
    /// of the solid that the outlines were measured by: from the floor to its lowest part; it is not stored
    std::optional<double> clearanceM = {};
    double meanViewDisagreementM = 0;
    std::optional<ViewsContradiction> contradiction = {}; ///< it is not stored
};

/// The root mean square σ of a coordinate of all samples that were added, metres; 0 without a position.
class NoiseLevel
{
public:
    void add(const std::vector<Sample> &samples);
    double sigmaM() const;

private:
    double m_variances = 0, m_count = 0;
};

} // namespace odo
