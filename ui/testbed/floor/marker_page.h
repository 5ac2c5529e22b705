// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"
#include "ui/testbed/floor/still_picture.h"
#include "ui/views/widgets/card.h"

#include <QWidget>
#include <vector>

class QAction;
class QLabel;
class QTableWidget;

namespace odo {

class MarkerCanvas;
class RegistrationVerdict;

/// Second page of the floor wizard: the markers in the picture, found or put by hand, and at once where the
/// camera stands, how well each marker fits, and what is wrong.
class MarkerPage : public QWidget
{
    Q_OBJECT
public:
    explicit MarkerPage(QWidget *parent = nullptr);

    /// While the picture is being got.
    void wait(const QString &words);
    void begin(std::shared_ptr<const StillPicture> picture, const MarkerLayout &layout,
               const std::optional<Intrinsics> &lens);
    void showFailure(const Error &error);
    /// What was found stands: it can be tried again.
    void showNotSaved(const Error &error);

    /// What the markers say now; none where they do not determine it.
    const std::optional<FloorRegistration> &registration() const { return m_registration; }
    const std::vector<MarkerPixel> &pixels() const { return m_pixels; }
    MarkerCanvas &canvas() { return *m_canvas; }

Q_SIGNALS:
    void completeChanged();

private:
    QWidget *makeSide();
    QString currentLabel() const;
    void place(const QString &label, const Eigen::Vector2d &pixel, bool snap);
    void removeCurrent();
    void undo();
    void remember();
    void evaluate();
    void showTable();

    std::shared_ptr<const StillPicture> m_picture;
    MarkerLayout m_layout;
    std::optional<Intrinsics> m_lens;
    std::vector<MarkerPixel> m_pixels;
    std::vector<std::pair<std::string, QString>> m_kinds; ///< label and what it was taken for
    std::vector<std::vector<MarkerPixel>> m_before;       ///< for undo
    std::optional<FloorRegistration> m_registration;
    MarkerCanvas *m_canvas;
    QTableWidget *m_table;
    RegistrationVerdict *m_verdict;
    QAction *m_remove, *m_undo;
};

/// Says where a camera stands by the registration in the making, or why that is not known and what to do. GUI
/// thread.
class RegistrationVerdict : public Card
{
    Q_OBJECT
public:
    explicit RegistrationVerdict(QWidget *parent = nullptr);
    void tell(const FloorRegistration &registration);
    void tell(const QString &verdict, const QString &advice);
    /// It could not be stored; the verdict stays.
    void tellNotSaved(const Error &error);

private:
    QLabel *m_verdict, *m_advice;
};

} // namespace odo
