// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/import_trial_dialog.h"

#include "ui/main_window/check_list.h"
#include "ui/views/path_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
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
constexpr double highestOffsetS = 600;
constexpr double usualRate = 240;
} // namespace

ImportTrialDialog::ImportTrialDialog(const Offer &offer, QWidget *parent)
    : QDialog(parent), m_cameras(offer.cameras), m_name(new QLineEdit(offer.name)), m_team(new QComboBox),
      m_task(new QLineEdit), m_robots(new CheckList(tr("Robots in the trial"))), m_videoGrid(new QGridLayout),
      m_sync(new QComboBox), m_offset(new QDoubleSpinBox),
      m_rateTold(new QCheckBox(tr("Camera's real &rate"))), m_rate(new QDoubleSpinBox),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Import trial from videos"));
    m_team->setEditable(true);
    m_team->addItem(QString());
    m_team->addItems(offer.teams);
    m_robots->setNames(offer.robots, offer.robots.size() == 1);
    auto *form = new QFormLayout;
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("&Team"), m_team);
    form->addRow(tr("Tas&k"), m_task);
    form->addRow(tr("R&obots"), m_robots);
    form->addRow(tr("Videos"), makeVideos());
    form->addRow(tr("In &step"), makeStep());
    QPushButton *accept = m_buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addStretch(1);
    layout->addWidget(m_buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    resize(620, sizeHint().height());
    connect(m_name, &QLineEdit::textChanged, this, &ImportTrialDialog::updateButtons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    updateButtons();
}

QWidget *ImportTrialDialog::makeVideos()
{
    auto *widget = new QWidget;
    auto *layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    m_videoGrid->setColumnStretch(1, 1);
    m_videoGrid->addWidget(new QLabel(tr("Camera")), 0, 0);
    m_videoGrid->addWidget(new QLabel(tr("Video file")), 0, 1);
    layout->addLayout(m_videoGrid);
    auto *add = new QPushButton(tr("Add &view"));
    add->setAutoDefault(false); // Enter is the dialog's
    layout->addWidget(add, 0, Qt::AlignLeft);
    connect(add, &QPushButton::clicked, this, [this] { addVideo({}, {}); });
    for (int i = 0; i < usualViews; ++i)
        addVideo(m_cameras.value(i, QString(QChar(QLatin1Char(static_cast<char>('A' + i))))), {});
    return widget;
}

QWidget *ImportTrialDialog::makeStep()
{
    m_sync->addItem(tr("Found in the videos"), static_cast<int>(ImportSettings::Sync::Automatic));
    m_sync->addItem(tr("Begun together"), static_cast<int>(ImportSettings::Sync::None));
    m_sync->addItem(tr("Second view began later by"), static_cast<int>(ImportSettings::Sync::Told));
    m_offset->setRange(-highestOffsetS, highestOffsetS);
    m_offset->setDecimals(4);
    m_offset->setSuffix(tr(" s"));
    m_offset->setAccessibleName(tr("How much later the second view began"));
    m_rate->setRange(1, 10000);
    m_rate->setValue(usualRate);
    m_rate->setSuffix(tr(" frames/s"));
    m_rate->setAccessibleName(tr("Camera's real rate"));
    m_rateTold->setToolTip(tr("For slow motion: the file plays slower than the camera took it"));
    auto *widget = new QWidget;
    auto *layout = new QGridLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_sync, 0, 0);
    layout->addWidget(m_offset, 0, 1);
    layout->addWidget(m_rateTold, 1, 0);
    layout->addWidget(m_rate, 1, 1);
    layout->setColumnStretch(0, 1);
    connect(m_sync, &QComboBox::currentIndexChanged, this, &ImportTrialDialog::updateButtons);
    connect(m_rateTold, &QCheckBox::toggled, m_rate, &QWidget::setEnabled);
    m_rate->setEnabled(false);
    return widget;
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
    name->addItems(m_cameras);
    name->setCurrentText(camera);
    name->setAccessibleName(tr("Camera of view %1").arg(number));
    auto *path = new PathField(tr("Video of view %1").arg(number),
                               tr("Videos (*.mp4 *.mkv *.avi *.mov *.webm *.m4v);;All files (*)"));
    path->setPath(file);
    m_videoGrid->addWidget(name, number, 0);
    m_videoGrid->addWidget(path, number, 1);
    m_videos.push_back({name, path});
    connect(name, &QComboBox::editTextChanged, this, &ImportTrialDialog::updateButtons);
    connect(path, &PathField::changed, this, &ImportTrialDialog::updateButtons);
    updateButtons();
}

void ImportTrialDialog::updateButtons()
{
    m_offset->setEnabled(m_sync->currentData().toInt() == static_cast<int>(ImportSettings::Sync::Told));
    // A video without a camera would be left out in silence.
    const bool nameless = std::any_of(m_videos.begin(), m_videos.end(), [](const VideoRow &row) {
        return !row.file->path().empty() && row.camera->currentText().trimmed().isEmpty();
    });
    const bool complete = !m_name->text().trimmed().isEmpty() && !nameless && !settings().videos.empty();
    for (QAbstractButton *button : m_buttons->buttons())
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(complete);
}

ImportSettings ImportTrialDialog::settings() const
{
    ImportSettings settings;
    settings.trial = m_name->text().trimmed().toStdString();
    settings.team = m_team->currentText().trimmed().toStdString();
    settings.task = m_task->text().trimmed().toStdString();
    settings.robots = m_robots->checkedNames();
    for (const VideoRow &row : m_videos) {
        const std::string camera = row.camera->currentText().trimmed().toStdString();
        if (!camera.empty() && !row.file->path().empty())
            settings.videos.emplace_back(camera, row.file->path());
    }
    settings.sync = static_cast<ImportSettings::Sync>(m_sync->currentData().toInt());
    settings.offsetsS = {m_offset->value()};
    if (m_rateTold->isChecked())
        settings.rate = m_rate->value();
    return settings;
}

} // namespace odo
