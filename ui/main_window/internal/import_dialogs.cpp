// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/import_dialogs.h"

#include "core/project/names.h"
#include "core/video/video_reader.h"
#include "core/workflow/import/chapter_names.h"
#include "core/workflow/import/recording_source.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {
constexpr int usualViews = 2;
constexpr double usualRate = 240, lowestRate = 1;

/// One text for each recording; chapters that belong together are joined.
QStringList recordingsOf(const QStringList &files)
{
    std::vector<std::filesystem::path> paths;
    for (const QString &file : files)
        paths.emplace_back(file.toStdString());
    QStringList recordings;
    for (const auto &group : chapterGroups(paths))
        recordings << QString::fromStdString(joinedNames(group).string());
    return recordings;
}

/// A codec's bare stream may say nothing of when its frames were taken, and images never do.
bool lacksTimes(const std::filesystem::path &video)
{
    const auto source = recordingSourceOf(video);
    return source &&
           (source->kind == RecordingSource::Kind::Images || VideoReader::lacksTimes(source->files.front()));
}

} // namespace

QString freeTrialName(const QStringList &taken)
{
    for (int number = static_cast<int>(taken.size()) + 1;; ++number) {
        QString name = ImportTrialDialog::tr("Trial %1").arg(number);
        if (!taken.contains(name))
            return name;
    }
}

TeamBox::TeamBox(const QStringList &teams, const QStringList &shown, QWidget *parent) : QComboBox(parent)
{
    setEditable(true);
    addItem(QString());
    for (qsizetype i = 0; i < teams.size(); ++i)
        addItem(shown.value(i, teams[i]), teams[i]);
}

std::string TeamBox::team() const
{
    const QString typed = currentText().trimmed();
    const int known = findText(typed, Qt::MatchFixedString | Qt::MatchCaseSensitive);
    return (known > 0 ? itemData(known).toString() : typed).toStdString();
}

ImportTrialDialog::ImportTrialDialog(const Offer &offer, QWidget *parent)
    : QDialog(parent), m_cameras(offer.cameras), m_teamsRobots(offer.teamsRobots),
      m_name(new QLineEdit(offer.name)), m_team(new TeamBox(offer.teams, offer.teamsShown)),
      m_task(new QComboBox), m_robots(new CheckList(tr("Robots in the trial"))), m_videoGrid(new QGridLayout),
      m_addView(new QPushButton(tr("Add &view"))), m_steps(new ViewSteps),
      m_givenRate(new QCheckBox(tr("Camera's real &rate"))), m_rate(new NumberBox), m_rateReason(new QLabel),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Import trial from videos"));
    m_task->setEditable(true);
    m_task->addItem(QString());
    m_task->addItems(offer.tasks);
    m_task->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a name may be long
    m_robots->setNames(offer.robots, offer.robots.size() == 1);
    auto *form = new QFormLayout;
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("Te&am"), m_team);
    form->addRow(tr("Tas&k"), m_task);
    form->addRow(tr("R&obots"), m_robots);
    form->addRow(tr("Videos"), makeVideos());
    auto *step = new QLabel(tr("&Synchronise"));
    step->setBuddy(m_steps->fields().constFirst());
    form->addRow(step, m_steps);
    form->addRow(m_givenRate, makeRate());
    m_rateReason->setWordWrap(true);
    m_rateReason->hide();
    form->addRow(m_rateReason);
    QPushButton *accept = m_buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(m_buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    resize(620, sizeHint().height());
    connect(m_name, &QLineEdit::textChanged, this, &ImportTrialDialog::updateButtons);
    connect(m_team, &QComboBox::currentIndexChanged, this, &ImportTrialDialog::proposeRobots);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    orderTabs();
    updateButtons();
}

/// Those of the team that is chosen, if it has any of its own; they can be changed.
void ImportTrialDialog::proposeRobots(int team)
{
    const QStringList robots = m_teamsRobots.value(team - 1);
    if (!robots.isEmpty())
        m_robots->setChecked(robots);
}

QWidget *ImportTrialDialog::makeVideos()
{
    auto *widget = new QWidget;
    auto *layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    m_videoGrid->setColumnStretch(2, 1);
    m_videoGrid->addWidget(new QLabel(tr("Camera")), 0, 0);
    m_videoGrid->addWidget(new QLabel(tr("Video file")), 0, 2);
    layout->addLayout(m_videoGrid);
    m_addView->setAutoDefault(false); // Enter is the dialog's
    layout->addWidget(m_addView, 0, Qt::AlignLeft);
    connect(m_addView, &QPushButton::clicked, this, [this] {
        addVideo({}, {});
        orderTabs();
        m_videos.back().camera->setFocus();
    });
    for (int i = 0; i < usualViews; ++i)
        addVideo(i < int(m_cameras.size()) ? m_cameras[std::size_t(i)].name
                                           : QString(QChar(QLatin1Char(static_cast<char>('A' + i)))),
                 {});
    return widget;
}

