// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/column_name.h"

#include "core/base/plain_text.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>

namespace odo {

namespace {

template <class Value>
struct Word
{
    std::string_view name;
    Value value;
};

// Headers come in the languages of those who use the program, too.
constexpr auto lengthWords = std::to_array<Word<LengthUnit>>({
    {"m", LengthUnit::Metre},
    {"meter", LengthUnit::Metre},
    {"meters", LengthUnit::Metre},
    {"metre", LengthUnit::Metre},
    {"metres", LengthUnit::Metre},
    {"metern", LengthUnit::Metre},
    {"mètre", LengthUnit::Metre},
    {"metro", LengthUnit::Metre},
    {"mètres", LengthUnit::Metre},
    {"metros", LengthUnit::Metre},
    {"미터", LengthUnit::Metre},
    {"米", LengthUnit::Metre},
    {"cm", LengthUnit::Centimetre},
    {"centimeters", LengthUnit::Centimetre},
    {"centimetres", LengthUnit::Centimetre},
    {"zentimeter", LengthUnit::Centimetre},
    {"zentimetern", LengthUnit::Centimetre},
    {"centimeter", LengthUnit::Centimetre},
    {"centimetre", LengthUnit::Centimetre},
    {"centimètres", LengthUnit::Centimetre},
    {"centímetros", LengthUnit::Centimetre},
    {"厘米", LengthUnit::Centimetre},
    {"mm", LengthUnit::Millimetre},
    {"millimeter", LengthUnit::Millimetre},
    {"millimetern", LengthUnit::Millimetre},
    {"millimetre", LengthUnit::Millimetre},
    {"millimeters", LengthUnit::Millimetre},
    {"millimetres", LengthUnit::Millimetre},
    {"millimètres", LengthUnit::Millimetre},
    {"milímetros", LengthUnit::Millimetre},
    {"밀리미터", LengthUnit::Millimetre},
    {"毫米", LengthUnit::Millimetre},
    {"in", LengthUnit::Inch},
    {"inch", LengthUnit::Inch},
    {"inches", LengthUnit::Inch},
    {"ft", LengthUnit::Foot},
    {"foot", LengthUnit::Foot},
    {"feet", LengthUnit::Foot},
    {"px", LengthUnit::Pixel},
    {"pix", LengthUnit::Pixel},
    {"pixel", LengthUnit::Pixel},
    {"pixels", LengthUnit::Pixel},
    {"píxeles", LengthUnit::Pixel},
    {"픽셀", LengthUnit::Pixel},
    {"像素", LengthUnit::Pixel},
});
/// Lengths that nobody's robot is measured in: named, so that they are not taken for the name of a track.
constexpr auto otherLengthWords =
    std::to_array<std::string_view>({"dm", "km", "um", "µm", "μm", "nm", "micron", "microns", "yd", "yards",
                                     "mil", "mils", "dezimeter", "kilometers", "kilometres"});
constexpr auto timeWords = std::to_array<Word<TimeUnit>>({
    {"s", TimeUnit::Second},
    {"sec", TimeUnit::Second},
    {"secs", TimeUnit::Second},
    {"second", TimeUnit::Second},
    {"seconds", TimeUnit::Second},
    {"sekunden", TimeUnit::Second},
    {"sekunde", TimeUnit::Second},
    {"sek", TimeUnit::Second},
    {"secondes", TimeUnit::Second},
    {"seconde", TimeUnit::Second},
    {"segundo", TimeUnit::Second},
    {"segundos", TimeUnit::Second},
    {"초", TimeUnit::Second},
    {"秒", TimeUnit::Second},
    {"ms", TimeUnit::Millisecond},
    {"msec", TimeUnit::Millisecond},
    {"millis", TimeUnit::Millisecond},
    {"milliseconds", TimeUnit::Millisecond},
    {"millisecond", TimeUnit::Millisecond},
    {"millisekunden", TimeUnit::Millisecond},
    {"millisecondes", TimeUnit::Millisecond},
    {"milisegundos", TimeUnit::Millisecond},
    {"밀리초", TimeUnit::Millisecond},
    {"毫秒", TimeUnit::Millisecond},
    {"us", TimeUnit::Microsecond},
    {"µs", TimeUnit::Microsecond},
    {"μs", TimeUnit::Microsecond},
    {"usec", TimeUnit::Microsecond},
    {"micros", TimeUnit::Microsecond},
    {"microseconds", TimeUnit::Microsecond},
    {"ns", TimeUnit::Nanosecond},
    {"nsec", TimeUnit::Nanosecond},
    {"nanoseconds", TimeUnit::Nanosecond},
    {"frame", TimeUnit::Frame},
    {"frames", TimeUnit::Frame},
    {"min", TimeUnit::Minute},
    {"mins", TimeUnit::Minute},
    {"minutes", TimeUnit::Minute},
    {"minute", TimeUnit::Minute},
    {"minuto", TimeUnit::Minute},
    {"minuten", TimeUnit::Minute},
    {"minutos", TimeUnit::Minute},
    {"h", TimeUnit::Hour},
    {"hours", TimeUnit::Hour},
    {"days", TimeUnit::Day},
});
constexpr std::array<Word<double>, 5> angleWords{{{"rad", 1.0},
                                                  {"radians", 1.0},
                                                  {"deg", std::numbers::pi / 180},
                                                  {"degrees", std::numbers::pi / 180},
                                                  {"°", std::numbers::pi / 180}}};

/// Words that go with the axis of a position and name nobody.
constexpr auto positionWords = std::to_array<std::string_view>(
    {"pos",        "position",   "positions", "pose",     "poses",      "translation", "transform",
     "p",          "t",          "loc",       "location", "center",     "centre",      "centroid",
     "wcentroid",  "pcentroid",  "point",     "points",   "field",      "data",        "msg",
     "message",    "world",      "coord",     "coords",   "coordinate", "coordinates", "base",
     "link",       "odom",       "odometry",  "global",   "local",      "floor",       "map",
     "estimated",  "measured",   "axis",      "achse",    "axe",        "eje",         "ort",
     "koordinate", "coordonnée", "posición",  "posicion", "coordenada", "위치",        "좌표",
     "位置",       "坐标"});
/// Words that go with axes of something else.
constexpr auto otherWords = std::to_array<std::string_view>({"v",
                                                             "vel",
                                                             "velocity",
                                                             "velocities",
                                                             "speed",
                                                             "acc",
                                                             "accel",
                                                             "acceleration",
                                                             "linear",
                                                             "angular",
                                                             "twist",
                                                             "orientation",
                                                             "rotation",
                                                             "rot",
                                                             "q",
                                                             "quat",
                                                             "quaternion",
                                                             "sigma",
                                                             "std",
                                                             "stddev",
                                                             "cov",
                                                             "covariance",
                                                             "var",
                                                             "variance",
                                                             "raw",
                                                             "gyro",
                                                             "gyroscope",
                                                             "mag",
                                                             "imu",
                                                             "target",
                                                             "goal",
                                                             "cmd",
                                                             "command",
                                                             "setpoint",
                                                             "ref",
                                                             "reference",
                                                             "desired",
                                                             "des",
                                                             "error",
                                                             "err",
                                                             "dot",
                                                             "delta",
                                                             "diff",
                                                             "force",
                                                             "torque",
                                                             "wrench",
                                                             "jerk",
                                                             "pixel",
                                                             "pixels",
                                                             "bias",
                                                             "scale",
                                                             "min",
                                                             "max",
                                                             "offset",
                                                             "geschwindigkeit",
                                                             "beschleunigung",
                                                             "vitesse",
                                                             "accélération",
                                                             "velocidad",
                                                             "aceleración",
                                                             "속도",
                                                             "가속도",
                                                             "速度",
                                                             "加速度"});
constexpr std::array<std::string_view, 6> quaternionWords{"orientation", "rotation", "rot",
                                                          "q",           "quat",     "quaternion"};
/// "x in mm", "x en mm"
constexpr std::array<std::string_view, 2> unitPrepositions{"in", "en"};

template <class Words>
auto valueNamed(const Words &words, std::string_view name) -> std::optional<decltype(words.front().value)>
{
    for (const auto &word : words) {
        if (word.name == name)
            return word.value;
    }
    return std::nullopt;
}

bool isUnit(std::string_view lower)
{
    return valueNamed(lengthWords, lower) || isAmong(otherLengthWords, lower) ||
           valueNamed(timeWords, lower) || valueNamed(angleWords, lower);
}

bool isWordCharacter(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::vector<std::string> wordsOf(std::string_view text)
{
    std::vector<std::string> words;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && isWordCharacter(text[end]))
            ++end;
        if (end > i)
            words.emplace_back(text.substr(i, end - i));
        i = end + 1;
    }
    return words;
}

/// "posx", "xpos", "tx", "qw": the axis and what is with it.
std::optional<std::pair<char, std::string>> gluedAxis(const std::string &word)
{
    if (word.size() < 2)
        return std::nullopt;
    constexpr std::string_view axes = "xyzw";
    const std::string front = word.substr(0, word.size() - 1), back = word.substr(1);
    if (axes.find(word.back()) != std::string_view::npos &&
        (isAmong(positionWords, front) || isAmong(quaternionWords, front)))
        return std::pair(word.back(), front);
    if (axes.find(word.front()) != std::string_view::npos && isAmong(positionWords, back))
        return std::pair(word.front(), back);
    return std::nullopt;
}

} // namespace

