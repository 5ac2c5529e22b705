// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/track_export.h"

#include "core/analysis/quantity_curve.h"
#include "core/exchange/internal/csv_line.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace odo {

namespace {

constexpr std::array<std::pair<CsvStyle, std::string_view>, 3> styleNames{
    {{CsvStyle::Analysis, "analysis"},
     {CsvStyle::International, "international"},
     {CsvStyle::Continental, "continental"}}};

constexpr std::array<std::string_view, 17> columns = {"t_s",
                                                      "x_mm",
                                                      "y_mm",
                                                      "vx_mm_s",
                                                      "vy_mm_s",
                                                      "speed_mm_s",
                                                      "ax_mm_s2",
                                                      "ay_mm_s2",
                                                      "accel_mm_s2",
                                                      "sigma_x_mm",
                                                      "sigma_y_mm",
                                                      "sigma_speed_mm_s",
                                                      "sigma_accel_mm_s2",
                                                      "raw_x_mm",
                                                      "raw_y_mm",
                                                      "views",
                                                      "flags"};

std::string viewNames(std::uint32_t views, const std::vector<std::string> &names)
{
    std::string joined;
    for (std::size_t i = 0; i < names.size() && i < 32; ++i) {
        if ((views & (1u << i)) != 0)
            joined += (joined.empty() ? "" : "+") + names[i];
    }
    return joined;
}

constexpr std::array<std::pair<std::string_view, CsvLength>, 4> unitWords{{{"mm", CsvLength::Millimetres},
                                                                           {"cm", CsvLength::Centimetres},
                                                                           {"m", CsvLength::Metres},
                                                                           {"in", CsvLength::Inches}}};

double lengthIn(CsvLength unit, double metres)
{
    switch (unit) {
    case CsvLength::Millimetres:
        return toMillimetres(metres);
    case CsvLength::Centimetres:
        return metres * 100;
    case CsvLength::Metres:
        return metres;
    case CsvLength::Inches:
        break;
    }
    return metres / 0.0254;
}

/// "x_mm" → "x_m"
std::string nameIn(CsvLength unit, std::string_view column)
{
    std::string name(column);
    const auto *const word = std::ranges::find(unitWords, unit, &decltype(unitWords)::value_type::second);
    if (const std::size_t at = name.find("_mm"); at != std::string::npos)
        name.replace(at + 1, 2, word->first);
    return name;
}

void addPoint(CsvLine &line, const ProfilePoint &point, CsvLength unit)
{
    for (double metres : {point.position.x(), point.position.y(), point.velocity.x(), point.velocity.y(),
                          point.speedMps, point.acceleration.x(), point.acceleration.y(), point.accelMps2,
                          point.sigmaXM, point.sigmaYM, point.sigmaSpeedMps, point.sigmaAccelMps2}) {
        if (point.valid)
            line.number(lengthIn(unit, metres));
        else
            line.empty();
    }
}

} // namespace

Result<CsvStyle> parseCsvStyle(std::string_view name)
{
    for (const auto &[style, itsName] : styleNames) {
        if (itsName == name)
            return style;
    }
    return fail(ErrorCode::NotFound,
                ODO_TEXT("exchange.csv_style", "style '%1' of CSV")(std::string(name.substr(0, 40))),
                ODO_TEXT("exchange.no_such_style", "this style does not exist"),
                ODO_TEXT("exchange.choose_style", "choose analysis, international or continental"));
}

std::optional<CsvLength> csvLengthFromWord(std::string_view word)
{
    for (const auto &[name, unit] : unitWords)
        if (name == word)
            return unit;
    return std::nullopt;
}

std::vector<std::string> csvColumns(CsvLength unit)
{
    std::vector<std::string> names;
    for (const std::string_view column : columns)
        names.push_back(nameIn(unit, column));
    return names;
}

Result<std::vector<std::size_t>> parseCsvColumns(const std::vector<std::string> &names)
{
    std::vector<std::size_t> chosen;
    const std::vector<std::string> known = csvColumns();
    for (const std::string &name : names) {
        const auto its = std::ranges::find(known, name);
        const Message what = ODO_TEXT("exchange.csv_column", "column '%1' of CSV")(name.substr(0, 40));
        if (its == known.end())
            return fail(ErrorCode::NotFound, what,
                        ODO_TEXT("exchange.no_such_column", "this column does not exist"),
                        ODO_TEXT("exchange.choose_column", "choose from %1")(
                            listed(known, MessageArgument::Kind::Label, MessageArgument::Joint::Comma)));
        chosen.push_back(static_cast<std::size_t>(its - known.begin()));
        if (std::ranges::count(chosen, chosen.back()) > 1)
            return fail(ErrorCode::InvalidInput, what, ODO_TEXT("exchange.column_twice", "it is named twice"),
                        ODO_TEXT("exchange.name_column_once", "name each column once"));
    }
    return chosen;
}

Result<void> writeTrackCsv(const AnalysisRecord &analysis, CsvStyle style, const TextSink &sink,
                           std::span<const std::size_t> chosen, CsvLength unit)
{
    const auto lineOf = [chosen](const CsvLine &line) {
        return chosen.empty() ? line.take() : line.take(chosen);
    };
    TextPieces text(sink);
    text.add(csvStart(style));
    CsvLine header(style);
    for (const std::string &column : csvColumns(unit))
        header.text(column);
    text.add(lineOf(header));
    const Profile &profile = analysis.profile;
    for (std::size_t i = 0; i < profile.samples.size(); ++i) {
        const Sample &sample = profile.samples[i];
        CsvLine line(style);
        // A quotient is rounded once, so that the shortest text is exactly the nanoseconds.
        line.number(static_cast<double>(sample.time.count()) / 1e9);
        addPoint(line, profile.points[i], unit);
        for (int axis : {0, 1}) {
            if (sample.position)
                line.number(lengthIn(unit, (*sample.position)[axis]));
            else
                line.empty();
        }
        line.text(viewNames(sample.views, analysis.views));
        line.text(flagNames(sample.flags));
        text.add(lineOf(line));
    }
    return text.finish();
}

std::string trackCsv(const AnalysisRecord &analysis, CsvStyle style)
{
    return wholeText([&](const TextSink &sink) { return writeTrackCsv(analysis, style, sink); });
}

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
    const auto headings = headingsOf(profile);
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
    // Tracker separates by blanks too, and reads data and comments from the first line on.
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
        text.add(isUsable(point)
                     ? '\t' + javaNumber(point.position.x()) + '\t' + javaNumber(point.position.y())
                     : "\t\t");
        text.add("\n");
    }
    return text.finish();
}

std::string trackTracker(const AnalysisRecord &analysis)
{
    return wholeText([&](const TextSink &sink) { return writeTrackTracker(analysis, sink); });
}

} // namespace odo
