// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "tests/fuzz/fuzz_file.h"

/// A still picture: PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM. Those of a size that would only be slow are left
/// out.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count)
{
    using namespace odo;
    constexpr std::uint64_t mostPixels = 1 << 20;
    const auto size = imageHeader({bytes, count});
    if (size && std::uint64_t(size->width) * size->height > mostPixels)
        return 0;
    static fuzz::File file(".png");
    const auto frame = readImage(file.holding(bytes, count));
    if (frame)
        static_cast<void>(toScreen(*frame, 16, 12));
    return 0;
}
