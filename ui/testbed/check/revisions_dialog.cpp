// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/revisions_dialog.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"
#include "ui/models/background_task.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/floor/marker_canvas.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

/// The image that a calibration or registration was made from, with its markers; loaded on a thread of its
/// own. Hidden if none was stored.
class RevisionImage : public MarkerCanvas
{
    Q_OBJECT
public:
    explicit RevisionImage(QWidget *parent = nullptr);
    void setRevision(const Revision &revision);

    QSize sizeHint() const override;

private:
    void read();
    void show(const std::optional<Error> &error);

    Revision m_revision;
    struct Read
    {
        std::filesystem::path file;
        QImage image;
    };
    std::shared_ptr<Read> m_read; ///< that is being read, or was last
    BackgroundTask m_task;
};

RevisionImage::RevisionImage(QWidget *parent) : MarkerCanvas(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents); // to look at
    setFocusPolicy(Qt::NoFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Source image"));
    connect(&m_task, &BackgroundTask::finished, this, &RevisionImage::show);
}

QSize RevisionImage::sizeHint() const
{
    return minimumSizeHint();
}

void RevisionImage::setRevision(const Revision &revision)
{
    m_revision = revision;
    setVisible(!revision.image.empty());
    setMarkers({});
    setImage({}, {});
    setEmptyText(tr("Reading the image…"));
    read();
}

void RevisionImage::read()
{
    if (m_revision.image.empty() || m_task.isRunning())
        return;
    m_read = std::make_shared<Read>(Read{m_revision.image, {}});
    m_task.start([read = m_read](const JobControl &) -> Result<void> {
        const auto image = ODO_TRY(readImage(read->file));
        read->image = toImage(toScreen(image, image.format.width, image.format.height));
        return {};
    });
}

void RevisionImage::show(const std::optional<Error> &error)
{
    if (m_read->file != m_revision.image) // another one was chosen meanwhile
        return read();
    if (error)
        return setEmptyText(tr("Cannot read the image."));
    setImage(m_read->image, m_read->image.size());
    setMarkers(m_revision.markers);
}

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

} // namespace