QWidget *ImportTrialDialog::makeRate()
{
    m_rate->setRange(lowestRate, 10000);
    m_rate->setValue(usualRate);
    m_rate->setSuffix(tr(" frames/s"));
    m_rate->setAccessibleName(tr("Camera's real rate"));
    m_rate->setEnabled(false);
    m_givenRate->setToolTip(tr("For slow motion: the file plays slower than the camera recorded it"));
    connect(m_givenRate, &QCheckBox::toggled, m_rate, &QWidget::setEnabled);
    connect(m_rate, &QDoubleSpinBox::valueChanged, this, &ImportTrialDialog::updateButtons);
    return m_rate;
}

/// One file after the other, on a thread of its own: a file may be on a slow disk, or in a network.
void ImportTrialDialog::findMissingTimes()
{
    const auto row = std::ranges::find_if(
        m_videos, [](const VideoRow &one) { return one.lookedInto != one.file->path(); });
    if (row == m_videos.end() || m_look.isRunning())
        return requireRate();
    const std::filesystem::path file = row->file->path();
    const auto found = std::make_shared<bool>(false);
    connect(
        &m_look, &BackgroundTask::finished, this,
        [this, file, found] {
            for (VideoRow &one : m_videos) {
                if (one.file->path() != file)
                    continue;
                one.lookedInto = file;
                one.hasNoTimes = *found;
            }
            findMissingTimes();
        },
        Qt::SingleShotConnection);
    m_look.start([file, found](const JobControl &) -> Result<void> {
        *found = lacksTimes(file);
        return {};
    });
    requireRate();
}

bool ImportTrialDialog::VideoRow::lacksTimes() const
{
    return hasNoTimes && lookedInto == file->path();
}

/// Where some video lacks its times, the rate must be given, and is not proposed.
void ImportTrialDialog::requireRate()
{
    const auto lacking = std::ranges::find_if(m_videos, &VideoRow::lacksTimes);
    const bool isNeeded = lacking != m_videos.end();
    if (isNeeded == !m_givenRate->isEnabled()) {
        updateButtons();
        return;
    }
    m_givenRate->setChecked(isNeeded);
    m_givenRate->setEnabled(!isNeeded);
    m_rate->setMinimum(isNeeded ? 0 : lowestRate);
    m_rate->setSpecialValueText(isNeeded ? tr("not entered") : QString());
    m_rate->setValue(isNeeded ? 0 : usualRate);
    m_rateReason->setVisible(isNeeded);
    if (isNeeded)
        m_rateReason->setText(
            tr("%1 has no time stamps and states no frame rate. Enter the rate of its camera.")
                .arg(QString::fromStdString(lacking->file->path().filename().string())));
    updateButtons();
}

/// A view that was added would be reached last.
void ImportTrialDialog::orderTabs()
{
    QList<QWidget *> chain{m_robots};
    for (const VideoRow &row : m_videos)
        chain << row.camera << row.file;
    chain << m_addView << m_steps->fields() << m_givenRate << m_rate;
    for (int i = 1; i < chain.size(); ++i)
        setTabOrder(chain.at(i - 1), chain.at(i));
}

void ImportTrialDialog::addVideos(const QStringList &files)
{
    for (const QString &recording : recordingsOf(files))
        addVideo({}, recording);
}

void ImportTrialDialog::addVideo(const QString &camera, const QString &file)
{
    for (const VideoRow &row : m_videos) // a dropped file goes to the first row that waits for one
        if (!file.isEmpty() && row.file->path().empty()) {
            row.file->setPath(file);
            return;
        }
    const int number = static_cast<int>(m_videos.size()) + 1;
    auto *name = new QComboBox;
    name->setEditable(true);
    for (const OfferedCamera &each : m_cameras)
        name->addItem(each.name);
    name->setCurrentText(camera);
    name->setAccessibleName(tr("Camera of view %1").arg(number));
    auto *path = new PathField(tr("Video of view %1").arg(number),
                               tr("Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;All files (*)"));
    path->setPath(file);
    path->setSeveral([](const QStringList &files) { return recordingsOf(files).constFirst(); });
    path->setToolTip(tr("Chapters of one recording are joined by +; images are given as their folder, or "
                        "FOLDER/%06d.png, with the rate"));
    m_videoGrid->addWidget(name, number, 0);
    auto *badge = new BadgeLabel({});
    badge->setAccessibleName(tr("Registration of the camera of view %1").arg(number));
    m_videoGrid->addWidget(badge, number, 1);
    m_videoGrid->addWidget(path, number, 2);
    m_videos.push_back({name, badge, path});
    m_steps->addView();
    connect(name, &QComboBox::editTextChanged, this, &ImportTrialDialog::updateButtons);
    connect(path, &PathField::changed, this, &ImportTrialDialog::findMissingTimes);
    findMissingTimes();
}

Badge ImportTrialDialog::badgeOf(const QString &camera) const
{
    const auto found = std::ranges::find(m_cameras, camera, &OfferedCamera::name);
    return found == m_cameras.end() ? Badge() : found->badge;
}

