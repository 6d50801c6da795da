#include <cairo.h>
#include <fcntl.h>
#include <gif_lib.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "exact/exact.hpp"
#include "render/detail/colour_table.hpp"
#include "render/detail/document.hpp"
#include "render/detail/drawing.hpp"
#include "render/detail/graph.hpp"
#include "render/render.hpp"

// Animations: a film of frames that all have one size, packed as gif, webp, mp4 or webm.
//
// Every plate is drawn by Cairo as a png would be, and the film keeps the least rectangle in which a frame differs from the one
// before it. All frames are drawn and packed before there is a file.
//
// A webp is encoded without loss; libwebp takes colours that are not multiplied by their opacity, and changes the picture that it
// is given, so each frame is copied. A gif has one table of 256 colours for all frames. If the frames together have no more, the
// gif is exact. Otherwise the colour there is most of, usually that of the paper, stays as it is, and the others are cut into 255 groups,
// each time the group with the largest squared error where its values are spread widest (Wan, Wong and Prusinkiewicz 1988). A
// colour counts by the square root of its number, so that thin lines keep theirs. The table depends on how many pixels have which
// colour, not on their order: equal figures make equal files.
//
// A video is packed by the program ffmpeg, in a process of its own: it reads the frames from a socket, each as often as its time is a
// multiple of the shortest one, and writes to a file without a name, as an mp4 is not written from front to back. What the file holds
// then goes out like that of the other formats. The process ends with the work, whatever ends it.
//
// Subtle: giflib calls back to write, and an exception must not pass through it; it waits in the sink. Times are hundredths of a
// second, the unit of gif; a webp counts milliseconds from the start, which has a bound (2,000,000 seconds).

namespace algae {

namespace {

constexpr std::size_t most_colours = 256;

/// A colour of the pictures and how much it counts.
struct Shade {
    std::uint32_t colour;
    double weight;
    double part(std::size_t i) const { return (colour >> (16 - 8 * i)) & 0xff; }
};

/// A run of shades that become one colour of the table.
struct Group {
    std::size_t first, last;
    std::array<double, 3> mean{};
    std::size_t widest = 0;  // the part, red, green or blue, with the largest error
    double error = 0;        // the sum of squares of the distances from the mean

    Group(const std::vector<Shade>& shades, std::size_t from, std::size_t to)
        : first(from), last(to) {
        double weight = 0;
        for (std::size_t at = first; at < last; ++at) {
            weight += shades[at].weight;
            for (std::size_t i = 0; i < 3; ++i) mean[i] += shades[at].weight * shades[at].part(i);
        }
        for (double& part : mean) part /= weight;
        std::array<double, 3> errors{};
        for (std::size_t at = first; at < last; ++at)
            for (std::size_t i = 0; i < 3; ++i) {
                const double distance = shades[at].part(i) - mean[i];
                errors[i] += shades[at].weight * distance * distance;
            }
        widest = static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) -
                                          errors.begin());
        error = last - first > 1 ? errors[0] + errors[1] + errors[2] : 0;
    }

    std::uint32_t colour() const {
        std::uint32_t packed = 0;
        for (const double part : mean)
            packed = packed << 8 | static_cast<std::uint32_t>(std::lround(part));
        return packed;
    }
};

}  // namespace

void ColourTable::count(std::span<const std::uint32_t> pixels) {
    constexpr std::uint32_t full = std::numeric_limits<std::uint32_t>::max();
    for (const std::uint32_t pixel : pixels) {
        std::uint32_t& cell = table_[pixel & 0xffffffu];
        if (cell != full) ++cell;
    }
}

