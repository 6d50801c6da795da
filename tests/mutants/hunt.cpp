// Looks for changed certificates by which verify's mutants are noticed that survive; tools/mutants builds and runs it.
//
//     PROGRAM collect FILE CERTIFICATES    runs all tests, and writes cases to FILE (see tests/verify/changed.hpp): those of the
//                                        certificates that tests check, and of CERTIFICATES, a line each, that reach other mutants
//     PROGRAM hunt FILE ALIVE OUT SECONDS SEED   changes cases of FILE at random, checks each as it should be and with each of the
//                                        mutants of ALIVE that it reaches, and writes a line for each mutant that finds something else
//     PROGRAM try FILE ALIVE OUT       the same with the changes that FILE has, and with a line of what is found of each
//
// The mutants are switched on within one process, so those of constants are not seen. A child does the work, as mutants crash and hang.

#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "verify/changed.hpp"
#include "verify/mutants.hpp"

namespace mutants {

constexpr std::size_t most = 100'000;
bool reached[most];
std::size_t chosen = most;

bool is_on(unsigned number) {
    reached[number] = true;
    return number == chosen;
}

}  // namespace mutants

namespace {

using changed::Found, changed::Json;
using mutants::most;

constexpr std::size_t longest_text = 14'000;
constexpr double longest = 0.06;  // seconds that a check may take

std::ofstream collected;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The case of a certificate with one statement.
Json case_of(const Json& certificate) {
    Json one{{"case", ""}}, header = Json::object();
    for (const auto& [key, value] : certificate.items())
        if (key != "format" && key != "claim" && key != "alphabet" && key != "systems" &&
            key != "statements")
            header[key] = value;
    if (!header.empty()) one["header"] = header;
    one["alphabet"] = certificate.value("alphabet", Json::array());
    one["systems"] = certificate.value("systems", Json::object());
    for (const char* part : {"statement", "verdict", "proof"})
        one[part] = certificate["statements"][0].value(part, Json());
    return one;
}

/// What is found with the mutant that is chosen, and other ends of the work than the program has.
Found found(const Json& certificate, const algae::Budget& budget = changed::budget()) {
    try {
        return changed::found(certificate, budget);
    } catch (const std::exception& error) {
        return {std::string("throws: ") + error.what(), ""};
    }
}

/// The mutants that are evaluated while a certificate is checked.
std::vector<unsigned> reached_by(const Json& certificate, Found& what, double& time) {
    std::fill(std::begin(mutants::reached), std::end(mutants::reached), false);
    algae::Budget budget = changed::budget();
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    const double begin = seconds();
    what = found(certificate, budget);
    time = seconds() - begin;
    std::vector<unsigned> numbers;
    for (unsigned i = 0; i < most; ++i)
        if (mutants::reached[i]) numbers.push_back(i);
    return numbers;
}

int collect(const std::string& file, const std::string& others) {
    const std::string all = file + ".all";
    collected.open(all);
    doctest::Context context;
    context.setOption("test-case-exclude", "*nearer*,*too near*");  // they take minutes
    context.run();
    collected.close();
    std::map<std::size_t, std::set<std::string>> by_size;
    for (const std::string& from : {all, others}) {
        std::ifstream in(from);
        for (std::string line; std::getline(in, line);)
            if (line.size() <= longest_text) by_size[line.size() / 64].insert(line);
    }
    std::map<unsigned, std::size_t> count;
    Json cases = Json::array();
    for (const auto& [size, lines] : by_size)
        for (const std::string& line : lines) {
            Json one = case_of(Json::parse(line));
            const Json certificate = changed::certificate_of(one);
            Found what;
            double time = 0;
            const std::vector<unsigned> numbers = reached_by(certificate, what, time);
            if (time > longest || what.outcome.starts_with("throws")) continue;
            if (std::none_of(numbers.begin(), numbers.end(),
                             [&](unsigned number) { return count[number] < 3; }))
                continue;
            for (const unsigned number : numbers) ++count[number];
            one["case"] = what.says.empty() ? "no certificate" : what.says;
            one["outcome"] = what.outcome;
            one["says"] = what.says;
            cases.push_back(one);
        }
    std::ofstream(file) << cases;
    std::cout << cases.size() << " cases reach " << count.size() << " mutants" << std::endl;
    return 0;
}

/// The places that have to be changed for one value to become another one.
void differences(const Json& from, const Json& to, const std::string& at, Json& places) {
    if (from == to) return;
    if (from.is_object() && to.is_object()) {
        bool is_order_kept = true;
        auto next = to.begin();
        for (const auto& [key, value] : from.items()) {
            if (!to.contains(key)) continue;
            is_order_kept = is_order_kept && next != to.end() && next.key() == key;
            if (next != to.end()) ++next;
        }
        if (is_order_kept) {
            for (const auto& [key, value] : from.items()) {
                const std::string place = (Json::json_pointer(at) / key).to_string();
                if (to.contains(key))
                    differences(value, to[key], place, places);
                else
                    places.push_back({place});
            }
            for (const auto& [key, value] : to.items())
                if (!from.contains(key))
                    places.push_back({(Json::json_pointer(at) / key).to_string(), value});
            return;
        }
    }
    if (from.is_array() && to.is_array() && from.size() == to.size()) {
        for (std::size_t i = 0; i < from.size(); ++i)
            differences(from[i], to[i], at + "/" + std::to_string(i), places);
        return;
    }
    places.push_back({at, to});
}

/// A sign of a text within the value is another one.
void change_sign(Json& value, std::mt19937_64& random) {
    std::vector<Json*> texts;
    const auto note = [&](const auto& self, Json& at) -> void {
        if (at.is_string() && !at.get_ref<const std::string&>().empty()) texts.push_back(&at);
        if (at.is_structured())
            for (Json& part : at) self(self, part);
    };
    note(note, value);
    if (texts.empty()) return;
    Json& place = *texts[random() % texts.size()];
    std::string text = place.get<std::string>();
    const std::size_t i = random() % text.size();
    static const std::string signs = "0123456789012-/+*^(),<=! abnxF";
    const std::string sign(1, signs[random() % signs.size()]);
    if (static_cast<unsigned char>(text[i]) >= 128) return;
    if (random() % 3 == 0)
        text.insert(i, sign);
    else if (random() % 3 == 0)
        text.erase(i, 1);
    else
        text[i] = sign[0];
    place = text;
}

/// Whether a changed certificate that is accepted says the same as before, or something that the second route finds true.
bool is_true(const Json& before, const Json& now) {
    const Json &old = before["statements"][0], &one = now["statements"][0];
    if (before["systems"] == now["systems"] && old["statement"] == one["statement"] &&
        old["verdict"] == one["verdict"])
        return true;
    algae::Budget budget;
    budget.memory = 256 << 20;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
    std::optional<bool> holds;
    try {
        holds = algae::oracle::truth_of(now, one["statement"], budget).holds;
    } catch (const std::exception&) {
        return false;
    }
    const bool claimed = one["verdict"] == "proved";
    if (holds && *holds != claimed) std::cout << "FALSE: " << now.dump() << std::endl;
    return holds && *holds == claimed;
}

/// What the child is at, for the parent, who learns of its end.
struct State {
    bool alive[most];
    unsigned mutant;
    std::size_t changes;
    bool is_said;
    char line[40'000];
};

struct Hunt {
    std::vector<Json> certificates;
    std::map<unsigned, std::vector<std::size_t>> where;  // the certificates that reach a mutant
    State& state;
    const std::string& out;
    bool is_told;  // whether what is found is written, too

