#include "cli/manual.hpp"

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"

namespace algae::cli {

namespace {

struct Options {
    const CLI::App* app = nullptr;
    bool page = false, bash = false, zsh = false, fish = false;
};

int manual(const Options& options) {
    const std::vector<VerbEntry> table = verb_table(*options.app);
    if (options.page + options.bash + options.zsh + options.fish != 1)
        throw Error("expected one of --man, --bash, --zsh and --fish");
    print(options.page   ? manual_page(table)
          : options.bash ? bash_completion(table)
          : options.zsh  ? zsh_completion(table)
                         : fish_completion(table));
    return success;
}

}  // namespace

void add_manual(Verbs& verbs) {
    auto options = std::make_shared<Options>();
    options->app = &verbs.app;
    CLI::App& verb = add_verb(
        verbs, "manual", "The manual page, and completions of verbs and options for shells",
        "  algae manual --man > algae.1\n  source <(algae manual --bash)", options, manual);
    verb.group("");  // for who installs algae
    verb.add_flag("--man", options->page, "the page algae(1), in the language of man");
    verb.add_flag("--bash", options->bash, "completions for bash");
    verb.add_flag("--zsh", options->zsh, "completions for zsh");
    verb.add_flag("--fish", options->fish, "completions for fish");
}

}  // namespace algae::cli
