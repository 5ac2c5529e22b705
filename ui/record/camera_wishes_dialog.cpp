// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/camera_wishes_dialog.h"

#include "ui/models/core_words.h"
#include "ui/models/live_cameras.h"
#include "ui/views/number_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

namespace odo {
namespace {

constexpr const char *network = "aravis:";
constexpr double mostFramesPerSecond = 1000, mostExposureMs = 1000;

/// "format=MJPG&size=1280x720" of "MJPG 1280×720 at 30 frames/s"; empty where it is not of that form.
QString pictureOf(const QString &words)
{
    static const QRegularExpression form(QStringLiteral("^(\\S+) (\\d+)×(\\d+) "));
    const QRegularExpressionMatch found = form.match(words);
    return found.hasMatch() ? QStringLiteral("format=%1&size=%2x%3")
                                  .arg(found.captured(1), found.captured(2), found.captured(3))
                            : QString();
}

QDoubleSpinBox *freeNumber(double most, const QString &unit)
{
    auto *box = new NumberBox;
    box->setRange(0, most);
    box->setSuffix(QStringLiteral(" ") + unit);
    box->setSpecialValueText(CameraWishesDialog::tr("as the camera has it"));
    return box;
}

CameraWish wish(const std::string &name, const std::string &value)
{
    return {name + "=" + value, name, value};
}

std::string text(double value)
{
    return QString::number(value, 'g', 6).toStdString();
}

} // namespace

CameraWishesDialog::CameraWishesDialog(const CameraDescription &device, const std::string &uri,
                                       QWidget *parent)
    : QDialog(parent), m_uri(uri), m_onNetwork(uri.starts_with(network)), m_picture(new QComboBox),
      m_rate(freeNumber(mostFramesPerSecond, tr("frames/s"))),
      m_exposure(freeNumber(mostExposureMs, tr("ms"))),
      m_trigger(new QCheckBox(tr("Ask for each picture, so that all such cameras take theirs together")))
{
    setWindowTitle(tr("Settings of %1").arg(shownDeviceName(device)));
    addPicture(device);
    m_picture->setAccessibleName(tr("Picture"));
    m_rate->setAccessibleName(tr("Rate"));
    m_exposure->setAccessibleName(tr("Exposure"));
    m_trigger->setAccessibleName(tr("Software trigger"));
    auto *form = new QFormLayout;
    form->addRow(tr("&Picture"), m_picture);
    form->addRow(tr("&Rate"), m_rate);
    form->addRow(tr("&Exposure"), m_exposure);
    form->addRow(tr("&Trigger"), m_trigger);
    form->setRowVisible(m_exposure, m_onNetwork);
    form->setRowVisible(m_trigger, m_onNetwork);
    auto *words = new QLabel(tr("What the camera cannot do is said when it is opened."));
    words->setObjectName(QStringLiteral("quiet"));
    words->setWordWrap(true);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *use = buttons->addButton(tr("Use these"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(words);
    layout->addWidget(buttons);
    use->setDefault(true); // now that it belongs to the dialog
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showWishes(splitCameraUri(uri, m_onNetwork ? network : "v4l2:").wishes);
}

void CameraWishesDialog::addPicture(const CameraDescription &device)
{
    m_picture->addItem(tr("the best for tracking"), QString());
    if (m_onNetwork) {
        for (const char *format : {"BayerRG8", "BayerGR8", "BayerGB8", "BayerBG8", "RGB8", "BGR8", "Mono8"})
            m_picture->addItem(QString::fromLatin1(format),
                               QStringLiteral("format=%1").arg(QLatin1String(format)));
        return;
    }
    for (const std::string &format : device.formats) {
        const QString words = QString::fromStdString(format);
        if (const QString picture = pictureOf(words); !picture.isEmpty())
            m_picture->addItem(shownWords(words), picture);
    }
}

void CameraWishesDialog::showWishes(std::vector<CameraWish> wishes)
{
    QStringList picture;
    for (CameraWish &wish : wishes) {
        const double number = QString::fromStdString(wish.value).toDouble();
        if (wish.name == "rate")
            m_rate->setValue(number);
        else if (wish.name == "exposure_ms" && m_onNetwork)
            m_exposure->setValue(number);
        else if (wish.name == "trigger" && m_onNetwork)
            m_trigger->setChecked(wish.value == "software");
        else if (wish.name == "format" || (wish.name == "size" && !m_onNetwork))
            picture << QString::fromStdString(wish.text);
        else
            m_others.push_back(std::move(wish));
    }
    picture.sort(); // format, then size
    const QString wanted = picture.join(u'&');
    if (m_picture->findData(wanted) < 0)
        m_picture->addItem(picture.join(QStringLiteral(", ")), wanted);
    m_picture->setCurrentIndex(m_picture->findData(wanted));
}

std::string CameraWishesDialog::uri() const
{
    std::vector<CameraWish> wishes;
    if (const QString picture = m_picture->currentData().toString(); !picture.isEmpty())
        wishes = splitCameraUri("x:?" + picture.toStdString(), "x:").wishes;
    if (m_rate->value() > 0)
        wishes.push_back(wish("rate", text(m_rate->value())));
    if (m_exposure->value() > 0)
        wishes.push_back(wish("exposure_ms", text(m_exposure->value())));
    if (m_trigger->isChecked())
        wishes.push_back(wish("trigger", "software"));
    wishes.insert(wishes.end(), m_others.begin(), m_others.end());
    return withWishes(m_uri, wishes);
}

} // namespace odo
