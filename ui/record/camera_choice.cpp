// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/camera_choice.h"

#include "core/capture/camera_uri.h"

#include <QSettings>
#include <algorithm>
#include <set>

namespace odo {
namespace {

const QString group = QStringLiteral("record/cameras");
const std::string simulated = "sim:";

} // namespace

std::vector<ChosenCamera> proposeCameras(const std::vector<CameraRecord> &cameras,
                                         const std::vector<CameraDescription> &connected,
                                         const std::map<std::string, std::string> &before)
{
    std::vector<ChosenCamera> chosen;
    for (const CameraRecord &camera : cameras)
        chosen.emplace_back(camera.name, "");
    if (chosen.empty()) {
        for (std::size_t i = 0; i < std::min<std::size_t>(2, connected.size()); ++i)
            chosen.emplace_back(std::string(1, char('A' + i)), "");
    }
    std::set<std::string> free;
    bool anyReal = false;
    for (const CameraDescription &device : connected) {
        if (device.busy)
            continue; // another program has it
        free.insert(device.uri);
        anyReal = anyReal || device.kind != "simulated";
    }
    const auto give = [&](ChosenCamera &camera, const std::string &uri) {
        if (camera.second.empty() && free.erase(withoutWishes(uri)) > 0)
            camera.second = uri;
    };
    for (std::size_t i = 0; i < cameras.size(); ++i)
        give(chosen[i], cameras[i].deviceUri);
    for (ChosenCamera &camera : chosen) {
        if (const auto was = before.find(camera.first); was != before.end())
            give(camera, was->second);
    }
    for (ChosenCamera &camera : chosen) {
        if (!anyReal)
            give(camera, simulated + camera.first);
        for (const CameraDescription &device : connected) {
            if (device.kind != "simulated")
                give(camera, device.uri);
        }
    }
    return chosen;
}

std::map<std::string, std::string> rememberedCameras()
{
    QSettings settings;
    settings.beginGroup(group);
    std::map<std::string, std::string> before;
    for (const QString &name : settings.childKeys())
        before[name.toStdString()] = settings.value(name).toString().toStdString();
    return before;
}

void rememberCameras(const std::vector<ChosenCamera> &cameras)
{
    QSettings settings;
    settings.beginGroup(group);
    for (const auto &[name, uri] : cameras)
        settings.setValue(QString::fromStdString(name), QString::fromStdString(uri));
}

} // namespace odo
