#pragma once

#include <gif_lib.h>
#include <webp/demux.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace algae::test {

/// An animation read back by the libraries' own decoders: what a viewer would show.
struct Frames {
    int width = 0, height = 0;
    std::vector<std::vector<std::uint32_t>> pictures;  // 0xAARRGGBB, row by row
    std::vector<int> milliseconds;
    int plays = 1;            // 0: for ever
    std::size_t colours = 0;  // in the table of a gif
};

inline Frames decoded_gif(const std::string& bytes) {
    struct Source {
        const std::string& bytes;
        std::size_t at = 0;
    } source{bytes};
    int error = 0;
    GifFileType* const gif = DGifOpen(
        &source,
        [](GifFileType* file, GifByteType* into, int count) {
            Source& from = *static_cast<Source*>(file->UserData);
            const std::size_t some =
                std::min(static_cast<std::size_t>(count), from.bytes.size() - from.at);
            std::memcpy(into, from.bytes.data() + from.at, some);
            from.at += some;
            return static_cast<int>(some);
        },
        &error);
    Frames frames;
    if (!gif) return frames;
    if (DGifSlurp(gif) == GIF_OK && source.at == bytes.size()) {
        frames.width = gif->SWidth;
        frames.height = gif->SHeight;
        frames.colours = static_cast<std::size_t>(gif->SColorMap->ColorCount);
        std::vector<std::uint32_t> picture(
            static_cast<std::size_t>(gif->SWidth) * static_cast<std::size_t>(gif->SHeight), 0);
        for (int i = 0; i < gif->ImageCount; ++i) {
            const SavedImage& image = gif->SavedImages[i];
            for (int block = 0; block + 1 < image.ExtensionBlockCount; ++block) {
                const ExtensionBlock& name = image.ExtensionBlocks[block];
                const ExtensionBlock& data = image.ExtensionBlocks[block + 1];
                if (name.Function == APPLICATION_EXT_FUNC_CODE && name.ByteCount == 11 &&
                    std::memcmp(name.Bytes, "NETSCAPE2.0", 11) == 0 && data.ByteCount == 3) {
                    const int again = data.Bytes[1] + 256 * data.Bytes[2];
                    frames.plays = again == 0 ? 0 : again + 1;
                }
            }
            GraphicsControlBlock control{};
            DGifSavedExtensionToGCB(gif, i, &control);
            frames.milliseconds.push_back(10 * control.DelayTime);
            const GifImageDesc& area = image.ImageDesc;
            for (int y = 0; y < area.Height; ++y)
                for (int x = 0; x < area.Width; ++x) {
                    const GifColorType& colour =
                        gif->SColorMap->Colors[image.RasterBits[y * area.Width + x]];
                    picture.at(
                        static_cast<std::size_t>((area.Top + y) * gif->SWidth + area.Left + x)) =
                        0xff000000u | static_cast<std::uint32_t>(colour.Red) << 16 |
                        static_cast<std::uint32_t>(colour.Green) << 8 | colour.Blue;
                }
            frames.pictures.push_back(picture);
        }
    }
    DGifCloseFile(gif, &error);
    return frames;
}

inline Frames decoded_webp(const std::string& bytes) {
    Frames frames;
    const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
    WebPAnimDecoderOptions options;
    WebPAnimDecoderOptionsInit(&options);
    WebPAnimDecoder* const decoder = WebPAnimDecoderNew(&data, &options);
    if (!decoder) return frames;
    WebPAnimInfo info;
    WebPAnimDecoderGetInfo(decoder, &info);
    frames.width = static_cast<int>(info.canvas_width);
    frames.height = static_cast<int>(info.canvas_height);
    frames.plays = static_cast<int>(info.loop_count);
    int before = 0;
    while (WebPAnimDecoderHasMoreFrames(decoder)) {
        std::uint8_t* pixels = nullptr;
        int until = 0;
        if (!WebPAnimDecoderGetNext(decoder, &pixels, &until)) break;
        std::vector<std::uint32_t> picture;
        for (std::size_t i = 0; i < std::size_t{4} * info.canvas_width * info.canvas_height; i += 4)
            picture.push_back(static_cast<std::uint32_t>(pixels[i + 3]) << 24 |
                              static_cast<std::uint32_t>(pixels[i]) << 16 |
                              static_cast<std::uint32_t>(pixels[i + 1]) << 8 | pixels[i + 2]);
        frames.pictures.push_back(std::move(picture));
        frames.milliseconds.push_back(until - before);
        before = until;
    }
    WebPAnimDecoderDelete(decoder);
    return frames;
}

}  // namespace algae::test
