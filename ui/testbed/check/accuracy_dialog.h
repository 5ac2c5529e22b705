// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/placement_advice.h"
#include "ui/models/background_task.h"
#include "ui/testbed/check/expected_accuracy.h"
#include "ui/testbed/floor/floor_camera.h"

#include <QDialog>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace odo {

class FloorSketch;
class PlannedCameraForm;

/// The expected accuracy of floor positions: with the registered cameras, one alone, or planned cameras,
/// which the user moves by mouse or numbers, or to the best position; and which registered camera to move.
/// Stores nothing.
class AccuracyDialog : public QDialog
{
    Q_OBJECT
public:
    /// cameras: registered by the layout. question: the height of the robot is to begin with.
    AccuracyDialog(const MarkerLayout &layout, const std::vector<CheckCamera> &cameras,
                   const PlacementQuestion &question, QWidget *parent = nullptr);
    ~AccuracyDialog() override;

    FloorSketch &sketch() { return *m_sketch; }
    bool isSettled() const
    {
        return !m_maker.isRunning() && !m_search.isRunning() && !m_advising.isRunning();
    }
    /// Of the camera in a row of the list; nullopt: it is a registered one.
    std::optional<PlannedCamera> planned(int row) const;

    void done(int result) override;

private:
    struct Entry
    {
        QString name;
        MappedCamera camera;
        QString remark;                            ///< of a registered one
        std::optional<std::size_t> movedFrom = {}; ///< it is the registered one of this row, elsewhere
        bool isCounted = true;
    };

    QWidget *makeSide();
    QWidget *makeCameraCard();
    QWidget *makePlanCard();
    int currentRow() const;
    PlannedCamera *currentPlanned();
    void addPlanned();
    void removePlanned();
    void findBestPosition();
    void positionFound(const std::optional<Error> &error);
    void askForAdvice();
    void showAdvice(const std::optional<Error> &error);
    void tick(std::size_t row, bool isCounted);
    void showList();
    void showChosen();
    void recompute();
    void showAccuracy(const ExpectedAccuracy &accuracy);
    void drag(int camera, const Eigen::Vector2d &position, bool aim);
    std::vector<std::size_t> counted() const;

    const MarkerLayout m_layout;
    PlacementQuestion m_question;
    std::vector<Entry> m_entries;
    int m_plannedSoFar = 0;
    FloorSketch *m_sketch;
    QListWidget *m_list;
    PlannedCameraForm *m_form;
    QComboBox *m_show;
    QDoubleSpinBox *m_robotHeight, *m_reach;
    QCheckBox *m_above;
    QPushButton *m_add, *m_remove, *m_advise, *m_best;
    QLabel *m_advice, *m_summary, *m_problem;
    QWidget *m_planCard = nullptr;
    AccuracyMaker m_maker;
    std::shared_ptr<PlannedCamera> m_found;
    int m_foundRow = -1;
    BackgroundTask m_search;
    std::shared_ptr<PlacementAdvice> m_given;
    BackgroundTask m_advising;
};

} // namespace odo
