// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/scoreboard_dialog.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"
#include "ui/scoreboard/internal/qr_code.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"

#include <QClipboard>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QEventLoop>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>
#include <utility>

namespace odo {

namespace {

/// The usual port, or where another program has it any that is free.
Result<std::unique_ptr<Scoreboard>> startAtAnyPort(const std::filesystem::path &file,
                                                   ScoreboardSettings settings)
{
    for (;;) {
        auto project = ODO_TRY(Project::openAgain(file, Project::Access::ReadOnly));
        auto board = Scoreboard::start(std::move(project), settings);
        if (board || board.error().code != ErrorCode::Unavailable || settings.port == 0)
            return board;
        settings.port = 0;
    }
}

/// On a thread of its own, until it is cancelled. whenServed: gets the address.
Result<void> serve(const std::filesystem::path &file, const ScoreboardSettings &settings,
                   const JobControl &control, const std::function<void(const QString &)> &whenServed)
{
    constexpr std::chrono::milliseconds cancelInterval{30};
    QEventLoop loop; // first: it makes this thread one that timers work on
    const auto board = ODO_TRY(startAtAnyPort(file, settings));
    whenServed(board->url());
    std::optional<Error> end;
    QObject::connect(board.get(), &Scoreboard::ended, &loop, [&](const Error &error) {
        end = error;
        loop.quit();
    });
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
        if (control.isCancelled())
            loop.quit();
    });
    timer.start(cancelInterval);
    loop.exec();
    return end ? Result<void>(tl::unexpected(*end)) : Result<void>();
}

} // namespace

ScoreboardDialog::ScoreboardDialog(Project &project, QWidget *parent)
    : QDialog(parent), m_file(project.file()), m_class(new QComboBox), m_task(new QComboBox),
      m_audience(new QComboBox), m_code(new QrWidget), m_address(new QLabel), m_words(new QLabel),
      m_copy(plainButton(tr("&Copy address"))), m_open(plainButton(tr("&Open in browser")))
{
    setWindowTitle(tr("Standings as a web page"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto *intro =
        new QLabel(tr("Show the standings on a projector or on phones. The page follows the project "
                      "as long as this window is open."));
    intro->setWordWrap(true);
    offer(project);
    auto *form = new QFormLayout;
    form->addRow(tr("C&lass:"), m_class);
    form->addRow(tr("&Task:"), m_task);
    form->addRow(tr("&Visible to:"), m_audience);
    m_address->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_address->setAlignment(Qt::AlignHCenter);
    m_address->setAccessibleName(tr("Address of the page"));
    QFont large = m_address->font();
    large.setPointSizeF(1.3 * large.pointSizeF());
    m_address->setFont(large);
    showAsWords(*m_words);
    m_words->setAlignment(Qt::AlignHCenter);
    m_words->setMinimumHeight(3 * m_words->fontMetrics().lineSpacing()); // so the dialog keeps its size
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_open, QDialogButtonBox::ActionRole);
    buttons->addButton(m_copy, QDialogButtonBox::ActionRole);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(intro);
    layout->addLayout(form);
    layout->addWidget(m_code, 0, Qt::AlignHCenter);
    layout->addWidget(m_address);
    layout->addWidget(m_words);
    layout->addStretch(1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_url); });
    connect(m_open, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl(m_url)); });
    for (QComboBox *choice : {m_class, m_task, m_audience})
        connect(choice, &QComboBox::currentIndexChanged, this, &ScoreboardDialog::restart);
    connect(&m_serving, &BackgroundTask::finished, this, &ScoreboardDialog::finish);
    begin();
}

ScoreboardDialog::~ScoreboardDialog() = default;

void ScoreboardDialog::offer(Project &project)
{
    m_class->addItem(tr("All classes"), QString());
    const auto classes = project.classes().all().value_or(std::vector<ClassRecord>());
    for (const ClassRecord &each : classes)
        if (!each.archived)
            m_class->addItem(QString::fromStdString(each.name), QString::fromStdString(each.name));
    m_task->addItem(tr("Task of the newest trial"), QString());
    const auto tasks = project.tasks().current().value_or(std::vector<TaskRecord>());
    for (const TaskRecord &each : tasks)
        m_task->addItem(QString::fromStdString(each.name), QString::fromStdString(each.name));
    m_audience->addItem(tr("This computer only"), false);
    m_audience->addItem(tr("All devices in the network"), true);
    for (QComboBox *choice : {m_class, m_task}) {
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->setMinimumContentsLength(20);
    }
}

ScoreboardSettings ScoreboardDialog::settings() const
{
    ScoreboardSettings settings;
    settings.choice.className = m_class->currentData().toString().toStdString();
    settings.choice.task = m_task->currentData().toString().toStdString();
    if (m_audience->currentData().toBool())
        settings.address = QHostAddress(QHostAddress::AnyIPv4);
    return settings;
}

void ScoreboardDialog::restart()
{
    m_isWanted = true;
    if (m_serving.isRunning())
        m_serving.cancel();
    else
        begin();
}

void ScoreboardDialog::begin()
{
    m_isWanted = false;
    showAddress({}, false);
    m_serving.start([this, file = m_file, settings = settings()](const JobControl &control) {
        const bool isForNetwork = !settings.address.isLoopback();
        return serve(file, settings, control, [this, isForNetwork](const QString &url) {
            callLater(this, [this, url, isForNetwork] { showAddress(url, isForNetwork); });
        });
    });
}

void ScoreboardDialog::showAddress(const QString &url, bool isForNetwork)
{
    m_url = url;
    m_code->setText(url);
    m_address->setText(url);
    m_words->setText(url.isEmpty() ? tr("Starting…")
                     : isForNetwork
                         ? tr("Everyone in the network can open this page. It shows the names of teams, "
                              "classes and tasks, and no others.")
                         : tr("Only this computer can open this page."));
    for (QPushButton *button : {m_copy, m_open})
        button->setEnabled(!url.isEmpty());
}

void ScoreboardDialog::finish(const std::optional<Error> &error)
{
    if (m_isWanted)
        return begin();
    showAddress({}, false);
    m_words->setText(error ? errorInWords(*error) : QString());
}

} // namespace odo
