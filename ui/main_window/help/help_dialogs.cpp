// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/help_dialogs.h"

#include "ui/main_window/language.h"
#include "ui/main_window/preferences/command_keys.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace odo {
namespace {

class HelpDialogsWords
{
    Q_DECLARE_TR_FUNCTIONS(HelpDialogs)
};

/// A table of the commands of each menu that have keys.
QString commandTables(const CommandKeys &keys)
{
    QString html, group;
    for (const CommandKeys::Command &command : keys.commands()) {
        if (command.keys.isEmpty())
            continue;
        if (command.group != group) {
            if (!group.isEmpty())
                html += QStringLiteral("</table>");
            group = command.group;
            html += QStringLiteral("<h3>%1</h3><table cellspacing=\"0\" cellpadding=\"3\">").arg(group.toHtmlEscaped());
        }
        const QString key = QKeySequence::listToString(command.keys, QKeySequence::NativeText);
        html += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                    .arg(key.toHtmlEscaped(), command.words.toHtmlEscaped());
    }
    return group.isEmpty() ? html : html + QStringLiteral("</table>");
}

} // namespace

void showKeys(const CommandKeys &keys, QWidget &window)
{
    auto *dialog = new QDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(HelpDialogsWords::tr("Keys"));
    auto *text = new QTextBrowser;
    text->setAccessibleName(HelpDialogsWords::tr("List of keys"));
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(commandTables(keys) + helpPage(QStringLiteral("keys")));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(460, 560);
    dialog->show();
}

void showAbout(QWidget &window)
{
    QMessageBox box(&window);
    box.setWindowTitle(HelpDialogsWords::tr("About Odograph"));
    box.setTextFormat(Qt::PlainText);
    box.setText(HelpDialogsWords::tr("Odograph %1").arg(QStringLiteral(ODOGRAPH_VERSION)));
    box.setInformativeText(HelpDialogsWords::tr(
        "Measures how a mobile robot moved, from the videos of ordinary cameras.\n\n"
        "Free software under the GNU General Public License, version 3 or later, without any warranty.\n\n"
        "The method follows S. Park, “Computational Vision for Automatic Tracking and Objective Estimation "
        "of Mobile Robot Trajectory”, 2018."));
    box.exec();
}

} // namespace odo
