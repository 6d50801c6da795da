#include "render/steady.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace algae {
namespace {

constexpr std::string_view date_line = "%%CreationDate:";
constexpr std::string_view end_of_header = "%%EndComments";
constexpr std::size_t longest_reference = 64;
constexpr std::size_t passed_on_at_once = std::size_t{1} << 16;

bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }

}  // namespace

void UndatedOutput::write(const char* bytes, std::size_t count) {
    if (!in_header_) return next_.write(bytes, count);
    header_.append(bytes, count);
    if (header_.find(end_of_header) != std::string::npos) finish();
}

void UndatedOutput::finish() {
    if (!in_header_) return;
    in_header_ = false;
    const std::size_t start = header_.find(date_line);
    if (start != std::string::npos) {
        const std::size_t end = header_.find('\n', start);
        header_.erase(start, end == std::string::npos ? end : end + 1 - start);
    }
    next_.write(header_.data(), header_.size());
    header_.clear();
}

void RenumberedOutput::write(const char* bytes, std::size_t count) {
    held_.append(bytes, count);
    if (held_.size() >= passed_on_at_once) pass_on(false);
}

void RenumberedOutput::finish() { pass_on(true); }

void RenumberedOutput::pass_on(bool at_end) {
    // A name opens with a quotation mark, a reference with that and #; then comes "surface" or
    // "image" and its number. All else, which is nearly everything, is passed over quickly.
    const std::size_t end = held_.size();
    std::size_t done = 0, from = 0;
    const auto hold_back = [&](std::size_t place) {
        next_.write(held_.data() + done, place - done);
        held_.erase(0, place);
    };
    for (;;) {
        const std::size_t mark = held_.find('"', from);
        if (mark == std::string::npos) break;
        if (!at_end && mark + longest_reference > end) return hold_back(mark);
        from = mark + 1;
        if (from < end && held_[from] == '#') ++from;
        std::size_t digits = from;
        for (const std::string_view kind : {"surface", "image"})
            if (std::string_view(held_).substr(from).starts_with(kind)) digits = from + kind.size();
        std::size_t after = digits;
        while (digits != from && after < end && is_digit(held_[after])) ++after;
        if (after == digits) continue;
        const std::string number = held_.substr(digits, after - digits);
        const auto [known, added] = numbers_.try_emplace(number, numbers_.size() + 1);
        const std::string renumbered = std::to_string(known->second);
        next_.write(held_.data() + done, digits - done);
        next_.write(renumbered.data(), renumbered.size());
        done = from = after;
    }
    hold_back(end);
}

}  // namespace algae
