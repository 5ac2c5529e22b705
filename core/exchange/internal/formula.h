// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace odo {

/// A formula that a person wrote: + − * / ^, brackets, numbers with a decimal point, pi, the functions sqrt,
/// abs, exp, ln, log10, sin, cos, tan (radians), min, max, hypot, and names, which are in braces where they
/// have other signs than letters, digits and _: "0.5 * {robot mass} * max_speed^2". Immutable value; any
/// thread.
class Formula
{
public:
    static constexpr std::size_t longest = 500; ///< bytes

    /// InvalidInput says what is wrong and where.
    static Result<Formula> parse(std::string_view text);
    /// Each once, in the order in which they appear.
    const std::vector<std::string> &names() const { return m_names; }
    /// values: of the names, as many. The value, and how it changes with each of them. nullopt where it is
    /// not a finite number.
    struct Outcome
    {
        double value = 0;
        std::vector<double> slopes; ///< partial derivatives
    };
    std::optional<Outcome> evaluate(std::span<const double> values) const;

private:
    friend class FormulaParser;
    enum class Step { Number, Name, Add, Subtract, Multiply, Divide, Power, Negate, Call };
    enum class Function { Sqrt, Abs, Exp, Ln, Log10, Sin, Cos, Tan, Min, Max, Hypot };
    struct Operation
    {
        Step step = Step::Number;
        double number = 0;
        std::size_t index = 0; ///< of a name
        Function function = Function::Sqrt;
    };
    /// A number and its derivative.
    struct Dual
    {
        double value = 0, slope = 0;
    };
    Dual run(std::span<const double> values, std::optional<std::size_t> by) const;
    static Dual called(Function function, const Dual &a, const Dual &b);
    static Dual power(const Dual &a, const Dual &b);
    static bool takesTwo(Function function);

    std::vector<std::string> m_names;
    std::vector<Operation> m_operations; ///< in reverse Polish order
};

} // namespace odo
