// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/intrinsics_yaml.h"
#include "tests/fuzz/fuzz_file.h"

/// A calibration as ROS or OpenCV writes it. What is read must be written and read again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    static fuzz::File file(".yaml");
    const auto read = readCalibrationFile(file.holding(bytes, count));
    if (!read)
        return 0;
    for (const IntrinsicsFormat format : {IntrinsicsFormat::Ros, IntrinsicsFormat::OpenCv}) {
        const std::string text = intrinsicsText(read->cameraName, read->intrinsics, format);
        const auto again = parseCalibration("again.yaml", text);
        if (!again || again->intrinsics.fxPx != read->intrinsics.fxPx || again->intrinsics.distortion != read->intrinsics.distortion) {
            std::fprintf(stderr, "written as:\n%s\n%s\n", text.c_str(), again ? "other numbers" : again.error().message().c_str());
            std::abort();
        }
    }
    return 0;
}
