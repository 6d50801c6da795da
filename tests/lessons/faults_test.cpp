#include <doctest/doctest.h>

#include <string>

#include "command/run.hpp"

namespace {

/// What algae says of an exercise: its task is asked for.
Run read(const std::string& text, const std::string& more = "") {
    const Scratch files;
    return run("lesson " + files.file("e.exercise", text) + " " + more);
}

/// Whether the exercise is refused with this text in the message, without an answer, with one, and as JSON.
bool refused(const std::string& text, const std::string& message) {
    const Scratch files;
    const std::string answer = files.file("answer.lsys", "axiom a\na -> aa\n");
    bool all = true;
    for (const std::string& more :
         {std::string(), answer, std::string("--json"), answer + " --json"}) {
        const Run found = read(text, more);
        CAPTURE(more);
        CAPTURE(found.err);
        CHECK(found.status == 2);
        CHECK(found.err.find(message) != std::string::npos);
        all = all && found.status == 2 && found.err.find(message) != std::string::npos;
    }
    return all;
}

const std::string head = "exercise A\ntask x\nanswer system\n";

}  // namespace

TEST_CASE("an exercise whose answer is a claim without names is refused") {
    const std::string message =
        "e.exercise:3:8: error: expected names behind 'answer claim', found the end of the line";
    CHECK(refused("exercise A\ntask x\nanswer claim\nshow G == H\n", message));
    CHECK(refused("exercise A\ntask x\nanswer claim # G H\nshow G == H\n", message));
    CHECK(refused("exercise A\ntask x\nanswer claim 3\nshow G == H\n",
                  "e.exercise:3:14: error: expected a name"));
    CHECK(refused("exercise A\ntask x\nanswer system please\nshow answer is D0L\n",
                  "e.exercise:3:15: error: expected the end of the line, found 'please'"));
    CHECK(refused("exercise A\ntask x\nanswer sistem\nshow answer is D0L\n",
                  "e.exercise:3:8: error: expected system, language, word or claim and names, "
                  "found 'sistem'; did you mean 'system'?"));
}

TEST_CASE("words behind a statement of an exercise are refused where they stand") {
    CHECK(refused(head + "show answer is PD0L banana\n",
                  "e.exercise:4:21: error: expected the end of the statement, found 'banana'"));
    CHECK(refused(head + "show answer has 2 rules and a pony\n",
                  "e.exercise:4:25: error: expected the end of the statement, found 'and'"));
    CHECK(
        refused(head + "show answer has 2 rulez\n",
                "e.exercise:4:19: error: expected rules, letters or axiom symbols, found 'rulez'"));
    CHECK(refused(head + "show answer has 2 axiom pigs\n",
                  "e.exercise:4:25: error: expected 'symbols'"));
    CHECK(
        refused(head + "show answer has at 2 rules\n", "e.exercise:4:20: error: expected 'most'"));
    CHECK(refused(head + "show figure(answer, 3) == figure(koch, 3) hello\n",
                  "e.exercise:4:43: error: expected the end of the statement, found 'hello'"));
    CHECK(refused(head + "show figure(answer, 3) == figure(koch, 3); show answer is D0L\n",
                  "e.exercise:4:44: error: expected one statement in a line"));
    CHECK(refused(head + "show answer is FOO\n",
                  "e.exercise:4:16: error: expected the name of a form of systems, found 'FOO'"));
    CHECK(read(head + "show answer is D0L # of course\n").status == 0);
    CHECK(read(head + "show answer has 1 axiom symbol\nshow answer has at most 2 rules\n").status ==
          0);
}

TEST_CASE("lines that an exercise does not have are refused, and those that it has twice") {
    const std::string expected =
        "expected one of exercise, source, task, answer, show, hint, "
        "alphabet, allow or let, found ";
    CHECK(refused(head + "show answer is D0L\nfoo bar\n",
                  "e.exercise:5:1: error: " + expected + "'foo'"));
    CHECK(refused(head + "show answer is D0L\nhnit look\n",
                  "e.exercise:5:1: error: " + expected + "'hnit'; did you mean 'hint'?"));
    CHECK(refused(head + "SHOW answer is D0L\nshow answer is D0L\n",
                  "e.exercise:4:1: error: " + expected + "'SHOW'; did you mean 'show'?"));
    CHECK(refused("exercise A\nexercise B\ntask x\nshow answer is D0L\n",
                  "e.exercise:2:1: error: 'exercise' is given twice, first in line 1"));
    CHECK(refused(head + "answer word\nshow answer is D0L\n",
                  "e.exercise:4:1: error: 'answer' is given twice, first in line 3"));
    CHECK(refused(head + "source a\nsource b\nshow answer is D0L\n",
                  "e.exercise:5:1: error: 'source' is given twice, first in line 4"));
    CHECK(refused(head + "let h = { a -> a }; show answer is D0L\nshow answer is D0L\n",
                  "e.exercise:4:21: error: expected 'show' at the start of a line"));
    CHECK(read("# mine\n" + head +
               "let G = D0L {\n  source a book\n  axiom a # {\n  a -> aa\n}\n"
               "show growth(answer) == growth(G)\n")
              .status == 0);
}

