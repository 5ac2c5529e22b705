// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/aravis/internal/aravis_controls.h"

#include "core/capture/aravis/internal/aravis_device.h"
#include "core/capture/camera_source.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

struct KnownFeature
{
    const char *id, *name, *unit;
    const char *automatic; ///< what changes it by itself; empty without
};

// An automatic comes before what it changes.
constexpr std::array<KnownFeature, 10> known{{{"ExposureAuto", "Automatic exposure", "", ""},
                                              {"ExposureTime", "Exposure", "µs", "ExposureAuto"},
                                              {"ExposureTimeAbs", "Exposure", "µs", "ExposureAuto"},
                                              {"GainAuto", "Automatic gain", "", ""},
                                              {"Gain", "Gain", "dB", "GainAuto"},
                                              {"GainRaw", "Gain", "", "GainAuto"},
                                              {"BalanceWhiteAuto", "Automatic white balance", "", ""},
                                              {"BalanceRatio", "White balance", "", "BalanceWhiteAuto"},
                                              {"BlackLevel", "Black level", "", ""},
                                              {"Gamma", "Gamma", "", ""}}};
constexpr const char *off = "Off";

bool isAutomatic(const KnownFeature &feature)
{
    return std::string_view(feature.id).ends_with("Auto");
}

ArvGcNode *nodeOf(ArvCamera *camera, const char *id)
{
    ArvFailure failure;
    if (!arv_camera_is_feature_implemented(camera, id, failure.out()) || failure)
        return nullptr;
    return arv_device_get_feature(arv_camera_get_device(camera), id);
}

bool readChoice(ArvCamera *camera, CameraControl &control)
{
    control.kind = CameraControl::Kind::Choice;
    ArvFailure failure;
    unsigned count = 0;
    const ArvList<const char *> entries(
        arv_camera_dup_available_enumerations_as_strings(camera, control.id.c_str(), &count, failure.out()));
    if (failure || count == 0)
        return false;
    control.choices.assign(entries.get(), entries.get() + count);
    const char *chosen = arv_camera_get_string(camera, control.id.c_str(), failure.out());
    if (failure || !chosen)
        return false;
    control.value = static_cast<double>(std::ranges::find(control.choices, chosen) - control.choices.begin());
    control.maximum = count - 1;
    control.step = 1;
    return true;
}

bool readReal(ArvCamera *camera, CameraControl &control)
{
    control.kind = CameraControl::Kind::Real;
    ArvFailure failure;
    control.value = arv_camera_get_float(camera, control.id.c_str(), failure.out());
    if (failure)
        return false;
    arv_camera_get_float_bounds(camera, control.id.c_str(), &control.minimum, &control.maximum,
                                failure.out());
    return !failure;
}

bool readInteger(ArvCamera *camera, CameraControl &control)
{
    control.kind = CameraControl::Kind::Integer;
    ArvFailure failure;
    gint64 least = 0, most = 0;
    control.value = static_cast<double>(arv_camera_get_integer(camera, control.id.c_str(), failure.out()));
    if (failure)
        return false;
    arv_camera_get_integer_bounds(camera, control.id.c_str(), &least, &most, failure.out());
    control.minimum = static_cast<double>(least);
    control.maximum = static_cast<double>(most);
    control.step = static_cast<double>(std::max<gint64>(
        1, arv_camera_get_integer_increment(camera, control.id.c_str(), ArvFailure().out())));
    return !failure;
}

/// nullopt where the camera has no such feature.
std::optional<CameraControl> readControl(ArvCamera *camera, const KnownFeature &feature)
{
    ArvGcNode *node = nodeOf(camera, feature.id);
    if (!node)
        return std::nullopt;
    CameraControl control;
    control.id = feature.id;
    control.name = feature.name;
    control.unit = feature.unit;
    const bool read = ARV_IS_GC_ENUMERATION(node) ? readChoice(camera, control)
                      : ARV_IS_GC_FLOAT(node)     ? readReal(camera, control)
                      : ARV_IS_GC_INTEGER(node)   ? readInteger(camera, control)
                                                  : false;
    if (!read)
        return std::nullopt;
    control.standard = control.value;
    control.readOnly = arv_gc_feature_node_is_locked(ARV_GC_FEATURE_NODE(node), ArvFailure().out());
    return control;
}

} // namespace

