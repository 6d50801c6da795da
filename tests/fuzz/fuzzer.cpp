// The program of tools/fuzz: libFuzzer with the target that TARGET in the environment names. `--list` prints the targets,
// `--seeds NAME DIR` writes the seeds of one and its dictionary.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "fuzz/targets.hpp"

namespace {

using namespace algae::fuzz;

const Target* chosen = nullptr;

[[noreturn]] void refuse(const char* name) {
    std::fprintf(stderr, "expected the name of a target, found \"%s\"; --list prints them\n",
                 name != nullptr ? name : "");
    std::exit(2);
}

const Target& known(const char* name) {
    const Target* found = name != nullptr ? target(name) : nullptr;
    if (found == nullptr) refuse(name);
    return *found;
}

/// A word as dictionaries of libFuzzer have it.
std::string quoted(const std::string& word) {
    std::string text = "\"";
    for (const char c : word) {
        char code[8];
        std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(c));
        text += c == '"' || c == '\\' || c < ' ' ? code : std::string(1, c);
    }
    return text + '"';
}

/// `DIR/seeds/0, 1, ...` and `DIR/dictionary`.
void write_seeds(const Target& of, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "seeds");
    std::size_t count = 0;
    for (const std::string& text : seeds(of))
        std::ofstream(folder / "seeds" / std::to_string(count++), std::ios::binary) << text;
    std::ofstream words(folder / "dictionary", std::ios::binary);
    for (const std::string& word : dictionary(of)) words << quoted(word) << '\n';
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    const auto argument = [&](int i) { return i < *argc ? (*argv)[i] : nullptr; };
    if (*argc > 1 && std::strcmp(argument(1), "--list") == 0) {
        for (const Target& each : targets())
            std::printf("%s\t%zu\t%s\n", each.name.c_str(), each.longest, each.what.c_str());
        std::exit(0);
    }
    if (*argc > 3 && std::strcmp(argument(1), "--seeds") == 0) {
        write_seeds(known(argument(2)), argument(3));
        std::exit(0);
    }
    chosen = &known(std::getenv("TARGET"));
    return 0;
}

// What comes out of `run` is a defect: nothing catches it, so libFuzzer keeps the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    run(*chosen, {reinterpret_cast<const char*>(data), size});
    return 0;
}
