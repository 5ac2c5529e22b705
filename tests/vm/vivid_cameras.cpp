// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/vm/vivid_cameras.h"

#include "core/capture/v4l2/internal/v4l2_device.h"

#include <QTest>
#include <cstdlib>

namespace odo::test {

void setVivid(const std::string &node, const std::string &control, double value)
{
    const auto device = V4l2Device::open(node, node);
    if (!device)
        QFAIL(device.error().message().c_str());
    if (const auto done = setV4l2Control(**device, node, control, value); !done)
        QFAIL((control + ": " + done.error().message()).c_str());
}

std::unique_ptr<CameraSource> opened(const std::string &uri)
{
    auto source = openCamera(uri);
    if (source)
        return std::move(*source);
    QTest::qFail(source.error().message().c_str(), __FILE__, __LINE__);
    return nullptr;
}

Taken take(CameraSource &source, std::size_t frames, std::size_t mostProblems)
{
    Taken taken;
    while (taken.frames.size() < frames && taken.problems.size() < mostProblems) {
        auto captured = source.next();
        if (!captured) {
            taken.problems.push_back(captured.error());
            continue;
        }
        if (!taken.frames.empty() && captured->sequence > taken.frames.back().sequence)
            taken.lost += captured->sequence - taken.frames.back().sequence - 1;
        taken.frames.push_back(std::move(*captured));
    }
    return taken;
}

bool rises(const Taken &taken)
{
    for (std::size_t i = 1; i < taken.frames.size(); ++i) {
        const CapturedFrame &before = taken.frames[i - 1], &after = taken.frames[i];
        if (after.sequence <= before.sequence || after.frame.time <= before.frame.time ||
            after.hostTime < before.hostTime)
            return false;
    }
    return !taken.frames.empty();
}

bool shell(const char *command)
{
    return std::system(command) == 0;
}

} // namespace odo::test
