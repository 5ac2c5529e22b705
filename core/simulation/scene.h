// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"
#include "core/simulation/internal/motion.h"
#include "core/video/frame.h"

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace odo {

/// Upright boxes and cylinders; wheels are cylinders that lie across the robot.
enum class SimulatedShape { Box, Cylinder, Wheel, Sphere };

/// A convex solid that a robot is made of. Robot's frame: x forward, y to the left, z up from the floor; the
/// origin is the centre of the footprint's bounding rectangle. The parts of a robot share no volume.
struct RobotPart
{
    SimulatedShape shape = SimulatedShape::Box;
    RgbColour colour;
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero();
    Eigen::Vector3d sizeM = Eigen::Vector3d::Zero(); ///< along x, y, z; of round ones the diameters are equal

    Eigen::Vector3d lower() const { return centreM - sizeM / 2; }
    Eigen::Vector3d upper() const { return centreM + sizeM / 2; }
};

struct SimulatedRobot
{
    std::string name;
    RgbColour colour;
    SimulatedShape shape = SimulatedShape::Box;           ///< Box or Cylinder
    double lengthM = 0.26, widthM = 0.19, heightM = 0.06; ///< cylinder: length is the diameter
    std::shared_ptr<const Motion> motion;
    /// what it is made of; empty: one solid of that shape, colour and size, which is on the floor
    std::vector<RobotPart> parts = {};
};

/// A flat patch on the floor of any colour: tape, or a distractor of the robot's own colour. Corners in
/// order.
struct FloorPatch
{
    RgbColour colour;
    std::vector<Eigen::Vector2d> corners;
};

/// A short bright spot of a colour that appears on the floor and is gone again: what makes spikes.
struct Reflection
{
    RgbColour colour;
    Eigen::Vector2d position;
    double radiusM = 0.05;
    double startS = 0, durationS = 0.1;
    int camera = -1; ///< seen by this camera only; -1: by all
};

/// An upright board that hides what is behind it, for a while.
struct Occluder
{
    RgbColour colour;
    Eigen::Vector2d from, to; ///< its foot on the floor
    double heightM = 0.5;
    double startS = 0, durationS = 1e9;
};

/// The light of the room is another for a while, for all cameras: a flash, or a lamp that is switched on.
struct LightChange
{
    double gain = 1; ///< of all luma and chroma
    double startS = 0, durationS = 1e9;
};

/// A lamp over the floor: what is in its light casts a shadow, which is the softer the larger the lamp
/// is.
struct Lamp
{
    Eigen::Vector3d positionM{0, 0, 2.5};
    double radiusM = 0.1;
    double strength = 0.3; ///< share of the floor's light that comes from it
};

/// Light that comes to a part of the floor, or leaves it, slowly: the sun through a window, a cloud before
/// it. It fades out to its edge; things in it are not lit.
struct LocalLight
{
    Eigen::Vector2d position{0, 0};
    double radiusM = 0.8;
    double strength = 0.15;       ///< added share of white where it is strongest; negative: of black
    double startS = 0, rampS = 4; ///< from nothing to all of it
};

/// What a simulated camera adds to the perfect image.
struct SensorModel
{
    double exposureS = 0.008; ///< motion blur, averaged over sub-steps
    /// a rolling shutter's, from the first row to the last; the frame's time is that of its middle row
    double readoutS = 0;
    double noiseSigma = 2.0;     ///< of 255, luma; chroma the same before subsampling
    double flickerAmplitude = 0; ///< of light, 0.05 = ±5 %
    double flickerHz = 100;
    double gainDriftPerS = 0; ///< relative, 0.01 = +1 % a second
    ChromaSiting siting = ChromaSiting::Left;
    std::vector<std::int64_t> droppedFrames; ///< frames, as taken, that are never delivered
    std::vector<std::int64_t> doubledFrames; ///< frames, as taken, that repeat the frame before
};

struct SimulatedCamera
{
    std::string name;
    FloorView view;
    double framesPerSecond = 30;
    double startOffsetS = 0;  ///< when the first frame is taken, in the scene's time
    double clockDriftPpm = 0; ///< the camera's clock runs faster by this much
    SensorModel sensor;
    /// The camera takes frames up to this much before or after their turn, as their stamps show (a camera of
    /// a variable rate). Less than half a period.
    double jitterS = 0;
};

/// What is at a marker's position: a tag (numbered in the layout's order), a black ring with a hole of half
/// its diameter, or a black disc.
enum class MarkerShape { Tag, Ring, Dot };

/// The floor: a texture of tiles and grain that is the same for a seed, with markers where a layout
/// says.
struct SimulatedFloor
{
    std::uint32_t textureSeed = 1; ///< not the scene's: trials with other noise share their floor
    RgbColour colour{182, 177, 166};
    RgbColour surroundings{92, 100, 110};                   ///< around the floor
    Eigen::Vector2d lower{-0.35, -0.35}, upper{3.35, 2.55}; ///< opposite corners of the floor
    double textureAmplitude = 0.06;                         ///< relative
    double tileM = 0.5;
    MarkerLayout markers;
    /// side of the tag's black square, outer diameter of a ring or disc; 0: none drawn
    double markerSideM = 0.16;
    std::vector<FloorPatch> patches;
    double shadowStrength = 0.35; ///< of the soft shadow where a robot meets the floor; 0: none
    double gloss = 0;             ///< how strong the mirror images in it are; 1: a mirror
    MarkerShape markerShape = MarkerShape::Tag;
    bool areTagsByLabel = false; ///< a tag's number is its marker's label, not its index in the layout
};

/// A whole simulated testbed with known truth. Rendering is deterministic for a seed, whatever the order of
/// frames.
struct SimulatedScene
{
    SimulatedFloor floor;
    std::vector<SimulatedRobot> robots;
    std::vector<SimulatedRobot> bystanders; ///< whatever moves and is no robot: legs, hands, a ball
    std::vector<Reflection> reflections;
    std::vector<Occluder> occluders;
    std::vector<LightChange> lights;
    std::vector<LocalLight> localLights;
    std::vector<Lamp> lamps;
    std::vector<SimulatedCamera> cameras;
    double durationS = 10;
    std::uint32_t seed = 1;
};

/// The camera's own number of delivered frames in the scene's duration.
std::int64_t frameCount(const SimulatedScene &scene, int camera);
/// Number, among the frames the camera took (delivered or not), of the frame that delivered frame i shows;
/// a doubled frame shows the one taken before it.
std::int64_t sourceFrame(const SimulatedScene &scene, int camera, std::int64_t frame);
/// Scene time of the middle of the exposure of the frame that delivered frame i shows.
double frameSceneTime(const SimulatedScene &scene, int camera, std::int64_t frame);
/// The time stamp that the camera gives it (its own, drifting clock), zero at its first frame.
Nanoseconds frameStamp(const SimulatedScene &scene, int camera, std::int64_t frame);
/// Scene time at which the camera's clock shows a stamp: where to ask the truth for a time of its recording.
double sceneTimeOfStamp(const SimulatedScene &scene, int camera, Nanoseconds stamp);

/// A number that looks random but depends only on its arguments (SplitMix64's finaliser, Steele et al. 2014):
/// what makes frames the same whatever the order in which they are asked for.
inline std::uint64_t randomHash(std::uint64_t a, std::uint64_t b)
{
    std::uint64_t z = a * 0x9e3779b97f4a7c15ull + b + 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

/// As randomHash, in [-1, 1).
inline double randomSigned(std::uint64_t a, std::uint64_t b)
{
    return static_cast<double>(randomHash(a, b) >> 11) * 0x1p-52 - 1.0;
}

} // namespace odo
