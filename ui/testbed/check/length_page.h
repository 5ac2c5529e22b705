// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/known_length.h"
#include "ui/testbed/check/check_camera.h"
#include "ui/testbed/floor/still_picture.h"

#include <QWidget>
#include <array>
#include <memory>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QTableWidget;

namespace odo {

class BadgeLabel;
class MarkerCanvas;

/// Second page of the length wizard: both ends of a known length in the picture, what it truly is, and at once how well
/// the camera measures it.
class LengthPage : public QWidget
{
    Q_OBJECT
public:
    explicit LengthPage(QWidget *parent = nullptr);

    /// While the picture is being got.
    void wait(const QString &words);
    void showFailure(const Error &error);
    void begin(std::shared_ptr<const StillPicture> picture, const CheckCamera &camera);

    MarkerCanvas &canvas() { return *m_canvas; }
    /// What was measured; nullopt until both ends are put.
    const std::optional<LengthCheck> &check() const { return m_check; }

private:
    struct End
    {
        Eigen::Vector2d pixel;
        double sigmaPx;
        QString seenAs;
    };

    QWidget *makeSide();
    QWidget *makeQuestions();
    int currentEnd() const;
    void place(const QString &label, const Eigen::Vector2d &pixel, bool snap);
    void evaluate();
    void showEnds();
    std::optional<double> toldM() const;

    std::shared_ptr<const StillPicture> m_picture;
    std::optional<CheckCamera> m_camera;
    std::array<std::optional<End>, 2> m_ends;
    std::optional<LengthCheck> m_check;
    MarkerCanvas *m_canvas;
    QTableWidget *m_table;
    QDoubleSpinBox *m_told, *m_height;
    QComboBox *m_unit;
    QCheckBox *m_snap;
    QLabel *m_length, *m_words;
    BadgeLabel *m_badge;
};

} // namespace odo
