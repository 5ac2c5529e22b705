// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/testbed/targets/target_sheet.h"

#include <QDialog>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace odo {

class TargetPreview;
struct ChosenOutput;

/// Chooses a board, floor markers or a floor mat, shows the sheets as they will come out, and prints them or
/// writes a PDF.
class TargetDialog : public QDialog
{
    Q_OBJECT
public:
    /// labels: of the markers, in the order of the layout; empty: O, U, V, D.
    explicit TargetDialog(TargetKind kind, const QStringList &labels, QWidget *parent = nullptr);

    TargetSpec spec() const;
    /// What Save as PDF does once the file is chosen; the dialog shows any error.
    bool savePdf(const ChosenOutput &output);

private:
    QWidget *makeForm(const QStringList &labels);
    static QString whatIsPrinted(const TargetSpec &wanted);
    void suggestSizes();
    void refresh();
    void askPdf();
    void print();
    void showOutcome(const Result<void> &outcome, const QString &success);

    QComboBox *m_kind, *m_paper;
    QSpinBox *m_columns, *m_rows, *m_sheetColumns, *m_sheetRows;
    QDoubleSpinBox *m_square, *m_marker;
    QLineEdit *m_labels;
    QFormLayout *m_form;
    QWidget *m_corners, *m_sheets;
    TargetPreview *m_preview;
    QLabel *m_message;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
