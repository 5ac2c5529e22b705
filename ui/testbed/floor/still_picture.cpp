// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/still_picture.h"

#include "core/capture/settled_picture.h"
#include "core/video/picture.h"
#include "core/workflow/picture_source.h"
#include "ui/views/path_field.h"
#include "ui/views/screen_image.h"

namespace odo {
namespace {

constexpr int videoStep = 15, mostPictures = 8;

Result<void> lookIn(const Frame &frame, const MarkerLayout &layout, const std::optional<Intrinsics> &lens, StillPicture &best)
{
    if (lens && (lens->widthPx != frame.format.width || lens->heightPx != frame.format.height))
        return fail(ErrorCode::InvalidInput, "the picture",
                    "it is " + std::to_string(frame.format.width) + "×" + std::to_string(frame.format.height) + ", but the lens was measured at " +
                        std::to_string(lens->widthPx) + "×" + std::to_string(lens->heightPx),
                    "take it at that resolution, or measure the lens again");
    if (layout.markers.empty()) {
        best.frame = frame;
        return {};
    }
    MarkerSearch search;
    search.camera = cameraOf(lens, frame.format.width, frame.format.height);
    search.intrinsicsKnown = lens.has_value();
    const auto markers = findMarkers(frame, layout, search);
    const bool first = best.frame.format.width == 0;
    if (!first && (!markers || markers->size() <= best.markers.size()))
        return {};
    best.frame = frame;
    best.markers = markers.value_or(std::vector<MarkerPixel>());
    best.notFound = markers ? std::nullopt : std::optional<Error>(markers.error());
    return {};
}

Result<StillPicture> fromCamera(const std::string &uri, const MarkerLayout &layout, const std::optional<Intrinsics> &lens,
                                const JobControl &control)
{
    auto camera = openCamera(uri);
    if (!camera)
        return tl::unexpected(camera.error());
    const auto frame = settledPicture(**camera, control);
    if (!frame)
        return tl::unexpected(frame.error());
    StillPicture picture;
    if (auto looked = lookIn(*frame, layout, lens, picture); !looked)
        return tl::unexpected(looked.error());
    return picture;
}

} // namespace

CameraModel cameraOf(const std::optional<Intrinsics> &lens, int widthPx, int heightPx)
{
    if (lens)
        if (auto camera = CameraModel::create(*lens))
            return *camera;
    return CameraModel::assumed(widthPx, heightPx);
}

Result<StillPicture> takeStillPicture(const PictureOrigin &origin, const MarkerLayout &layout, const std::optional<Intrinsics> &lens,
                                      const JobControl &control)
{
    Result<StillPicture> picture = StillPicture();
    if (!origin.liveUri.isEmpty()) {
        picture = fromCamera(origin.liveUri.toStdString(), layout, lens, control);
    } else {
        int looked = 0;
        Result<void> problem;
        const auto visited = visitPictures(pathOf(origin.file), videoStep, [&](const Frame &frame, const std::string &name) {
            control.report(double(looked) / mostPictures, "looking for the markers in " + name);
            problem = lookIn(frame, layout, lens, *picture);
            return problem && picture->markers.size() < layout.markers.size() && ++looked < mostPictures && !control.isCancelled();
        }, control.cancel);
        if (!problem)
            return tl::unexpected(problem.error());
        if (!visited && picture->frame.format.width == 0)
            return tl::unexpected(visited.error());
    }
    if (control.isCancelled())
        return cancelled("the picture");
    if (picture)
        picture->image = toImage(toScreen(picture->frame, picture->frame.format.width, picture->frame.format.height));
    return picture;
}

} // namespace odo
