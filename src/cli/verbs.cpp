#include "cli/command.hpp"

namespace algae::cli {

void add_verbs(Verbs& verbs) {
    verbs.app.description("algae derives L-systems exactly, analyses and draws them.");
    verbs.app.name("algae");
    verbs.app.set_version_flag("--version", "algae " ALGAE_VERSION, "Print the version and exit");
    verbs.app.require_subcommand(1);
    verbs.app.footer(
        "`algae VERB --help` shows examples. FILE is a file, - for standard input, or a name that\n"
        "`algae gallery` lists. Exit status: 0 success, 1 false, 2 bad usage or input,\n"
        "3 undecided or a bound was reached, 130 interrupted.");
    add_show(verbs);
    add_fmt(verbs);
    add_derive(verbs);
    add_letter(verbs);
    add_growth(verbs);
    add_member(verbs);
    add_finite(verbs);
    add_equal(verbs);
    add_is(verbs);
    add_check(verbs);
    add_closure(verbs);
    add_verify(verbs);
    add_draw(verbs);
    add_dimension(verbs);
    add_tree(verbs);
    add_figures(verbs);
    add_gallery(verbs);
    add_lesson(verbs);
    add_ifs(verbs);
    add_walk(verbs);
    add_brownian(verbs);
    add_terrain(verbs);
    add_dla(verbs);
    add_particles(verbs);
    add_ca(verbs);
    add_convert(verbs);
    add_manual(verbs);
}

}  // namespace algae::cli
