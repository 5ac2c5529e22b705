// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/together/joint_dialog.h"

#include "core/base/units.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

namespace odo {
namespace {

constexpr double usualTapeMm = 2;

QTableWidget *makeTable(const QStringList &headers, const QString &name)
{
    auto *table = new QTableWidget(0, int(headers.size()));
    table->setHorizontalHeaderLabels(headers);
    table->setAccessibleName(name);
    showAsList(*table);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(int(headers.size()) - 1, QHeaderView::Stretch);
    return table;
}

void setRow(QTableWidget &table, int row, const QStringList &texts)
{
    for (int column = 0; column < texts.size(); ++column)
        table.setItem(row, column, new QTableWidgetItem(texts[column]));
}

QString millimetres(double metres)
{
    return QLocale().toString(toMillimetres(metres), 'f', 1);
}

} // namespace

JointDialog::JointDialog(const QString &layout, Prepare prepare, QWidget *parent)
    : QDialog(parent), m_prepare(std::move(prepare)), m_tape(new NumberBox),
      m_cameras(makeTable({tr("Camera"), tr("Known to, before"), tr("Known to, together"), tr("Moves by")},
                          tr("Cameras"))),
      m_markers(makeTable({tr("Marker"), tr("Cameras"), tr("Off by, mm"), tr("Verdict")}, tr("Markers"))),
      m_verdict(new QLabel), m_advice(new QLabel)
{
    setWindowTitle(tr("Register all cameras together"));
    resize(980, 520);
    auto *intro = new QLabel(
        tr("The cameras of layout %1 are fitted again at once, by the markers they were registered with: "
           "where they see "
           "the same markers, they agree better afterwards, and a marker that was measured wrongly is found.")
            .arg(breakable(layout)));
    intro->setWordWrap(true);
    intro->setTextFormat(Qt::PlainText);
    m_tape->setRange(0.1, 100);
    m_tape->setDecimals(1);
    m_tape->setValue(usualTapeMm);
    m_tape->setSuffix(tr(" mm"));
    m_tape->setAccessibleName(tr("Error of the tape measure"));
    auto *form = new QFormLayout;
    form->addRow(tr("The markers' places were &measured to"), m_tape);
    showAsVerdict(*m_verdict, *m_advice);
    m_verdict->setAccessibleName(tr("Verdict"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    m_save = buttons->button(QDialogButtonBox::Save);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *page = new QVBoxLayout(this);
    page->addWidget(intro);
    page->addLayout(form);
    page->addWidget(makeTables(), 1);
    page->addWidget(m_verdict);
    page->addWidget(m_advice);
    page->addWidget(buttons);
    connect(m_tape, &QDoubleSpinBox::valueChanged, this, &JointDialog::fit);
    connect(&m_task, &BackgroundTask::finished, this, &JointDialog::show);
    fit();
}

JointDialog::~JointDialog() = default;

QWidget *JointDialog::makeTables()
{
    auto *both = new QWidget;
    auto *layout = new QHBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const auto &[title, table] :
         {std::pair(tr("Cameras"), m_cameras), std::pair(tr("Markers"), m_markers)}) {
        auto *card = new Card(title);
        card->setContent(table);
        layout->addWidget(card, 1);
    }
    return both;
}

void JointDialog::fit()
{
    m_save->setEnabled(false);
    m_fitAgain = m_task.isRunning();
    if (m_fitAgain)
        return;
    auto prepared = m_prepare(fromMillimetres(m_tape->value()));
    if (!prepared)
        return show(prepared.error());
    m_job = std::move(*prepared);
    m_verdict->setText(tr("Fitting the cameras together…"));
    m_advice->clear();
    m_task.start([job = m_job](const JobControl &control) { return job->run(control); });
}

void JointDialog::show(const std::optional<Error> &error)
{
    if (m_fitAgain)
        return fit();
    m_save->setEnabled(!error);
    if (error) {
        m_cameras->setRowCount(0);
        m_markers->setRowCount(0);
        m_verdict->setText(breakable(shownWords(error->why)));
        m_advice->setText(breakable(shownWords(error->advice)));
        return;
    }
    m_verdict->setText(breakable(shownWords(m_job->joint().verdict)));
    m_advice->setText(tr("What is known together reckons with the markers' places being measured to %1 mm, "
                         "which a camera that is registered by "
                         "itself takes as exact. Nothing is changed before you save; trials keep the "
                         "registration they were analysed with.")
                          .arg(QLocale().toString(m_tape->value(), 'f', 1)));
    showCameras();
    showMarkers();
}

void JointDialog::showCameras()
{
    const auto &joint = m_job->joint();
    m_cameras->setRowCount(int(joint.registrations.size()));
    for (std::size_t i = 0; i < joint.registrations.size(); ++i) {
        const FloorRegistration &before = m_job->before()[i].registration, &after = joint.registrations[i];
        const double movedM = (after.worldFromCamera.translation - before.worldFromCamera.translation).norm();
        setRow(*m_cameras, int(i),
               {QString::fromStdString(m_job->cameras()[i]),
                tr("±%1 mm").arg(millimetres(before.floorSigmaM)),
                tr("±%1 mm").arg(millimetres(after.floorSigmaM)), tr("%1 mm").arg(millimetres(movedM))});
    }
}

void JointDialog::showMarkers()
{
    const auto &markers = m_job->joint().markers;
    m_markers->setRowCount(int(markers.size()));
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const JointMarker &marker = markers[i];
        setRow(*m_markers, int(i),
               {QString::fromStdString(marker.label), QLocale().toString(marker.cameras),
                tr("%1 ± %2").arg(millimetres(marker.offM.norm()),
                                  millimetres(std::sqrt(marker.covariance.trace()))),
                marker.isSuspicious ? tr("measure it again") : tr("fits")});
    }
}

void JointDialog::done(int result)
{
    m_fitAgain = false;
    m_task.cancel();
    QDialog::done(result);
}

} // namespace odo
