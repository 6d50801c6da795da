#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <ostream>
#include <set>
#include <system_error>
#include <utility>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/render.hpp"

// From a Cairo surface to the bytes of a file: the same bytes whenever they are made, and a file that appears whole or not at all.
//
// A document is a Cairo surface of one format whose bytes go through a chain of Outputs. Three things would make equal pictures
// unequal files. A PDF has a date, which Cairo leaves out when it is told an empty one. PostScript has a comment with the
// date: UndatedOutput holds the header back until its end and takes that line out. SVG numbers surfaces and images by counters
// of the process: RenumberedOutput finds those names, which open with a quotation mark (a reference with that and #), and numbers
// them from 1 in order of appearance; everything else passes through without being looked at.
//
// A file is written beside its place under a name of this process and of a counter, so that threads do not meet, and renamed
// at `commit`: until then a file of that name is as it was, and an error or a stop leaves nothing behind. A pipe or a device is
// written directly, and a symbolic link is followed, so that the link stays a link.
//
// Subtle: Cairo calls back to write, and an exception must not pass through C code. The sink keeps the exception, answers
// with an error of Cairo's own, and `finish` throws it. A document that is abandoned is wiped before it is destroyed: Cairo would
// otherwise work out everything that was drawn on it.

namespace algae {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

/// Names of temporary files differ between processes and, by the counter, between threads.
std::string temporary_name(const std::string& target) {
    static std::atomic<unsigned> counter{0};
    return target + ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
}

// --- Files that are kept, and files that are not finished ---

struct Kept {
    std::mutex guard;
    std::set<std::pair<dev_t, ino_t>> inputs;
    bool all = false;
};
Kept& kept() {
    static Kept files;
    return files;
}

/// The names of temporary files, where a handler of signals finds them.
constexpr std::size_t most_unfinished = 64;
std::array<std::atomic<const char*>, most_unfinished> unfinished{};

void set_unfinished(const char* from, const char* to) {
    for (auto& place : unfinished) {
        const char* expected = from;
        if (place.compare_exchange_strong(expected, to)) return;
    }
}

constexpr std::string_view date_line = "%%CreationDate:";
constexpr std::string_view end_of_header = "%%EndComments";
constexpr std::size_t longest_reference = 64;
constexpr std::size_t passed_on_at_once = std::size_t{1} << 16;

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

[[noreturn]] void fail(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    throw Error(std::string("the picture cannot be drawn: ") + cairo_status_to_string(status));
}

}  // namespace

void keep_input(const std::string& path) {
    struct stat file;
    if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return;
    const std::lock_guard lock(kept().guard);
    kept().inputs.emplace(file.st_dev, file.st_ino);
}

void keep_all_files() {
    const std::lock_guard lock(kept().guard);
    kept().all = true;
}

void remove_unfinished_files() noexcept {
    for (const auto& place : unfinished)
        if (const char* const name = place.load()) ::unlink(name);
}

FileOutput::FileOutput(const std::string& path, bool is_input) : path_(path), target_(path) {
    namespace files = std::filesystem;
    std::error_code ignored;
    if (path.empty()) throw Error("cannot write a file without a name");
    buffer_.reserve(buffer_size);  // before there is a file that an exception would leave
    if (files::is_symlink(path, ignored)) {
        const files::path leads_to = files::weakly_canonical(path, ignored);
        if (!ignored) target_ = leads_to.string();
    }
    const files::file_status status = files::status(target_, ignored);
    if (status.type() == files::file_type::none) fail(ignored.value());  // links in a circle
    if (files::is_directory(status)) fail(EISDIR);
    if (files::is_regular_file(status)) {
        struct stat there;
        const std::lock_guard lock(kept().guard);
        if (!is_input && ::stat(target_.c_str(), &there) == 0 &&
            kept().inputs.count({there.st_dev, there.st_ino}) > 0)
            throw Error("cannot write " + path + ": it was read as input; expected another name");
        if (kept().all)
            throw Error("cannot write " + path +
                        ": it is there already, and files that are there are kept");
    }
    if (files::exists(status) && ::access(target_.c_str(), W_OK) != 0) fail(errno);

    const bool direct = files::exists(status) && !files::is_regular_file(status);
    if (!direct) temporary_ = temporary_name(target_);
    const int flags = O_WRONLY | O_CLOEXEC | (direct ? 0 : O_CREAT | O_EXCL);
    descriptor_ = ::open(direct ? target_.c_str() : temporary_.c_str(), flags, 0666);
    if (descriptor_ < 0) {
        const int reason = errno;
        temporary_.clear();
        fail(reason);
    }
    struct stat old;
    if (!direct && ::stat(target_.c_str(), &old) == 0) ::fchmod(descriptor_, old.st_mode & 07777);
    if (!direct) set_unfinished(nullptr, temporary_.c_str());
}