std::optional<LengthUnit> lengthUnitNamed(std::string_view lower)
{
    return valueNamed(lengthWords, lower);
}

std::optional<TimeUnit> timeUnitNamed(std::string_view lower)
{
    return valueNamed(timeWords, lower);
}

ColumnName::ColumnName(std::string_view cell) : m_lower(lowerCaseAscii(withoutBlanks(cell)))
{
    std::string text(withoutBlanks(cell));
    takeUnit(text);
    std::vector<std::string> written = wordsOf(text);
    for (const std::string &word : written)
        m_words.push_back(lowerCaseAscii(word));
    if (hasUnit() && m_words.size() > 1 && isAmong(unitPrepositions, m_words.back()))
        written.pop_back(), m_words.pop_back();
    readAxis(written);
}

/// Cuts a unit off the end of a name.
void ColumnName::takeUnit(std::string &text)
{
    if (text.ends_with(']') || text.ends_with(')')) {
        const std::size_t open = text.find_last_of("[(");
        if (open != std::string::npos && open > 0) {
            m_unit = lowerCaseAscii(withoutBlanks(text.substr(open + 1, text.size() - open - 2)));
            m_isBracketed = m_unit != "";
            text.resize(open);
            return;
        }
    }
    const std::size_t mark = text.find_last_of("/_ .");
    if (mark == std::string::npos || mark == 0)
        return;
    const std::string tail = lowerCaseAscii(text.substr(mark + 1));
    if (!isUnit(tail) || (text[mark] == '/' && text.find('/') != mark))
        return;
    m_unit = tail;
    m_isBracketed = text[mark] == '/' || isAmong(otherLengthWords, tail);
    text.resize(mark);
}

