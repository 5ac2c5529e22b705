// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/internal/image_series.h"

#include "core/base/file_system.h"
#include "core/base/plain_text.h"
#include "core/files/file_words.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace odo {

namespace {

constexpr std::array<std::string_view, 7> imageEndings{".png",  ".jpg", ".jpeg", ".tif",
                                                       ".tiff", ".bmp", ".webp"};
constexpr std::size_t mostDigitsOfImage = 18;

bool isImageName(const std::string &name)
{
    return std::ranges::find(imageEndings,
                             lowerCaseAscii(std::filesystem::path(name).extension().string())) !=
           imageEndings.end();
}

Message imagesSubject(const std::filesystem::path &path)
{
    return ODO_TEXT("workflow.images", "images '%1'")(Named::file(path));
}

struct Pattern
{
    std::string front, back;
    std::size_t leastDigits = 1;
};

/// "a_%06d.png": what is in front, what is behind, and at least how many digits between.
std::optional<Pattern> patternOf(const std::string &name)
{
    const std::size_t percent = name.find('%');
    if (percent == std::string::npos)
        return std::nullopt;
    const std::size_t end = name.find_first_not_of("0123456789", percent + 1);
    if (end == std::string::npos || name[end] != 'd' || end - percent > 3)
        return std::nullopt;
    const std::string width = name.substr(percent + 1, end - percent - 1);
    return Pattern{name.substr(0, percent), name.substr(end + 1),
                   width.empty() ? 1 : std::max<std::size_t>(1, std::stoul(width))};
}

/// The number that a name has in a place of a pattern.
std::optional<std::int64_t> numberIn(const std::string &name, const Pattern &pattern)
{
    if (name.size() <= pattern.front.size() + pattern.back.size() || !name.starts_with(pattern.front) ||
        !name.ends_with(pattern.back))
        return std::nullopt;
    const std::string digits =
        name.substr(pattern.front.size(), name.size() - pattern.front.size() - pattern.back.size());
    if (digits.size() < pattern.leastDigits || digits.size() > mostDigitsOfImage ||
        digits.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    return std::stoll(digits);
}

/// Where the last number of an image's name is.
std::optional<Pattern> seriesOf(const std::string &name)
{
    const std::string stem = std::filesystem::path(name).stem().string();
    const std::size_t last = stem.find_last_of("0123456789");
    if (last == std::string::npos)
        return std::nullopt;
    const std::size_t before = stem.find_last_not_of("0123456789", last);
    return Pattern{stem.substr(0, before == std::string::npos ? 0 : before + 1), name.substr(last + 1)};
}

Result<ImageSeries> seriesIn(const std::filesystem::path &folder, const std::vector<std::string> &names,
                             const Pattern &pattern, const std::filesystem::path &called)
{
    std::map<std::int64_t, std::string> byNumber;
    for (const std::string &name : names) {
        const auto number = numberIn(name, pattern);
        if (!number || !files::isFile(folder / name))
            continue;
        if (const auto [other, isNew] = byNumber.emplace(*number, name); !isNew)
            return fail(ErrorCode::InvalidInput, imagesSubject(called),
                        ODO_TEXT("workflow.images_share_number", "'%1' and '%2' have the same number")(
                            Named::file(other->second), Named::file(name)),
                        ODO_TEXT("workflow.number_images_once", "give each image a number of its own"));
    }
    if (byNumber.size() < 2) {
        Message why = ODO_TEXT("workflow.no_image_series",
                               "there are no numbered images (PNG, JPEG, TIFF, BMP, WebP) of that name");
        if (files::isFolder(called))
            why = joined({files::insteadOfFile(files::Kind::Folder), std::move(why)}, Join::Semicolon);
        return fail(ErrorCode::NotFound, imagesSubject(called), std::move(why),
                    ODO_TEXT("workflow.name_image_series",
                             "give a folder with images such as 000001.png, or a pattern such as "
                             "FOLDER/%1")(std::string("%06d.png")));
    }
    ImageSeries series;
    for (const auto &[number, name] : byNumber) {
        series.numbers.push_back(number);
        series.files.push_back(folder / name);
    }
    return series;
}

/// The only series of a folder, or one of which there is nothing.
Result<Pattern> onlySeries(const std::filesystem::path &folder, const std::vector<std::string> &names)
{
    std::map<std::pair<std::string, std::string>, std::size_t> counts;
    for (const std::string &name : names)
        if (const auto series = isImageName(name) ? seriesOf(name) : std::nullopt)
            ++counts[{series->front, series->back}];
    std::erase_if(counts, [](const auto &each) { return each.second < 2; });
    if (counts.empty())
        return Pattern{".", "."};
    const auto &[front, back] = counts.begin()->first;
    if (counts.size() == 1)
        return Pattern{front, back};
    const auto &[otherFront, otherBack] = std::next(counts.begin())->first;
    return fail(ErrorCode::InvalidInput, imagesSubject(folder),
                ODO_TEXT("workflow.several_image_series", "the folder holds several series: %1 and %2")(
                    Named::file(front + "%d" + back), Named::file(otherFront + "%d" + otherBack)),
                ODO_TEXT("workflow.name_one_series",
                         "name one of them, like FOLDER/%1")(Named::file(front + "%d" + back)));
}

} // namespace

bool isImagePattern(const std::filesystem::path &path)
{
    const std::string name = path.filename().string();
    return patternOf(name).has_value() && isImageName(name);
}

Result<ImageSeries> imagesOf(const std::filesystem::path &patternOrFolder)
{
    const bool isFolder = files::isFolder(patternOrFolder);
    std::filesystem::path folder = isFolder ? patternOrFolder : patternOrFolder.parent_path();
    if (folder.empty())
        folder = ".";
    std::error_code problem;
    const std::vector<std::string> names = files::namesIn(folder, problem);
    if (problem)
        return fail(ErrorCode::NotFound, imagesSubject(patternOrFolder), foreignWords(problem.message()),
                    checkFileIsThere());
    const Pattern pattern = isFolder ? ODO_TRY(onlySeries(folder, names))
                                     : patternOf(patternOrFolder.filename().string()).value_or(Pattern());
    return seriesIn(folder, names, pattern, patternOrFolder);
}

std::vector<Nanoseconds> timesOfNumbers(const std::vector<std::int64_t> &numbers, double framesPerSecond)
{
    std::vector<Nanoseconds> times;
    for (const std::int64_t number : numbers)
        times.push_back(fromSeconds(static_cast<double>(number - numbers.front()) / framesPerSecond));
    return times;
}

Result<Message> missingImages(const std::filesystem::path &patternOrFolder,
                              const std::vector<std::int64_t> &numbers)
{
    constexpr std::int64_t mostForEach = 10;
    const auto count = static_cast<std::int64_t>(numbers.size());
    const std::int64_t missing = numbers.back() - numbers.front() + 1 - count;
    if (missing == 0)
        return Message();
    std::size_t before = 0;
    while (numbers[before + 1] == numbers[before] + 1)
        ++before;
    if (missing > mostForEach * count)
        return fail(
            ErrorCode::Undetermined, imagesSubject(patternOrFolder),
            ODO_TEXT("workflow.numbers_count_no_frames",
                     "their numbers go from %1 to %2, and there are %3 images: they do not count "
                     "frames")(std::to_string(numbers.front()), std::to_string(numbers.back()), count),
            ODO_TEXT("workflow.give_table_of_times",
                     "give a table of their times, like --times A=stamps.csv"));
    return joined({imagesSubject(patternOrFolder),
                   ODO_TEXT("workflow.images_missing",
                            "missing numbers: %1, the first behind %2; their frames count as lost, and the "
                            "others keep their times")(missing, std::to_string(numbers[before]))},
                  Join::Colon);
}

} // namespace odo
