// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/check/camera_position_dialog.h"

#include "core/capture/camera_source.h"
#include "ui/models/camera_lists.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/image_file_filter.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/table_list.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {
namespace {

constexpr int mostLetters = 24; ///< of a name on a button

struct MovedColumn
{
    enum { Camera, Picture, Result, Count };
};
constexpr int resultTextRole = Qt::UserRole, resultStateRole = Qt::UserRole + 1;
constexpr int fileRole = Qt::UserRole, uriRole = Qt::UserRole + 1;

/// "sim:A" is camera A, as is the one whose address the project knows.
bool isTheCamera(const QString &uri, const CheckCamera &camera)
{
    return uri == QString::fromStdString(withoutSettings(camera.deviceUri)) ||
           uri.section(QLatin1Char(':'), 1) == camera.name;
}

Badge badgeOf(const CameraPositionCheck &check)
{
    switch (check.verdict) {
    case CameraPositionCheck::Verdict::CameraMoved:
        return {CameraPositionDialog::tr("moved %1").arg(lengthText(check.shiftM)), BadgeState::Bad};
    case CameraPositionCheck::Verdict::MarkersMoved:
        return {CameraPositionDialog::tr("marker moved %1").arg(lengthText(check.shiftM)),
                BadgeState::Warning};
    case CameraPositionCheck::Verdict::Still:
        break;
    }
    return {CameraPositionDialog::tr("has not moved"), BadgeState::Good};
}

} // namespace

CameraPositionDialog::CameraPositionDialog(Project &project, std::vector<CheckCamera> cameras,
                                           const LiveCameras &live, QWidget *parent)
    : QDialog(parent), m_project(project), m_table(new QTableWidget(int(cameras.size()), MovedColumn::Count)),
      m_words(new QLabel), m_check(plainButton(tr("&Check"))),
      m_register(plainButton(tr("&Register again…"))), m_runner(project)
{
    setWindowTitle(tr("Check camera positions"));
    for (CheckCamera &camera : cameras)
        m_rows.push_back({std::move(camera), {}, {}, {}, false});
    m_table->setHorizontalHeaderLabels({tr("Camera"), tr("New image"), tr("Result")});
    m_table->setAccessibleName(tr("Registered cameras"));
    showAsList(*m_table);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setSectionResizeMode(MovedColumn::Camera, QHeaderView::ResizeToContents);
    m_table->setColumnWidth(MovedColumn::Picture, 260);
    m_table->setItemDelegateForColumn(MovedColumn::Result,
                                      new BadgeDelegate(resultTextRole, resultStateRole, this));
    for (int row = 0; row < int(m_rows.size()); ++row)
        addRow(row);
    offerLive(live);
    connect(&live, &LiveCameras::changed, this, [this, &live] { offerLive(live); });
    auto *intro = new QLabel(tr("A camera that someone has pushed measures wrong positions without any sign "
                                "of it. Before the robots run, check each camera's markers in a new image."));
    intro->setWordWrap(true);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(intro);
    layout->addWidget(m_table, 1);
    layout->addWidget(makeDetail());
    auto *buttons = new QHBoxLayout;
    auto *close = plainButton(tr("Close"));
    buttons->addWidget(m_register);
    buttons->addStretch(1);
    buttons->addWidget(m_check);
    buttons->addWidget(close);
    m_check->setDefault(true);
    m_check->setProperty("primary", true);
    layout->addLayout(buttons);
    resize(760, 420);
    connect(m_check, &QPushButton::clicked, this, &CameraPositionDialog::checkAll);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_register, &QPushButton::clicked, this, [this] {
        m_toRegister = m_rows.at(std::size_t(m_table->currentRow())).camera.name;
        accept();
    });
    connect(m_table, &QTableWidget::currentCellChanged, this, &CameraPositionDialog::showCurrent);
    connect(&m_runner, &JobRunner::finished, this, &CameraPositionDialog::finishOne);
    m_table->selectRow(0);
    showCurrent();
}

CameraPositionDialog::~CameraPositionDialog() = default;

QWidget *CameraPositionDialog::makeDetail()
{
    showAsWords(*m_words);
    m_words->setAccessibleName(tr("Results of the check"));
    m_words->setMinimumHeight(4 * m_words->fontMetrics().lineSpacing()); // so that the table does not jump
    m_words->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return m_words;
}

void CameraPositionDialog::addRow(int row)
{
    const CheckCamera &camera = m_rows[std::size_t(row)].camera;
    auto *choice = new QComboBox;
    choice->setAccessibleName(tr("New image of camera %1").arg(camera.name));
    if (camera.newestRecording) {
        choice->addItem(tr("Its newest recording"));
        choice->setItemData(0, textOf(*camera.newestRecording), fileRole);
    }
    choice->addItem(tr("Not checked"));
    choice->addItem(tr("An image or video…"));
    m_rows[std::size_t(row)].origin = {choice->currentData(fileRole).toString(),
                                       choice->currentData(uriRole).toString()};
    m_table->setItem(row, MovedColumn::Camera, new QTableWidgetItem(camera.name));
    m_table->setCellWidget(row, MovedColumn::Picture, choice);
    m_table->setItem(row, MovedColumn::Result, new QTableWidgetItem);
    m_table->setRowHeight(row, choice->sizeHint().height() + 6);
    connect(choice, &QComboBox::activated, this, [this, row](int index) { chooseImage(row, index); });
    showRow(row);
}

void CameraPositionDialog::offerLive(const LiveCameras &live)
{
    for (int row = 0; row < int(m_rows.size()); ++row)
        for (const CameraDescription &camera : live.cameras())
            offerLive(row, camera);
}

