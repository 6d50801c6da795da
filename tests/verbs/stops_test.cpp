#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <optional>
#include <set>

#include "command/detail/verb.hpp"
#include "exact/exact.hpp"
#include "places.hpp"
#include "verbs/in_process.hpp"

namespace {

using namespace algae;
using in_process::Ran;
using in_process::run;

const std::string over = "the time allowed by --timeout is over";

/// Work that looks at its budget here is stopped there: at one check, or from it on as a deadline does.
class Stopping {
public:
    enum class By { nothing, interrupt, time, deadline };

    Stopping(By by, std::uint64_t at) : by_(by), at_(at), called_([this] { check(); }) {
        command::at_check = &called_;
    }
    ~Stopping() { command::at_check = nullptr; }
    std::uint64_t checks() const { return checks_; }

private:
    void check() {
        const std::uint64_t number = ++checks_;
        if (by_ == By::nothing || number < at_ || (number > at_ && by_ != By::deadline)) return;
        if (by_ == By::interrupt) throw Interrupted();
        throw BoundReached(Bound::time, over);
    }

    By by_;
    std::uint64_t at_;
    std::atomic<std::uint64_t> checks_ = 0;
    std::function<void()> called_;
};

/// What a verb does, by some of the ways in which it can be asked. OUT is where its file goes.
struct Case {
    std::string verb;
    std::vector<std::string> ways, slow = {};  // slow ones are stopped at fewer checks
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"show", {"koch", "IN/open.lsys", "IN/lights.lsys --axes -n 3", "koch --json"}},
        {"fmt", {"IN/open.lsys"}},
        {"derive",
         {"koch -n 4", "IN/plant.lsys -n 3", "IN/context.lsys -n 12",
          "IN/chance.lsys -n 5 --seeds 1..3", "IN/chance.lsys -n 2 --distribution",
          "IN/chance.lsys -n 3 --expected", "IN/choice.lsys -n 2 --all-words",
          "IN/finals.lsys -n 3 --language --longest 6", "IN/boxes.lsys -n 3", "IN/light.lsys -n 4",
          "IN/tables.lsys --tables light,dark", "koch -n 5 --json"}},
        {"letter",
         {"dragon -n 300 --at 1000000000000000000000000000000", "koch -n 1000 --at 10 --count 60"}},
        {"growth",
         {"koch", "dragon --json", "koch -n 0..40", "koch -n 3 --counts", "IN/choice.lsys --bounds",
          "koch --plot OUT.svg", "fibonacci --words", "koch --words --json", "--realise n^2+1",
          "--realise 1,2,4,9,3", "IN/context.lsys -n 12"}},
        {"words",
         {"abaab", "fibonacci --to 12", "rudin-shapiro --to 6 --json", "--letters IN/points.csv"}},
        {"infer",
         {"a ab aba abaab", "F F+F F+F+F --family 0L --json", "ab ba bb aa --family DIL",
          "a aa aaaaaa --family DT0L", "a aa --sample --max-size 5"}},
        {"member",
         {"fibonacci abaab", "fibonacci abb", "IN/choice.lsys aaaaab", "IN/tables.lsys aaaabb",
          "IN/finals.lsys aabb", "IN/choice.lsys aaa --json", "IN/choice.lsys aaa --count",
          "IN/choice.lsys aaa --all -n 2..3 --json", "IN/tables.lsys aabb --count -n 0..4"}},
        {"finite",
         {"koch", "IN/choice.lsys", "IN/short.lsys", "IN/tables.lsys --json", "IN/finals.lsys"}},
        {"equal",
         {"IN/even.lsys IN/odd.lsys --as sequence", "IN/even.lsys IN/odd.lsys --as language",
          "koch koch --as language", "IN/even.lsys IN/odd.lsys --as growth --json",
          "IN/even.lsys fibonacci --as language --json", "koch koch --as sequence --json"}},
        {"is",
         {"0L {a,aa}", "0L {a,aa,aaa,ab,ba} --json", "T0L {a,aa,aaaa}", "regular L(fibonacci)",
          "empty {a}&/b*/", "finite L(fibonacci)&/a*b/", "E0L L(koch)", "PD0L L(fibonacci) --json",
          "infinite /a+/"}},
        {"list",
         {"/(a|b)*/ --words 50", "L(IN/tables.lsys) --length 12",
          "L(IN/finals.lsys)|~{a} --length 5", "~/(a|b)*bb/ --counts --length 20",
          "/(a|b)*/ --random 20 --length 30"}},
        {"check",
         {"IN/all.claim", "IN/all.claim --json", "IN/all.claim --explain",
          "IN/all.claim --certificate OUT.json", "IN/drawn.claim", "IN/quantified.claim"}},
        {"census",
         {"finite%languages%up%to%size%4 --by 0L,T0L --threads 1",
          "D0L%systems%up%to%size%5 --by growth --threads 1 --format json",
          "D0L%systems%up%to%size%5 --distinct languages --by 0L --threads 1",
          "D0L%systems%up%to%size%4 --by finite --threads 1 --verify-sample 3 --certificate "
          "OUT.json"}},
        {"closure", {}, {"0L union", "0L union --json"}},
        {"verify", {"IN/all.json", "IN/all.json --json", "IN/drawn.json"}},
        {"draw",
         {"koch -n 3 -o OUT.svg",
          "koch -n 3 -o OUT.png --width 60",
          "koch -n 2 -o OUT.tex",
          "koch -n 2 -o OUT.csv",
          "IN/plant.lsys -n 3 --plotter -o OUT.dxf",
          "koch -n 0..2 -o OUT.pdf --captions",
          "koch -n 0..2 --panels -o OUT.eps",
          "koch -n 0..3 -o OUT.gif --width 40",
          "koch -n 0..2 -o OUT.webp --width 40",
          "koch -n 2 --progressive --max-frames 5 -o OUT.gif --width 40",
          "koch --explain -n 1",
          "koch --explain -n 1 -o OUT.svg",
          "IN/space.lsys -n 3 -o OUT.png --width 60",
          "IN/space.lsys -n 3 -o OUT.glb",
          "IN/space.lsys -n 3 -o OUT.stl",
          "IN/space.lsys -n 3 -o OUT.x3d",
          "IN/boxes.lsys -n 3 -o OUT.obj",
          "IN/plant.lsys -n 3 -o OUT.svg",
          "IN/chance.lsys -n 3 --seeds 1..3 -o OUT.pdf",
          "IN/lights.lsys -n 4 -o OUT.svg",
          "boxes-on-koch -o OUT.svg",
          "weierstrass -o OUT.svg"}},
        {"dimension",
         {"koch -n 3 --grids 2", "IN/scaled.lsys --grids 2 -n 4",
          "IN/bush.lsys -n 4 --grids 2 --json", "koch -n 3 --measure divider",
          "koch -n 3 --measure mass", "koch -n 3 --measure information --json",
          "koch -n 3 --measure lacunarity", "IN/points.csv --grids 2", "IN/picture.png --grids 2",
          "--table IN/curves --quick", "--table IN/curves --quick --json"},
         {"koch --grids 2", "IN/folded.lsys -n 2 --grids 2", "koch -n 3 --measure correlation",
          "koch -n 3 --measure multifractal", "--table IN/curves --grids 2"}},
        {"tree",
         {"anabaena -n 4 -o OUT.svg", "all-powers --word aaa -o OUT.svg",
          "fibonacci --graph -o OUT.svg", "--families -o OUT.svg",
          "anabaena -n 40 --dag -o OUT.dot --json", "anabaena -n 60 -o OUT.svg",
          "IN/plant.lsys -n 1 -o OUT.svg", "IN/context.lsys -n 4 -o OUT.svg --json",
          "IN/chance.lsys -n 4 --seed 2 -o OUT.dot", "IN/chance.lsys -n 30 -o OUT.svg",
          "IN/tables.lsys -n 2 --tables light,dark -o OUT.svg"}},
        {"figures",
         {"IN/curves --out OUT --formats svg --jobs 1",
          "IN/curves --out OUT --check --jobs 1 --json",
          "IN/curves --out OUT --formats svg --captions --page --jobs 1"}},
        {"gallery", {"", "--json"}},
        {"lesson",
         {"", "3", "2 --exercise 1 IN/wrong.lsys", "IN/own.exercise IN/even.lsys --json",
          "IN/own.exercise IN/wrong.lsys"}},
        {"mark", {"2.1 IN/wrong.lsys", "IN/own.exercise IN/even.lsys --json"}},
        {"ifs",
         {"fern --points 2000 --width 60 -o OUT.png", "copy-machine --iterations 0..2 -o OUT.pdf",
          "sierpinski"}},
        {"walk",
         {"--steps 9000 --seed 3 --json", "--steps 9000 --seed 3 -o OUT.svg",
          "--dimensions 3 --steps 60 -o OUT.glb"}},
        {"brownian",
         {"--hurst 0.7 --levels 6 -o OUT.svg", "--method midpoint --levels 1..4 -o OUT.pdf",
          "--dimensions 3 --levels 3 -o OUT.x3d"}},
        {"terrain",
         {"--levels 3 --roughness 0.7 -o OUT.png --width 40", "--levels 3 --seed 2 -o OUT.glb"}},
        {"dla",
         {"--particles 100 --seed 5 --off-lattice -o OUT.svg",
          "--particles 100 --seed 5 -o OUT.svg"}},
        {"particles", {"fireworks --show 10 -o OUT.svg", "fireworks"}},
        {"ca",
         {"--rule 30 --cells 21 -n 10 --text", "rule-126 -o OUT.svg", "glider -o OUT.svg",
          "--rule 30 --cells 21 -n 6 -o OUT.gif"}},
        {"convert",
         {"IN/bush.brno --to lsys", "dragon --to ifs", "koch-island-002 --to netlogo",
          "rule-110.ca --to lsys"}},
        {"latex", {"IN/paper.tex -o OUT.algae", "IN/paper.tex -o OUT.algae --json"}},
        {"lsp", {}},     // reads what an editor sends
        {"studio", {}},  // serves until it is stopped; tests/studio
        {"manual", {"--man"}},
    };
    return all;
}

