// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/backups_dialog.h"

#include "core/project/names.h"
#include "core/project/project.h"
#include "core/project/project_rescue.h"
#include "ui/main_window/preferences/backup_plan.h"
#include "ui/models/number_text.h"
#include "ui/models/project_changes.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/table_list.h"

#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QTableWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

constexpr int shownNames = 5; ///< of trials; the list of changes has the rest
constexpr int leftWidth = 290, rightWidth = 500;

QLabel *wrappedLabel(const QString &name)
{
    auto *label = new QLabel;
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    label->setAccessibleName(name);
    return label;
}

QString namesText(const std::vector<std::string> &names)
{
    QStringList shown;
    for (std::size_t i = 0; i < std::min<std::size_t>(shownNames, names.size()); ++i)
        shown << QString::fromStdString(names[i]);
    return names.size() > shownNames ? shown.join(QStringLiteral(", ")) + QStringLiteral(" …")
                                     : shown.join(QStringLiteral(", "));
}

} // namespace

BackupsDialog::BackupsDialog(const std::filesystem::path &project, bool readOnly, QWidget *parent)
    : QDialog(parent), m_project(project), m_readOnly(readOnly), m_list(new QTableWidget(0, 2)),
      m_preview(wrappedLabel(tr("What restoring would change"))), m_message(wrappedLabel(tr("Message"))),
      m_changes(new QTableView), m_make(new QPushButton(tr("&Back up now"))),
      m_restore(new QPushButton(tr("&Restore this backup"))), m_previewReader(project), m_maker(project)
{
    setWindowTitle(tr("Backups"));
    const QString folder = textOf(backupFolderOf(project));
    const BackupPlan plan = chosenBackupPlan();
    auto *where = wrappedLabel(tr("Folder of the backups"));
    where->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    where->setText(tr("Backups are in %1. They contain everything except the videos.")
                       .arg(QDir::toNativeSeparators(folder)) +
                   QLatin1Char(' ') +
                   (plan.isDaily
                        ? tr("One is made each day on which you open the project, and kept for %n day(s).",
                             nullptr, plan.daysKept)
                        : tr("Daily backups are switched off in the preferences.")));
    auto *open = new QPushButton(tr("&Open folder"));
    open->setAutoDefault(false);
    connect(open, &QPushButton::clicked, this,
            [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
    m_list->setHorizontalHeaderLabels({tr("Date"), tr("Size")});
    m_list->setAccessibleName(tr("Backups"));
    showAsList(*m_list);
    m_list->horizontalHeader()->setStretchLastSection(true);
    m_changes->setAccessibleName(tr("Changes since this backup"));
    showAsList(*m_changes);
    m_changes->horizontalHeader()->setStretchLastSection(true);
    auto *right = new QWidget;
    auto *rightLayout = new QVBoxLayout(right);
    rightLayout->setContentsMargins(8, 0, 0, 0);
    rightLayout->setSpacing(8);
    rightLayout->addWidget(m_preview);
    rightLayout->addWidget(m_changes, 1);
    rightLayout->addStretch(); // where there are no changes
    auto *halves = new QSplitter;
    halves->addWidget(m_list);
    halves->addWidget(right);
    halves->setStretchFactor(0, 2);
    halves->setStretchFactor(1, 3);
    halves->setChildrenCollapsible(false);
    halves->setSizes({leftWidth, rightWidth});
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_make, QDialogButtonBox::ActionRole);
    buttons->addButton(open, QDialogButtonBox::ActionRole);
    buttons->addButton(m_restore, QDialogButtonBox::AcceptRole);
    m_make->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_make, &QPushButton::clicked, this, &BackupsDialog::backUpNow);
    connect(m_list->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &BackupsDialog::showPreview);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(where);
    layout->addWidget(halves, 1);
    layout->addWidget(m_message);
    layout->addWidget(buttons);
    m_message->hide();
    resize(820, 460);
    refresh();
}

std::filesystem::path BackupsDialog::chosen() const
{
    const ProjectBackup *backup = recordAt(m_backups, m_list->currentRow());
    return backup ? backup->file : std::filesystem::path();
}

void BackupsDialog::refresh()
{
    m_backups = backupsOf(m_project);
    m_list->setRowCount(static_cast<int>(m_backups.size()));
    for (int row = 0; row < m_list->rowCount(); ++row) {
        const ProjectBackup &backup = m_backups[static_cast<std::size_t>(row)];
        auto *date =
            new QTableWidgetItem(backup.isByDate ? shortDate(backup.made)
                                                 : tr("%1, before an update").arg(shortDate(backup.made)));
        date->setToolTip(textOf(backup.file).toHtmlEscaped());
        m_list->setItem(row, 0, date);
        m_list->setItem(row, 1,
                        new QTableWidgetItem(
                            QLocale().formattedDataSize(qint64(backup.bytes), 1, QLocale::DataSizeSIFormat)));
    }
    m_list->resizeColumnToContents(0);
    if (!m_backups.empty())
        m_list->setCurrentCell(0, 0);
    showPreview();
}

void BackupsDialog::backUpNow()
{
    m_make->setEnabled(false);
    m_message->hide();
    m_maker.read<ProjectBackup>([](Project &project) { return backUp(project, backupTime()); },
                                [this](const Result<ProjectBackup> &made) {
                                    m_make->setEnabled(true);
                                    m_message->setVisible(!made);
                                    if (!made)
                                        m_message->setText(errorLine(made.error()));
                                    refresh();
                                });
}

void BackupsDialog::showPreview()
{
    m_restore->setEnabled(false);
    setChanges({});
    const std::filesystem::path backup = chosen();
    if (backup.empty()) {
        m_preview->setText(tr("No backup yet."));
        return;
    }
    m_preview->setText(tr("Reading the backup…"));
    m_previewReader.read<BackupPreview>(
        [backup](Project &project) { return previewBackup(backup, project); },
        [this](const Result<BackupPreview> &preview) { takePreview(preview); });
}

void BackupsDialog::takePreview(const Result<BackupPreview> &preview)
{
    if (!preview) {
        m_preview->setText(errorLine(preview.error()));
        return;
    }
    QStringList lines{tr("%n trial(s) in this backup.", nullptr, static_cast<int>(preview->trialCount))};
    if (!preview->trialsLost.empty())
        lines << tr("Without: %1").arg(namesText(preview->trialsLost));
    if (!preview->trialsBack.empty())
        lines << tr("With, though deleted since: %1").arg(namesText(preview->trialsBack));
    if (preview->videosMissing > 0)
        lines << tr("%n of its video(s) no longer exist.", nullptr, static_cast<int>(preview->videosMissing));
    lines << (preview->changesLost.empty() ? tr("Restoring it discards no changes.")
                                           : tr("Restoring it discards %n change(s) made since:", nullptr,
                                                static_cast<int>(preview->changesLost.size())));
    if (!preview->changesBack.empty())
        lines << tr("It brings back %n change(s).", nullptr, static_cast<int>(preview->changesBack.size()));
    m_preview->setText(lines.join(u'\n'));
    setChanges(preview->changesLost);
    m_restore->setEnabled(!m_readOnly);
}

void BackupsDialog::setChanges(std::vector<ChangeEntry> changes)
{
    QAbstractItemModel *before = m_changes->model();
    m_changes->setVisible(!changes.empty());
    m_changes->setModel(new ChangeModel(std::move(changes), m_changes));
    delete before;
    m_changes->resizeColumnsToContents();
}

} // namespace odo
