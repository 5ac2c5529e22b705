// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/jpeg.h"
#include "tests/calibration/images.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

namespace odo::test {

/// A picture of a floor with markers, and where they truly are in it.
struct DrawnView
{
    SimulatedScene scene;
    std::vector<MarkerPixel> truth;
    Frame frame;
};

/// Where a view has the markers of a layout; empty where one is not well within the picture.
inline std::vector<MarkerPixel> markersIn(const FloorView &view, const MarkerLayout &layout, double borderPx)
{
    std::vector<MarkerPixel> seen;
    for (const Marker &marker : layout.markers) {
        const auto pixel = view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
        const Intrinsics &lens = view.camera().intrinsics();
        if (!pixel || pixel->x() < borderPx || pixel->y() < borderPx ||
            pixel->x() > lens.widthPx - borderPx || pixel->y() > lens.heightPx - borderPx)
            return {};
        seen.push_back({marker.label, *pixel});
    }
    return seen;
}

/// The picture as a webcam gives it: blurred by its lens, with noise, and through JPEG of quality 85.
inline Frame asByWebcam(const Frame &clean, double blurPx, double noiseSigma, std::uint32_t seed)
{
    cv::Mat image(clean.y.height, clean.y.width, CV_32F), noise(image.size(), CV_32F);
    for (int y = 0; y < image.rows; ++y)
        std::copy_n(clean.y.row(y), image.cols, image.ptr<float>(y));
    cv::GaussianBlur(image, image, {0, 0}, blurPx);
    cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0, noiseSigma);
    image += noise;
    image.convertTo(image, CV_8U);
    Frame frame = frameOf(image);
    frame.format.fullRange = true;
    const std::vector<std::uint8_t> bytes = JpegEncoder(85).encode(frame).value();
    JpegDecoder(jpegFormat(bytes).value()).decode(bytes, std::nullopt, frame);
    return frame;
}

/// Some camera 1 to 3.5 m above the floor and up to some 6 m away, of three picture sizes and different
/// lenses, that has all markers in its picture, with a blur of 0.3 to 0.9 px and noise of 1 to 5 grey values,
/// through JPEG.
inline DrawnView drawFloorView(const MarkerLayout &layout, MarkerShape shape, double markerM,
                               std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Marker &marker : layout.markers)
        middle += marker.pointInWorld / static_cast<double>(layout.markers.size());
    static constexpr int sizes[][2] = {{1280, 720}, {1920, 1080}, {1024, 768}};
    DrawnView drawn;
    for (;;) {
        const auto &size = sizes[random() % 3];
        const double direction = 2 * EIGEN_PI * share(random), away = 1 + 4 * share(random);
        const Eigen::Vector3d position(middle.x() + away * std::cos(direction),
                                       middle.y() + away * std::sin(direction), 1.2 + 2.3 * share(random));
        const Eigen::Vector3d aim(middle.x() + 0.4 * (share(random) - 0.5),
                                  middle.y() + 0.4 * (share(random) - 0.5), 0);
        const FloorView view =
            simulatedView(position, aim, size[0], size[1], size[0] * (0.5 + 0.5 * share(random)));
        drawn.truth = markersIn(view, layout, 30);
        if (drawn.truth.empty())
            continue;
        SimulatedCamera camera{"A", view, 30, 0, 0, {}, 0};
        camera.sensor.noiseSigma = 0;
        drawn.scene.cameras = {camera};
        break;
    }
    drawn.scene.seed = seed;
    drawn.scene.durationS = 0.1;
    drawn.scene.floor.textureSeed = seed;
    drawn.scene.floor.textureAmplitude = 0.03 + 0.06 * share(random);
    drawn.scene.floor.markers = layout;
    drawn.scene.floor.markerShape = shape;
    drawn.scene.floor.markerSideM = markerM;
    const double blurPx = 0.3 + 0.6 * share(random), noiseSigma = 1 + 4 * share(random);
    drawn.frame = asByWebcam(SceneRenderer(drawn.scene, 0).render(0), blurPx, noiseSigma, seed);
    return drawn;
}

} // namespace odo::test
