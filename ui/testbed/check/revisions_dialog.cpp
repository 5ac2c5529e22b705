// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/revisions_dialog.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/register_job.h"
#include "ui/models/badge.h"
#include "ui/models/breakable_text.h"
#include "ui/models/core_words.h"
#include "ui/models/error_words.h"
#include "ui/testbed/check/reprocess_dialog.h"
#include "ui/testbed/check/revision_picture.h"
#include "ui/views/badge_delegate.h"
#include "ui/views/plain_button.h"
#include "ui/views/table_list.h"
#include "ui/views/words_label.h"

#include <QComboBox>
#include <QDateTime>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

namespace odo {
namespace {

struct RevisionColumn
{
    enum { Kind, Date, Version, Origin, Rms, Trials, State, Count };
};
constexpr int stateTextRole = Qt::UserRole, stateBadgeRole = Qt::UserRole + 1;

QString namesText(const std::vector<std::string> &names)
{
    QStringList texts;
    for (const std::string &name : names)
        texts << QString::fromStdString(name);
    return texts.join(QStringLiteral(", "));
}

QString dateText(Instant instant)
{
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(instant.time_since_epoch().count()), QLocale::ShortFormat);
}

} // namespace

RevisionsDialog::RevisionsDialog(Project &project, const QStringList &cameras, const QString &current,
                                 QWidget *parent)
    : QDialog(parent), m_project(project), m_camera(new QComboBox),
      m_table(new QTableWidget(0, RevisionColumn::Count)), m_words(new QLabel),
      m_picture(new RevisionPicture), m_choose(plainButton(tr("&Use this one"))),
      m_register(plainButton(tr("&Register with this lens"))),
      m_reprocess(plainButton(tr("&Measure trials again…")))
{
    setWindowTitle(tr("Calibrations and registrations"));
    m_camera->addItems(cameras);
    m_camera->setCurrentText(current);
    m_table->setHorizontalHeaderLabels({tr("What"), tr("Made"), tr("Odograph"), tr("From"), tr("RMS"), tr("Trials"), tr("In force")});
    m_table->setAccessibleName(tr("Revisions"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setWordWrap(false);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setItemDelegateForColumn(RevisionColumn::State,
                                      new BadgeDelegate(stateTextRole, stateBadgeRole, this));
    m_choose->setToolTip(tr("Puts the chosen revision in force for what is measured from now on; trials keep theirs"));
    m_register->setToolTip(tr("Computes the registration in force anew from the same markers, with the lens in force"));
    showAsWords(*m_words);
    m_words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_words->setMinimumHeight(4 * m_words->fontMetrics().lineSpacing());
    m_words->setAccessibleName(tr("Verdict"));
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    auto *close = plainButton(tr("Close"));
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_choose);
    buttons->addWidget(m_register);
    buttons->addWidget(m_reprocess);
    buttons->addStretch(1);
    buttons->addWidget(close);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addLayout(form);
    layout->addWidget(m_table, 1);
    auto *detail = new QHBoxLayout;
    detail->addWidget(m_words, 1);
    detail->addWidget(m_picture);
    layout->addLayout(detail);
    layout->addLayout(buttons);
    resize(1080, 560);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_choose, &QPushButton::clicked, this, &RevisionsDialog::choose);
    connect(m_register, &QPushButton::clicked, this, &RevisionsDialog::registerAnew);
    connect(m_reprocess, &QPushButton::clicked, this, &RevisionsDialog::reprocess);
    connect(m_camera, &QComboBox::currentIndexChanged, this, &RevisionsDialog::refresh);
    connect(m_table, &QTableWidget::currentCellChanged, this, &RevisionsDialog::showCurrent);
    refresh();
    m_table->setFocus();
}

RevisionsDialog::~RevisionsDialog() = default;

void RevisionsDialog::refresh()
{
    const int row = m_table->currentRow();
    auto revisions = revisionsOf(m_project, m_camera->currentText().toStdString());
    m_revisions = revisions.value_or(std::vector<Revision>());
    {
        const QSignalBlocker quiet(m_table);
        m_table->setRowCount(int(m_revisions.size()));
        for (int i = 0; i < m_table->rowCount(); ++i)
            showRow(i);
        m_table->resizeColumnsToContents();
        m_table->setColumnWidth(RevisionColumn::Trials,
                                std::min(190, m_table->columnWidth(RevisionColumn::Trials)));
        m_table->selectRow(std::clamp(row, 0, std::max(0, m_table->rowCount() - 1)));
    }
    showCurrent();
    if (!revisions)
        tell(errorLine(revisions.error()));
    else if (m_revisions.empty())
        tell(tr("The camera is neither calibrated nor registered yet."));
}

