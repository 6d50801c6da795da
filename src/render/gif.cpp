#include "render/gif.hpp"

#include <gif_lib.h>

#include <bit>
#include <exception>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "render/colour_table.hpp"

namespace algae {
namespace {

constexpr int longest_side = 65'535;

/// What the library's write function is given. An exception must not pass through it, so it waits.
struct Sink {
    Output& output;
    std::exception_ptr problem;

    static int write(GifFileType* file, const GifByteType* bytes, int count) {
        Sink& sink = *static_cast<Sink*>(file->UserData);
        if (sink.problem) return 0;
        try {
            sink.output.write(reinterpret_cast<const char*>(bytes),
                              static_cast<std::size_t>(count));
            return count;
        } catch (...) {
            sink.problem = std::current_exception();
            return 0;
        }
    }
};

class Writer {
public:
    explicit Writer(Output& output) : sink_{output, nullptr} {
        int error = 0;
        file_ = EGifOpen(&sink_, Sink::write, &error);
        if (!file_) fail(error);
        EGifSetGifVersion(file_, true);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() {
        if (file_) EGifCloseFile(file_, nullptr);
    }

    void screen(int width, int height, const std::vector<std::uint32_t>& colours) {
        const auto size = static_cast<int>(std::bit_ceil(std::max<std::size_t>(2, colours.size())));
        const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(
            GifMakeMapObject(size, nullptr), GifFreeMapObject);
        if (!map) throw std::bad_alloc();
        for (int i = 0; i < size; ++i) {
            const auto place = static_cast<std::size_t>(i);
            const std::uint32_t colour = place < colours.size() ? colours[place] : 0;
            map->Colors[i] = {static_cast<GifByteType>(colour >> 16),
                              static_cast<GifByteType>(colour >> 8 & 0xff),
                              static_cast<GifByteType>(colour & 0xff)};
        }
        check(EGifPutScreenDesc(file_, width, height, 8, 0, map.get()));
    }

    /// How often the film comes again after the first time; 0 for ever.
    void repeat(std::uint32_t times) {
        const GifByteType block[] = {1, static_cast<GifByteType>(times & 0xff),
                                     static_cast<GifByteType>(times >> 8)};
        check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
        check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
        check(EGifPutExtensionBlock(file_, sizeof block, block));
        check(EGifPutExtensionTrailer(file_));
    }

    void frame(const FilmFrame& frame, std::uint32_t hundredths, const ColourTable& table) {
        GraphicsControlBlock control{};
        control.DisposalMode = DISPOSE_DO_NOT;
        control.DelayTime = static_cast<int>(hundredths);
        control.TransparentColor = NO_TRANSPARENT_COLOR;
        GifByteType block[4];
        EGifGCBToExtension(&control, block);
        check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, sizeof block, block));
        const PixelRectangle& area = frame.area;
        check(
            EGifPutImageDesc(file_, area.left, area.top, area.width, area.height, false, nullptr));
        std::vector<GifPixelType> line(static_cast<std::size_t>(area.width));
        auto from = frame.pixels.begin();
        for (int y = 0; y < area.height; ++y) {
            for (GifPixelType& pixel : line) pixel = table.index(*from++);
            check(EGifPutLine(file_, line.data(), area.width));
        }
    }

    void finish() {
        int error = 0;
        GifFileType* const file = file_;
        file_ = nullptr;
        const int status = EGifCloseFile(file, &error);
        if (sink_.problem) std::rethrow_exception(sink_.problem);
        if (status != GIF_OK) fail(error);
    }

private:
    [[noreturn]] void fail(int error) const {
        if (sink_.problem) std::rethrow_exception(sink_.problem);
        const char* const reason = GifErrorString(error);
        throw Error(std::string("the animation cannot be written: ") +
                    (reason ? reason : "the GIF library gives no reason"));
    }
    void check(int status) const {
        if (status != GIF_OK) fail(file_->Error);
    }

    Sink sink_;
    GifFileType* file_ = nullptr;
};

}  // namespace

void write_gif(const Film& film, std::span<const std::uint32_t> hundredths, std::uint32_t plays,
               Output& output, const Budget& budget) {
    if (film.width > longest_side || film.height > longest_side)
        throw Error("a gif has at most " + std::to_string(longest_side) + " pixels a side");
    budget.check_memory(ColourTable::memory, "the colours of a gif");
    ColourTable table;
    for (const FilmFrame& frame : film.frames) table.count(frame.pixels);
    table.choose();
    Writer writer(output);
    writer.screen(film.width, film.height, table.colours());
    if (film.frames.size() > 1 && plays != 1) writer.repeat(plays == 0 ? 0 : plays - 1);
    for (std::size_t i = 0; i < film.frames.size(); ++i) {
        budget.check();
        writer.frame(film.frames[i], hundredths[i], table);
    }
    writer.finish();
}

}  // namespace algae
