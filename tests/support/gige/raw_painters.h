// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"
#include "tests/support/gige/simulated_gige_camera.h"

namespace odo::test {

namespace pixel {
constexpr std::uint32_t mono8 = 0x01080001, bayerGr8 = 0x01080008, bayerRg8 = 0x01080009,
                        bayerGb8 = 0x0108000a, bayerBg8 = 0x0108000b, rgb8 = 0x02180014, bgr8 = 0x02180015;
}

/// A painter that writes into the picture when and as which number it was taken, 640 pixels wide, in the
/// uppermost 8 rows; below it is of one colour. Any format.
SimulatedGigeCamera::Painter codedPainter(RgbColour below = {90, 90, 90});

/// What a coded picture says.
struct FrameCode
{
    std::uint16_t id = 0;
    Nanoseconds begin{0}; ///< of the exposure, by this machine's steady clock
};
FrameCode readCode(const Frame &frame);

/// A painter that shows, over and over, what a camera of a scene sees from one of its frames to the last.
/// That frame is shown at that steady time; the pace is the scene's. All of it is painted in advance, so that
/// two cameras keep up.
SimulatedGigeCamera::Painter scenePainter(const SimulatedScene &scene, int camera, std::int64_t firstFrame,
                                          std::uint32_t pixelFormat, Nanoseconds beginning);

} // namespace odo::test
