// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_image.h"

#include "core/base/job_control.h"
#include "core/exchange/file_name.h"
#include "core/files/output_file.h"
#include "core/workflow/job.h"
#include "ui/models/shown_message.h"
#include "ui/views/charts/chart_view.h"
#include "ui/views/charts/internal/chart.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGraphicsScene>
#include <QGuiApplication>
#include <QMessageBox>
#include <QMimeData>
#include <QPageSize>
#include <QPaintEngine>
#include <QPainter>
#include <QPdfWriter>
#include <QPicture>
#include <QStandardPaths>
#include <QSvgGenerator>
#include <QThread>
#include <QWidget>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <utility>

namespace odo {

namespace {

constexpr int margin = 8;
constexpr double dotsPerPixel = 3; // 288 dots an inch: enough for print
const QString svgEnding = QStringLiteral("svg"), pdfEnding = QStringLiteral("pdf");

/// A widget as it looks in light, while it lives. It is not visible: the screen is painted later.
class InLight
{
public:
    explicit InLight(QWidget &widget)
        : m_widget(widget), m_isOwn(widget.testAttribute(Qt::WA_SetPalette)), m_before(widget.palette())
    {
        widget.setPalette(lightPalette());
    }
    ~InLight() { m_widget.setPalette(m_isOwn ? m_before : QPalette()); }
    Q_DISABLE_COPY_MOVE(InLight)

private:
    QWidget &m_widget;
    bool m_isOwn;
    QPalette m_before;
};

QByteArray pngOf(const QImage &image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "png");
    return bytes;
}

} // namespace

QString ImageHeading::title() const
{
    QStringList names = runs;
    names.removeAll(QString());
    return names.isEmpty() ? what : what + QStringLiteral(" · ") + names.join(QStringLiteral(", "));
}

ChartImage::ChartImage(QWidget &plot, std::function<ImageHeading()> heading, SeriesKey *key)
    : QObject(&plot), m_plot(plot), m_heading(std::move(heading)), m_key(key)
{
    auto *copyIt = new QAction(tr("&Copy as image"), &plot);
    copyIt->setShortcut(QKeySequence::Copy);
    copyIt->setShortcutContext(Qt::WidgetShortcut);
    auto *saveIt = new QAction(tr("&Save as image…"), &plot);
    connect(copyIt, &QAction::triggered, this, &ChartImage::copy);
    connect(saveIt, &QAction::triggered, this, &ChartImage::askSave);
    plot.addActions({copyIt, saveIt});
    plot.setContextMenuPolicy(Qt::ActionsContextMenu);
}

ChartImage::ChartImage(ChartView &plot, std::function<ImageHeading()> heading, SeriesKey *key)
    : ChartImage(static_cast<QWidget &>(plot), std::move(heading), key)
{
    m_paintPlot = [&plot](QPainter &painter) { plot.paintImage(painter); };
}

bool ChartImage::isPaintedBy(const QPainter &painter, const QWidget &plot)
{
    return painter.paintEngine()->type() == QPaintEngine::SVG ||
           painter.deviceTransform().m11() > plot.devicePixelRatioF();
}

int ChartImage::headHeight() const
{
    return m_plot.fontMetrics().height() + 2 * margin;
}

QSize ChartImage::size() const
{
    return m_plot.size() + QSize(0, headHeight());
}

void ChartImage::paintHead(QPainter &painter) const
{
    const ImageHeading heading = m_heading();
    const ThemeColours colours = ThemeColours::of(lightPalette());
    const bool hasKey = m_key && !m_key->isHidden();
    QRect room(margin, 0, m_plot.width() - 2 * margin - (hasKey ? m_key->width() : 0), headHeight());
    QFont bold = m_plot.font();
    bold.setBold(true);
    const QFontMetrics metrics(bold);
    painter.setFont(bold);
    painter.setPen(colours.text);
    const QString title = metrics.elidedText(heading.title(), Qt::ElideMiddle, room.width());
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, title);
    room.setLeft(room.left() + metrics.horizontalAdvance(title) + 2 * margin);
    painter.setFont(m_plot.font());
    painter.setPen(colours.muted);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     m_plot.fontMetrics().elidedText(heading.remark, Qt::ElideRight, room.width()));
    if (!hasKey)
        return;
    const InLight light(*m_key);
    m_key->render(&painter,
                  QPoint(m_plot.width() - margin - m_key->width(), (headHeight() - m_key->height()) / 2), {},
                  QWidget::DrawChildren);
}

void ChartImage::paint(QPainter &painter) const
{
    painter.fillRect(QRect(QPoint(), size()), Qt::white);
    paintHead(painter);
    const InLight light(m_plot);
    if (m_paintPlot) {
        painter.translate(0, headHeight());
        m_paintPlot(painter);
        return;
    }
    m_plot.render(&painter, QPoint(0, headHeight()), {}, QWidget::DrawChildren);
}

QByteArray ChartImage::svg() const
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size());
    generator.setViewBox(QRect(QPoint(), size()));
    generator.setResolution(m_plot.logicalDpiX());
    generator.setTitle(m_heading().title());
    QPainter painter(&generator);
    paint(painter);
    painter.end();
    return bytes;
}

QByteArray ChartImage::pdf() const
{
    constexpr int dotsPerInch = 1200;
    constexpr double pointsPerInch = 72;
    const double dpi = m_plot.logicalDpiX();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(m_heading().title());
    writer.setCreator(QStringLiteral("Odograph " ODOGRAPH_VERSION));
    writer.setResolution(dotsPerInch);
    writer.setPageMargins(QMarginsF());
    writer.setPageSize(
        QPageSize(QSizeF(size()) * pointsPerInch / dpi, QPageSize::Point, {}, QPageSize::ExactMatch));
    QPainter painter(&writer);
    painter.scale(dotsPerInch / dpi, dotsPerInch / dpi);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    paint(painter);
    painter.end();
    return bytes;
}

