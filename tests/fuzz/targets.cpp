#include "fuzz/targets.hpp"
#include "places.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>

namespace algae::fuzz {

namespace fs = std::filesystem;

const std::vector<Target>& targets() {
    static const std::vector<Target> all = [] {
        std::vector<Target> joined;
        for (auto part : {readers(), certificates(), comparisons()})
            joined.insert(joined.end(), part.begin(), part.end());
        return joined;
    }();
    return all;
}

const Target* target(std::string_view name) {
    const auto found = std::ranges::find(targets(), name, &Target::name);
    return found == targets().end() ? nullptr : &*found;
}

void run(const Target& target, std::string_view bytes) {
    try {
        target.take(bytes);
    } catch (const Diagnostics& error) {
        for (const Diagnostic& finding : error.findings()) {
            expect(!finding.message.empty(), "a finding says what is wrong");
            expect(!finding.text().empty(), "a finding can be printed");
        }
    } catch (const Error& error) {
        expect(*error.what() != '\0', "an error says what is wrong");
    } catch (const Stopped&) {
    }
}

Texts seeds(const Target& target) {
    std::set<std::string> texts;
    for (std::string& text : target.seeds())
        if (text.size() <= target.longest) texts.insert(std::move(text));
    return {texts.begin(), texts.end()};
}

Texts dictionary(const Target& target) {
    constexpr std::size_t most = 250, longest = 24;
    std::map<std::string, std::size_t> times;
    for (const std::string& text : seeds(target)) {
        std::set<std::string> words;  // each counts once a text
        const auto kind = [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte <= ' ' || byte == 127) return 0;
            return byte >= 128 || std::isalnum(byte) != 0 || byte == '_' ? 1 : 2;
        };
        for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
            end = begin + 1;
            while (end < text.size() && kind(text[end]) == kind(text[begin])) ++end;
            if (kind(text[begin]) != 0 && end - begin <= longest && end - begin > 1)
                words.insert(text.substr(begin, end - begin));
        }
        for (const std::string& word : words) ++times[word];
    }
    std::vector<std::pair<std::size_t, std::string>> ordered;
    for (const auto& [word, count] : times)
        if (count > 1) ordered.emplace_back(count, word);
    std::ranges::stable_sort(ordered, std::greater<>(),
                             [](const auto& each) { return each.first; });
    Texts found;
    for (const auto& [count, word] : ordered)
        if (found.size() < most) found.push_back(word);
    return found;
}

Budget small_budget() {
    Budget budget;
    budget.letters = 5'000;
    budget.memory = 8 << 20;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
    return budget;
}

namespace {

/// The texts of the files below these folders whose names end so.
Texts texts_of(const std::vector<std::string>& folders, const std::string& ending) {
    Texts texts;
    for (const std::string& folder : folders)
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(source_folder()) / folder)) {
            if (!entry.is_regular_file() || !entry.path().string().ends_with(ending)) continue;
            std::ifstream file(entry.path(), std::ios::binary);
            std::ostringstream text;
            text << file.rdbuf();
            texts.push_back(text.str());
        }
    std::ranges::sort(texts);
    return texts;
}

}  // namespace

std::function<Texts()> files(std::vector<std::string> folders, std::string ending) {
    return [folders, ending] { return texts_of(folders, ending); };
}

std::function<Texts()> lines(std::vector<std::string> folders, std::string ending,
                             std::string beginning) {
    return [folders, ending, beginning] {
        Texts found;
        for (const std::string& text : texts_of(folders, ending)) {
            std::istringstream read(text);
            for (std::string line; std::getline(read, line);)
                if (line.starts_with(beginning) && line.size() > beginning.size())
                    found.push_back(line.substr(beginning.size()));
        }
        return found;
    };
}

std::function<Texts()> random_bytes(std::size_t count, std::size_t length) {
    return [=] {
        std::mt19937 random(1);
        Texts texts(count, std::string(length, ' '));
        for (std::string& text : texts)
            for (char& byte : text) byte = static_cast<char>(random() % 256);
        return texts;
    };
}

}  // namespace algae::fuzz
