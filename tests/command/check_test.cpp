#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "command/run.hpp"
#include "places.hpp"

using nlohmann::json;

namespace {

const std::string right =
    "claim powers of two\nlet G = D0L { axiom a; a -> aa }\nshow aaaa in L(G)\nrefute aaa in "
    "L(G)\n";
const std::string wrong = "claim one letter\nshow {a} is 0L\nshow {a, aa} is 0L\n";
const std::string open = "claim star\nlet A = {b a^(2^n) : n >= 0}\nshow A* is 0L\n";
const std::string cited = "claim star\nlet A = {b a^(2^n) : n >= 0}\nshow A* is not 0L by a book\n";

}  // namespace

TEST_CASE(
    "check ends with 0, 1 or 3: all hold, one fails, none fails and one is undecided or cited") {
    const Scratch files;
    const Run stands = run("check " + files.file("right.claim", right));
    CHECK(stands.status == 0);
    CHECK(stands.out == "claim powers of two\n  examples: 2 of 2 hold\n");
    const std::string file = files.file("wrong.claim", wrong);
    const Run refuted = run("check " + file);
    CHECK(refuted.status == 1);
    CHECK(refuted.out.starts_with("claim one letter\n  examples: 1 of 2 hold\n    " + file +
                                  ":3:6: {a, aa} is 0L: refuted\n        {a, aa} is not 0L.\n"));
    const std::string undecided = files.file("open.claim", open);
    const Run tried = run("check " + undecided);
    CHECK(tried.status == 3);
    CHECK(tried.out ==
          "claim star\n  examples: 0 of 1 hold\n    " + undecided +
              ":3:6: A* is 0L: undecided\n"
              "        A* was not found to be finite or regular; that no 0L system does "
              "is decided for few other languages\n");
    const std::string book = files.file("cited.claim", cited);
    const Run source = run("check " + book);
    CHECK(source.status == 3);
    CHECK(source.out == "claim star\n  examples: 0 of 1 hold\n    " + book +
                            ":3:6: A* is not 0L: cited\n        a book\n");
    CHECK(run("check --accept cited " + book).status == 0);
    CHECK(run("check --accept all " + book).err ==
          "algae: --accept: expected 'cited', found 'all'\n");
}

TEST_CASE("check of a dimension within a time says that it is over, and nothing of the rules") {
    const std::string claim = source_folder() + "/theory/document-001/dimension-gosper.claim";
    for (const char* option : {"", " --json"}) {
        const Run found = run("check '" + claim + "' --timeout 0.001" + option);
        CHECK(found.status == 3);
        CHECK((found.out + found.err).find("the time allowed by --timeout is over") !=
              std::string::npos);
        CHECK((found.out + found.err).find("formula") == std::string::npos);
    }
    CHECK(run("check '" + claim + "'").status == 0);
}

TEST_CASE("check of a folder counts its claims, those in folders of it too, and other files not") {
    const Scratch files;
    std::filesystem::create_directory(files.path() / "more");
    files.file("b.claim", wrong);
    files.file("a.claim", right);
    files.file("more/c.claim", open);
    files.file("d.txt", "no claim");
    const Run found = run("check " + files.path().string());
    CHECK(found.status == 1);
    CHECK(
        found.out.starts_with("claim powers of two\n  examples: 2 of 2 hold\nclaim one letter\n"));
    CHECK(found.out.ends_with("3 claims: 1 examples, 1 undecided, 1 refuted\n"));
}

