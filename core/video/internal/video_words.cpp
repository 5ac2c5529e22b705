// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/video_words.h"

namespace odo {

Message cannotOpenVideo(const std::filesystem::path &file)
{
    return ODO_TEXT("video.cannot_open", "cannot open the video %1")(Named::file(file));
}

Message dataAreDamaged()
{
    return ODO_TEXT("video.data_damaged", "its data are damaged");
}

Message writingFailedBefore()
{
    return ODO_TEXT("video.failed_before", "writing has failed before");
}

Message copyFromCamera()
{
    return ODO_TEXT("video.copy_from_camera", "copy it from the camera again");
}

Message convertToH264()
{
    return ODO_TEXT("video.convert_to_h264", "convert it to H.264");
}

} // namespace odo
