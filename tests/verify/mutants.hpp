#pragma once

// Certificates with changed tokens, and what becomes of them: verify rejects a mutant, or it accepts a statement, which
// must then be true. A mutant holds one statement of its certificate and the systems. Everything follows from the seed.

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "oracle/certificate_truth.hpp"
#include "verify/verify.hpp"

namespace mutants {

using Json = nlohmann::ordered_json;

/// What became of some mutants.
struct Counts {
    std::size_t mutants = 0, rejected = 0;
    std::size_t same = 0;  // accepted: it says what the original does
    std::size_t confirmed =
        0;                  // accepted: it says something else, which the second route finds true
    std::size_t open = 0;   // accepted, and not decided by the second route
    std::size_t wrong = 0;  // accepted and false
    std::vector<std::string> examples = {};  // of those that are false

    void add(const Counts& other) {
        mutants += other.mutants;
        rejected += other.rejected;
        same += other.same;
        confirmed += other.confirmed;
        open += other.open;
        wrong += other.wrong;
        examples.insert(examples.end(), other.examples.begin(), other.examples.end());
    }
};

/// A certificate with one of the statements.
inline Json with_statement(const Json& certificate, std::size_t index) {
    Json one = certificate;
    one["statements"] = Json::array({certificate["statements"][index]});
    return one;
}

/// What verify says of the only statement; nothing where the certificate is refused.
inline std::optional<algae::verify::Finding> found(const Json& certificate,
                                                   std::chrono::milliseconds time) {
    algae::Budget budget;
    budget.memory = 64 << 20;
    budget.deadline = std::chrono::steady_clock::now() + time;
    try {
        const auto all = algae::verify::check_certificate(certificate.dump(), "x", budget);
        return all.empty() ? std::nullopt : std::optional(all.front());
    } catch (const algae::Error&) {
        return std::nullopt;
    } catch (const algae::BoundReached&) {
        return std::nullopt;
    }
}

class Mutator {
public:
    using Numbers = std::function<std::uint64_t()>;

    explicit Mutator(std::uint64_t seed) : random_(std::mt19937_64(seed)) {}
    /// Everything follows from these numbers.
    explicit Mutator(Numbers numbers) : random_(std::move(numbers)) {}

    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

    /// The certificate with one or two changes; `other` is one that parts are taken from.
    Json operator()(const Json& certificate, const Json& other) {
        Json changed = certificate;
        for (std::size_t left = 1 + below(3) / 2; left > 0; --left) change(changed, other);
        return changed;
    }

private:
    using Place = Json::json_pointer;

    /// All places of the statements and systems.
    static void note(const Json& value, const Place& at, std::vector<Place>& places) {
        places.push_back(at);
        if (value.is_object())
            for (const auto& [key, part] : value.items()) note(part, at / key, places);
        if (value.is_array())
            for (std::size_t i = 0; i < value.size(); ++i) note(value[i], at / i, places);
    }
    static std::vector<Place> places_of(const Json& certificate) {
        std::vector<Place> places;
        note(certificate["systems"], Place("/systems"), places);
        if (certificate["statements"].empty()) return places;
        // The statement comes first and again, as it is small beside its proof.
        const Place statement("/statements/0/statement");
        for (int i = 0; i < 3 && certificate.contains(statement); ++i)
            note(certificate[statement], statement, places);
        note(certificate["statements"], Place("/statements"), places);
        return places;
    }

    void change(Json& certificate, const Json& other) {
        const std::vector<Place> places = places_of(certificate);
        const Place place = places[below(places.size())];
        Json& value = certificate[place];
        if (below(8) == 0) return take_from(place, value, other);
        if (value.is_number()) {
            const std::uint64_t number =
                value.is_number_unsigned() ? value.get<std::uint64_t>() : 0;
            const std::uint64_t numbers[] = {
                number + 1, number > 0 ? number - 1 : 2, 0, 1, 2 * number, below(10)};
            value = numbers[below(6)];
        } else if (value.is_boolean()) {
            value = !value.get<bool>();
        } else if (value.is_string()) {
            change_text(value, certificate["alphabet"]);
        } else if (value.is_array() && !value.empty()) {
            const std::size_t i = below(value.size()), j = below(value.size());
            const std::size_t way = below(3);
            if (way == 0) value.erase(i);
            if (way == 1) value.push_back(Json(value[i]));
            if (way == 2) std::swap(value[i], value[j]);
        } else if (value.is_object() && !value.empty()) {
            const auto at = [&] {
                return std::next(value.begin(), static_cast<std::ptrdiff_t>(below(value.size())));
            };
            const auto left = at(), right = at();
            if (below(3) == 0)
                value.erase(left);
            else if (below(6) == 0 && place.to_string().ends_with("/statement"))
                value = Json{{"not", value}};
            else
                std::swap(left.value(), right.value());
        }
    }

