// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/together/through_source_page.h"

#include "ui/testbed/floor/picture_choice.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

ThroughSourcePage::ThroughSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                                     const std::vector<CheckCamera> &registered,
                                     const LiveCameras &live, QWidget *parent)
    : QWidget(parent), m_cameras(cameras), m_registered(registered), m_camera(new QComboBox), m_through(new QComboBox),
      m_picture(new PictureChoice(live, tr("Picture or video of the camera to register"))),
      m_throughPicture(new PictureChoice(live, tr("Picture or video of the registered camera"))),
      m_same(new QLabel(tr("A camera cannot be registered through itself: choose two different ones.")))
{
    for (const FloorCamera &camera : m_cameras)
        m_camera->addItem(camera.name);
    for (const CheckCamera &camera : m_registered)
        m_through->addItem(camera.name);
    m_camera->setCurrentIndex(std::max(0, m_camera->findText(current)));
    if (m_through->currentText() == m_camera->currentText() && m_through->count() > 1)
        m_through->setCurrentIndex(1);
    m_camera->setAccessibleName(tr("Camera to register"));
    m_through->setAccessibleName(tr("Registered camera"));
    auto *intro = new QLabel(tr("A camera that sees no markers can be registered by points of the floor that a registered camera sees as "
                                "well: corners of tiles, ends of tape, screws. Four are enough, six or more spread over the common part "
                                "are better. Neither camera may be moved afterwards."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("C&amera to register"), m_camera);
    form->addRow(tr("&Through camera"), m_through);
    form->addRow(QString(), m_same);
    auto *pictures = new QHBoxLayout;
    for (const auto &[title, choice] : {std::pair(tr("Its picture"), m_picture), std::pair(tr("The registered camera's picture"), m_throughPicture)}) {
        auto *box = new QGroupBox(title);
        auto *boxLayout = new QVBoxLayout(box);
        boxLayout->addWidget(choice);
        pictures->addWidget(box, 1);
    }
    setFocusProxy(m_camera);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addSpacing(8);
    layout->addLayout(form);
    layout->addSpacing(12);
    layout->addLayout(pictures);
    layout->addStretch(1);
    for (QComboBox *box : {m_camera, m_through})
        connect(box, &QComboBox::currentIndexChanged, this, &ThroughSourcePage::showCameras);
    for (PictureChoice *choice : {m_picture, m_throughPicture})
        connect(choice, &PictureChoice::changed, this, &ThroughSourcePage::completeChanged);
    showCameras();
}

const FloorCamera &ThroughSourcePage::camera() const { return m_cameras.at(std::size_t(m_camera->currentIndex())); }
const CheckCamera &ThroughSourcePage::through() const { return m_registered.at(std::size_t(m_through->currentIndex())); }

void ThroughSourcePage::showCameras()
{
    m_picture->setRecording(camera().newestRecording);
    m_throughPicture->setRecording(through().newestRecording);
    m_same->setVisible(camera().name == through().name);
    Q_EMIT completeChanged();
}

bool ThroughSourcePage::isComplete() const
{
    return camera().name != through().name && m_picture->isComplete() && m_throughPicture->isComplete();
}

} // namespace odo
