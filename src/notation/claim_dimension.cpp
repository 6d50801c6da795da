#include "notation/claim_dimension.hpp"

#include <string>

#include "notation/characters.hpp"
#include "notation/claim_number.hpp"
#include "notation/findings.hpp"

namespace algae {

void parse_dimension(ClaimScanner& scanner, Statement& statement, ClaimReading& reading) {
    const std::string_view word = scanner.take_name();
    statement.kind = word == "dimension" ? Statement::Kind::dimension : Statement::Kind::boundary;
    if (!scanner.take("(")) throw unexpected("'(' after " + quoted(word), scanner.here);
    const std::string_view name = scanner.take_name();
    if (name.empty()) throw unexpected("the name of a system", scanner.here);
    statement.drawn = reading.written(name);
    if (!scanner.take(")")) throw unexpected("')'", scanner.here);
    const bool at_most = scanner.take("<=");
    statement.negated = !at_most && scanner.take("!=");
    if (!at_most && !statement.negated && !scanner.take("="))
        throw unexpected("'=', '!=' or '<=' and a number", scanner.here);
    const std::string_view text = scanner.rest();
    const DimensionValue value = parse_dimension_value(scanner);
    statement.dimension = ClaimedDimension{
        value,
        std::string(trimmed(text.substr(0, static_cast<std::size_t>(scanner.here - text.data())))),
        at_most};
}

}  // namespace algae
