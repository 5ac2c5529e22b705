// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <filesystem>

class QLineEdit;
class QMimeData;

namespace odo {

std::filesystem::path pathOf(const QString &text);
QString textOf(const std::filesystem::path &path);
/// Of what is dragged or dropped: this machine's files.
QStringList localFiles(const QMimeData &data);

/// A line for the path of one existing file, and a button that looks for it. A file can be dropped on it.
class PathField : public QWidget
{
    Q_OBJECT
public:
    /// name: for the screen reader and the title of the file dialog. filter: as QFileDialog takes it.
    PathField(const QString &name, const QString &filter, QWidget *parent = nullptr);
    std::filesystem::path path() const;
    void setPath(const QString &path);

Q_SIGNALS:
    void changed();

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void browse();
    QLineEdit *m_line;
    QString m_name, m_filter;
};

} // namespace odo