/// The verbs that never look at a budget: they print what is known beforehand.
const std::set<std::string> never_checks{"gallery", "lsp", "manual", "studio"};

/// The files that the cases read and, one after the other, write.
class Folder {
public:
    Folder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "algae-verbs-XXXXXX").string();
        if (!mkdtemp(pattern.data())) std::abort();
        path_ = pattern;
        for (const char* name : {"in", "in/curves", "out"})
            std::filesystem::create_directory(path_ / name);
        for (const auto& [name, text] : texts()) std::ofstream(path_ / "in" / name) << text;
        std::string points;
        for (int i = 0; i < 300; ++i)
            points += std::to_string(i * 7 % 100) + " " + std::to_string(i * i % 91) + "\n";
        std::ofstream(path_ / "in/points.csv") << points;
        std::filesystem::copy(source_folder() + "/examples/bush.brno", path_ / "in/bush.brno");
        run({"draw", "koch", "-n", "3", "--width", "60", "-o", (path_ / "in/picture.png").string()},
            path_);
        for (const char* name : {"all", "drawn"})
            run({"check", (path_ / "in" / name).string() + ".claim", "--certificate",
                 (path_ / "in" / name).string() + ".json"},
                path_);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    std::vector<std::string> words(const std::string& verb, const std::string& way) const {
        std::istringstream in(verb + ' ' + way);
        std::vector<std::string> all;
        for (std::string word; in >> word;) {
            for (const auto& [name, folder] : {std::pair("IN/", "in/"), {"OUT", "out/made"}})
                if (const std::size_t at = word.find(name); at != std::string::npos)
                    word.replace(at, std::string(name).size(), (path_ / folder).string());
            std::replace(word.begin(), word.end(), '%', ' ');  // blanks within a word
            all.push_back(word);
        }
        return all;
    }

    /// Runs a verb; what it wrote is told and removed.
    std::pair<Ran, std::map<std::string, std::string>> done(
        const std::vector<std::string>& words) const {
        const Ran ran = run(words, path_);
        std::map<std::string, std::string> written;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(path_ / "out"))
            if (entry.is_regular_file()) {
                std::ostringstream text;
                text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
                written.emplace(entry.path().lexically_relative(path_).string(), text.str());
            }
        std::filesystem::remove_all(path_ / "out");
        std::filesystem::create_directory(path_ / "out");
        return {ran, written};
    }