TEST_CASE("check --json tells claims, statements, verdicts and arguments") {
    const Scratch files;
    const Run found = run("check --json " + files.file("right.claim", right) + " " +
                          files.file("cited.claim", cited));
    CHECK(found.status == 3);
    const json claims = json::parse(found.out)["claims"];
    CHECK(claims.size() == 2);
    CHECK(claims[0]["claim"] == "powers of two");
    CHECK(claims[0]["verdict"] == "examples");
    CHECK(claims[0]["examples"] == json{{"hold", 2}, {"of", 2}});
    const json statements = json::parse(R"json([
        {"text": "aaaa in L(G)", "verdict": "proved", "argument": ["aaaa is in L(G): a => aa => aaaa."]},
        {"text": "aaa in L(G)", "verdict": "refuted", "argument":
          ["aaa is not in L(G): generations 0 to 1 are not this word, and from then on all words are longer."]}])json");
    CHECK(claims[0]["statements"] == statements);
    CHECK(claims[1]["verdict"] == "cited");
    CHECK(claims[1]["statements"][0]["verdict"] == "cited");
    CHECK(claims[1]["statements"][0]["citation"] == "a book");
}

TEST_CASE("check --explain of Theorem 8 of document 001 is the proof by cases") {
    const Run page =
        run("check '" + source_folder() + "/theory/document-001/theorem-8.claim' --explain");
    CHECK(page.status == 0);
    CHECK(page.out.starts_with("0L languages are not closed under union\n001 Theorem 8\n\n"));
    const std::string proof =
        "A | B is not 0L: proved.\n"
        "   A | B = {a, aa}.\n"
        "   {a, aa} is not 0L.\n"
        "   Suppose that a system generates it. Each letter occurs in a word of the language, and "
        "what that\n"
        "   word gives is in the language again. So an image of a letter is one of the factors of "
        "its words:\n"
        "   ε, a or aa.\n"
        "   a -> ε is impossible: a would give ε, which is not in the language.\n"
        "   a -> aa is impossible: aa would give aaaa, which is not in the language.\n"
        "   a -> a is left.\n"
        "   By what is left, no other word gives a, and no other word gives aa. The axiom is not "
        "both, so one\n"
        "   of these words is never reached.\n"
        "   So {a, aa} is not 0L.\n";
    CHECK(page.out.find(proof) != std::string::npos);
}

TEST_CASE("check --explain tells definitions, and separates claims") {
    const Scratch files;
    const Run page = run("check --explain " +
                         files.file("a.claim", "claim T\nallow empty axiom\nshow {ε} is 0L\n") +
                         " " + files.file("b.claim", "claim U\nnote Words.\nshow {a} is finite\n"));
    CHECK(page.status == 0);
    CHECK(
        page.out ==
        "T\n\nSystems may have the empty word as axiom.\n\n1. {ε} is 0L: proved.\n   The system "
        "with axiom ε generates it.\n"
        "\n" +
            std::string(100, '=') +
            "\n\n"
            "U\n\nWords.\n\n1. {a} is finite: proved.\n   {a} has 1 word.\n2 claims: 2 examples\n");
}

TEST_CASE("check --certificate writes what verify checks") {
    const Scratch files;
    const std::string certificate = files.file("proof.json");
    CHECK(
        run("check " + files.file("right.claim", right) + " --certificate " + certificate).status ==
        0);
    const json written = json::parse(text_of(certificate));
    CHECK(written["format"] == "algae certificate 1");
    CHECK(written["claim"] == "powers of two");
    CHECK(written["statements"].size() == 2);
    CHECK(!written.contains("empty axiom"));
    const Run verified = run("verify " + certificate);
    CHECK(verified.status == 0);
    CHECK(verified.out ==
          "letters a\nG: axiom a; a -> aa\nchecked: aaaa is in L(G)\nchecked: aaa is not in L(G)\n"
          "2 checked\n");
    const std::string claim = files.file("right.claim", right);
    CHECK(run("verify " + certificate + " --against " + claim).status == 0);
    const Run other = run("verify " + certificate + " --against " +
                          files.file("other.claim",
                                     "claim powers of two\nlet G = D0L { axiom a; a -> aa }\n"
                                     "show aaaa in L(G)\nrefute aaaaa in L(G)\n"));
    CHECK(other.status == 2);
    CHECK(other.out == "letters a\nG: axiom a; a -> aa\nchecked: aaaa is in L(G)\n");
    CHECK(other.err == "algae: " + certificate + ": the certificate is not of " +
                           files.file("other.claim") +
                           ": statement 2 differs, which the claim writes aaaaa in L(G)\n");
    CHECK(
        run("check " + files.file("wrong.claim", wrong) + " --certificate " + certificate).status ==
        1);
    CHECK(run("verify " + certificate).status == 0);  // it holds the proof that the claim is wrong
}

