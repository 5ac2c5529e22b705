// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/picture_choice.h"

#include "ui/views/live_camera_box.h"
#include "ui/views/path_field.h"

#include <QHBoxLayout>
#include <QRadioButton>
#include <QVBoxLayout>

namespace odo {
namespace {

constexpr int indent = 24;

QHBoxLayout *indented(QWidget *widget, bool stretched)
{
    auto *row = new QHBoxLayout;
    row->setContentsMargins(indent, 0, 0, 0);
    row->addWidget(widget, stretched ? 1 : 0);
    if (!stretched)
        row->addStretch(1);
    return row;
}

} // namespace

PictureChoice::PictureChoice(const LiveCameras &live, const QString &fileName, QWidget *parent)
    : QWidget(parent), m_fromRecording(new QRadioButton(tr("In the camera's &newest recording"))),
      m_fromLive(new QRadioButton(tr("In what a &connected camera sees now"))), m_fromFile(new QRadioButton(tr("In a &picture or video"))),
      m_live(new LiveCameraBox(live)),
      m_file(new PathField(fileName, tr("Pictures and videos (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov "
                                        "*.webm);;All files (*)")))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_fromRecording);
    layout->addWidget(m_fromLive);
    layout->addLayout(indented(m_live, false));
    layout->addWidget(m_fromFile);
    layout->addLayout(indented(m_file, true));
    setFocusProxy(m_fromRecording);
    m_fromFile->setChecked(true);
    for (QRadioButton *choice : {m_fromRecording, m_fromLive, m_fromFile})
        connect(choice, &QRadioButton::toggled, this, &PictureChoice::updateChoices);
    connect(m_live, &QComboBox::currentIndexChanged, this, &PictureChoice::updateChoices);
    connect(m_file, &PathField::changed, this, &PictureChoice::changed);
    updateChoices();
}

void PictureChoice::setRecording(const std::optional<std::filesystem::path> &file)
{
    m_recording = file;
    if (m_recording && m_fromFile->isChecked() && m_file->path().empty())
        m_fromRecording->setChecked(true);
    updateChoices();
}

void PictureChoice::updateChoices()
{
    m_fromRecording->setEnabled(m_recording.has_value());
    m_fromLive->setEnabled(!m_live->uri().isEmpty() || m_fromLive->isChecked());
    if (!m_recording && m_fromRecording->isChecked())
        m_fromFile->setChecked(true);
    m_live->setEnabled(m_fromLive->isChecked());
    m_file->setEnabled(m_fromFile->isChecked());
    Q_EMIT changed();
}

PictureOrigin PictureChoice::origin() const
{
    if (m_fromLive->isChecked())
        return {{}, m_live->uri()};
    if (m_fromFile->isChecked())
        return {textOf(m_file->path()), {}};
    return {m_recording ? textOf(*m_recording) : QString(), {}};
}

void PictureChoice::setFile(const QString &file)
{
    m_fromFile->setChecked(true);
    m_file->setPath(file);
}

bool PictureChoice::isComplete() const
{
    const PictureOrigin from = origin();
    return !from.file.isEmpty() || !from.liveUri.isEmpty();
}

} // namespace odo
