#include "growth/residues.hpp"

#include <algorithm>

namespace algae {

namespace {

__extension__ typedef unsigned __int128 Wide;

/// Miller and Rabin's test with bases that settle it for all numbers of 64 bits.
bool is_prime(Residue n) {
    if (n < 2) return false;
    for (const Residue p : {2u, 3u, 5u, 7u, 11u, 13u, 17u, 19u, 23u, 29u, 31u, 37u})
        if (n % p == 0) return n == p;
    const PrimeField field(n);
    Residue odd = n - 1;
    int twos = 0;
    for (; odd % 2 == 0; odd /= 2) ++twos;
    for (const Residue base : {2u, 3u, 5u, 7u, 11u, 13u, 17u, 19u, 23u, 29u, 31u, 37u}) {
        Residue x = field.power(base, odd);
        if (x == 1 || x == n - 1) continue;
        bool composite = true;
        for (int i = 1; i < twos && composite; ++i) {
            x = field.multiply(x, x);
            composite = x != n - 1;
        }
        if (composite) return false;
    }
    return true;
}

}  // namespace

Residue PrimeField::residue(const Integer& value) const {
    return remainder(value, Integer(prime_)).to_uint64();
}

Residue PrimeField::multiply(Residue left, Residue right) const {
    return static_cast<Residue>(static_cast<Wide>(left) * right % prime_);
}

Residue PrimeField::power(Residue base, std::uint64_t exponent) const {
    Residue result = 1 % prime_;
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = multiply(result, base);
        base = multiply(base, base);
    }
    return result;
}

Residue prime_below(Residue bound) {
    do --bound;
    while (!is_prime(bound));
    return bound;
}

std::vector<Residue> shortest_recurrence_modulo(const std::vector<Residue>& terms, const PrimeField& field) {
    std::vector<Residue> now{1}, before{1};  // connection polynomials: now[0] a(n) + now[1] a(n-1) + ... == 0
    std::size_t order = 0, shift = 1;
    Residue last = 1;
    for (std::size_t n = 0; n < terms.size(); ++n, ++shift) {
        Residue wrong = 0;
        for (std::size_t i = 0; i < now.size() && i <= n; ++i)
            wrong = field.add(wrong, field.multiply(now[i], terms[n - i]));
        if (wrong == 0) continue;
        const Residue factor = field.multiply(wrong, field.inverse(last));
        std::vector<Residue> next = now;
        next.resize(std::max(now.size(), before.size() + shift), 0);
        for (std::size_t i = 0; i < before.size(); ++i)
            next[i + shift] = field.subtract(next[i + shift], field.multiply(factor, before[i]));
        if (2 * order <= n) {
            order = n + 1 - order;
            before = std::move(now);
            last = wrong;
            shift = 0;
        }
        now = std::move(next);
    }
    now.resize(order + 1, 0);
    std::reverse(now.begin(), now.end());
    return now;
}

}  // namespace algae
