// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/floor_source_page.h"

#include "ui/views/path_field.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QRadioButton>
#include <QVBoxLayout>
#include <algorithm>

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

FloorSourcePage::FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current, const std::vector<LayoutRecord> &layouts,
                                 const std::vector<std::pair<QString, QString>> &live, QWidget *parent)
    : QWidget(parent), m_cameras(cameras), m_camera(new QComboBox), m_layout(new QComboBox), m_live(new QComboBox),
      m_fromRecording(new QRadioButton(tr("In the camera's &newest recording"))), m_fromLive(new QRadioButton(tr("In what a &connected camera sees now"))),
      m_fromFile(new QRadioButton(tr("In a &picture or video"))),
      m_file(new PathField(tr("Picture or video of the markers"), tr("Pictures and videos (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.mp4 *.mkv "
                                                                     "*.avi *.mov *.webm);;All files (*)"))),
      m_lens(new QLabel)
{
    m_camera->setEditable(true); // one whose lens was never measured may be new here
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    m_camera->setCurrentText(current);
    for (const LayoutRecord &layout : layouts)
        m_layout->addItem(QString::fromStdString(layout.layout.name));
    for (const auto &[name, uri] : live)
        m_live->addItem(name, uri);
    m_live->setAccessibleName(tr("Camera that is connected"));
    m_lens->setObjectName(QStringLiteral("quiet"));
    m_lens->setWordWrap(true);
    auto *intro = new QLabel(tr("Markers whose places on the floor are known tell where the camera stands. Four are enough, a fifth checks "
                                "them. Afterwards the camera must not be moved."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    form->addRow(QString(), m_lens);
    form->addRow(tr("Marker &layout"), m_layout);
    auto *where = new QLabel(tr("Where the markers are seen"));
    where->setStyleSheet(QStringLiteral("font-weight: 600"));
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addWidget(where);
    layout->addWidget(m_fromRecording);
    layout->addWidget(m_fromLive);
    layout->addLayout(indented(m_live, false));
    layout->addWidget(m_fromFile);
    layout->addLayout(indented(m_file, true));
    layout->addStretch(1);
    m_fromLive->setEnabled(!live.empty());
    for (QRadioButton *choice : {m_fromRecording, m_fromLive, m_fromFile})
        connect(choice, &QRadioButton::toggled, this, &FloorSourcePage::updateChoices);
    connect(m_camera, &QComboBox::editTextChanged, this, &FloorSourcePage::updateChoices);
    connect(m_file, &PathField::changed, this, &FloorSourcePage::completeChanged);
    (known() && known()->newestRecording ? m_fromRecording : m_fromFile)->setChecked(true);
    updateChoices();
}

const FloorCamera *FloorSourcePage::known() const
{
    const auto found = std::ranges::find(m_cameras, camera(), &FloorCamera::name);
    return found == m_cameras.end() ? nullptr : &*found;
}

void FloorSourcePage::updateChoices()
{
    const FloorCamera *camera = known();
    m_fromRecording->setEnabled(camera && camera->newestRecording);
    if (!m_fromRecording->isEnabled() && m_fromRecording->isChecked())
        m_fromFile->setChecked(true);
    m_live->setEnabled(m_fromLive->isChecked());
    m_file->setEnabled(m_fromFile->isChecked());
    m_lens->setText(camera && camera->intrinsics ? tr("Its lens is measured.")
                                                 : tr("Its lens was not measured: it is taken as free of distortion, and its focal "
                                                      "length is estimated from the markers where they tell it."));
    Q_EMIT completeChanged();
}

QString FloorSourcePage::camera() const { return m_camera->currentText().trimmed(); }
int FloorSourcePage::layout() const { return m_layout->currentIndex(); }

PictureOrigin FloorSourcePage::origin() const
{
    if (m_fromLive->isChecked())
        return {{}, m_live->currentData().toString()};
    if (m_fromFile->isChecked())
        return {textOf(m_file->path()), {}};
    return {known() && known()->newestRecording ? textOf(*known()->newestRecording) : QString(), {}};
}

void FloorSourcePage::setFile(const QString &file)
{
    m_fromFile->setChecked(true);
    m_file->setPath(file);
}

bool FloorSourcePage::isComplete() const
{
    const PictureOrigin from = origin();
    return !camera().isEmpty() && layout() >= 0 && (!from.file.isEmpty() || !from.liveUri.isEmpty());
}

} // namespace odo
