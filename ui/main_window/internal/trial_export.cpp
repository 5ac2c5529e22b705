// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/trial_export.h"

#include "core/exchange/file_name.h"
#include "core/exchange/track_export.h"
#include "core/files/output_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"
#include "ui/main_window/language.h"
#include "ui/report/html_page.h"
#include "ui/views/widgets/form_fields.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QList>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

namespace odo {

namespace {

class TrialExportWords
{
    Q_DECLARE_TR_FUNCTIONS(TrialExport)
};

struct Format
{
    OutputFormat output;
    std::string (*text)(const AnalysisRecord &analysis); ///< null: a page
};

template <CsvStyle style>
std::string csvText(const AnalysisRecord &analysis)
{
    return trackCsv(analysis, style);
}

QList<Format> formats()
{
    const QString csv = QStringLiteral("csv");
    return {
        {{TrialExportWords::tr("CSV for programs (*.csv)"), csv, FileKind::Csv},
         &csvText<CsvStyle::Analysis>},
        {{TrialExportWords::tr("CSV for spreadsheets, 1.5 (*.csv)"), csv, FileKind::Csv},
         &csvText<CsvStyle::International>},
        {{TrialExportWords::tr("CSV for spreadsheets, 1,5 (*.csv)"), csv, FileKind::Csv},
         &csvText<CsvStyle::Continental>},
        {{TrialExportWords::tr("Tracker text (*.txt)"), QStringLiteral("txt"), FileKind::Tracker},
         &trackTracker},
        {{TrialExportWords::tr("TUM trajectory (*.tum)"), QStringLiteral("tum"), FileKind::Tum}, &trackTum},
        {{TrialExportWords::tr("Page to take along (*.html)"), QStringLiteral("html"), FileKind::Html},
         nullptr}};
}

/// The index of the one that is meant; -1: the person thought better of it.
int chooseRobot(const std::vector<AnalysisRecord> &analyses, QWidget &window)
{
    if (analyses.size() == 1)
        return 0;
    QStringList names;
    for (const AnalysisRecord &analysis : analyses)
        names << QString::fromStdString(analysis.robotName);
    bool accepted = false;
    const QString name = QInputDialog::getItem(&window, TrialExportWords::tr("Export"),
                                               TrialExportWords::tr("Robot:"), names, 0, false, &accepted);
    return accepted ? static_cast<int>(names.indexOf(name)) : -1;
}

} // namespace

Result<QString> exportTrial(Project &project, const QString &trial, QWidget &window)
{
    const TrialRecord record = ODO_TRY(project.trials().find(trial.toStdString()));
    const std::vector<AnalysisRecord> analyses = ODO_TRY(project.analyses().current(record.id));
    if (analyses.empty())
        return fail(ErrorCode::NotFound,
                    ODO_TEXT("ui.export_of", "export of %1")(Named::trial(trial.toStdString())),
                    notTrackedYet(), trackItFirst());
    const int robot = chooseRobot(analyses, window);
    if (robot < 0)
        return QString();
    QList<OutputFormat> outputs;
    for (const Format &format : formats())
        outputs << format.output;
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString offered = QString::fromStdString(fileNameOf(trial.toStdString())) + QStringLiteral(".csv");
    const auto chosen =
        askOutput(&window, TrialExportWords::tr("Export %1").arg(trial), folder.filePath(offered), outputs);
    if (!chosen)
        return QString();
    const AnalysisRecord &analysis = analyses.at(static_cast<std::size_t>(robot));
    const Format format = formats().at(chosen->format);
    const std::string text =
        format.text ? format.text(analysis)
                    : ODO_TRY(htmlPage(project, {{record.name}, analysis.robotName, shownLanguage()}, {}));
    ODO_TRY(writeOutput(chosen->target, text));
    return TrialExportWords::tr("%1 was exported to %2.").arg(trial, QDir::toNativeSeparators(chosen->file));
}

VideoDialog::VideoDialog(const QString &title, bool isDark, QWidget *parent)
    : QDialog(parent), m_speed(new QComboBox), m_size(new QComboBox), m_theme(new QComboBox)
{
    setWindowTitle(title);
    m_speed->addItem(tr("Real time"), 1.0);
    m_speed->addItem(tr("Slow motion, 1/2"), 0.5);
    m_speed->addItem(tr("Slow motion, 1/4"), 0.25);
    m_speed->addItem(tr("Slow motion, 1/10"), 0.1);
    for (const QSize size : {QSize(1920, 1080), QSize(1280, 720), QSize(3840, 2160)})
        m_size->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
    m_theme->addItem(tr("Light"), false);
    m_theme->addItem(tr("Dark"), true);
    m_theme->setCurrentIndex(isDark ? 1 : 0);
    auto *words = new QLabel(tr("One video with all camera views, the map and the speed, to show or send. It "
                                "plays without Odograph."));
    words->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Speed"), m_speed);
    form->addRow(tr("Si&ze"), m_size);
    form->addRow(tr("&Theme"), m_theme);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *accept = buttons->addButton(tr("Choose a file…"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    constexpr int width = 420;
    resize(width, layout->totalHeightForWidth(width));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

AnnotatedVideoSettings VideoDialog::settings() const
{
    AnnotatedVideoSettings settings;
    settings.speed = m_speed->currentData().toDouble();
    settings.sizePx = m_size->currentData().toSize();
    settings.isDark = m_theme->currentData().toBool();
    return settings;
}

} // namespace odo