TEST_CASE("verify ends with 3 where not everything was checked") {
    const Scratch files;
    const std::string certificate = files.file("proof.json");
    run("check " + files.file("cited.claim", cited) + " --certificate " + certificate);
    const Run rests = run("verify " + certificate);
    CHECK(rests.status == 3);
    CHECK(rests.out ==
          "letters b a\ncited: not checked: {(b)^(1) (a)^(2^n) : n >= 0}* is not 0L (a book)\n1 "
          "cited: "
          "not checked\n");
    CHECK(run("verify " + certificate + " --accept cited").status == 0);
    run("check " + files.file("open.claim", open) + " --certificate " + certificate);
    CHECK(run("verify " + certificate).status == 3);
}

TEST_CASE("verify prints what it checked: rules, formulas, and long names in quotes") {
    const Scratch files;
    const std::string certificate = files.file("proof.json");
    run("check " +
        files.file("names.claim",
                   "claim T\nalphabet ab c\nlet G = D0L { axiom c; c -> c ab }\n"
                   "show growth(G) = n + 1\nshow {ab, c ab} is finite\n") +
        " --certificate " + certificate);
    const Run found = run("verify " + certificate);
    CHECK(found.status == 0);
    CHECK(found.out ==
          "letters 'ab' c\nG: axiom c; c -> c'ab'\nchecked: for all numbers n: length(G,n) = n+1\n"
          "checked: {'ab', c'ab'} is finite\n2 checked\n");
    std::string text = text_of(certificate);
    text.replace(text.find("\"ab\""), 4, "\"a\\u001b[2J\"");
    const Run bad = run("verify " + files.file("bad.json", text));
    CHECK(bad.status == 2);
    CHECK(bad.err.find("a name must not have control characters") != std::string::npos);
}

TEST_CASE("a title, whatever it says, is not what is proved") {
    const Scratch files;
    const auto out = [&](const std::string& lines) {
        return run("check " + files.file("x.claim", lines)).out;
    };
    CHECK(out("claim 0L languages are closed under union\nlet A = {a}; let B = {b}\n"
              "show A | B is 0L\nclosed under union: 0L\n") ==
          "claim 0L languages are closed under union\n  examples: 1 of 1 hold\n");
    CHECK(out("claim P = NP\nshow a in {a}\n") == "claim P = NP\n  examples: 1 of 1 hold\n");
    CHECK(out("claim proved     Every word is a palindrome\nshow a in {a}\n").find("\nproved") ==
          std::string::npos);
    const std::string empty = files.file("empty.claim", "claim Every word is a palindrome\n");
    const Run nothing = run("check " + empty);
    CHECK(nothing.status == 2);
    CHECK(nothing.err ==
          "algae: " + empty +
              ": expected a statement (theorem, show, lemma or refute), found none\n");
}

