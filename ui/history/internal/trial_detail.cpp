// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/internal/trial_detail.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/fact_list.h"

#include <QDateTime>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <chrono>

namespace odo {
namespace {

constexpr std::chrono::milliseconds saveAfter{500};

QString dateText(Instant instant)
{
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count()),
                              QLocale::ShortFormat);
}

QList<Fact> factsOf(const TrialRecord &trial, const std::vector<AnalysisRecord> &analyses,
                    const std::vector<TrialScore> &scores)
{
    QList<Fact> facts;
    const auto add = [&facts](const QString &name, const QString &value) {
        if (!value.isEmpty())
            facts.append({name, value, {}});
    };
    add(TrialDetail::tr("Team"), shownTeam(trial));
    add(TrialDetail::tr("Class"), QString::fromStdString(trial.className));
    add(TrialDetail::tr("Task"), QString::fromStdString(trial.task));
    add(TrialDetail::tr("Date"), dateText(trial.date));
    add(TrialDetail::tr("Views"), trial.viewCount > 0 || analyses.empty()
                                      ? QLocale().toString(trial.viewCount)
                                      : TrialDetail::tr("none: the track was imported"));
    for (const AnalysisRecord &analysis : analyses) {
        if (analyses.size() > 1)
            add(TrialDetail::tr("Robot"), QString::fromStdString(analysis.robotName));
        for (const Metric &metric : analysis.profile.metrics)
            facts.append({metricName(metric.name),
                          metricNumber(metric).text(),
                          {},
                          explainMetric(metric, analysisInputs(trial, analysis))});
    }
    for (const TrialScore &run : scores) {
        if (run.trial != trial.id)
            continue;
        if (run.score)
            facts.append({TrialDetail::tr("Score"), scoreText(*run.score), {}, explainScore(*run.score)});
        else
            add(TrialDetail::tr("Score"),
                TrialDetail::tr(
                    "none: analysed with a different course than its task has now. Reanalyse the trial"));
    }
    if (analyses.empty())
        facts.append({TrialDetail::tr("Result"), TrialDetail::tr("none yet: open it and choose Track"), {}});
    return facts;
}

} // namespace

TrialDetail::TrialDetail(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_facts(new FactList), m_notes(new QPlainTextEdit),
      m_open(new QPushButton(tr("Open in Review"))), m_saveTimer(new QTimer(this))
{
    auto *scroll = scrolled(m_facts, tr("Facts of the trial"));

    m_notes->setAccessibleName(tr("Notes of the trial"));
    m_notes->setPlaceholderText(tr("What did you change on the robot? What do you want to remember?"));
    m_notes->setTabChangesFocus(true);
    m_notes->setFixedHeight(110);
    m_open->setProperty("primary", true);
    auto *notesTitle = new QLabel(tr("&Notes"));
    notesTitle->setBuddy(m_notes);
    auto *footer = new QWidget;
    auto *footerLayout = new QVBoxLayout(footer);
    footerLayout->setContentsMargins(10, 6, 10, 10);
    footerLayout->addWidget(notesTitle);
    footerLayout->addWidget(m_notes);
    footerLayout->addWidget(m_open);

    auto *content = new QWidget;
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->addWidget(scroll, 1);
    contentLayout->addWidget(footer);
    m_card = new Card(tr("Trial"), this);
    m_card->setContent(content);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_card);
    setMinimumWidth(280);

    m_saveTimer->setSingleShot(true);
    m_saveTimer->setInterval(saveAfter);
    connect(m_saveTimer, &QTimer::timeout, this, &TrialDetail::saveNotes);
    connect(m_notes, &QPlainTextEdit::textChanged, m_saveTimer, qOverload<>(&QTimer::start));
    connect(m_open, &QPushButton::clicked, this, [this] { Q_EMIT openRequested(m_name); });
    showNone(true);
}

TrialDetail::~TrialDetail()
{
    const QSignalBlocker quiet(this); // who listens is going away as well
    saveNotes();
}

void TrialDetail::showTrial(const TrialRecord &trial)
{
    if (trial.id != m_trial)
        saveNotes();
    const QString notes = QString::fromStdString(trial.notes);
    const bool sameTrial = m_trial == trial.id;
    m_trial = trial.id;
    m_name = QString::fromStdString(trial.name);
    m_card->setTitle(m_name);
    const Result<std::vector<AnalysisRecord>> analyses = m_project.analyses().currentMetrics(trial.id);
    const Result<std::vector<TrialScore>> scores = trialScores(m_project, trial.date, trial.date);
    if (!analyses || !scores)
        Q_EMIT failed(analyses ? scores.error() : analyses.error());
    m_facts->setFacts(factsOf(trial, analyses.value_or(std::vector<AnalysisRecord>()),
                              scores.value_or(std::vector<TrialScore>())));
    if (!sameTrial || notes != m_savedNotes) {
        m_savedNotes = notes;
        m_notes->setPlainText(notes);
        m_saveTimer->stop();
    }
    m_notes->setEnabled(true);
    m_open->setEnabled(true);
}

void TrialDetail::showNone(bool noTrials)
{
    saveNotes();
    m_trial = 0;
    m_name.clear();
    m_card->setTitle(noTrials ? tr("No trials yet") : tr("No trial selected"));
    m_facts->setFacts({});
    m_notes->clear();
    m_saveTimer->stop();
    m_notes->setEnabled(false);
    m_open->setEnabled(false);
}

void TrialDetail::saveNotes()
{
    m_saveTimer->stop();
    const QString notes = m_notes->toPlainText();
    if (m_trial == 0 || notes == m_savedNotes)
        return;
    const Result<void> saved =
        m_project.change(ODO_TEXT("ui.write_notes", "write notes of %1")(Named::trial(m_name.toStdString())),
                         [&] { return m_project.trials().setNotes(m_trial, notes.toStdString()); });
    if (!saved) {
        Q_EMIT failed(saved.error());
        return;
    }
    m_savedNotes = notes;
    Q_EMIT notesChanged(m_name);
}

} // namespace odo
