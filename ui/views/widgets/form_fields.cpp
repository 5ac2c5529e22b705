// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/form_fields.h"

#include "ui/models/camera_lists.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QDateTimeEdit>
#include <QDir>
#include <QDragEnterEvent>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSignalBlocker>
#include <QUrl>
#include <algorithm>

namespace odo {

namespace {
constexpr int fewestRows = 2, mostRows = 6;
}

CheckList::CheckList(const QString &accessibleName, QWidget *parent) : QListWidget(parent)
{
    setAccessibleName(accessibleName);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFrameShape(QFrame::StyledPanel);
}

void CheckList::setNames(const QStringList &names, bool checked)
{
    clear();
    for (const QString &name : names) {
        auto *item = new QListWidgetItem(name, this);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(checked ? Qt::Checked : Qt::Unchecked);
    }
    if (count() > 0)
        setCurrentRow(0);
    updateGeometry();
}

std::vector<std::string> CheckList::checkedNames() const
{
    std::vector<std::string> names;
    for (int i = 0; i < count(); ++i)
        if (item(i)->checkState() == Qt::Checked)
            names.push_back(item(i)->text().toStdString());
    return names;
}

void CheckList::setChecked(const QStringList &names)
{
    for (int i = 0; i < count(); ++i)
        item(i)->setCheckState(names.contains(item(i)->text()) ? Qt::Checked : Qt::Unchecked);
}

bool CheckList::event(QEvent *event)
{
    const bool isHandled = QListWidget::event(event);
    if (event->type() == QEvent::Polish)
        doItemsLayout(); // rows arranged before the style sheet was known are too low
    return isHandled;
}

QSize CheckList::sizeHint() const
{
    ensurePolished();
    const int row = std::max(sizeHintForRow(0), fontMetrics().height() + 6);
    return {QListWidget::sizeHint().width(),
            std::clamp(count(), fewestRows, mostRows) * row + 2 * frameWidth()};
}

LiveCameraBox::LiveCameraBox(const LiveCameras &cameras, QWidget *parent)
    : QComboBox(parent), m_cameras(cameras)
{
    setAccessibleName(tr("Connected camera"));
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(&cameras, &LiveCameras::changed, this, &LiveCameraBox::fill);
    fill();
}

void LiveCameraBox::fill()
{
    const QString chosen = uri();
    {
        const QSignalBlocker blocked(this);
        clear();
        for (const CameraDescription &camera : m_cameras.cameras()) {
            const QString name = shownWords(camera.name);
            addItem(camera.widthPx > 0 ? tr("%1, %2×%3").arg(name).arg(camera.widthPx).arg(camera.heightPx)
                                       : name,
                    QString::fromStdString(camera.uri));
        }
        if (count() == 0)
            addItem(m_cameras.isSearching() ? tr("Searching for cameras…") : tr("No camera is connected"),
                    QString());
        setCurrentIndex(std::max(0, findData(chosen)));
    }
    Q_EMIT currentIndexChanged(currentIndex());
}

/// While it is typed, a sign that parts thousands may still become anything.
QValidator::State NumberBox::validate(QString &text, int &position) const
{
    const bool isOpen = isAmbiguousNumber(text, locale()) || withDecimalSign(text, locale()) != text;
    return isOpen ? QValidator::Intermediate : QDoubleSpinBox::validate(text, position);
}

/// Qt's would take the signs away that part thousands.
void NumberBox::fixup(QString &text) const
{
    text = isAmbiguousNumber(text, locale()) ? prefix() + textFromValue(m_before) + suffix()
                                             : withDecimalSign(text, locale());
}

/// The number counts while it is typed: of "1.234" a one is taken first.
void NumberBox::rememberBefore()
{
    if (!lineEdit()->isModified())
        m_before = value();
}

void NumberBox::keyPressEvent(QKeyEvent *event)
{
    rememberBefore();
    QDoubleSpinBox::keyPressEvent(event);
}

void NumberBox::focusInEvent(QFocusEvent *event)
{
    rememberBefore();
    QDoubleSpinBox::focusInEvent(event);
}

QDateTimeEdit *makeMomentField(QWidget *parent)
{
    auto *field = new QDateTimeEdit(parent);
    QString format = QLocale().dateTimeFormat(QLocale::ShortFormat);
    if (!format.contains(QLatin1String("yyyy"))) // Qt would take 26 for 1926
        format.replace(QLatin1String("yy"), QLatin1String("yyyy"));
    field->setDisplayFormat(format);
    field->setCalendarPopup(true);
    field->setMinimumDate(QDate(1970, 1, 1));
    return field;
}

namespace {

class OutputQuestion
{
    Q_DECLARE_TR_FUNCTIONS(OutputQuestion)
public:
    OutputQuestion(QWidget *parent, const QString &title) : m_parent(parent), m_title(title) {}

