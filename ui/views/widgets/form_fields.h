// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <string>
#include <vector>

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

} // namespace odo
