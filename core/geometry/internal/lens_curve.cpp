// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/internal/lens_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace odo {

namespace {

constexpr double farthestRadius = 100; // 89.4° from the axis: beyond any flat lens model

constexpr std::size_t degree = 6;
using Polynomial = std::array<double, degree + 1>; ///< coefficients, the constant first

/// Of the same polynomial in t, where u = from + width t.
Polynomial shifted(Polynomial p, double from, double width)
{
    for (std::size_t done = 0; done < degree; ++done) // Horner's scheme, again and again
        for (std::size_t i = degree; i > done; --i)
            p[i - 1] += from * p[i];
    double scale = 1;
    for (double &coefficient : p) {
        coefficient *= scale;
        scale *= width;
    }
    return p;
}

/// Whether all coefficients in Bernstein's basis over [0, 1] are positive, and with them all values there.
bool isSurelyPositive(const Polynomial &p)
{
    // (j over k) / (degree over k)
    static const auto shares = [] {
        std::array<std::array<double, degree + 1>, degree + 1> table{};
        for (std::size_t j = 0; j <= degree; ++j) {
            table[j][0] = 1;
            for (std::size_t k = 1; k <= j; ++k)
                table[j][k] = table[j][k - 1] * double(j + 1 - k) / double(degree + 1 - k);
        }
        return table;
    }();
    for (std::size_t j = 0; j <= degree; ++j) {
        double coefficient = 0;
        for (std::size_t k = 0; k <= j; ++k)
            coefficient += shares[j][k] * p[k];
        if (!(coefficient > 0))
            return false;
    }
    return true;
}

/// As far as a polynomial is positive within [from, to]: to `to`, or to its first root there.
double positiveWithin(const Polynomial &p, double from, double to)
{
    if (isSurelyPositive(shifted(p, from, to - from)))
        return to;
    const double middle = 0.5 * (from + to);
    if (!(middle > from && middle < to))
        return from;
    const double reached = positiveWithin(p, from, middle);
    return reached < middle ? reached : positiveWithin(p, middle, to);
}

/// As far as a polynomial that is positive at 0 stays so, at most to `end`. Found in ranges that widen, for
/// the rounding of coefficients over a wide one would hide what is near 0.
double positiveUpTo(const Polynomial &p, double end)
{
    double from = 0;
    for (double to = 1.0 / 16; from < end; to *= 4) {
        const double reached = positiveWithin(p, from, std::min(to, end));
        if (reached < std::min(to, end))
            return reached;
        from = reached;
    }
    return end;
}

} // namespace

double LensCurve::value(double argument) const
{
    const double u = argument * argument;
    if (m_fisheye)
        return argument * (1 + u * (m_k[0] + u * (m_k[1] + u * (m_k[2] + u * m_k[3]))));
    const double above = 1 + u * (m_k[0] + u * (m_k[1] + u * m_k[4]));
    const double below = 1 + u * (m_k[5] + u * (m_k[6] + u * m_k[7]));
    return argument * above / below;
}

double LensCurve::slope(double argument) const
{
    const double u = argument * argument;
    if (m_fisheye)
        return 1 + u * (3 * m_k[0] + u * (5 * m_k[1] + u * (7 * m_k[2] + u * 9 * m_k[3])));
    const double above = 1 + u * (m_k[0] + u * (m_k[1] + u * m_k[4]));
    const double below = 1 + u * (m_k[5] + u * (m_k[6] + u * m_k[7]));
    const double aboveByU = m_k[0] + u * (2 * m_k[1] + u * 3 * m_k[4]);
    const double belowByU = m_k[5] + u * (2 * m_k[6] + u * 3 * m_k[7]);
    if (below <= 0)
        return -1; // past a pole of the rational model: certainly not usable
    return (above + 2 * u * aboveByU) / below - 2 * u * above * belowByU / (below * below);
}

double LensCurve::limit() const
{
    const double end = m_fisheye ? std::numbers::pi : farthestRadius;
    if (std::all_of(m_k.begin(), m_k.end(), [](double k) { return k == 0; }))
        return m_fisheye ? end : std::numeric_limits<double>::infinity();
    if (m_fisheye)
        return std::sqrt(positiveUpTo({1, 3 * m_k[0], 5 * m_k[1], 7 * m_k[2], 9 * m_k[3], 0, 0}, end * end));
    // The curve is x a(u) / b(u), u = x²; it grows while b and a b + 2 u (a' b - a b') are positive.
    const std::array<double, 4> a{1, m_k[0], m_k[1], m_k[4]}, b{1, m_k[5], m_k[6], m_k[7]};
    Polynomial growth{};
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
            growth[i + k] += (1 + 2 * (double(i) - double(k))) * a[i] * b[k];
    return std::sqrt(positiveUpTo(growth, positiveUpTo({b[0], b[1], b[2], b[3], 0, 0, 0}, end * end)));
}

std::optional<double> LensCurve::inverse(double wanted, double limit) const
{
    if (wanted == 0)
        return 0.0;
    double low = 0;
    double high = std::isinf(limit) ? wanted : limit; // without a limit the curve is the identity
    if (!(value(high) >= wanted))
        return std::nullopt;
    double argument = std::min(wanted, high);
    for (int i = 0; i < 100; ++i) {
        const double error = value(argument) - wanted;
        (error > 0 ? high : low) = argument;
        if (std::abs(error) < 1e-15 * std::max(1.0, wanted))
            break;
        double next = argument - error / slope(argument);
        if (!(next > low && next < high)) // Newton left the bracket
            next = 0.5 * (low + high);
        if (next == argument)
            break;
        argument = next;
    }
    return argument;
}

} // namespace odo
