// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/export_job.h"
#include "ui/views/widgets/form_fields.h"

#include <QDialog>
#include <QStringList>
#include <QVariantMap>
#include <optional>

class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QListWidget;
class QPushButton;

namespace odo {

/// What can be asked about an export.
struct ExportOffer
{
    QString title;
    QStringList robots;                ///< to choose one of; one or none: it is not asked
    bool isOfOne = true;               ///< trial; several cannot become a page
    bool hasRange = false;             ///< the trial has one, so that its whole run is more
    std::optional<TimeSpan> selection; ///< of the time line
};

/// Asks how tracks are exported: format, columns, unit, axes, and which part of the run. Choices can be kept
/// by a name; the last ones are there again. GUI thread.
class ExportDialog : public QDialog
{
    Q_OBJECT
public:
    explicit ExportDialog(const ExportOffer &offer, QWidget *parent = nullptr);
    /// Not of a page.
    TrackExport settings() const;
    bool isPage() const; ///< HTML, which has all robots' charts and maps
    int robot() const;   ///< index
    OutputFormat output() const;
    void accept() override;

private:
    QComboBox *addChoice(QFormLayout &form, const QString &label);
    QLayout *makePresets();
    void offerPart(const ExportOffer &offer);
    void showFitting();
    void showColumnNames();
    void offerPresets(const QString &current);
    void savePreset();
    void removePreset();
    QVariantMap words() const;
    void setWords(const QVariantMap &words);
    QString formatWord() const;

    std::optional<TimeSpan> m_selection;
    QComboBox *m_preset, *m_robot, *m_format, *m_unit, *m_axes, *m_part;
    QPushButton *m_savePreset, *m_removePreset;
    QListWidget *m_columns;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
