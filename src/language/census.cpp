#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <utility>

#include "language/detail/finite_verdicts.hpp"
#include "language/detail/judge.hpp"
#include "language/detail/proof.hpp"
#include "search/search.hpp"

// A census asks the same of every instance up to a size: of how many is a statement proved, of how many refuted?
//
// Instances come from the room `search` in their order, each once up to renaming. They are cut into chunks of a fixed number of
// instances of one size, the last chunk of a size may have fewer. Nothing else decides where chunks are cut, so a
// chunk's result can be worked out by any thread or process, again or never; a sum over all chunks is the census (`CensusTotals`). Who takes
// which chunk is asked of `CensusOptions::next`: a counter, a list that lacks what a file has, another process.
//
// Within a chunk all threads decide instances, and what they find is put together in the order of the instances. Nothing is kept
// of a chunk but counts and a few texts, so memory does not depend on how many instances there are.
//
// Verdicts come without proofs where few words decide a statement (quick_judge.cpp); otherwise the judges are asked. So
// `census_sample` draws instances, decides their statements with proofs, and compares.
//
// Counting languages: a system whose language is finite stands for it, by the least text of its words under renaming, and each
// language counts at the first system that has it, which is one of the smallest. A chunk lists the languages that it meets,
// and the sum keeps the first of each. Infinite languages of systems are not compared with each other; their systems are
// counted apart.
//
// Subtle: a chunk is known to be the last of its size only when no further instance comes, so it is closed when the next
// instance comes or the size ends. A size without instances has one empty chunk; otherwise nobody could tell that it is done.

namespace algae {

namespace {

using Json = nlohmann::ordered_json;

bool is_plain_deterministic(const Quantified& said) {
    const Domain& only = said.bindings.front().domain;
    return said.bindings.size() == 1 && !said.over && only.kind == Domain::Kind::system &&
           only.deterministic && !only.tables && !only.max_word_length;
}

/// The statements that say the same of all systems with one language, up to renaming.
bool is_about_language(const Statement& statement) {
    if (const auto* said = std::get_if<Joint>(&statement.says))
        return std::all_of(said->parts.begin(), said->parts.end(), is_about_language);
    return std::holds_alternative<InFamily>(statement.says) ||
           std::holds_alternative<IsFinite>(statement.says) ||
           std::holds_alternative<IsEmpty>(statement.says) ||
           std::holds_alternative<HasSize>(statement.says);
}

/// The words of a text of `up_to_renaming`, as `Instance` writes a language.
std::string language_text(const std::string& renamed) {
    std::vector<Word> words(1);
    std::size_t letters = 0;
    for (const char c : renamed) {
        if (c == '\0') {
            words.emplace_back();
            continue;
        }
        const auto letter = static_cast<std::uint8_t>(c);
        words.back().push_back(letter - 1u);
        letters = std::max<std::size_t>(letters, letter);
    }
    words.pop_back();
    const Alphabet alphabet = search_alphabet(letters);
    return joined(words, ",", [&](const Word& word) { return spell(alphabet, word); });
}

class Taker {
public:
    Taker(const Quantified& said, const std::vector<Statement>& properties, const Claim& claim,
          const CensusOptions& options, CensusTotals& totals, const Budget& budget)
        : said_(said),
          properties_(properties),
          claim_(claim),
          options_(options),
          totals_(totals),
          budget_(budget),
          patient_(budget),
          quick_(claim, patient_),
          tuple_(tuple_of(said)) {
        if (options.finishes_chunks) patient_.stop = nullptr;
        is_plain_ = is_plain_deterministic(said);
        is_only_counted_ = is_plain_ && properties.empty() && !options.languages;
        // The sizes that are visited are within the bound; without it systems are found by their numbers.
        if (is_plain_) tuple_.values.front().max_size.reset();
        if (!options.languages) return;
        if (said.bindings.size() != 1 || said.bindings[0].domain.kind != Domain::Kind::system)
            throw Error(
                "expected systems whose languages are counted, such as 'D0L systems up to size 8'");
        for (const Statement& property : properties)
            if (!is_about_language(property))
                throw Error(
                    "expected a statement about the language L(X) where languages are "
                    "counted, such as 'L(X) is 0L', found '" +
                    property.text + "'");
    }

