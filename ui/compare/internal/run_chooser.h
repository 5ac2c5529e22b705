// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/shown_names.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QToolButton;

namespace odo {

/// Which runs are compared and how they are aligned: two lists and a button that swaps them, further runs
/// from a menu, the alignment, by hand the seconds by which the second run's moment is moved, by distance the
/// place.
class RunChooser : public QWidget
{
    Q_OBJECT
public:
    explicit RunChooser(QWidget *parent = nullptr);

    void setChoices(QList<RunChoice> choices);
    /// Emits nothing. Runs that are not among the choices are left out.
    void setRuns(const std::vector<CompareSettings::Run> &wanted);
    std::vector<CompareSettings::Run> runs() const;
    std::optional<AlignBy> alignBy() const;
    double shiftS() const;
    /// By distance: how far from the beginning of what is compared, metres; nullopt: where all have begun.
    std::optional<double> placeM() const;
    /// Back to what the runs themselves give. Emits nothing.
    void alignAutomatically();
    /// What the automatic choice came to.
    void setAlignedBy(AlignBy by);

Q_SIGNALS:
    void runsChanged();
    void alignmentChanged();

private:
    void swap();
    void toggleFurther(int choice, bool isWanted);
    void fillMenu();
    void showShift();

    QList<RunChoice> m_choices;
    QList<int> m_further; ///< indices of the runs beside the two
    QComboBox *m_first, *m_second, *m_align;
    QToolButton *m_swap, *m_more;
    QMenu *m_menu;
    QLabel *m_shiftName, *m_placeName;
    QDoubleSpinBox *m_shift, *m_place;
};

/// The alignment in words: "start gate".
QString alignmentWords(AlignBy by);

} // namespace odo
