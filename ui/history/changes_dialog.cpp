// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/changes_dialog.h"

#include "ui/models/project_changes.h"
#include "ui/views/widgets/table_list.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

namespace odo {

ChangesDialog::ChangesDialog(std::vector<ChangeEntry> changes, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Changes of the project"));
    auto *intro = new QLabel(
        changes.empty() ? tr("Nothing has been changed yet.")
                        : tr("What was changed, in this window and by the command line, the newest first. "
                             "Recordings, imports and tracking are told too; they cannot be undone."));
    intro->setWordWrap(true);
    auto *model = new ChangeModel(std::move(changes), this);
    auto *search = new QLineEdit;
    search->setPlaceholderText(tr("Search the changes…"));
    search->setAccessibleName(tr("Search the changes"));
    search->setClearButtonEnabled(true);
    connect(search, &QLineEdit::textChanged, model, &ChangeModel::setText);
    auto *table = new QTableView;
    table->setModel(model);
    table->setAccessibleName(tr("Changes"));
    showAsList(*table);
    table->horizontalHeader()->setResizeContentsPrecision(0);
    table->horizontalHeader()->setStretchLastSection(true);
    table->resizeColumnsToContents();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->addWidget(intro);
    layout->addWidget(search);
    layout->addWidget(table, 1);
    layout->addWidget(buttons);
    resize(720, 480);
}

} // namespace odo
