// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/run_results.h"

#include "core/workflow/track/track_job.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_message.h"
#include "ui/models/verdict_mark.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/theme.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

/// Time (of the task, or else of the run), top speed, and the most informative others.
std::vector<Metric> shownMetrics(const std::vector<Metric> &all, std::size_t count)
{
    std::vector<Metric> chosen = informativeMetrics(all, count);
    const auto top = std::ranges::find(all, std::string("max_speed"), &Metric::name);
    if (top != all.end() && std::ranges::find(chosen, top->name, &Metric::name) == chosen.end() &&
        !chosen.empty())
        chosen.back() = *top;
    return chosen;
}

} // namespace

RunResultCard::RunResultCard(QWidget *parent)
    : Card(tr("Result"), parent), m_grid(new MetricGrid), m_words(new QLabel),
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
    m_words->setText(tr("The results appear here shortly after the run ends."));
    connect(m_open, &QPushButton::clicked, this, [this] { Q_EMIT openRequested(m_trial); });
}

void RunResultCard::setWorking(const QString &trial)
{
    m_trial = trial;
    setRemark(trial);
    setBadge({});
    m_grid->hide();
    m_open->hide();
    m_words->setText(tr("Analysing…"));
}

void RunResultCard::setLiveResults(const QString &trial, const std::vector<Result> &results)
{
    showMetrics(trial, results);
    setBadge({});
    m_words->setText(tr("From live tracking. The final results follow shortly, from the recording."));
    m_open->hide();
}

void RunResultCard::setFinalResults(const QString &trial, const std::vector<Result> &results,
                                    const TrialVerdict &verdict)
{
    showMetrics(trial, results);
    setBadge(verdictBadge(verdict));
    QStringList words{tr("Final, from every frame of the recording.")};
    m_words->setText((words + verdictReasons(verdict)).join(u'\n'));
    m_open->show();
}

void RunResultCard::showMetrics(const QString &trial, const std::vector<Result> &results)
{
    m_trial = trial;
    setRemark(results.size() == 1 ? trial + QStringLiteral(" · ") + results.front().robot : trial);
    std::vector<NamedMetric> metrics;
    const std::size_t each = results.size() > 1 ? 2 : 5;
    for (const Result &result : results) {
        for (const Metric &metric : shownMetrics(result.metrics, each)) {
            const QString name = metricName(metric.name);
            metrics.push_back(
                {results.size() > 1 ? joinedWords(result.robot, name) : name, metricNumber(metric)});
        }
        if (results.size() == 1)
            metrics.push_back({tr("Spikes flagged"), numberText(double(result.spikes), std::nullopt, {})});
    }
    m_grid->setMetrics(std::move(metrics));
    m_grid->show();
}

void RunResultCard::setFailure(const QString &trial, const QString &words)
{
    m_trial = trial;
    setRemark(trial);
    setBadge({});
    m_grid->hide();
    m_words->setText(words);
    m_open->setVisible(!trial.isEmpty());
}

QString RunResultCard::words() const
{
    return m_words->text();
}

namespace {

constexpr std::ptrdiff_t leastSightings = 10;

bool wasSeen(const LiveRun &run)
{
    return std::ranges::any_of(run.views, [](const ViewTrack &view) {
        return std::ranges::count_if(view.observations, &Observation::found) >= leastSightings;
    });
}

RunResultCard::Result resultOf(const std::string &robot, const Profile &profile)
{
    return {QString::fromStdString(robot), profile.metrics, profile.spikes.size()};
}

} // namespace

RunMeasuring::RunMeasuring(Project &project, QObject *parent) : QObject(parent), m_jobs(project)
{
    connect(&m_jobs, &JobRunner::finished, this,
            [this](const std::shared_ptr<Job> &, const std::optional<Error> &error) { finish(error); });
}

RunMeasuring::~RunMeasuring() = default;

void RunMeasuring::measureLive(const QString &trial, std::vector<LiveRun> runs,
                               const std::optional<TaskRecord> &task)
{
    m_seen = {trial, {}};
    for (const LiveRun &run : runs) {
        if (wasSeen(run))
            m_seen.robots.push_back(run.robot.name);
    }
    const auto results = std::make_shared<std::vector<RunResultCard::Result>>();
    const auto answered = std::make_shared<QMetaObject::Connection>();
    *answered = connect(&m_live, &BackgroundTask::finished, this, [this, trial, results, answered] {
        disconnect(*answered);
        if (!results->empty()) // else the recording may give more
            Q_EMIT measuredLive(trial, *results);
    });
    const bool started =
        m_live.start([runs = std::move(runs), task, results](const JobControl &) -> Result<void> {
            for (const LiveRun &run : runs) {
                if (const auto analysis = analyseRun(run, {}, task))
                    results->push_back(resultOf(run.robot.name, analysis->profile));
            }
            return {};
        });
    if (!started)
        disconnect(*answered);
}

