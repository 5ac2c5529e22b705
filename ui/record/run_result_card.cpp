// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/run_result_card.h"

#include "ui/models/core_words.h"
#include "ui/models/figure_text.h"
#include "ui/models/metric_choice.h"
#include "ui/views/figure_grid.h"
#include "ui/views/theme_icon.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {
namespace {

/// Time (of the task, or else of the run), top speed, and what else tells most.
std::vector<Metric> shownMetrics(const std::vector<Metric> &all, std::size_t count)
{
    std::vector<Metric> chosen = tellingMetrics(all, count);
    const auto top = std::ranges::find(all, std::string("max_speed"), &Metric::name);
    if (top != all.end() && std::ranges::find(chosen, top->name, &Metric::name) == chosen.end() &&
        !chosen.empty())
        chosen.back() = *top;
    return chosen;
}

} // namespace

RunResultCard::RunResultCard(QWidget *parent)
    : Card(tr("Result"), parent), m_grid(new FigureGrid), m_words(new QLabel),
      m_open(new QPushButton(tr("&Open in Review")))
{
    auto *content = new QWidget;
    content->setObjectName(QStringLiteral("cardBody"));
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 0, 8);
    layout->setSpacing(4);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    m_words->setContentsMargins(12, 8, 12, 0);
    m_open->setIcon(themeIcon(QStringLiteral("review")));
    layout->addWidget(m_grid);
    layout->addWidget(m_words);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(12, 2, 12, 0);
    row->addWidget(m_open);
    row->addStretch(1);
    layout->addLayout(row);
    layout->addStretch(1);
    setContent(content);
    m_open->hide();
    m_grid->hide();
    m_words->setText(tr("The figures of a run stand here a moment after it has ended."));
    connect(m_open, &QPushButton::clicked, this, [this] { Q_EMIT openRequested(m_trial); });
}

void RunResultCard::setWorking(const QString &trial)
{
    m_trial = trial;
    setRemark(trial);
    m_grid->hide();
    m_open->hide();
    m_words->setText(tr("Measuring…"));
}

void RunResultCard::setResults(const QString &trial, const std::vector<Result> &results, From from)
{
    m_trial = trial;
    setRemark(results.size() == 1 ? trial + QStringLiteral(" · ") + results.front().robot : trial);
    std::vector<NamedFigure> figures;
    const std::size_t each = results.size() > 1 ? 2 : 5;
    for (const Result &result : results) {
        for (const Metric &metric : shownMetrics(result.metrics, each)) {
            const QString name = metricName(metric.name);
            figures.push_back({results.size() > 1 ? joinedWords(result.robot, name) : name, metricFigure(metric)});
        }
        if (results.size() == 1)
            figures.push_back({tr("Spikes flagged"), figureText(double(result.spikes), std::nullopt, {})});
    }
    m_grid->setFigures(std::move(figures));
    m_grid->show();
    m_words->setText(from == From::Live
                         ? tr("From live tracking. The final figures come from the recording, in a moment.")
                         : tr("Final, from every picture of the recording."));
    m_open->setVisible(from == From::Recording);
}

void RunResultCard::setFailure(const QString &trial, const QString &words)
{
    m_trial = trial;
    setRemark(trial);
    m_grid->hide();
    m_words->setText(words);
    m_open->setVisible(!trial.isEmpty());
}

QString RunResultCard::words() const
{
    return m_words->text();
}

} // namespace odo
