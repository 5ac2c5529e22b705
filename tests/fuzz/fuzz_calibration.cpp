// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"
#include "tests/fuzz/fuzz_file.h"

namespace {

/// Coefficients at the end that are zero bend nothing: none at all are written as zeros, for other programs
/// read no empty matrix.
std::vector<double> withoutZerosAtTheEnd(std::vector<double> distortion)
{
    while (!distortion.empty() && distortion.back() == 0)
        distortion.pop_back();
    return distortion;
}

bool isSameIntrinsics(const odo::Intrinsics &a, const odo::Intrinsics &b)
{
    return a.model == b.model && a.fxPx == b.fxPx &&
           withoutZerosAtTheEnd(a.distortion) == withoutZerosAtTheEnd(b.distortion);
}

} // namespace

/// A calibration in any of the styles that are read. What is read must be written and read again as the same.
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
        if (!again || !isSameIntrinsics(again->intrinsics, read->intrinsics)) {
            std::fprintf(stderr, "written as:\n%s\n%s\n", text.c_str(),
                         again ? "other numbers" : again.error().message().c_str());
            std::abort();
        }
    }
    return 0;
}
