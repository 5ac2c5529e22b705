// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/import_tracks_dialog.h"

#include "ui/main_window/internal/track_preview.h"
#include "ui/main_window/internal/track_reading_form.h"
#include "ui/views/widgets/form_fields.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

ImportTracksDialog::ImportTracksDialog(const Offer &offer, QWidget *parent)
    : QDialog(parent), m_knownRobots(offer.robots), m_name(new QLineEdit(offer.name)),
      m_team(new TeamBox(offer.teams, offer.teamsShown)), m_task(new QComboBox), m_grid(new QGridLayout),
      m_addRobot(new QPushButton(tr("Add &robot"))), m_reading(new TrackReadingForm),
      m_preview(new TrackPreview), m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Import finished tracks"));
    m_task->addItem(tr("none"), QString());
    for (const QString &task : offer.tasks)
        m_task->addItem(task, task);
    m_task->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a name may be long
    auto *words =
        new QLabel(tr("Positions measured by another program or exported by Odograph: TUM, CSV, Tracker "
                      "text and others. Odograph analyses them as a run without video."));
    words->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("Te&am"), m_team);
    form->addRow(tr("Tas&k"), m_task);
    form->addRow(tr("Tracks"), makeTracks());
    QPushButton *accept = m_buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(m_reading);
    layout->addWidget(m_preview, 1);
    layout->addWidget(m_buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    resize(620, sizeHint().height());
    connect(m_name, &QLineEdit::textChanged, this, &ImportTracksDialog::updateButtons);
    connect(m_reading, &TrackReadingForm::changed, this, &ImportTracksDialog::updatePreview);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    orderTabs();
    updateButtons();
}

bool ImportTracksDialog::isTrackFile(const QString &file)
{
    static const QStringList endings = {QStringLiteral("csv"), QStringLiteral("txt"), QStringLiteral("tum"),
                                        QStringLiteral("tsv"), QStringLiteral("trc")};
    return endings.contains(QFileInfo(file).suffix(), Qt::CaseInsensitive);
}

QWidget *ImportTracksDialog::makeTracks()
{
    auto *widget = new QWidget;
    auto *layout = new QVBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    m_grid->setColumnStretch(1, 1);
    m_grid->addWidget(new QLabel(tr("Robot")), 0, 0);
    m_grid->addWidget(new QLabel(tr("File")), 0, 1);
    layout->addLayout(m_grid);
    m_addRobot->setAutoDefault(false); // Enter is the dialog's
    layout->addWidget(m_addRobot, 0, Qt::AlignLeft);
    connect(m_addRobot, &QPushButton::clicked, this, [this] {
        addRow();
        orderTabs();
        m_tracks.back().robot->setFocus();
    });
    addRow();
    return widget;
}

void ImportTracksDialog::addRow()
{
    const int number = static_cast<int>(m_tracks.size()) + 1;
    auto *robot = new QComboBox;
    robot->setEditable(true);
    robot->addItems(m_knownRobots);
    robot->setCurrentText(
        m_knownRobots.value(number - 1, m_knownRobots.isEmpty() && number == 1 ? tr("Robot") : QString()));
    robot->setAccessibleName(tr("Robot of track %1").arg(number));
    robot->setToolTip(tr("A new name creates a new robot"));
    robot->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    robot->setMinimumContentsLength(14);
    auto *file = new PathField(tr("File of track %1").arg(number),
                               tr("Tracks (*.csv *.txt *.tum *.tsv *.trc);;All files (*)"));
    m_grid->addWidget(robot, number, 0);
    m_grid->addWidget(file, number, 1);
    m_tracks.push_back({robot, file});
    connect(robot, &QComboBox::editTextChanged, this, &ImportTracksDialog::updateButtons);
    connect(file, &PathField::changed, this, &ImportTracksDialog::updateButtons);
    connect(file, &PathField::changed, this, &ImportTracksDialog::updatePreview);
    updateButtons();
}

/// A row that was added would be reached last.
void ImportTracksDialog::orderTabs()
{
    QList<QWidget *> chain{m_task};
    for (const TrackRow &row : m_tracks)
        chain << row.robot << row.file;
    chain << m_addRobot << m_reading->fields();
    for (int i = 1; i < chain.size(); ++i)
        setTabOrder(chain.at(i - 1), chain.at(i));
}

void ImportTracksDialog::addTrack(const QString &file)
{
    if (!m_tracks.back().file->path().empty()) {
        addRow();
        orderTabs();
    }
    m_tracks.back().file->setPath(file);
}

void ImportTracksDialog::updateButtons()
{
    // A file without a robot would be left out in silence.
    const bool nameless = std::any_of(m_tracks.begin(), m_tracks.end(), [](const TrackRow &row) {
        return !row.file->path().empty() && row.robot->currentText().trimmed().isEmpty();
    });
    const bool complete = !m_name->text().trimmed().isEmpty() && !nameless && !settings().tracks.empty();
    for (QAbstractButton *button : m_buttons->buttons())
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(complete);
}

void ImportTracksDialog::updatePreview()
{
    std::vector<std::filesystem::path> files;
    for (const TrackRow &row : m_tracks)
        if (!row.file->path().empty())
            files.push_back(row.file->path());
    m_preview->show(files, m_reading->reading());
}

ImportTracksSettings ImportTracksDialog::settings() const
{
    ImportTracksSettings settings;
    settings.trial = m_name->text().trimmed().toStdString();
    settings.team = m_team->team();
    settings.task = m_task->currentData().toString().toStdString();
    settings.reading = m_reading->reading();
    settings.sigmaM = m_reading->sigmaM();
    for (const TrackRow &row : m_tracks) {
        const std::string robot = row.robot->currentText().trimmed().toStdString();
        if (!robot.empty() && !row.file->path().empty())
            settings.tracks.emplace_back(robot, row.file->path());
    }
    return settings;
}

} // namespace odo
