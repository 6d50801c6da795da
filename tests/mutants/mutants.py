"""Mutants of a room, and which of them its tests notice: see tools/mutants."""

import argparse
import collections
import concurrent.futures
import json
import os
import random
import re
import resource
import shlex
import signal
import subprocess
import sys
import time
import zlib
from pathlib import Path

from schemata import Source

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
MEMORY = 4 << 30  # of a run; what takes more is killed
ENVIRONMENT = {**os.environ, 'RC_PARAMS': 'seed=1'}


def say(text):
    print(text, flush=True)


class Room:
    """A room whose sources hold mutants, in build/mutants/ROOM."""

    def __init__(self, name, build, jobs):
        self.name, self.build, self.jobs = name, build, jobs
        self.folder = ROOT / 'build/mutants' / name
        self.flags = {entry['file']: entry for entry in json.loads((build / 'compile_commands.json').read_text())
                      if 'algae_library.dir' in entry['command']}  # not those with sanitizers
        files = sorted((ROOT / 'src' / name).rglob('*.[ch]pp'))
        self.sources = [Source(str(path.relative_to(ROOT)), path.read_text()) for path in files]
        self.mutants = [mutant for source in self.sources for mutant in source.mutants]
        for number, mutant in enumerate(self.mutants):
            mutant.number = number
        self.wanted = {mutant.number for mutant in self.mutants}
        for source in self.sources:
            give_keys(source)
        (self.folder / 'mutants.hpp').parent.mkdir(parents=True, exist_ok=True)
        put(self.folder / 'mutants.hpp', '#pragma once\nnamespace mutants { bool is_on(unsigned number); }\n')

    def choose(self, only, sample, seed):
        for name in only or []:
            if not any(mutant.file.endswith('/' + name.lstrip('/')) for mutant in self.mutants):
                sys.exit(f'--only {name}: no file of {self.name} that has mutants is called so')
        chosen = [mutant.number for mutant in self.mutants
                  if not only or any(mutant.file.endswith('/' + name.lstrip('/')) for name in only)]
        if sample is not None and sample < len(chosen):
            chosen = random.Random(seed).sample(chosen, sample)
        self.wanted = set(chosen)

    def write(self):
        """Writes the sources with the mutants that are wanted, and returns the blame of each file's lines."""
        blame = {}
        for source in self.sources:
            text, blame[source.file] = source.rewritten([m for m in source.mutants if m.number in self.wanted])
            put(self.folder / source.file, text)
        return blame

    def command(self, source, rest, other=()):
        """How the compiler is called for a file of the room, without the options `other`."""
        entry = self.flags[str(ROOT / source.file)]
        words, kept = shlex.split(entry['command']), []
        while words:
            word = words.pop(0)
            if word in ('-o', '-c'):
                words.pop(0)
            elif not word.startswith(('-W', *other)):
                kept.append(word)
        kept[1:1] = ['-I', str(self.folder / 'src')]
        return kept + ['-include', str(self.folder / 'mutants.hpp'), '-w', str(self.folder / source.file)] + rest, \
            entry['directory']

    def units(self):
        """The files that have to be compiled: all, where a header has mutants."""
        changed = {mutant.file for mutant in self.mutants if mutant.number in self.wanted}
        return [source for source in self.sources if source.file.endswith('.cpp') and (
            source.file in changed or any(file.endswith('.hpp') for file in changed))]

    def drop_what_fails(self):
        """Takes mutants away until all files compile. Returns how many were taken away."""
        before, cache = len(self.wanted), self.folder / 'compiled.json'
        known = json.loads(cache.read_text()) if cache.exists() else {'dropped': [], 'sound': []}
        dropped, sound = set(map(tuple, known['dropped'])), set(known['sound'])
        keys = {mutant.number: self.key(mutant) for mutant in self.mutants}
        self.wanted = {number for number in self.wanted if keys[number] not in dropped}
        asked, left = set(self.wanted), self.units()
        self.write()
        left = [source for source in left if self.state(source) not in sound]
        while left:
            blame = self.write()

            def errors(source):
                words, folder = self.command(source, ['-fsyntax-only', '-fmax-errors=0'])
                return subprocess.run(words, cwd=folder, capture_output=True, text=True)

            with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
                runs = list(pool.map(errors, left))
            failed, wrong = [], set()
            for source, run in zip(left, runs):
                if run.returncode != 0:
                    failed.append(source)
                    wrong |= self.wrong(source, run.stderr, blame)
            self.wanted -= wrong
            say(f'  {len(left) - len(failed)} of {len(left)} files compile; {len(self.wanted)} mutants')
            left = failed
        self.write()
        dropped |= {keys[number] for number in asked - self.wanted}
        sound |= {self.state(source) for source in self.units()}
        cache.write_text(json.dumps({'dropped': sorted(dropped), 'sound': sorted(sound)}))
        return before - len(self.wanted)

    def state(self, source):
        """The text that is compiled, with the headers of the room."""
        files = [source.file] + [each.file for each in self.sources if each.file.endswith('.hpp')]
        return f'{source.file} ' + ' '.join(str(zlib.crc32((self.folder / file).read_bytes())) for file in files)

    def key(self, mutant):
        """What a mutant is known by from one run to the next, as long as its file is the same."""
        text = next(source.text for source in self.sources if source.file == mutant.file)
        return f'{mutant.file} {zlib.crc32(text.encode())}', mutant.start, mutant.end, mutant.changed

    def wrong(self, source, messages, blame):
        """The mutants on the lines of these messages; those in constants where no line is to blame."""
        prefix = re.escape(str(self.folder)) + '/'
        wrong, around = set(), set()
        for line in messages.splitlines():
            found = re.match(prefix + r'([^:]*):(\d+):(?:\d+:)? *(error|  required from)', line)
            if not found or found[1] not in blame:
                continue
            lines = blame[found[1]]
            blamed = lines[min(int(found[2]), len(lines)) - 1]
            (wrong if len(blamed) == 1 else around).update(blamed)
        shown = set(map(int, re.findall(r'::mutants::is_on\((\d+)\)', messages)))  # an operand that goes on in the next line
        wrong = wrong & self.wanted or around & self.wanted or shown & self.wanted or \
            {mutant.number for mutant in source.in_constants()} & self.wanted
        if not wrong:
            sys.exit(f'{source.file} does not compile, and no mutant is to blame:\n{messages[:4000]}')
        return wrong

    def compile(self):
        """The objects of the room."""
        self.write()
        objects = []

        def one(source):
            target = self.folder / (source.file + '.o')
            words, folder = self.command(source, ['-O1', '-D_GLIBCXX_ASSERTIONS', '-c', '-o', str(target)], ('-O',))
            newest = max((self.folder / each.file).stat().st_mtime for each in self.sources
                         if each is source or each.file.endswith('.hpp'))
            if not target.exists() or target.stat().st_mtime < newest:
                subprocess.run(words, cwd=folder, check=True)
            return str(target)

        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            objects = list(pool.map(one, self.units()))
        return objects

    def link(self, objects, main='run.cpp', options=()):
        """The tests of the room with these objects, whose symbols replace those of the library, and with this main program."""
        test = f'tests/test_{self.name}'
        main_of_tests = 'tests/CMakeFiles/test_main.dir/main.cpp.o'
        command = subprocess.run(['ninja', '-C', str(self.build), '-t', 'commands', test], capture_output=True, text=True,
                                 check=True).stdout.splitlines()[-1]
        words = [word for word in shlex.split(command) if word not in (':', '&&')]
        source = HERE / main
        run, program = self.folder / (source.stem + '.o'), str(self.folder / f'{source.stem}_{self.name}')
        if not run.exists() or run.stat().st_mtime < source.stat().st_mtime:
            subprocess.run([words[0], '-std=c++20', '-O1', '-w', *(f'-I{ROOT / folder}' for folder in ('src', 'tests')),
                            '-c', str(source), '-o', str(run)], check=True)
        at = words.index(main_of_tests)
        words[at:at + 1] = [str(run)] + objects + list(options)
        words[words.index('-o') + 1] = program
        inputs = [self.build / word for word in words if word.endswith(('.o', '.a')) and (self.build / word).exists()]
        if not os.path.exists(program) or os.path.getmtime(program) < max(file.stat().st_mtime for file in inputs):
            subprocess.run(words, cwd=self.build, check=True)
        return program


