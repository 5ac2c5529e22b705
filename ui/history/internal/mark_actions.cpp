// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/mark_actions.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/media_upkeep.h"
#include "core/workflow/trials/trial_changes.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

namespace odo {

namespace {

const MessageText &starWords(bool starred)
{
    return starred ? ODO_TEXT("ui.star_trial", "star %1")
                   : ODO_TEXT("ui.unstar_trial", "remove the star from %1");
}

} // namespace

MarkActions::MarkActions(Project &project, QWidget &window)
    : QObject(&window), m_project(project), m_window(window),
      m_star(new QAction(themeIcon(QStringLiteral("star")), tr("&Star"), this)),
      m_archive(new QAction(themeIcon(QStringLiteral("archive")), tr("&Archive"), this)),
      m_bin(new QAction(themeIcon(QStringLiteral("bin")), tr("&Delete"), this)),
      m_empty(new QAction(tr("&Empty the bin…"), this))
{
    nameCommands({{m_star, "starTrials"},
                  {m_archive, "archiveTrials"},
                  {m_bin, "deleteTrials"},
                  {m_empty, "emptyBin"}});
    m_star->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_D));
    m_bin->setShortcut(QKeySequence(Qt::Key_Delete));
    for (QAction *action : {m_star, m_archive, m_bin, m_empty})
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(m_star, &QAction::triggered, this, [this] {
        const bool to = !std::ranges::all_of(m_trials, &TrialRecord::starred);
        change(
            starWords(to),
            to ? ODO_TEXT("ui.star_trials", "star %1 trials")
               : ODO_TEXT("ui.unstar_trials", "remove the star from %1 trials"),
            [](Project &changed, const TrialRecord &trial, bool starred) {
                return changed.trials().setStarred(trial.id, starred);
            },
            to);
    });
    connect(m_archive, &QAction::triggered, this, [this] {
        const bool to = !std::ranges::all_of(
            m_trials, [](const TrialRecord &trial) { return trial.archived.has_value(); });
        change(
            to ? ODO_TEXT("ui.archive_trial", "archive %1")
               : ODO_TEXT("ui.unarchive_trial", "restore %1 from the archive"),
            to ? ODO_TEXT("ui.archive_trials", "archive %1 trials")
               : ODO_TEXT("ui.unarchive_trials", "restore %1 trials from the archive"),
            [](Project &changed, const TrialRecord &trial, bool archived) {
                return changed.trials().setArchived(trial.id, archived);
            },
            to);
    });
    connect(m_bin, &QAction::triggered, this, &MarkActions::moveToBinOrBack);
    connect(m_empty, &QAction::triggered, this, &MarkActions::askToEmpty);
    updateActions();
}

void MarkActions::setTrials(std::vector<TrialRecord> trials)
{
    m_trials = std::move(trials);
    updateActions();
}

void MarkActions::setReadOnly(bool readOnly)
{
    m_readOnly = readOnly;
    updateActions();
}

void MarkActions::setBinShown(bool shown)
{
    m_binShown = shown;
    updateActions();
}

void MarkActions::updateActions()
{
    const bool some = !m_trials.empty() && !m_readOnly;
    const bool starred = some && std::ranges::all_of(m_trials, &TrialRecord::starred);
    const bool archived = some && std::ranges::all_of(m_trials, [](const TrialRecord &trial) {
                              return trial.archived.has_value();
                          });
    m_star->setEnabled(some);
    m_star->setText(starred ? tr("Remove &star") : tr("&Star"));
    m_archive->setEnabled(some && !m_binShown);
    m_archive->setText(archived ? tr("Restore from &archive") : tr("&Archive"));
    m_bin->setEnabled(some);
    m_bin->setText(m_binShown ? tr("Rest&ore") : tr("&Delete"));
    m_bin->setToolTip(m_binShown ? tr("Restore the selected trials from the bin (Del)")
                                 : tr("Move the selected trials to the bin (Del); you can restore them"));
    m_empty->setEnabled(m_binShown && !m_readOnly);
    m_empty->setVisible(m_binShown);
}

void MarkActions::change(const MessageText &words, const MessageText &wordsOfMany, Mark mark, bool to)
{
    if (m_trials.empty())
        return;
    const Message told =
        m_trials.size() == 1 ? words(Named::trial(m_trials.front().name)) : wordsOfMany(m_trials.size());
    report(m_project.change(told, [&]() -> Result<void> {
        for (const TrialRecord &trial : m_trials)
            ODO_TRY(mark(m_project, trial, to));
        return {};
    }));
}

void MarkActions::moveToBinOrBack()
{
    if (!m_trials.empty())
        report(setInBin(m_project, m_trials, !m_binShown));
}

void MarkActions::report(const Result<void> &done)
{
    if (!done) {
        Q_EMIT failed(done.error());
        return;
    }
    QList<qint64> ids; // the signal changes what is selected
    for (const TrialRecord &trial : m_trials)
        ids << trial.id;
    Q_EMIT marked(ids);
}

void MarkActions::setStarred(RecordId trial, bool starred)
{
    const Result<TrialRecord> record = m_project.trials().get(trial);
    if (!record) {
        Q_EMIT failed(record.error());
        return;
    }
    const Result<void> done = m_project.change(starWords(starred)(Named::trial(record->name)),
                                               [&] { return m_project.trials().setStarred(trial, starred); });
    if (done)
        Q_EMIT marked({qint64(trial)});
    else
        Q_EMIT failed(done.error());
}

void MarkActions::edit(RecordId trial, const TrialEdit &edit)
{
    const Result<TrialRecord> done = editTrial(m_project, trial, edit);
    if (done)
        Q_EMIT marked({qint64(trial)});
    else
        Q_EMIT failed(done.error());
}

void MarkActions::askToEmpty()
{
    const Result<BinContent> content = binContent(m_project);
    if (!content || content->trials.empty()) {
        if (!content)
            Q_EMIT failed(content.error());
        return;
    }
    QMessageBox question(QMessageBox::Warning, tr("Empty the bin"),
                         tr("Remove %n trial(s) for good?", "", static_cast<int>(content->trials.size())),
                         QMessageBox::Cancel, &m_window);
    question.setInformativeText(
        tr("This removes their videos (%1), measurements and results from the disk. You cannot undo it.")
            .arg(QLocale().formattedDataSize(content->bytes)));
    QPushButton *remove = question.addButton(tr("&Remove for good"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    if (question.clickedButton() != remove)
        return;
    Q_EMIT emptyBinRequested(*content);
}

} // namespace odo