    void take() {
        const std::uint64_t sizes = census_size(said_);
        next_target();
        for (std::uint64_t size = 1; size <= sizes && target_; ++size) {
            if (totals_.has_size(size))
                start_ = *totals_.last_chunk(size) + 1;
            else if (is_only_counted_)
                count(size);
            else
                visit_size(size);
            while (target_ && *target_ < start_) next_target();
        }
    }

private:
    void next_target() {
        do {
            target_ = options_.next ? options_.next()
                                    : std::optional(target_ ? *target_ + 1 : std::uint64_t{0});
        } while (target_ && totals_.has(*target_));
    }

    void finish(CensusChunk chunk) {
        totals_.add(chunk);
        if (options_.on_chunk) options_.on_chunk(chunk);
        next_target();
    }

    void count(std::uint64_t size) {
        const Domain& domain = said_.bindings.front().domain;
        if (target_ == start_) {
            budget_.check();
            CensusChunk chunk = empty_chunk(size);
            chunk.is_last = true;
            chunk.instances =
                DeterministicSystems(size, domain.propagating, domain.letters, patient_).count();
            finish(std::move(chunk));
        }
        ++start_;
    }

    CensusChunk empty_chunk(std::uint64_t size) const {
        CensusChunk chunk;
        chunk.number = start_;
        chunk.size = size;
        if (options_.languages) return chunk;
        chunk.verdicts.resize(properties_.size());
        chunk.first.resize(properties_.size());
        return chunk;
    }

    /// Goes through the instances of a size, from the chunk that is wanted next if they are found by number, and does those
    /// chunks that are wanted. Afterwards `start_` is the first chunk of the next size.
    void visit_size(std::uint64_t size) {
        const std::optional<std::uint64_t> known_last = totals_.last_chunk(size);
        InstanceRange range;
        if (is_plain_) {
            const Domain& domain = said_.bindings.front().domain;
            const std::uint64_t all =
                DeterministicSystems(size, domain.propagating, domain.letters, budget_)
                    .count()
                    .to_uint64();
            const std::uint64_t end =
                start_ + std::max<std::uint64_t>(1, (all + options_.chunk - 1) / options_.chunk);
            if (*target_ >= end) {
                start_ = end;
                return;
            }
            range.first = (*target_ - start_) * options_.chunk;
            start_ = *target_;
        }
        std::vector<Instance> batch;
        std::uint64_t met = 0;
        const auto close = [&](bool is_last) {
            if (target_ == start_) finish(decided(size, std::exchange(batch, {}), is_last));
            ++start_;
            met = 0;
        };
        bool is_stopped = false;
        visit(
            tuple_, size,
            [&](const Instance& instance) {
                if (met == options_.chunk) {
                    close(false);
                    is_stopped = !target_ || (known_last && *target_ > *known_last);
                    if (is_stopped) return false;
                }
                if (++met % 256 == 0) budget_.check();
                if (target_ == start_) batch.push_back(instance);
                return true;
            },
            budget_, range);
        if (!is_stopped)
            close(true);
        else if (known_last)
            start_ = *known_last + 1;
    }

    std::vector<Symbol> letters_for(const Instance& instance) const {
        if (said_.over) return *said_.over;
        if (instance.letters() > claim_.instance_letters.size())
            throw BoundReached(Bound::method, "an instance has more than " +
                                                  std::to_string(claim_.instance_letters.size()) +
                                                  " letters");
        return std::vector<Symbol>(
            claim_.instance_letters.begin(),
            claim_.instance_letters.begin() + static_cast<std::ptrdiff_t>(instance.letters()));
    }

    std::vector<Truth> truths(const Instance& instance, QuickJudge& quick) const {
        const auto values = values_of(instance, said_, claim_, letters_for(instance));
        std::vector<Truth> all;
        for (const Statement& property : properties_) {
            const Statement closed = with_values(property, values);
            const auto truth = quick.truth(closed);
            all.push_back(truth ? *truth : decide_part(closed, claim_, patient_, {}).truth);
        }
        return all;
    }

    CensusChunk decided(std::uint64_t size, const std::vector<Instance>& batch, bool is_last) {
        CensusChunk chunk = empty_chunk(size);
        chunk.is_last = is_last;
        if (options_.languages) {
            count_languages(batch, chunk);
            return chunk;
        }
        chunk.instances = Integer(std::uint64_t{batch.size()});
        std::vector<std::vector<Truth>> found(batch.size());
        each_part(batch.size(), options_.threads, patient_, [&]() -> PartWorker {
            return
                [&, quick = quick_.take()](std::size_t i) { found[i] = truths(batch[i], *quick); };
        });
        for (std::size_t i = 0; i < batch.size(); ++i)
            for (std::size_t p = 0; p < properties_.size(); ++p) {
                ++chunk.verdicts[p][static_cast<std::size_t>(found[i][p])];
                if (found[i][p] == Truth::proved && chunk.first[p].size() < options_.first)
                    chunk.first[p].push_back(batch[i].text());
            }
        return chunk;
    }