def put(path, text):
    """Writes a file if it is to change."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


class Tests:
    """The test program: its test cases, how long they take, and which mutants they reach."""

    def __init__(self, program, folder):
        self.program = program
        listed = folder / 'coverage'
        run = subprocess.run([program, 'cover', str(listed)], capture_output=True, text=True, env=ENVIRONMENT)
        if run.returncode != 0:
            sys.exit('The tests fail without a mutant:\n' + run.stdout[-4000:])
        self.names, self.seconds, self.reached, self.at_start = [], [], [], set()
        self.noticed = {}  # of each file: lines of mutants, and the tests that noticed them
        for line in listed.read_text().splitlines():
            seconds, name, numbers = line.split('\t')
            if not name:
                self.at_start = set(map(int, numbers.split()))
                continue
            self.names.append(name)
            self.seconds.append(float(seconds))
            self.reached.append(set(map(int, numbers.split())))

    def that_reach(self, mutant, longest):
        """The tests that evaluate a mutant: those that noticed its neighbours first, then the quick ones."""
        found = [i for i in range(len(self.names)) if mutant.number in self.reached[i]]
        if mutant.number in self.at_start:
            found = range(len(self.names))
        elif mutant.is_kept and found:
            found = range(found[0], len(self.names))
        found = [i for i in found if self.seconds[i] <= longest]
        found.sort(key=lambda i: self.seconds[i])
        near = sorted(list(self.noticed.get(mutant.file, {}).items()), key=lambda each: abs(each[0] - mutant.line))[:3]
        first = list(dict.fromkeys(test for _, test in near if test in found and self.seconds[test] < 1))
        return first + [i for i in found if i not in first]

    def judge(self, mutant, longest):
        """What becomes of a mutant: killed, timed out, survived or not reached."""
        tests = self.that_reach(mutant, longest)
        if not tests:
            return 'not reached'

        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

        limits = [5 * self.seconds[i] + 0.5 for i in tests]
        try:
            run = subprocess.run([self.program, 'kill'] + [f'{i}:{limit}' for i, limit in zip(tests, limits)],
                                 env={**ENVIRONMENT, 'ALGAE_MUTANT': str(mutant.number)}, preexec_fn=limited,
                                 stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=4 * sum(limits))
        except subprocess.TimeoutExpired:
            return 'timed out'
        if run.returncode == 0:
            return 'survived'
        by = re.search(rb'\nnoticed by (\d+)\n$', run.stdout[-100:])
        if by:
            self.noticed.setdefault(mutant.file, {})[mutant.line] = int(by[1])
        return 'timed out' if -run.returncode in (signal.SIGPROF, signal.SIGKILL) else 'killed'


def give_keys(source):
    """Tells the mutants of a file what equivalent.txt knows them by: file, line, column in the line, and what is changed into what. Where
    the same line stands in the file again the column is 5#2, 5#3, ..."""
    lines, times = source.text.splitlines(), collections.Counter()
    for mutant in source.mutants:
        line, change = lines[mutant.line - 1].strip(), (mutant.original, mutant.changed)
        times[line, mutant.column, change] += 1
        nth = times[line, mutant.column, change]
        mutant.key = mutant.file, line, str(mutant.column) + (f'#{nth}' if nth > 1 else ''), *change


