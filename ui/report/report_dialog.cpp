// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_dialog.h"

#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/views/widgets/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPaintEvent>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace odo {

namespace {

constexpr int formWidth = 300;

} // namespace

ReportDialog::ReportDialog(std::filesystem::path projectFile, QList<ReportSubject> subjects,
                           ReportChoices choices, QWidget *parent)
    : QDialog(parent), m_subjects(std::move(subjects)), m_choices(std::move(choices)),
      m_settings(storedReportSettings()), m_teams(new QCheckBox(tr("A page for each &team"))),
      m_method(new QCheckBox(tr("A second page with the &method"))), m_remark(new QLabel),
      m_save(new QPushButton(tr("&Save as PDF…"))), m_print(new QPushButton(tr("&Print…"))),
      m_preview(new ReportPreview(std::move(projectFile)))
{
    setWindowTitle(tr("Report"));
    auto *left = new QVBoxLayout;
    left->addWidget(makeForm());
    left->addStretch(1);
    left->addWidget(makeButtons());
    auto *layout = new QHBoxLayout(this);
    layout->addLayout(left);
    layout->addWidget(m_preview, 1);
    resize(1080, 820);
    connect(m_preview, &ReportPreview::made, this, &ReportDialog::showCreated);
    choose();
}

QComboBox *ReportDialog::addChoice(QFormLayout &form, const QString &label)
{
    auto *box = new QComboBox;
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(14);
    form.addRow(label, box);
    box->setAccessibleName(QString(label).remove(u'&'));
    connect(box, &QComboBox::activated, this, &ReportDialog::choose);
    return box;
}

void ReportDialog::addClassChoices(QFormLayout &form)
{
    m_class = addChoice(form, tr("&Class"));
    m_class->addItems(m_choices.classes);
    m_task = addChoice(form, tr("&Task"));
    m_task->addItem(tr("Most common"), QString());
    for (const QString &task : m_choices.tasks)
        m_task->addItem(task, task);
    m_metric = addChoice(form, tr("M&etric"));
    m_metric->addItem(tr("Most informative"), QString());
    for (const std::string &metric : m_choices.metricNames)
        m_metric->addItem(metricName(metric), QString::fromStdString(metric));
    form.addRow(m_teams);
    connect(m_teams, &QCheckBox::clicked, this, &ReportDialog::choose);
}

QWidget *ReportDialog::makeForm()
{
    auto *widget = new QWidget;
    widget->setFixedWidth(formWidth);
    m_form = new QFormLayout(widget);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_subject = addChoice(*m_form, tr("Report &of"));
    for (const ReportSubject &each : m_subjects)
        m_subject->addItem(each.words);
    addClassChoices(*m_form);
    m_paper = addChoice(*m_form, tr("P&aper"));
    m_paper->addItems({tr("A4"), tr("Letter")});
    m_paper->setCurrentIndex(static_cast<int>(m_settings.paper));
    m_form->addRow(m_method);
    m_method->setChecked(m_settings.withMethod);
    connect(m_method, &QCheckBox::clicked, this, &ReportDialog::choose);
    auto *letterhead = new QPushButton(tr("School, &logo and wording…"));
    letterhead->setAutoDefault(false);
    connect(letterhead, &QPushButton::clicked, this, &ReportDialog::letterheadRequested);
    m_form->addRow(letterhead);
    m_remark->setObjectName(QStringLiteral("quiet"));
    m_remark->setTextFormat(Qt::PlainText);
    m_remark->setWordWrap(true);
    m_form->addRow(m_remark);
    return widget;
}

QWidget *ReportDialog::makeButtons()
{
    auto *widget = new QWidget;
    auto *layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    auto *close = new QPushButton(tr("Close"));
    for (QPushButton *button : {m_save, m_print, close}) {
        button->setAutoDefault(button == m_save);
        layout->addWidget(button);
    }
    m_save->setDefault(true);
    connect(m_save, &QPushButton::clicked, this, &ReportDialog::saveRequested);
    connect(m_print, &QPushButton::clicked, this, &ReportDialog::printRequested);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    return widget;
}

const ReportSubject &ReportDialog::subject() const
{
    return m_subjects.at(std::max(0, m_subject->currentIndex()));
}

void ReportDialog::choose()
{
    for (QWidget *ofClass : std::initializer_list<QWidget *>{m_class, m_task, m_metric}) {
        ofClass->setVisible(subject().isClass);
        m_form->labelForField(ofClass)->setVisible(subject().isClass);
    }
    m_teams->setVisible(subject().isClass);
    m_method->setVisible(!subject().trials.empty());
    m_settings.paper = static_cast<Paper>(m_paper->currentIndex());
    m_settings.withMethod = m_method->isChecked();
    storeReportSettings(m_settings);
    m_save->setEnabled(false);
    m_print->setEnabled(false);
    m_preview->show(maker());
}

void ReportDialog::refresh()
{
    m_settings = storedReportSettings();
    choose();
}