    // --- Languages ---

    /// The text of the language of a system; empty if it is infinite, nothing if that is not known.
    std::optional<std::string> text_of_language(const Instance& instance, QuickJudge& quick) const {
        const auto values = values_of(instance, said_, claim_, letters_for(instance));
        const Language language =
            generated_language(std::get<std::shared_ptr<const SourceSystem>>(values.front().is));
        auto words = quick.words(language);
        if (!words)
            if (auto value = finite_value(language, *claim_.alphabet, patient_))
                words = std::move(value->words);
        if (words) return language_text(up_to_renaming(*words));
        if (judge_finite(language, *claim_.alphabet, patient_).truth == Truth::refuted)
            return std::string();
        return std::nullopt;
    }

    void count_languages(const std::vector<Instance>& batch, CensusChunk& chunk) {
        std::vector<std::optional<std::string>> texts(batch.size());
        each_part(batch.size(), options_.threads, patient_, [&]() -> PartWorker {
            return [&, quick = quick_.take()](std::size_t i) {
                try {
                    texts[i] = text_of_language(batch[i], *quick);
                } catch (const BoundReached& bound) {
                    if (bound.bound() == Bound::time) throw;
                }
            };
        });
        std::vector<std::size_t> first;
        std::set<std::string> met;
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (!texts[i])
                ++chunk.open;
            else if (texts[i]->empty())
                ++chunk.infinite;
            else if (met.insert(*texts[i]).second)
                first.push_back(i);
        }
        chunk.instances = Integer(std::uint64_t{first.size()});
        chunk.languages.resize(first.size());
        each_part(first.size(), options_.threads, patient_, [&]() -> PartWorker {
            return [&, quick = quick_.take()](std::size_t i) {
                std::string verdicts;
                for (const Truth truth : truths(batch[first[i]], *quick))
                    verdicts += to_string(truth).front();
                chunk.languages[i] = {*texts[first[i]], verdicts};
            };
        });
    }

    const Quantified& said_;
    const std::vector<Statement>& properties_;
    const Claim& claim_;
    const CensusOptions& options_;
    CensusTotals& totals_;
    const Budget& budget_;
    Budget patient_;  // with it a chunk that is begun is finished
    QuickJudges quick_;
    Tuple tuple_;
    bool is_plain_ = false, is_only_counted_ = false;
    std::optional<std::uint64_t> target_;  // the chunk that is wanted next
    std::uint64_t start_ = 0;              // the chunk that is being visited
};

}  // namespace

std::string census_line(const CensusChunk& chunk) {
    Json line{{"chunk", chunk.number}, {"size", chunk.size}};
    if (chunk.is_last) line["last"] = true;
    line["instances"] = to_string(chunk.instances);
    line["verdicts"] = chunk.verdicts;
    line["first"] = chunk.first;
    if (!chunk.languages.empty()) line["languages"] = chunk.languages;
    if (chunk.infinite > 0) line["infinite"] = chunk.infinite;
    if (chunk.open > 0) line["open"] = chunk.open;
    return line.dump();
}

