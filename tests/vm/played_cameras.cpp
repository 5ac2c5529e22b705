// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/vm/played_cameras.h"

#include "tests/video/jpeg_images.h"

#include <QTest>
#include <algorithm>

namespace odo::test {

const UsbBytes &playedFrame()
{
    static const UsbBytes image = [] {
        FrameFormat format;
        format.width = 320;
        format.height = 240;
        format.chromaShiftY = 0;
        return jpegOf(format, {});
    }();
    return image;
}

std::unique_ptr<UvcCamera> playedCamera(unsigned port, const std::string &name, const std::string &serial)
{
    auto camera = std::make_unique<UvcCamera>(port, UvcCamera::Identity{name, serial},
                                              std::vector<UsbBytes>{withoutHuffmanTables(playedFrame())});
    if (QTest::qWaitFor([&] { return camera->plug(); })) // a port is free only a while after it was left
        return camera;
    QTest::qFail("the kernel does not take the played camera", __FILE__, __LINE__);
    return nullptr;
}

std::vector<CameraDescription> usbCameras()
{
    std::vector<CameraDescription> cameras = listCameras();
    std::erase_if(cameras, [](const CameraDescription &camera) { return camera.kind != "v4l2"; });
    return cameras;
}

std::string playedUri(const std::string &serial, const std::string &format)
{
    const auto cameras = usbCameras();
    const auto found = std::ranges::find(cameras, serial, &CameraDescription::serial);
    return found == cameras.end() ? std::string() : found->uri + "?size=320x240&rate=15&format=" + format;
}

} // namespace odo::test
