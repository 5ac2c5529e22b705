// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/import_lesson_dialog.h"

#include "ui/models/number_text.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <set>

namespace odo {

namespace {

constexpr int longestShown = 12; // letters of a camera's name, before it is scrolled

QTableWidgetItem *cell(const QString &text, bool isEditable = false)
{
    auto *item = new QTableWidgetItem(text);
    if (!isEditable)
        item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    return item;
}

} // namespace

ImportLessonDialog::ImportLessonDialog(const ImportTrialDialog::Offer &offer, const QStringList &taken,
                                       std::vector<ClipGroup> groups, QWidget *parent)
    : QDialog(parent), m_taken(taken), m_groups(std::move(groups)), m_task(new QComboBox),
      m_robots(new CheckList(tr("Robots in the trials"))), m_table(new QTableWidget), m_message(new QLabel)
{
    constexpr int width = 860, height = 560;
    setWindowTitle(tr("Import a lesson"));
    auto *words =
        new QLabel(tr("Clips that were recorded at the same time belong to one trial. Untick what is "
                      "no run; names and teams can be changed."));
    showAsWords(*words);
    m_task->setEditable(true);
    m_task->addItem(QString());
    m_task->addItems(offer.tasks);
    m_robots->setNames(offer.robots, offer.robots.size() == 1);
    auto *form = new QFormLayout;
    form->addRow(tr("Cameras"), makeCameras(offer));
    form->addRow(tr("Tas&k"), m_task);
    form->addRow(tr("R&obots"), m_robots);
    fill(offer);
    showAsWords(*m_message);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_accept = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_message);
    layout->addWidget(buttons);
    m_accept->setDefault(true);
    resize(width, height);
    connect(m_table, &QTableWidget::itemChanged, this, &ImportLessonDialog::updateButtons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    updateButtons();
}

QWidget *ImportLessonDialog::makeCameras(const ImportTrialDialog::Offer &offer)
{
    auto *widget = new QWidget;
    auto *row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    for (std::size_t view = 0; view < m_groups.front().views.size(); ++view) {
        auto *name = new QComboBox;
        name->setEditable(true);
        name->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        name->setMinimumContentsLength(longestShown);
        for (const ImportTrialDialog::OfferedCamera &each : offer.cameras)
            name->addItem(each.name);
        name->setCurrentText(view < offer.cameras.size()
                                 ? offer.cameras[view].name
                                 : QString(QChar(QLatin1Char(static_cast<char>('A' + view)))));
        name->setAccessibleName(tr("Camera of view %1").arg(view + 1));
        connect(name, &QComboBox::editTextChanged, this, &ImportLessonDialog::updateButtons);
        row->addWidget(name);
        m_cameras.push_back(name);
    }
    row->addStretch(1);
    return widget;
}

void ImportLessonDialog::fill(const ImportTrialDialog::Offer &offer)
{
    const int views = int(m_cameras.size());
    m_table->setColumnCount(FirstClipColumn + views);
    m_table->setRowCount(int(m_groups.size()));
    m_table->setAccessibleName(tr("Trials"));
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    QHeaderView &header = *m_table->horizontalHeader();
    header.setSectionResizeMode(QHeaderView::ResizeToContents);
    for (const int column : {TrialColumn, TeamColumn}) // what is written in
        header.setSectionResizeMode(column, QHeaderView::Stretch);
    QStringList taken = m_taken;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ClipGroup &group = m_groups[std::size_t(row)];
        taken << freeTrialName(taken);
        auto *trial = cell(taken.constLast(), true);
        trial->setFlags(trial->flags() | Qt::ItemIsUserCheckable);
        trial->setCheckState(Qt::Checked);
        m_table->setItem(row, TrialColumn, trial);
        auto *team = new TeamBox(offer.teams, offer.teamsShown);
        team->setAccessibleName(tr("Team of row %1").arg(row + 1));
        m_table->setCellWidget(row, TeamColumn, team);
        m_table->setItem(row, TimeColumn, cell(group.recorded ? shortDate(*group.recorded) : QString()));
        m_table->setItem(
            row, LengthColumn,
            cell(group.lengthS > 0 ? tr("%1 s").arg(QLocale().toString(group.lengthS, 'f', 1)) : QString()));
        for (int view = 0; view < views; ++view) {
            const QString file = QString::fromStdString(group.views[std::size_t(view)].string());
            auto *clip = cell(file.isEmpty() ? tr("no clip") : QFileInfo(file).fileName());
            clip->setToolTip(file);
            m_table->setItem(row, FirstClipColumn + view, clip);
        }
    }
}

bool ImportLessonDialog::sharesCamera(int row) const
{
    const ClipGroup &group = m_groups[std::size_t(row)];
    std::set<QString> cameras;
    for (std::size_t view = 0; view < m_cameras.size(); ++view)
        if (!group.views[view].empty() && !cameras.insert(m_cameras[view]->currentText().trimmed()).second)
            return true;
    return false;
}

QString ImportLessonDialog::missing() const
{
    for (const QComboBox *camera : m_cameras)
        if (camera->currentText().trimmed().isEmpty())
            return tr("Each column of clips needs a camera.");
    std::set<QString> trials;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QTableWidgetItem *trial = m_table->item(row, TrialColumn);
        if (trial->checkState() != Qt::Checked)
            continue;
        const QString name = trial->text().trimmed();
        if (name.isEmpty() || m_taken.contains(name) || !trials.insert(name).second)
            return tr("Each trial needs a name of its own.");
        if (sharesCamera(row))
            return tr("Two clips of %1 are of the same camera.").arg(name);
    }
    return trials.empty() ? tr("Tick the trials to import.") : QString();
}

void ImportLessonDialog::updateButtons()
{
    QStringList heads{tr("Trial"), tr("Team"), tr("Recorded"), tr("Length")};
    for (const QComboBox *camera : m_cameras)
        heads << tr("Clip of %1").arg(camera->currentText().trimmed());
    m_table->setHorizontalHeaderLabels(heads);
    const QString problem = missing();
    m_message->setText(problem);
    m_accept->setEnabled(problem.isEmpty());
}

std::vector<ImportSettings> ImportLessonDialog::settings() const
{
    std::vector<ImportSettings> all;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QTableWidgetItem *trial = m_table->item(row, TrialColumn);
        if (trial->checkState() != Qt::Checked)
            continue;
        const ClipGroup &group = m_groups[std::size_t(row)];
        ImportSettings settings;
        settings.trial = trial->text().trimmed().toStdString();
        settings.team = static_cast<TeamBox *>(m_table->cellWidget(row, TeamColumn))->team();
        settings.task = m_task->currentText().trimmed().toStdString();
        settings.robots = m_robots->checkedNames();
        for (std::size_t view = 0; view < group.views.size(); ++view)
            if (!group.views[view].empty())
                settings.videos.emplace_back(m_cameras[view]->currentText().trimmed().toStdString(),
                                             group.views[view]);
        all.push_back(std::move(settings));
    }
    return all;
}

} // namespace odo
