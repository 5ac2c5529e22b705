// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/school/hub_runs_panel.h"

#include "ui/models/shown_message.h"
#include "ui/school/internal/hub_runs_model.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"
#include "ui/views/widgets/theme.h"

#include <QComboBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <utility>

namespace odo {

namespace {

constexpr int pageSize = 250, benchLetters = 12;
constexpr qsizetype shortestSearch = 3; ///< letters, of which the hub has an index
constexpr std::chrono::milliseconds typingTime{250};

} // namespace

/// What a task leaves for this thread.
struct HubRunsPanel::Answer
{
    bool isFirst = true;
    std::shared_ptr<HubResults> results;
    std::vector<HubRun> runs;
    std::vector<std::string> benches;
};

HubRunsPanel::HubRunsPanel(QWidget *parent)
    : QWidget(parent), m_model(new HubRunsModel(this)), m_card(new Card(tr("Trials of all benches"), this)),
      m_search(new QLineEdit), m_bench(new QComboBox), m_problem(new QLabel), m_table(new QTableView),
      m_typing(new QTimer(this)), m_task(std::make_unique<BackgroundTask>())
{
    m_search->setPlaceholderText(tr("Search trials and teams…"));
    m_search->setAccessibleName(tr("Search the hub"));
    m_search->setToolTip(tr("Three letters or more"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(240);
    m_search->addAction(themeIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("Runs at the hub"));
    showAsList(*m_table);
    m_table->horizontalHeader()->setResizeContentsPrecision(100);
    m_table->viewport()->installEventFilter(this);
    m_bench->setAccessibleName(tr("Bench"));
    m_bench->addItem(tr("All benches"));
    m_bench->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_bench->setMinimumContentsLength(benchLetters);
    m_bench->hide();
    showAsWords(*m_problem);
    m_problem->setContentsMargins(12, 10, 12, 10);
    m_problem->hide();
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_problem);
    column->addWidget(m_table, 1);
    m_card->addToHeader(m_bench);
    m_card->addToHeader(m_search);
    m_card->setContent(content);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_card);
    m_typing->setSingleShot(true);
    m_typing->setInterval(typingTime);
    connect(m_search, &QLineEdit::textChanged, m_typing, qOverload<>(&QTimer::start));
    connect(m_bench, &QComboBox::currentIndexChanged, this, &HubRunsPanel::askFirst);
    connect(m_typing, &QTimer::timeout, this, &HubRunsPanel::askFirst);
    connect(m_model, &HubRunsModel::moreWanted, this, &HubRunsPanel::askMore);
    connect(m_task.get(), &BackgroundTask::finished, this, &HubRunsPanel::take);
}

HubRunsPanel::~HubRunsPanel() = default;

void HubRunsPanel::setHub(const std::optional<HubAddress> &hub)
{
    const bool isSame = hub.has_value() == m_hub.has_value() &&
                        (!hub || (hub->url() == m_hub->url() && hub->password == m_hub->password));
    if (isSame)
        return;
    m_hub = hub;
    m_results.reset();
    m_model->setRuns({}, true);
    if (isVisible())
        askFirst();
}

void HubRunsPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    askFirst();
}

void HubRunsPanel::askFirst()
{
    if (m_task->isRunning()) {
        m_isNextFirst = true;
        m_task->cancel();
    } else {
        ask(true);
    }
}

void HubRunsPanel::askMore()
{
    if (!m_task->isRunning())
        ask(false);
}

void HubRunsPanel::ask(bool isFirst)
{
    const QString text = m_search->text().trimmed();
    if (!m_hub || (!text.isEmpty() && text.size() < shortestSearch))
        return;
    HubRunFilter filter;
    filter.search = text.toStdString();
    filter.bench = m_bench->currentData().toString().toStdString();
    std::optional<HubRun> after;
    if (!isFirst && !m_model->runs().empty())
        after = m_model->runs().back();
    m_answer = std::make_shared<Answer>();
    m_answer->isFirst = isFirst;
    m_card->setRemark(tr("Searching…"));
    m_task->start([hub = *m_hub, filter, after, answer = m_answer,
                   known = m_results](const JobControl &control) -> Result<void> {
        answer->results = known;
        if (!answer->results)
            answer->results = ODO_TRY(HubResults::connect(hub, control));
        if (answer->isFirst)
            answer->benches = ODO_TRY(answer->results->benches(control));
        answer->runs = ODO_TRY(answer->results->runs(filter, pageSize, after ? &*after : nullptr, control));
        return {};
    });
}

void HubRunsPanel::take(const std::optional<Error> &error)
{
    const auto answer = std::exchange(m_answer, nullptr);
    m_results = error ? nullptr : answer->results; // after an error it connects again
    if (std::exchange(m_isNextFirst, false))
        return ask(true);
    const bool isAll = error || static_cast<int>(answer->runs.size()) < pageSize;
    if (error && answer->isFirst)
        m_model->setRuns({}, true);
    else if (answer->isFirst)
        m_model->setRuns(std::move(answer->runs), isAll);
    else
        m_model->addRuns(answer->runs, isAll);
    if (!error && answer->isFirst)
        offerBenches(answer->benches);
    m_problem->setText(error ? errorInWords(*error) : QString());
    m_problem->setVisible(error.has_value());
    const auto count = static_cast<int>(m_model->runs().size());
    m_card->setRemark(error              ? QString()
                      : m_model->isAll() ? tr("%n run(s)", nullptr, count)
                                         : tr("the newest %n run(s)", nullptr, count));
    if (answer->isFirst)
        fit();
    Q_EMIT settled();
}

/// Keeps what is chosen where it is still there.
void HubRunsPanel::offerBenches(const std::vector<std::string> &benches)
{
    const QSignalBlocker quiet(m_bench);
    const QVariant chosen = m_bench->currentData();
    while (m_bench->count() > 1)
        m_bench->removeItem(1);
    for (const std::string &bench : benches)
        m_bench->addItem(QString::fromStdString(bench), QString::fromStdString(bench));
    m_bench->setCurrentIndex(std::max(0, chosen.isValid() ? m_bench->findData(chosen) : 0));
    m_bench->setVisible(benches.size() > 1);
    m_table->setColumnHidden(HubRunsModel::BenchColumn, benches.empty());
}

void HubRunsPanel::fit()
{
    fitColumns(*m_table, HubRunsModel::TrialColumn,
               {HubRunsModel::TrialColumn, HubRunsModel::TeamColumn, HubRunsModel::TaskColumn});
}

bool HubRunsPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize) // of the table, also by its scroll bar
        fit();
    return QWidget::eventFilter(watched, event);
}

} // namespace odo