    /// Puts what stands at the same place of another certificate here, or what has the same key.
    void take_from(const Place& place, Json& value, const Json& other) {
        if (other.contains(place)) {
            value = other[place];
            return;
        }
        if (place.empty()) return;
        std::vector<Place> there;
        for (const Place& each : places_of(other))
            if (!each.empty() && each.back() == place.back()) there.push_back(each);
        if (!there.empty()) value = other[there[below(there.size())]];
    }

    void change_text(Json& value, const Json& alphabet) {
        static const std::vector<std::string> known{
            "proved", "refuted",   "0L",   "P0L",       "D0L",    "PD0L",      "T0L",   "E0L",
            "ET0L",   "EDT0L",     "IL",   "REG",       "CF",     "finite",    "empty", "values",
            "word",   "identical", "form", "relations", "closed", "membership"};
        const auto text = value.get<std::string>();
        if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos &&
            below(2) == 0) {
            value = std::to_string(std::stoull(text.substr(0, 15)) + below(5) - (below(2) ? 1 : 0));
            return;
        }
        std::vector<std::string> letters;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find(' ', begin), text.size());
            letters.push_back(text.substr(begin, end - begin));
            begin = end + 1;
        }
        const std::string new_letter =
            alphabet.empty() ? "a" : alphabet[below(alphabet.size())].get<std::string>();
        const std::size_t way = below(6);
        if (way == 0 && below(3) == 0) {
            value = known[below(known.size())];
            return;
        }
        const std::size_t i = below(letters.size() + 1);
        if (way <= 1)
            letters.insert(letters.begin() + static_cast<std::ptrdiff_t>(i), new_letter);
        else if (!letters.empty() && way == 2)
            letters.erase(letters.begin() + static_cast<std::ptrdiff_t>(i % letters.size()));
        else if (!letters.empty() && way <= 4)
            letters[i % letters.size()] = new_letter;
        else if (!letters.empty())
            std::swap(letters[i % letters.size()], letters[below(letters.size())]);
        std::string changed;
        for (const std::string& letter : letters) changed += (changed.empty() ? "" : " ") + letter;
        value = changed;
    }

    Numbers random_;
};

/// What another checker is to be asked of, too: a mutant, and what verify finds.
using OnMutant = std::function<void(const Json&, const std::optional<algae::verify::Finding>&)>;

/// Judges so many mutants of a certificate of one statement.
inline Counts judged(const Json& certificate, const Json& other, std::size_t count, Mutator& mutate,
                     std::chrono::milliseconds time, const OnMutant& on_mutant = {}) {
    Counts counts;
    for (std::size_t n = 0; n < count; ++n) {
        const Json mutant = mutate(certificate, other);
        if (mutant == certificate) continue;
        ++counts.mutants;
        const auto finding = found(mutant, time);
        if (on_mutant) on_mutant(mutant, finding);
        if (!finding || finding->outcome != algae::verify::Finding::Outcome::checked) {
            ++counts.rejected;
            continue;
        }
        const Json &before = certificate["statements"][0], &now = mutant["statements"][0];
        if (mutant["systems"] == certificate["systems"] &&
            now["statement"] == before["statement"] && now["verdict"] == before["verdict"]) {
            ++counts.same;
            continue;
        }
        algae::Budget budget;
        budget.memory = 256 << 20;
        budget.deadline = std::chrono::steady_clock::now() + 10 * time;
        const auto truth = algae::oracle::truth_of(mutant, now["statement"], budget);
        const bool claimed = now["verdict"] == "proved";
        if (!truth.holds) {
            ++counts.open;
        } else if (*truth.holds == claimed) {
            ++counts.confirmed;
        } else {
            ++counts.wrong;
            counts.examples.push_back(finding->statement + "\n" + truth.by + "\n" +
                                      Json(mutant["systems"]).dump() + "\n" + now.dump());
        }
    }
    return counts;
}

}  // namespace mutants