TEST_CASE("check tells a theorem with its verdict, and --say takes it at the prompt") {
    const Scratch files;
    const Run claim =
        run("check " + files.file("union.claim",
                                  "claim No union\n"
                                  "theorem not for all 0L languages A, B: A | B is 0L\n"
                                  "show {a} is 0L\n"));
    CHECK(claim.status == 0);
    CHECK(claim.out ==
          "claim No union\n  theorem not for all 0L languages A, B: A | B is 0L\n"
          "    proved by the counterexample A = {a}, B = {aa}\n  examples: 1 of 1 hold\n");
    const Run said = run("check --say 'for all 0L languages A, B: A | B is 0L' --json");
    CHECK(said.status == 1);
    const json found = json::parse(said.out)["claims"][0];
    CHECK(found["verdict"] == "refuted");
    CHECK(found["theorem"]["method"] == "instance");
    CHECK(found["theorem"]["counterexample"] == json{{"A", "{a}"}, {"B", "{aa}"}});
    CHECK(found["theorem"]["searched"]["size"] == 5);
    CHECK(found["theorem"]["searched"]["undecided"] == 0);
    const Run some = run("check --say 'for some finite language A: A is not 0L' --json");
    CHECK(json::parse(some.out)["claims"][0]["theorem"]["example"] == json{{"A", "{}"}});
    CHECK(run("check --say 'for all 0L languages A: A | A is 0L' --size 4").status == 3);
    CHECK(run("check --say 'for all 0L languages A: A^R is 0L'").status == 0);
    CHECK(
        run("check --say 'A is 0L'")
            .err.starts_with("--say:1:9: error: expected a name that is defined above, found 'A'"));
    CHECK(run("check").err ==
          "algae: expected files of claims or --say and a statement, found neither\n");
}

TEST_CASE("a claim that allows the empty axiom says so in its certificate") {
    const Scratch files;
    const std::string certificate = files.file("proof.json");
    CHECK(run("check " + files.file("strict.claim", "claim T\nshow {ε} is 0L\n")).status == 1);
    CHECK(run("check " +
              files.file("allowed.claim", "claim T\nallow empty axiom\nshow {ε} is 0L\n") +
              " --certificate " + certificate)
              .status == 0);
    CHECK(json::parse(text_of(certificate))["empty axiom"] == true);
    CHECK(run("verify " + certificate).status == 0);
}

TEST_CASE("check refuses what it cannot read or write, and leaves no file behind") {
    const Scratch files;
    const std::string good = files.file("right.claim", right);
    const auto refused = [](const std::string& arguments, const std::string& message) {
        const Run found = run("check " + arguments);
        CHECK(found.status == 2);
        CHECK(found.out.empty());
        CAPTURE(found.err);
        CHECK(found.err.find(message) != std::string::npos);
    };
    const std::string names = files.file("names.claim", "claim x\nshow B is 0L\nshow {a} is 0LX\n");
    refused(names, names + ":2:6: error: expected a name that is defined above, found 'B'");
    refused(names, names + ":3:13: error: expected a family");
    refused(good + " " + names, ":2:6: error");  // before anything is decided
    std::filesystem::create_directory(files.path() / "empty");
    refused(files.file("empty"), "expected .claim files in this folder, found none");
    refused(files.file("none.claim"), "cannot read");
    refused("", "expected files of claims or --say and a statement, found neither");
    const std::string certificate = files.file("proof.json");
    refused(good + " " + good + " --certificate " + certificate,
            "--certificate takes one claim, found 2");
    refused(good + " --certificate " + files.file("none/proof.json"), "cannot write");
    const std::string growth = files.file(
        "growth.claim",
        "claim x\nlet G = 0L { axiom a; a -> a; a -> aa }\nshow growth(G) = n\nshow a in L(G)\n");
    const Run unsupported = run("check " + growth);  // the other statements are decided
    CHECK(unsupported.status == 3);
    CHECK(unsupported.out == "claim x\n  examples: 1 of 2 hold\n    " + growth +
                                 ":3:6: growth(G) = n: undecided\n        " + growth +
                                 ":3:6: G is not a D0L system: a letter has several rules\n");
    CHECK(!std::filesystem::exists(certificate));
    for (const auto& entry : std::filesystem::directory_iterator(files.path()))
        CHECK(entry.path().filename().string().find("proof") == std::string::npos);
}

TEST_CASE("check reads standard input") {
    const Run found = run("check -", "printf 'claim T; show {a} is 0L' |");
    CHECK(found.status == 0);
    CHECK(found.out == "claim T\n  examples: 1 of 1 hold\n");
}

