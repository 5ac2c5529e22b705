// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibration_media.h"

#include "core/base/file_system.h"
#include "core/base/sha256.h"
#include "core/video/picture_writer.h"
#include "core/workflow/media_copy.h"


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

Result<StoredPicture> CalibrationMedia::write(const std::string &name, const std::vector<unsigned char> &png)
{
    if (png.empty() || m_bytes + png.size() > mostBytes)
        return StoredPicture{};
    auto file = writeMediaFile(m_folder, name, ".png", {reinterpret_cast<const char *>(png.data()), png.size()}, "calibration picture '" + name + "'");
    if (!file)
        return tl::unexpected(file.error());
    const std::string path = files::absolute(file->path()).string();
    m_files.push_back(std::move(*file));
    m_bytes += png.size();
    Sha256 hash;
    hash.add(png.data(), png.size());
    return StoredPicture{path, hash.hex(), static_cast<std::int64_t>(png.size())};
}

void CalibrationMedia::keep()
{
    for (ClaimedFile &file : m_files)
        file.keep();
    m_files.clear();
}

Result<StoredPicture> CalibrationMedia::writeFloor(const std::string &camera, const Frame &frame)
{
    const auto png = colourPng(frame);
    return png ? write(camera + "_floor", *png) : tl::unexpected(png.error());
}

} // namespace odo
