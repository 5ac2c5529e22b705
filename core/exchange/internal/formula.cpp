// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/formula.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace odo {

/// Recursive descent over one formula.
class FormulaParser
{
public:
    explicit FormulaParser(std::string_view text) : m_text(text) {}

    Result<Formula> parse()
    {
        if (m_text.size() > Formula::longest)
            return wrong(ODO_TEXT("exchange.formula_too_long", "it is too long"));
        if (!sum())
            return tl::unexpected(*m_error);
        skipBlanks();
        if (m_at < m_text.size())
            return wrong(ODO_TEXT("exchange.formula_sign", "'%1' is not expected at character %2")(
                std::string(1, m_text[m_at]), m_at + 1));
        return std::move(m_formula);
    }

private:
    using Step = Formula::Step;
    static constexpr int deepest = 60;

    tl::unexpected<Error> wrong(Message why)
    {
        m_error = Error{
            ErrorCode::InvalidInput,
            ODO_TEXT("exchange.formula", "formula '%1'")(std::string(m_text.substr(0, 60))), std::move(why),
            ODO_TEXT("exchange.formula_advice",
                     "write one like 0.5 * mass * max_speed^2, with names of metrics and variables")};
        return tl::unexpected(*m_error);
    }
    bool fail(Message why)
    {
        wrong(std::move(why));
        return false;
    }
    void skipBlanks()
    {
        while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at])) != 0)
            ++m_at;
    }
    bool take(char sign)
    {
        skipBlanks();
        if (m_at >= m_text.size() || m_text[m_at] != sign)
            return false;
        ++m_at;
        return true;
    }
    void add(Step step) { m_formula.m_operations.push_back({step, 0, 0, {}}); }

    bool sum()
    {
        if (!product())
            return false;
        for (;;) {
            const Step step = take('+') ? Step::Add : take('-') ? Step::Subtract : Step::Number;
            if (step == Step::Number)
                return true;
            if (!product())
                return false;
            add(step);
        }
    }
    bool product()
    {
        if (!factor())
            return false;
        for (;;) {
            const Step step = take('*') ? Step::Multiply : take('/') ? Step::Divide : Step::Number;
            if (step == Step::Number)
                return true;
            if (!factor())
                return false;
            add(step);
        }
    }
    /// −2^2 is −4, as people write it; 2^−1 and 2^3^2 = 2^9 work.
    bool factor()
    {
        if (++m_depth > deepest)
            return fail(ODO_TEXT("exchange.formula_too_deep", "it has too many brackets in each other"));
        bool isFine = false;
        if (take('-')) {
            isFine = factor();
            add(Step::Negate);
        } else if (take('+')) {
            isFine = factor();
        } else {
            isFine = operand();
            if (isFine && take('^')) {
                isFine = factor();
                add(Step::Power);
            }
        }
        --m_depth;
        return isFine;
    }
    bool operand()
    {
        if (take('('))
            return sum() && close();
        if (take('{')) {
            const std::size_t end = m_text.find('}', m_at);
            if (end == std::string_view::npos)
                return fail(ODO_TEXT("exchange.formula_brace", "a closing brace is missing"));
            addName(std::string(m_text.substr(m_at, end - m_at)));
            m_at = end + 1;
            return true;
        }
        skipBlanks();
        if (m_at >= m_text.size())
            return fail(ODO_TEXT("exchange.formula_ends", "a number or a name is missing at its end"));
        const char sign = m_text[m_at];
        if (std::isdigit(static_cast<unsigned char>(sign)) != 0 || sign == '.')
            return number();
        if (isLetter(sign))
            return word();
        return fail(ODO_TEXT("exchange.formula_sign",
                             "'%1' is not expected at character %2")(std::string(1, sign), m_at + 1));
    }
    bool close()
    {
        return take(')') || fail(ODO_TEXT("exchange.formula_bracket", "a closing bracket is missing"));
    }
    bool number()
    {
        double value = 0;
        const auto [end, problem] =
            std::from_chars(m_text.data() + m_at, m_text.data() + m_text.size(), value);
        if (problem != std::errc())
            return fail(ODO_TEXT("exchange.formula_number", "there is no number at character %1")(m_at + 1));
        m_at = static_cast<std::size_t>(end - m_text.data());
        m_formula.m_operations.push_back({Step::Number, value, 0, {}});
        return true;
    }
    /// Letters of any alphabet: all bytes beyond ASCII.
    static bool isLetter(char sign)
    {
        const auto byte = static_cast<unsigned char>(sign);
        return byte >= 0x80 || std::isalpha(byte) != 0 || sign == '_';
    }
    bool word()
    {
        const std::size_t begin = m_at;
        while (m_at < m_text.size() &&
               (isLetter(m_text[m_at]) || std::isdigit(static_cast<unsigned char>(m_text[m_at])) != 0))
            ++m_at;
        const std::string_view name = m_text.substr(begin, m_at - begin);
        if (take('('))
            return call(name);
        if (name == "pi")
            m_formula.m_operations.push_back({Step::Number, std::numbers::pi, 0, {}});
        else
            addName(std::string(name));
        return true;
    }
    bool call(std::string_view name)
    {
        using Function = Formula::Function;
        static constexpr std::array<std::pair<std::string_view, Function>, 11> functions{
            {{"sqrt", Function::Sqrt},
             {"abs", Function::Abs},
             {"exp", Function::Exp},
             {"ln", Function::Ln},
             {"log10", Function::Log10},
             {"sin", Function::Sin},
             {"cos", Function::Cos},
             {"tan", Function::Tan},
             {"min", Function::Min},
             {"max", Function::Max},
             {"hypot", Function::Hypot}}};
        const auto *const found =
            std::ranges::find(functions, name, &std::pair<std::string_view, Function>::first);
        if (found == functions.end())
            return fail(
                ODO_TEXT("exchange.formula_function", "there is no function '%1'")(std::string(name)));
        if (!sum())
            return false;
        if (Formula::takesTwo(found->second) &&
            !((take(',') || fail(ODO_TEXT("exchange.formula_two",
                                          "'%1' takes two values, parted by a comma")(std::string(name)))) &&
              sum()))
            return false;
        m_formula.m_operations.push_back({Step::Call, 0, 0, found->second});
        return close();
    }
    void addName(std::string name)
    {
        const auto found = std::ranges::find(m_formula.m_names, name);
        const auto index = static_cast<std::size_t>(found - m_formula.m_names.begin());
        if (found == m_formula.m_names.end())
            m_formula.m_names.push_back(std::move(name));
        m_formula.m_operations.push_back({Step::Name, 0, index, {}});
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    int m_depth = 0;
    Formula m_formula;
    std::optional<Error> m_error;
};

