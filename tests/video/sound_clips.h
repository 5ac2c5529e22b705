// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace odo::test {

/// A small video with sound, as a camera writes it: H.264 of 30 frames a second with B frames.
struct SoundClip
{
    double lengthS = 3;
    std::vector<float> sound; ///< peaks at 1; none: the file has no sound stream
    int soundRate = 48'000;
    int channels = 1; ///< the sound is in the last one alone
    std::string codec = "aac";
    int bitRate = 96'000;
    double soundLateS = 0; ///< after the first frame; negative: before it
    double gapAtS = 1e9;   ///< packets that begin in gapS from here on are left out
    double gapS = 0.1;
};

/// The container is chosen by the name. False when libav would not.
bool writeSoundClip(const std::filesystem::path &to, const SoundClip &clip);

/// Silence with clicks in it: short bursts at these seconds.
std::vector<float> clicksAt(const std::vector<double> &timesS, double lengthS, int rate);

} // namespace odo::test
