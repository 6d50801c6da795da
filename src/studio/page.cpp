// The page, which the assembler puts into the program as it lies in src/studio/built: as text in a source it would take the compiler
// a minute and a gigabyte.

#include "studio/studio.hpp"

__asm__(
    ".section .rodata\n"
    ".global algae_studio_page\n"
    ".global algae_studio_page_end\n"
    "algae_studio_page:\n"
    ".incbin \"" ALGAE_STUDIO_PAGE
    "\"\n"
    "algae_studio_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const char algae_studio_page[], algae_studio_page_end[];
}

namespace algae {

std::string_view studio_page() {
    return {algae_studio_page, static_cast<std::size_t>(algae_studio_page_end - algae_studio_page)};
}

}  // namespace algae
