#include "word/lifetimes.hpp"

namespace algae {

std::vector<std::uint64_t> lifetimes(const std::vector<Word>& images) {
    std::vector<std::uint64_t> lifetime(images.size(), lasts);
    std::vector<std::size_t> alive(images.size());  // letters of the image that are not known to die
    std::vector<std::vector<Symbol>> occurs_in(images.size());
    std::vector<Symbol> dying;
    for (Symbol a = 0; a < images.size(); ++a) {
        alive[a] = images[a].size();
        for (const Symbol b : images[a]) occurs_in[b].push_back(a);
        if (alive[a] == 0) {
            lifetime[a] = 1;
            dying.push_back(a);
        }
    }
    for (std::size_t i = 0; i < dying.size(); ++i)  // in the order of their lifetimes
        for (const Symbol a : occurs_in[dying[i]])
            if (--alive[a] == 0) {
                lifetime[a] = lifetime[dying[i]] + 1;
                dying.push_back(a);
            }
    return lifetime;
}

}  // namespace algae
