// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/picture_outline.h"
#include "core/simulation/polygon_layer.h"
#include "core/simulation/renderer.h"
#include "core/simulation/sensor.h"
#include "core/simulation/tag_pattern.h"

#include <cassert>

namespace odo {
namespace {

const Rgb wall(118, 116, 112, 0), boardWhite(236, 236, 234, 0), boardBlack(24, 24, 26, 0);

class BoardPainter
{
public:
    BoardPainter(const CameraModel &camera, const SimulatedBoard &board)
        : m_board(board), m_outline(camera, board.cameraFromBoard), m_picture(m_outline.pictureRect())
    {
    }

    RgbPicture paint()
    {
        const PixelRect rect = m_picture.rect();
        for (int y = rect.y0; y < rect.y1; ++y)
            std::fill_n(m_picture.row(y), rect.width(), wall);
        PolygonLayer paper(rect);
        const double s = m_board.squareM;
        // A rim of one square of white around the outermost squares.
        addRectangle(paper, {-2 * s, -2 * s}, {(m_board.columns + 1) * s, (m_board.rows + 1) * s},
                     boardWhite);
        paper.paintOver(m_picture);

        PolygonLayer ink(rect);
        int marker = 0;
        for (int row = 0; row <= m_board.rows; ++row) {
            for (int column = 0; column <= m_board.columns; ++column) {
                const Eigen::Vector2d corner((column - 1) * s, (row - 1) * s);
                if ((row + column) % 2 == 0)
                    addRectangle(ink, corner, corner + Eigen::Vector2d(s, s), boardBlack);
                else if (m_board.charuco)
                    addMarker(ink, corner, marker++);
            }
        }
        ink.paintOver(m_picture);
        return std::move(m_picture);
    }

private:
    void addRectangle(PolygonLayer &layer, const Eigen::Vector2d &lower, const Eigen::Vector2d &upper,
                      const Rgb &colour) const
    {
        const std::vector<Eigen::Vector3d> corners = {{lower.x(), lower.y(), 0},
                                                      {upper.x(), lower.y(), 0},
                                                      {upper.x(), upper.y(), 0},
                                                      {lower.x(), upper.y(), 0}};
        layer.add(m_outline.of(corners), colour);
    }

    void addMarker(PolygonLayer &ink, const Eigen::Vector2d &squareCorner, int id) const
    {
        const TagPattern pattern = arucoPattern(id);
        const double side = m_board.squareM * m_board.markerRatio, cell = side / pattern.side;
        const Eigen::Vector2d start = squareCorner + Eigen::Vector2d::Constant((m_board.squareM - side) / 2);
        for (int row = 0; row < pattern.side; ++row)
            for (int column = 0; column < pattern.side; ++column)
                if (pattern.isBlack(column, row))
                    addRectangle(ink, start + cell * Eigen::Vector2d(column, row),
                                 start + cell * Eigen::Vector2d(column + 1, row + 1), boardBlack);
    }

    const SimulatedBoard &m_board;
    const PictureOutline m_outline;
    RgbPicture m_picture;
};

} // namespace

Frame renderBoard(const CameraModel &camera, const SimulatedBoard &board, double noiseSigma,
                  std::uint32_t seed)
{
    assert(board.columns > 0 && board.rows > 0 && board.squareM > 0 && noiseSigma >= 0);
    assert(board.markerRatio > 0 && board.markerRatio < 1);
    const RgbPicture picture = BoardPainter(camera, board).paint();
    SensorModel model;
    model.noiseSigma = noiseSigma;
    Sensor sensor(model, picture.rect().width(), picture.rect().height(), seed);
    sensor.take(picture);
    return FrameBuffer::toFrame(sensor.read(1.0, 0), 0, Nanoseconds{0});
}

} // namespace odo