TEST_CASE("names, families and systems that there are not are told when an exercise is read") {
    CHECK(refused(head + "show growth(answr) = 2^n\n",
                  "e.exercise:4:13: error: expected a name that is defined above, found 'answr'; "
                  "did you mean 'answer'?"));
    CHECK(refused(head + "show answer is D0L\nshow growth(answer) == growth(model)\n",
                  "e.exercise:5:31: error: expected a name that is defined above, found 'model'"));
    CHECK(refused("exercise A\ntask x\nanswer language\nshow answer is FOO\n",
                  "e.exercise:4:16: error: expected a family"));
    CHECK(refused("exercise A\ntask x\nanswer word\nshow answer === {a}\n", "e.exercise:4:"));
    CHECK(refused("exercise A\ntask x\nanswer claim G H\nshow L(G) == L(K)\n",
                  "e.exercise:4:16: error: expected a name that is defined above, found 'K'"));
    CHECK(refused(head + "let model = D0L fibonaci\nshow growth(answer) == growth(model)\n",
                  "e.exercise:4:17: error: no file \"fibonaci\""));
    CHECK(refused(head + "show figure(answer, 3) == figure(kochh, 3)\n",
                  "e.exercise:4:34: error: no file \"kochh\""));
    CHECK(refused(head + "hint none\nshow answer is D0L\n",
                  "e.exercise:4:1: error: expected a 'show'"));
}

TEST_CASE("what is wrong with one kind of answer only is no fault of an exercise") {
    CHECK(read(head + "show P(answer ==> aa in 1 step) = 1/4\n").status == 0);
    CHECK(read(head + "show growth(answer) = 2^n\nshow L(answer) is regular\n").status == 0);
    CHECK(read(head + "show answer ==> R(2)R(0) in 2 steps\n").status == 0);
    CHECK(read("exercise A\ntask x\nanswer claim G A\nshow L(G) == A\nshow growth(G) = 2^n\n")
              .status == 0);
    CHECK(read("exercise A\ntask x\nanswer word\nlet h = { x -> xy; y -> x }\nshow h(answer) == "
               "{xy}\n")
              .status == 0);
}

TEST_CASE("a system that may stand beside the answer is sought when there is one") {
    const std::string text = head +
                             "let model = D0L model.lsys\nshow growth(answer) == growth(model)\n"
                             "show figure(answer, 1) == figure(model.lsys, 1)\n";
    CHECK(read(text).status == 0);
    const Scratch files;
    const std::string answer = files.file("answer.lsys", "axiom F\nF -> FF\n");
    CHECK(read(text, answer).err.find("e.exercise:4:17: error: no file \"model.lsys\"") !=
          std::string::npos);
    files.file("model.lsys", "axiom F\nF -> FF\n");
    CHECK(read(text, answer).status == 0);
}

TEST_CASE("an exercise without a task or anything to show is refused at the end of its file") {
    CHECK(refused(
        head,
        "e.exercise:4:1: error: expected a line 'show STATEMENT' before the end of the file"));
    CHECK(refused("exercise A\nshow answer is D0L\n",
                  "e.exercise:3:1: error: expected a line 'task TEXT' before the end of the file"));
    CHECK(refused("", "e.exercise:1:1: error: expected a line 'exercise TITLE' before the end"));
}

TEST_CASE("an exercise that is no UTF-8 is refused where the first wrong byte stands") {
    CHECK(
        refused("exercise A\ntask Gr\xF6\xDF"
                "e\nshow answer is D0L\n",
                "e.exercise:2:8: error: "));
    const Scratch files;
    const Run word = run("lesson 1 --exercise 1 --json " + files.file("answer.txt", "a\xF6\n"));
    CHECK(word.status == 2);
    CHECK(word.err.find("answer.txt:1:2: ") != std::string::npos);
}

TEST_CASE("options of lesson that make no sense together, or as numbers, are refused") {
    const Run zero = run("lesson 1 --exercise 0");
    CHECK(zero.status == 2);
    CHECK(zero.err.find("exercises 1 to 5, found 0") != std::string::npos);
    CHECK(zero.err.size() < 200);
    CHECK(run("lesson 1 --exercise -1").status == 2);
    CHECK(run("lesson 1 --exercise two").status == 2);
    const Scratch files;
    const Run out = read(head + "show answer is D0L\n", "--out " + files.file("folder"));
    CHECK(out.status == 2);
    CHECK(out.err.find("--out") != std::string::npos);
    CHECK(files.size() == 0);
    CHECK(run("lesson 3 --max-letters -1").status == 2);
    CHECK(run("lesson --max-letters -1").status == 2);
    CHECK(run("lesson 1 --exercise 1 --max-letters many").status == 2);
}
