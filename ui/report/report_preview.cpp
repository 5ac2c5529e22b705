// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_preview.h"

#include "ui/models/error_words.h"
#include "ui/views/theme.h"

#include <QPainter>
#include <QPaintEvent>

namespace odo {

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
    void setPictures(const QList<QImage> &pictures)
    {
        m_pictures = pictures;
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
        for (const QImage &picture : m_pictures)
            height += heightOf(picture, wide) + gap;
        return height;
    }

protected:
    void resizeEvent(QResizeEvent *) override { fit(); }
    void paintEvent(QPaintEvent *event) override
    {
        QPainter painter(this);
        const ThemeColours colours = ThemeColours::of(palette());
        painter.fillRect(event->rect(), colours.pictureGround);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        int top = gap;
        for (const QImage &picture : m_pictures) {
            const QRect sheet(gap, top, width() - 2 * gap, heightOf(picture, width()));
            if (sheet.intersects(event->rect())) {
                painter.drawImage(sheet, picture);
                painter.setPen(colours.border);
                painter.drawRect(sheet);
            }
            top += sheet.height() + gap;
        }
        if (m_words.isEmpty())
            return;
        const QRect seen = visibleRegion().boundingRect();
        const QRect box(seen.left(), seen.center().y() - 24, seen.width(), 48);
        if (!m_pictures.isEmpty()) // over the pages that were there
            painter.fillRect(box, colours.bubble);
        painter.setPen(m_pictures.isEmpty() ? colours.text : colours.bubbleText);
        painter.drawText(box, Qt::AlignCenter | Qt::TextWordWrap, m_words);
    }

private:
    static int heightOf(const QImage &picture, int wide)
    {
        return picture.width() > 0 ? (wide - 2 * gap) * picture.height() / picture.width() : 0;
    }

    QList<QImage> m_pictures;
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

Result<ReportPreview::Made> ReportPreview::make(Project &project, const ReportMaker &maker, const CancelToken &cancel)
{
    constexpr int widthPx = 1400; // 170 to the inch
    Made made;
    const auto taken = maker(project, {cancel, {}}, [&](const ReportPage &page) -> Result<void> {
        made.isAll = made.pictures.size() < qsizetype(mostPages);
        if (!made.isAll || cancel.isCancelled())
            return cancelled("preview"); // it has enough
        made.pictures << pagePicture(page, widthPx);
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
    m_pictures.clear();
    m_sheets->setPictures({});
}

void ReportPreview::show(const ReportMaker &maker)
{
    m_cancel.cancel();
    m_cancel = CancelToken();
    m_sheets->setWords(tr("The pages are being painted…"));
    m_reader.read<Made>([maker, cancel = m_cancel](Project &project) { return make(project, maker, cancel); },
                        [this](Result<Made> made) { take(std::move(made)); });
}

void ReportPreview::take(Result<Made> made)
{
    if (m_cancel.isCancelled()) // cleared meanwhile
        return;
    m_pictures = made ? made->pictures : QList<QImage>();
    m_sheets->setPictures(m_pictures);
    const QString failure = made ? QString() : errorLine(made.error());
    m_sheets->setWords(failure);
    setAccessibleDescription(failure.isEmpty() ? tr("%n page(s)", "", int(m_pictures.size())) : failure);
    Q_EMIT this->made(failure, !made || made->isAll);
}

} // namespace odo