private:
    static const std::vector<std::pair<std::string, std::string>>& texts() {
        static const std::vector<std::pair<std::string, std::string>> all{
            {"plant.lsys", "axiom A(1)\nA(x) : x < 6 -> F(x)[+A(x+1)][-A(x+2)]\nangle 30\n"},
            {"open.lsys", "axiom FX\nX -> X+YF+\nY -> -FX-Y\nangle 90\nexpect length 3: 25\n"},
            {"context.lsys", "axiom baaa\nb < a -> b\nb -> a\na -> aa\n"},
            {"chance.lsys", "axiom F\nF -(1/2)-> F+F\nF -(1/4)-> F\nF -(1/4)-> FF\nangle 60\n"},
            {"choice.lsys", "axiom ab\na -> aa\na -> a\nb -> ab\nb -> b\n"},
            {"short.lsys", "axiom ab\na -> b\nb -> \nb -> c\n"},
            {"tables.lsys",
             "axiom ab\ntable light\na -> aa\nb -> b\ntable dark\na -> ab\nb -> b\n"},
            {"finals.lsys",
             "alphabet A B a b\nterminals a b\naxiom AB\nA -> AA\nA -> a\nB -> Bb\nB -> b\n"},
            {"boxes.lsys", "axiom A(8,8,8)\nA -> repeat(X, 2){ B }\nB -> div(Z, 1r, 2r){ C A }\n"},
            {"light.lsys", "axiom F(0,0)A?P(0,0)\nA -> F(0,1)A\nplot F\n"},
            {"lights.lsys", "axiom FA\nA -> [+FA][-FA]\nangle 25\n"},
            {"space.lsys", "axiom A\nA -> F[&FA]////[&FA]\nangle 22.5\n"},
            {"even.lsys", "axiom ab\na -> \nb -> aabb\n"},
            {"odd.lsys", "axiom ab\na -> aabb\nb -> \n"},
            {"wrong.lsys", "axiom a\na -> aaa\n"},
            {"folded.lsys", "axiom F\nF -> FF-F-F-F-F-F+F\nangle 90\n"},
            {"bush.lsys", "axiom X\nX -> F[+X][-X]\nF -> FF\nangle 20\n"},
            {"scaled.lsys", "axiom F(1)\nF(x) -> F(x/3)+F(x/3)--F(x/2)+F(x/3)\nangle 60\n"},
            {"curves/koch.lsys",
             "axiom F\nF -> F+F--F+F\nangle 60\ngeneration 2\nexpect length 2: 36\n"},
            {"curves/terdragon.lsys", "axiom F\nF -> F+F-F\nangle 120\ngeneration 3\n"},
            {"curves/dragon.lsys", "axiom FX\nX -> X+YF+\nY -> -FX-Y\nangle 90\ngeneration 4\n"},
            {"curves/straight.lsys", "axiom F[A]\nA -> AB\nB -> B\ngeneration 1\n"},
            {"all.claim",
             "claim All kinds of statements\n"
             "let F = D0L fibonacci\nlet G = 0L { axiom a; a -> aa; a -> a }\nlet H = D0L { axiom "
             "a; a -> aa }\n"
             "let T = E0L { axiom S; S -> aSb; S -> ab; terminals a b }\nlet D = D0L { axiom aa; a "
             "-> aa }\nlet E = D0L { axiom b; a -> ab; b -> a }\n"
             "let Q = parametric { axiom A(1); A(x) : x < 3 -> A(x+1)B; B -> B }\n"
             "let R = S0L { axiom a; a -(1/2)-> a; a -(1/2)-> aa }\n"
             "show aaaa in L(G)\nrefute aaa in L(H)\nshow L(H) <= /a+/\nshow L(T) <= /a+b+/\nshow "
             "L(F) == L(E)\n"
             "refute {a, aa} is T0L\nrefute {a, aa} is 0L\nshow L(G) is infinite\nshow {a} & /b*/ "
             "is empty\n"
             "show L(T) & /b*/ is empty\nshow |L(F) & /ab?/| = 2\nshow growth(H) ~ "
             "exponential\nshow growth(H) = 2^n\n"
             "show P(R ==> aa in 2 steps) = 3/8\nshow Q ==> A(3)BB in 2 steps\nshow growth(F) != "
             "growth(H)\n"
             "show sequence(H) != sequence(D)\nshow abaab in L(F) | L(G)\nshow L(F) is not "
             "regular\n"},
            {"paper.tex",
             "\\algaefigure[n=2]{koch}\\algaegrowth{fibonacci}\\algaeword[n=3]{koch}\n"
             "\\algaeis{0L}{{a, aa}}\n"},
            {"drawn.claim",
             "claim Dimensions\nlet G = D0L gosper\nlet K = D0L koch\nshow dimension(G) = 2\n"
             "show boundary(G) = log 3 / log sqrt 7\nrefute dimension(K) = 3/2\nshow dimension(K) "
             "<= 2\n"},
            {"quantified.claim",
             "claim Names\ntheorem not for all 0L languages A, B: A | B is 0L\n"
             "show for all D0L languages A with words up to length 1 over {a, b}: A is 0L\n"
             "show {a} is 0L or {a, aa} is 0L\nshow for all languages A: A* A* == A*\n"},
            {"own.exercise",
             "exercise Twice two\ntask Find a system with the language of even powers.\n"
             "answer system\nshow answer is D0L\nshow aabb in L(answer)\nshow L(answer) is "
             "infinite\n"},
        };
        return all;
    }

    std::filesystem::path path_;
};

