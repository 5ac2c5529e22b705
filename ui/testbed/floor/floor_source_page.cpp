// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/floor/floor_source_page.h"

#include "ui/testbed/floor/picture_choice.h"
#include "ui/views/badge_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

FloorSourcePage::FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current, const std::vector<LayoutRecord> &layouts,
                                 const LiveCameras &live, QWidget *parent)
    : QWidget(parent), m_cameras(cameras), m_camera(new QComboBox), m_layout(new QComboBox),
      m_picture(new PictureChoice(live, tr("Picture or video of the markers"))), m_lens(new QLabel), m_badge(new BadgeLabel({}))
{
    m_camera->setEditable(true); // one whose lens was never measured may be new here
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    m_camera->setCurrentText(current);
    for (const LayoutRecord &layout : layouts)
        m_layout->addItem(QString::fromStdString(layout.layout.name));
    m_lens->setObjectName(QStringLiteral("quiet"));
    m_lens->setWordWrap(true);
    auto *intro = new QLabel(tr("Markers whose places on the floor are known tell where the camera stands. Four are enough, a fifth checks "
                                "them. Afterwards the camera must not be moved."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera"), m_camera);
    form->addRow(QString(), m_badge);
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
    layout->addWidget(m_picture);
    layout->addStretch(1);
    connect(m_camera, &QComboBox::editTextChanged, this, &FloorSourcePage::showCamera);
    connect(m_picture, &PictureChoice::changed, this, &FloorSourcePage::completeChanged);
    showCamera();
}

const FloorCamera *FloorSourcePage::known() const
{
    const auto found = std::ranges::find(m_cameras, camera(), &FloorCamera::name);
    return found == m_cameras.end() ? nullptr : &*found;
}

void FloorSourcePage::showCamera()
{
    const FloorCamera *camera = known();
    m_badge->setBadge(camera ? camera->badge : Badge());
    m_picture->setRecording(camera ? camera->newestRecording : std::nullopt);
    m_lens->setText(camera && camera->intrinsics ? tr("Its lens is measured.")
                                                 : tr("Its lens was not measured: it is taken as free of distortion, and its focal "
                                                      "length is estimated from the markers where they tell it."));
    Q_EMIT completeChanged();
}

QString FloorSourcePage::camera() const { return m_camera->currentText().trimmed(); }
int FloorSourcePage::layout() const { return m_layout->currentIndex(); }

PictureOrigin FloorSourcePage::origin() const { return m_picture->origin(); }
void FloorSourcePage::setFile(const QString &file) { m_picture->setFile(file); }
bool FloorSourcePage::isComplete() const { return !camera().isEmpty() && layout() >= 0 && m_picture->isComplete(); }

} // namespace odo
