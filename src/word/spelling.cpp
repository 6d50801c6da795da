#include "word/spelling.hpp"

namespace algae {

Spellings::Spellings(const Alphabet& alphabet) : alphabet_(&alphabet), blanks_(false) {
    // A blank is needed only next to a name that is long, ends in digits after a subscript, or is
    // one of the two marks that could be read as part of a longer name.
    for (Symbol a = 0; a < alphabet.size(); ++a) {
        const std::string& name = alphabet.name(a);
        blanks_ = blanks_ || !is_short_name(name) || name == "?" || name == "_" ||
                  (name.find('_') != std::string::npos && needs_blank(name, "0"));
    }
}

}  // namespace algae
