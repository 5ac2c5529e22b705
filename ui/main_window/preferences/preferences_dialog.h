// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/report/report_maker.h"
#include "ui/views/widgets/theme.h"

#include <QDialog>
#include <QWidget>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QImage;
class QLabel;
class QLineEdit;
class QSpinBox;
class QTabWidget;

namespace odo {

class CommandKeys;

/// What a person can set for all projects. Every change counts at once; there is nothing to confirm.
class PreferencesDialog : public QDialog
{
    Q_OBJECT
public:
    enum Page { General, Reports, Keys };
    PreferencesDialog(CommandKeys &keys, Theme theme, QWidget *parent = nullptr);
    void turnTo(Page page);

Q_SIGNALS:
    void themeChosen(odo::Theme theme);
    void styleChanged(); ///< the pages must be rebuilt

private:
    QTabWidget *m_tabs;
};

/// Appearance: language, units, theme, colours of maps. A choice takes effect, and is stored in the settings,
/// at once.
class GeneralPage : public QWidget
{
    Q_OBJECT
public:
    explicit GeneralPage(Theme theme, QWidget *parent = nullptr);

    /// What the settings hold comes into force, but for the theme, which is the window's own.
    static void applySettings();

Q_SIGNALS:
    void themeChosen(odo::Theme theme);
    void styleChanged(); ///< the pages must be rebuilt

private:
    QComboBox *makeLanguages();
    void addBackups(QFormLayout &form);
    QComboBox *makeUnits();
    QComboBox *makeThemes(Theme theme);
    QComboBox *makeScales();

    QLabel *m_languageWords; ///< hidden until another language is chosen
};

/// Whether live positions are sent on the network, and to where. What is chosen, and can be sent to, is kept
/// in the settings at once; who sends asks for it when the preferences are closed.
class NetworkPage : public QWidget
{
    Q_OBJECT
public:
    explicit NetworkPage(QWidget *parent = nullptr);

private:
    void choose();
    void showState();

    QCheckBox *m_on;
    QLineEdit *m_address;
    QSpinBox *m_port;
    QComboBox *m_interface;
    QLabel *m_words;
};

class PathField;

/// What a school has on all of its reports: its name, logo and a line at the foot. Kept in the settings at
/// once.
class ReportsPage : public QWidget
{
    Q_OBJECT
public:
    explicit ReportsPage(QWidget *parent = nullptr);

private:
    QLineEdit *addLine(QFormLayout &form, const QString &label, const QString &text);
    void store();
    void showLogo();
    void takeLogo(const std::optional<Error> &error);

    ReportSettings m_settings;
    QLineEdit *m_school, *m_remark;
    PathField *m_logo;
    QLabel *m_image;
    BackgroundTask m_reading;       ///< of the logo: a large one takes a while
    std::shared_ptr<QImage> m_read; ///< by it
    bool m_isOther = false;         ///< another logo was chosen meanwhile
};

} // namespace odo
