#include "render/webp.hpp"

#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>
#include <new>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace algae {
namespace {

constexpr int effort = 3;  // of 9: higher ones take several times as long for a few percent

[[noreturn]] void fail(const char* reason) {
    throw Error(std::string("the animation cannot be written: ") +
                (reason ? reason : "the WebP library gives no reason"));
}

/// The same colour with its parts not multiplied by its opacity.
std::uint32_t apart(std::uint32_t pixel) {
    const std::uint32_t opacity = pixel >> 24;
    if (opacity == 255) return pixel;
    if (opacity == 0) return 0;
    const auto part = [&](int shift) {
        const std::uint32_t value = pixel >> shift & 0xff;
        return std::min<std::uint32_t>(255, (value * 255 + opacity / 2) / opacity) << shift;
    };
    return opacity << 24 | part(16) | part(8) | part(0);
}

/// The library's own description of a picture.
struct Picture : WebPPicture {
    Picture(int across, int down) {
        if (!WebPPictureInit(this)) fail(nullptr);
        width = across;
        height = down;
        use_argb = 1;
        if (!WebPPictureAlloc(this)) throw std::bad_alloc();
    }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
    ~Picture() { WebPPictureFree(this); }
};

/// The finished file.
struct Bytes : WebPData {
    Bytes() { WebPDataInit(this); }
    Bytes(const Bytes&) = delete;
    Bytes& operator=(const Bytes&) = delete;
    ~Bytes() { WebPDataClear(this); }
};

}  // namespace

void write_webp(const Film& film, std::span<const std::uint32_t> hundredths, std::uint32_t plays,
                Output& output, const Budget& budget) {
    if (film.width > WEBP_MAX_DIMENSION || film.height > WEBP_MAX_DIMENSION)
        throw Error("a webp has at most " + std::to_string(WEBP_MAX_DIMENSION) + " pixels a side");
    WebPAnimEncoderOptions options;
    if (!WebPAnimEncoderOptionsInit(&options)) fail(nullptr);
    options.anim_params.loop_count = static_cast<int>(plays);
    WebPConfig config;
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, effort)) fail(nullptr);
    config.exact = 1;
    const std::unique_ptr<WebPAnimEncoder, decltype(&WebPAnimEncoderDelete)> encoder(
        WebPAnimEncoderNew(film.width, film.height, &options), WebPAnimEncoderDelete);
    if (!encoder) throw std::bad_alloc();

    std::vector<std::uint32_t> pixels;
    std::uint64_t milliseconds = 0;
    for (std::size_t i = 0; i < film.frames.size(); ++i) {
        budget.check();
        film.show(i, pixels);
        // The encoder changes the picture that it is given.
        Picture picture(film.width, film.height);
        for (int y = 0; y < film.height; ++y)
            for (int x = 0; x < film.width; ++x)
                picture.argb[static_cast<std::ptrdiff_t>(y) * picture.argb_stride + x] = apart(
                    pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                           static_cast<std::size_t>(x)]);
        if (!WebPAnimEncoderAdd(encoder.get(), &picture, static_cast<int>(milliseconds), &config))
            fail(WebPAnimEncoderGetError(encoder.get()));
        milliseconds += 10 * std::uint64_t{hundredths[i]};
        if (milliseconds > 2'000'000'000) throw Error("a webp lasts at most 2,000,000 seconds");
    }
    if (!WebPAnimEncoderAdd(encoder.get(), nullptr, static_cast<int>(milliseconds), nullptr))
        fail(WebPAnimEncoderGetError(encoder.get()));
    Bytes file;
    if (!WebPAnimEncoderAssemble(encoder.get(), &file))
        fail(WebPAnimEncoderGetError(encoder.get()));
    output.write(reinterpret_cast<const char*>(file.bytes), file.size);
}

}  // namespace algae