std::optional<CensusChunk> census_chunk(const std::string& line) {
    const Json read = Json::parse(line, nullptr, false);
    if (!read.is_object()) return std::nullopt;
    try {
        CensusChunk chunk;
        read.at("chunk").get_to(chunk.number);
        read.at("size").get_to(chunk.size);
        chunk.is_last = read.value("last", false);
        chunk.instances = Integer(read.at("instances").get<std::string>());
        read.at("verdicts").get_to(chunk.verdicts);
        read.at("first").get_to(chunk.first);
        if (read.contains("languages")) read.at("languages").get_to(chunk.languages);
        chunk.infinite = read.value("infinite", std::uint64_t{0});
        chunk.open = read.value("open", std::uint64_t{0});
        return chunk;
    } catch (const Json::exception&) {
        return std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

// --- The sum ---

CensusTotals::CensusTotals(std::uint64_t size, std::size_t properties, const CensusOptions& options)
    : kept_(options.first),
      languages_(options.languages),
      last_(static_cast<std::size_t>(size) + 1),
      first_(properties) {
    for (std::uint64_t s = 1; s <= size; ++s) {
        rows_.emplace_back().size = s;
        rows_.back().verdicts.resize(properties);
    }
}

bool CensusTotals::has(std::uint64_t number) const {
    return number < known_.size() && known_[static_cast<std::size_t>(number)] != 0;
}

std::optional<std::uint64_t> CensusTotals::last_chunk(std::uint64_t size) const {
    return size < last_.size() ? last_[static_cast<std::size_t>(size)] : std::nullopt;
}

bool CensusTotals::has_size(std::uint64_t size) const {
    return last_chunk(size) && first_unknown_ > *last_chunk(size);
}

void CensusTotals::add(const CensusChunk& chunk) {
    constexpr std::uint64_t most_chunks = std::uint64_t{1} << 28;
    const bool fits = languages_ ? chunk.verdicts.empty() : chunk.verdicts.size() == first_.size();
    if (chunk.size == 0 || chunk.size > rows_.size() || chunk.number >= most_chunks || !fits ||
        chunk.first.size() != chunk.verdicts.size())
        throw Error("expected a chunk of this census, found one of size " +
                    std::to_string(chunk.size) + " with " +
                    counted(chunk.verdicts.size(), "statement"));
    if (has(chunk.number)) return;
    if (chunk.number >= known_.size()) known_.resize(static_cast<std::size_t>(chunk.number) + 1, 0);
    known_[static_cast<std::size_t>(chunk.number)] = 1;
    while (has(first_unknown_)) ++first_unknown_;
    if (chunk.is_last) last_[static_cast<std::size_t>(chunk.size)] = chunk.number;
    Census::Row& row = rows_[static_cast<std::size_t>(chunk.size) - 1];
    row.infinite += chunk.infinite;
    row.open += chunk.open;
    for (std::size_t i = 0; i < chunk.languages.size(); ++i) {
        const auto& [text, verdicts] = chunk.languages[i];
        if (verdicts.size() != first_.size())
            throw Error("expected a verdict for each of " + counted(first_.size(), "statement") +
                        " on the language " + text);
        const Found here{chunk.number, i, chunk.size, verdicts};
        const auto [known, is_new] = found_.try_emplace(text, here);
        if (!is_new &&
            std::pair(here.chunk, here.place) < std::pair(known->second.chunk, known->second.place))
            known->second = here;
    }
    if (languages_) return;
    row.instances += chunk.instances;
    for (std::size_t p = 0; p < first_.size(); ++p) {
        for (std::size_t truth = 0; truth < 3; ++truth)
            row.verdicts[p][truth] += chunk.verdicts[p][truth];
        for (std::size_t i = 0; i < chunk.first[p].size(); ++i)
            first_[p].emplace_back(chunk.number, i, chunk.first[p][i]);
        std::sort(first_[p].begin(), first_[p].end());
        if (first_[p].size() > kept_) first_[p].resize(kept_);
    }
}

Census CensusTotals::census() const {
    Census all;
    all.rows = rows_;
    all.is_whole = rows_.empty() || has_size(rows_.back().size);
    auto first = first_;
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::pair<const std::string*, const Found*>>
        in_order;
    for (const auto& [text, found] : found_) in_order[{found.chunk, found.place}] = {&text, &found};
    for (const auto& [place, entry] : in_order) {
        const auto& [text, found] = entry;
        Census::Row& row = all.rows[static_cast<std::size_t>(found->size) - 1];
        row.instances += 1;
        for (std::size_t p = 0; p < first.size(); ++p) {
            const char verdict = found->verdicts[p];
            ++row.verdicts[p][verdict == 'p' ? 0 : verdict == 'r' ? 1 : 2];
            if (verdict == 'p' && first[p].size() < kept_)
                first[p].emplace_back(place.first, place.second, *text);
        }
    }
    for (const auto& texts : first) {
        auto& kept = all.first.emplace_back();
        for (const auto& one : texts) kept.push_back(std::get<2>(one));
    }
    return all;
}

std::uint64_t census_size(const Quantified& said) {
    const Tuple tuple = tuple_of(said);
    const auto last = is_finite(tuple) ? greatest_size(tuple) : std::nullopt;
    if (!last) throw Error("expected a bound of the census, such as 'up to size 8'");
    constexpr std::uint64_t most_sizes = 1'000'000;
    if (*last > most_sizes)
        throw BoundReached(Bound::method,
                           "a census has at most 1000000 sizes; a bound of the size, "
                           "such as 'up to size 8', leaves fewer");
    return *last;
}

void take_census(const Quantified& said, const std::vector<Statement>& properties,
                 const Claim& claim, const CensusOptions& options, CensusTotals& totals,
                 const Budget& budget) {
    if (options.chunk == 0) throw Error("expected chunks of at least one instance, found 0");
    Taker(said, properties, claim, options, totals, budget).take();
}

// --- A sample with proofs ---

namespace {

/// So many different numbers below `all`, in increasing order, all sets equally likely; all numbers if there are fewer.
std::vector<std::uint64_t> drawn(std::uint64_t all, std::uint64_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t bound) {
        // std::uniform_int_distribution differs from library to library.
        const std::uint64_t whole = std::numeric_limits<std::uint64_t>::max() / bound * bound;
        std::uint64_t value = random();
        while (value >= whole) value = random();
        return value % bound;
    };
    std::set<std::uint64_t> places;  // Floyd: at step i one of the first i + 1 numbers, or i itself
    for (std::uint64_t i = all - std::min(all, count); i < all; ++i) {
        const std::uint64_t place = below(i + 1);
        places.insert(places.count(place) > 0 ? i : place);
    }
    return {places.begin(), places.end()};
}

}  // namespace

CheckedClaim census_sample(const Quantified& said, const std::vector<Statement>& properties,
                           const Claim& claim, const Census& census, std::uint64_t count,
                           std::uint64_t seed, const Budget& budget) {
    Integer all;
    for (const Census::Row& row : census.rows) all += row.instances;
    if (properties.empty()) throw Error("expected statements whose verdicts are drawn, found none");
    if (!census.is_whole) throw Error("expected a whole census to draw from, found a chunk of one");
    const std::vector<std::uint64_t> places = drawn(all.to_uint64(), count, seed);
    CheckedClaim sample;
    sample.claim = claim;
    sample.claim.title = "a sample of a census";
    sample.claim.statements.clear();
    Tuple tuple = tuple_of(said);
    if (is_plain_deterministic(said)) tuple.values.front().max_size.reset();
    QuickJudge quick(claim, budget);
    const auto add = [&](const Instance& instance) {
        const std::vector<Symbol> letters =
            said.over.value_or(std::vector<Symbol>(claim.instance_letters));
        auto values = values_of(instance, said, claim, letters);
        for (BoundValue& value : values) {
            auto* system = std::get_if<std::shared_ptr<const SourceSystem>>(&value.is);
            if (!system) continue;
            auto renamed = std::make_shared<SourceSystem>(**system);
            renamed->name += std::to_string(sample.claim.systems.size() + 1);
            sample.claim.systems.push_back(renamed);
            *system = std::move(renamed);
        }
        for (const Statement& property : properties) {
            ClaimedStatement claimed;
            claimed.statement = with_values(property, values);
            claimed.statement.text = instance.text() + ": " + property.text;
            CheckedStatement checked;
            checked.answer = decide_part(claimed.statement, claim, budget, {});
            const Truth truth = checked.answer.truth;
            const auto counted_as = quick.truth(claimed.statement);
            if (counted_as && truth == opposite(*counted_as))
                throw Error(claimed.statement.text + ": the census says " +
                            std::string(to_string(*counted_as)) + ", its proof " +
                            std::string(to_string(truth)) + ": a defect of algae");
            if (truth == Truth::refuted) claimed.purpose = ClaimedStatement::Purpose::refute;
            checked.outcome = truth == Truth::undecided ? CheckedStatement::Outcome::undecided
                                                        : CheckedStatement::Outcome::holds;
            sample.claim.statements.push_back(std::move(claimed));
            sample.statements.push_back(std::move(checked));
        }
    };
    auto place = places.begin();
    std::uint64_t before = 0;  // instances of smaller sizes
    for (const Census::Row& row : census.rows) {
        const std::uint64_t end = before + row.instances.to_uint64();
        if (place != places.end() && *place < end) {
            std::uint64_t here = *place;
            visit(tuple, row.size,
                  [&](const Instance& instance) {
                      if (here++ == *place) {
                          add(instance);
                          ++place;
                      }
                      return place != places.end() && *place < end;
                  },
                  budget, {*place - before});
        }
        before = end;
    }
    return sample;
}

}  // namespace algae
