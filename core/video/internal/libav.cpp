// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/libav.h"

#include <cstring>
#include <mutex>
#include <system_error>
#include <type_traits>

namespace odo::libav {

namespace {

template <class Enumeration>
void forgetUnknown(Enumeration &stated, Enumeration end, Enumeration notStated)
{
    std::underlying_type_t<Enumeration> number{};
    std::memcpy(&number, &stated, sizeof number);
    if (number >= end)
        stated = notStated;
}

} // namespace

void forgetUnknownColours(AVCodecParameters &parameters)
{
    forgetUnknown(parameters.color_range, AVCOL_RANGE_NB, AVCOL_RANGE_UNSPECIFIED);
    forgetUnknown(parameters.color_space, AVCOL_SPC_NB, AVCOL_SPC_UNSPECIFIED);
    forgetUnknown(parameters.color_trc, AVCOL_TRC_NB, AVCOL_TRC_UNSPECIFIED);
    forgetUnknown(parameters.chroma_location, AVCHROMA_LOC_NB, AVCHROMA_LOC_UNSPECIFIED);
}

int checked(int answer)
{
    if (answer == AVERROR(ENOMEM))
        throw std::bad_alloc();
    if (answer == AVERROR(EMFILE) || answer == AVERROR(ENFILE))
        throw std::system_error(AVUNERROR(answer), std::generic_category());
    return answer;
}

AVColorSpace colourSpaceOf(YuvMatrix matrix)
{
    switch (matrix) {
    case YuvMatrix::Bt709:
        return AVCOL_SPC_BT709;
    case YuvMatrix::Bt2020:
        return AVCOL_SPC_BT2020_NCL;
    default:
        return AVCOL_SPC_SMPTE170M;
    }
}

std::string errorText(int error)
{
    char text[AV_ERROR_MAX_STRING_SIZE] = {};
    av_strerror(error, text, sizeof text);
    return text;
}

void quieten()
{
    static std::once_flag once;
    std::call_once(once, [] { av_log_set_level(AV_LOG_QUIET); });
}

} // namespace odo::libav

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
    return ODO_TEXT("video.failed_before", "writing failed earlier");
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
