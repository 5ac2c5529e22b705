// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/intrinsic_calibration.h"
#include "ui/models/background_task.h"
#include "ui/testbed/lens/internal/board_search.h"

#include <QLabel>

namespace odo {

/// How well a standard lens fits the images accepted so far, in words: their RMS, and which image is the
/// worst. Computed on a thread of its own after each change; of the changes that come meanwhile only the
/// last is followed. The calibration itself compares lens models and may be better. GUI thread.
class RmsSoFar : public QLabel
{
    Q_OBJECT
public:
    explicit RmsSoFar(QWidget *parent = nullptr);
    void setState(const SearchState &state);
    bool isSettled() const { return !m_task.isRunning(); }

private:
    struct Images
    {
        std::vector<BoardView> views;
        QStringList names;
        QSize size;
    };
    void begin(Images images);
    void showFit(const std::optional<Error> &error);

    QStringList m_names; ///< of the images that were asked about last
    Images m_fitted;     ///< those being fitted; without views
    std::shared_ptr<IntrinsicCalibration> m_fit;
    std::optional<Images> m_next;
    BackgroundTask m_task;
};

} // namespace odo
