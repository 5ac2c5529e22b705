// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/reprocess_dialog.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/revisions.h"
#include "ui/models/core_words.h"
#include "ui/models/error_words.h"
#include "ui/models/figure_text.h"
#include "ui/views/plain_button.h"
#include "ui/views/table_list.h"
#include "ui/views/words_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {
namespace {

struct ReprocessColumn
{
    enum { Robot, Metric, Before, After, Change, Count };
};

QString figure(const std::optional<double> &value, const MetricChange &metric)
{
    return value ? metricFigure({metric.name, metric.unit, *value, metric.sigma}).text() : QStringLiteral("–");
}

/// With its sign; no more digits than the figures have, and a word where none of them changes.
QString difference(const MetricChange &metric)
{
    if (!metric.before || !metric.after)
        return {};
    const double change = *metric.after - *metric.before;
    FigureText text = metricFigure({metric.name, metric.unit, std::abs(change), metric.sigma});
    text.sigma.clear();
    static const QRegularExpression anyDigit(QStringLiteral("[1-9]"));
    if (!text.value.contains(anyDigit))
        return ReprocessDialog::tr("none");
    return (change < 0 ? QStringLiteral("−") : QStringLiteral("+")) + text.text();
}

} // namespace

ReprocessDialog::ReprocessDialog(Project &project, QWidget *parent)
    : QDialog(parent), m_project(project), m_trial(new QComboBox),
      m_table(new QTableWidget(0, ReprocessColumn::Count)), m_words(new QLabel),
      m_begin(plainButton(tr("&Measure again"))), m_keep(plainButton(tr("&Keep"))), m_runner(project)
{
    setWindowTitle(tr("Measure trials again"));
    m_table->setHorizontalHeaderLabels({tr("Robot"), tr("Figure"), tr("Before"), tr("After"), tr("Change")});
    m_table->setAccessibleName(tr("What changes"));
    showAsList(*m_table);
    m_table->horizontalHeader()->setStretchLastSection(true);
    showAsWords(*m_words);
    m_words->setAccessibleName(tr("What changes, in words"));
    auto *intro = new QLabel(tr("What was seen in the videos stays as it is; where it lies on the floor is computed with the registrations in "
                                "force now. Look at what changes, then keep it or not: the older analysis stays in the project too."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Trial"), m_trial);
    auto *close = plainButton(tr("Close"));
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_begin);
    buttons->addStretch(1);
    buttons->addWidget(m_keep);
    buttons->addWidget(close);
    m_begin->setDefault(true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(intro);
    layout->addLayout(form);
    layout->addWidget(m_words);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
    resize(760, 560);
    fillTrials();
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_begin, &QPushButton::clicked, this, &ReprocessDialog::begin);
    connect(m_keep, &QPushButton::clicked, this, &ReprocessDialog::keep);
    connect(m_trial, &QComboBox::currentIndexChanged, this, &ReprocessDialog::forget);
    connect(&m_runner, &JobRunner::finished, this, &ReprocessDialog::finish);
    forget();
}

ReprocessDialog::~ReprocessDialog() = default;

void ReprocessDialog::fillTrials()
{
    const std::vector<std::string> outdated = outdatedTrials(m_project).value_or(std::vector<std::string>());
    const QString current = m_trial->currentData().toString();
    const QSignalBlocker quiet(m_trial);
    m_trial->clear();
    for (const TrialName &trial : m_project.trials().names().value_or(std::vector<TrialName>())) {
        const QString name = QString::fromStdString(trial.name);
        const bool isOld = std::ranges::find(outdated, trial.name) != outdated.end();
        // Those that a newer registration concerns come first.
        m_trial->insertItem(isOld ? 0 : m_trial->count(), isOld ? tr("%1 (measured with an older registration)").arg(name) : name, name);
    }
    m_trial->setCurrentIndex(std::max(0, m_trial->findData(current)));
}

void ReprocessDialog::forget()
{
    m_done.reset();
    m_table->setRowCount(0);
    m_words->clear();
    m_keep->setEnabled(false);
    m_begin->setEnabled(!m_runner.isRunning() && m_trial->count() > 0);
}

void ReprocessDialog::begin()
{
    forget();
    m_begin->setEnabled(false);
    m_trial->setEnabled(false);
    m_words->setText(tr("Measuring…"));
    m_runner.start(std::make_shared<ReprocessJob>(m_trial->currentData().toString().toStdString()));
}

void ReprocessDialog::finish(const std::shared_ptr<Job> &job, const std::optional<Error> &error)
{
    forget();
    m_trial->setEnabled(true);
    m_begin->setEnabled(true);
    if (error)
        return m_words->setText(errorLine(*error));
    m_done = std::static_pointer_cast<ReprocessJob>(job);
    showChanges();
    m_keep->setEnabled(true);
}

void ReprocessDialog::showChanges()
{
    QStringList sentences;
    for (const ReprocessedRobot &robot : m_done->robots()) {
        const QString name = QString::fromStdString(robot.name);
        sentences << tr("%1: %2").arg(name, shownWords(robot.change.words));
        for (const MetricChange &metric : robot.change.metrics)
            addMetric(name, metric);
    }
    m_words->setText(sentences.join(QLatin1Char('\n')));
    m_table->resizeColumnsToContents();
}

void ReprocessDialog::addMetric(const QString &robot, const MetricChange &metric)
{
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    const QString texts[] = {robot, metricName(metric.name), figure(metric.before, metric), figure(metric.after, metric), difference(metric)};
    for (int column = 0; column < ReprocessColumn::Count; ++column)
        m_table->setItem(row, column, new QTableWidgetItem(texts[column]));
}

void ReprocessDialog::keep()
{
    const auto kept = m_done->keep(m_project);
    const QString trial = QString::fromStdString(m_done->trial());
    m_hasKept = m_hasKept || kept.has_value();
    fillTrials();
    m_done.reset();
    m_keep->setEnabled(false);
    m_words->setText(kept ? tr("Kept: the new analysis of %1 is the current one.").arg(trial) : errorLine(kept.error()));
}

void ReprocessDialog::done(int result)
{
    m_runner.cancel();
    QDialog::done(result);
}

} // namespace odo
