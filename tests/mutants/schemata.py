"""Rewrites C++ sources so that one build holds many mutants: each changed expression becomes
(mutant(17) ? CHANGED : ORIGINAL). Works on tokens, not on a syntax tree, and trusts the layout that tools/format gives: a binary
operator has a space before it, and the bracket of a template has none. What is rewritten wrongly does not compile, and is
dropped by the caller, who maps the line of an error to the mutant.
"""

import re
from dataclasses import dataclass, field

TOKEN = re.compile(
    r'''(?P<space>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.)*(?=\n))
      | (?P<text>(?:u8|[uUL])?R"(?P<d>[^(\s]*)\(.*?\)(?P=d)"|(?:u8|[uUL])?"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)+')
      | (?P<number>\.?\d(?:[eEpP][+-]|'?[\w.])*)
      | (?P<name>[A-Za-z_]\w*)
      | (?P<sign><=>|->\*|<<=|>>=|\.\.\.|::|->|\+\+|--|<<|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)''',
    re.VERBOSE | re.DOTALL | re.MULTILINE)

# How tightly a binary operator binds, and what it is changed to.
BINDS = {'*': 9, '/': 9, '%': 9, '+': 8, '-': 8, '<<': 7, '>>': 7, '<=>': 6, '<': 5, '<=': 5, '>': 5, '>=': 5, '==': 4, '!=': 4,
         '&': 3, '^': 2.5, '|': 2, '&&': 1, '||': 0}
CHANGES = {'*': ['+'], '/': ['*'], '%': ['/'], '+': ['-'], '-': ['+'], '<<': ['>>'], '>>': ['<<'], '<': ['<=', '>='],
           '<=': ['<', '>'], '>': ['>=', '<='], '>=': ['>', '<'], '==': ['!='], '!=': ['=='], '&': ['|'], '|': ['&'],
           '&&': ['||'], '||': ['&&'], '+=': ['-='], '-=': ['+='], '*=': ['/='], '/=': ['*='], '|=': ['&='], '&=': ['|='],
           '%=': ['/='], '++': ['--'], '--': ['++']}
ASSIGNS = {'=', '+=', '-=', '*=', '/=', '%=', '&=', '|=', '^=', '<<=', '>>='}
CALLS = {'all_of': 'any_of', 'any_of': 'all_of', 'min': 'max', 'max': 'min'}
STOPS = {'return', 'throw', 'else', 'do', 'case', 'co_return', 'co_yield', 'using', 'typedef', 'delete', 'goto'}
HEADS = {'if', 'for', 'while', 'switch', 'catch'}
OPENS = {'(': ')', '[': ']', '{': '}', 'ANGLE<': 'ANGLE>'}
CLOSES = {close: open for open, close in OPENS.items()}


@dataclass
class Token:
    kind: str
    text: str
    start: int
    end: int
    spaced: bool  # whether space stands before it
    mate: int = -1  # the bracket that belongs to it


@dataclass
class Mutant:
    """One change: the characters of [start, end) are replaced."""
    file: str
    line: int
    start: int
    end: int
    original: str
    changed: str
    code: str  # of what is changed, with the brackets it needs
    column: int = 1  # of the operator in its line, counted without the indentation
    is_kept: bool = False  # what is evaluated there once is used again later
    number: int = 0
    key: tuple = ()  # what equivalent.txt knows it by