def known_equivalents(room):
    """The mutants of a room that no test can notice, each with the reason."""
    known = {}
    for line in (HERE / 'equivalent.txt').read_text().splitlines():
        if line.startswith('#') or not line.strip():
            continue
        parts = [part.strip() for part in line.split(' ## ')]
        if len(parts) != 6 or not re.fullmatch(r'\d+(#\d+)?', parts[2]) and parts[2:5] != ['*'] * 3:
            sys.exit('equivalent.txt: expected FILE ## LINE ## COLUMN ## ORIGINAL ## CHANGED ## REASON, found ' + line)
        if tuple(parts[:5]) in known:
            sys.exit('equivalent.txt: two lines for one mutant: ' + line)
        known[tuple(parts[:5])] = parts[5]
    return {key: reason for key, reason in known.items() if key[0].startswith(f'src/{room}/')}


def reason_for(key, known):
    """Why a mutant is equivalent: by its own line of equivalent.txt, or by one for all mutants of its line. None if it is not known to be."""
    return known.get(key, known.get((*key[:2], '*', '*', '*')))


def main():
    parser = argparse.ArgumentParser(prog='tools/mutants', description=__doc__)
    parser.add_argument('room')
    parser.add_argument('--sample', type=int, help='so many mutants, chosen at random')
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--only', nargs='+', action='extend', metavar='FILE', help='the mutants of these files only')
    parser.add_argument('--list', action='store_true', help='only print the mutants, as equivalent.txt writes them')
    parser.add_argument('--longest', type=float, default=float('inf'),
                        help='leave out test cases that take more seconds; of less than 10, also those of the suite "long"')
    parser.add_argument('--again', action='store_true',
                        help='only judge what the last run did not find to be noticed: for tests that were added')
    parser.add_argument('--hunt', type=int, metavar='SECONDS',
                        help='look for changed certificates that notice what no run has found to be noticed, and add them to the tests')
    parser.add_argument('--try', type=Path, metavar='FILE', dest='try_file',
                        help='write what is found with the changes of a file of cases, and print the survivors that are noticed')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--build', type=Path, default=ROOT / 'build/release')
    asked = parser.parse_args()
    if not (ROOT / 'src' / asked.room).is_dir():
        parser.error(f'there is no room {asked.room}')

    room = Room(asked.room, asked.build, asked.jobs)
    room.choose(asked.only, asked.sample, asked.seed)
    found = {mutant.key for mutant in room.mutants}
    found |= {(*key[:2], '*', '*', '*') for key in found}
    for key in known_equivalents(asked.room):
        if key not in found:
            sys.exit('equivalent.txt names a mutant that is not there: ' + ' ## '.join(key))
    if asked.list:
        for mutant in room.mutants:
            if mutant.number in room.wanted:
                say(' ## '.join(mutant.key))
        return
    say(f'{len(room.wanted)} mutants of {asked.room}')
    dropped = room.drop_what_fails()
    if asked.hunt or asked.try_file:
        return hunt(room, asked.hunt, asked.try_file)
    if asked.longest < 10:
        ENVIRONMENT['ALGAE_QUICK'] = '1'
    tests = Tests(room.link(room.compile()), room.folder)
    say(f'  {len(tests.names)} test cases take {sum(tests.seconds):.1f} s')

    wanted = [mutant for mutant in room.mutants if mutant.number in room.wanted]
    kept = Kept(room, tests, asked.longest, noticed_before(room) if asked.again else {})
    found = {mutant.number: kept.outcomes[mutant.number] for mutant in wanted if mutant.number in kept.outcomes}
    if found:
        say(f'  {len(found)} are known from the run before, which ended early')
    left, begin = [mutant for mutant in wanted if mutant.number not in found], time.monotonic()
    if asked.again:  # those that are explained are believed: a whole run tries them, too
        known = known_equivalents(asked.room)
        found.update({mutant.number: 'survived' for mutant in left
                      if reason_for(mutant.key, known) is not None})
        left = [mutant for mutant in left if mutant.number not in found]
    if room.name == 'verify':
        noticed = noticed_by_cases(room, left, asked.jobs)
        for mutant in left:
            if mutant.number in noticed:
                found[mutant.number] = 'killed'
                kept.add(mutant, 'killed')
        say(f'  {len(noticed)} are noticed by the changed certificates of the tests, in one process')
        left = [mutant for mutant in left if mutant.number not in found]
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        for mutant, outcome in zip(left, pool.map(lambda each: tests.judge(each, asked.longest), left)):
            found[mutant.number] = outcome
            kept.add(mutant, outcome)
            if len(found) % 500 == 0:
                say(f'  {len(found)} of {len(wanted)} after {time.monotonic() - begin:.0f} s')
    kept.file.rename(room.folder / 'found')  # all are there: the next run is a new one
    sys.exit(report(room, wanted, found, dropped))


