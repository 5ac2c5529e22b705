// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace odo::test {

/// The dice of one scene and seed: what differs between seeds is drawn from here, and the same on every run.
class SeededDraw
{
public:
    SeededDraw(std::string_view scene, unsigned seed) : m_random(mixed(scene, seed)) {}

    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }
    double gaussian(double sigma) { return std::normal_distribution<double>(0, sigma)(m_random); }
    double sign() { return between(0, 1) < 0.5 ? -1.0 : 1.0; }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_random); }

private:
    /// FNV-1a of the name, so that scenes share nothing.
    static std::uint32_t mixed(std::string_view scene, unsigned seed)
    {
        std::uint32_t hash = 2166136261u ^ (seed * 2654435761u);
        for (const char letter : scene)
            hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
        return hash;
    }

    std::mt19937 m_random;
};

} // namespace odo::test