TEST_CASE("check and its folders know the theory that comes with algae, wherever it runs") {
    const Scratch files;
    const std::string there = "cd '" + files.path().string() + "' &&";
    const Run all = run("check theory/finite", there);
    CHECK(all.status == 0);
    CHECK(all.out.ends_with("\n11 claims: 7 proved, 4 examples\n"));
    const Run one = run("check theory/closure/union-not-0l.claim --certificate c.json", there);
    CHECK(one.status == 0);
    CHECK(std::filesystem::exists(files.file("c.json")));
    std::filesystem::create_directory(files.path() / "theory");
    files.file("theory/own.claim", right);  // a folder of one's own comes first
    CHECK(run("check theory", there).out == "claim powers of two\n  examples: 2 of 2 hold\n");
    const Run none = run("check theory/finite", there);
    CHECK(none.status == 0);
    const Run missing = run("check no-theory", there);
    CHECK(missing.status == 2);
    CHECK(missing.err == "algae: cannot read no-theory: No such file or directory\n");
}

TEST_CASE("a search that is written down goes on to the same answer") {
    const Scratch files;
    const std::string asked = "check --say 'for all D0L languages A: A* is 0L' --instances ";
    const std::string file = files.file("search.jsonl");
    const Run whole = run(asked + "3000");
    CHECK(whole.status == 3);
    const Run begun = run(asked + "500 --checkpoint " + file);
    CHECK(begun.status == 3);
    CHECK(begun.out.find("among the first 500 instances") != std::string::npos);
    const std::string written = text_of(file);
    CHECK(run(asked + "3000 --resume " + file).out == whole.out);
    CHECK(text_of(file).starts_with(written));
    // Whatever of the file a killed process leaves behind the first line.
    const std::size_t header = written.find('\n') + 1;
    std::size_t cuts = 0;
    for (std::size_t size = header; size < written.size(); size += 1 + written.size() / 23) {
        const std::string torn = files.file("torn.jsonl", written.substr(0, size));
        CAPTURE(size);
        CHECK(run(asked + "3000 --resume " + torn).out == whole.out);
        ++cuts;
    }
    CHECK(cuts > 5);
    // A counterexample is the one that is found in one go.
    const std::string fails = "check --say 'for all 0L languages A: A is DT0L' --instances ";
    const std::string other = files.file("other.jsonl");
    run(fails + "20 --checkpoint " + other);
    const Run found = run(fails + "3000 --resume " + other);
    CHECK(found.status == 1);
    CHECK(found.out == run(fails + "3000").out);

    const Run wrong_file = run(asked + "3000 --resume " + other);
    CHECK(wrong_file.status == 2);
    CHECK(wrong_file.err.find("other.jsonl:1: the checkpoint is of another question; expected ") !=
          std::string::npos);
    CHECK(wrong_file.err.find("A: A* is 0L") != std::string::npos);
    CHECK(wrong_file.err.size() < 500);
    // A file of one line without an end was once taken for a torn header, and emptied.
    const std::string notes = files.file("notes.txt", "what I want to keep");
    const Run kept = run(asked + "500 --resume " + notes);
    CHECK(kept.status == 2);
    CHECK(
        kept.err.find("notes.txt:1: this is no checkpoint of the question; expected {\"format\"") !=
        std::string::npos);
    CHECK(text_of(notes) == "what I want to keep");
    const Run there = run(asked + "500 --checkpoint " + file);
    CHECK(there.status == 2);
    CHECK(there.err.find("is there already") != std::string::npos);
    const Run plain = run("check --say 'a in {a}' --checkpoint " + files.file("no.jsonl"));
    CHECK(plain.status == 2);
    CHECK(plain.err ==
          "algae: --checkpoint: expected one statement about all values, or some, and nothing "
          "else\n");
}
