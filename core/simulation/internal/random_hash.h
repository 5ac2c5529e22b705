// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace odo {

/// A number that looks random but depends only on its arguments (SplitMix64's finaliser, Steele et al. 2014):
/// what makes pictures the same whatever the order in which they are asked for.
inline std::uint64_t randomHash(std::uint64_t a, std::uint64_t b)
{
    std::uint64_t z = a * 0x9e3779b97f4a7c15ull + b + 0x9e3779b97f4a7c15ull;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

/// As randomHash, in [-1, 1).
inline double randomSigned(std::uint64_t a, std::uint64_t b)
{
    return static_cast<double>(randomHash(a, b) >> 11) * 0x1p-52 - 1.0;
}

} // namespace odo