void ImportTrialDialog::updateButtons()
{
    QStringList cameras;
    for (const VideoRow &row : m_videos) {
        cameras << row.camera->currentText();
        row.badge->setBadge(badgeOf(row.camera->currentText().trimmed()));
    }
    m_steps->setCameras(cameras);
    // A video without a camera would be left out in silence.
    const bool nameless = std::any_of(m_videos.begin(), m_videos.end(), [](const VideoRow &row) {
        return !row.file->path().empty() && row.camera->currentText().trimmed().isEmpty();
    });
    const bool isRateMissing = m_givenRate->isChecked() && m_rate->value() < lowestFrameRate;
    const bool complete =
        !m_name->text().trimmed().isEmpty() && !nameless && !isRateMissing && !settings().videos.empty();
    for (QAbstractButton *button : m_buttons->buttons())
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(complete);
}

ImportSettings ImportTrialDialog::settings() const
{
    ImportSettings settings;
    settings.trial = m_name->text().trimmed().toStdString();
    settings.team = m_team->team();
    settings.task = m_task->currentText().trimmed().toStdString();
    settings.robots = m_robots->checkedNames();
    for (std::size_t view = 0; view < m_videos.size(); ++view) {
        const VideoRow &row = m_videos[view];
        const std::string camera = row.camera->currentText().trimmed().toStdString();
        if (camera.empty() || row.file->path().empty())
            continue;
        if (!settings.videos.empty()) // the first one that there is needs no step
            settings.steps.push_back(m_steps->step(view));
        settings.videos.emplace_back(camera, row.file->path());
    }
    if (m_givenRate->isChecked())
        settings.rate = m_rate->value();
    return settings;
}

namespace {

constexpr double highestOffsetS = 600;
using Sync = SyncBy;

} // namespace

ViewSteps::ViewSteps(QWidget *parent) : QWidget(parent), m_grid(new QGridLayout(this))
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setColumnStretch(1, 1);
}

void ViewSteps::addView()
{
    if (++m_views == 1)
        return;
    const int number = static_cast<int>(m_views);
    Row row{new ElidedLabel, new QComboBox, new NumberBox};
    row.how->addItem(tr("Automatic: motion, flash or sound"), static_cast<int>(Sync::Automatic));
    row.how->addItem(tr("By the motion"), static_cast<int>(Sync::Motion));
    row.how->addItem(tr("By a flash of light"), static_cast<int>(Sync::Flash));
    row.how->addItem(tr("By sound"), static_cast<int>(Sync::Sound));
    row.how->addItem(tr("Same start time"), static_cast<int>(Sync::None));
    row.how->addItem(tr("By hand: time offset"), static_cast<int>(Sync::Given));
    row.how->setAccessibleName(tr("How to synchronise view %1 with the first").arg(number));
    row.how->setToolTip(tr("A flash: switch the room lights on and off once while all cameras record. Sound: "
                           "clap twice near the middle of the floor"));
    row.later->setRange(-highestOffsetS, highestOffsetS);
    row.later->setDecimals(4);
    row.later->setSingleStep(0.01);
    row.later->setSuffix(tr(" s"));
    row.later->setAccessibleName(tr("Time offset of view %1").arg(number));
    row.later->setToolTip(tr("Negative: it started before the first view"));
    row.later->setEnabled(false);
    const int place = static_cast<int>(m_rows.size());
    const std::size_t view = m_rows.size() + 1;
    connect(row.how, &QComboBox::currentIndexChanged, this, [this, row, view] {
        row.later->setEnabled(row.how->currentData().toInt() == static_cast<int>(Sync::Given));
        Q_EMIT changed(view);
    });
    connect(row.later, &QDoubleSpinBox::valueChanged, this, [this, view] { Q_EMIT changed(view); });
    m_grid->addWidget(row.camera, place, 0);
    m_grid->addWidget(row.how, place, 1);
    m_grid->addWidget(row.later, place, 2);
    m_rows.push_back(row);
}

void ViewSteps::setCameras(const QStringList &cameras)
{
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const int view = static_cast<int>(i) + 1;
        const QString name = cameras.value(view).trimmed();
        m_rows[i].camera->setFullText(name.isEmpty() ? tr("View %1").arg(view + 1) : name);
    }
}

void ViewSteps::offerToKeep()
{
    for (const Row &row : m_rows)
        row.how->addItem(tr("As it is"), static_cast<int>(Sync::Kept));
}

void ViewSteps::setStep(std::size_t view, const ViewStep &step)
{
    const Row &row = m_rows[view - 1];
    row.how->setCurrentIndex(row.how->findData(static_cast<int>(step.how)));
    row.later->setValue(step.offsetS);
}

ViewStep ViewSteps::step(std::size_t view) const
{
    if (view == 0 || view > m_rows.size())
        return {};
    const Row &row = m_rows[view - 1];
    return {static_cast<Sync>(row.how->currentData().toInt()), row.later->value()};
}

QList<QWidget *> ViewSteps::fields() const
{
    QList<QWidget *> all;
    for (const Row &row : m_rows)
        all << row.how << row.later;
    return all;
}

} // namespace odo
