// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report_maker.h"
#include "ui/report/report_settings.h"

#include <QDialog>
#include <QList>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace odo {

class ReportPreview;

/// Something that a report can be made of.
struct ReportSubject
{
    QString words;                             ///< in the list of what can be reported
    QString fileName;                          ///< that is proposed, without ending
    std::vector<std::string> trials;           ///< a report of each
    std::optional<CompareSettings> comparison; ///< or of these runs
    bool isClass = false;                      ///< or of a class, which is chosen in the dialog
};

/// What there is to choose from where the subject is a class.
struct ReportChoices
{
    QStringList classes, tasks;
    std::vector<std::string> figures; ///< the score first where a task is scored
};

/// Chooses what a report is made of and how, shows its pages, and says whether it is to be saved or printed. GUI
/// thread; the pages are painted on another.
class ReportDialog : public QDialog
{
    Q_OBJECT
public:
    ReportDialog(std::filesystem::path projectFile, QList<ReportSubject> subjects, ReportChoices choices,
                 QWidget *parent = nullptr);

    /// By what is chosen now.
    ReportMaker maker() const;
    QString proposedName() const;
    ReportPreview &preview() const { return *m_preview; }
    /// The letterhead may be another one: reads the settings, and paints anew.
    void refresh();

Q_SIGNALS:
    void saveRequested();
    void printRequested();
    void letterheadRequested(); ///< school, logo and wording are to be changed

private:
    QWidget *makeForm();
    QWidget *makeButtons();
    QComboBox *addChoice(QFormLayout &form, const QString &label);
    void addClassChoices(QFormLayout &form);
    void choose();
    void tellMade(const QString &failure, bool isAll);
    const ReportSubject &subject() const;

    const QList<ReportSubject> m_subjects;
    const ReportChoices m_choices;
    ReportSettings m_settings;
    QComboBox *m_subject = nullptr, *m_class = nullptr, *m_task = nullptr, *m_figure = nullptr, *m_paper = nullptr;
    QCheckBox *m_teams, *m_method;
    QLabel *m_remark;
    QPushButton *m_save, *m_print;
    ReportPreview *m_preview;
    QFormLayout *m_form = nullptr;
};

} // namespace odo
