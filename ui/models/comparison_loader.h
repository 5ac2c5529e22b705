// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/models/comparison_scene.h"

#include <filesystem>
#include <optional>

namespace odo {

/// Loads comparisons on a thread of its own, by a reading connection of its own, so that the window does not
/// wait. The newest request counts; one that is overtaken is not told. GUI thread.
class ComparisonLoader : public QObject
{
    Q_OBJECT
public:
    explicit ComparisonLoader(std::filesystem::path projectFile, QObject *parent = nullptr);

    void load(CompareSettings settings);
    bool isRunning() const { return m_wanted.has_value() || m_task.isRunning(); }

Q_SIGNALS:
    void loaded(const odo::ComparisonScenePtr &scene);
    void failed(const odo::Error &error);

private:
    void begin();
    void finish(const std::optional<Error> &error);

    std::filesystem::path m_file;
    std::optional<CompareSettings> m_wanted;      ///< not begun yet
    std::shared_ptr<ComparisonScenePtr> m_result; ///< of the one in work
    BackgroundTask m_task;
};

} // namespace odo
