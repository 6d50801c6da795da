#include "render/document.hpp"

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <new>

#include "base/error.hpp"
#include "render/steady.hpp"

namespace algae {
namespace {

[[noreturn]] void fail(cairo_status_t status) {
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    throw Error(std::string("the picture cannot be drawn: ") + cairo_status_to_string(status));
}

}  // namespace

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
            surface_ =
                cairo_image_surface_create(background ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32,
                                           static_cast<int>(width), static_cast<int>(height));
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
    cairo_set_source_rgb(context_, background_->red, background_->green, background_->blue);
    cairo_paint(context_);
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

}  // namespace algae
