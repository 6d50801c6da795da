#include "render/graph_letter.hpp"

namespace algae {

Graph::Node letter_node(const Alphabet& alphabet, Symbol letter) {
    Graph::Node node;
    node.label = alphabet.name(letter);
    const std::size_t mark = node.label.find('_');
    if (mark == std::string::npos || mark == 0 || mark + 1 == node.label.size() ||
        !is_short_name(node.label))
        return node;
    node.subscript = node.label.substr(mark + 1);
    node.label.resize(mark);
    return node;
}

}  // namespace algae
