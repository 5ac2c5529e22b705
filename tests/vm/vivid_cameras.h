// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"

#include <QByteArray>
#include <string>
#include <vector>

namespace odo::test {

/// Sets a control of an emulated camera from outside of the program under test, as another program would. The
/// test fails when that cannot be done.
void setVivid(const std::string &node, const std::string &control, double value);

/// Opens a camera; where that cannot be done the test fails with the words.
std::unique_ptr<CameraSource> opened(const std::string &uri);

/// What came until so many pictures had, or so many times none.
struct Taken
{
    std::vector<CapturedFrame> frames;
    std::vector<Error> problems;
    std::uint64_t lost = 0; ///< gaps in the sequence

    std::uint64_t span() const
    {
        return frames.empty() ? 0 : frames.back().sequence - frames.front().sequence + 1;
    }
};
Taken take(CameraSource &source, std::size_t frames, std::size_t mostProblems = 6);

/// Whether sequence and time rise from each picture to the next.
bool rises(const Taken &taken);

/// Runs a command in the machine; false when it fails.
bool shell(const char *command);

} // namespace odo::test