ReportMaker ReportDialog::maker() const
{
    const ReportSubject &chosen = subject();
    const ClassReportSettings ofClass{m_class->currentText().toStdString(),
                                      m_task->currentData().toString().toStdString(),
                                      m_metric->currentData().toString().toStdString(), m_teams->isChecked()};
    return reportBy(m_settings, [chosen, ofClass](const ReportOptions &options) {
        if (chosen.comparison)
            return comparisonReport(*chosen.comparison, options);
        return chosen.isClass ? classReport(ofClass, options) : trialReports(chosen.trials, options);
    });
}

QString ReportDialog::proposedName() const
{
    return subject().isClass ? m_class->currentText() : subject().fileName;
}

void ReportDialog::showCreated(const QString &failure, bool isAll)
{
    m_save->setEnabled(failure.isEmpty());
    m_print->setEnabled(failure.isEmpty());
    if (!failure.isEmpty())
        m_remark->setText(tr("Nothing to print yet."));
    else if (isAll)
        m_remark->setText(tr("%n page(s)", "", int(m_preview->images().size())));
    else
        m_remark->setText(
            tr("The first %n page(s); the file has all of them.", "", int(m_preview->images().size())));
}

/// The sheets on their desk; as high as their widths make them.
class ReportPreview::Sheets : public QWidget
{
public:
    static constexpr int gap = 18;

    explicit Sheets(QWidget *parent) : QWidget(parent)
    {
        QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
        policy.setHeightForWidth(true);
        setSizePolicy(policy);
    }
    void setImages(const QList<QImage> &images)
    {
        m_images = images;
        m_words.clear();
        updateGeometry();
        fit();
        update();
    }
    void setWords(const QString &words)
    {
        m_words = words;
        update();
    }
    /// As high as its sheets at the width that it has.
    void fit() { setMinimumHeight(heightForWidth(width())); }
    int heightForWidth(int wide) const override
    {
        int height = gap;
        for (const QImage &image : m_images)
            height += heightOf(image, wide) + gap;
        return height;
    }

protected:
    void resizeEvent(QResizeEvent *) override { fit(); }
    void paintEvent(QPaintEvent *event) override
    {
        QPainter painter(this);
        const ThemeColours colours = ThemeColours::of(palette());
        painter.fillRect(event->rect(), colours.imageBackground);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        int top = gap;
        for (const QImage &image : m_images) {
            const QRect sheet(gap, top, width() - 2 * gap, heightOf(image, width()));
            if (sheet.intersects(event->rect())) {
                painter.drawImage(sheet, image);
                painter.setPen(colours.border);
                painter.drawRect(sheet);
            }
            top += sheet.height() + gap;
        }
        if (m_words.isEmpty())
            return;
        const QRect seen = visibleRegion().boundingRect();
        const QRect box(seen.left(), seen.center().y() - 24, seen.width(), 48);
        if (!m_images.isEmpty()) // over the pages that were there
            painter.fillRect(box, colours.bubble);
        painter.setPen(m_images.isEmpty() ? colours.text : colours.bubbleText);
        painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, m_words);
    }

private:
    static int heightOf(const QImage &image, int wide)
    {
        return image.width() > 0 ? (wide - 2 * gap) * image.height() / image.width() : 0;
    }

    QList<QImage> m_images;
    QString m_words;
};

ReportPreview::ReportPreview(std::filesystem::path projectFile, QWidget *parent)
    : QScrollArea(parent), m_reader(std::move(projectFile)), m_sheets(new Sheets(this))
{
    setWidget(m_sheets);
    setWidgetResizable(true);
    setFocusPolicy(Qt::StrongFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setAccessibleName(tr("Preview of the pages"));
}

Result<ReportPreview::Made> ReportPreview::make(Project &project, const ReportMaker &maker,
                                                const CancelToken &cancel)
{
    constexpr int widthPx = 1400; // 170 to the inch
    Made made;
    const auto taken = maker(project, {cancel, {}}, [&](const ReportPage &page) -> Result<void> {
        made.isAll = made.images.size() < qsizetype(mostPages);
        if (!made.isAll || cancel.isCancelled())
            return cancelled(ODO_TEXT("ui.preview", "preview")); // it has enough
        made.images << pageImage(page, widthPx);
        return {};
    });
    if (!taken && made.isAll)
        return tl::unexpected(taken.error());
    return made;
}

ReportPreview::~ReportPreview()
{
    m_cancel.cancel();
}

void ReportPreview::clear()
{
    m_cancel.cancel();
    m_images.clear();
    m_sheets->setImages({});
}

void ReportPreview::show(const ReportMaker &maker)
{
    m_cancel.cancel();
    m_cancel = CancelToken();
    m_sheets->setWords(tr("Drawing the pages…"));
    m_reader.read<Made>([maker, cancel = m_cancel](Project &project) { return make(project, maker, cancel); },
                        [this](Result<Made> made) { take(std::move(made)); });
}

void ReportPreview::take(Result<Made> made)
{
    if (m_cancel.isCancelled()) // cleared meanwhile
        return;
    m_images = made ? made->images : QList<QImage>();
    m_sheets->setImages(m_images);
    const QString failure = made ? QString() : errorLine(made.error());
    m_sheets->setWords(failure);
    setAccessibleDescription(failure.isEmpty() ? tr("%n page(s)", "", int(m_images.size())) : failure);
    Q_EMIT this->made(failure, !made || made->isAll);
}

} // namespace odo
