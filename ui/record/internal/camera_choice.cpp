// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/camera_choice.h"

#include "core/capture/camera_source.h"
#include "ui/models/camera_lists.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

namespace odo {

namespace {

const QString group = QStringLiteral("record/cameras");
const std::string simulated = "sim:";

bool isReal(const CameraDescription &device)
{
    return device.kind != "simulated";
}

} // namespace

std::vector<ChosenCamera> proposeCameras(const std::vector<CameraRecord> &cameras,
                                         const std::vector<CameraDescription> &connected,
                                         const std::map<std::string, std::string> &before)
{
    std::vector<ChosenCamera> chosen;
    for (const CameraRecord &camera : cameras)
        chosen.emplace_back(camera.name, "");
    if (chosen.empty()) {
        const auto real = std::ranges::count_if(connected, isReal);
        for (std::ptrdiff_t i = 0; i < std::min<std::ptrdiff_t>(2, real); ++i)
            chosen.emplace_back(std::string(1, char('A' + i)), "");
    }
    std::set<std::string> free;
    for (const CameraDescription &device : connected) {
        if (!device.busy) // else another program has it
            free.insert(device.uri);
    }
    const auto give = [&](ChosenCamera &camera, const std::string &uri) {
        if (camera.second.empty() && free.erase(withoutSettings(uri)) > 0)
            camera.second = uri;
    };
    for (std::size_t i = 0; i < cameras.size(); ++i)
        give(chosen[i], cameras[i].deviceUri);
    for (ChosenCamera &camera : chosen) {
        if (const auto was = before.find(camera.first);
            was != before.end() && !was->second.starts_with(simulated))
            give(camera, was->second);
    }
    for (ChosenCamera &camera : chosen) {
        for (const CameraDescription &device : connected) {
            if (isReal(device))
                give(camera, device.uri);
        }
    }
    return chosen;
}

std::map<std::string, std::string> rememberedCameras()
{
    QSettings settings;
    settings.beginGroup(group);
    std::map<std::string, std::string> before;
    for (const QString &name : settings.childKeys())
        before[name.toStdString()] = settings.value(name).toString().toStdString();
    return before;
}

void rememberCameras(const std::vector<ChosenCamera> &cameras)
{
    QSettings settings;
    settings.beginGroup(group);
    for (const auto &[name, uri] : cameras)
        settings.setValue(QString::fromStdString(name), QString::fromStdString(uri));
}

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
        box->setAccessibleName(tr("Device for camera %1").arg(QString::fromStdString(name)));
        box->setMinimumContentsLength(52); // a device name and its format, before they are known
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        connect(box, &QComboBox::currentIndexChanged, this, &CameraChoiceDialog::check);
        auto *settings = plainButton(tr("Settings…"));
        settings->setAccessibleName(tr("Settings of camera %1").arg(QString::fromStdString(name)));
        const std::size_t camera = m_boxes.size();
        connect(settings, &QPushButton::clicked, this, [this, camera] { askSettings(camera); });
        auto *row = new QHBoxLayout;
        row->addWidget(box, 1);
        row->addWidget(settings);
        auto *label = new ElidedLabel;
        label->setFullText(tr("Camera %1").arg(QString::fromStdString(name)));
        form->addRow(label, row);
        m_boxes.push_back(box);
        m_settings.push_back(settings);
        m_wanted[withoutSettings(uri)] = uri;
    }
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::PlainText);
    m_words->setObjectName(QStringLiteral("quiet"));
    QPushButton *searchButton = m_buttons->addButton(tr("&Search again"), QDialogButtonBox::ActionRole);
    QPushButton *use = m_buttons->addButton(tr("Use these"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_words);
    layout->addWidget(m_buttons);
    use->setDefault(true);
    connect(searchButton, &QPushButton::clicked, &m_connected, &LiveCameras::poll);
    connect(&m_connected, &LiveCameras::changed, this, &CameraChoiceDialog::fill);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill();
    m_connected.poll();
}

