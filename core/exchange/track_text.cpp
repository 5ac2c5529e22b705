// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/track_text.h"

#include "core/exchange/text_file.h"
#include "core/trajectory/heading.h"

#include <charconv>

namespace odo {

namespace {

double secondsOf(const Sample &sample)
{
    return static_cast<double>(sample.time.count()) / 1e9;
}

bool isUsable(const ProfilePoint &point)
{
    return point.valid && point.position.allFinite();
}

/// Shortest text with an exponent as Java writes it: "1.25E-1".
std::string javaNumber(double value)
{
    char text[64];
    const auto [end, problem] = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific);
    std::string number(text, problem == std::errc() ? end : text);
    const std::size_t e = number.find('e');
    if (e == std::string::npos)
        return number;
    std::string mantissa = number.substr(0, e);
    if (mantissa.find('.') == std::string::npos)
        mantissa += ".0";
    const bool negative = number[e + 1] == '-';
    const std::size_t digits = std::min(number.find_first_not_of('0', e + 2), number.size() - 1);
    return mantissa + (negative ? "E-" : "E") + number.substr(digits);
}

} // namespace

Result<void> writeTrackTum(const AnalysisRecord &analysis, const TextSink &sink)
{
    const Profile &profile = analysis.profile;
    const auto headings = headingsOf(profile.points);
    TextPieces text(sink);
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        if (!isUsable(point))
            continue;
        const double heading = headings[i] ? headings[i]->radians : 0.0;
        text.add(numberText(secondsOf(profile.samples[i])) + ' ' + numberText(point.position.x()) + ' ' +
                 numberText(point.position.y()) + " 0 0 0 " + numberText(std::sin(heading / 2)) + ' ' +
                 numberText(std::cos(heading / 2)) + '\n');
    }
    return text.finish();
}

std::string trackTum(const AnalysisRecord &analysis)
{
    return wholeText([&](const TextSink &sink) { return writeTrackTum(analysis, sink); });
}

std::string trackerName(std::string name)
{
    // Tracker separates by blanks too, and looks for data and remarks from the first line on.
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return std::string_view(" ,;\t\"").find(c) != std::string_view::npos; }, '_');
    if (name.starts_with('#') || name.starts_with("//") || parseNumber(name))
        name.insert(name.begin(), '_');
    return name;
}

Result<void> writeTrackTracker(const AnalysisRecord &analysis, const TextSink &sink)
{
    TextPieces text(sink);
    text.add(trackerName(analysis.robotName) + "\nt\tx\ty\n");
    const Profile &profile = analysis.profile;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        text.add(javaNumber(secondsOf(profile.samples[i])));
        text.add(isUsable(point) ? '\t' + javaNumber(point.position.x()) + '\t' + javaNumber(point.position.y()) : "\t\t");
        text.add("\n");
    }
    return text.finish();
}

std::string trackTracker(const AnalysisRecord &analysis)
{
    return wholeText([&](const TextSink &sink) { return writeTrackTracker(analysis, sink); });
}

} // namespace odo