void RunMeasuring::track(const QString &trial)
{
    m_waiting.push_back(m_seen.trial == trial ? m_seen : Waiting{trial, {}});
    goOn();
}

void RunMeasuring::setRecording(bool recording)
{
    m_recording = recording;
    if (m_recording && m_jobs.isRunning()) {
        m_stepsBack = true;
        m_jobs.cancel();
    }
    goOn();
}

void RunMeasuring::goOn()
{
    if (m_recording || m_waiting.empty() || m_jobs.isRunning())
        return;
    TrackSettings settings;
    settings.robots = m_waiting.front().robots;
    m_job = std::make_shared<TrackJob>(m_waiting.front().trial.toStdString(), std::move(settings));
    m_jobs.start(m_job);
}

void RunMeasuring::finish(const std::optional<Error> &error)
{
    const std::shared_ptr<TrackJob> job = std::move(m_job);
    if (std::exchange(m_stepsBack, false) && error && error->code == ErrorCode::Cancelled)
        return goOn(); // it is still the first that waits
    const QString trial = m_waiting.front().trial;
    m_waiting.pop_front();
    if (error) {
        Q_EMIT failed(trial, *error);
    } else {
        std::vector<RunResultCard::Result> results;
        for (const TrackedRobot &robot : job->outcome().robots)
            results.push_back(resultOf(robot.name, robot.analysis.profile));
        Q_EMIT measured(trial, results, job->outcome().verdict, job->outcome().warnings);
    }
    goOn();
}

namespace {

QString asSentence(QString words)
{
    if (!words.isEmpty() && !words.endsWith(u'.'))
        words += u'.';
    if (!words.isEmpty())
        words.front() = words.front().toUpper();
    return words;
}

QString withWarnings(const QString &said, const std::vector<Message> &warnings)
{
    QStringList sentences{said};
    for (const Message &warning : warnings)
        sentences << asSentence(shownWords(warning));
    return sentences.join(u' ');
}

} // namespace

RunResults::RunResults(Project &project, RunResultCard &card, QObject *parent)
    : QObject(parent), m_measuring(new RunMeasuring(project, this)), m_card(card)
{
    connect(m_measuring, &RunMeasuring::measuredLive, this,
            [this](const QString &trial, const auto &results) {
                if (!isShown(trial))
                    return;
                m_card.setLiveResults(trial, results);
                Q_EMIT shown(results);
            });
    connect(m_measuring, &RunMeasuring::measured, this,
            [this](const QString &trial, const auto &results, const TrialVerdict &verdict,
                   const std::vector<Message> &warnings) {
                if (isShown(trial)) {
                    m_card.setFinalResults(trial, results, verdict);
                    Q_EMIT shown(results);
                }
                Q_EMIT changed(withWarnings(tr("%1 is analysed.").arg(trial), warnings), warnings);
            });
    connect(m_measuring, &RunMeasuring::failed, this, [this](const QString &trial, const Error &error) {
        showFailure(trial, tr("Recorded, but not analysed: %1").arg(asSentence(errorLine(error))));
        Q_EMIT failed(error);
    });
}

void RunResults::takeEnded(const QString &trial, std::vector<LiveRun> runs,
                           const std::optional<TaskRecord> &task)
{
    m_card.setWorking(trial);
    m_measuring->measureLive(trial, std::move(runs), task);
}

void RunResults::takeRecorded(const QString &trial, const std::vector<Message> &warnings)
{
    m_measuring->track(trial);
    Q_EMIT changed(withWarnings(tr("%1 is recorded.").arg(trial), warnings), warnings);
}

void RunResults::takeGivenUp(const QString &trial, const Error &error)
{
    setRecording(false);
    showFailure(trial, tr("Recording failed: %1").arg(asSentence(errorLine(error))));
    Q_EMIT failed(error);
}

void RunResults::showFailure(const QString &trial, const QString &words)
{
    if (isShown(trial))
        m_card.setFailure(trial, words);
}

} // namespace odo