FileOutput::~FileOutput() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (temporary_.empty()) return;
    ::unlink(temporary_.c_str());
    set_unfinished(temporary_.c_str(), nullptr);
}

void FileOutput::fail(int reason) const {
    throw Error("cannot write " + path_ + ": " + std::generic_category().message(reason));
}

void FileOutput::flush() {
    std::size_t written = 0;
    while (written < buffer_.size()) {
        const ssize_t count =
            ::write(descriptor_, buffer_.data() + written, buffer_.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(errno);
        written += static_cast<std::size_t>(count);
    }
    buffer_.clear();
}

void FileOutput::write(const char* bytes, std::size_t count) {
    buffer_.append(bytes, count);
    if (buffer_.size() >= buffer_size) flush();
}

void FileOutput::commit() {
    flush();
    const int descriptor = descriptor_;
    descriptor_ = -1;
    // Its bytes are on the disk before its name is: a machine that stops leaves the old file or the new one.
    const bool is_synced = temporary_.empty() || ::fsync(descriptor) == 0 || errno == EINVAL;
    const int reason = errno;
    if (::close(descriptor) != 0) fail(errno);
    if (!is_synced) fail(reason);
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    set_unfinished(temporary_.c_str(), nullptr);
    temporary_.clear();
    // Its name is on the disk too. Where that cannot be, the machine that stops leaves the old name or the new one.
    const std::string folder = std::filesystem::path(target_).parent_path().string();
    const int above =
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (above < 0) return;
    ::fsync(above);
    ::close(above);
}

void StreamOutput::write(const char* bytes, std::size_t count) {
    errno = 0;
    stream_.write(bytes, static_cast<std::streamsize>(count));
    check();
}

void StreamOutput::finish() {
    errno = 0;
    stream_.flush();
    check();
}

void StreamOutput::check() const {
    const int reason = errno;
    if (stream_.good()) return;
    throw Error("cannot write the picture" +
                (reason ? ": " + std::generic_category().message(reason) : std::string()));
}

std::string ending_of(std::string_view path) {
    const std::size_t slash = path.find_last_of('/'), dot = path.find_last_of('.');
    std::string ending;
    if (dot != std::string_view::npos && (slash == std::string_view::npos || dot > slash))
        ending = path.substr(dot + 1);
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return ending;
}

std::optional<Colour> background_of(const std::optional<std::string>& wanted,
                                    PictureFormat format) {
    if (!wanted)
        return format == PictureFormat::png ? std::optional(Colour{1, 1, 1}) : std::nullopt;
    if (*wanted == "transparent") return std::nullopt;
    return colour_named(*wanted);
}

void write_to(const Target& target, const std::function<void(Output&)>& write) {
    if (target.stream) {
        StreamOutput output(*target.stream);
        write(output);
        return output.finish();
    }
    FileOutput file(target.path);
    write(file);
    file.commit();
}

void set_colour(cairo_t* context, const Colour& colour, double opacity) {
    cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, opacity);
}

void choose_font(cairo_t* context, const char* family, double size, bool bold) {
    cairo_select_font_face(context, family, CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, size);
}

