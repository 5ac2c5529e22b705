// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/screen_image.h"

namespace odo {

QImage toImage(ScreenPicture &&picture)
{
    if (!picture.pixels)
        return {};
    auto *owned = new ScreenPicture(std::move(picture)); // freed by the image's last copy
    return QImage(
        reinterpret_cast<const uchar *>(owned->pixels.get()), owned->width, owned->height,
        owned->width * qsizetype(sizeof(std::uint32_t)), QImage::Format_RGB32,
        [](void *pointer) { delete static_cast<ScreenPicture *>(pointer); }, owned);
}

} // namespace odo
