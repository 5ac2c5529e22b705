// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/track_reading.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

template <class Words>
bool isAmong(const Words &words, std::string_view word)
{
    return std::ranges::find(words, word) != words.end();
}

/// What the name of a column says. "field.pose.position.x" is the axis x of a position; "X#wcentroid (cm)"
/// too, in centimetres; "robot 1/Y" is the axis y of "robot 1". Plain value.
class ColumnName
{
public:
    explicit ColumnName(std::string_view cell);

    const std::string &lower() const { return m_lower; } ///< all of it, in lower case
    const std::string &unit() const { return m_unit; }   ///< in lower case; may be empty
    bool hasUnit() const { return !m_unit.empty(); }
    bool isBracketed() const { return m_isBracketed; }                ///< its unit; nothing else can be meant
    const std::vector<std::string> &words() const { return m_words; } ///< in lower case, without the unit
    std::string joinedWords() const;                                  ///< by '_'

    /// 'x', 'y', 'z' or 'w', where one of the words says so; else 0.
    char axis() const { return m_axis; }
    /// The words besides the axis, as they are written; of a position only those that are no words for one.
    const std::string &owner() const { return m_owner; }
    bool isPosition() const { return m_axis != 0 && m_axis != 'w' && m_isPosition; }
    bool isPlainAxis() const { return isPosition() && m_words.size() == 1; }
    bool isQuaternion() const { return m_axis != 0 && m_isQuaternion; }

    std::optional<LengthUnit> lengthUnit() const;
    std::optional<TimeUnit> timeUnit() const;
    std::optional<double> radiansPerUnit() const;

private:
    void takeUnit(std::string &text);
    void readAxis(const std::vector<std::string> &written);

    std::string m_lower, m_unit, m_owner;
    std::vector<std::string> m_words;
    bool m_isBracketed = false, m_isPosition = false, m_isQuaternion = false;
    char m_axis = 0;
};

std::optional<LengthUnit> lengthUnitNamed(std::string_view lower);
std::optional<TimeUnit> timeUnitNamed(std::string_view lower);

} // namespace odo
