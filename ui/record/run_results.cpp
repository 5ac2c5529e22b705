// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/run_results.h"

#include "ui/models/error_words.h"

namespace odo {
namespace {

QString asSentence(QString words)
{
    if (!words.isEmpty() && !words.endsWith(u'.'))
        words += u'.';
    if (!words.isEmpty())
        words.front() = words.front().toUpper();
    return words;
}

QString withWarnings(const QString &said, const QStringList &warnings)
{
    QStringList sentences{said};
    for (const QString &warning : warnings)
        sentences << asSentence(warning);
    return sentences.join(u' ');
}

} // namespace

RunResults::RunResults(Project &project, RunResultCard &card, QObject *parent)
    : QObject(parent), m_measuring(new RunMeasuring(project, this)), m_card(card)
{
    connect(m_measuring, &RunMeasuring::measuredLive, this,
            [this](const QString &trial, const auto &results) {
                show(trial, results, RunResultCard::From::Live);
            });
    connect(m_measuring, &RunMeasuring::measured, this,
            [this](const QString &trial, const auto &results, const QStringList &warnings) {
                show(trial, results, RunResultCard::From::Recording);
                Q_EMIT changed(withWarnings(tr("%1 is measured.").arg(trial), warnings));
            });
    connect(m_measuring, &RunMeasuring::failed, this, [this](const QString &trial, const Error &error) {
        showFailure(trial,
                    tr("It is recorded, but could not be measured: %1").arg(asSentence(errorLine(error))));
        Q_EMIT failed(error);
    });
}

void RunResults::takeEnded(const QString &trial, std::vector<LiveRun> runs,
                           const std::optional<TaskRecord> &task)
{
    m_card.setWorking(trial);
    m_measuring->measureLive(trial, std::move(runs), task);
}

void RunResults::takeRecorded(const QString &trial, const QStringList &warnings)
{
    m_measuring->track(trial);
    Q_EMIT changed(withWarnings(tr("%1 is recorded.").arg(trial), warnings));
}

void RunResults::takeGivenUp(const QString &trial, const Error &error)
{
    setRecording(false);
    showFailure(trial, tr("It could not be recorded: %1").arg(asSentence(errorLine(error))));
    Q_EMIT failed(error);
}

/// Another run may have ended since; then the card is about that one.
void RunResults::show(const QString &trial, const std::vector<RunResultCard::Result> &results,
                      RunResultCard::From from)
{
    if (m_card.trial() == trial)
        m_card.setResults(trial, results, from);
}

void RunResults::showFailure(const QString &trial, const QString &words)
{
    if (m_card.trial() == trial)
        m_card.setFailure(trial, words);
}

} // namespace odo