std::vector<CameraControl> readAravisControls(ArvCamera *camera)
{
    std::vector<CameraControl> controls;
    for (const KnownFeature &feature : known) {
        if (auto control = readControl(camera, feature))
            controls.push_back(std::move(*control));
    }
    return controls;
}

Result<void> setAravisControl(ArvCamera *camera, const std::string &uri, const std::string &id, double value)
{
    const auto feature =
        std::ranges::find(known, id, [](const KnownFeature &one) { return std::string(one.id); });
    const auto control = feature == known.end() ? std::nullopt : readControl(camera, *feature);
    if (!control)
        return noSuchControl(uri, id);
    if (control->readOnly)
        return fail(
            ErrorCode::InvalidInput, cameraAtAddress(uri),
            ODO_TEXT("capture.control_automatic", "%1 cannot be set while it is automatic")(control->name),
            ODO_TEXT("capture.turn_automatic_off", "turn automatic mode off"));
    if (!(value >= control->minimum && value <= control->maximum))
        return fail(ErrorCode::InvalidInput, cameraAtAddress(uri),
                    controlGoes(control->name, quantity(control->minimum, 2), quantity(control->maximum, 2)),
                    ODO_TEXT("capture.set_between", "set it to something between"));
    ArvFailure failure;
    switch (control->kind) {
    case CameraControl::Kind::Choice:
        arv_camera_set_string(camera, id.c_str(),
                              control->choices[static_cast<std::size_t>(std::lround(value))].c_str(),
                              failure.out());
        break;
    case CameraControl::Kind::Real:
        arv_camera_set_float(camera, id.c_str(), value, failure.out());
        break;
    default:
        arv_camera_set_integer(camera, id.c_str(), std::llround(value), failure.out());
    }
    if (failure.is(ARV_DEVICE_ERROR_TIMEOUT))
        return noAnswer(uri);
    if (failure)
        return fail(ErrorCode::InvalidInput, cameraAtAddress(uri),
                    ODO_TEXT("capture.control_not_taken",
                             "it rejects this value for %1 (%2)")(control->name, failure.words()),
                    ODO_TEXT("capture.set_to_something_else", "set another value"));
    return {};
}

HeldAutomatics holdAravisAutomatics(ArvCamera *camera)
{
    HeldAutomatics held;
    for (const KnownFeature &feature : known) {
        const auto control = readControl(camera, feature);
        if (!control)
            continue;
        if (!isAutomatic(feature)) {
            // What an automatic has left belongs to what is held: a camera that comes back has forgotten it.
            if (*feature.automatic != '\0' && !control->readOnly)
                held.settings.emplace_back(feature.id, control->value);
            continue;
        }
        const auto choice = std::ranges::find(control->choices, off);
        const auto location = static_cast<double>(choice - control->choices.begin());
        const bool isOff = choice != control->choices.end() &&
                           (control->value == location || setAravisControl(camera, {}, feature.id, location));
        if (isOff && control->value != location)
            held.automatics.emplace_back(feature.id, control->value);
        if (isOff)
            held.settings.emplace_back(feature.id, location);
        else
            held.notHeld.push_back(foreignWords(feature.name));
    }
    return held;
}

Message exposureAndGain()
{
    return ODO_TEXT("capture.exposure_and_gain", "Exposure and gain");
}

tl::unexpected<Error> noAnswer(const std::string &uri)
{
    return fail(ErrorCode::Unavailable, cameraAtAddress(uri), doesNotAnswer(), checkPowerAndCable());
}

} // namespace odo
