// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/gige/raw_painters.h"

#include "core/simulation/renderer.h"

#include <algorithm>
#include <cmath>

namespace odo::test {

namespace {

constexpr int cell = 8, idBits = 16, timeBits = 64;

/// Sets pixels of a raw picture, whatever its format.
class Canvas
{
public:
    Canvas(const Exposure &exposure, std::span<std::uint8_t> bytes)
        : m_bytes(bytes), m_width(exposure.width), m_format(exposure.pixelFormat)
    {
    }

    void set(int x, int y, const RgbColour &colour)
    {
        const auto place =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
        switch (m_format) {
        case pixel::rgb8:
        case pixel::bgr8: {
            std::uint8_t *pixel = m_bytes.data() + 3 * place;
            pixel[0] = m_format == pixel::rgb8 ? colour.red : colour.blue;
            pixel[1] = colour.green;
            pixel[2] = m_format == pixel::rgb8 ? colour.blue : colour.red;
            break;
        }
        case pixel::mono8:
            m_bytes[place] = static_cast<std::uint8_t>(
                std::lround(0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue));
            break;
        default:
            m_bytes[place] = isRed(x, y) ? colour.red : isRed(x + 1, y + 1) ? colour.blue : colour.green;
        }
    }

private:
    bool isRed(int x, int y) const
    {
        const int right = m_format == pixel::bayerGr8 || m_format == pixel::bayerBg8,
                  below = m_format == pixel::bayerGb8 || m_format == pixel::bayerBg8;
        return x % 2 == right && y % 2 == below;
    }

    std::span<std::uint8_t> m_bytes;
    int m_width;
    std::uint32_t m_format;
};

/// BT.601 of a limited range, nearest chroma.
RgbColour colourAt(const Frame &frame, int x, int y)
{
    const double luma = (frame.y.at(x, y) - 16) * 255.0 / 219;
    const int cx = std::min(x / 2, frame.u.width - 1), cy = std::min(y / 2, frame.u.height - 1);
    const double cb = (frame.u.at(cx, cy) - 128) * 255.0 / 224, cr = (frame.v.at(cx, cy) - 128) * 255.0 / 224;
    const auto code = [](double value) {
        return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
    };
    return {code(luma + 1.402 * cr), code(luma - 0.344136 * cb - 0.714136 * cr), code(luma + 1.772 * cb)};
}

} // namespace

SimulatedGigeCamera::Painter codedPainter(RgbColour below)
{
    // What is the same in all pictures is painted once.
    return [below, still = std::vector<std::uint8_t>()](const Exposure &exposure,
                                                        std::span<std::uint8_t> pixels) mutable {
        if (still.size() != pixels.size()) {
            still.resize(pixels.size());
            Canvas canvas(exposure, still);
            for (int y = 0; y < exposure.height; ++y) {
                for (int x = 0; x < exposure.width; ++x)
                    canvas.set(x, y, below);
            }
        }
        std::ranges::copy(still, pixels.begin());
        Canvas canvas(exposure, pixels);
        const auto time = static_cast<std::uint64_t>(exposure.begin.count());
        for (int x = 0; x < exposure.width; ++x) {
            const int bit = x / cell;
            const bool set =
                bit < idBits ? exposure.id >> bit & 1 : bit < idBits + timeBits && time >> (bit - idBits) & 1;
            const std::uint8_t level = set ? 255 : 0;
            for (int y = 0; y < cell; ++y)
                canvas.set(x, y, {level, level, level});
        }
    };
}

FrameCode readCode(const Frame &frame)
{
    const auto isSet = [&](int bit) { return frame.y.at(bit * cell + cell / 2, cell / 2) > 127; };
    FrameCode code;
    std::uint64_t time = 0;
    for (int bit = 0; bit < idBits; ++bit)
        code.id = static_cast<std::uint16_t>(code.id | isSet(bit) << bit);
    for (int bit = 0; bit < timeBits; ++bit)
        time |= std::uint64_t{isSet(idBits + bit)} << bit;
    code.begin = Nanoseconds(static_cast<std::int64_t>(time));
    return code;
}

SimulatedGigeCamera::Painter scenePainter(const SimulatedScene &scene, int camera, std::int64_t firstFrame,
                                          std::uint32_t pixelFormat, Nanoseconds beginning)
{
    SceneRenderer renderer(scene, camera);
    auto frames = std::make_shared<std::vector<std::vector<std::uint8_t>>>();
    for (std::int64_t i = firstFrame; i < renderer.frameCount(); ++i) {
        const Frame frame = renderer.render(i);
        const Exposure exposure{0, {}, {}, pixelFormat, frame.format.width, frame.format.height};
        const int bytesPerPixel = static_cast<int>(pixelFormat >> 16 & 0xff) / 8;
        std::vector<std::uint8_t> &raw =
            frames->emplace_back(static_cast<std::size_t>(exposure.width * exposure.height * bytesPerPixel));
        Canvas canvas(exposure, raw);
        for (int y = 0; y < exposure.height; ++y) {
            for (int x = 0; x < exposure.width; ++x)
                canvas.set(x, y, colourAt(frame, x, y));
        }
    }
    const double framesPerSecond = scene.cameras[static_cast<std::size_t>(camera)].framesPerSecond;
    return [frames, framesPerSecond, beginning](const Exposure &exposure, std::span<std::uint8_t> pixels) {
        const double since = toSeconds(exposure.begin + exposure.length / 2 - beginning);
        const auto number = static_cast<std::int64_t>(std::floor(since * framesPerSecond + 0.5)),
                   count = static_cast<std::int64_t>(frames->size());
        const std::vector<std::uint8_t> &image =
            (*frames)[static_cast<std::size_t>(((number % count) + count) % count)];
        if (image.size() == pixels.size())
            std::ranges::copy(image, pixels.begin());
    };
}

} // namespace odo::test
