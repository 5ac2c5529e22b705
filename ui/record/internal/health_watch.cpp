// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/health_watch.h"

#include "core/project/project.h"
#include "ui/models/shown_message.h"
#include "ui/record/internal/chosen_cameras.h"
#include "ui/record/internal/health_words.h"
#include "ui/record/internal/live_board.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/widgets/fact_list.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

class HealthWatchWords
{
    Q_DECLARE_TR_FUNCTIONS(HealthWatch)
};

} // namespace

HealthWatch::HealthWatch(const Project &project, bool readOnly, ChosenCameras &cameras, LiveBoard &board,
                         TroubleBar &trouble)
    : m_project(project), m_readOnly(readOnly), m_cameras(cameras), m_board(board), m_trouble(trouble)
{
}

void HealthWatch::look()
{
    if (!m_cameras.session())
        return;
    CaptureHealth health = m_cameras.session()->health();
    if (!health.disk.recording)
        health.disk.secondsLeft = m_cameras.session()->secondsOfRoom(m_project.file().parent_path());
    const LiveFigures live = m_cameras.tracker() ? m_cameras.tracker()->figures() : LiveFigures{};
    m_board.setHealth(health, m_cameras.cameras(), live, m_before);
    m_room = shownWords(roomWords(health.disk));
    m_anyDelivers = std::ranges::any_of(
        health.views, [](const ViewHealth &view) { return view.state == ViewHealth::State::Delivering; });
    const bool allEnded = std::ranges::all_of(
        health.views, [](const ViewHealth &view) { return view.state == ViewHealth::State::Ended; });
    m_hasEnded = health.disk.ended || allEnded;
    showTrouble(health);
}

void HealthWatch::countFromNow()
{
    m_before = m_cameras.session()->health();
}

QString HealthWatch::blocked() const
{
    if (m_readOnly)
        return HealthWatchWords::tr("The project can only be read");
    if (!m_cameras.session())
        return m_cameras.isPreparing() ? HealthWatchWords::tr("Opening the cameras…")
                                       : HealthWatchWords::tr("No camera runs");
    return m_anyDelivers ? QString() : HealthWatchWords::tr("No camera sends pictures");
}

void HealthWatch::showTrouble(const CaptureHealth &health)
{
    const auto &cameras = m_cameras.cameras();
    QString words = troubleWords(health, cameras);
    if (m_readOnly)
        words = HealthWatchWords::tr("This project can only be read: nothing can be recorded into it.");
    const QString unregistered = m_cameras.session() ? unregisteredWords(cameras) : QString();
    if (words.isEmpty() && !unregistered.isEmpty())
        m_trouble.setWords(unregistered, HealthWatchWords::tr("Register &it in Testbed"));
    else
        m_trouble.setWords(words);
}

TroubleBar::TroubleBar(QWidget *parent) : QFrame(parent), m_words(new QLabel), m_button(new QPushButton)
{
    setObjectName(QStringLiteral("messageBar"));
    setProperty("kind", QStringLiteral("bad"));
    setAccessibleName(tr("What is the matter"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->addWidget(m_words, 1);
    layout->addWidget(m_button);
    m_button->setAccessibleName(tr("Put it right"));
    connect(m_button, &QPushButton::clicked, this, &TroubleBar::clicked);
    hide();
}

void TroubleBar::setWords(const QString &words, const QString &button)
{
    if (words != m_words->text())
        m_words->setText(words);
    m_button->setText(button);
    m_button->setVisible(!button.isEmpty());
    setVisible(!words.isEmpty());
}

QString TroubleBar::words() const
{
    return isHidden() ? QString() : m_words->text();
}

namespace {

Badge badgeOf(SetupFinding::Verdict verdict)
{
    switch (verdict) {
    case SetupFinding::Verdict::Good:
        return {DoctorDialog::tr("good"), BadgeState::Good};
    case SetupFinding::Verdict::Warning:
        return {DoctorDialog::tr("doubtful"), BadgeState::Warning};
    case SetupFinding::Verdict::Bad:
        return {DoctorDialog::tr("bad"), BadgeState::Bad};
    case SetupFinding::Verdict::NotKnown:
        break;
    }
    return {DoctorDialog::tr("not known"), BadgeState::Neutral};
}

} // namespace

DoctorDialog::DoctorDialog(const RunningCameras &cameras, QWidget *parent)
    : QDialog(parent), m_cameras(cameras), m_facts(new FactList), m_words(new QLabel)
{
    setWindowTitle(tr("Set-up doctor"));
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    auto *scroll = scrolled(m_facts, tr("What was found"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    m_again = buttons->addButton(tr("&Look again"), QDialogButtonBox::ActionRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(m_words);
    layout->addWidget(scroll, 1);
    layout->addWidget(buttons);
    resize(680, 520);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_again, &QPushButton::clicked, this, &DoctorDialog::examine);
    examine();
}

void DoctorDialog::examine()
{
    m_words->setText(tr("Looking…"));
    m_again->setEnabled(false);
    std::vector<CheckedCamera> cameras;
    PairHealth pairs;
    const std::shared_ptr<CaptureSession> session = m_cameras.session();
    if (session) {
        const CaptureHealth health = session->health();
        pairs = health.pairs;
        for (std::size_t v = 0; v < m_cameras.cameras().size(); ++v) {
            const WantedCamera &wanted = m_cameras.cameras()[v];
            CheckedCamera camera{wanted.name,
                                 session->description(v),
                                 {},
                                 wanted.registeredPx.width(),
                                 wanted.registeredPx.height(),
                                 health.views[v],
                                 {},
                                 0};
            cameras.push_back(std::move(camera));
        }
    }
    const auto findings = std::make_shared<std::vector<SetupFinding>>();
    disconnect(&m_task, nullptr, this, nullptr);
    connect(&m_task, &BackgroundTask::finished, this, [this, findings] { show(*findings); });
    m_task.start([session, cameras, pairs, findings](const JobControl &) mutable -> Result<void> {
        for (std::size_t v = 0; v < cameras.size(); ++v)
            cameras[v].controls = session->controls(v).value_or(std::vector<CameraControl>());
        *findings = checkSetup(std::move(cameras), pairs, readMachine());
        return {};
    });
}

void DoctorDialog::show(const std::vector<SetupFinding> &findings)
{
    QList<Fact> facts;
    int doubts = 0;
    for (const SetupFinding &finding : findings) {
        QString words = shownWords(finding.words);
        if (!finding.advice.isEmpty())
            words += tr(". What to do: %1.").arg(shownWords(finding.advice));
        doubts += finding.verdict == SetupFinding::Verdict::Warning ||
                  finding.verdict == SetupFinding::Verdict::Bad;
        facts.append({shownWords(finding.what), words, badgeOf(finding.verdict)});
    }
    m_facts->setFacts(facts);
    m_words->setText(doubts == 0   ? tr("Nothing was found that would disturb a recording.")
                     : doubts == 1 ? tr("There is one thing to look at.")
                                   : tr("There are %1 things to look at, the worst first.").arg(doubts));
    m_again->setEnabled(true);
}

} // namespace odo
