// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/path_field.h"

#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>
#include <algorithm>

namespace odo {

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
        const auto place = checkOutput(chosen.target, std::nullopt);
        if (!place) {
            show(QMessageBox::Warning, errorInWords(place.error()), QMessageBox::Ok);
            return false;
        }
        const bool isOther = place->exists && place->kind != FileKind::Empty && place->kind != kind;
        if (!place->exists || (wasAsked && !isOther))
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
    const QString file = QFileDialog::getOpenFileName(this, m_name, m_line->text(), m_filter);
    if (!file.isEmpty())
        m_line->setText(file);
}

void PathField::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void PathField::dropEvent(QDropEvent *event)
{
    m_line->setText(localFiles(*event->mimeData()).constFirst());
    event->acceptProposedAction();
}

} // namespace odo
