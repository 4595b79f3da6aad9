"""The mutants of a C source: each a small change of one constant, shift, rounding, sign or
comparison.

    python3 mutants.py FILE...      lists them
"""
import re
import sys

TOKEN = re.compile(r"""
    (?P<skip>/\*.*?\*/|\s+|\\\n|//[^\n]*)
  | (?P<directive>\#[ \t]*(?:include|if|ifdef|ifndef|elif|else|endif|undef|error|pragma)
                  (?:\\\n|[^\n])*)
  | (?P<define>\#[ \t]*define[ \t]+\w+(?:\([^)]*\))?)
  | (?P<string>"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')
  | (?P<number>0[xX][0-9a-fA-F]+[uUlL]*|[0-9]+[uUlL]*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<operator><<=|>>=|<<|>>|<=|>=|==|!=|\+\+|--|->|\+=|-=|&&|\|\||.)
""", re.X | re.S)

SWAPS = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==",
         "+": "-", "-": "+", "+=": "-=", "-=": "+="}
TYPES = re.compile(r"(u?int\d+_t|int|unsigned|char|size_t|(fx|qv)_\w+)$")


class Token:
    def __init__(self, match):
        self.kind = match.lastgroup
        self.text = match.group()
        self.start = match.start()


def tokens_of(text):
    found = [Token(match) for match in TOKEN.finditer(text)]
    return [token for token in found if token.kind not in ("skip", "directive")]


def near(tokens, i):
    """The token, or an empty one beyond the ends."""
    class Nothing:
        kind, text, start = "", "", 0
    return tokens[i] if 0 <= i < len(tokens) else Nothing


def is_value_end(token):
    return token.kind in ("name", "number") and token.text != "return" or token.text in ("]", ")")


def is_declared_size(tokens, i):
    """Whether a number is an array's size in its declaration: type name[n] or type name[m][n]."""
    j = i - 1
    while near(tokens, j).text == "[" and near(tokens, j - 1).text == "]":
        j -= 3
    return near(tokens, j).text == "[" and near(tokens, j - 1).kind == "name" and (
        TYPES.match(near(tokens, j - 2).text) or near(tokens, j - 2).text == "*"
        and TYPES.match(near(tokens, j - 3).text) is not None)


def changed_number(text, by):
    digits = re.match(r"0[xX][0-9a-fA-F]+|[0-9]+", text).group()
    value = int(digits, 0) + by
    if value < 0:
        return None
    return (hex(value) if digits[:2] in ("0x", "0X") else str(value)) + text[len(digits):]


def of_number(tokens, i):
    if is_declared_size(tokens, i):
        return
    for by in (1, -1):
        text = changed_number(tokens[i].text, by)
        if text is not None:
            yield text


def is_rounding(tokens, i):
    """Whether the + adds something to a sum that is shifted or divided next: (... + n) >> s."""
    j = i + 1
    if near(tokens, j).text == "(":
        while near(tokens, j).text not in (")", ""):
            j += 1
    return near(tokens, j + 1).text == ")" and near(tokens, j + 2).text in (">>", "/")


def of_operator(tokens, i):
    text = tokens[i].text
    if text in (">>", "<<", ">>=", "<<="):
        if near(tokens, i + 1).kind != "number":
            yield text + " 1 +"
            yield text + " -1 +"
    elif text in SWAPS and is_value_end(near(tokens, i - 1)):
        yield SWAPS[text]
        if text == "+" and is_rounding(tokens, i):
            yield "+ 0 *"


def refusals(tokens):
    """Numbers of the tokens that only decide what is refused: the condition of an if whose
    statement returns an error, and such a return."""
    found, opened = set(), []
    for i, token in enumerate(tokens):
        if token.text == "if":
            opened = [i]
        elif token.text == "return":
            end = i
            while near(tokens, end).text not in (";", ""):
                end += 1
            if any(other.text.startswith("QV_ERROR") for other in tokens[i:end]):
                found.update(range(opened[0] if opened else i, end))
        if token.text in (";", "{", "}"):
            opened = []
    return found


def mutants_of(text):
    """(offset, old text, new text) of each."""
    tokens = tokens_of(text)
    refused = refusals(tokens)
    for i, token in enumerate(tokens):
        if i in refused:
            continue
        changes = {"number": of_number, "operator": of_operator}.get(token.kind)
        for new in changes(tokens, i) if changes else ():
            yield token.start, token.text, new


def functions_of(text):
    """(first line, last line) of each function's body: what stands in braces behind a list of
    parameters."""
    found, depth, start = [], 0, None
    tokens = [token for token in tokens_of(text) if token.kind != "define"]
    for i, token in enumerate(tokens):
        if token.text == "{":
            if depth == 0 and near(tokens, i - 1).text == ")":
                start = line_of(text, token.start)
            depth += 1
        elif token.text == "}":
            depth -= 1
            if depth == 0 and start is not None:
                found.append((start, line_of(text, token.start)))
                start = None
    return found


def line_of(text, offset):
    return text.count("\n", 0, offset) + 1


if __name__ == "__main__":
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            source = file.read()
        for start, old, new in mutants_of(source):
            print(f"{path}:{line_of(source, start)}: {old} -> {new}")