def hunter(room):
    """The program that changes certificates."""
    wrap = ('_ZN5algae6verify17check_certificateERKNSt7__cxx1112basic_string'
            'IcSt11char_traitsIcESaIcEEES8_RKNS_6BudgetE')
    return room.link(room.compile(), 'hunt.cpp', [f'-Wl,--wrap={wrap}'])


def written(out):
    """What the program wrote, a line each; lines that a crash of a mutant left unfinished are none."""
    for line in out.read_text(errors='replace').split('\n'):
        try:
            yield json.loads(line)
        except ValueError:
            pass


def noticed_by_cases(room, mutants, jobs):
    """The mutants that the changed certificates of the tests notice: thousands of checks in one process are far quicker than a process
    for each mutant."""
    program, numbers = hunter(room), room.folder / 'left'
    files = sorted((ROOT / 'tests/verify/certificates').rglob('*.json'))
    files, noticed = [file for file in files if file.name != 'attacks.json'], set()  # whole certificates, without changes
    numbers.write_text('\n'.join(str(mutant.number) for mutant in mutants))

    def one(file):
        out = room.folder / ('tried-' + file.stem)
        subprocess.run([program, 'try', str(file), str(numbers), str(out)], check=True, env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        return {each['mutant'] for each in written(out) if 'mutant' in each}

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for each in pool.map(one, files):
            noticed |= each
    return noticed


def hunt(room, seconds, try_file):
    """Looks for changed certificates that notice survivors, and writes them to the tests. With `try_file` only those of the file."""
    if room.name != 'verify':
        sys.exit('--hunt: only certificates are changed, which are checked by verify')
    known, alive = known_equivalents(room.name), []
    dead, by_number = noticed_before(room).keys(), {mutant.number: mutant for mutant in room.mutants}
    for mutant in room.mutants:
        if mutant.number in room.wanted - dead and reason_for(mutant.key, known) is None:
            alive.append(mutant.number)
    program = hunter(room)
    if try_file:
        return try_changes(room, program, try_file, alive)
    cases, numbers, others = room.folder / 'cases.json', room.folder / 'alive', room.folder / 'others'
    if not cases.exists():
        say('  Certificates of the theory, if the command is built, and of the tests')
        with others.open('w') as out:
            out.writelines(line + '\n' for line in certificates_of_theory(room))
        subprocess.run([program, 'collect', str(cases), str(others)], check=True, stdout=subprocess.DEVNULL, env=ENVIRONMENT)
    numbers.write_text('\n'.join(map(str, alive)))
    outs = [room.folder / f'noticed-{job}' for job in range(room.jobs)]
    seed = random.SystemRandom().randrange(1 << 32)
    runs = [subprocess.Popen([program, 'hunt', str(cases), str(numbers), str(out), str(seconds), str(seed + 10**6 * job)],
                             stdout=None if job == 0 else subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=ENVIRONMENT)
            for job, out in enumerate(outs)]
    if any(run.wait() != 0 for run in runs):
        sys.exit('the hunt ended with an error')
    noticed = {}
    for out in outs:
        for one in written(out):
            noticed.setdefault(one['mutant'], one)
    keep(json.loads(cases.read_text()), noticed, {mutant.number: Path(mutant.file).stem for mutant in room.mutants})
    note_noticed(room, by_number, noticed)
    say(f'  {len(noticed)} of {len(alive)} survivors are noticed; judge them again')


def certificates_of_theory(room):
    """Certificates of one statement each, for all claims of the theory that are judged within a minute."""
    command, file = room.build / 'algae', room.folder / 'theory.json'
    for claim in sorted((ROOT / 'theory').rglob('*.claim')) if command.exists() else []:
        file.unlink(missing_ok=True)
        try:
            subprocess.run([str(command), 'check', str(claim), '--certificate', str(file)], timeout=60, capture_output=True)
        except subprocess.TimeoutExpired:
            continue
        whole = json.loads(file.read_text()) if file.exists() else {'statements': []}
        for statement in whole['statements']:
            text = json.dumps(statement)
            systems = {name: system for name, system in whole['systems'].items() if name in text}
            yield json.dumps({**whole, 'systems': systems, 'statements': [statement]})


def note_noticed(room, by_number, noticed):
    """Adds mutants to those that are known to be noticed: the tests have the changes now."""
    file = room.folder / 'found-so-far'
    if not file.exists():
        file = room.folder / 'found'
    with file.open('a') as out:
        for number in noticed:
            out.write(line_of_found(by_number[number], 'killed'))


def try_changes(room, program, file, alive):
    """Completes a file of cases by what is found, and prints the survivors that notice its changes."""
    numbers, out = file.with_suffix('.alive'), file.with_suffix('.out')
    numbers.write_text('\n'.join(map(str, alive)))
    subprocess.run([program, 'try', str(file), str(numbers), str(out)], check=True, env=ENVIRONMENT, stderr=subprocess.DEVNULL)
    cases, noticed = json.loads(file.read_text()), set()
    for one in written(out):
        case = cases[one['case']]
        if 'mutant' in one:
            noticed.add(one['mutant'])
        elif not one['change']:
            case.update(case=case.get('case', one['says']), outcome=one['outcome'], says=one['says'])
        else:
            case['changes'] = [[each[0], one['outcome'], one['says']] if each[0] == one['change'] else each
                               for each in case['changes']]
    write_cases(file, cases)
    for mutant in room.mutants:
        if mutant.number in noticed:
            say(f'{mutant.file}:{mutant.line}: at {mutant.column}: {mutant.original}  ->  {mutant.changed}')
    say(f'  {len(noticed)} survivors are noticed')
    numbers.unlink()
    out.unlink()


def keep(cases, noticed, file_of):
    """Adds the changes that notice mutants to the cases of tests/verify/certificates/mutants, a file for each source."""
    folder = ROOT / 'tests/verify/certificates/mutants'
    folder.mkdir(exist_ok=True)
    files = {}
    for number, one in sorted(noticed.items()):
        name = file_of[number]
        if name not in files:
            path = folder / f'{name}.json'
            files[name] = json.loads(path.read_text()) if path.exists() else []
        case = cases[one['case']]
        same = [each for each in files[name] if all(each.get(part) == case.get(part) for part in
                                                    ('header', 'alphabet', 'systems', 'statement', 'verdict', 'proof'))]
        if not same:
            same = [{**case, 'changes': []}]
            files[name] += same
        change = [one['change'], one['outcome'], one['says']]
        if one['change'] and change not in same[0]['changes']:
            same[0]['changes'].append(change)
    for name, all_cases in files.items():
        write_cases(folder / f'{name}.json', all_cases)


def write_cases(path, cases):
    """Writes a file of cases: a line for each field and each change."""
    def line(value):
        return json.dumps(value, ensure_ascii=False)

    text = []
    for case in cases:
        fields = [f'        {line(key)}: {line(value)}' for key, value in case.items() if key != 'changes']
        changes = ',\n'.join('            ' + line(each) for each in case['changes'])
        text.append('    {\n' + ',\n'.join(fields) + ',\n        "changes": [' +
                    (f'\n{changes}\n        ' if changes else '') + ']\n    }')
    put(path, '[\n' + ',\n'.join(text) + '\n]\n')


def line_of_found(mutant, outcome):
    """A line of the files that have what was found: the outcome, the number in this program, the line, and the key, which knows the
    mutant when the sources have changed."""
    return '\t'.join([outcome, str(mutant.number), str(mutant.line), *mutant.key]) + '\n'


def read_found(text):
    """The outcome, the number and the key of each whole line of such a file."""
    for line in text.splitlines(True)[1:]:
        parts = line.rstrip('\n').split('\t')
        if line.endswith('\n') and len(parts) == 8:
            yield parts[0], int(parts[1]), tuple(parts[3:])


def noticed_before(room):
    """The mutants that the last run, or the one before that ended early, found to be noticed, and how. The sources may have changed."""
    last = max(filter(Path.exists, (room.folder / 'found', room.folder / 'found-so-far')), key=lambda file: file.stat().st_mtime,
               default=None)
    found = {key: outcome for outcome, _, key in read_found(last.read_text() if last else '')}
    outcomes = {mutant.number: found.get(mutant.key) for mutant in room.mutants}
    return {number: outcome for number, outcome in outcomes.items() if outcome in ('killed', 'timed out')}


class Kept:
    """What was found so far, in a file, from which a run goes on that was stopped before its end."""

    def __init__(self, room, tests, longest, before):
        program = zlib.crc32(Path(tests.program).read_bytes())
        self.file, head = room.folder / 'found-so-far', f'{program} {longest}\n'
        text = self.file.read_text() if self.file.exists() else ''
        self.outcomes = {}
        if text.startswith(head):
            self.outcomes = {number: outcome for outcome, number, _ in read_found(text)}
        else:
            self.file.write_text(head)
        self.out = self.file.open('a', buffering=1)
        new = before.keys() - self.outcomes.keys()
        for mutant in room.mutants:
            if mutant.number in new:
                self.outcomes[mutant.number] = before[mutant.number]
                self.add(mutant, before[mutant.number])

    def add(self, mutant, outcome):
        self.out.write(line_of_found(mutant, outcome))


def report(room, wanted, found, dropped):
    """Prints the survivors and the figures. Returns 1 if a survivor is not known to be equivalent."""
    known = known_equivalents(room.name)
    explained, open_ones, by_file = 0, 0, {}
    for mutant in wanted:
        outcome = found[mutant.number]
        if outcome in ('killed', 'timed out'):
            continue
        reason = reason_for(mutant.key, known)
        explained += reason is not None
        open_ones += reason is None
        counts = by_file.setdefault(mutant.file, [0, 0])
        counts[0] += 1
        counts[1] += reason is not None
        if reason is None:
            say(f'{mutant.file}:{mutant.line}: {outcome}, at {mutant.column}: {mutant.original}  ->  {mutant.changed}')
    say('')
    for file, (survivors, equivalent) in sorted(by_file.items()):
        say(f'{file}: {survivors} survivors, {equivalent} of them equivalent')
    count = {outcome: sum(each == outcome for each in found.values())
             for outcome in ('killed', 'timed out', 'survived', 'not reached')}
    dead = count['killed'] + count['timed out']
    judged = max(1, len(wanted) - explained)
    say(f'{len(wanted)} mutants ({dropped} more did not compile): {count["killed"]} killed, {count["timed out"]} timed out, '
        f'{count["survived"]} survived, {count["not reached"]} not reached; {explained} of these are equivalent')
    say(f'{dead} of {judged} killed, {100 * dead / judged:.1f} %')
    return 1 if open_ones and room.name == 'verify' or dead < 0.95 * judged else 0


if __name__ == '__main__':
    main()
