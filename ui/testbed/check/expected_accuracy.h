// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/accuracy_map.h"
#include "core/calibration/accuracy_words.h"
#include "ui/models/background_task.h"
#include "ui/testbed/check/accuracy_layer.h"

#include <QObject>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace odo {

/// A camera of a map: registered, or planned.
using MappedCamera = std::variant<FloorView, PlannedCamera>;

/// What is to be mapped.
struct AccuracyRequest
{
    MarkerLayout layout;
    std::vector<MappedCamera> cameras;
    std::optional<std::size_t> alone; ///< the map of this one; nullopt: of all together
    double robotHeightM = 0;
};

struct ExpectedAccuracy
{
    SketchedAccuracy map;
    AccuracySummary summary;
    std::vector<std::optional<Error>> problems; ///< one a camera: why it is not counted
};

/// σ of a followed robot over the markers and a margin about them, of the cameras that can be there. Pure, any thread.
ExpectedAccuracy expectedAccuracy(const AccuracyRequest &request);

/// Makes maps on a thread of its own; of the requests that come while one is made only the newest is made next. GUI thread.
class AccuracyMaker : public QObject
{
    Q_OBJECT
public:
    explicit AccuracyMaker(QObject *parent = nullptr);
    void make(AccuracyRequest request);
    bool isRunning() const { return m_task.isRunning(); }

Q_SIGNALS:
    void ready(const odo::ExpectedAccuracy &accuracy);

private:
    void begin(AccuracyRequest request);

    std::shared_ptr<ExpectedAccuracy> m_made;
    std::optional<AccuracyRequest> m_next;
    BackgroundTask m_task;
};

} // namespace odo
