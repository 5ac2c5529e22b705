// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/picture_source.h"

#include "core/video/picture.h"
#include "core/video/video_reader.h"

#include <algorithm>
#include <array>

namespace odo {

bool isStillPicture(const std::filesystem::path &file)
{
    static constexpr std::array<std::string_view, 8> endings = {".png", ".jpg",  ".jpeg", ".bmp",
                                                                ".tif", ".tiff", ".webp", ".pgm"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

Result<void> visitPictures(const std::filesystem::path &file, int videoStep,
                           const std::function<bool(const Frame &, const std::string &)> &visit)
{
    const std::string name = file.filename().string();
    if (isStillPicture(file)) {
        const auto picture = readPicture(file);
        if (!picture)
            return tl::unexpected(picture.error());
        visit(*picture, name);
        return {};
    }
    auto reader = VideoReader::open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    for (;;) {
        const auto frame = (*reader)->next();
        if (!frame)
            return tl::unexpected(frame.error());
        if (!*frame)
            return {};
        if ((*frame)->index % videoStep == 0 && !visit(**frame, name + "@" + std::to_string((*frame)->index)))
            return {};
    }
}

} // namespace odo
