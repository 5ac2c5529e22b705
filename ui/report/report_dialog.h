// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/report/report_maker.h"

#include <QDialog>
#include <QImage>
#include <QList>
#include <QScrollArea>
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
    std::vector<std::string> metricNames; ///< the score first where a task is scored
};

/// Chooses what a report is made of and how, shows its pages, and says whether it is to be saved or printed.
/// GUI thread; the pages are painted on another.
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
    /// The letterhead may be another one: rereads the settings and repaints.
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
    void showCreated(const QString &failure, bool isAll);
    const ReportSubject &subject() const;

    const QList<ReportSubject> m_subjects;
    const ReportChoices m_choices;
    ReportSettings m_settings;
    QComboBox *m_subject = nullptr, *m_class = nullptr, *m_task = nullptr, *m_metric = nullptr,
              *m_paper = nullptr;
    QCheckBox *m_teams, *m_method;
    QLabel *m_remark;
    QPushButton *m_save, *m_print;
    ReportPreview *m_preview;
    QFormLayout *m_form = nullptr;
};

/// The first pages of a report as they will be printed, one below the other, as wide as there is room. They
/// are made and painted on a thread of its own; what is overtaken by another report is not shown. Keys
/// scroll. GUI thread.
class ReportPreview : public QScrollArea
{
    Q_OBJECT
public:
    static constexpr std::size_t mostPages = 12;

    /// projectFile: that must stay open meanwhile.
    explicit ReportPreview(std::filesystem::path projectFile, QWidget *parent = nullptr);
    ~ReportPreview() override; ///< waits for the page in work
    void show(const ReportMaker &maker);
    /// Shows nothing, and gives up what is being made.
    void clear();
    bool isSettled() const { return !m_reader.isRunning(); }
    const QList<QImage> &images() const { return m_images; }

Q_SIGNALS:
    /// The pages are there, or why there are none (empty: they are). isAll: there are no further ones.
    void made(const QString &failure, bool isAll);

private:
    class Sheets;
    struct Made
    {
        QList<QImage> images;
        bool isAll = true;
    };
    static Result<Made> make(Project &project, const ReportMaker &maker, const CancelToken &cancel);
    void take(Result<Made> made);

    CancelToken m_cancel; ///< of what is being made
    ProjectReader m_reader;
    QList<QImage> m_images;
    Sheets *m_sheets;
};

} // namespace odo
