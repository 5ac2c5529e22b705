// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/paired_files.h"

#include "core/base/file_system.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "core/workflow/calibrate/calibration_images.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace odo {

namespace {

using Files = std::vector<std::filesystem::path>;
using FilesByNumber = std::map<std::string, std::filesystem::path>;

constexpr std::size_t mostNumbersInName = 4;
constexpr double sharedPart = 0.8;
constexpr double framesPerSecond = 2;
constexpr std::int64_t mostFrames = 120;

Message pairedFiles()
{
    return ODO_TEXT("workflow.paired_files", "the files of the two cameras");
}

/// The numbers in a file's name without their zeros in front, the last one first.
std::vector<std::string> numbersIn(const std::filesystem::path &file)
{
    std::vector<std::string> numbers;
    std::string digits;
    const std::string stem = file.stem().string();
    for (std::size_t i = 0; i <= stem.size(); ++i) {
        if (i < stem.size() && std::isdigit(static_cast<unsigned char>(stem[i])) != 0) {
            digits += stem[i];
        } else if (!digits.empty()) {
            digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
            numbers.insert(numbers.begin(), std::move(digits));
            digits.clear();
        }
    }
    return numbers;
}

/// By the number at a position from the end of the names; empty where not each file has one of its own.
FilesByNumber byNumber(const Files &files, std::size_t position)
{
    FilesByNumber numbered;
    for (const auto &file : files) {
        const auto numbers = numbersIn(file);
        if (position >= numbers.size() || !numbered.emplace(numbers[position], file).second)
            return {};
    }
    return numbered;
}

/// nullopt where the names share no number.
std::optional<std::vector<FilePair>> pairedByNumber(const Files &a, const Files &b)
{
    for (std::size_t position = 0; position < mostNumbersInName; ++position) {
        const FilesByNumber ofA = byNumber(a, position), ofB = byNumber(b, position);
        const auto shared =
            std::ranges::count_if(ofA, [&](const auto &one) { return ofB.contains(one.first); });
        if (shared == 0 || double(shared) < sharedPart * double(std::min(ofA.size(), ofB.size())))
            continue;
        std::vector<FilePair> pairs;
        for (const auto &file : a) { // in the order given
            const auto other = ofB.find(numbersIn(file)[position]);
            pairs.push_back({file, other == ofB.end() ? std::filesystem::path() : other->second});
        }
        for (const auto &file : b)
            if (!ofA.contains(numbersIn(file)[position]))
                pairs.push_back({{}, file});
        return pairs;
    }
    return std::nullopt;
}

Result<void> checkEachOnce(const Files &a, const Files &b)
{
    std::set<std::filesystem::path> seen;
    for (const Files *files : {&a, &b}) {
        for (const auto &file : *files) {
            if (!seen.insert(files::absolute(file).lexically_normal()).second)
                return fail(ErrorCode::InvalidInput, pairedFiles(),
                            ODO_TEXT("workflow.file_given_twice",
                                     "'%1' is given twice")(Named::file(file.filename())),
                            ODO_TEXT("workflow.give_each_file_once", "give each file once, to its camera"));
        }
    }
    return {};
}

std::int64_t nearestFrame(const std::vector<Nanoseconds> &times, Nanoseconds time)
{
    const auto after = std::ranges::lower_bound(times, time);
    if (after == times.begin())
        return 0;
    const auto before = std::prev(after);
    const bool isBefore = after == times.end() || time - *before <= *after - time;
    return (isBefore ? before : after) - times.begin();
}

Result<void> visitVideoPair(const FilePair &files, const std::function<bool(const FramePair &)> &visit,
                            const CancelToken &cancel)
{
    const auto a = ODO_TRY(VideoReader::open(files.a, cancel));
    const auto b = ODO_TRY(VideoReader::open(files.b, cancel));
    const auto &timesA = a->info().frameTimes, &timesB = b->info().frameTimes;
    if (timesA.empty() || timesB.empty())
        return {};
    const auto frames = static_cast<std::int64_t>(timesA.size());
    const auto step = std::max<std::int64_t>(std::llround(a->info().framesPerSecond / framesPerSecond),
                                             frames / mostFrames);
    for (std::int64_t frame = 0; frame < frames; frame += std::max<std::int64_t>(1, step)) {
        const Nanoseconds time = timesA[static_cast<std::size_t>(frame)];
        if (time > timesB.back())
            return {};
        const std::int64_t other = nearestFrame(timesB, time);
        auto frameA = ODO_TRY(a->frameAt(frame));
        auto frameB = ODO_TRY(b->frameAt(other));
        const auto nameOf = [](const std::filesystem::path &file, std::int64_t index) {
            return file.filename().string() + "@" + std::to_string(index);
        };
        if (!visit({std::move(frameA), std::move(frameB), nameOf(files.a, frame), nameOf(files.b, other)}))
            return {};
    }
    return {};
}

} // namespace

Result<std::vector<FilePair>> pairFiles(const Files &a, const Files &b)
{
    ODO_TRY(checkEachOnce(a, b));
    if (auto pairs = pairedByNumber(a, b))
        return std::move(*pairs);
    if (a.size() != b.size())
        return fail(ErrorCode::InvalidInput, pairedFiles(),
                    ODO_TEXT("workflow.unequal_files",
                             "%1 files of the first camera cannot be paired with %2 of the second one")(
                        a.size(), b.size()),
                    ODO_TEXT("workflow.number_files_alike",
                             "give as many of each, in the same order, or number their names alike"));
    std::vector<FilePair> pairs;
    for (std::size_t i = 0; i < a.size(); ++i)
        pairs.push_back({a[i], b[i]});
    return pairs;
}

Result<void> visitFramePairs(const FilePair &files, const std::function<bool(const FramePair &)> &visit,
                             const CancelToken &cancel)
{
    const bool isStillA = isStillImage(files.a), isStillB = isStillImage(files.b);
    if (isStillA != isStillB)
        return fail(ErrorCode::InvalidInput, pairedFiles(),
                    ODO_TEXT("workflow.image_with_video", "one is an image and the other a video"),
                    ODO_TEXT("workflow.pair_like_files", "pair images with images and videos with videos"));
    if (!isStillA)
        return visitVideoPair(files, visit, cancel);
    auto frameA = ODO_TRY(readImage(files.a));
    auto frameB = ODO_TRY(readImage(files.b));
    visit({std::move(frameA), std::move(frameB), files.a.filename().string(), files.b.filename().string()});
    return {};
}

} // namespace odo
