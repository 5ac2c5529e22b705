// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/heif.h"

#include "core/video/internal/rgb_rows.h"

#include <algorithm>
#include <libheif/heif.h>
#include <memory>

namespace odo {

namespace {

struct FreeHeif
{
    void operator()(heif_context *context) const { heif_context_free(context); }
    void operator()(heif_image_handle *handle) const { heif_image_handle_release(handle); }
    void operator()(heif_image *image) const { heif_image_release(image); }
    void operator()(heif_decoding_options *options) const { heif_decoding_options_free(options); }
};

bool isFine(const heif_error &error)
{
    if (error.code == heif_error_Memory_allocation_error && error.subcode == heif_suberror_Unspecified)
        throw std::bad_alloc();
    return error.code == heif_error_Ok;
}

/// The first image of a file, not decoded yet.
struct HeifImage
{
    explicit HeifImage(std::span<const std::uint8_t> file) : context(heif_context_alloc())
    {
        heif_image_handle *found = nullptr;
        if (context &&
            isFine(heif_context_read_from_memory_without_copy(context.get(), file.data(), file.size(),
                                                              nullptr)) &&
            isFine(heif_context_get_primary_image_handle(context.get(), &found)))
            handle.reset(found);
    }
    int codedWidth() const { return handle ? heif_image_handle_get_ispe_width(handle.get()) : 0; }
    int codedHeight() const { return handle ? heif_image_handle_get_ispe_height(handle.get()) : 0; }

    std::unique_ptr<heif_context, FreeHeif> context;
    std::unique_ptr<heif_image_handle, FreeHeif> handle;
};

} // namespace

bool isHeif(std::span<const std::uint8_t> file)
{
    constexpr std::size_t leastBytes = 12;
    return file.size() >= leastBytes &&
           heif_check_filetype(file.data(), int(file.size())) == heif_filetype_yes_supported;
}

StatedSize heifSize(std::span<const std::uint8_t> file)
{
    const HeifImage image(file);
    const int width = image.codedWidth(), height = image.codedHeight();
    return width > 0 && height > 0 ? StatedSize{std::uint32_t(width), std::uint32_t(height)} : StatedSize{};
}

std::optional<Frame> decodeHeif(std::span<const std::uint8_t> file)
{
    const HeifImage image(file);
    if (!image.handle)
        return std::nullopt;
    // Parts of the image may state other sizes than the whole; they are of whole blocks.
    constexpr int largestBlock = 64;
    heif_context_set_maximum_image_size_limit(
        image.context.get(), std::max(image.codedWidth(), image.codedHeight()) + largestBlock);
    const std::unique_ptr<heif_decoding_options, FreeHeif> options(heif_decoding_options_alloc());
    options->convert_hdr_to_8bit = 1;
    options->strict_decoding = 1;
    heif_image *decoded = nullptr;
    const bool isDecoded = isFine(heif_decode_image(image.handle.get(), &decoded, heif_colorspace_RGB,
                                                    heif_chroma_interleaved_RGB, options.get()));
    const std::unique_ptr<heif_image, FreeHeif> pixels(decoded);
    if (!isDecoded || heif_image_get_decoding_warnings(decoded, 0, nullptr, 0) > 0)
        return std::nullopt;
    int stride = 0;
    const std::uint8_t *rows = heif_image_get_plane_readonly(decoded, heif_channel_interleaved, &stride);
    FrameFormat format = rgbFormat(heif_image_get_width(decoded, heif_channel_interleaved),
                                   heif_image_get_height(decoded, heif_channel_interleaved));
    if (!rows || format.width != heif_image_handle_get_width(image.handle.get()) ||
        format.height != heif_image_handle_get_height(image.handle.get()))
        return std::nullopt;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < format.height; ++y)
        convertRgbRow(rows + std::ptrdiff_t(y) * stride, format.width, buffer->yRow(y), buffer->uRow(y),
                      buffer->vRow(y));
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

} // namespace odo
