#include "oracle/morphisms.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace algae::oracle {

namespace {

bool is_palindrome(const std::string& word) {
    return word == std::string(word.rbegin(), word.rend());
}

}  // namespace

std::string mapped(const LetterImages& images, const std::string& word) {
    std::string found;
    for (const char letter : word) found += images[static_cast<std::size_t>(letter - 'a')];
    return found;
}

std::vector<std::string> words_to(std::size_t letters, std::size_t longest) {
    std::vector<std::string> found{""};
    for (std::size_t i = 0; i < found.size() && found[i].size() < longest; ++i)
        for (std::size_t a = 0; a < letters; ++a)
            found.push_back(found[i] + static_cast<char>('a' + a));
    return found;
}

std::optional<std::pair<std::string, std::string>> same_image_of(const LetterImages& images,
                                                                 std::size_t longest) {
    std::map<std::string, std::string> shortest;  // word by image
    std::optional<std::pair<std::string, std::string>> best;
    for (const std::string& word : words_to(images.size(), longest)) {
        const auto [at, is_new] = shortest.emplace(mapped(images, word), word);
        if (is_new) continue;
        if (!best || at->second.size() + word.size() < best->first.size() + best->second.size())
            best = std::pair(at->second, word);
    }
    return best;
}

std::vector<LetterImages> conjugates_of_morphism(const LetterImages& images) {
    std::set<LetterImages> seen{images};
    std::vector<LetterImages> found{images};
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const bool is_first : {true, false}) {
            std::set<char> letters;
            for (const std::string& image : found[i])
                if (!image.empty()) letters.insert(is_first ? image.front() : image.back());
            if (letters.size() != 1) continue;
            LetterImages next = found[i];
            for (std::string& image : next) {
                if (image.empty()) continue;
                image = is_first ? image.substr(1) + image.front()
                                 : image.back() + image.substr(0, image.size() - 1);
            }
            if (seen.insert(next).second) found.push_back(next);
        }
    return found;
}

bool is_class_p(const LetterImages& images) {
    for (std::size_t size = 0; size <= images.front().size(); ++size) {
        const std::string before = images.front().substr(0, size),
                          behind = images.front().substr(images.front().size() - size);
        const auto is_so = [&](const std::string& part, bool is_first) {
            return is_palindrome(part) &&
                   std::all_of(images.begin(), images.end(), [&](const std::string& image) {
                       if (image.size() < size) return false;
                       const std::string rest =
                           is_first ? image.substr(size) : image.substr(0, image.size() - size);
                       return (is_first ? part + rest : rest + part) == image &&
                              is_palindrome(rest);
                   });
        };
        if (is_so(before, true) || is_so(behind, false)) return true;
    }
    return false;
}

bool permutes_choices(const LetterImages& images, int things) {
    std::vector<int> first(static_cast<std::size_t>(things));
    std::iota(first.begin(), first.end(), 0);
    std::vector<std::vector<int>> group;
    do group.push_back(first);
    while (std::next_permutation(first.begin(), first.end()));
    std::set<std::vector<std::vector<int>>> seen;
    std::vector<std::size_t> choice(images.size(), 0);
    for (;;) {
        std::vector<std::vector<int>> image;
        for (const std::string& word : images) {
            std::vector<int> product = group.front();
            for (const char letter : word)
                for (int& at : product)
                    at = group[choice[static_cast<std::size_t>(letter - 'a')]]
                              [static_cast<std::size_t>(at)];
            image.push_back(product);
        }
        if (!seen.insert(image).second) return false;
        std::size_t i = 0;
        while (i < choice.size() && ++choice[i] == group.size()) choice[i++] = 0;
        if (i == choice.size()) return true;
    }
}

bool has_square(const std::string& word) {
    for (std::size_t begin = 0; begin < word.size(); ++begin)
        for (std::size_t size = 1; begin + 2 * size <= word.size(); ++size)
            if (word.substr(begin, size) == word.substr(begin + size, size)) return true;
    return false;
}

bool has_overlap(const std::string& word) {
    for (std::size_t begin = 0; begin < word.size(); ++begin)
        for (std::size_t size = 1; begin + 2 * size < word.size(); ++size)
            if (word.substr(begin, size + 1) == word.substr(begin + size, size + 1)) return true;
    return false;
}

}  // namespace algae::oracle
