// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/transfer_actions.h"

#include "core/project/project.h"
#include "core/workflow/media_upkeep.h"
#include "core/workflow/project_copy.h"
#include "ui/main_window/workspace.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

namespace odo {

TransferActions::TransferActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window),
      m_pack(new QAction(tr("&Pack into one file…"), this)),
      m_unpack(new QAction(tr("&Unpack a packed project…"), this)),
      m_relink(new QAction(tr("Find &lost videos…"), this)),
      m_strays(new QAction(tr("Find &stray files…"), this))
{
    nameCommands({{m_pack, "pack"}, {m_unpack, "unpack"}, {m_relink, "relink"}, {m_strays, "strays"}});
    m_pack->setEnabled(false);
    m_relink->setEnabled(false);
    m_strays->setEnabled(false);
    connect(m_pack, &QAction::triggered, this, &TransferActions::askPack);
    connect(m_unpack, &QAction::triggered, this, &TransferActions::askArchive);
    connect(m_relink, &QAction::triggered, this, &TransferActions::askLostVideos);
    connect(m_strays, &QAction::triggered, this, &TransferActions::findStrays);
    connect(&m_workspace, &Workspace::opened, this, [this] {
        m_pack->setEnabled(true);
        m_relink->setEnabled(!m_workspace.isReadOnly());
        m_strays->setEnabled(!m_workspace.isReadOnly());
    });
}

void TransferActions::fillMenu(QMenu &menu)
{
    menu.addAction(m_pack);
    menu.addAction(m_unpack);
    menu.addAction(m_relink);
    menu.addAction(m_strays);
}

void TransferActions::showFailure(const Result<void> &result)
{
    if (!result)
        Q_EMIT failed(result.error());
}

void TransferActions::askPack()
{
    const QFileInfo own(textOf(m_workspace.project()->file()));
    const QString suffix = QLatin1String(archiveSuffix);
    const auto chosen = askOutput(&m_window, tr("Pack the project with its videos"),
                                  own.dir().filePath(own.completeBaseName() + suffix),
                                  {{tr("Packed projects (*%1)").arg(suffix), suffix.mid(1), FileKind::Zip}});
    if (chosen)
        pack(*chosen);
}

void TransferActions::pack(const ChosenOutput &archive)
{
    const auto job = std::make_shared<PackJob>(archive.target);
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.packing", "Packing the project"), [this, job, archive = archive.file] {
            QStringList sentences{tr("Project packed into %1. To use it on another computer, choose \"Unpack "
                                     "a packed project\" there.")
                                      .arg(QDir::toNativeSeparators(archive))};
            for (const Message &warning : job->warnings())
                sentences << tr("Note: %1.").arg(shownWords(warning));
            Q_EMIT done({sentences.join(u' '), job->warnings(), archive});
        }));
}

void TransferActions::askArchive()
{
    const QString archive = QFileDialog::getOpenFileName(
        &m_window, tr("Unpack a packed project"), QDir::homePath(),
        tr("Packed projects (*%1);;All files (*)").arg(QLatin1String(archiveSuffix)));
    if (!archive.isEmpty())
        askUnpack(pathOf(archive));
}

void TransferActions::askUnpack(const std::filesystem::path &archive)
{
    const QString parent = QFileDialog::getExistingDirectory(
        &m_window, tr("Choose a folder for the unpacked project"), QDir::homePath());
    if (parent.isEmpty())
        return;
    const std::filesystem::path folder =
        pathOf(QDir(parent).filePath(QFileInfo(textOf(archive)).completeBaseName()));
    const auto unpack = [archive, folder](const JobControl &control) {
        return unpackArchive(archive, folder, control);
    };
    showFailure(m_workspace.makeAndOpen(unpack, ODO_TEXT("ui.unpacking", "Unpacking the project"),
                                        [this] { Q_EMIT unpacked(m_workspace.project()->file()); }));
}

void TransferActions::askLostVideos()
{
    const QString folder = QFileDialog::getExistingDirectory(
        &m_window, tr("Choose the folder to search for the lost videos (with subfolders)"), QDir::homePath());
    if (folder.isEmpty())
        return;
    const auto job = std::make_shared<RelinkJob>(pathOf(folder));
    showFailure(
        m_workspace.start(job, ODO_TEXT("ui.looking_for_lost", "Searching for lost videos"), [this, job] {
            Q_EMIT done(tr("Found %1 of %2 lost videos by their content.")
                            .arg(job->foundCount())
                            .arg(job->lostCount()));
        }));
}

void TransferActions::findStrays()
{
    const auto job = std::make_shared<FindStraysJob>();
    showFailure(
        m_workspace.start(job, ODO_TEXT("ui.looking_for_strays", "Searching for stray files"), [this, job] {
            if (job->strays().empty() && job->others().empty())
                Q_EMIT done(
                    tr("Every file in the media folder belongs to a trial, a lens calibration or a floor "
                       "registration."));
            else
                askStrays(*job);
        }));
}

void TransferActions::askStrays(const FindStraysJob &found)
{
    auto *box = new QMessageBox(&m_window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName(QStringLiteral("strays"));
    box->setWindowTitle(tr("Stray files"));
    box->setTextFormat(Qt::PlainText);
    box->setText(
        tr("%n file(s) in the media folder belong to no trial, lens calibration or floor registration.",
           nullptr, static_cast<int>(found.strays().size())));
    QString words = tr("You can add videos as trials. Removed files are gone for good.");
    if (!found.others().empty())
        words += u' ' + tr("%n other file(s), listed last, stay: missing recordings, projects, and files "
                           "that are neither videos nor images.",
                           nullptr, static_cast<int>(found.others().size()));
    box->setInformativeText(words);
    QStringList names;
    for (const auto *files : {&found.strays(), &found.others()})
        for (const std::filesystem::path &file : *files)
            names << QDir::toNativeSeparators(textOf(file));
    box->setDetailedText(names.join(u'\n'));
    QPushButton *add = box->addButton(tr("&Add videos as trials"), QMessageBox::AcceptRole);
    add->setEnabled(!found.videos().empty());
    QPushButton *remove = box->addButton(tr("&Remove files"), QMessageBox::DestructiveRole);
    remove->setEnabled(!found.strays().empty());
    box->setDefaultButton(box->addButton(QMessageBox::Cancel));
    connect(add, &QPushButton::clicked, this, [this, videos = found.videos()] { adopt(videos); });
    connect(remove, &QPushButton::clicked, this, [this, files = found.strays()] { removeStrays(files); });
    box->open();
}

void TransferActions::adopt(const std::vector<std::filesystem::path> &videos)
{
    const auto job = std::make_shared<AdoptStraysJob>(videos);
    showFailure(
        m_workspace.start(job, ODO_TEXT("ui.adding_strays", "Adding stray videos as trials"), [this, job] {
            if (!job->trials().empty() || job->failures().empty())
                Q_EMIT done(tr("%n trial(s) added. Their names begin with \"recovered\".", nullptr,
                               static_cast<int>(job->trials().size())));
            for (const Error &failure : job->failures())
                Q_EMIT failed(failure);
        }));
}

void TransferActions::removeStrays(const std::vector<std::filesystem::path> &files)
{
    const auto job = std::make_shared<RemoveStraysJob>(files);
    showFailure(m_workspace.start(job, ODO_TEXT("ui.removing_strays", "Removing stray files"), [this, job] {
        Q_EMIT done(tr("%n stray file(s) removed.", nullptr, static_cast<int>(job->removed().size())));
    }));
}

} // namespace odo
