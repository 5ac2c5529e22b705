// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/start_actions.h"

#include "core/base/units.h"
#include "core/calibration/floor_mat.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/mat_job.h"
#include "core/workflow/calibrate/register_job.h"
#include "ui/main_window/internal/report_actions.h"
#include "ui/main_window/internal/trial_actions.h"
#include "ui/main_window/project_pages.h"
#include "ui/main_window/workspace.h"
#include "ui/models/number_text.h"
#include "ui/start/start_page.h"
#include "ui/testbed/targets/target_dialog.h"
#include "ui/testbed/testbed_page.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <optional>
#include <utility>

namespace odo {

namespace {

/// Asks for the length of the mat's check line, which tells how large the print came out.
class MatDialog : public QDialog
{
    Q_OBJECT
public:
    MatDialog(const QStringList &cameras, QWidget *parent);
    double checkLineM() const { return fromMillimetres(m_line->value()); }

private:
    NumberBox *m_line;
};

MatDialog::MatDialog(const QStringList &cameras, QWidget *parent) : QDialog(parent), m_line(new NumberBox)
{
    constexpr double shortestMm = 150, longestMm = 1200; // 0.2 and 1 m, as printers print them
    constexpr int width = 460;
    setWindowTitle(tr("Find the floor mat"));
    auto *words = new QLabel(tr("The mat is searched for in the newest recording of each camera: %1.")
                                 .arg(cameras.join(QStringLiteral(", "))));
    showAsWords(*words);
    m_line->setRange(shortestMm, longestMm);
    m_line->setDecimals(1);
    m_line->setSpecialValueText(tr("not measured")); // nothing is proposed: it would be taken as measured
    m_line->setSuffix(tr(" mm"));
    auto *hint = new QLabel(tr("Measure the line at the mat's lower edge from end mark to end mark. Printers "
                               "often shrink by 2 to 4 %; what you enter makes up for it."));
    showAsWords(*hint);
    hint->setForegroundRole(QPalette::PlaceholderText);
    auto *form = new QFormLayout;
    form->addRow(tr("&Check line"), m_line);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *find = buttons->addButton(tr("Find the mat"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(hint);
    layout->addWidget(buttons);
    find->setDefault(true);
    find->setEnabled(false);
    connect(m_line, &QDoubleSpinBox::valueChanged, find,
            [find](double mm) { find->setEnabled(mm > shortestMm); });
    m_line->setFocus();
    resize(width, layout->totalHeightForWidth(width));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

} // namespace

StartActions::StartActions(Workspace &workspace, TrialActions &trials, ReportActions &reports,
                           QWidget &window)
    : QObject(&window), m_workspace(workspace), m_trials(trials), m_reports(reports), m_window(window)
{
}

void StartActions::serve(ProjectPages &pages)
{
    m_pages = &pages;
    connect(&pages.start(), &StartPage::requested, this, &StartActions::act);
}

void StartActions::act(StartPage::Task task)
{
    switch (task) {
    case StartPage::ImportClips:
        return m_trials.askImport();
    case StartPage::ConnectCameras:
        return m_pages->show(WindowMode::Record);
    case StartPage::PrintMat:
        return printMat();
    case StartPage::FindMat:
        return findMat();
    case StartPage::RegisterFloor:
        return m_pages->show(WindowMode::Testbed);
    case StartPage::Calibrate:
        return calibrateBy({});
    case StartPage::AddRobot:
        m_trials.askRobot();
        return;
    case StartPage::TrackNewest:
        return m_trials.askTrack(m_pages->start().newestTrial());
    case StartPage::RecordTrial:
        return m_pages->show(WindowMode::Record);
    case StartPage::MakeReport:
        return m_reports.askTrials({m_pages->start().newestTrial()});
    }
}

void StartActions::calibrateBy(const QStringList &stills)
{
    if (!m_pages) // that of this project is still to be made
        return;
    m_pages->show(WindowMode::Testbed);
    m_pages->testbed().calibrate(stills);
}

void StartActions::printMat()
{
    TargetDialog(TargetKind::Mat, {}, &m_window).exec();
}

Result<std::vector<StartActions::MatCamera>> StartActions::recordedCameras() const
{
    Project &project = *m_workspace.project();
    std::vector<MatCamera> cameras;
    for (const CameraRecord &camera : ODO_TRY(project.cameras().all())) {
        if (const auto recording = ODO_TRY(project.trials().newestRecording(camera.id)))
            cameras.push_back({camera.name, project.resolve(*recording)});
    }
    return cameras;
}

void StartActions::findMat()
{
    auto cameras = recordedCameras();
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    QStringList names;
    MatSettings settings;
    for (const MatCamera &camera : *cameras) {
        names << QString::fromStdString(camera.name);
        settings.files.push_back(camera.recording);
    }
    MatDialog dialog(names, &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    settings.checkLineM = dialog.checkLineM();
    const auto job = std::make_shared<FindMatJob>(std::move(settings));
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.finding_mat", "Finding the floor mat"), [this, job, cameras = std::move(*cameras)] {
            std::vector<MatCamera> seeing;
            QStringList without;
            for (std::size_t i = 0; i < cameras.size(); ++i) {
                if (job->isSeen()[i])
                    seeing.push_back(cameras[i]);
                else
                    without << QString::fromStdString(cameras[i].name);
            }
            registerNext(seeing, job->layoutName(), {}, without.join(QStringLiteral(", ")));
        }));
}

/// One after the other, each a change of its own.
void StartActions::registerNext(std::vector<MatCamera> cameras, const std::string &layout,
                                const QString &outcome, const QString &without)
{
    if (cameras.empty()) {
        QString words = tr("Registered to the floor mat: %1.").arg(outcome);
        if (!without.isEmpty())
            words += QLatin1Char(' ') + tr("Their newest recordings do not show it: %1.").arg(without);
        Q_EMIT done(words);
        return;
    }
    const std::string name = cameras.front().name;
    cameras.erase(cameras.begin());
    const auto job = std::make_shared<RegisterJob>(RegisterSettings{name, layout, {}, {}, {}});
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.registering", "Registering camera %1")(Named::camera(name)),
        [this, job, cameras = std::move(cameras), layout, outcome, without, name] {
            const QString one = QStringLiteral("%1 %2").arg(
                QString::fromStdString(name), registrationBadge(job->record().registration).text);
            registerNext(cameras, layout, outcome.isEmpty() ? one : outcome + QStringLiteral(", ") + one,
                         without);
        }));
}

void StartActions::showFailure(const Result<void> &result)
{
    if (!result)
        Q_EMIT failed(result.error());
}

} // namespace odo

#include "start_actions.moc"