/// At most `most` numbers from 1 to `last`, evenly spread.
std::vector<std::uint64_t> spread(std::uint64_t last, std::uint64_t most) {
    std::vector<std::uint64_t> all;
    for (std::uint64_t i = 0; i < std::min(last, most); ++i)
        all.push_back(last <= most ? i + 1 : 1 + i * (last - 1) / (most - 1));
    return all;
}

}  // namespace

TEST_CASE("every verb is stopped somewhere") {
    command::Verbs verbs;
    command::add_verbs(verbs);
    std::set<std::string> known, tried;
    for (const command::Verb& verb : verbs.all) known.insert(verb.name);
    for (const Case& one : cases()) tried.insert(one.verb);
    CHECK(known == tried);
}

TEST_CASE("work that is stopped at any check gives the whole answer or none") {
    constexpr std::uint64_t everywhere = 200, few = 12;
    using By = Stopping::By;
    const Folder folder;
    std::uint64_t stops = 0;
    for (const Case& one : cases()) {
        std::uint64_t checks_of_verb = 0;
        std::vector<std::string> ways = one.ways;
        ways.insert(ways.end(), one.slow.begin(), one.slow.end());
        for (const std::string& way : ways) {
            const bool is_slow = std::find(one.slow.begin(), one.slow.end(), way) != one.slow.end();
            const std::vector<std::string> words = folder.words(one.verb, way);
            const std::string asked = one.verb + ' ' + way;
            CAPTURE(asked);
            std::uint64_t checks = 0;
            const auto whole = [&] {
                const Stopping none(By::nothing, 0);
                const auto done = folder.done(words);
                checks = none.checks();
                return done;
            }();
            CAPTURE(whole.first.err);
            REQUIRE(whole.first.status != command::bad_input);
            checks_of_verb += checks;
            for (const std::uint64_t k : spread(checks, is_slow ? few : everywhere))
                for (const By by : {By::interrupt, k % 2 ? By::time : By::deadline}) {
                    const Stopping stopping(by, k);
                    const auto [ran, written] = folder.done(words);
                    ++stops;
                    CAPTURE(k);
                    CAPTURE(checks);
                    CAPTURE(ran.status);
                    CAPTURE(ran.out);
                    CAPTURE(ran.err);
                    for (const auto& [name, text] : written)
                        CHECK_MESSAGE(whole.second.count(name), "written: " << name);
                    // The first search of `dimension` has a time of its own, and the second one goes on.
                    if (by == By::time &&
                        ran.out.find("\nthe search for parts that coincide goes on\n\n") !=
                            std::string::npos) {
                        CHECK(written == whole.second);
                        CHECK(ran.status == whole.first.status);
                        continue;
                    }
                    if (stopping.checks() < k || (by != By::interrupt && ran == whole.first)) {
                        CHECK(ran == whole.first);
                        CHECK(written == whole.second);
                    } else if (by == By::interrupt) {
                        CHECK(ran.status == command::interrupted);
                        CHECK(ran.err.ends_with("algae: interrupted\n"));
                        CHECK(whole.first.out.starts_with(ran.out));
                    } else {
                        CHECK(ran.status == command::undecided);
                        // A document says of its commands that they are undecided.
                        const std::string said = ran.out + ran.err;
                        CHECK((said.find(over) != std::string::npos ||
                               (one.verb == "latex" &&
                                said.find("undecided within the bounds") != std::string::npos)));
                    }
                }
        }
        CHECK_MESSAGE((checks_of_verb == 0) == never_checks.contains(one.verb),
                      one.verb << ": " << checks_of_verb);
    }
    MESSAGE(stops << " stops");
}
