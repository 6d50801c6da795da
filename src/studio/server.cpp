// The server: addresses, who may ask, and how an answer travels.
//
// A page of somebody else that is open in the same browser can send requests to any address, and its name may be made to lead to this
// machine. So three things are asked of every request: the address begins with a token that only the printed address has; the header Host
// names what is served; the header Origin, where a browser sends one, is that of the page itself. Questions have to be JSON by their
// header, which a form of another page cannot say.
//
// An answer is a stream of lines. While the work goes on, lines that begin with ~ say how far it is, and blank lines come where
// nothing was said for a while: they find out whether the page still listens. Then comes one line of JSON, {"status":0,"end":"answered","said":""},
// and all that follows it is what the worker wrote, byte for byte. So an answer has status 200 however the work ended.
//
// Each connection has a thread and carries one request; a client that sends a byte now and then costs a sleeping thread for as long as its
// header is allowed to take, and nobody waits for it.

#include <arpa/inet.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "studio/detail/workers.hpp"
#include "studio/studio.hpp"

// As Debian builds the library: without these its classes have other members.
#define CPPHTTPLIB_OPENSSL_SUPPORT
#define CPPHTTPLIB_ZLIB_SUPPORT
#define CPPHTTPLIB_BROTLI_SUPPORT
#include <httplib.h>

