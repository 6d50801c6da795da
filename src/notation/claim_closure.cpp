#include "notation/claim_closure.hpp"

#include <algorithm>

#include "notation/characters.hpp"
#include "notation/claim_scanner.hpp"
#include "notation/suggestion.hpp"

namespace algae {

namespace {

bool is_one_of(const std::vector<std::string>& all, std::string_view word) {
    return std::find(all.begin(), all.end(), word) != all.end();
}

std::string listed(const std::vector<std::string>& all) {
    std::string text;
    for (std::size_t i = 0; i < all.size(); ++i)
        text += (i == 0 ? "" : i + 1 == all.size() ? " or " : ", ") + all[i];
    return text;
}

/// The words up to a colon, with one blank between any two.
std::string take_operation(ClaimScanner& scanner) {
    const std::string_view rest = scanner.rest();
    ClaimScanner words(rest.substr(0, rest.find(':')));
    std::string operation;
    while (!words.at_end())
        operation += (operation.empty() ? "" : " ") + std::string(words.take_piece());
    scanner.here = words.end;
    return operation;
}

}  // namespace

bool is_closure_fact(std::string_view text) {
    ClaimScanner scanner(text);
    scanner.take_word("not");
    return scanner.take_word("closed");
}

ClosureFact parse_closure_fact(std::string_view text, const ClaimReading& reading) {
    ClosureFact fact;
    fact.place = reading.source.place(text.data());
    ClaimScanner scanner(text);
    fact.closed = !scanner.take_word("not");
    scanner.take_word("closed");
    if (!scanner.take_word("under")) throw unexpected("'under' after 'closed'", scanner.here);
    const char* const where = scanner.rest().data();
    fact.operation = take_operation(scanner);
    if (fact.operation.empty()) throw unexpected("an operation", where);
    if (!is_one_of(closure_operations(), fact.operation))
        throw SyntaxError{where, "expected an operation (" + listed(closure_operations()) +
                                     "), found " + quoted(fact.operation) +
                                     did_you_mean(fact.operation, closure_operations())};
    if (!scanner.take(":")) throw unexpected("':' and families", scanner.here);
    do {
        const char* const family_place = scanner.rest().data();
        const std::string_view family = scanner.take_piece();
        if (family.empty()) throw unexpected("a family", family_place);
        if (!is_one_of(closure_families(), family))
            throw SyntaxError{family_place, "expected a family of the table (" +
                                                listed(closure_families()) + "), found " +
                                                quoted(family) +
                                                did_you_mean(family, closure_families())};
        if (is_one_of(fact.families, family))
            throw SyntaxError{family_place,
                              "the family " + std::string(family) + " stands there twice"};
        fact.families.emplace_back(family);
    } while (!scanner.at_end());
    return fact;
}

}  // namespace algae