RevisionsDialog::RevisionsDialog(Project &project, const QStringList &cameras, const QString &current,
                                 QWidget *parent)
    : QDialog(parent), m_project(project), m_camera(new QComboBox),
      m_table(new QTableWidget(0, RevisionColumn::Count)), m_words(new QLabel), m_image(new RevisionImage),
      m_choose(plainButton(tr("&Use this one"))),
      m_register(plainButton(tr("&Register with this calibration"))),
      m_reprocess(plainButton(tr("Reanalyse &trials…")))
{
    setWindowTitle(tr("Calibrations and registrations"));
    m_camera->addItems(cameras);
    m_camera->setCurrentText(current);
    m_table->setHorizontalHeaderLabels(
        {tr("What"), tr("Made"), tr("Odograph"), tr("From"), tr("RMS"), tr("Trials"), tr("Current")});
    m_table->setAccessibleName(tr("Revisions"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setWordWrap(false);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setItemDelegateForColumn(RevisionColumn::State,
                                      new BadgeDelegate(stateTextRole, stateBadgeRole, this));
    m_choose->setToolTip(
        tr("Makes the selected revision the current one for new measurements; trials keep theirs"));
    m_register->setToolTip(
        tr("Recomputes the current registration from the same markers, with the current lens calibration"));
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
    detail->addWidget(m_image);
    layout->addLayout(detail);
    layout->addLayout(buttons);
    resize(1080, 560);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_choose, &QPushButton::clicked, this, &RevisionsDialog::choose);
    connect(m_register, &QPushButton::clicked, this, &RevisionsDialog::reregister);
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
        showOutcome(errorLine(revisions.error()));
    else if (m_revisions.empty())
        showOutcome(tr("The camera is neither calibrated nor registered yet."));
}

void RevisionsDialog::showRow(int row)
{
    const Revision &revision = m_revisions[std::size_t(row)];
    const bool isCalibration = revision.kind == Revision::Kind::Calibration;
    const QString rms =
        revision.rmsPx > 0 ? tr("%1 px").arg(QLocale().toString(revision.rmsPx, 'f', 2)) : QString();
    const QString texts[] = {(isCalibration ? tr("Calibration %1") : tr("Registration %1")).arg(revision.id),
                             shortDate(revision.made),
                             QString::fromStdString(revision.softwareVersion),
                             shownWords(revision.origin),
                             rms,
                             namesText(revision.trials),
                             revision.isCurrent ? tr("current") : QString()};
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
    m_register->setEnabled(isThere && m_revisions[std::size_t(row)].isCurrent &&
                           m_revisions[std::size_t(row)].kind == Revision::Kind::Calibration);
    m_reprocess->setEnabled(!m_project.trials().names().value_or(std::vector<TrialName>()).empty());
    m_image->setRevision(isThere ? m_revisions[std::size_t(row)] : Revision());
    if (!isThere)
        return showOutcome({});
    const Revision &revision = m_revisions[std::size_t(row)];
    QStringList sentences{shownWords(revision.verdict)};
    sentences << (revision.trials.empty() ? tr("No trial uses it.")
                                          : tr("Trials that use it: %1.").arg(namesText(revision.trials)));
    sentences.removeAll(QString());
    showOutcome(sentences.join(QLatin1Char(' ')));
}

void RevisionsDialog::choose()
{
    const int row = m_table->currentRow();
    if (row < 0 || row >= int(m_revisions.size()))
        return;
    const Revision revision = m_revisions[std::size_t(row)];
    const auto chosen =
        chooseRevision(m_project, m_camera->currentText().toStdString(), revision.kind, revision.id);
    m_hasChanged = m_hasChanged || chosen.has_value();
    refresh();
    const QString name = m_table->item(row, RevisionColumn::Kind)->text();
    if (!chosen)
        showOutcome(errorLine(chosen.error()));
    else if (revision.kind == Revision::Kind::Calibration)
        showOutcome(
            tr("%1 is now current. The registrations keep the lens calibration that they were made with: "
               "register the camera with this one.")
                .arg(name));
    else
        showOutcome(tr("%1 is now current. Trials keep theirs until you reanalyse them.").arg(name));
}

void RevisionsDialog::reregister()
{
    const auto registered = registerWithCurrentIntrinsics(m_project, m_camera->currentText().toStdString());
    m_hasChanged = m_hasChanged || registered.has_value();
    refresh();
    showOutcome(registered
                    ? tr("Registration %1 is now current: the same markers, with this lens calibration. %2")
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

void RevisionsDialog::showOutcome(const QString &words)
{
    m_words->setText(breakable(words));
}

namespace {

struct ReprocessColumn
{
    enum { Robot, Metric, Before, After, Change, Count };
};

QString number(const std::optional<double> &value, const MetricChange &metric)
{
    return value ? metricNumber({metric.name, metric.unit, *value, metric.sigma}).text()
                 : QStringLiteral("–");
}

/// With its sign; no more digits than the values have, and a word if none of them changes.
QString difference(const MetricChange &metric)
{
    if (!metric.before || !metric.after)
        return {};
    const double change = *metric.after - *metric.before;
    NumberText text = metricNumber({metric.name, metric.unit, std::abs(change), metric.sigma});
    text.sigma.clear();
    static const QRegularExpression anyDigit(QStringLiteral("[1-9]"));
    if (!text.value.contains(anyDigit))
        return ReprocessDialog::tr("none");
    return (change < 0 ? QStringLiteral("−") : QStringLiteral("+")) + text.text();
}

} // namespace

ReprocessDialog::ReprocessDialog(Project &project, QWidget *parent)
    : QDialog(parent), m_project(project), m_trial(new QComboBox),
      m_table(new QTableWidget(0, ReprocessColumn::Count)), m_words(new QLabel),
      m_begin(plainButton(tr("&Reanalyse"))), m_keep(plainButton(tr("&Keep"))), m_runner(project)
{
    setWindowTitle(tr("Reanalyse trials"));
    m_table->setHorizontalHeaderLabels({tr("Robot"), tr("Metric"), tr("Before"), tr("After"), tr("Change")});
    m_table->setAccessibleName(tr("What changes"));
    showAsList(*m_table);
    m_table->horizontalHeader()->setStretchLastSection(true);
    showAsWords(*m_words);
    m_words->setAccessibleName(tr("What changes, in words"));
    auto *intro = new QLabel(tr("What was detected in the videos stays as it is; its floor positions are "
                                "recomputed with the current registrations. Check what changes, then keep it "
                                "or not: the older analysis stays in the project too."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Trial"), m_trial);
    auto *close = plainButton(tr("Close"));
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_begin);
    buttons->addStretch(1);
    buttons->addWidget(m_keep);
    buttons->addWidget(close);
    m_begin->setDefault(true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(intro);
    layout->addLayout(form);
    layout->addWidget(m_words);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
    resize(760, 560);
    fillTrials();
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_begin, &QPushButton::clicked, this, &ReprocessDialog::begin);
    connect(m_keep, &QPushButton::clicked, this, &ReprocessDialog::keep);
    connect(m_trial, &QComboBox::currentIndexChanged, this, &ReprocessDialog::forget);
    connect(&m_runner, &JobRunner::finished, this, &ReprocessDialog::finish);
    forget();
}

ReprocessDialog::~ReprocessDialog() = default;

void ReprocessDialog::fillTrials()
{
    const std::vector<std::string> outdated = outdatedTrials(m_project).value_or(std::vector<std::string>());
    const QString current = m_trial->currentData().toString();
    const QSignalBlocker quiet(m_trial);
    m_trial->clear();
    for (const TrialName &trial : m_project.trials().names().value_or(std::vector<TrialName>())) {
        const QString name = QString::fromStdString(trial.name);
        const bool isOld = std::ranges::find(outdated, trial.name) != outdated.end();
        // Those that a newer registration concerns come first.
        m_trial->insertItem(isOld ? 0 : m_trial->count(),
                            isOld ? tr("%1 (measured with an older registration)").arg(name) : name, name);
    }
    m_trial->setCurrentIndex(std::max(0, m_trial->findData(current)));
}

void ReprocessDialog::forget()
{
    m_done.reset();
    m_table->setRowCount(0);
    m_words->clear();
    m_keep->setEnabled(false);
    m_begin->setEnabled(!m_runner.isRunning() && m_trial->count() > 0);
}

void ReprocessDialog::begin()
{
    forget();
    m_begin->setEnabled(false);
    m_trial->setEnabled(false);
    m_words->setText(tr("Measuring…"));
    m_runner.start(std::make_shared<ReprocessJob>(m_trial->currentData().toString().toStdString()));
}

void ReprocessDialog::finish(const std::shared_ptr<Job> &job, const std::optional<Error> &error)
{
    forget();
    m_trial->setEnabled(true);
    m_begin->setEnabled(true);
    if (error)
        return m_words->setText(errorLine(*error));
    m_done = std::static_pointer_cast<ReprocessJob>(job);
    showChanges();
    m_keep->setEnabled(true);
}

void ReprocessDialog::showChanges()
{
    QStringList sentences;
    for (const ReprocessedRobot &robot : m_done->robots()) {
        const QString name = QString::fromStdString(robot.name);
        sentences << tr("%1: %2").arg(name, shownWords(robot.change.words));
        for (const MetricChange &metric : robot.change.metrics)
            addMetric(name, metric);
    }
    m_words->setText(sentences.join(QLatin1Char('\n')));
    m_table->resizeColumnsToContents();
}

void ReprocessDialog::addMetric(const QString &robot, const MetricChange &metric)
{
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    const QString texts[] = {robot, metricName(metric.name), number(metric.before, metric),
                             number(metric.after, metric), difference(metric)};
    for (int column = 0; column < ReprocessColumn::Count; ++column)
        m_table->setItem(row, column, new QTableWidgetItem(texts[column]));
}

void ReprocessDialog::keep()
{
    const auto kept = m_done->keep(m_project);
    const QString trial = QString::fromStdString(m_done->trial());
    m_hasKept = m_hasKept || kept.has_value();
    fillTrials();
    m_done.reset();
    m_keep->setEnabled(false);
    m_words->setText(kept ? tr("Kept: the new analysis of %1 is the current one.").arg(trial)
                          : errorLine(kept.error()));
}

void ReprocessDialog::done(int result)
{
    m_runner.cancel();
    QDialog::done(result);
}

} // namespace odo

#include "revisions_dialog.moc"
