// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/transfer_actions.h"

#include "core/project/project.h"
#include "core/workflow/pack_job.h"
#include "core/workflow/relink_job.h"
#include "ui/main_window/workspace.h"
#include "ui/models/core_words.h"
#include "ui/views/command_names.h"
#include "ui/views/output_question.h"
#include "ui/views/path_field.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

namespace odo {

TransferActions::TransferActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window),
      m_pack(new QAction(tr("&Pack into one file…"), this)),
      m_unpack(new QAction(tr("&Unpack a packed project…"), this)),
      m_relink(new QAction(tr("Find &lost videos…"), this))
{
    nameCommands({{m_pack, "pack"}, {m_unpack, "unpack"}, {m_relink, "relink"}});
    m_pack->setEnabled(false);
    m_relink->setEnabled(false);
    connect(m_pack, &QAction::triggered, this, &TransferActions::askPack);
    connect(m_unpack, &QAction::triggered, this, &TransferActions::askArchive);
    connect(m_relink, &QAction::triggered, this, &TransferActions::askLostVideos);
    connect(&m_workspace, &Workspace::opened, this, [this] {
        m_pack->setEnabled(true);
        m_relink->setEnabled(!m_workspace.isReadOnly());
    });
}

void TransferActions::fillMenu(QMenu &menu)
{
    menu.addAction(m_pack);
    menu.addAction(m_unpack);
    menu.addAction(m_relink);
}

void TransferActions::tellFailure(const Result<void> &result)
{
    if (!result)
        Q_EMIT failed(result.error());
}

void TransferActions::askPack()
{
    const QFileInfo own(textOf(m_workspace.project()->file()));
    const QString suffix = QLatin1String(archiveSuffix);
    const auto chosen = askOutput(&m_window, tr("Pack the project with its videos"), own.dir().filePath(own.completeBaseName() + suffix),
                                  {{tr("Packed projects (*%1)").arg(suffix), suffix.mid(1), FileKind::Zip}});
    if (chosen)
        pack(*chosen);
}

void TransferActions::pack(const ChosenOutput &archive)
{
    const auto job = std::make_shared<PackJob>(archive.target);
    tellFailure(m_workspace.start(job, tr("Packing the project"), [this, job, archive = archive.file] {
        QStringList sentences{
            tr("The project is packed into %1. Elsewhere it is unpacked by \"Unpack a packed project\".")
                .arg(QDir::toNativeSeparators(archive))};
        for (const std::string &warning : job->warnings())
            sentences << tr("Note: %1.").arg(shownWords(warning));
        Q_EMIT done(sentences.join(u' '));
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
        &m_window, tr("Where shall the project be unpacked?"), QDir::homePath());
    if (parent.isEmpty())
        return;
    const std::filesystem::path folder =
        pathOf(QDir(parent).filePath(QFileInfo(textOf(archive)).completeBaseName()));
    const auto unpack = [archive, folder](const JobControl &control) {
        return unpackArchive(archive, folder, control);
    };
    tellFailure(m_workspace.makeAndOpen(unpack, tr("Unpacking the project"),
                                        [this] { Q_EMIT unpacked(m_workspace.project()->file()); }));
}

void TransferActions::askLostVideos()
{
    const QString folder = QFileDialog::getExistingDirectory(
        &m_window, tr("In which folder, or below, may the lost videos lie?"), QDir::homePath());
    if (folder.isEmpty())
        return;
    const auto job = std::make_shared<RelinkJob>(pathOf(folder));
    tellFailure(m_workspace.start(job, tr("Looking for lost videos"), [this, job] {
        Q_EMIT done(tr("%1 of %2 lost videos were found, by their content.")
                        .arg(job->foundCount())
                        .arg(job->lostCount()));
    }));
}

} // namespace odo
