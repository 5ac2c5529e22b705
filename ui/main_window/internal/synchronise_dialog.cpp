// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/synchronise_dialog.h"

#include "ui/main_window/internal/frame_aligner.h"
#include "ui/main_window/internal/import_dialogs.h"
#include "ui/models/explanation.h"
#include "ui/views/widgets/labels.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>
#include <utility>

namespace odo {

namespace {

QLabel *sentence(const QString &text)
{
    auto *label = new QLabel(text);
    showAsWords(*label);
    return label;
}

} // namespace

SynchroniseDialog::SynchroniseDialog(const QString &trial, const std::vector<RecordingRecord> &views,
                                     const std::vector<std::filesystem::path> &files, QWidget *parent)
    : QDialog(parent), m_steps(new ViewSteps), m_views(views), m_files(files), m_frames(new FrameAligner),
      m_chart(new SoundChart), m_soundWords(sentence(tr("The sound of the videos is being read…")))
{
    setWindowTitle(tr("Synchronise %1").arg(trial));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *accept = buttons->addButton(tr("Synchronise"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(makeSteps(views));
    auto *sound = new QWidget;
    auto *soundLayout = new QVBoxLayout(sound);
    soundLayout->addWidget(m_chart, 1);
    soundLayout->addWidget(m_soundWords);
    auto *evidence = new QTabWidget;
    evidence->setAccessibleName(tr("Frames or sound"));
    evidence->addTab(m_frames, tr("&Frames"));
    evidence->addTab(sound, tr("S&ound"));
    layout->addWidget(evidence, 1);
    layout->addWidget(sentence(tr("What was tracked in the trial is reanalysed. Choose Undo to return to the "
                                  "synchronisation that it has now.")));
    layout->addWidget(buttons);
    m_chart->setMinimumHeight(200);
    m_chart->hide();          // until there is something to compare
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    constexpr int width = 720;
    resize(width, sizeHint().height());
    m_steps->fields().constFirst()->setFocus();
    connect(m_steps, &ViewSteps::changed, this, &SynchroniseDialog::showView);
    connect(m_frames, &FrameAligner::offsetChosen, this, [this](double offsetS) {
        m_steps->setStep(m_shownFrames, {SyncBy::Given, offsetS});
    });
    connect(m_chart, &SoundChart::offsetDragged, this, [this](double offsetS) {
        m_steps->setStep(m_shownView, {SyncBy::Given, offsetS});
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    if (!m_views.empty() && !m_files.empty())
        m_frames->setFirst(m_views.front(), m_files.front());
    showFrames(1);
    readSounds(files);
}

void SynchroniseDialog::showView(std::size_t view)
{
    showSounds(view);
    showFrames(view);
}

/// Of the first view and another.
void SynchroniseDialog::showFrames(std::size_t view)
{
    if (view >= m_files.size() || view >= m_views.size())
        return;
    if (std::exchange(m_shownFrames, view) != view)
        m_frames->setOther(m_views[view], m_files[view]);
    m_frames->setOffset(m_steps->step(view).offsetS);
}

QWidget *SynchroniseDialog::makeSteps(const std::vector<RecordingRecord> &views)
{
    auto *widget = new QWidget;
    auto *form = new QFormLayout(widget);
    form->setContentsMargins(0, 0, 0, 0);
    QStringList cameras;
    for (const RecordingRecord &view : views) {
        cameras << QString::fromStdString(view.cameraName);
        m_steps->addView();
        if (view.position == 0)
            continue;
        m_steps->setStep(std::size_t(view.position), {SyncBy::Automatic, view.startOffsetS});
        auto *now = new ElidedLabel;
        now->setFullText(tr("%1 now").arg(cameras.constLast()));
        form->addRow(now, sentence(stepText(view)));
    }
    if (views.size() > 2)
        m_steps->offerToKeep();
    m_steps->setCameras(cameras);
    auto *steps = new QLabel(tr("&Synchronise"));
    steps->setBuddy(m_steps->fields().constFirst());
    form->addRow(steps, m_steps);
    return widget;
}

void SynchroniseDialog::readSounds(const std::vector<std::filesystem::path> &files)
{
    const auto read = std::make_shared<std::vector<SoundPeaks>>();
    connect(&m_reading, &BackgroundTask::finished, this, [this, read] {
        m_sounds = std::move(*read);
        showSounds(1);
    });
    m_reading.start([read, files](const JobControl &control) -> Result<void> {
        for (const std::filesystem::path &file : files) {
            const auto sound = readSound(file, control.cancel); // one that cannot be read is none
            read->push_back(sound ? peaksOf(*sound) : SoundPeaks{});
        }
        return {};
    });
}

/// Of the first view and another.
void SynchroniseDialog::showSounds(std::size_t view)
{
    if (view >= m_sounds.size())
        return; // not read yet
    const SoundPeaks &first = m_sounds.front(), &other = m_sounds[view];
    const bool areBoth = !first.peaks.empty() && !other.peaks.empty();
    m_chart->setVisible(areBoth);
    m_soundWords->setText(areBoth ? tr("Sound of the first view above, of the other one below. Drag it until "
                                       "both show the same clap at one time; the wheel zooms.")
                                  : tr("There is no sound in both views to compare."));
    m_chart->setOffset(m_steps->step(view).offsetS);
    if (areBoth && m_shownView != view)
        m_chart->setSounds({first, other});
    m_shownView = view;
}

std::vector<ViewStep> SynchroniseDialog::steps() const
{
    std::vector<ViewStep> steps;
    for (std::size_t view = 1; view < m_views.size(); ++view)
        steps.push_back(m_steps->step(view));
    return steps;
}

} // namespace odo
