// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibration_media.h"

#include "core/base/file_system.h"
#include "core/exchange/whole_file.h"
#include "core/video/picture_writer.h"
#include "core/workflow/media_copy.h"

#include <QCryptographicHash>

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
    for (const std::filesystem::path &file : m_files)
        files::remove(file);
    for (const std::filesystem::path &folder : {m_folder, m_mediaFolder})
        files::remove(folder); // only when empty
}

Result<StoredPicture> CalibrationMedia::write(const std::string &name, const std::vector<unsigned char> &png)
{
    if (png.empty() || m_bytes + png.size() > mostBytes)
        return StoredPicture{};
    const auto failed = [&](const std::string &why) {
        return fail(ErrorCode::Io, "calibration picture '" + name + "'", why,
                    "check the free space and the rights of the project's folder");
    };
    std::error_code problem;
    files::makeFolders(m_folder, problem);
    if (problem)
        return failed(problem.message());
    const std::filesystem::path file = freeMediaPath(m_folder, name, ".png");
    const auto size = static_cast<qsizetype>(png.size());
    const QByteArrayView bytes(png.data(), size);
    WholeFile out(QString::fromStdString(file.string()));
    if (!out.open(QIODevice::WriteOnly) || out.write(bytes.data(), size) != size || !out.commit())
        return failed(out.errorString().toStdString());
    m_files.push_back(file);
    m_bytes += png.size();
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(bytes);
    return StoredPicture{files::absolute(file).string(), hash.result().toHex().toStdString(), size};
}

Result<StoredPicture> CalibrationMedia::writeFloor(const std::string &camera, const Frame &frame)
{
    const auto png = colourPng(frame);
    return png ? write(camera + "_floor", *png) : tl::unexpected(png.error());
}

} // namespace odo