void ColourTable::choose() {
    std::vector<Shade> shades;
    for (std::size_t colour = 0; colour < table_.size(); ++colour)
        if (table_[colour] > 0)
            shades.push_back({static_cast<std::uint32_t>(colour),
                              std::sqrt(static_cast<double>(table_[colour]))});
    if (shades.empty()) shades.push_back({0, 1});
    exact_ = shades.size() <= most_colours;
    const auto put = [this](std::uint32_t colour) {
        colours_.push_back(colour);
        return static_cast<std::uint32_t>(colours_.size() - 1);
    };
    if (exact_) {
        for (const Shade& shade : shades) table_[shade.colour] = put(shade.colour);
        return;
    }
    const auto most = std::max_element(
        shades.begin(), shades.end(),
        [](const Shade& left, const Shade& right) { return left.weight < right.weight; });
    table_[most->colour] = put(most->colour);
    shades.erase(most);
    std::vector<Group> groups{Group(shades, 0, shades.size())};
    while (groups.size() < most_colours - 1) {
        const auto worst = std::max_element(
            groups.begin(), groups.end(),
            [](const Group& left, const Group& right) { return left.error < right.error; });
        if (worst->error == 0) break;
        const std::size_t part = worst->widest, first = worst->first, last = worst->last;
        const double mean = worst->mean[part];
        const auto middle =
            std::stable_partition(shades.begin() + static_cast<std::ptrdiff_t>(first),
                                  shades.begin() + static_cast<std::ptrdiff_t>(last),
                                  [&](const Shade& shade) { return shade.part(part) <= mean; });
        const auto cut = static_cast<std::size_t>(middle - shades.begin());
        *worst = Group(shades, first, cut);
        groups.emplace_back(shades, cut, last);
    }
    for (const Group& group : groups) {
        const std::uint32_t place = put(group.colour());
        for (std::size_t at = group.first; at < group.last; ++at) table_[shades[at].colour] = place;
    }
}

namespace {

/// A frame of a film: what differs from the frame before it, and all of the first.
struct FilmFrame {
    PixelRectangle area;                // at least one pixel
    std::vector<std::uint32_t> pixels;  // row by row, 0xAARRGGBB, colours times opacity
};

/// The frames of an animation, without gaps in time.
struct Film {
    int width = 0, height = 0;  // pixels
    bool opaque = true;
    std::vector<FilmFrame> frames;