    void write(unsigned mutant) const {
        std::ofstream file(out, std::ios::app);
        file << "{";
        if (mutant != most) file << "\"mutant\": " << mutant << ", ";
        file << state.line << "}\n";
        if (mutant != most) state.alive[mutant] = false;
    }

    [[noreturn]] void work(std::uint64_t seed, double until) {
        std::mt19937_64 random(seed);
        mutants::Mutator mutate(random());
        while (seconds() < until) one(random, mutate);
        std::_Exit(0);
    }

    static void limit(double time) {
        itimerval timer{};
        timer.it_value.tv_sec = static_cast<time_t>(time);
        timer.it_value.tv_usec =
            static_cast<suseconds_t>((time - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
        setitimer(ITIMER_PROF, &timer, nullptr);
    }

    void one(std::mt19937_64& random, mutants::Mutator& mutate) {
        std::vector<unsigned> targets;
        for (const auto& [mutant, files] : where)
            if (state.alive[mutant]) targets.push_back(mutant);
        const std::size_t index =
            targets.empty() || random() % 4 == 0 ? random() % certificates.size() : [&] {
                const auto& from = where[targets[random() % targets.size()]];
                return from[random() % from.size()];
            }();
        const Json& certificate = certificates[index];
        Json other = certificate;
        if (random() % 8 == 0) {
            // as it is
        } else if (random() % 4 == 0) {
            change_sign(other[random() % 3 == 0 ? "systems" : "statements"], random);
        } else {
            other = mutate(certificate, certificates[random() % certificates.size()]);
        }
        Json places = Json::array();
        differences(certificate, other, "", places);
        for (Json& place : places) {
            std::string text = place[0].get<std::string>();
            if (text.empty() || text == "/statements" || text == "/statements/0") return;
            if (text.starts_with("/statements/0/")) text = text.substr(13);
            place[0] = text;
        }
        look_at(index, places, longest);
    }

    /// Checks a case with changes, as it should be and with each mutant.
    void look_at(std::size_t index, const Json& places, double most_time) {
        const Json& certificate = certificates[index];
        Json changed = certificate;
        try {
            changed::change(changed, places);
        } catch (const std::exception&) {
            return;
        }
        if (!changed["statements"].is_array() || changed["statements"].empty()) return;
        state.mutant = most;
        limit(0.5 + 2 * most_time);
        Found whole;
        double time = 0;
        const auto numbers = reached_by(changed, whole, time);
        limit(0);
        ++state.changes;
        // A check that the time ended says nothing.
        if (time > most_time || whole.outcome.starts_with("throws") ||
            whole.outcome.find("the time allowed is over") != std::string::npos)
            return;
        if (whole.outcome == "checked" && !is_true(certificate, changed)) return;
        const std::string line = "\"case\": " + std::to_string(index) +
                                 ", \"change\": " + places.dump() +
                                 ", \"outcome\": " + Json(whole.outcome).dump() +
                                 ", \"says\": " + Json(whole.says).dump();
        if (line.size() + 1 > sizeof state.line) return;
        std::memcpy(state.line, line.c_str(), line.size() + 1);
        if (is_told && !state.is_said) write(most);
        state.is_said = true;
        for (const unsigned number : numbers) {
            if (!state.alive[number]) continue;
            state.mutant = number;
            mutants::chosen = number;
            limit(0.1 + 20 * time);
            const bool same = found(changed) == whole;
            limit(0);
            mutants::chosen = most;
            if (!same) write(number);
        }
        state.mutant = most;
    }
};

/// The cases of a file.
Json cases_of(const std::string& file) {
    std::ifstream in(file);
    return Json::parse(in);
}

State& shared_state(const std::string& numbers) {
    State& state = *static_cast<State*>(
        mmap(nullptr, sizeof(State), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    std::ifstream alive(numbers);
    for (unsigned number = 0; alive >> number;) state.alive[number] = true;
    return state;
}

/// What is found with the changes that are given, and the mutants that notice them.
int tried(const std::vector<std::string>& given) {
    const Json cases = cases_of(given[2]);
    Hunt hunt{{}, {}, shared_state(given[3]), given[4], true};
    std::ofstream(given[4]).close();
    for (const Json& each : cases) hunt.certificates.push_back(changed::certificate_of(each));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        Json all = Json::array({Json::array()});  // as it is, too
        for (const Json& each : cases[i]["changes"]) all.push_back(each[0]);
        for (const Json& places : all) {
            hunt.state.is_said = false;
            for (int status = 1; status != 0;) {
                hunt.state.mutant = most;
                const pid_t child = fork();
                if (child == 0) {
                    hunt.look_at(i, places, 2);
                    std::_Exit(0);
                }
                waitpid(child, &status, 0);
                if (status != 0 && hunt.state.mutant == most) {
                    std::cout << "case " << i << ": " << places << " ends the checker" << std::endl;
                    break;
                }
                if (status != 0) hunt.write(hunt.state.mutant);
            }
            if (!hunt.state.is_said)
                std::cout
                    << "case " << i << ": " << places
                    << " is no change, takes too long, or is accepted and not known to be true"
                    << std::endl;
        }
    }
    return 0;
}

int hunt(const std::vector<std::string>& given) {
    std::vector<Json> certificates;
    for (const Json& each : cases_of(given[2]))
        certificates.push_back(changed::certificate_of(each));
    State& state = shared_state(given[3]);
    const auto count = std::count(std::begin(state.alive), std::end(state.alive), true);
    Hunt hunt{certificates, {}, state, given[4], false};
    std::ofstream(given[4]).close();
    for (std::size_t i = 0; i < certificates.size(); ++i) {  // also gives constants their values
        Found what;
        double time = 0;
        for (const unsigned number : reached_by(certificates[i], what, time))
            if (state.alive[number]) hunt.where[number].push_back(i);
    }
    std::cout << count << " mutants, " << hunt.where.size() << " are reached" << std::endl;
    const auto begin = std::chrono::steady_clock::now();
    const auto passed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    const double time = std::stod(given[5]);
    std::uint64_t seed = std::stoull(given[6]);
    double said = 0;
    while (passed() < time) {
        state.mutant = most;
        const pid_t child = fork();
        if (child == 0) {
            // A child ends soon enough to be begun anew, as memory and constants may not be what they were.
            hunt.work(seed, seconds() + std::min(20.0, time - passed() + 0.1));
        }
        int status = 0;
        waitpid(child, &status, 0);
        ++seed;
        if (status != 0 && state.mutant != most) hunt.write(state.mutant);
        if (passed() - said > 60) {
            said = passed();
            std::cout << "  " << state.changes << " changes after " << static_cast<int>(said)
                      << " s, " << std::count(std::begin(state.alive), std::end(state.alive), true)
                      << " mutants are left" << std::endl;
        }
    }
    return 0;
}

}  // namespace

// Tests call this instead of check_certificate: the linker is told so.
extern "C" {
// NOLINTBEGIN: the names that the linker makes
std::vector<algae::verify::Finding>
__real__ZN5algae6verify17check_certificateERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEES8_RKNS_6BudgetE(
    const std::string&, const std::string&, const algae::Budget&);
std::vector<algae::verify::Finding>
__wrap__ZN5algae6verify17check_certificateERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEES8_RKNS_6BudgetE(
    const std::string& text, const std::string& file, const algae::Budget& budget) {
    if (collected.is_open() && text.size() < 1 << 20) {
        const Json whole = Json::parse(text, nullptr, false);
        if (whole.is_object() && whole.contains("statements") && whole["statements"].is_array())
            for (std::size_t i = 0; i < whole["statements"].size() && i < 40; ++i)
                if (whole["statements"][i].is_object())
                    collected << mutants::with_statement(whole, i).dump(
                                     -1, ' ', false, Json::error_handler_t::replace)
                              << '\n';
    }
    return __real__ZN5algae6verify17check_certificateERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEES8_RKNS_6BudgetE(
        text, file, budget);
}
// NOLINTEND
}

int main(int count, char** words) {
    const std::vector<std::string> given(words, words + count);
    if (given.at(1) == "collect") return collect(given.at(2), given.at(3));
    return given[1] == "try" ? tried(given) : hunt(given);
}
