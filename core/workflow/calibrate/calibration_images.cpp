// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/calibration_images.h"

#include "core/base/file_system.h"
#include "core/base/sha256.h"
#include "core/files/protected_files.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/video/video_reader.h"
#include "core/workflow/media_copy.h"
#include "core/workflow/shared_words.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace odo {

namespace {

constexpr std::size_t mostBytes = 200'000'000;

}

CalibrationMedia::CalibrationMedia(const std::filesystem::path &mediaFolder)
    : m_mediaFolder(mediaFolder), m_folder(mediaFolder / "calibration")
{
}

CalibrationMedia::~CalibrationMedia()
{
    if (m_files.empty())
        return;
    m_files.clear();
    for (const std::filesystem::path &folder : {m_folder, m_mediaFolder})
        files::remove(folder); // only when empty
}

Result<StoredImage> CalibrationMedia::write(const std::string &name, const std::vector<unsigned char> &png)
{
    if (png.empty() || m_bytes + png.size() > mostBytes)
        return StoredImage{};
    auto file = ODO_TRY(writeMediaFile(
        m_folder, name, ".png", {reinterpret_cast<const char *>(png.data()), png.size()},
        ODO_TEXT("workflow.calibration_picture", "calibration image '%1'")(Named::file(name))));
    const std::string path = files::absolute(file.path()).string();
    m_files.push_back(std::move(file));
    m_bytes += png.size();
    Sha256 hash;
    hash.add(png.data(), png.size());
    return StoredImage{path, hash.hex(), static_cast<std::int64_t>(png.size())};
}

void CalibrationMedia::keep()
{
    for (ClaimedFile &file : m_files)
        file.keep();
    m_files.clear();
}

Result<StoredImage> CalibrationMedia::writeFloor(const std::string &camera, const Frame &frame)
{
    const auto png = colourPng(frame);
    return png ? write(camera + "_floor", *png) : tl::unexpected(png.error());
}

namespace {

bool startsAsStill(const std::filesystem::path &file)
{
    if (!checkMayBeRead(file, fileSubject(file)))
        return false;
    std::array<char, 32> start{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(start.data(), start.size());
    return startsAsImage(
        {reinterpret_cast<const std::uint8_t *>(start.data()), static_cast<std::size_t>(stream.gcount())});
}

} // namespace

bool isStillImage(const std::filesystem::path &file)
{
    static constexpr std::array<std::string_view, 15> endings = {".png", ".jpg",  ".jpeg", ".jpe", ".bmp",
                                                                 ".tif", ".tiff", ".webp", ".pbm", ".pgm",
                                                                 ".ppm", ".heic", ".heif", ".hif", ".avif"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return startsAsStill(file) || std::ranges::find(endings, ending) != endings.end();
}

Result<Frame> imageOf(const std::filesystem::path &file, std::int64_t frame)
{
    const auto missing = [&](std::size_t frames) {
        return fail(
            ErrorCode::NotFound,
            ODO_TEXT("workflow.frame_of_file", "frame %1 of '%2'")(frame, Named::file(file.filename())),
            noSuchFrame(),
            frames > 1 ? chooseFrame(0, static_cast<std::int64_t>(frames) - 1)
                       : ODO_TEXT("workflow.only_frame", "its only frame is 0"));
    };
    if (isStillImage(file)) {
        if (frame != 0)
            return missing(1);
        return readImage(file);
    }
    auto reader = ODO_TRY(VideoReader::open(file));
    const std::size_t frames = reader->info().frameTimes.size();
    if (frame < 0 || frame >= static_cast<std::int64_t>(frames))
        return missing(frames);
    auto found = reader->frameAt(frame);
    return found ? wholeFrame(*found) : found;
}

Result<void> visitImages(const std::filesystem::path &file, int videoStep,
                         const std::function<bool(const Frame &, const std::string &)> &visit,
                         const CancelToken &cancel)
{
    const std::string name = file.filename().string();
    if (isStillImage(file)) {
        const auto image = ODO_TRY(readImage(file));
        visit(image, name);
        return {};
    }
    auto reader = ODO_TRY(VideoReader::open(file, cancel));
    for (;;) {
        const auto frame = ODO_TRY(reader->next());
        if (!frame)
            return {};
        if (frame->index % videoStep == 0 && !visit(*frame, name + "@" + std::to_string(frame->index)))
            return {};
    }
}

Message detectingMarkersIn(const std::string &name)
{
    return ODO_TEXT("workflow.looking_for_markers_in", "detecting the markers in %1")(Named::file(name));
}

} // namespace odo
