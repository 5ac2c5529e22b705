// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace odo {

/// Encodes frames as JPEG pictures for a recording of a camera that gives raw ones, from their planes and with their
/// chroma as it is. JPEG is full range by definition: samples of a limited range are stretched. Keeps its memory; any
/// thread, one at a time.
class JpegEncoder
{
public:
    /// quality: 1 to 100. At 92 tracking loses nothing that can be measured.
    explicit JpegEncoder(int quality = 92);
    ~JpegEncoder();
    JpegEncoder(const JpegEncoder &) = delete;
    JpegEncoder &operator=(const JpegEncoder &) = delete;

    /// InvalidInput for a layout of chroma that JPEG does not have.
    Result<std::vector<std::uint8_t>> encode(const Frame &frame);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
