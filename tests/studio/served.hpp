#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "places.hpp"

namespace served {

/// A connection of a test to a port of this machine: bytes as they are, without a library that would mend them.
class Connection {
public:
    explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address = {};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
            throw std::runtime_error("nobody listens");
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() { close(); }
    void close() {
        if (socket_ >= 0) ::close(socket_);
        socket_ = -1;
    }
    void send(const std::string& text) const {
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t count =
                ::send(socket_, text.data() + done, text.size() - done, MSG_NOSIGNAL);
            if (count <= 0) return;  // the server has heard enough
            done += static_cast<std::size_t>(count);
        }
    }
    /// Everything until the server closes the connection.
    std::string receive(int milliseconds = 60'000) const {
        std::string text;
        char piece[1 << 16];
        for (;;) {
            pollfd waits{socket_, POLLIN, 0};
            if (::poll(&waits, 1, milliseconds) <= 0) return text;
            const ssize_t count = ::recv(socket_, piece, sizeof piece, 0);
            if (count <= 0) return text;
            text.append(piece, static_cast<std::size_t>(count));
        }
    }

private:
    int socket_;
};

struct Response {
    int status = 0;
    std::string head, body;
};

/// What a server said, with the pieces of a body in chunks joined.
inline Response response_of(const std::string& text) {
    Response found;
    const std::size_t end = text.find("\r\n\r\n");
    if (end == std::string::npos || !text.starts_with("HTTP/1.")) return found;
    found.status = std::stoi(text.substr(9, 3));
    found.head = text.substr(0, end + 2);
    const std::string rest = text.substr(end + 4);
    if (found.head.find("Transfer-Encoding: chunked") == std::string::npos) {
        found.body = rest;
        return found;
    }
    for (std::size_t at = 0; at < rest.size();) {
        const std::size_t line = rest.find("\r\n", at);
        if (line == std::string::npos) break;
        const std::size_t size = std::stoul(rest.substr(at, line - at), nullptr, 16);
        if (size == 0) break;
        found.body += rest.substr(line + 2, size);
        at = line + 2 + size + 2;
    }
    return found;
}

/// An answer of the studio.
struct Answer {
    nlohmann::json head;
    std::string text;
    nlohmann::json json() const { return nlohmann::json::parse(text, nullptr, false); }
};

inline Answer answer_of(const std::string& body) {
    std::size_t at = 0;
    while (at < body.size() && body[at] == '~') at = body.find('\n', at) + 1;
    const std::size_t end = body.find('\n', at);
    if (end == std::string::npos) return {};
    return {nlohmann::json::parse(body.substr(at, end - at), nullptr, false), body.substr(end + 1)};
}

/// A studio that runs as a program of its own.
class Studio {
public:
    explicit Studio(const std::vector<std::string>& arguments = {}) {
        int output[2];
        if (::pipe(output) != 0) throw std::runtime_error("no pipe");
        process_ = ::fork();
        if (process_ == 0) {
            ::setpgid(0, 0);
            ::dup2(output[1], STDOUT_FILENO);
            ::close(output[0]);
            ::close(output[1]);
            std::vector<std::string> words{built_command(), "studio"};
            words.insert(words.end(), arguments.begin(), arguments.end());
            std::vector<char*> pointers;
            for (std::string& word : words) pointers.push_back(word.data());
            pointers.push_back(nullptr);
            ::execv(words[0].c_str(), pointers.data());
            std::_Exit(127);
        }
        ::close(output[1]);
        char c = 0;
        while (::read(output[0], &c, 1) == 1 && c != '\n') address += c;
        ::close(output[0]);
        const std::size_t colon = address.rfind(':');
        if (colon == std::string::npos || colon < 6) return;
        const std::size_t slash = address.find('/', colon);
        port = std::stoi(address.substr(colon + 1, slash - colon - 1));
        token = address.substr(slash + 1, address.size() - slash - 2);
        host = "127.0.0.1:" + std::to_string(port);
    }
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;
    ~Studio() {
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
            ::waitpid(process_, nullptr, 0);
        }
    }

    /// Sends a signal, and gives the exit status; 128 + signal if it was killed.
    int end(int signal) {
        ::kill(process_, signal);
        int status = 0;
        ::waitpid(process_, &status, 0);
        process_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    bool is_running() const { return ::waitpid(process_, nullptr, WNOHANG) == 0; }
    pid_t process() const { return process_; }

    Response raw(const std::string& request) const {
        const Connection connection(port);
        connection.send(request);
        return response_of(connection.receive());
    }
    Response get(const std::string& path, const std::string& headers = "") const {
        return raw("GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n" + headers + "\r\n");
    }
    std::string request(const std::string& body, const std::string& headers = "") const {
        return "POST /" + token + "/ask HTTP/1.1\r\nHost: " + host +
               "\r\nContent-Type: application/json\r\nContent-Length: " +
               std::to_string(body.size()) + "\r\n" + headers + "\r\n" + body;
    }
    Response post(const std::string& body, const std::string& headers = "") const {
        return raw(request(body, headers));
    }
    Answer ask(const nlohmann::json& question) const {
        return answer_of(post(question.dump()).body);
    }

    std::string address, token, host;
    int port = 0;

private:
    pid_t process_ = 0;
};

}  // namespace served
