// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/video_writer.h"

#include <QString>
#include <vector>

namespace odo::test {

constexpr int codedBits = 12;

/// 192x96, 4:2:0, full range, centred chroma.
FrameFormat smallFormat();
/// Grey from left (0) to right (255), 256x64, 4:2:0, full range.
Frame rampFrame();
/// A frame over a soft pattern that carries its number as black and white blocks, so that it survives
/// compression.
Frame codedFrame(const FrameFormat &format, int number, Nanoseconds time);
/// The number that codedFrame wrote.
int numberIn(const Frame &frame);

/// A sum that tells any two different pictures apart with near certainty (hashes of the rows of luma and
/// chroma).
std::uint64_t fingerprint(const Frame &frame);

/// Frames numbered 0, 1, ... at these times, written to a file. Fails the calling test by returning an error
/// text.
QString writeCoded(const std::filesystem::path &file, const std::vector<Nanoseconds> &times,
                   const VideoWriterOptions &options, const FrameFormat &format = smallFormat());

std::vector<Nanoseconds> evenTimes(int count, double framesPerSecond);
/// Intervals between 5 and 60 ms without a pattern.
std::vector<Nanoseconds> unevenTimes(int count);

} // namespace odo::test
