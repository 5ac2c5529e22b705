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

Taken take(CameraSource &source, std::size_t pictures, std::size_t mostProblems)
{
    Taken taken;
    while (taken.pictures.size() < pictures && taken.problems.size() < mostProblems) {
        auto captured = source.next();
        if (!captured) {
            taken.problems.push_back(captured.error());
            continue;
        }
        if (!taken.pictures.empty() && captured->sequence > taken.pictures.back().sequence)
            taken.lost += captured->sequence - taken.pictures.back().sequence - 1;
        taken.pictures.push_back(std::move(*captured));
    }
    return taken;
}

bool rises(const Taken &taken)
{
    for (std::size_t i = 1; i < taken.pictures.size(); ++i) {
        const CapturedFrame &before = taken.pictures[i - 1], &after = taken.pictures[i];
        if (after.sequence <= before.sequence || after.frame.time <= before.frame.time ||
            after.hostTime < before.hostTime)
            return false;
    }
    return !taken.pictures.empty();
}

bool shell(const char *command)
{
    return std::system(command) == 0;
}

} // namespace odo::test
