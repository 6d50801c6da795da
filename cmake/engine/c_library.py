"""Compiles those files of C libraries that some symbols need, directly or through others, into an archive.

    c_library.py FOLDER ARCHIVE FOLDERS SYMBOLS -- COMPILER FLAGS...

FOLDERS are the libraries' sources, with commas between, SYMBOLS a file with the names that are wanted, a line each; the path of a
source is a name of it. FLINT and Arb have five thousand files, and the engine needs a sixth. The file of a function is found by reading: it
has the name at the beginning of a line, with parameters and a brace. What no file defines is left to the linker. Objects lie in
FOLDER and are kept.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

split = sys.argv.index("--")
folder, archive, libraries, symbols = sys.argv[1:split]
compiler = sys.argv[split + 1 :]

comment = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)
function = re.compile(r"^(?:[A-Za-z_][\w \t\*]*[\s\*])?(\w+)\s*\((?:[^;{}()]|\([^()]*\))*\)\s*\{", re.M)
variable = re.compile(r"^(?!typedef|return|#|static|extern)[A-Za-z_][\w \t\*]*[ \t\*](\w+)\s*(?:\[[^\]\n]*\]\s*)*(?:=|;)", re.M)
inline = re.compile(r"^\w+_INLINE\b[^;{}]*?[\s\*](\w+)\s*\(", re.M)

left_out = ("cxx", "demos", "examples", "mini-gmp", "profile", "test", "tests", "tune")

sources, by_file = {}, {}  # the files that define a name, as it is written in them and as they are called
for library in libraries.split(","):
    root = pathlib.Path(library)
    for path in sorted([*root.glob("*.[ch]"), *root.glob("*/*.[ch]")]):
        parts = path.relative_to(root).parts
        if parts[0] in left_out or re.match("gen-|tal-(?!re)|bootstrap|gettimeofday", path.name):
            continue
        text = comment.sub(" ", path.read_text(errors="replace"))
        if path.suffix == ".h":
            inlines = path.with_suffix("") / "inlines.c"
            if inlines.exists():
                for name in inline.findall(text):
                    sources.setdefault(name, []).append(inlines)
            continue
        names = {*function.findall(text), *variable.findall(text)}
        for name in names:
            sources.setdefault(name, []).append(path)
        # Some names are put together by macros; files then have the name of what they define, with more or less of the folder's before it.
        stem, room = path.stem, parts[0] if len(parts) == 2 else ""
        aliases = {"/".join(parts), f"{room}_{stem}", f"{room.rsplit('_', 1)[0]}_{stem}"}
        aliases |= {f"__g{room}_{stem}", f"__g{room}_{stem}_p", f"mpfr_{stem}", f"mpfr_{stem}_p"}
        aliases |= {"__g" + name for name in names if re.match("mp[nzqf]?_", name)} | {"__" + name for name in names if name.startswith("gmp_")}
        for name in aliases:
            by_file.setdefault(name, []).append(path)

os.makedirs(folder, exist_ok=True)


def compiled(path):
    """The object of a file, and the names that it lacks."""
    target = os.path.join(folder, "-".join(path.parts[-3:]) + ".o")
    if not os.path.exists(target):
        subprocess.run([*compiler, f"-DOPERATION_{path.stem}", "-c", str(path), "-o", target + ".new"], check=True)
        os.replace(target + ".new", target)
    names = subprocess.run(["llvm-nm-14", "-u", target], check=True, capture_output=True, text=True).stdout.split()
    return target, {name for name in names if name != "U"}


wanted = set(open(symbols).read().split())
done, objects = {}, []
with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", "2"))) as pool:
    while wanted:
        files = {path for name in wanted for path in sources.get(name) or by_file.get(name, [])} - set(done)
        seen = set(done.get("names", ()))
        done["names"] = seen | wanted
        wanted = set()
        for path, (target, lacks) in zip(sorted(files), pool.map(compiled, sorted(files))):
            done[path] = True
            objects.append(target)
            wanted |= lacks
        wanted -= done["names"]
if os.path.exists(archive):
    os.remove(archive)
with open(archive + ".list", "w") as out:
    out.write("\n".join(objects))
subprocess.run(["llvm-ar-14", "rcs", archive, "@" + archive + ".list"], check=True)
print(f"{archive}: {len(objects)} files")