void CameraChoiceDialog::fill()
{
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        QComboBox &box = *m_boxes[i];
        const QSignalBlocker quiet(box);
        const QString now = box.count() > 0 ? box.currentData().toString()
                                            : QString::fromStdString(withoutSettings(m_cameras[i].second));
        box.clear();
        box.addItem(tr("not used"), QString());
        for (const CameraDescription &device : m_connected.cameras()) {
            QString words = shownWords(device.name);
            if (!device.formats.empty())
                words += QStringLiteral(" · ") + shownWords(device.formats.front().words);
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
        m_settings[i]->setEnabled(acceptsSettings(m_boxes[i]->currentData().toString().toStdString()));
    QString words;
    if (m_connected.isSearching())
        words = tr("Searching for cameras…");
    else if (used == 0)
        words = tr("Choose at least one camera. Two cameras locate a robot more accurately, and if one "
                   "cannot see it, the other often can.");
    else if (uris.size() < used)
        words = tr("You cannot use one device as two cameras.");
    m_words->setText(words);
    for (QAbstractButton *button : m_buttons->buttons()) {
        if (m_buttons->buttonRole(button) == QDialogButtonBox::AcceptRole)
            button->setEnabled(used > 0 && uris.size() == used);
    }
}

/// With its requested settings.
std::string CameraChoiceDialog::uriOf(std::size_t camera) const
{
    const std::string uri = m_boxes[camera]->currentData().toString().toStdString();
    const auto wanted = m_wanted.find(uri);
    return wanted == m_wanted.end() ? uri : wanted->second;
}

void CameraChoiceDialog::askSettings(std::size_t camera)
{
    const std::string uri = uriOf(camera);
    const auto device =
        std::ranges::find(m_connected.cameras(), withoutSettings(uri), &CameraDescription::uri);
    const CameraDescription known{
        .uri = uri, .kind = {}, .name = nameAlone(uri)}; // one that is not connected now
    CameraSettingsDialog dialog(device == m_connected.cameras().end() ? known : *device, uri, this);
    if (dialog.exec() == QDialog::Accepted)
        m_wanted[withoutSettings(uri)] = dialog.uri();
}

std::vector<ChosenCamera> CameraChoiceDialog::cameras() const
{
    std::vector<ChosenCamera> chosen = m_cameras;
    for (std::size_t i = 0; i < m_boxes.size(); ++i)
        chosen[i].second = uriOf(i);
    return chosen;
}

namespace {

constexpr const char *network = "aravis:";
constexpr double mostFramesPerSecond = 1000, mostExposureMs = 1000;

/// "format=MJPG&size=1280x720"
QString frameFormatOf(const CameraFormat &format)
{
    return QStringLiteral("format=%1&size=%2x%3")
        .arg(QString::fromStdString(format.coding))
        .arg(format.widthPx)
        .arg(format.heightPx);
}

QDoubleSpinBox *freeNumber(double most, const QString &unit)
{
    auto *box = new NumberBox;
    box->setRange(0, most);
    box->setSuffix(QStringLiteral(" ") + unit);
    box->setSpecialValueText(CameraSettingsDialog::tr("set by the camera"));
    return box;
}

CameraSetting setting(const std::string &name, const std::string &value)
{
    return {name + "=" + value, name, value};
}

std::string text(double value)
{
    return QString::number(value, 'g', 6).toStdString();
}

} // namespace

CameraSettingsDialog::CameraSettingsDialog(const CameraDescription &device, const std::string &uri,
                                           QWidget *parent)
    : QDialog(parent), m_uri(uri), m_onNetwork(uri.starts_with(network)), m_frameFormat(new QComboBox),
      m_rate(freeNumber(mostFramesPerSecond, tr("frames/s"))),
      m_exposure(freeNumber(mostExposureMs, tr("ms"))),
      m_trigger(new QCheckBox(
          tr("Trigger each frame by software, at the same time for all cameras with this setting")))
{
    setWindowTitle(tr("Settings of %1").arg(shownWords(device.name)));
    addFrameFormat(device);
    m_frameFormat->setAccessibleName(tr("Format"));
    m_rate->setAccessibleName(tr("Rate"));
    m_exposure->setAccessibleName(tr("Exposure"));
    m_trigger->setAccessibleName(tr("Software trigger"));
    auto *form = new QFormLayout;
    form->addRow(tr("&Format"), m_frameFormat);
    form->addRow(tr("&Rate"), m_rate);
    form->addRow(tr("&Exposure"), m_exposure);
    form->addRow(tr("&Trigger"), m_trigger);
    form->setRowVisible(m_exposure, m_onNetwork);
    form->setRowVisible(m_trigger, m_onNetwork);
    auto *words =
        new QLabel(tr("If the camera does not support a setting, a message says so when it opens."));
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
    showSettings(splitCameraUri(uri, m_onNetwork ? network : "v4l2:").cameraSettings);
}

void CameraSettingsDialog::addFrameFormat(const CameraDescription &device)
{
    m_frameFormat->addItem(tr("best for tracking"), QString());
    if (m_onNetwork) {
        for (const char *format : {"BayerRG8", "BayerGR8", "BayerGB8", "BayerBG8", "RGB8", "BGR8", "Mono8"})
            m_frameFormat->addItem(QString::fromLatin1(format),
                                   QStringLiteral("format=%1").arg(QLatin1String(format)));
        return;
    }
    for (const CameraFormat &format : device.formats)
        if (!format.coding.empty())
            m_frameFormat->addItem(shownWords(format.words), frameFormatOf(format));
}

void CameraSettingsDialog::showSettings(std::vector<CameraSetting> cameraSettings)
{
    QStringList frameFormat;
    for (CameraSetting &setting : cameraSettings) {
        const double number = QString::fromStdString(setting.value).toDouble();
        if (setting.name == "rate")
            m_rate->setValue(number);
        else if (setting.name == "exposure_ms" && m_onNetwork)
            m_exposure->setValue(number);
        else if (setting.name == "trigger" && m_onNetwork)
            m_trigger->setChecked(setting.value == "software");
        else if (setting.name == "format" || (setting.name == "size" && !m_onNetwork))
            frameFormat << QString::fromStdString(setting.text);
        else
            m_others.push_back(std::move(setting));
    }
    frameFormat.sort(); // format, then size
    const QString wanted = frameFormat.join(u'&');
    if (m_frameFormat->findData(wanted) < 0)
        m_frameFormat->addItem(frameFormat.join(QStringLiteral(", ")), wanted);
    m_frameFormat->setCurrentIndex(m_frameFormat->findData(wanted));
}

std::string CameraSettingsDialog::uri() const
{
    std::vector<CameraSetting> cameraSettings;
    if (const QString frameFormat = m_frameFormat->currentData().toString(); !frameFormat.isEmpty())
        cameraSettings = splitCameraUri("x:?" + frameFormat.toStdString(), "x:").cameraSettings;
    if (m_rate->value() > 0)
        cameraSettings.push_back(setting("rate", text(m_rate->value())));
    if (m_exposure->value() > 0)
        cameraSettings.push_back(setting("exposure_ms", text(m_exposure->value())));
    if (m_trigger->isChecked())
        cameraSettings.push_back(setting("trigger", "software"));
    cameraSettings.insert(cameraSettings.end(), m_others.begin(), m_others.end());
    return withSettings(m_uri, cameraSettings);
}

} // namespace odo
