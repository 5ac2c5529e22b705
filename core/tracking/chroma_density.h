// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma.h"

#include <array>
#include <cstddef>
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
    /// Convolves with the binomial kernel (1 2 1)/4 along both axes, as often as told.
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

/// 1 at the told chroma, falling with the angle between the hues and, outside 0.6 to 1.5 times its
/// saturation, with the saturation: how well what is seen may be a told colour seen by a camera under some
/// light.
double likeness(const Chroma &seen, const Chroma &told);

/// The likeness as a density.
ChromaDensity densityOfToldColour(const Chroma &told);

} // namespace odo