namespace algae {

namespace {

using namespace std::chrono_literals;

/// A thread for each connection, of which there are at most so many; others wait. Threads are not waited for: at the end a client that
/// says nothing would hold the server up.
class Connections : public httplib::TaskQueue {
public:
    explicit Connections(std::size_t most) : state_(std::make_shared<State>()) {
        state_->most = most;
    }
    void enqueue(std::function<void()> work) override {
        {
            const std::lock_guard lock(state_->mutex);
            if (state_->running == state_->most) {
                state_->waiting.push_back(std::move(work));
                return;
            }
            ++state_->running;
        }
        std::thread([state = state_, work = std::move(work)]() mutable {
            for (;;) {
                work();
                const std::lock_guard lock(state->mutex);
                if (state->waiting.empty()) {
                    --state->running;
                    state->idle.notify_all();
                    return;
                }
                work = std::move(state->waiting.front());
                state->waiting.pop_front();
            }
        }).detach();
    }
    void shutdown() override {
        std::unique_lock lock(state_->mutex);
        state_->waiting.clear();
        state_->idle.wait_for(lock, 300ms, [&] { return state_->running == 0; });
    }

private:
    struct State {
        std::mutex mutex;
        std::condition_variable idle;
        std::deque<std::function<void()>> waiting;
        std::size_t running = 0, most = 0;
    };
    std::shared_ptr<State> state_;
};

/// Places for so many workers at a time.
class Places {
public:
    explicit Places(unsigned count) : free_(count) {}
    bool take() {
        std::unique_lock lock(mutex_);
        if (!changed_.wait_for(lock, 50ms, [&] { return free_ > 0; })) return false;
        --free_;
        return true;
    }
    void give_back() {
        {
            const std::lock_guard lock(mutex_);
            ++free_;
        }
        changed_.notify_one();
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    unsigned free_;
};

/// Whether the texts are equal, in a time that does not tell where they differ.
bool is_equal(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    unsigned char differ = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        differ = static_cast<unsigned char>(differ | (a[i] ^ b[i]));
    return differ == 0;
}

bool is_loopback(const std::string& host) {
    return host.starts_with("127.") || host == "localhost" || host == "::1";
}

std::string in_address(const std::string& host) {
    return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

const char* name_of(Answered::End end) {
    switch (end) {
        case Answered::End::answered:
            return "answered";
        case Answered::End::gone:
            return "gone";
        case Answered::End::time:
            return "time";
        case Answered::End::size:
            return "size";
        case Answered::End::broken:
            return "broken";
    }
    return "broken";
}

/// Everything that handlers use. It lives as long as the last connection.
class Serving {
public:
    explicit Serving(const Studio& studio)
        : studio_(studio),
          workers_(studio.answer, studio.share),
          places_(std::max(1U, studio.share.at_once)) {}

    /// Listens, and returns the port.
    int bind() {
        server_.set_default_headers(
            {{"Content-Security-Policy",
              "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src "
              "'unsafe-inline'; img-src data: blob:; font-src data:; connect-src 'self'; "
              "frame-ancestors "
              "'self'; form-action 'none'; base-uri 'none'"},
             {"Referrer-Policy", "no-referrer"},
             {"X-Content-Type-Options", "nosniff"},
             {"Cross-Origin-Resource-Policy", "same-origin"},
             {"Cache-Control", "no-store"}});
        server_.set_payload_max_length(studio_.share.question);
        server_.set_keep_alive_max_count(1);
        server_.set_read_timeout(5);
        server_.set_write_timeout(10);
        server_.set_tcp_nodelay(true);
        server_.set_socket_options([](socket_t socket) {
            // Not SO_REUSEPORT, the library's own choice: with it two studios would share a port, and its requests.
            const int yes = 1;
            ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        });
        server_.new_task_queue = [] { return new Connections(256); };
        server_.set_pre_routing_handler(
            [this](const httplib::Request& request, httplib::Response& response) {
                return look_at(request, response);
            });
        server_.Get("/.*", [this](const httplib::Request& request, httplib::Response& response) {
            get(request, response);
        });
        server_.Post("/.*", [this](const httplib::Request& request, httplib::Response& response) {
            post(request, response);
        });
        server_.set_exception_handler(
            [](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
                refuse(response, 500, "the server failed");
            });
        port_ = studio_.port == 0 ? server_.bind_to_any_port(studio_.host.c_str())
                : server_.bind_to_port(studio_.host.c_str(), studio_.port) ? studio_.port
                                                                           : -1;
        if (port_ <= 0)
            throw Error("cannot listen on " + in_address(studio_.host) +
                        (studio_.port == 0 ? std::string() : ":" + std::to_string(studio_.port)) +
                        ": the address is not this machine's, or the port is in use");
        names_.push_back(in_address(studio_.host));
        if (is_loopback(studio_.host)) names_.insert(names_.end(), {"localhost", "127.0.0.1"});
        return port_;
    }

    std::string address() const {
        const bool everywhere = studio_.host == "0.0.0.0" || studio_.host == "::";
        return "http://" + (everywhere ? own_name() : in_address(studio_.host)) + ":" +
               std::to_string(port_) + "/" + studio_.token + "/";
    }

    void listen() { server_.listen_after_bind(); }
    bool is_running() const { return server_.is_running(); }

    void stop() {
        stopped_ = true;
        server_.stop();
    }

private:
    using Handled = httplib::Server::HandlerResponse;

    static std::string own_name() {
        char name[256] = {};
        return ::gethostname(name, sizeof name - 1) == 0 ? std::string(name)
                                                         : std::string("localhost");
    }

    static void refuse(httplib::Response& response, int status, const std::string& why) {
        response.status = status;
        response.set_content(why + "\n", "text/plain");
    }

    /// Whether the host of an address is a number, 192.0.2.7 or [fe80::1]; a name may have all letters of one.
    static bool is_number(std::string_view host) {
        const bool is_long = host.size() > 2 && host.front() == '[' && host.back() == ']';
        if (is_long) host = host.substr(1, host.size() - 2);
        in6_addr number = {};
        return ::inet_pton(is_long ? AF_INET6 : AF_INET, std::string(host).c_str(), &number) == 1;
    }

    /// Whether a browser asked for a machine that this is.
    bool is_own_host(const std::string& host) const {
        const std::string port = ":" + std::to_string(port_);
        if (!host.ends_with(port)) return false;
        const std::string name = host.substr(0, host.size() - port.size());
        if (studio_.host == "0.0.0.0" || studio_.host == "::")
            // Any of the machine's addresses, as numbers, or its name: other names may be made to lead here.
            return name == own_name() || name == "localhost" || is_number(name);
        return std::ranges::find(names_, name) != names_.end();
    }

    Handled look_at(const httplib::Request& request, httplib::Response& response) const {
        const std::string host = request.get_header_value("Host"),
                          origin = request.get_header_value("Origin"),
                          site = request.get_header_value("Sec-Fetch-Site");
        if (!is_own_host(host)) {
            refuse(response, 403, "the studio is not served by this name");
        } else if (!origin.empty() && origin != "http://" + host) {
            refuse(response, 403, "another page may not use the studio");
        } else if (request.method != "GET" && !site.empty() && site != "same-origin") {
            refuse(response, 403, "another page may not use the studio");
        } else if (std::string_view(request.path).substr(0, 1) != "/" ||
                   !is_equal(std::string_view(request.path).substr(1, studio_.token.size()),
                             studio_.token)) {
            refuse(response, 403,
                   "the address has no token, or that of another studio; open the address that "
                   "`algae studio` printed");
        } else {
            return Handled::Unhandled;
        }
        return Handled::Handled;
    }

    /// The address behind the token.
    std::string place(const httplib::Request& request) const {
        return request.path.substr(1 + studio_.token.size());
    }

    void get(const httplib::Request& request, httplib::Response& response) const {
        const std::string at = place(request);
        if (at.empty())
            response.set_redirect("/" + studio_.token + "/");
        else if (at == "/")
            // In pieces: the library would compress a whole text anew for each browser, for ten seconds.
            response.set_content_provider(
                studio_.page.size(), "text/html; charset=utf-8",
                [page = studio_.page](std::size_t from, std::size_t size, httplib::DataSink& sink) {
                    return sink.write(page.data() + from, std::min(size, std::size_t{1} << 16));
                });
        else
            refuse(response, 404, "there is nothing at this address");
    }

    void post(const httplib::Request& request, httplib::Response& response) {
        if (place(request) != "/ask")
            return refuse(response, 404, "there is nothing at this address");
        if (!request.get_header_value("Content-Type").starts_with("application/json"))
            return refuse(response, 415, "expected a question with Content-Type: application/json");
        response.set_chunked_content_provider(
            "application/octet-stream",
            [this, question = request.body](std::size_t, httplib::DataSink& sink) {
                return answer(question, sink);
            });
    }

    /// Sends an answer; whether the page was there to the end.
    bool answer(const std::string& question, httplib::DataSink& sink) {
        const auto is_there = [&] { return !stopped_ && sink.is_writable(); };
        while (!places_.take())
            if (!is_there()) return false;
        struct Back {
            Places& places;
            ~Back() { places.give_back(); }
        } back{places_};
        std::string told;
        const auto goes_on = [&](const std::string& said) {
            if (!is_there()) return false;
            if (said == told) return true;
            told = said;
            const std::string line = "~" + said + "\n";
            return sink.write(line.data(), line.size());
        };
        Answered found;
        try {
            found = workers_.run(question, goes_on);
        } catch (const Error& error) {
            found.said = error.what();
        }
        if (found.end == Answered::End::gone) return false;
        if (found.end == Answered::End::size) found.answer.clear();
        const nlohmann::json head{{"status", found.status},
                                  {"end", name_of(found.end)},
                                  {"said", found.said},
                                  {"seconds", studio_.share.seconds}};
        const std::string line =
            head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
        if (!sink.write(line.data(), line.size())) return false;
        constexpr std::size_t piece = std::size_t{1} << 18;
        for (std::size_t at = 0; at < found.answer.size(); at += piece)
            if (!sink.write(found.answer.data() + at, std::min(piece, found.answer.size() - at)))
                return false;
        sink.done();
        return true;
    }

    const Studio studio_;
    Workers workers_;
    Places places_;
    std::atomic<bool> stopped_ = false;
    std::vector<std::string> names_;
    int port_ = 0;
    httplib::Server server_;
};

}  // namespace

void serve(const Studio& studio) {
    if (studio.token.size() < 16)
        throw Error("a studio needs a token of at least 16 letters or digits");
    const auto serving = std::make_shared<Serving>(studio);
    serving->bind();
    // The thread keeps what its connections use; one that still sends is left to itself.
    std::thread listening([serving] { serving->listen(); });
    if (studio.listening) studio.listening(serving->address());
    while (!studio.is_stopped()) std::this_thread::sleep_for(50ms);
    serving->stop();
    listening.join();
    static auto* const kept = new std::vector<std::shared_ptr<Serving>>;
    kept->push_back(serving);  // for connections that have not ended, to the end of the process
}

std::string random_token() {
    unsigned char bytes[16];
    if (::getrandom(bytes, sizeof bytes, 0) != static_cast<ssize_t>(sizeof bytes))
        throw Error("the system gives no random numbers");
    std::string token;
    for (const unsigned char byte : bytes) {
        token += "0123456789abcdef"[byte / 16];
        token += "0123456789abcdef"[byte % 16];
    }
    return token;
}

}  // namespace algae