double text_width(cairo_t* context, const std::string& text) {
    cairo_text_extents_t extents{};
    cairo_text_extents(context, text.c_str(), &extents);
    return extents.x_advance;
}

void show_text(cairo_t* context, const std::string& text, double x, double y) {
    cairo_move_to(context, x, y);
    cairo_show_text(context, text.c_str());
    cairo_new_path(context);
}

void draw_line(cairo_t* context, const Point& from, const Point& to) {
    cairo_move_to(context, from.x, from.y);
    cairo_line_to(context, to.x, to.y);
    cairo_stroke(context);
}

void fill_and_outline(cairo_t* context, const Colour& fill, const Colour& outline, double width) {
    set_colour(context, fill);
    cairo_fill_preserve(context);
    set_colour(context, outline);
    cairo_set_line_width(context, width);
    cairo_stroke(context);
}

void must_be_finite(double coordinates) {
    if (!std::isfinite(coordinates))
        throw Error("the figure has a point whose coordinates are beyond the range of numbers");
}

std::optional<std::size_t> format_of(std::span<const char* const> names, std::string_view path) {
    const auto found = std::ranges::find(names, ending_of(path));
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

void UndatedOutput::write(const char* bytes, std::size_t count) {
    if (!in_header_) return next_.write(bytes, count);
    header_.append(bytes, count);
    if (header_.find(end_of_header) != std::string::npos) finish();
}

void UndatedOutput::finish() {
    if (!in_header_) return;
    in_header_ = false;
    const std::size_t start = header_.find(date_line);
    if (start != std::string::npos) {
        const std::size_t end = header_.find('\n', start);
        header_.erase(start, end == std::string::npos ? end : end + 1 - start);
    }
    next_.write(header_.data(), header_.size());
    header_.clear();
}

void RenumberedOutput::write(const char* bytes, std::size_t count) {
    held_.append(bytes, count);
    if (held_.size() >= passed_on_at_once) pass_on(false);
}

void RenumberedOutput::finish() { pass_on(true); }

void RenumberedOutput::pass_on(bool at_end) {
    // A name opens with a quotation mark, a reference with that and #; then comes "surface" or
    // "image" and its number. All else, which is nearly everything, is passed over quickly.
    const std::size_t end = held_.size();
    std::size_t done = 0, from = 0;
    const auto hold_back = [&](std::size_t place) {
        next_.write(held_.data() + done, place - done);
        held_.erase(0, place);
    };
    for (;;) {
        const std::size_t mark = held_.find('"', from);
        if (mark == std::string::npos) break;
        if (!at_end && mark + longest_reference > end) return hold_back(mark);
        from = mark + 1;
        if (from < end && held_[from] == '#') ++from;
        std::size_t digits = from;
        for (const std::string_view kind : {"surface", "image"})
            if (std::string_view(held_).substr(from).starts_with(kind)) digits = from + kind.size();
        std::size_t after = digits;
        while (digits != from && after < end && is_digit(held_[after])) ++after;
        if (after == digits) continue;
        const std::string number = held_.substr(digits, after - digits);
        const auto [known, added] = numbers_.try_emplace(number, numbers_.size() + 1);
        const std::string renumbered = std::to_string(known->second);
        next_.write(held_.data() + done, digits - done);
        next_.write(renumbered.data(), renumbered.size());
        done = from = after;
    }
    hold_back(end);
}

void CairoRelease::operator()(cairo_t* context) const { cairo_destroy(context); }
void CairoRelease::operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }

OwnedSurface blank_image(double width, double height, bool opaque) {
    return OwnedSurface(
        cairo_image_surface_create(opaque ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                   static_cast<int>(width), static_cast<int>(height)));
}

/// What Cairo's write function is given. An exception must not pass through Cairo, so it waits.
struct Document::Sink {
    Sink(PictureFormat format, Output& output, const Budget& allowed)
        : undated(output), renumbered(output), budget(allowed) {
        if (format == PictureFormat::ps || format == PictureFormat::eps)
            next = &undated;
        else if (format == PictureFormat::svg)
            next = &renumbered;
        else
            next = &output;
    }

