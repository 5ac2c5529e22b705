// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_uri.h"

namespace odo {

namespace {

CameraWish wishIn(std::string_view part)
{
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos)
        return {std::string(part), {}, {}};
    return {std::string(part), std::string(part.substr(0, equals)), std::string(part.substr(equals + 1))};
}

} // namespace

CameraUri splitCameraUri(std::string_view uri, std::string_view scheme)
{
    const std::string_view all = uri.substr(scheme.size());
    const std::size_t question = all.find('?');
    CameraUri split{std::string(all.substr(0, question))};
    if (question == std::string_view::npos)
        return split;
    for (std::string_view rest = all.substr(question + 1); !rest.empty();) {
        const std::size_t ampersand = rest.find('&');
        split.wishes.push_back(wishIn(rest.substr(0, ampersand)));
        rest = ampersand == std::string_view::npos ? std::string_view() : rest.substr(ampersand + 1);
    }
    return split;
}

bool takesWishes(const std::string &uri)
{
    return uri.starts_with("v4l2:") || uri.starts_with("aravis:");
}

std::string withoutWishes(const std::string &uri)
{
    return takesWishes(uri) ? uri.substr(0, uri.find('?')) : uri;
}

std::string withWishes(const std::string &uri, const std::vector<CameraWish> &wishes)
{
    std::string whole = withoutWishes(uri);
    for (std::size_t i = 0; i < wishes.size(); ++i)
        whole += (i == 0 ? '?' : '&') + wishes[i].text;
    return whole;
}

} // namespace odo