    /// Changes `picture`, all pixels of a frame, into the next one.
    void show(std::size_t frame, std::vector<std::uint32_t>& picture) const {
        picture.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        const FilmFrame& change = frames.at(frame);
        auto from = change.pixels.begin();
        for (int y = change.area.top; y < change.area.top + change.area.height; ++y) {
            std::copy_n(
                from, change.area.width,
                picture.begin() + static_cast<std::ptrdiff_t>(y) * width + change.area.left);
            from += change.area.width;
        }
    }
};

constexpr double share_of_drawing = 0.7;  // the rest of the work is packing frames

void paint(cairo_t* context, const std::optional<Colour>& background) {
    if (!background) return;
    set_colour(context, *background);
    cairo_paint(context);
}

/// The rows of an image surface, one after the other.
std::vector<std::uint32_t> pixels_of(cairo_surface_t* surface, int width, int height, bool opaque) {
    cairo_surface_flush(surface);
    const unsigned char* const data = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const auto across = static_cast<std::size_t>(width), down = static_cast<std::size_t>(height);
    std::vector<std::uint32_t> pixels(across * down);
    for (std::size_t y = 0; y < down; ++y)
        std::memcpy(pixels.data() + y * across, data + y * stride, across * sizeof(std::uint32_t));
    if (opaque)
        for (std::uint32_t& pixel : pixels) pixel |= 0xff000000u;
    return pixels;
}

/// The least rectangle in which two pictures differ; one pixel if they are equal.
PixelRectangle difference(const std::vector<std::uint32_t>& before,
                          const std::vector<std::uint32_t>& after, int width, int height) {
    int left = width, right = -1, top = height, bottom = -1;
    for (int y = 0; y < height; ++y) {
        const auto row = static_cast<std::ptrdiff_t>(y) * width;
        const auto begin = after.begin() + row, end = begin + width;
        const auto first = std::mismatch(begin, end, before.begin() + row).first;
        if (first == end) continue;
        auto last = end;
        while (*(last - 1) == before[static_cast<std::size_t>(last - 1 - after.begin())]) --last;
        left = std::min(left, static_cast<int>(first - begin));
        right = std::max(right, static_cast<int>(last - begin) - 1);
        top = std::min(top, y);
        bottom = y;
    }
    if (right < 0) return {0, 0, 1, 1};
    return {left, top, right - left + 1, bottom - top + 1};
}

FilmFrame cut_out(const std::vector<std::uint32_t>& picture, const PixelRectangle& area,
                  int width) {
    FilmFrame frame;
    frame.area = area;
    for (int y = area.top; y < area.top + area.height; ++y) {
        const auto row = picture.begin() + static_cast<std::ptrdiff_t>(y) * width + area.left;
        frame.pixels.insert(frame.pixels.end(), row, row + area.width);
    }
    return frame;
}

/// Pictures of one size, one after the other, of which each has what the one before has not. `draw` draws a picture with its background. Throws
/// BoundReached if they need more memory than the budget has, and what drawing throws.
Film film(std::size_t count, int width, int height, bool opaque,
          const std::function<void(std::size_t, cairo_t*)>& draw, const Budget& budget) {
    Film result{width, height, opaque, {}};
    std::uint64_t taken = 0;
    std::vector<std::uint32_t> before;
    for (std::size_t i = 0; i < count; ++i) {
        budget.check();
        const OwnedSurface surface = blank_image(width, height, opaque);
        const OwnedContext context(cairo_create(surface.get()));
        check_cairo(context.get());
        draw(i, context.get());
        check_cairo(context.get());
        std::vector<std::uint32_t> picture = pixels_of(surface.get(), width, height, opaque);
        const PixelRectangle area = i == 0 ? PixelRectangle{0, 0, width, height}
                                           : difference(before, picture, width, height);
        taken += sizeof(std::uint32_t) * static_cast<std::uint64_t>(area.width) *
                 static_cast<std::uint64_t>(area.height);
        budget.check_memory(taken, "what changes from frame to frame of an animation");
        result.frames.push_back(cut_out(picture, area, width));
        before = std::move(picture);
    }
    return result;
}

/// Plates as frames, one each, by a plan of frames. `drawn` learns what was drawn.
Film film_of_plates(std::span<const Plate> plates, const Plan& plan, const Budget& budget,
                    Progress* progress, Drawn& drawn) {
    drawn.width = plan.page.width;
    drawn.height = plan.page.height;
    double all = 0, done = 0;
    for (const Plate& plate : plates) all += work(*plate.figure);
    all /= share_of_drawing;
    const auto draw = [&](std::size_t i, cairo_t* context) {
        const double next = done + work(*plates[i].figure);
        const Share share(progress, done / all, next / all);
        done = next;
        paint(context, plan.background);
        draw_plate(context, plan, i, plates[i], budget, share, drawn);
    };
    return film(plates.size(), static_cast<int>(plan.page.width),
                static_cast<int>(plan.page.height), plan.background.has_value(), draw, budget);
}

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

/// Writes an opaque film as an animated GIF (version 89a): what changes of each frame, with one table of
/// colours for all. `hundredths`: how long each frame is shown, in hundredths of a second, below
/// 65,536. `plays`: how often it is shown, below 65,536; 0 for ever.
///
/// Throws Error if the film has a side above 65,535 pixels, BoundReached for want
/// of memory, and what writing throws.
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

/// Writes a film as an animated WebP without any loss. Equal frames that follow each other become one
/// that is shown as long. `hundredths`: how long each frame is shown, in hundredths of a second.
/// `plays`: how often it is shown, below 65,536; 0 for ever.
///
/// Throws Error if the film has a side above 16,383 pixels, and what writing throws.
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

/// A file without a name, which is gone when this is.
class UnnamedFile {
public:
    UnnamedFile() {
        const char* const folder = std::getenv("TMPDIR");
        std::string name = std::string(folder && *folder ? folder : "/tmp") + "/algae-XXXXXX";
        descriptor = mkostemp(name.data(), O_CLOEXEC);
        if (descriptor < 0)
            throw Error("cannot write a temporary file in " + name.substr(0, name.rfind('/')) +
                        ": " + std::strerror(errno) + "; TMPDIR names another folder");
        unlink(name.c_str());
    }
    UnnamedFile(const UnnamedFile&) = delete;
    UnnamedFile& operator=(const UnnamedFile&) = delete;
    ~UnnamedFile() { close(descriptor); }

