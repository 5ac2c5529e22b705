// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/calibrate_dialog.h"

#include "core/base/units.h"
#include "ui/views/path_field.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace odo {
namespace {
constexpr double usualSquareMm = 25;
}

CalibrateDialog::CalibrateDialog(const QStringList &cameras, const QString &current, QWidget *parent)
    : QDialog(parent), m_camera(new QComboBox), m_files(new QListWidget),
      m_square(new QDoubleSpinBox), m_lens(new QComboBox),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Calibrate camera"));
    m_camera->setEditable(true);
    m_camera->addItems(cameras);
    m_camera->setCurrentText(current);
    m_square->setRange(1, 1000);
    m_square->setDecimals(2);
    m_square->setSuffix(tr(" mm"));
    m_square->setValue(usualSquareMm);
    m_lens->addItem(tr("Ordinary lens"), static_cast<int>(LensModel::Standard));
    m_lens->addItem(tr("Wide lens (rational model)"), static_cast<int>(LensModel::Rational));
    m_lens->addItem(tr("Fisheye"), static_cast<int>(LensModel::Fisheye));

    auto *intro =
        new QLabel(tr("Take ten or more pictures, or a video, of a flat board from different sides, tilted, "
                      "near and far, until it has been everywhere in the picture. The lens must not be "
                      "refocused or zoomed afterwards."));
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Camera"), m_camera);
    form->addRow(tr("&Pictures and videos"), makeFileList());
    form->addRow(tr("&Side of a square, measured"), m_square);
    form->addRow(tr("&Lens"), m_lens);
    QPushButton *accept = m_buttons->addButton(tr("Calibrate"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(intro);
    layout->addLayout(form, 1);
    layout->addWidget(m_buttons);
    accept->setDefault(true); // only now is it in the dialog, whose Enter key it is to have
    resize(560, 480);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_camera, &QComboBox::editTextChanged, this, &CalibrateDialog::updateButtons);
    updateButtons();
}

QWidget *CalibrateDialog::makeFileList()
{
    m_files->setAccessibleName(tr("Pictures and videos of the board"));
    m_files->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_files->setTextElideMode(Qt::ElideMiddle);
    auto *add = new QPushButton(tr("&Add…"));
    auto *remove = new QPushButton(tr("&Remove"));
    connect(add, &QPushButton::clicked, this, [this] {
        addFiles(QFileDialog::getOpenFileNames(
            this, tr("Pictures and videos of the board"), {},
            tr("Pictures and videos (*.png *.jpg *.jpeg *.tif *.tiff *.bmp *.mp4 "
               "*.mkv *.avi *.mov *.webm);;All files (*)")));
    });
    connect(remove, &QPushButton::clicked, this, [this] {
        qDeleteAll(m_files->selectedItems());
        updateButtons();
    });
    for (QPushButton *button : {add, remove})
        button->setAutoDefault(false); // Enter is the dialog's
    auto *buttons = new QVBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove);
    buttons->addStretch(1);
    auto *widget = new QWidget;
    auto *layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_files, 1);
    layout->addLayout(buttons);
    return widget;
}

void CalibrateDialog::addFiles(const QStringList &files)
{
    for (const QString &file : files)
        if (m_files->findItems(file, Qt::MatchExactly).isEmpty())
            m_files->addItem(file);
    updateButtons();
}

void CalibrateDialog::updateButtons()
{
    for (QAbstractButton *button : m_buttons->buttons())
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(m_files->count() > 0 && !m_camera->currentText().trimmed().isEmpty());
}

CalibrateSettings CalibrateDialog::settings() const
{
    CalibrateSettings settings;
    settings.camera = m_camera->currentText().trimmed().toStdString();
    for (int i = 0; i < m_files->count(); ++i)
        settings.files.push_back(pathOf(m_files->item(i)->text()));
    settings.board.squareM = fromMillimetres(m_square->value());
    settings.model = static_cast<LensModel>(m_lens->currentData().toInt());
    return settings;
}

} // namespace odo