QImage ChartImage::image() const
{
    const double scale = dotsPerPixel * m_plot.devicePixelRatioF();
    QImage image((QSizeF(size()) * scale).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    paint(painter);
    return image;
}

Result<void> ChartImage::save(const OutputTarget &target) const
{
    const QString ending = QFileInfo(textOf(target.file)).suffix().toLower();
    const QByteArray bytes = ending == svgEnding ? svg() : ending == pdfEnding ? pdf() : pngOf(image());
    return writeOutput(target, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

void ChartImage::copy() const
{
    auto *content = new QMimeData;
    content->setImageData(image());
    content->setData(QStringLiteral("image/svg+xml"), svg());
    QGuiApplication::clipboard()->setMimeData(content);
}

void ChartImage::askSave() const
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    const QString name = QString::fromStdString(fileNameOf(m_heading().title().toStdString()));
    const auto chosen = askOutput(&m_plot, tr("Save as image"), folder.filePath(name + u'.' + svgEnding),
                                  {{tr("SVG images (*.svg)"), svgEnding, FileKind::Svg},
                                   {tr("PDF documents (*.pdf)"), pdfEnding, FileKind::Pdf},
                                   {tr("PNG images (*.png)"), QStringLiteral("png"), FileKind::Png}});
    if (!chosen)
        return;
    if (const auto saved = save(chosen->target); !saved) {
        QMessageBox told(QMessageBox::Warning, tr("Save as image"), errorInWords(saved.error()),
                         QMessageBox::Ok, &m_plot);
        told.setTextFormat(Qt::PlainText);
        told.exec();
    }
}

namespace {

void drawOn(QPainter &painter, const QWidget &view, const StillLayer::Draw &draw)
{
    painter.setFont(view.font());
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
}

} // namespace

void StillLayer::paint(QPainter &painter, const QWidget &view, const QColor &ground, const Draw &draw)
{
    if (ChartImage::isPaintedBy(painter, view)) {
        painter.fillRect(view.rect(), ground);
        drawOn(painter, view, draw);
        return;
    }
    if (m_image.isNull()) {
        m_image = QPixmap((QSizeF(view.size()) * view.devicePixelRatioF()).toSize());
        m_image.setDevicePixelRatio(view.devicePixelRatioF());
        m_image.fill(ground);
        add(view, draw);
    }
    painter.drawPixmap(0, 0, m_image);
}

void StillLayer::add(const QWidget &view, const Draw &draw)
{
    if (m_image.isNull())
        return;
    QPainter painter(&m_image);
    drawOn(painter, view, draw);
}

namespace {

/// A chart as drawing commands, which any painter plays.
struct Recorded
{
    ChartDrawing drawing;
    QSizeF size;
    QPalette palette;
    QFont font;
    double fineness = 1;
    QPicture image; ///< once it was made
    ChartPlot plot; ///< likewise
};

void record(Recorded &recorded)
{
    QGraphicsScene scene;
    auto *chart = new Chart(recorded.drawing.axes);
    scene.addItem(chart);
    chart->setFineness(recorded.fineness);
    chart->setStyle(recorded.palette, recorded.font);
    chart->setContent(recorded.drawing.content, recorded.drawing.stretches);
    chart->setSize(recorded.size);
    std::optional<ValueRange> chosen;
    if (recorded.drawing.axes.style == ChartStyle::Strip && recorded.drawing.content)
        chosen = recorded.drawing.content->range; // its rows are where the page has them
    chart->show(recorded.drawing.low, recorded.drawing.high, chosen);
    chart->prepare();
    const QRectF room(QPointF(0, 0), recorded.size);
    QPainter painter(&recorded.image);
    painter.setRenderHint(QPainter::Antialiasing);
    scene.render(&painter, room, room, Qt::IgnoreAspectRatio);
    recorded.plot = chart->chartPlot();
}

} // namespace

ChartPlot drawChart(QPainter &painter, const QRectF &rect, const ChartDrawing &drawing,
                    const QPalette &palette, const QFont &font, double fineness)
{
    // Shared with the window's thread, which may come to it when the caller has given up.
    const auto recorded = std::make_shared<Recorded>();
    recorded->drawing = drawing;
    recorded->size = rect.size();
    recorded->palette = palette;
    recorded->font = font;
    recorded->fineness = fineness;
    onWindowThread([recorded] { record(*recorded); });
    // Playing it would enlarge it by the dots to an inch, which whoever made the painter has done already.
    const QPaintDevice &paper = *painter.device();
    painter.save();
    painter.translate(rect.topLeft());
    painter.scale(double(recorded->image.logicalDpiX()) / paper.logicalDpiX(),
                  double(recorded->image.logicalDpiY()) / paper.logicalDpiY());
    painter.drawPicture(QPointF(), recorded->image);
    painter.restore();
    ChartPlot plot = recorded->plot;
    plot.rect.translate(rect.topLeft());
    return plot;
}

void onWindowThread(std::function<void()> work)
{
    using namespace std::chrono_literals;
    if (QThread::currentThread() == qApp->thread()) {
        work();
        return;
    }
    const auto task = std::make_shared<std::packaged_task<void()>>(std::move(work));
    std::future<void> done = task->get_future();
    // Once the caller has given up, only what has started keeps the task.
    callLater(qApp, [waiting = std::weak_ptr(task)] {
        if (const auto wanted = waiting.lock())
            (*wanted)();
    });
    // Checked now and then: whoever cancels may wait for this thread, on the window's.
    while (done.wait_for(20ms) != std::future_status::ready)
        endIfCancelled();
    done.get();
}

} // namespace odo
