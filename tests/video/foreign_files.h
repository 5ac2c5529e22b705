// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/video/frame.h"

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

struct AVFrame;

namespace odo::test {

/// Copies the packets of a video into another container, chosen by its name, as an editor or a camera would
/// have written them. False when libav would not. turn: a, b, c, d of a display matrix that it writes, 1 or
/// -1 each (orientationOfMatrix); all zero: none.
/// recordedAt: the time that a camera notes, "2024-05-06T10:11:03Z". withSound: a track of silence beside it.
bool remux(const std::filesystem::path &from, const std::filesystem::path &to,
           const std::array<int, 4> &turn = {}, const std::string &recordedAt = {}, bool withSound = false);

/// A video to be written by one of libav's encoders.
struct RawVideo
{
    std::string encoder, pixelFormat; ///< by libav's names
    int frames = 0, width = 0, height = 0, ticksPerSecond = 25;
    std::int64_t interval = 1;                  ///< between two frames, in ticks
    bool isInterlaced = false;                  ///< of two fields, the top one first
    std::function<void(AVFrame &, int)> fill{}; ///< the planes of a frame, by its number
    int aspectWidth = 0, aspectHeight = 1;      ///< of a pixel; 0: not stated
    std::array<int, 4> turn{};                  ///< as in remux
    int range = 0, matrix = 2, transfer = 2;    ///< of colours, by H.273; range 1: limited, 2: full
    std::vector<std::int64_t> ticks{};          ///< of each frame, where they are not even
    std::vector<std::pair<const char *, const char *>> coding{}, muxing{}; ///< options of libav
    std::vector<std::pair<const char *, const char *>> metadata{};         ///< of the container
};
bool writeRaw(const std::filesystem::path &to, const RawVideo &video);

/// Writes `frames` pictures of 4:3 in a pixel format of libav's ("nv12", "gray", "yuv420p10le", ...) with
/// one of its encoders. Of every picture i, each byte of plane p is 40 + 20 p + i; in semi-planar chroma, odd
/// bytes are 100 more. interval: between two pictures, in ticks, of which a second has 25. isInterlaced: the
/// top field first; each byte of the bottom field is 50 more.
bool writeRaw(const std::filesystem::path &to, const std::string &encoder, const std::string &pixelFormat,
              int frames, std::int64_t interval = 1, int width = 64, int ticksPerSecond = 25,
              bool isInterlaced = false);

/// Writes the luma of frames, 25 of them a second, without loss. isInterlaced: as frames of two fields, of
/// which the top one is first.
bool writeLuma(const std::filesystem::path &to, const std::vector<Frame> &frames, bool isInterlaced);

} // namespace odo::test