/// First in the list; chosen where it is the row's camera and nobody has chosen otherwise.
void CameraPositionDialog::offerLive(int row, const CameraDescription &live)
{
    auto *choice = qobject_cast<QComboBox *>(m_table->cellWidget(row, MovedColumn::Picture));
    const QString uri = QString::fromStdString(live.uri);
    if (choice->findData(uri, uriRole) >= 0)
        return;
    choice->insertItem(0, shownWords(live.name));
    choice->setItemData(0, uri, uriRole);
    Row &of = m_rows[std::size_t(row)];
    if (of.chosen || !isTheCamera(uri, of.camera))
        return;
    choice->setCurrentIndex(0);
    of.origin = {{}, uri};
}

void CameraPositionDialog::chooseImage(int row, int index)
{
    auto *choice = qobject_cast<QComboBox *>(m_table->cellWidget(row, MovedColumn::Picture));
    m_table->selectRow(row);
    m_rows[std::size_t(row)].chosen = true;
    if (index + 1 < choice->count()) {
        m_rows[std::size_t(row)].origin = {choice->itemData(index, fileRole).toString(),
                                           choice->itemData(index, uriRole).toString()};
        return;
    }
    const QString file = QFileDialog::getOpenFileName(
        this, tr("New image of camera %1").arg(m_rows[std::size_t(row)].camera.name), {}, imageFileFilter());
    setImage(row, file.isEmpty() ? ImageOrigin() : ImageOrigin{file, {}});
}

void CameraPositionDialog::setImage(int row, const ImageOrigin &origin)
{
    auto *choice = qobject_cast<QComboBox *>(m_table->cellWidget(row, MovedColumn::Picture));
    m_rows[std::size_t(row)].origin = origin;
    m_rows[std::size_t(row)].chosen = true;
    const int notChecked = choice->count() - 2;
    if (origin.file.isEmpty() && origin.liveUri.isEmpty())
        return choice->setCurrentIndex(notChecked);
    choice->insertItem(notChecked,
                       origin.file.isEmpty() ? origin.liveUri : QFileInfo(origin.file).fileName());
    choice->setItemData(notChecked, origin.file, fileRole);
    choice->setItemData(notChecked, origin.liveUri, uriRole);
    choice->setCurrentIndex(notChecked);
}

void CameraPositionDialog::checkAll()
{
    m_waiting.clear();
    for (int row = 0; row < int(m_rows.size()); ++row) {
        const ImageOrigin &origin = m_rows[std::size_t(row)].origin;
        m_rows[std::size_t(row)].badge = {};
        m_rows[std::size_t(row)].words.clear();
        if (!origin.file.isEmpty() || !origin.liveUri.isEmpty())
            m_waiting.push_back(row);
        showRow(row);
    }
    m_check->setEnabled(m_waiting.empty());
    checkNext();
}

void CameraPositionDialog::checkNext()
{
    if (m_waiting.empty()) {
        m_check->setEnabled(true);
        return;
    }
    Row &row = m_rows[std::size_t(m_waiting.front())];
    row.badge = {tr("detecting…"), BadgeState::Neutral};
    showRow(m_waiting.front());
    m_runner.start(std::make_shared<CameraPositionJob>(CameraPositionSettings{
        row.camera.name.toStdString(), pathOf(row.origin.file), row.origin.liveUri.toStdString()}));
}

void CameraPositionDialog::finishOne(const std::shared_ptr<Job> &job, const std::optional<Error> &error)
{
    if (m_waiting.empty())
        return;
    Row &row = m_rows[std::size_t(m_waiting.front())];
    if (!error) {
        const CameraPositionCheck &check = std::static_pointer_cast<CameraPositionJob>(job)->check();
        row.badge = badgeOf(check);
        row.words = shownWords(check.words);
        m_hasChecked = true;
    } else {
        row.badge = {tr("undetermined"), BadgeState::Warning};
        row.words = errorLine(*error);
        // where a camera looks quite elsewhere, the list must not go on praising it
        if (error->code == ErrorCode::Undetermined)
            m_hasChecked = keepUndetermined(m_project, row.camera.name.toStdString(), *error).has_value() ||
                           m_hasChecked;
    }
    showRow(m_waiting.front());
    // Selects the first problem, so nobody has to search for it.
    if (row.badge.state != BadgeState::Good)
        m_table->selectRow(m_waiting.front());
    m_waiting.pop_front();
    showCurrent();
    checkNext();
}

void CameraPositionDialog::showRow(int row)
{
    const Badge badge = m_rows[std::size_t(row)].badge.text.isEmpty() ? m_rows[std::size_t(row)].camera.badge
                                                                      : m_rows[std::size_t(row)].badge;
    QTableWidgetItem *item = m_table->item(row, MovedColumn::Result);
    item->setText(badge.text); // for the screen reader
    item->setData(resultTextRole, badge.text);
    item->setData(resultStateRole, int(badge.state));
}

void CameraPositionDialog::showCurrent()
{
    const int row = m_table->currentRow();
    const bool isThere = row >= 0 && row < int(m_rows.size());
    const QString words = isThere ? m_rows[std::size_t(row)].words : QString();
    m_words->setText(words.isEmpty() ? tr("At least two markers must be visible. The check changes nothing.")
                                     : breakable(words));
    m_register->setEnabled(isThere);
    m_register->setText(
        isThere ? tr("&Register %1 again…").arg(m_rows[std::size_t(row)].camera.name.left(mostLetters))
                : tr("&Register again…"));
}

void CameraPositionDialog::done(int result)
{
    m_waiting.clear();
    m_runner.cancel();
    QDialog::done(result);
}

} // namespace odo
