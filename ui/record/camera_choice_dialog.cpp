// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/camera_choice_dialog.h"

#include "core/capture/camera_uri.h"
#include "ui/models/core_words.h"
#include "ui/models/live_cameras.h"
#include "ui/record/camera_wishes_dialog.h"
#include "ui/views/elided_label.h"
#include "ui/views/plain_button.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

CameraChoiceDialog::CameraChoiceDialog(std::vector<ChosenCamera> cameras, LiveCameras &connected,
                                       QWidget *parent)
    : QDialog(parent), m_connected(connected), m_cameras(std::move(cameras)), m_words(new QLabel),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Cameras to record with"));
    if (m_cameras.empty())
        m_cameras = {{"A", ""}, {"B", ""}};
    auto *form = new QFormLayout;
    for (const auto &[name, uri] : m_cameras) {
        auto *box = new QComboBox;
        box->setAccessibleName(tr("Device that is camera %1").arg(QString::fromStdString(name)));
        box->setMinimumContentsLength(52); // a name of a device and its picture, before they are found
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        connect(box, &QComboBox::currentIndexChanged, this, &CameraChoiceDialog::check);
        auto *settings = plainButton(tr("Settings…"));
        settings->setAccessibleName(tr("Settings of camera %1").arg(QString::fromStdString(name)));
        const std::size_t camera = m_boxes.size();
        connect(settings, &QPushButton::clicked, this, [this, camera] { askWishes(camera); });
        auto *row = new QHBoxLayout;
        row->addWidget(box, 1);
        row->addWidget(settings);
        auto *label = new ElidedLabel;
        label->setFullText(tr("Camera %1").arg(QString::fromStdString(name)));
        form->addRow(label, row);
        m_boxes.push_back(box);
        m_settings.push_back(settings);
        m_wanted[withoutWishes(uri)] = uri;
    }
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setObjectName(QStringLiteral("quiet"));
    QPushButton *look = m_buttons->addButton(tr("&Look again"), QDialogButtonBox::ActionRole);
    QPushButton *use = m_buttons->addButton(tr("Use these"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_words);
    layout->addWidget(m_buttons);
    use->setDefault(true);
    connect(look, &QPushButton::clicked, &m_connected, &LiveCameras::look);
    connect(&m_connected, &LiveCameras::changed, this, &CameraChoiceDialog::fill);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill();
    m_connected.look();
}

void CameraChoiceDialog::fill()
{
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        QComboBox &box = *m_boxes[i];
        const QSignalBlocker quiet(box);
        const QString now = box.count() > 0 ? box.currentData().toString()
                                            : QString::fromStdString(withoutWishes(m_cameras[i].second));
        box.clear();
        box.addItem(tr("not used"), QString());
        for (const CameraDescription &device : m_connected.cameras()) {
            QString words = shownDeviceName(device);
            if (!device.formats.empty())
                words += QStringLiteral(" · ") + shownWords(device.formats.front());
            if (device.busy)
                words += QStringLiteral(" · ") + tr("in use by another program");
            box.addItem(words, QString::fromStdString(device.uri));
        }
        if (!now.isEmpty() && box.findData(now) < 0)
            box.addItem(tr("%1 (not connected)").arg(now), now);
        box.setCurrentIndex(std::max(0, box.findData(now)));
    }
    check();
}

void CameraChoiceDialog::check()
{
    QSet<QString> uris;
    int used = 0;
    for (const QComboBox *box : m_boxes) {
        const QString uri = box->currentData().toString();
        used += !uri.isEmpty();
        if (!uri.isEmpty())
            uris.insert(uri);
    }
    for (std::size_t i = 0; i < m_boxes.size(); ++i)
        m_settings[i]->setEnabled(takesWishes(m_boxes[i]->currentData().toString().toStdString()));
    QString words;
    if (m_connected.isLooking())
        words = tr("Looking for cameras…");
    else if (used == 0)
        words = tr("Choose at least one camera. With two, the place of a robot is known better, and while "
                   "one cannot see it.");
    else if (uris.size() < used)
        words = tr("One device cannot be two cameras.");
    m_words->setText(words);
    for (QAbstractButton *button : m_buttons->buttons()) {
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(used > 0 && uris.size() == used);
    }
}

/// With what is wanted of it.
std::string CameraChoiceDialog::uriOf(std::size_t camera) const
{
    const std::string uri = m_boxes[camera]->currentData().toString().toStdString();
    const auto wanted = m_wanted.find(uri);
    return wanted == m_wanted.end() ? uri : wanted->second;
}

void CameraChoiceDialog::askWishes(std::size_t camera)
{
    const std::string uri = uriOf(camera);
    const auto device = std::ranges::find(m_connected.cameras(), withoutWishes(uri), &CameraDescription::uri);
    const CameraDescription known{.uri = uri, .kind = {}, .name = uri}; // one that is not connected now
    CameraWishesDialog dialog(device == m_connected.cameras().end() ? known : *device, uri, this);
    if (dialog.exec() == QDialog::Accepted)
        m_wanted[withoutWishes(uri)] = dialog.uri();
}

std::vector<ChosenCamera> CameraChoiceDialog::cameras() const
{
    std::vector<ChosenCamera> chosen = m_cameras;
    for (std::size_t i = 0; i < m_boxes.size(); ++i)
        chosen[i].second = uriOf(i);
    return chosen;
}

} // namespace odo