void ColumnName::readAxis(const std::vector<std::string> &written)
{
    std::vector<std::string> others;
    for (std::size_t i = 0; i < m_words.size(); ++i) {
        const std::string &word = m_words[i];
        const bool isAxis =
            word.size() == 1 && std::string_view("xyzw").find(word[0]) != std::string_view::npos;
        const auto glued = isAxis ? std::nullopt : gluedAxis(word);
        if (m_axis == 0 && isAxis) {
            m_axis = word[0];
        } else if (m_axis == 0 && glued) {
            m_axis = glued->first;
            others.push_back(glued->second);
        } else {
            others.push_back(written[i]);
        }
    }
    if (m_axis == 0)
        return;
    // EuRoC: p_RS_R_x is a position, q_RS_w an orientation, whatever RS and R are
    const bool isOfFrame = others.size() > 1 && others.front() == "p";
    m_isPosition = true;
    for (const std::string &other : others) {
        const std::string lower = lowerCaseAscii(other);
        m_isPosition = m_isPosition && !isAmong(otherWords, lower);
        m_isQuaternion = m_isQuaternion || isAmong(quaternionWords, lower);
        if (!isOfFrame && !isAmong(positionWords, lower))
            m_owner.append(m_owner.empty() ? "" : " ").append(other);
    }
}

std::string ColumnName::joinedWords() const
{
    std::string joined;
    for (const std::string &word : m_words)
        joined.append(joined.empty() ? "" : "_").append(word);
    return joined;
}

std::optional<LengthUnit> ColumnName::lengthUnit() const
{
    return lengthUnitNamed(m_unit);
}

std::optional<TimeUnit> ColumnName::timeUnit() const
{
    return timeUnitNamed(m_unit);
}

std::optional<double> ColumnName::radiansPerUnit() const
{
    return valueNamed(angleWords, m_unit);
}

} // namespace odo
