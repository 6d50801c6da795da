// `algae-census`: the verb `census` run by many processes, with MPI.
//
// Process 0 reads the question and the checkpoint, hands out the numbers of chunks, writes what comes back and prints the
// result; the others take chunks. They ask for a chunk when they are done with one, so a slow machine takes fewer. Which
// process took a chunk does not show in its line, and the sum does not depend on the order, so any number of processes
// prints the same bytes, and so does `algae census`. A process alone takes all chunks itself.
//
// Every message is a text: a request, a line of the checkpoint, or a farewell. Process 0 looks for messages and sleeps
// between: a blocking receive of OpenMPI keeps a processor busy. The others begin only when process 0 has read the
// question, so that a mistake in it is told once.

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>
#include <chrono>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "command/detail/census.hpp"
#include "command/detail/verb.hpp"

namespace algae::command {

namespace {

class MpiRanks : public CensusRanks {
public:
    bool is_first() const override { return world_.rank() == 0; }
    bool is_alone() const { return world_.size() == 1; }

    void serve(const std::function<std::optional<std::uint64_t>()>& next,
               const std::function<void(const CensusChunk&)>& take) override {
        let_others(true);
        std::exception_ptr failure;
        std::string farewell;
        for (int working = world_.size() - 1; working > 0;) {
            const auto message = world_.iprobe(boost::mpi::any_source, boost::mpi::any_tag);
            if (!message) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                continue;
            }
            std::string text;
            world_.recv(message->source(), message->tag(), text);
            try {
                if (message->tag() == request) {
                    std::string number;
                    if (const auto chunk = failure ? std::nullopt : next())
                        number = std::to_string(*chunk);
                    world_.send(message->source(), answer, number);
                } else if (message->tag() == line) {
                    if (const auto chunk = census_chunk(text); chunk && !failure) take(*chunk);
                } else {
                    --working;
                    if (farewell.empty()) farewell = text;
                }
            } catch (...) {
                if (!failure) failure = std::current_exception();
                if (message->tag() == request)
                    world_.send(message->source(), answer, std::string());
            }
        }
        if (failure) std::rethrow_exception(failure);
        if (!farewell.empty() && !stop) throw Error(farewell);
    }

    std::optional<std::uint64_t> next() override {
        world_.send(0, request, std::string());
        std::string number;
        world_.recv(0, answer, number);
        if (number.empty()) return std::nullopt;
        return std::stoull(number);
    }
    void send(const CensusChunk& chunk) override { world_.send(0, line, census_line(chunk)); }

    /// Of the first process: whether the others are to begin. Of the others: waits for that.
    bool let_others(bool begin) {
        if (!is_decided_) boost::mpi::broadcast(world_, begin, 0);
        is_decided_ = true;
        return begin;
    }
    /// Of the others: nothing more comes from this one; with the reason if it failed.
    void leave(int status) {
        world_.send(0, farewell_tag,
                    status == success ? std::string()
                                      : "process " + std::to_string(world_.rank()) +
                                            " stopped with status " + std::to_string(status));
    }

private:
    enum Tag { request, answer, line, farewell_tag };
    boost::mpi::communicator world_;
    bool is_decided_ = false;
};

}  // namespace

}  // namespace algae::command

int main(int argc, char** argv) {
    using namespace algae::command;
    const boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
    handle_stops();
    MpiRanks ranks;
    if (!ranks.is_alone()) census_ranks = &ranks;
    std::string program = "algae", verb = "census";
    std::vector<char*> arguments{program.data(), verb.data()};
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    const int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    if (!ranks.is_first() && !ranks.let_others(false)) return success;
    const int status = run_command(count, arguments.data());
    if (ranks.is_first())
        ranks.let_others(false);
    else
        ranks.leave(status);
    return status;
}
