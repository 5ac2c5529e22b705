// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/intrinsic_calibration.h"

#include <QImage>
#include <QObject>
#include <QSize>
#include <optional>
#include <thread>
#include <vector>

namespace odo {

/// What is to be solved, and a picture that is shown straightened by the answer.
struct LensQuestion
{
    std::vector<BoardView> views;
    QSize size;                     ///< of the pictures
    std::optional<LensModel> model; ///< nullopt: chosen by how well it foretells
    /// set: again from the chosen of its pictures, instead of the views
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

/// The picture as a camera of the same focal length without distortion would show it. Any thread.
QImage straightened(const QImage &picture, const Intrinsics &lens);

} // namespace odo
