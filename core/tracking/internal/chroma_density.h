// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <initializer_list>

namespace odo {

/// How chroma is spread over 64×64 bins of 4×4 code values: a histogram, or a density that sums to one.
class ChromaDensity
{
public:
    static constexpr int binShift = 2;
    static constexpr int binsPerAxis = 256 >> binShift;
    static constexpr int binCount = binsPerAxis * binsPerAxis;

    static constexpr std::size_t binOf(std::uint8_t u, std::uint8_t v)
    {
        return (static_cast<std::size_t>(u >> binShift) * binsPerAxis) + (v >> binShift);
    }
    /// The chroma of the middle of a bin.
    static Chroma centreOf(std::size_t bin);

    float operator[](std::size_t bin) const { return m_bins[bin]; }
    float &operator[](std::size_t bin) { return m_bins[bin]; }

    /// Counts one sample of every step×step block of the area.
    void count(const ChromaGrid &grid, const ChromaRect &area, int step, float weight = 1.0f);
    double sum() const;
    /// Scales to sum one; an empty density stays empty.
    void normalise();
    /// Convolves with the binomial kernel (1 2 1)/4 along both axes, the given number of times.
    void blur(int times);
    /// The density as dimmer or brighter light would show it: at each chroma the highest value that the
    /// density has along the same ray between 1/high and 1/low times as far out; extreme light counts for
    /// less. The maximum instead of the sum keeps a dim side of a robot as likely as a lit one.
    ChromaDensity underOtherLight(double low, double high) const;
    /// The density with every chroma made `scale` times as saturated and its hue turned. Values are kept, not
    /// the sum.
    ChromaDensity transformed(double scale, double turnRad) const;
    /// Bhattacharyya coefficient of two normalised densities: 1 for equal ones, 0 for disjoint ones.
    double overlap(const ChromaDensity &other) const;

private:
    struct Support
    {
        double beginU, endU, beginV, endV;
    };
    struct Bins
    {
        int firstU, lastU, firstV, lastV;

        template <class Function>
        void forEach(Function function) const
        {
            for (int u = firstU; u <= lastU; ++u)
                for (int v = firstV; v <= lastV; ++v)
                    function(static_cast<std::size_t>(u) * binsPerAxis + static_cast<std::size_t>(v));
        }
    };
    Support support() const;
    static Bins reachOf(const Support &support, std::initializer_list<double> scales, double turnRad);
    float interpolated(const Chroma &chroma, const Support &support) const;

    std::array<float, binCount> m_bins{};
};

/// 1 at the given chroma, falling with the angle between the hues and, outside 0.6 to 1.5 times its
/// saturation, with the saturation: how well the observed colour may be the given one under some light and
/// camera.
double likeness(const Chroma &seen, const Chroma &given);

/// The likeness as a density.
ChromaDensity densityOfGivenColour(const Chroma &given);

/// For each chroma bin the probability (0 to 255) that a sample of it is the robot's, the robot and the rest
/// being equally likely beforehand. What the inner loops read.
class ChromaTable
{
public:
    static constexpr std::uint8_t threshold = 128; ///< at least this counts as the robot's

    ChromaTable() = default;
    /// Weight = F/(F + B + uncertainty): robot and background as densities that sum to about one; uncertainty
    /// lowers the weight of a chroma that was never seen.
    ChromaTable(const ChromaDensity &robot, const ChromaDensity &background, float uncertainty);

    /// Takes what either table takes.
    void add(const ChromaTable &other);

    std::uint8_t weight(std::uint8_t u, std::uint8_t v) const
    {
        return m_weights[ChromaDensity::binOf(u, v)];
    }

    static constexpr int blockSamples = 16;
    /// Whether any of so many samples side by side may be the robot's: false spares looking at each.
    bool mayTakeBlock(const std::uint8_t *u, const std::uint8_t *v) const
    {
        using Bytes = std::uint8_t __attribute__((vector_size(blockSamples)));
        using Longs = std::uint64_t __attribute__((vector_size(blockSamples)));
        Bytes us, vs;
        std::memcpy(&us, u, sizeof(us));
        std::memcpy(&vs, v, sizeof(vs));
        const auto any = reinterpret_cast<Longs>((us - m_leastU <= m_rangeU) & (vs - m_leastV <= m_rangeV));
        return (any[0] | any[1]) != 0;
    }

private:
    void findBox();
    static void setRange(const std::array<std::uint8_t, ChromaDensity::binsPerAxis> &most,
                         std::uint8_t &least, std::uint8_t &range);

    std::array<std::uint8_t, ChromaDensity::binCount> m_weights{};
    std::uint8_t m_leastU = 0, m_rangeU = 0, m_leastV = 0, m_rangeV = 0; ///< code values of all that is taken
};

} // namespace odo
