// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/registered_scene.h"

#include "core/video/image_reader.h"
#include "core/workflow/shared_words.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace odo {

namespace {

/// Behind the tracker's version in a series.
constexpr const char *shiftedWords = "; shifted ";

std::optional<ViewChange> changeSinceRegistration(const RegisteredView &view)
{
    if (view.registrationImage.empty() || view.convertedFromPx)
        return std::nullopt;
    const auto image = readImage(view.registrationImage);
    const auto reader = VideoReader::open(view.file, {}, knownRecording(view.recording));
    const auto frame = reader ? (*reader)->frameAt(0) : tl::unexpected(reader.error());
    return image && frame ? changeOfView(image->y, frame->y) : std::nullopt;
}

Message useOriginalOrRegister()
{
    return ODO_TEXT("workflow.use_original_or_register",
                    "use the file as the camera wrote it, or register the camera again in a frame of this "
                    "video");
}

/// How it differs, where it is another one.
Message otherScene(const ViewChange &change)
{
    constexpr double degrees = 57.29577951308232;
    switch (change.kind) {
    case ViewChange::Kind::Mirrored:
        return ODO_TEXT("workflow.scene_mirrored",
                        "it is mirrored against the image by which its camera was registered");
    case ViewChange::Kind::Turned:
        return ODO_TEXT("workflow.scene_turned",
                        "it is turned by %1 against the image by which its camera was registered")(
            quantity(std::abs(change.turnRad) * degrees, 0, "°"));
    case ViewChange::Kind::Zoomed:
        return ODO_TEXT("workflow.scene_zoomed", "it shows the scene %1 times as large as the image by which "
                                                 "its camera was registered")(quantity(change.zoom, 2));
    case ViewChange::Kind::Panned:
    case ViewChange::Kind::Shifted:
    case ViewChange::Kind::Same:
        break;
    }
    return ODO_TEXT("workflow.scene_far_shifted",
                    "its scene is shifted by %1 against the image by which its camera was registered")(
        quantity(change.shiftPx, 0, "px"));
}

bool isOther(const std::optional<ViewChange> &change)
{
    return change && change->isOtherView();
}

} // namespace

std::vector<std::optional<ViewChange>> changesSinceRegistration(const std::vector<RegisteredView> &views,
                                                                const CancelToken &cancel)
{
    std::vector<std::optional<ViewChange>> changes(views.size());
    for (std::size_t v = 0; v < views.size() && !cancel.isCancelled(); ++v) // one by one, for their memory
        changes[v] = changeSinceRegistration(views[v]);
    return changes;
}

Result<void> checkSameScene(const std::string &trialName, const std::vector<RegisteredView> &views,
                            const std::vector<std::optional<ViewChange>> &changes)
{
    for (std::size_t v = 0; v < views.size(); ++v)
        if (isOther(changes[v]))
            return fail(ErrorCode::InvalidInput, viewInTrialSubject(views[v].recording.cameraName, trialName),
                        otherScene(*changes[v]), useOriginalOrRegister());
    return {};
}

FloorView widenedByShift(const FloorView &view, double shiftPx)
{
    const Intrinsics &lens = view.camera().intrinsics();
    // by which a roll shifts what lies half-way between the centre and the rim
    const double leverPx = std::hypot(lens.widthPx, lens.heightPx) / 4;
    return view.perhapsTurned(shiftPx / leverPx, shiftPx / lens.fxPx);
}

void noteShift(const RegisteredView &view, double shiftPx, std::vector<ObservationSeries> &series)
{
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%s%.2f px from registration %lld", shiftedWords, shiftPx,
                  static_cast<long long>(view.registration->id));
    for (ObservationSeries &one : series)
        one.algorithm += text.data();
}

std::optional<double> notedShift(const ObservationSeries &series, RecordId registration)
{
    const std::size_t at = series.algorithm.find(shiftedWords);
    double shiftPx = 0;
    long long noted = 0;
    if (at == std::string::npos || std::sscanf(series.algorithm.c_str() + at + std::strlen(shiftedWords),
                                               "%lf px from registration %lld", &shiftPx, &noted) != 2)
        return std::nullopt;
    return noted == registration ? std::optional(shiftPx) : std::nullopt;
}

Message shiftedSentence(const std::string &trialName, const RecordingRecord &view, double shiftPx)
{
    return wholeMessage(
        viewInTrialSubject(view.cameraName, trialName),
        ODO_TEXT("workflow.scene_shifted",
                 "its scene is shifted by %1 against the image by which its camera was registered, so the "
                 "camera was moved, and the stated errors were increased by that")(
            quantity(shiftPx, 1, "px")),
        ODO_TEXT("workflow.register_in_this_video",
                 "register the camera again in a frame of this video and reanalyse"));
}

std::vector<Message> sceneWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                   const std::vector<std::optional<ViewChange>> &changes)
{
    std::vector<Message> sentences;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const RecordingRecord &recording = views[v].recording;
        if (isOther(changes[v]))
            sentences.push_back(wholeMessage(viewInTrialSubject(recording.cameraName, trialName),
                                             otherScene(*changes[v]), useOriginalOrRegister()));
        else if (changes[v] && changes[v]->kind == ViewChange::Kind::Shifted)
            sentences.push_back(shiftedSentence(trialName, recording, changes[v]->shiftPx));
    }
    return sentences;
}

} // namespace odo
