// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// One of the parts behind the '?' of a camera's address: "rate=30". Without a '=' it has no name.
struct CameraWish
{
    std::string text; ///< as it was written
    std::string name, value;
};

/// A camera's address taken apart: "SCHEME:PLACE?a=1&b=2".
struct CameraUri
{
    std::string place; ///< empty where the address says none
    std::vector<CameraWish> wishes =
        {}; ///< in their order; which of them are understood is for the kind of camera
};

/// scheme: with its colon; the address must begin with it.
CameraUri splitCameraUri(std::string_view uri, std::string_view scheme);

/// Which camera an address means, without what is wanted of it: "v4l2:/dev/video0".
std::string withoutWishes(const std::string &uri);
/// With these in place of whatever the address wanted before.
std::string withWishes(const std::string &uri, const std::vector<CameraWish> &wishes);
/// USB and network cameras: others are what they are.
bool takesWishes(const std::string &uri);

} // namespace odo
