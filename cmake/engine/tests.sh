# Read by tools/engine --tests [ROOM...]: builds the tests of the rooms in tests.txt as WebAssembly and runs them with node.

table=$root/cmake/engine/tests.txt
# of_kind KIND [ROOM]: the lines of the table of this kind, or of these with a bar between, without the kind.
of_kind() { sed -nE "s/^($1) [|] //p" "$table" | grep "^${2:+$2 |}" || true; }
mapfile -t rooms < <(if [ $# -gt 0 ]; then printf '%s\n' "$@"; else of_kind room; fi)
for room in "${rooms[@]}"; do
    of_kind room | grep -qx "$room" || { echo "cmake/engine/tests.txt has no room $room" >&2; exit 2; }
done

# What those tests can reach, in an archive, of which the linker takes what a test needs: the rooms of the engines, but for those that speak
# with somebody, and the whole of each tested room. The embedded texts are those of the engines, and the other generators.
mapfile -t product < <(
    {
        cat "$root"/cmake/engine/{sources,theory}.txt
        for room in "${rooms[@]}"; do [ ! -d "$root/src/$room" ] || (cd "$root/src" && find "$room" -name '*.cpp' | sed 's/\.cpp$//'); done
    } | grep -vE '^(command|studio|report|render|lesson|exchange)/' | sort -u
)
oracle=() texts=(gallery theory_claims lesson_texts exercise_texts generator_gallery)
mapfile -t generators < <(sed -n 's/^set(algae_generator_patterns \(.*\))$/\1/p' "$root/cmake/gallery.cmake" | tr ' ' '\n' |
    while read -r pattern; do find "$root/figures" -name "$pattern"; done | LC_ALL=C sort)
embed generator_gallery "${generators[@]}"
for file in "$root"/tests/oracle/*.cpp; do oracle+=("oracle/$(basename "$file" .cpp)"); done
mapfile -t support < <(cd rapidcheck/src && find . -name '*.cpp' | sed 's|^\./||; s|\.cpp$||' | LC_ALL=C sort)
is_out() { of_kind file "${1%%/*}" | grep -qF "| ${1#*/}.cpp |"; }
tests_of() {
    local file name
    for file in "$root/tests/$1"/*_test.cpp; do
        name=$1/$(basename "$file" .cpp)
        is_out "$name" || echo "$name"
    done
}

say "Compiling the tests"
mkdir -p tests
test_compile=${compile/-Os/-O1}
test_compile="${test_compile/-I ..\/..\/src/-I ..\/..\/src -I ..\/..\/tests} -DDOCTEST_CONFIG_NO_POSIX_SIGNALS"
cat >tests/headers.hpp.new <<EOF
#include <doctest/doctest.h>
#include <rapidcheck.h>
#include <exact/exact.hpp>
#include <nlohmann/json.hpp>
EOF
cmp -s tests/headers.hpp.new tests/headers.hpp || mv tests/headers.hpp.new tests/headers.hpp
places="-DALGAE_SOURCE_DIR='\"$root\"' -DALGAE_COMMAND='\"\"'"
{
    cat build.ninja
    printf 'rule headers\n  description = $out\n  command = %s -x c++-header -MMD -MF $out.d -c $in -o $out\n  depfile = $out.d\n  deps = gcc\n' "$test_compile"
    printf 'rule test\n  description = $out\n  command = %s $more -MMD -MF $out.d -c $in -o $out\n  depfile = $out.d\n  deps = gcc\n' "$test_compile"
    printf 'rule c\n  description = $out\n  command = clang-14 %s -O2 -w -DINLINE=inline -DPROJECT_VERSION_FULL='"'\"\"'"' -DHAVE_STDINT_H -DHAVE_STDLIB_H -DHAVE_STRING_H -I headers -I libdivsufsort/include -c $in -o $out\n' "${cflags[*]}"
    printf 'rule rapidcheck\n  description = $out\n  command = %s -w -I rapidcheck/src -MMD -MF $out.d -c $in -o $out\n  depfile = $out.d\n  deps = gcc\n' "$test_compile"
    printf 'rule archive\n  description = $out\n  rspfile = $out.list\n  rspfile_content = $in_newline\n  command = rm -f $out && llvm-ar-14 rcs $out @$out.list\n'
    echo "build tests/headers.pch: headers tests/headers.hpp"
    for name in "${product[@]}"; do
        grep -qx "$name" "$root"/cmake/engine/{sources,theory}.txt -h || echo "build objects/algae/$name.o: cxx ../../src/$name.cpp"
    done
    echo "build objects/generator_gallery.o: cxx generator_gallery.cpp"
    for name in "${support[@]}"; do echo "build objects/rapidcheck/$name.o: rapidcheck rapidcheck/src/$name.cpp"; done
    for name in divsufsort sssort trsort; do echo "build objects/divsufsort/$name.o: c libdivsufsort/lib/$name.c"; done
    printf 'build objects/tests/main.o: test ../../tests/main.cpp\nbuild objects/tests/places.o: test ../../tests/places.cpp\n  more = %s\n' "$places"
    for name in "${oracle[@]}" $(for room in "${rooms[@]}"; do tests_of "$room"; done); do
        printf 'build objects/tests/%s.o: test ../../tests/%s.cpp | tests/headers.pch\n  more = -include-pch tests/headers.pch\n' "$name" "$name"
    done
    printf 'build tests/libalgae.a: archive'
    printf ' objects/%s.o' "${product[@]/#/algae/}" "${texts[@]}"
    printf '\nbuild tests/libsupport.a: archive'
    printf ' objects/%s.o' "${oracle[@]/#/tests/}" "${support[@]/#/rapidcheck/}" divsufsort/{divsufsort,sssort,trsort}
    printf '\nbuild programs: phony tests/libalgae.a tests/libsupport.a'
    printf ' objects/tests/%s.o' main places $(for room in "${rooms[@]}"; do tests_of "$room"; done)
    printf '\n'
} >tests.ninja
ninja -f tests.ninja -j "${JOBS:-$(nproc)}" -k 0 programs
libraries tests/libalgae.a

# A stack as deep as that of the command; node keeps the calls of WebAssembly on its own.
link_test() {
    em++ -O1 -fwasm-exceptions $(for name in main places $(tests_of "$1"); do echo "objects/tests/$name.o"; done) \
        tests/libsupport.a tests/libalgae.a libflint.a libmpfr.a libgmp.a -o "tests/$1.js" --pre-js "$root/cmake/engine/tests.js" \
        -sNODERAWFS=1 -sEXIT_RUNTIME=1 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2GB -sTOTAL_STACK=8MB -sENVIRONMENT=node
}
run_test() {
    local out number seed=${RC_PARAMS:-seed=20261126}
    # Names are patterns with commas between, so a comma in one stands for any letter.
    out=$(of_kind case "$1" | sed 's/^[^|]* | \(.*\) | [^|]*$/\1/; s/,/?/g' | paste -sd,)
    number=$(of_kind fewer "$1" | cut -d' ' -f3)
    RC_PARAMS="$seed${number:+ max_success=$number}" node --stack-size=7600 "tests/$1.js" --no-colors ${out:+"--test-case-exclude=$out"} >"tests/$1.log" 2>&1
}
say "Running the tests with node $(node --version)"
failed=0
for room in "${rooms[@]}"; do
    verdict=FAILED counts=()
    rm -f "tests/$room.log"
    if link_test "$room"; then
        if run_test "$room"; then verdict=passed; fi
        mapfile -t counts < <(sed -n 's/^\[doctest\] \(test cases\|assertions\): *\([0-9]*\) | *\([0-9]*\) passed.*/\3 of \2 \1/p' "tests/$room.log")
        [ ${#counts[@]} = 2 ] || verdict=FAILED
    fi
    echo "$verdict   $room: ${counts[0]:-no test cases}, ${counts[1]:-no assertions}"
    [ "$verdict" = passed ] && continue
    failed=$((failed + 1))
    [ ! -f "tests/$room.log" ] || grep -v '^OK, passed\|^$\|^- ' "tests/$room.log" | tail -n 60
done
say "Left out"
for room in "${rooms[@]}"; do of_kind 'file|case|fewer' "$room"; done | tee tests/left_out.txt
printf '%d left out or less\n\n%d passed, %d failed\n' "$(wc -l <tests/left_out.txt)" $((${#rooms[@]} - failed)) "$failed"
[ "$failed" = 0 ]
