// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/trial_export.h"

#include "core/exchange/file_name.h"
#include "core/files/output_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/shared_words.h"
#include "ui/main_window/internal/export_dialog.h"
#include "ui/main_window/language.h"
#include "ui/report/html_page.h"
#include "ui/views/widgets/form_fields.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFormLayout>
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

Result<std::string> pageOf(Project &project, const TrialRecord &trial, const std::string &robot)
{
    return htmlPage(project, {{trial.name}, robot, shownLanguage()}, {});
}

} // namespace

Result<DoneWork> exportTrial(Project &project, const QString &trial, const std::optional<TimeSpan> &selection,
                             QWidget &window)
{
    const TrialRecord record = ODO_TRY(project.trials().find(trial.toStdString()));
    const std::vector<AnalysisRecord> analyses = ODO_TRY(project.analyses().current(record.id));
    if (analyses.empty())
        return fail(ErrorCode::NotFound,
                    ODO_TEXT("ui.export_of", "export of %1")(Named::trial(trial.toStdString())),
                    notTrackedYet(), trackItFirst());
    const QString title = TrialExportWords::tr("Export %1").arg(trial);
    ExportOffer offer{title, {}, true, record.range.has_value(), selection};
    for (const AnalysisRecord &analysis : analyses)
        offer.robots << QString::fromStdString(analysis.robotName);
    ExportDialog dialog(offer, &window);
    if (dialog.exec() != QDialog::Accepted)
        return DoneWork(QString());
    const OutputFormat format = dialog.output();
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString offered =
        QString::fromStdString(fileNameOf(trial.toStdString())) + QLatin1Char('.') + format.ending;
    const auto chosen = askOutput(&window, title, folder.filePath(offered), {format});
    if (!chosen)
        return DoneWork(QString());
    const AnalysisRecord &analysis = analyses.at(static_cast<std::size_t>(dialog.robot()));
    if (dialog.isPage()) {
        const auto page = ODO_TRY(pageOf(project, record, analysis.robotName));
        ODO_TRY(writeOutput(chosen->target, page));
    } else {
        const TrackExport how = dialog.settings();
        const AnalysisRecord part = exportedPart(analysis, how);
        ODO_TRY(
            writeOutput(chosen->target, [&](const TextSink &sink) { return writeTrack(part, how, sink); }));
    }
    return DoneWork(
        TrialExportWords::tr("%1 was exported to %2.").arg(trial, QDir::toNativeSeparators(chosen->file)), {},
        chosen->file);
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