    /// Whether the file may be written: nothing is in the way, or the person says so. wasAsked: about
    /// replacing it.
    bool isAllowed(const ChosenOutput &chosen, FileKind kind, bool wasAsked) const
    {
        const auto location = checkOutput(chosen.target, std::nullopt);
        if (!location) {
            show(QMessageBox::Warning, errorInWords(location.error()), QMessageBox::Ok);
            return false;
        }
        const bool isOther = location->exists && location->kind != FileKind::Empty && location->kind != kind;
        if (!location->exists || (wasAsked && !isOther))
            return true;
        const QString file = QDir::toNativeSeparators(chosen.file);
        return show(QMessageBox::Question,
                    isOther ? tr("%1 is a file of another kind. Replace it?").arg(file)
                            : tr("%1 exists. Replace it?").arg(file),
                    QMessageBox::Yes | QMessageBox::No) == QMessageBox::Yes;
    }

private:
    int show(QMessageBox::Icon icon, const QString &text, QMessageBox::StandardButtons buttons) const
    {
        QMessageBox box(icon, m_title, text, buttons, m_parent);
        box.setTextFormat(Qt::PlainText);
        if (buttons.testFlag(QMessageBox::No))
            box.setDefaultButton(QMessageBox::No);
        return box.exec();
    }

    QWidget *const m_parent;
    const QString m_title;
};

/// -1: none.
template <class Fits>
qsizetype indexWhere(const QList<OutputFormat> &formats, const Fits &fits)
{
    const auto found = std::ranges::find_if(formats, fits);
    return found == formats.end() ? -1 : found - formats.begin();
}

/// The format that was chosen in the dialog, but if the file's ending names another: that one. (Several may
/// have one ending.)
int formatOf(const QString &ending, const QString &filter, const QList<OutputFormat> &formats)
{
    const auto chosen =
        std::max(qsizetype(0),
                 indexWhere(formats, [&](const OutputFormat &format) { return format.filter == filter; }));
    const auto named =
        indexWhere(formats, [&](const OutputFormat &format) { return format.ending == ending; });
    return static_cast<int>(named < 0 || formats.at(chosen).ending == ending ? chosen : named);
}

} // namespace

std::optional<ChosenOutput> askOutput(QWidget *parent, const QString &title, const QString &offered,
                                      const QList<OutputFormat> &formats)
{
    QStringList filters;
    for (const OutputFormat &format : formats)
        filters << format.filter;
    const OutputQuestion question(parent, title);
    QString proposed = offered;
    for (;;) {
        QString filter = filters.front();
        const QString asked = QFileDialog::getSaveFileName(parent, title, proposed,
                                                           filters.join(QStringLiteral(";;")), &filter);
        if (asked.isEmpty())
            return std::nullopt;
        const QString ending = QFileInfo(asked).suffix();
        ChosenOutput chosen;
        chosen.format = formatOf(ending.toLower(), filter, formats);
        const OutputFormat &format = formats.at(chosen.format);
        const bool isComplete = format.isEndingNeeded ? ending == format.ending : !ending.isEmpty();
        chosen.file = isComplete ? asked : asked + u'.' + format.ending;
        chosen.target = OutputTarget(pathOf(chosen.file), Existing::ReplaceAny);
        if (question.isAllowed(chosen, format.kind, chosen.file == asked))
            return chosen;
        proposed = chosen.file;
    }
}

std::filesystem::path pathOf(const QString &text)
{
    return std::filesystem::path(text.trimmed().toStdString());
}

QString textOf(const std::filesystem::path &path)
{
    return QString::fromStdString(path.string());
}

QStringList localFiles(const QMimeData &data)
{
    QStringList files;
    for (const QUrl &url : data.urls())
        if (url.isLocalFile())
            files << url.toLocalFile();
    return files;
}

PathField::PathField(const QString &name, const QString &filter, QWidget *parent)
    : QWidget(parent), m_line(new QLineEdit(this)), m_name(name), m_filter(filter)
{
    m_line->setAccessibleName(name);
    m_line->setAcceptDrops(false); // a dropped file replaces the text, it is not inserted into it
    setAcceptDrops(true);
    setFocusPolicy(Qt::StrongFocus); // so that the tab order takes it with its line and button
    setFocusProxy(m_line);
    auto *button = new QPushButton(tr("Browse…"), this);
    button->setAccessibleName(tr("Browse: %1").arg(name));
    button->setAutoDefault(false); // Enter is the dialog's
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_line, 1);
    layout->addWidget(button);
    connect(button, &QPushButton::clicked, this, &PathField::browse);
    connect(m_line, &QLineEdit::textChanged, this, &PathField::changed);
}

std::filesystem::path PathField::path() const
{
    return pathOf(m_line->text());
}

void PathField::setPath(const QString &path)
{
    m_line->setText(path);
}

void PathField::browse()
{
    const QString there = m_line->text();
    take(m_joined ? QFileDialog::getOpenFileNames(this, m_name, there, m_filter)
                  : QStringList(QFileDialog::getOpenFileName(this, m_name, there, m_filter)));
}

void PathField::take(const QStringList &files)
{
    if (!files.isEmpty() && !files.constFirst().isEmpty())
        m_line->setText(m_joined ? m_joined(files) : files.constFirst());
}

void PathField::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void PathField::dropEvent(QDropEvent *event)
{
    take(localFiles(*event->mimeData()));
    event->acceptProposedAction();
}

} // namespace odo
