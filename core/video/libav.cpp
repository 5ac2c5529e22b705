// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/libav.h"

#include <mutex>
#include <system_error>

namespace odo::libav {

int checked(int answer)
{
    if (answer == AVERROR(ENOMEM))
        throw std::bad_alloc();
    if (answer == AVERROR(EMFILE) || answer == AVERROR(ENFILE))
        throw std::system_error(AVUNERROR(answer), std::generic_category());
    return answer;
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
