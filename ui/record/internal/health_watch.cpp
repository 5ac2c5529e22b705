// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/health_watch.h"

#include "core/project/project.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/record/internal/live_board.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/widgets/fact_list.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <bit>
#include <cmath>

namespace odo {

namespace {

class HealthWatchWords
{
    Q_DECLARE_TR_FUNCTIONS(HealthWatch)
};

} // namespace

HealthWatch::HealthWatch(const Project &project, bool readOnly, ChosenCameras &cameras, LiveBoard &board,
                         WarningBar &warning)
    : m_project(project), m_readOnly(readOnly), m_cameras(cameras), m_board(board), m_warning(warning)
{
}

void HealthWatch::poll()
{
    if (!m_cameras.session())
        return;
    CaptureHealth health = m_cameras.session()->health();
    if (!health.disk.recording)
        health.disk.secondsLeft = m_cameras.session()->remainingSeconds(m_project.file().parent_path());
    const LiveStatistics live = m_cameras.tracker() ? m_cameras.tracker()->statistics() : LiveStatistics{};
    m_board.setHealth(health, m_cameras.cameras(), live, m_before);
    m_remainingTime = shownWords(remainingTimeText(health.disk));
    m_anyDelivers = std::ranges::any_of(
        health.views, [](const ViewHealth &view) { return view.state == ViewHealth::State::Delivering; });
    const bool allEnded = std::ranges::all_of(
        health.views, [](const ViewHealth &view) { return view.state == ViewHealth::State::Ended; });
    m_hasEnded = health.disk.ended || allEnded;
    showWarning(health);
}

void HealthWatch::countFromNow()
{
    m_before = m_cameras.session()->health();
}

QString HealthWatch::blocked() const
{
    if (m_readOnly)
        return HealthWatchWords::tr("The project is read-only");
    if (!m_cameras.session())
        return m_cameras.isPreparing() ? HealthWatchWords::tr("Opening the cameras…")
                                       : HealthWatchWords::tr("No camera is running");
    return m_anyDelivers ? QString() : HealthWatchWords::tr("No camera sends frames");
}

void HealthWatch::showWarning(const CaptureHealth &health)
{
    const auto &cameras = m_cameras.cameras();
    QString words = warningWords(health, cameras);
    if (m_readOnly)
        words = HealthWatchWords::tr("This project is read-only: you cannot record into it.");
    const QString unregistered = m_cameras.session() ? unregisteredWords(cameras) : QString();
    if (words.isEmpty() && !unregistered.isEmpty())
        m_warning.setWords(unregistered, HealthWatchWords::tr("Register &it in Testbed"));
    else
        m_warning.setWords(words);
}

WarningBar::WarningBar(QWidget *parent) : QFrame(parent), m_words(new QLabel), m_button(new QPushButton)
{
    setObjectName(QStringLiteral("messageBar"));
    setProperty("kind", QStringLiteral("bad"));
    setAccessibleName(tr("Problem"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->addWidget(m_words, 1);
    layout->addWidget(m_button);
    m_button->setAccessibleName(tr("Fix"));
    connect(m_button, &QPushButton::clicked, this, &WarningBar::clicked);
    hide();
}

void WarningBar::setWords(const QString &words, const QString &button)
{
    const bool isNew = isHidden() && !words.isEmpty() && button.isEmpty();
    if (words != m_words->text())
        m_words->setText(words);
    m_button->setText(button);
    m_button->setVisible(!button.isEmpty());
    setVisible(!words.isEmpty());
    if (isNew) // once: its numbers may change
        Q_EMIT warned(words);
}

QString WarningBar::words() const
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
        return {DoctorDialog::tr("warning"), BadgeState::Warning};
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
    auto *scroll = scrolled(m_facts, tr("Findings"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    m_again = buttons->addButton(tr("&Check again"), QDialogButtonBox::ActionRole);
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
    m_words->setText(tr("Checking…"));
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
    int problems = 0;
    for (const SetupFinding &finding : findings) {
        QString words = shownWords(finding.words);
        if (!finding.advice.isEmpty())
            words += tr(". What to do: %1.").arg(shownWords(finding.advice));
        problems += finding.verdict == SetupFinding::Verdict::Warning ||
                    finding.verdict == SetupFinding::Verdict::Bad;
        facts.append({shownWords(finding.what), words, badgeOf(finding.verdict)});
    }
    m_facts->setFacts(facts);
    m_words->setText(problems == 0   ? tr("Found nothing that would disturb a recording.")
                     : problems == 1 ? tr("Found one problem.")
                                     : tr("Found %1 problems, the worst first.").arg(problems));
    m_again->setEnabled(true);
}

namespace {

class RecordHealthWords
{
    Q_DECLARE_TR_FUNCTIONS(RecordHealth)
};

constexpr double goodStepS = 0.005, badStepS = 0.017; // half an interval of 30 frames/s
constexpr double slowMapS = 0.2, littleTimeS = 300;

Badge viewBadge(const ViewHealth &view)
{
    if (view.state == ViewHealth::State::Waiting || view.state == ViewHealth::State::Ended || view.warning)
        return {RecordHealthWords::tr("problem"), BadgeState::Bad};
    if (view.slow)
        return {RecordHealthWords::tr("slow"), BadgeState::Warning};
    if (view.lostByUs > 0 || view.lostOnWire > 0)
        return {RecordHealthWords::tr("lost frames"), BadgeState::Warning};
    return view.state == ViewHealth::State::Delivering
               ? Badge{RecordHealthWords::tr("good"), BadgeState::Good}
               : Badge{};
}

Fact viewFact(const ViewHealth &view, const WantedCamera &camera)
{
    QString words = shownWords(healthWords(view));
    if (view.state == ViewHealth::State::Delivering && view.latencyS > 0)
        words += RecordHealthWords::tr(", %1 ms").arg(std::lround(1e3 * view.latencyS));
    if (!camera.floorView)
        words += RecordHealthWords::tr("; not registered");
    return {RecordHealthWords::tr("Camera %1").arg(QString::fromStdString(camera.name)), words,
            viewBadge(view)};
}

ViewHealth since(ViewHealth view, const CaptureHealth &before, std::size_t v)
{
    if (v >= before.views.size())
        return view;
    const ViewHealth &then = before.views[v];
    view.lostOnWire -= std::min(view.lostOnWire, then.lostOnWire);
    view.lostByUs -= std::min(view.lostByUs, then.lostByUs);
    view.source.damaged -= std::min(view.source.damaged, then.source.damaged);
    return view;
}

Fact robotFact(const SeenRobot &robot)
{
    const QString name = QString::fromStdString(robot.name);
    if (!robot.now || !robot.now->point.valid)
        return {name,
                RecordHealthWords::tr("no camera sees it"),
                {RecordHealthWords::tr("not visible"), BadgeState::Warning}};
    const ProfilePoint &point = robot.now->point;
    const QString place = RecordHealthWords::tr("x %1, y %2, %3")
                              .arg(distanceText(point.position.x()), distanceText(point.position.y()),
                                   speedText(point.speedMps, point.sigmaSpeedMps));
    if (std::popcount(robot.now->sample.views) == 1)
        return {name,
                place + RecordHealthWords::tr("; one camera sees it"),
                {RecordHealthWords::tr("visible"), BadgeState::Neutral}};
    return {name, place, {RecordHealthWords::tr("visible"), BadgeState::Good}};
}

Fact stepFact(const PairHealth &pairs)
{
    const Badge badge = pairs.p95S <= goodStepS  ? Badge{RecordHealthWords::tr("good"), BadgeState::Good}
                        : pairs.p95S <= badStepS ? Badge{RecordHealthWords::tr("fair"), BadgeState::Neutral}
                                                 : Badge{RecordHealthWords::tr("poor"), BadgeState::Warning};
    return {RecordHealthWords::tr("Synchronisation"), shownWords(synchronisationWords(pairs.p95S)), badge};
}

QString sentence(QString words)
{
    if (!words.isEmpty() && !words.endsWith(u'.'))
        words += u'.';
    return words;
}

QString errorSentence(const Error &error)
{
    return sentence(errorLine(error));
}

} // namespace

QList<Fact> healthFacts(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                        const LiveStatistics &live, const std::vector<SeenRobot> &robots,
                        const CaptureHealth &before)
{
    QList<Fact> facts;
    for (std::size_t v = 0; v < std::min(cameras.size(), health.views.size()); ++v)
        facts.append(viewFact(since(health.views[v], before, v), cameras[v]));
    if (health.pairs.pairs > 0 && cameras.size() > 1)
        facts.append(stepFact(health.pairs));
    if (const Message words = liveWords(live); !words.isEmpty())
        facts.append({RecordHealthWords::tr("Live"), shownWords(words),
                      live.latencyP99S > slowMapS ? Badge{RecordHealthWords::tr("slow"), BadgeState::Warning}
                                                  : Badge{RecordHealthWords::tr("good"), BadgeState::Good}});
    if (health.disk.recording) {
        QStringList words{RecordHealthWords::tr("%1 MB written")
                              .arg(QLocale().toString(double(health.disk.bytes) / 1e6, 'f', 0))};
        if (const Message remainingTime = remainingTimeText(health.disk); !remainingTime.isEmpty())
            words << shownWords(remainingTime);
        const bool bad = health.disk.warning || health.disk.waiting >= 1;
        facts.append({RecordHealthWords::tr("Disk"), words.join(QStringLiteral(", ")),
                      bad ? Badge{RecordHealthWords::tr("problem"), BadgeState::Bad}
                          : Badge{RecordHealthWords::tr("good"), BadgeState::Good}});
    }
    for (const SeenRobot &robot : robots)
        facts.append(robotFact(robot));
    return facts;
}

QString unregisteredWords(const std::vector<WantedCamera> &cameras)
{
    for (const WantedCamera &camera : cameras) {
        const QString name = QString::fromStdString(camera.name);
        if (!camera.floorView && camera.registeredPx.isEmpty())
            return RecordHealthWords::tr(
                       "Camera %1 is not registered to the floor: it records, but cannot locate robots.")
                .arg(name);
        if (!camera.floorView)
            return RecordHealthWords::tr("Camera %1 was registered with frames of %2×%3, but now sends "
                                         "another size: it records, but cannot locate robots.")
                .arg(name)
                .arg(camera.registeredPx.width())
                .arg(camera.registeredPx.height());
    }
    return {};
}

QString warningWords(const CaptureHealth &health, const std::vector<WantedCamera> &cameras)
{
    if (health.disk.warning)
        return RecordHealthWords::tr("Recording: %1").arg(errorSentence(health.disk.warning->error));
    const auto firstOf = [&](std::optional<RecordingWarning> ViewHealth::*kind) {
        for (std::size_t v = 0; v < std::min(cameras.size(), health.views.size()); ++v) {
            if (const auto &warning = health.views[v].*kind)
                return RecordHealthWords::tr("Camera %1: %2")
                    .arg(QString::fromStdString(cameras[v].name), errorSentence(warning->error));
        }
        return QString();
    };
    if (QString words = firstOf(&ViewHealth::warning); !words.isEmpty())
        return words;
    if (health.sleep)
        return errorSentence(health.sleep->error);
    if (QString words = firstOf(&ViewHealth::slow); !words.isEmpty())
        return words;
    if (health.disk.recording && health.disk.waiting >= 0.5)
        return RecordHealthWords::tr(
            "The disk is barely fast enough: record to a faster one, or with fewer cameras.");
    if (health.disk.secondsLeft && *health.disk.secondsLeft < littleTimeS)
        return sentence(RecordHealthWords::tr("The disk is nearly full: %1")
                            .arg(shownWords(remainingTimeText(health.disk))));
    if (health.pairs.pairs > 0 && health.pairs.p95S > badStepS)
        return RecordHealthWords::tr("The cameras are not synchronised: set both to the same frame rate.");
    return {};
}

} // namespace odo
