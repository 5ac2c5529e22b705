// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/lens/internal/board_search.h"
#include "ui/testbed/lens/internal/lens_solver.h"

#include <QStringList>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QTabWidget;

namespace odo {

class BoardCanvas;
class Card;
class FactList;
class PictureBars;

/// Third page of the lens wizard: the lens in words and millimetres, how well each picture fits, what leaving
/// some out changes, and a picture straightened by it.
class LensResultPage : public QWidget
{
    Q_OBJECT
public:
    explicit LensResultPage(QWidget *parent = nullptr);

    /// Solves for these pictures from the start.
    void begin(const SearchState &pictures);
    void cancel() { m_solver.cancel(); }
    /// While the lens is being stored, and when that failed: it still stands here.
    void showSaving();
    void showNotSaved(const Error &error);
    /// The lens that stands there; none while it is being solved, or where it could not.
    const std::optional<IntrinsicCalibration> &calibration() const { return m_calibration; }
    const std::vector<KeptPicture> &pictures() const { return m_pictures.kept; }

Q_SIGNALS:
    void completeChanged();

private:
    QWidget *makeFigures();
    void solve();
    void solveAgain(double mostRmsPx);
    void ask(LensQuestion question);
    void showFigures();
    const CalibrationPicture *outcomeOf(int index) const;
    void showAnswer(const LensAnswer &answer);
    void showFailure(const Error &error);
    void showPicture(int index);

    SearchState m_pictures;
    std::optional<IntrinsicCalibration> m_all; ///< from all pictures: what a threshold starts from
    std::optional<IntrinsicCalibration> m_calibration;
    LensSolver m_solver;
    QLabel *m_verdict;
    QProgressBar *m_progress;
    PictureBars *m_bars;
    BoardCanvas *m_canvas, *m_straight;
    FactList *m_facts;
    QComboBox *m_model;
};

} // namespace odo