void RevisionsDialog::showRow(int row)
{
    const Revision &revision = m_revisions[std::size_t(row)];
    const bool isCalibration = revision.kind == Revision::Kind::Calibration;
    const QString rms = revision.rmsPx > 0 ? tr("%1 px").arg(QLocale().toString(revision.rmsPx, 'f', 2)) : QString();
    const QString texts[] = {(isCalibration ? tr("Calibration %1") : tr("Registration %1")).arg(revision.id),
                             dateText(revision.made),
                             QString::fromStdString(revision.softwareVersion),
                             shownWords(revision.origin),
                             rms,
                             namesText(revision.trials),
                             revision.isCurrent ? tr("in force") : QString()};
    for (int column = 0; column < RevisionColumn::Count; ++column)
        m_table->setItem(row, column, new QTableWidgetItem(texts[column]));
    m_table->item(row, RevisionColumn::Trials)->setToolTip(texts[RevisionColumn::Trials].toHtmlEscaped());
    m_table->item(row, RevisionColumn::State)->setData(stateTextRole, texts[RevisionColumn::State]);
    m_table->item(row, RevisionColumn::State)->setData(stateBadgeRole, int(BadgeState::Good));
}

void RevisionsDialog::showCurrent()
{
    const int row = m_table->currentRow();
    const bool isThere = row >= 0 && row < int(m_revisions.size());
    m_choose->setEnabled(isThere && !m_revisions[std::size_t(row)].isCurrent);
    m_register->setEnabled(isThere && m_revisions[std::size_t(row)].isCurrent && m_revisions[std::size_t(row)].kind == Revision::Kind::Calibration);
    m_reprocess->setEnabled(!m_project.trials().names().value_or(std::vector<TrialName>()).empty());
    m_picture->setRevision(isThere ? m_revisions[std::size_t(row)] : Revision());
    if (!isThere)
        return tell({});
    const Revision &revision = m_revisions[std::size_t(row)];
    QStringList sentences{shownWords(revision.verdict)};
    sentences << (revision.trials.empty() ? tr("No trial was measured with it.") : tr("Trials measured with it: %1.").arg(namesText(revision.trials)));
    sentences.removeAll(QString());
    tell(sentences.join(QLatin1Char(' ')));
}

void RevisionsDialog::choose()
{
    const int row = m_table->currentRow();
    if (row < 0 || row >= int(m_revisions.size()))
        return;
    const Revision revision = m_revisions[std::size_t(row)];
    const auto chosen = chooseRevision(m_project, m_camera->currentText().toStdString(), revision.kind, revision.id);
    m_hasChanged = m_hasChanged || chosen.has_value();
    refresh();
    const QString name = m_table->item(row, RevisionColumn::Kind)->text();
    if (!chosen)
        tell(errorLine(chosen.error()));
    else if (revision.kind == Revision::Kind::Calibration)
        tell(tr("%1 is in force. The registrations keep the lens that they were made with: register the camera with this one.").arg(name));
    else
        tell(tr("%1 is in force. Trials keep theirs until they are measured again.").arg(name));
}

void RevisionsDialog::registerAnew()
{
    const auto registered = registerWithLensInForce(m_project, m_camera->currentText().toStdString());
    m_hasChanged = m_hasChanged || registered.has_value();
    refresh();
    tell(registered ? tr("Registration %1 is in force: the same markers, with this lens. %2")
                          .arg(registered->id)
                          .arg(shownWords(registered->registration.verdict))
                    : errorLine(registered.error()));
}

void RevisionsDialog::reprocess()
{
    ReprocessDialog dialog(m_project, this);
    dialog.exec();
    if (!dialog.hasKept())
        return;
    m_hasChanged = true;
    refresh();
}

void RevisionsDialog::tell(const QString &words) { m_words->setText(breakable(words)); }

} // namespace odo
