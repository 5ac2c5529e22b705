// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/crash_report.h"

#include "core/base/file_system.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

namespace odo {

namespace {

constexpr std::string_view newPrefix = "crash-", shownPrefix = "told-crash-";

bool isReport(const std::filesystem::path &file, std::string_view prefix)
{
    constexpr std::uintmax_t longest = 1'000'000;
    std::error_code problem;
    const std::string name = file.filename().string();
    return name.starts_with(prefix) && name.ends_with(".txt") &&
           files::kindOfItself(file) == files::Kind::File && files::sizeOf(file, problem) <= longest &&
           !problem;
}

std::vector<std::filesystem::path> reportsOf(const std::filesystem::path &folder, std::string_view prefix)
{
    std::vector<std::filesystem::path> reports;
    std::error_code problem;
    for (const std::string &name : files::namesIn(folder, problem))
        if (isReport(folder / name, prefix))
            reports.push_back(folder / name);
    std::ranges::sort(reports); // the time is in the name
    return reports;
}

/// The rest of the line that begins with a word; empty where there is none.
std::string lineAfter(const std::string &text, const std::string &word)
{
    const auto begin = text.find("\n" + word);
    if (begin == std::string::npos)
        return {};
    const auto from = begin + 1 + word.size();
    return text.substr(from, text.find('\n', from) - from);
}

} // namespace

std::vector<CrashReport> newCrashReports(const std::filesystem::path &folder)
{
    std::vector<CrashReport> reports;
    for (const std::filesystem::path &file : reportsOf(folder, newPrefix)) {
        std::ifstream stream(file, std::ios::binary);
        const std::string text(std::istreambuf_iterator<char>(stream), {});
        CrashReport report{file, lineAfter(text, "signal: "), std::nullopt};
        if (const std::string project = lineAfter(text, "project: "); !project.empty())
            report.project = project;
        reports.push_back(std::move(report));
    }
    return reports;
}

std::filesystem::path keepShownReport(const CrashReport &report)
{
    constexpr std::size_t mostKept = 10;
    const std::filesystem::path folder = report.file.parent_path();
    std::filesystem::path told = folder / ("told-" + report.file.filename().string());
    std::error_code problem;
    files::rename(report.file, told, problem);
    if (problem)
        return report.file;
    const std::vector<std::filesystem::path> kept = reportsOf(folder, shownPrefix);
    for (std::size_t i = 0; i + mostKept < kept.size(); ++i)
        files::remove(kept[i]);
    return told;
}

} // namespace odo