@dataclass
class Source:
    """The tokens of a file and the mutants that are found in it."""
    file: str
    text: str
    tokens: list = field(default_factory=list)
    mutants: list = field(default_factory=list)

    def __post_init__(self):
        self.read()
        self.pair()
        self.constants = [(token.start, self.tokens[self.until(at, {';'})].start) for at, token in enumerate(self.tokens)
                          if token.text == 'constexpr' and not self.is_function(at) and self.tokens[at - 1].text != 'if']
        self.kept = [(token.start, self.tokens[self.until(at, {';'})].start) for at, token in enumerate(self.tokens)
                     if token.text == 'static' and not self.is_function(at)]
        self.fixed = self.fixed_places()
        for at in range(len(self.tokens)):
            if not self.fixed[at]:
                self.look_at(at)

    def read(self):
        spaced = True
        for found in TOKEN.finditer(self.text):
            if found.lastgroup == 'space' or found['space']:
                spaced = True
                continue
            kind = next(each for each in ('text', 'number', 'name', 'sign') if found[each] is not None)
            if found[0] == '>>' and not spaced:  # of two templates
                self.tokens.append(Token(kind, '>', found.start(), found.start() + 1, False))
                self.tokens.append(Token(kind, '>', found.start() + 1, found.end(), False))
            else:
                self.tokens.append(Token(kind, found[0], found.start(), found.end(), spaced))
            spaced = False

    def pair(self):
        """Finds brackets, those of templates too, and gives each its mate."""
        open_ones = []
        for at, token in enumerate(self.tokens):
            before = self.tokens[at - 1] if at else None
            if token.text == '<' and before and before.kind == 'name' and (
                    not token.spaced or before.text == 'template') and before.text != 'operator':
                token.text = 'ANGLE<'
            elif token.text == '>' and not token.spaced and open_ones and self.tokens[open_ones[-1]].text == 'ANGLE<':
                token.text = 'ANGLE>'
            if token.text in OPENS:
                open_ones.append(at)
            elif token.text in CLOSES and open_ones:
                while open_ones and OPENS[self.tokens[open_ones[-1]].text] != token.text:
                    open_ones.pop()
                if open_ones:
                    token.mate = open_ones.pop()
                    self.tokens[token.mate].mate = at

    def fixed_places(self):
        """The tokens that have to be constant: arguments of templates, labels, enumerators, static assertions."""
        fixed = [False] * len(self.tokens)

        def fix(first, last):
            for i in range(first, min(last + 1, len(fixed))):
                fixed[i] = True

        for at, token in enumerate(self.tokens):
            following = self.tokens[at + 1] if at + 1 < len(self.tokens) else token
            if token.text == 'ANGLE<' and token.mate > at:
                fix(at, token.mate)
            elif token.text == 'case' and token.kind == 'name':
                fix(at, self.until(at, {':'}))
            elif token.text in ('static_assert', 'enum', 'requires', 'concept', 'noexcept', 'alignas'):
                fix(at, self.until(at, {';'}))
            elif token.text == 'if' and following.text == 'constexpr':
                fix(at, self.tokens[at + 2].mate)
            elif token.text == 'operator':
                fix(at, at + 1)
            elif token.text == 'constexpr' and self.is_function(at):
                fix(at, self.until(at, {'{', ';'}))
        return fixed

    def is_function(self, at):
        """Whether what is declared here, before the next = or ;, is a function."""
        return self.tokens[self.until(at, {'=', ';', '{', '('})].text == '('

    def until(self, at, signs):
        """The next of these signs that is not within brackets."""
        while at < len(self.tokens) - 1 and self.tokens[at].text not in signs:
            token = self.tokens[at]
            at = token.mate + 1 if token.text in OPENS and token.mate > at else at + 1
        return min(at, len(self.tokens) - 1)

    def is_binary(self, at):
        token = self.tokens[at]
        return token.kind == 'sign' and token.text in BINDS and token.spaced and at + 1 < len(self.tokens) and \
            self.tokens[at + 1].spaced

    def left_end(self, at, binds):
        """The first token of the left operand of a binary operator."""
        i = at - 1
        while i >= 0:
            token = self.tokens[i]
            if token.text in CLOSES:
                if token.mate < 0:
                    break
                head = self.tokens[token.mate - 1] if token.mate else token
                if token.text == ')' and (head.text in HEADS or (
                        head.text == 'constexpr' and self.tokens[token.mate - 2].text == 'if')):
                    break
                if token.text == '}' and self.is_block(token.mate) and i + 1 < at and self.begins(i + 1):
                    break
                i = token.mate - 1
            elif token.text in OPENS or token.text in ASSIGNS or token.text in (';', ',', '?', ':') or token.text in STOPS:
                break
            elif self.is_binary(i) and BINDS[token.text] < binds:
                break
            else:
                i -= 1
        return i + 1

    def is_block(self, at):
        """Whether this brace opens statements."""
        before = self.tokens[at - 1]
        return before.text in (')', ';', '{', '}', 'else', 'do', 'const', 'mutable', ':') or before.text == 'ANGLE>'

    def begins(self, at):
        """Whether an operand begins with this token, so that the block before it is not a lambda's."""
        token = self.tokens[at]
        return token.kind != 'sign' or token.text in ('++', '--', '!')

    def right_end(self, at, binds):
        """The last token of the right operand."""
        i, choices = at + 1, 0
        while i < len(self.tokens):
            token = self.tokens[i]
            if token.text in OPENS:
                if token.mate < 0:
                    break
                i = token.mate + 1
            elif binds < 0 and (token.text == '?' or token.text == ':' and choices > 0):
                choices += 1 if token.text == '?' else -1
                i += 1
            elif token.text in CLOSES or token.text in (';', ',', '?', ':') or token.text in ASSIGNS:
                break
            elif self.is_binary(i) and BINDS[token.text] <= binds:
                break
            else:
                i += 1
        return i - 1

    def operand_end(self, at):
        """The last token of the operand of a unary operator, which begins here."""
        i = at
        while self.tokens[i].text in ('!', '-', '*', '&', '~', '++', '--'):
            i += 1
        while i < len(self.tokens):
            token = self.tokens[i]
            after = self.tokens[i + 1] if i + 1 < len(self.tokens) else None
            if token.text in OPENS and token.mate > i:
                i = token.mate
                after = self.tokens[i + 1] if i + 1 < len(self.tokens) else None
            if after is None or after.text not in ('(', '[', '.', '->', '::', 'ANGLE<') and not (
                    token.text in ('.', '->', '::')) and not (after.text == '{' and not after.spaced):
                return i
            i += 1
        return len(self.tokens) - 1

    def line(self, at):
        return self.text.count('\n', 0, self.tokens[at].start) + 1

    def column(self, at):
        start = self.tokens[at].start
        line = self.text[self.text.rfind('\n', 0, start) + 1:start]
        return len(line.lstrip()) + 1

    def span(self, first, last):
        return self.text[self.tokens[first].start:self.tokens[last].end]

    def add(self, at, first, last, changed, code=None):
        if first > last or first < 0:
            return
        start, end = self.tokens[first].start, self.tokens[last].end
        if self.text[start:end] != changed:
            self.mutants.append(Mutant(self.file, self.line(at), start, end, flat(self.text[start:end]), flat(changed),
                                       code or changed, self.column(at),
                                       any(first <= start < after for first, after in self.kept)))

    def look_at(self, at):
        token = self.tokens[at]
        before = self.tokens[at - 1] if at else token
        if token.kind == 'number':
            self.number(at)
        elif token.text in ('true', 'false'):
            self.add(at, at, at, 'false' if token.text == 'true' else 'true')
        elif token.kind == 'name' and token.text in CALLS and before.text == '::' and self.tokens[at + 1].text == '(' \
                and self.tokens[at - 2].text == 'std':
            self.add(at, at - 2, self.tokens[at + 1].mate,
                     'std::' + CALLS[token.text] + self.span(at + 1, self.tokens[at + 1].mate))
        elif token.text in ('if', 'while') and token.kind == 'name' and self.tokens[at + 1].text == '(':
            self.condition(at)
        elif token.kind != 'sign':
            return
        elif self.is_binary(at) and token.text in CHANGES:
            first, last = self.left_end(at, BINDS[token.text]), self.right_end(at, BINDS[token.text])
            if first >= at or last <= at or token.text == '+' and self.has_text(first, last):
                return
            left, right = self.text[self.tokens[first].start:token.start], self.text[token.end:self.tokens[last].end]
            for other in CHANGES[token.text]:
                self.add(at, first, last, left + other + right, f'({left}) {other} ({right})')
        elif token.text in CHANGES and token.text in ASSIGNS:
            first, last = self.left_end(at, -1), self.right_end(at, -1)
            if token.text == '+=' and self.has_text(at, last):
                return
            for other in CHANGES[token.text]:
                self.add(at, first, last, self.text[self.tokens[first].start:token.start] + other +
                         self.text[token.end:self.tokens[last].end])
        elif token.text in ('++', '--'):
            other = CHANGES[token.text][0]
            if not self.tokens[at + 1].spaced and (self.tokens[at + 1].kind == 'name' or self.tokens[at + 1].text in ('*', '(')):
                last = self.operand_end(at + 1)
                self.add(at, at, last, other + self.span(at + 1, last))
            else:
                first = self.postfix_start(at)
                self.add(at, first, at, self.text[self.tokens[first].start:token.start] + other)
        elif token.text in ('!', '-') and not self.tokens[at + 1].spaced and not (
                token.text == '-' and (before.kind in ('name', 'number') and before.text not in STOPS or
                                       before.text in (')', ']'))):
            last = self.operand_end(at + 1)
            operand = self.span(at + 1, last)
            self.add(at, at, last, operand, f'bool({operand})' if token.text == '!' else operand)
        elif token.text == '?':
            first = self.left_end(at, -1)
            if first < at and not any(self.is_decision(i) for i in self.outside(first, at)):
                self.add(at, first, at - 1, f'!({self.span(first, at - 1)})')

    def postfix_start(self, at):
        i = at - 1
        while i > 0:
            if self.tokens[i].text in CLOSES and self.tokens[i].mate >= 0:
                i = self.tokens[i].mate
                if self.tokens[i - 1].kind == 'name' and self.tokens[i - 1].text not in HEADS | STOPS:
                    i -= 1
            if self.tokens[i - 1].text in ('.', '->', '::'):
                i -= 2
            else:
                return i
        return i

    def number(self, at):
        text = self.tokens[at].text
        digits = text.replace("'", '').rstrip('uUlL')
        if digits.isdigit() and (digits == '0' or digits[0] != '0'):
            self.add(at, at, at, str(int(digits) + 1) + text.replace("'", '')[len(digits):])

    def is_decision(self, at):
        text = self.tokens[at].text
        return text == '!' or self.is_binary(at) and BINDS[text] <= 5 and text not in ('&', '|', '^')

    def outside(self, first, after):
        """The tokens of [first, after) that are not within brackets."""
        i = first
        while i < after:
            yield i
            i = self.tokens[i].mate if self.tokens[i].text in OPENS and self.tokens[i].mate > i else i + 1

    def has_text(self, first, last):
        """Whether an operand is a string, which can only be added."""
        return any(self.tokens[i].text.startswith('"') or self.tokens[i].text == 'to_string' for i in self.outside(first, last + 1))

    def condition(self, at):
        """A condition never holds, so what it asks for is not asked; one without an operator also is turned round."""
        first, close = at + 2, self.tokens[at + 1].mate
        if close < 0:
            return
        for i in self.outside(first, close):
            if self.tokens[i].text == ';':
                first = i + 1
        inside = list(self.outside(first, close))
        if any(self.tokens[i].text == '=' for i in inside) or first >= close:
            return
        if self.tokens[at].text == 'if':
            self.add(at, first, close - 1, 'false')
        if not any(self.is_decision(i) for i in inside):
            self.add(at, first, close - 1, f'!({self.span(first, close - 1)})')

    def rewritten(self, wanted):
        """The text with these mutants, and for each of its lines those to blame for an error there: the mutant whose change it
        is, or those around it. A mutant that overlaps with another one is left out."""
        places = {}
        for mutant in wanted:
            places.setdefault((mutant.start, mutant.end), []).append(mutant)
        spans = sorted(places, key=lambda span: (span[0], -span[1]))
        out, lines = [], [[]]

        def put(text, blamed):
            out.append(text)
            lines[-1] = lines[-1] or blamed
            lines.extend([blamed] * text.count('\n'))

        def write(start, end, position, around):
            """Writes the characters of [start, end) with the spans from `position` on that lie there."""
            at = start
            while position < len(spans) and spans[position][0] < end:
                first, last = spans[position]
                if first < at or last > end:
                    position += 1
                    continue
                put(self.text[at:first] + '(\n', around)
                inner = [mutant.number for mutant in places[first, last]]
                for mutant in places[first, last]:
                    put(f'::mutants::is_on({mutant.number})\n? ({mutant.code})\n', [mutant.number])
                    lines[-1] = []
                    put(':\n', inner)
                position = write(first, last, position + 1, inner)
                put(')', inner)
                at = last
            put(self.text[at:end], around)
            return position

        at = position = 0
        for start, end in self.constants:  # which are no longer known when they are compiled
            if any(start <= first < end for first, _ in spans):
                position = write(at, start, position, [])
                put('const', [])
                at = start + len('constexpr')
        write(at, len(self.text), position, [])
        return ''.join(out), lines

    def in_constants(self):
        """The mutants within what the compiler may have to know."""
        return [mutant for mutant in self.mutants if any(start <= mutant.start < end for start, end in self.constants)]


def flat(text):
    """One line without comments."""
    return ' '.join(re.sub(r'//[^\n]*', '', text).split())
