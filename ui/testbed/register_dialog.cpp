// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/register_dialog.h"

#include "ui/views/path_field.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace odo {

RegisterDialog::RegisterDialog(const QStringList &cameras, const QString &current, const QStringList &layouts,
                               QWidget *parent)
    : QDialog(parent), m_camera(new QComboBox), m_layout(new QComboBox),
      m_fromRecording(new QRadioButton(tr("in the camera's &newest recording"))),
      m_fromFile(new QRadioButton(tr("in a &picture or video"))),
      m_fromPixels(new QRadioButton(tr("picked by hand, from a &table (label,u,v)"))),
      m_picture(new PathField(
          tr("Picture or video of the markers"),
          tr("Pictures and videos (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.mp4 *.mkv *.avi *.mov "
             "*.webm);;All files (*)"))),
      m_pixels(new PathField(tr("Table of the markers' pixels"), tr("Tables (*.csv *.txt);;All files (*)"))),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Register camera to the floor"));
    m_camera->setEditable(true); // a camera whose lens was never measured may be new here
    m_camera->addItems(cameras);
    m_camera->setCurrentText(current);
    m_layout->addItems(layouts);
    auto *form = new QFormLayout;
    form->addRow(tr("&Camera"), m_camera);
    form->addRow(tr("Marker &layout"), m_layout);
    auto *where = new QLabel(tr("Where the markers are seen:"));
    m_picture->setContentsMargins(24, 0, 0, 0);
    m_pixels->setContentsMargins(24, 0, 0, 0);
    QPushButton *accept = m_buttons->addButton(tr("Register"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addSpacing(6);
    layout->addWidget(where);
    layout->addWidget(m_fromRecording);
    layout->addWidget(m_fromFile);
    layout->addWidget(m_picture);
    layout->addWidget(m_fromPixels);
    layout->addWidget(m_pixels);
    layout->addStretch(1);
    layout->addWidget(m_buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    resize(520, sizeHint().height());
    m_fromRecording->setChecked(true);
    for (QRadioButton *choice : {m_fromRecording, m_fromFile, m_fromPixels})
        connect(choice, &QRadioButton::toggled, this, &RegisterDialog::updateButtons);
    connect(m_camera, &QComboBox::editTextChanged, this, &RegisterDialog::updateButtons);
    for (PathField *field : {m_picture, m_pixels})
        connect(field, &PathField::changed, this, &RegisterDialog::updateButtons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    updateButtons();
}

void RegisterDialog::updateButtons()
{
    m_picture->setEnabled(m_fromFile->isChecked());
    m_pixels->setEnabled(m_fromPixels->isChecked());
    const bool placeTold = m_fromRecording->isChecked() ||
                           (m_fromFile->isChecked() && !m_picture->path().empty()) ||
                           (m_fromPixels->isChecked() && !m_pixels->path().empty());
    for (QAbstractButton *button : m_buttons->buttons())
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(placeTold && m_layout->count() > 0 &&
                               !m_camera->currentText().trimmed().isEmpty());
}

RegisterSettings RegisterDialog::settings() const
{
    RegisterSettings settings;
    settings.camera = m_camera->currentText().trimmed().toStdString();
    settings.layout = m_layout->currentText().toStdString();
    if (m_fromFile->isChecked())
        settings.pictureFile = m_picture->path();
    if (m_fromPixels->isChecked())
        settings.pixelsFile = m_pixels->path();
    return settings;
}

} // namespace odo
