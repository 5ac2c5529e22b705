// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/v4l2_description.h"

#include "core/capture/v4l2/v4l2_address.h"
#include "core/capture/v4l2/v4l2_source.h"
#include "core/capture/v4l2/v4l2_sysfs.h"

#include <algorithm>

namespace odo {

namespace {

constexpr const char *kind = "v4l2";

std::vector<std::string> formatsOf(const std::vector<V4l2Mode> &modes)
{
    std::vector<V4l2Mode> fastest;
    for (const V4l2Mode &mode : modes) {
        const auto same = std::ranges::find_if(fastest, [&](const V4l2Mode &other) {
            return other.format == mode.format && other.widthPx == mode.widthPx &&
                   other.heightPx == mode.heightPx;
        });
        if (same == fastest.end())
            fastest.push_back(mode);
        else if (mode.framesPerSecond() > same->framesPerSecond())
            *same = mode;
    }
    sortByMerit(fastest);
    std::vector<std::string> words;
    for (const V4l2Mode &mode : fastest)
        words.push_back(modeWords(mode));
    return words;
}

/// Cameras that may not be opened. Only the first node of a camera is named: whether another one gives
/// pictures cannot be asked.
std::vector<CameraDescription> forbiddenCameras()
{
    std::vector<CameraDescription> cameras;
    for (const int number : v4l2Sysfs::nodeNumbers()) {
        const std::filesystem::path node = v4l2Sysfs::nodeOf(number);
        const std::string uri = std::string(v4l2Scheme) + node.string();
        if (v4l2Sysfs::indexOf(node) != "0")
            continue;
        const auto device = V4l2Device::open(node, uri);
        if (!device && device.error().code == ErrorCode::Io)
            cameras.push_back({.uri = uri,
                               .kind = kind,
                               .name = v4l2Sysfs::nameOf(node),
                               .formats = {device.error().why + "; " + device.error().advice}});
    }
    return cameras;
}

} // namespace

CameraDescription describeV4l2(const V4l2Device &device, const std::vector<V4l2Mode> &modes,
                               const V4l2Mode &chosen)
{
    return {.uri = std::string(v4l2Scheme) + device.node().string(),
            .kind = kind,
            .name = device.identity().name,
            .widthPx = chosen.widthPx,
            .heightPx = chosen.heightPx,
            .framesPerSecond = chosen.framesPerSecond(),
            .serial = device.identity().serial,
            .formats = formatsOf(modes)};
}

std::vector<CameraDescription> listV4l2Cameras()
{
    std::vector<CameraDescription> cameras;
    for (const auto &device : openV4l2Devices()) {
        const std::vector<V4l2Mode> modes = v4l2Modes(*device);
        const auto mode = chooseMode(modes, {}, device->node().string());
        if (!mode)
            continue; // nothing that can be read
        cameras.push_back(describeV4l2(*device, modes, *mode));
        cameras.back().busy = device->isBusy();
    }
    for (CameraDescription &camera : forbiddenCameras())
        cameras.push_back(std::move(camera));
    return cameras;
}

} // namespace odo
