// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_file.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QList>
#include <QListWidget>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class QDateTimeEdit;
class QLineEdit;
class QMimeData;
class QWidget;

namespace odo {

/// A short list of names, each with a box to tick.
class CheckList : public QListWidget
{
    Q_OBJECT
public:
    explicit CheckList(const QString &accessibleName, QWidget *parent = nullptr);
    void setNames(const QStringList &names, bool checked);
    std::vector<std::string> checkedNames() const;
    /// Ticks these and no others.
    void setChecked(const QStringList &names);
    QSize sizeHint() const override;

protected:
    bool event(QEvent *event) override;
};

class LiveCameras;

/// A choice among the cameras that are connected, which fills itself when they are found. Its data is the
/// address.
class LiveCameraBox : public QComboBox
{
    Q_OBJECT
public:
    /// cameras must outlive it.
    explicit LiveCameraBox(const LiveCameras &cameras, QWidget *parent = nullptr);

    /// Empty: none is connected, or none was found yet.
    QString uri() const { return currentData().toString(); }

private:
    void fill();
    const LiveCameras &m_cameras;
};

/// A spin box that takes point and comma alike as the decimal sign, once the number is finished, and shows
/// what it read. "1.234" that can be read in two ways is not taken (ui/models/figure_text.h): the number
/// before comes back. Qt's own makes 125 of "12.5" where a point parts thousands.
class NumberBox : public QDoubleSpinBox
{
    Q_OBJECT
public:
    using QDoubleSpinBox::QDoubleSpinBox;

protected:
    QValidator::State validate(QString &text, int &position) const override;
    void fixup(QString &text) const override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    void rememberBefore();

    double m_before = 0; ///< what is typed now
};

/// A field for a date with its time, as the person's country writes it, the year in four digits.
QDateTimeEdit *makeMomentField(QWidget *parent = nullptr);

/// A format that a file can be saved in.
struct OutputFormat
{
    QString filter; ///< of the dialog: "PDF files (*.pdf)"
    QString ending; ///< without the dot; added to a name without one
    FileKind kind = FileKind::Text;
    bool isEndingNeeded = false; ///< added to a name with another one, too
};

/// Where a person wants a file.
struct ChosenOutput
{
    OutputTarget target; ///< replaces what is there: the person was asked
    QString file;        ///< as a person reads it
    int format = 0;      ///< index of the chosen one
};

/// Asks for a file to write. What must never be overwritten (checkOutput) is refused with its reason and
/// asked again; before an existing file is replaced that the file dialog has not asked about, or that is of
/// another kind, it asks as well. Nothing: the person thought better of it. GUI thread.
std::optional<ChosenOutput> askOutput(QWidget *parent, const QString &title, const QString &offered,
                                      const QList<OutputFormat> &formats);

std::filesystem::path pathOf(const QString &text);
QString textOf(const std::filesystem::path &path);
/// Of what is dragged or dropped: this machine's files.
QStringList localFiles(const QMimeData &data);

/// A line for the path of one existing file, and a button to browse for it. A file can be dropped on it.
class PathField : public QWidget
{
    Q_OBJECT
public:
    /// name: for the screen reader and the title of the file dialog. filter: as QFileDialog takes it.
    PathField(const QString &name, const QString &filter, QWidget *parent = nullptr);
    std::filesystem::path path() const;
    void setPath(const QString &path);
    /// How several files that were chosen or dropped at once become one text; without it only the first
    /// counts.
    void setSeveral(std::function<QString(const QStringList &)> joined) { m_joined = std::move(joined); }

Q_SIGNALS:
    void changed();

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void browse();
    void take(const QStringList &files);
    QLineEdit *m_line;
    QString m_name, m_filter;
    std::function<QString(const QStringList &)> m_joined;
};

} // namespace odo
