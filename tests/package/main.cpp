#include <cstdlib>
#include <iostream>

#include <algae/model.hpp>
#include <algae/notation.hpp>
#include <algae/render.hpp>
#include <algae/system.hpp>

int main() {
    std::cout << algae::gallery().size() << " figures come with algae\n";
    const algae::Model koch =
        algae::read_lsystem("axiom F\nF -> F+F--F+F\nangle 60\n", "koch.lsys");
    const algae::Integer length = algae::fold(*algae::as_d0l(koch), 100, algae::length_lift());
    algae::draw_picture({algae::figure(koch, 3, {}).get(), "koch", ""}, std::cout,
                        algae::PictureFormat::svg, {}, {});
    const bool right = algae::power(algae::Integer(4), 100) * 7 - 4 == length * 3;
    return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