Result<Formula> Formula::parse(std::string_view text)
{
    return FormulaParser(text).parse();
}

bool Formula::takesTwo(Function function)
{
    return function == Function::Min || function == Function::Max || function == Function::Hypot;
}

Formula::Dual Formula::called(Function function, const Dual &a, const Dual &b)
{
    switch (function) {
    case Function::Sqrt:
        return {std::sqrt(a.value), a.slope == 0 ? 0 : a.slope / (2 * std::sqrt(a.value))};
    case Function::Abs:
        return {std::abs(a.value), a.value < 0 ? -a.slope : a.slope};
    case Function::Exp:
        return {std::exp(a.value), a.slope * std::exp(a.value)};
    case Function::Ln:
        return {std::log(a.value), a.slope / a.value};
    case Function::Log10:
        return {std::log10(a.value), a.slope / (a.value * std::numbers::ln10)};
    case Function::Sin:
        return {std::sin(a.value), a.slope * std::cos(a.value)};
    case Function::Cos:
        return {std::cos(a.value), -a.slope * std::sin(a.value)};
    case Function::Tan:
        return {std::tan(a.value), a.slope / (std::cos(a.value) * std::cos(a.value))};
    case Function::Min:
        return a.value <= b.value ? a : b;
    case Function::Max:
        return a.value >= b.value ? a : b;
    case Function::Hypot:
        break;
    }
    const double length = std::hypot(a.value, b.value);
    return {length, length == 0 ? 0 : (a.value * a.slope + b.value * b.slope) / length};
}

/// The logarithm only where the exponent varies: it is not known of negative numbers.
Formula::Dual Formula::power(const Dual &a, const Dual &b)
{
    const double value = std::pow(a.value, b.value);
    double slope = 0;
    if (a.slope != 0)
        slope += b.value * std::pow(a.value, b.value - 1) * a.slope;
    if (b.slope != 0)
        slope += value * std::log(a.value) * b.slope;
    return {value, slope};
}

Formula::Dual Formula::run(std::span<const double> values, std::optional<std::size_t> by) const
{
    std::vector<Dual> stack;
    const auto pop = [&stack] {
        const Dual top = stack.back();
        stack.pop_back();
        return top;
    };
    for (const Operation &operation : m_operations) {
        if (operation.step == Step::Number) {
            stack.push_back({operation.number, 0});
            continue;
        }
        if (operation.step == Step::Name) {
            stack.push_back({values[operation.index], by == operation.index ? 1.0 : 0.0});
            continue;
        }
        const bool isOfOne =
            operation.step == Step::Negate || (operation.step == Step::Call && !takesTwo(operation.function));
        const Dual b = isOfOne ? Dual() : pop();
        const Dual a = pop();
        switch (operation.step) {
        case Step::Add:
            stack.push_back({a.value + b.value, a.slope + b.slope});
            break;
        case Step::Subtract:
            stack.push_back({a.value - b.value, a.slope - b.slope});
            break;
        case Step::Multiply:
            stack.push_back({a.value * b.value, a.slope * b.value + a.value * b.slope});
            break;
        case Step::Divide:
            stack.push_back(
                {a.value / b.value, (a.slope * b.value - a.value * b.slope) / (b.value * b.value)});
            break;
        case Step::Power:
            stack.push_back(power(a, b));
            break;
        case Step::Negate:
            stack.push_back({-a.value, -a.slope});
            break;
        default:
            stack.push_back(called(operation.function, a, b));
        }
    }
    return stack.back();
}

std::optional<Formula::Outcome> Formula::evaluate(std::span<const double> values) const
{
    Outcome outcome{run(values, std::nullopt).value, {}};
    if (!std::isfinite(outcome.value))
        return std::nullopt;
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        outcome.slopes.push_back(run(values, i).slope);
        if (!std::isfinite(outcome.slopes.back()))
            return std::nullopt;
    }
    return outcome;
}

} // namespace odo