    /// Gives its bytes, from the first on, to `take`.
    template <class Take>
    void read_all(Take take) const {
        std::vector<char> bytes(1 << 16);
        off_t at = 0;
        for (;;) {
            const ssize_t got = pread(descriptor, bytes.data(), bytes.size(), at);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0)
                throw Error(std::string("cannot read a temporary file: ") + std::strerror(errno));
            if (got == 0) return;
            take(bytes.data(), static_cast<std::size_t>(got));
            at += got;
        }
    }

    int descriptor = -1;
};

/// Whether a program of this name can be started.
bool is_on_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::string rest = path ? path : "/usr/bin:/bin";
    for (std::size_t from = 0; from <= rest.size();) {
        const std::size_t to = std::min(rest.find(':', from), rest.size());
        const std::string folder = to > from ? rest.substr(from, to - from) : ".";
        if (access((folder + '/' + program).c_str(), X_OK) == 0) return true;
        from = to + 1;
    }
    return false;
}

/// A running ffmpeg that reads frames; it is killed where this ends before `finish`.
class Encoder {
public:
    /// The arguments without the name of the program. `output` is its descriptor 3.
    Encoder(std::vector<std::string> arguments, const UnnamedFile& output) {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
            throw Error(std::string("cannot start ffmpeg: ") + std::strerror(errno));
        ours_ = ends[0];
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
        posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, said_.descriptor, 2);
        posix_spawn_file_actions_adddup2(&actions, output.descriptor, 3);
        arguments.insert(arguments.begin(), "ffmpeg");
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        const int problem =
            posix_spawnp(&process_, "ffmpeg", &actions, nullptr, pointers.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
        if (problem != 0) {
            close(ours_);
            throw Error(std::string("cannot start ffmpeg: ") + std::strerror(problem));
        }
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() {
        if (ours_ >= 0) close(ours_);
        if (process_ <= 0) return;
        kill(process_, SIGKILL);
        while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    /// False if ffmpeg reads no more: `finish` says why.
    bool send_all(const char* bytes, std::size_t count, const Budget& budget) {
        while (count > 0) {
            budget.check();
            pollfd ready{ours_, POLLOUT, 0};
            if (poll(&ready, 1, 50) == 0) continue;  // it may be slow, and we may be told to stop
            const ssize_t sent = send(ours_, bytes, std::min<std::size_t>(count, 1 << 20),
                                      MSG_NOSIGNAL | MSG_DONTWAIT);
            if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
            if (sent < 0) return false;
            bytes += sent;
            count -= static_cast<std::size_t>(sent);
        }
        return true;
    }

    /// Waits for its end. Throws Error, with the last line that it said, unless all went well.
    void finish(const Budget& budget) {
        close(ours_);
        ours_ = -1;
        int status = 0;
        for (;;) {
            const pid_t ended = waitpid(process_, &status, WNOHANG);
            if (ended == process_) break;
            if (ended < 0 && errno != EINTR) break;
            budget.check();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        process_ = 0;
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
        constexpr std::size_t most = 300;
        std::string said;
        said_.read_all([&](const char* bytes, std::size_t count) { said.append(bytes, count); });
        while (!said.empty() && said.back() == '\n') said.pop_back();
        std::string last = said.substr(said.rfind('\n') + 1).substr(0, most);
        for (char& c : last)
            if (static_cast<unsigned char>(c) < 0x20) c = ' ';
        throw Error("ffmpeg could not pack the video" +
                    (last.empty() ? std::string(", and says no reason") : ": " + last));
    }

private:
    UnnamedFile said_;
    pid_t process_ = 0;
    int ours_ = -1;
};

/// How ffmpeg packs: sharp edges of few colours want a higher quality than films.
std::vector<std::string> codec_of(AnimationFormat format) {
    if (format == AnimationFormat::mp4)
        return {"-c:v",  "libx264",   "-preset",   "medium",     "-crf", "18",
                "-tune", "animation", "-movflags", "+faststart", "-f",   "mp4"};
    return {"-c:v",      "libvpx-vp9", "-crf",      "24", "-b:v", "0",
            "-deadline", "good",       "-cpu-used", "2",  "-f",   "webm"};
}

/// Writes an opaque film as a video. Sides become even by a last row or column twice. Throws Error if ffmpeg fails.
void write_video(const Film& film, std::span<const std::uint32_t> hundredths,
                 AnimationFormat format, Output& output, const Budget& budget) {
    std::uint32_t unit = 0;
    for (const std::uint32_t time : hundredths) unit = std::gcd(unit, time);
    unit = std::max<std::uint32_t>(1, unit);
    const auto across = static_cast<std::size_t>(film.width),
               down = static_cast<std::size_t>(film.height);
    const std::size_t wide = across + across % 2, high = down + down % 2;
    std::vector<std::string> arguments{"-hide_banner",
                                       "-nostdin",
                                       "-loglevel",
                                       "error",
                                       "-y",
                                       "-f",
                                       "rawvideo",
                                       "-pix_fmt",
                                       std::endian::native == std::endian::little ? "bgr0" : "0rgb",
                                       "-video_size",
                                       std::to_string(wide) + 'x' + std::to_string(high),
                                       "-framerate",
                                       "100/" + std::to_string(unit),
                                       "-i",
                                       "pipe:0",
                                       "-an",
                                       "-pix_fmt",
                                       "yuv420p",
                                       "-threads",
                                       "1",
                                       "-map_metadata",
                                       "-1",
                                       "-fflags",
                                       "+bitexact",
                                       "-flags:v",
                                       "+bitexact"};
    for (std::string& part : codec_of(format)) arguments.push_back(std::move(part));
    arguments.emplace_back("/dev/fd/3");

    const UnnamedFile packed;
    Encoder encoder(std::move(arguments), packed);
    std::vector<std::uint32_t> pixels, rows(wide * high);
    bool goes_on = true;
    for (std::size_t i = 0; i < film.frames.size() && goes_on; ++i) {
        film.show(i, pixels);
        for (std::size_t y = 0; y < high; ++y) {
            const auto from =
                pixels.begin() + static_cast<std::ptrdiff_t>(std::min(y, down - 1) * across);
            const auto to = rows.begin() + static_cast<std::ptrdiff_t>(y * wide);
            std::copy_n(from, across, to);
            if (wide > across) to[static_cast<std::ptrdiff_t>(across)] = from[film.width - 1];
        }
        for (std::uint32_t shown = 0; shown < hundredths[i] && goes_on; shown += unit)
            goes_on = encoder.send_all(reinterpret_cast<const char*>(rows.data()),
                                       rows.size() * sizeof rows[0], budget);
    }
    encoder.finish(budget);
    if (!goes_on) throw Error("ffmpeg ended before it had read all frames of the video");
    packed.read_all([&](const char* bytes, std::size_t count) {
        budget.check();
        output.write(bytes, count);
    });
}

constexpr double shortest_time = 0.02, longest_time = 600;  // seconds; programs slow down less

std::uint32_t hundredths(const char* what, double seconds) {
    if (!(seconds >= shortest_time && seconds <= longest_time))
        throw Error(std::string("the time of ") + what + " must be from " +
                    rounded_decimal(shortest_time, 6) + " to " + rounded_decimal(longest_time, 6) +
                    " seconds, not " + rounded_decimal(seconds, 6));
    return static_cast<std::uint32_t>(std::lround(100 * seconds));
}

std::vector<std::uint32_t> times(const AnimationTiming& timing, std::size_t frames) {
    const std::uint32_t each = hundredths("a frame", timing.frame);
    const double hold = std::clamp(3 * timing.frame, 2.0, longest_time);
    const std::uint32_t last = hundredths("the last frame", timing.last.value_or(hold));
    if (timing.plays > 65'535)
        throw Error("an animation is shown at most 65535 times, or for ever, not " +
                    std::to_string(timing.plays) + " times");
    std::vector<std::uint32_t> found(frames, each);
    if (!found.empty()) found.back() = last;
    return found;
}

}  // namespace

std::optional<AnimationFormat> animation_format(std::string_view path) {
    static constexpr std::array names{"gif", "webp", "mp4", "webm"};
    const auto found = format_of(names, path);
    if (!found || path.size() <= ending_of(path).size() + 1) return std::nullopt;
    return static_cast<AnimationFormat>(*found);
}

namespace {

/// Packs all frames before there is a file.
void write(const Film& frames, const Target& target, AnimationFormat format,
           const AnimationTiming& timing, const Budget& budget) {
    const std::vector<std::uint32_t> hundredths = times(timing, frames.frames.size());
    write_to(target, [&](Output& output) {
        if (format == AnimationFormat::gif)
            write_gif(frames, hundredths, timing.plays, output, budget);
        else if (format == AnimationFormat::webp)
            write_webp(frames, hundredths, timing.plays, output, budget);
        else
            write_video(frames, hundredths, format, output, budget);
    });
}

void check(AnimationFormat format, const std::optional<std::string>& background,
           const AnimationTiming& timing) {
    times(timing, 0);
    if (format != AnimationFormat::webp && background == "transparent")
        throw Error(
            "a gif or a video has no half-transparent pixels: expected a colour as its background, "
            "or webp");
    if (format != AnimationFormat::mp4 && format != AnimationFormat::webm) return;
    if (timing.plays != 0)
        throw Error("a video does not say how often it is shown; gif and webp do");
    if (!is_on_path("ffmpeg"))
        throw Error(
            "mp4 and webm are packed by the program ffmpeg, which is not on the PATH; expected it "
            "there (Debian: apt-get install ffmpeg), or .gif or .webp");
}

}  // namespace

Drawn draw_animation(std::span<const Plate> plates, const Target& target, AnimationFormat format,
                     const PictureOptions& options, const AnimationTiming& timing,
                     const Budget& budget, Progress* progress) {
    check(format, options.background, timing);
    const Plan decided = plan(plates, PictureFormat::png, Arrangement::frames, options, budget);
    Drawn drawn;
    write(film_of_plates(plates, decided, budget, progress, drawn), target, format, timing, budget);
    if (progress) progress->report(1);
    return drawn;
}

GraphDrawn draw_animation(std::span<const Graph> graphs, const Target& target,
                          AnimationFormat format, const GraphOptions& options,
                          const AnimationTiming& timing, const Budget& budget) {
    check(format, options.background, timing);
    std::vector<GraphPicture> pictures;
    GraphDrawn page;
    for (const Graph& graph : graphs) {
        pictures.push_back(graph_picture(graph, budget));
        page.width = std::max(page.width, pictures.back().width);
        page.height = std::max(page.height, pictures.back().height);
    }
    if (pictures.empty()) throw Error("expected at least one graph");
    const double scale = graph_scale(page, PictureFormat::png, options);
    const GraphDrawn drawn = graph_page(page, scale, PictureFormat::png);
    const std::optional<Colour> background = background_of(options.background, PictureFormat::png);
    const auto draw = [&](std::size_t i, cairo_t* context) {
        paint(context, background);
        cairo_scale(context, scale, scale);
        cairo_translate(context, (page.width - pictures[i].width) / 2,
                        (page.height - pictures[i].height) / 2);
        pictures[i].draw(context);
    };
    write(film(graphs.size(), static_cast<int>(drawn.width), static_cast<int>(drawn.height),
               background.has_value(), draw, budget),
          target, format, timing, budget);
    return drawn;
}

}  // namespace algae
