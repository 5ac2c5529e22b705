// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/intrinsic_calibration.h"
#include "ui/testbed/lens/internal/board_search.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <thread>
#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QTabWidget;

namespace odo {

/// The calibration to solve, and an image to straighten with the result.
struct LensQuestion
{
    std::vector<BoardView> views;
    QSize size;                     ///< of the images
    std::optional<LensModel> model; ///< nullopt: chosen by held-out error
    /// set: solve again from the chosen ones of its images, instead of the views
    std::optional<IntrinsicCalibration> reference;
    std::vector<std::size_t> chosen;
    QImage example;
};

struct LensAnswer
{
    IntrinsicCalibration calibration;
    QImage straightened; ///< the example without the lens's bending
};

/// Solves in the background. A new question ends the one before, whose end is not waited for. Signals come on
/// the object's thread, for the newest question alone. The destructor cancels and waits.
class LensSolver : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;
    ~LensSolver() override;
    void solve(LensQuestion question);
    void cancel();

Q_SIGNALS:
    void progressed(double fraction, const QString &text);
    void solved(const odo::LensAnswer &answer);
    void failed(const odo::Error &error);

private:
    void start();
    void finish(const Result<LensAnswer> &answer);

    std::thread m_thread; ///< joinable while one is being solved
    CancelToken m_cancel;
    std::optional<LensQuestion> m_next; ///< waits for the one before to end
    bool m_wanted = false;              ///< the answer to the one being solved
};

/// The image as a camera of the same focal length without distortion would show it. Any thread.
QImage straightened(const QImage &image, const Intrinsics &lens);

class BoardCanvas;
class Card;
class FactList;
class ImageBars;

/// Third page of the lens wizard: the calibration in words and millimetres, how well each image fits, the
/// effect of leaving some out, and a straightened image.
class CalibrationResultPage : public QWidget
{
    Q_OBJECT
public:
    explicit CalibrationResultPage(QWidget *parent = nullptr);

    /// Solves for these images from the start.
    void begin(const SearchState &images);
    void cancel() { m_solver.cancel(); }
    /// While the calibration is being stored, and if that failed: it is still shown.
    void showSaving();
    void showNotSaved(const Error &error);
    /// The calibration on the page; none while it is being solved, or if that failed.
    const std::optional<IntrinsicCalibration> &calibration() const { return m_calibration; }
    const std::vector<KeptImage> &images() const { return m_images.kept; }

Q_SIGNALS:
    void completeChanged();

private:
    QWidget *makeMetrics();
    void solve();
    void solveAgain(double mostRmsPx);
    void ask(LensQuestion question);
    void showMetrics();
    QString imagesLeftOut() const;
    QString cornersLeftOut() const;
    const CalibrationImage *outcomeOf(int index) const;
    void showAnswer(const LensAnswer &answer);
    void showFailure(const Error &error);
    void showImage(int index);

    SearchState m_images;
    std::optional<IntrinsicCalibration> m_all; ///< from all images: where a threshold starts
    std::optional<IntrinsicCalibration> m_calibration;
    LensSolver m_solver;
    QLabel *m_verdict;
    QProgressBar *m_progress;
    ImageBars *m_bars;
    BoardCanvas *m_canvas, *m_straight;
    FactList *m_facts;
    QComboBox *m_model;
};

} // namespace odo