    static cairo_status_t write(void* closure, const unsigned char* bytes, unsigned int count) {
        Sink& sink = *static_cast<Sink*>(closure);
        if (sink.problem || sink.abandoned) return CAIRO_STATUS_WRITE_ERROR;
        try {
            sink.budget.check();
            sink.next->write(reinterpret_cast<const char*>(bytes), count);
            return CAIRO_STATUS_SUCCESS;
        } catch (...) {
            sink.problem = std::current_exception();
            return CAIRO_STATUS_WRITE_ERROR;
        }
    }

    UndatedOutput undated;
    RenumberedOutput renumbered;
    Output* next = nullptr;
    const Budget& budget;
    std::exception_ptr problem;
    bool abandoned = false;
};

Document::Document(PictureFormat format, double width, double height,
                   std::optional<Colour> background, Output& output, const Budget& budget)
    : format_(format),
      background_(background),
      sink_(std::make_unique<Sink>(format, output, budget)) {
    switch (format) {
        case PictureFormat::png:
            surface_ = blank_image(width, height, background.has_value()).release();
            break;
        case PictureFormat::svg:
            surface_ = cairo_svg_surface_create_for_stream(Sink::write, sink_.get(), width, height);
            break;
        case PictureFormat::pdf:
            surface_ = cairo_pdf_surface_create_for_stream(Sink::write, sink_.get(), width, height);
            // A date that is none is left out.
            cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_CREATE_DATE, "");
            break;
        case PictureFormat::ps:
        case PictureFormat::eps:
            surface_ = cairo_ps_surface_create_for_stream(Sink::write, sink_.get(), width, height);
            cairo_ps_surface_set_eps(surface_, format == PictureFormat::eps);
            break;
    }
    context_ = cairo_create(surface_);
    try {
        check();
        paint_background();
    } catch (...) {
        cairo_destroy(context_);
        cairo_surface_destroy(surface_);
        throw;
    }
}

Document::~Document() {
    sink_->abandoned = true;
    if (context_) {
        // Cairo would still work out all that was drawn; wiped out, there is nothing to work out.
        cairo_reset_clip(context_);
        cairo_set_operator(context_, CAIRO_OPERATOR_CLEAR);
        cairo_paint(context_);
        cairo_destroy(context_);
    }
    if (surface_) cairo_surface_destroy(surface_);
}

void Document::paint_background() {
    if (!background_) return;
    set_colour(context_, *background_);
    cairo_paint(context_);
}

void Document::say(const std::string& title, const std::string& author) {
    if (format_ != PictureFormat::pdf) return;
    if (!title.empty())
        cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_TITLE, title.c_str());
    if (!author.empty())
        cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_AUTHOR, author.c_str());
}

void Document::next_page() {
    cairo_show_page(context_);
    check();
    paint_background();
}

void Document::check() const {
    if (sink_->problem) std::rethrow_exception(sink_->problem);
    check_cairo(context_);
}

void Document::finish() {
    check();
    cairo_status_t status = CAIRO_STATUS_SUCCESS;
    if (format_ == PictureFormat::png) {
        status = cairo_surface_write_to_png_stream(surface_, Sink::write, sink_.get());
    } else {
        cairo_destroy(context_);
        context_ = nullptr;
        cairo_surface_finish(surface_);
        status = cairo_surface_status(surface_);
    }
    if (sink_->problem) std::rethrow_exception(sink_->problem);
    if (status != CAIRO_STATUS_SUCCESS) fail(status);
    if (sink_->next == &sink_->undated) sink_->undated.finish();
    if (sink_->next == &sink_->renumbered) sink_->renumbered.finish();
}

void check_cairo(cairo_t* context) {
    cairo_status_t status = cairo_status(context);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(cairo_get_target(context));
    if (status != CAIRO_STATUS_SUCCESS) fail(status);
}

std::string escaped_markup(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '"')
            out += "&quot;";
        else if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else
            out += c;
    }
    return out;
}

}  // namespace algae
