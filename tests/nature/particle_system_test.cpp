#include "nature/detail/particles.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>

#include "exact/exact.hpp"

using namespace algae;

namespace {

ParticleSystem fountain() {
    ParticleSystem system;
    ParticleKind drop;
    drop.name = "drop";
    drop.speed = {3, 1};
    drop.angle = {90, 20};
    drop.life = {12, 4};
    drop.size = {2, 1};
    system.kinds = {drop};
    Emitter spout;
    spout.count = {5, 2};
    spout.to = {1, 0};
    system.emitters = {spout};
    system.force = {0, -0.2};
    return system;
}

ParticleSystem fireworks() {
    ParticleSystem system = fountain();
    system.kinds[0].bursts_into = 1;
    system.kinds[0].fragments = {20, 0};
    system.kinds[0].life = {8, 0};
    ParticleKind spark;
    spark.name = "spark";
    spark.size = {0.5, 0};
    spark.life = {10, 0};
    spark.angle = {0, 180};
    system.kinds.push_back(spark);
    system.emitters[0].count = {1, 0};
    system.emitters[0].every = 5;
    return system;
}

}  // namespace

TEST_CASE("a particle that nothing holds back follows the sums of its steps") {
    CHECK(rc::check([](std::uint32_t seed) {
        ParticleSystem system = fountain();
        system.seed = seed;
        ParticleRun run(system, {});
        std::map<std::uint64_t, Particle> at_birth;
        std::map<std::uint64_t, std::uint64_t> birth;
        for (int frame = 0; frame < 30; ++frame) {
            for (const Particle& particle : run.particles()) {
                if (at_birth.try_emplace(particle.number, particle).second)
                    birth[particle.number] = run.frame();
                const Particle& first = at_birth.at(particle.number);
                const double k = static_cast<double>(run.frame() - birth.at(particle.number));
                RC_ASSERT(particle.age == k);
                RC_ASSERT(particle.age <= particle.life);
                // p(k) = p + k v + a (1 + 2 + ... + k)
                const double x = first.place.x + k * first.velocity.x;
                const double y = first.place.y + k * first.velocity.y - 0.2 * k * (k + 1) / 2;
                RC_ASSERT(std::abs(particle.place.x - x) < 1e-9);
                RC_ASSERT(std::abs(particle.place.y - y) < 1e-9);
            }
            run.advance();
        }
    }));
}

TEST_CASE("no more are alive than the rate times the life, and none is older than its life") {
    ParticleRun run(fountain(), {});
    for (int frame = 0; frame < 100; ++frame) {
        run.advance();
        CHECK(run.particles().size() <= 7 * 17);  // frames 0 to 16 of the longest life
        CHECK(run.born() == run.died() + run.particles().size());
        for (const Particle& particle : run.particles()) {
            CHECK(particle.age <= particle.life);
            CHECK(particle.life >= 8);
            CHECK(particle.life <= 16);
            CHECK(particle.size >= 1);
            CHECK(particle.size <= 3);
        }
    }
    CHECK(run.born() > 101 * 4);
    CHECK(run.born() < 101 * 6);
}

TEST_CASE("a rocket bursts where its life ends, into fragments of half its size") {
    ParticleRun run(fireworks(), {});
    REQUIRE(run.particles().size() == 1);
    const double size = run.particles()[0].size;
    Point last;
    for (int frame = 1; frame <= 8; ++frame) {
        run.advance();
        last = run.particles()[0].place;
        CHECK(run.particles()[0].kind == 0);
    }
    run.advance();  // older than 8 frames
    std::size_t sparks = 0;
    for (const Particle& particle : run.particles()) {
        if (particle.kind != 1) continue;
        ++sparks;
        CHECK(particle.place == last);
        CHECK(particle.size == doctest::Approx(size / 2));
        CHECK(particle.age == 0);
        CHECK(std::hypot(particle.velocity.x, particle.velocity.y) == doctest::Approx(1));
    }
    CHECK(sparks == 20);
}

TEST_CASE("a seed gives the same frames again, another one others") {
    ParticleRun one(fireworks(), {}), same(fireworks(), {});
    ParticleSystem changed = fireworks();
    changed.seed = 2;
    ParticleRun other(changed, {});
    for (int frame = 0; frame < 40; ++frame) {
        one.advance();
        same.advance();
        other.advance();
        CHECK(one.particles() == same.particles());
    }
    CHECK_FALSE(one.particles() == other.particles());
}

TEST_CASE("drag, trails and the ground") {
    ParticleSystem system = fountain();
    system.kinds[0].drag = 0.5;
    system.kinds[0].trail = 3;
    system.kinds[0].weight = 0;
    system.kinds[0].angle = {0, 0};
    system.kinds[0].speed = {8, 0};
    system.kinds[0].life = {20, 0};
    system.emitters[0].last = 0;
    system.emitters[0].to = {0, 0};
    ParticleRun run(system, {});
    for (int frame = 0; frame < 4; ++frame) run.advance();
    CHECK(run.particles()[0].place.x == doctest::Approx(4 + 2 + 1 + 0.5));
    CHECK(run.particles()[0].trail == std::vector<Point>{{7, 0}, {6, 0}, {4, 0}});

    ParticleSystem falling = fountain();
    falling.ground = 0;
    falling.bounce = 0.5;
    ParticleRun bouncing(falling, {});
    for (int frame = 0; frame < 60; ++frame) {
        bouncing.advance();
        for (const Particle& particle : bouncing.particles()) CHECK(particle.place.y >= 0);
    }
}

TEST_CASE("systems that make no sense are refused") {
    ParticleSystem none = fountain();
    none.emitters.clear();
    CHECK_THROWS_WITH_AS(ParticleRun(none, {}),
                         "expected an emitter, found no particle that is born", Error);
    ParticleSystem negative = fountain();
    negative.emitters[0].count = {-3, 0};
    CHECK_THROWS_WITH_AS(ParticleRun(negative, {}),
                         "the number born of drop: expected numbers from 0 on, found -3 +- 0",
                         Error);
    ParticleSystem thick = fountain();
    thick.kinds[0].drag = 2;
    CHECK_THROWS_WITH_AS(ParticleRun(thick, {}), "drag of drop: expected 0 to 1, found 2", Error);
    ParticleSystem endless = fountain();
    endless.kinds[0].bursts_into = 0;
    endless.kinds[0].fragments = {1000, 0};
    endless.kinds[0].life = {1, 0};
    ParticleRun run(endless, {});
    CHECK_THROWS_AS(
        [&] {
            for (int frame = 0; frame < 20; ++frame) run.advance();
        }(),
        BoundReached);
}
