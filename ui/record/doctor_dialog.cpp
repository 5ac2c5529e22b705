// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/doctor_dialog.h"

#include "ui/models/core_words.h"
#include "ui/record/running_cameras.h"
#include "ui/views/fact_list.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace odo {
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
        if (!finding.advice.empty())
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
