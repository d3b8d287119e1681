#!/usr/bin/env python3
"""check_comments.py ROOT [--mend]: comments have their shape, which clang-format leaves alone here.

No line of a comment is longer than 100 columns, none breaks off in a sentence long before that, and a tag (REQUIRES:,
ENSURES:, Errors: ...) begins a line of its own. With --mend, what is not so is broken anew; lines that are fine stay as they are.
"""
import pathlib
import re
import sys
import textwrap

WIDTH = 100
SLACK = 20  # columns by which a line may be shorter than the next word makes it
TAG = r'(?:REQUIRES|ENSURES|EXACT|Errors|Units|Returns|Raises|Threads|Cost|Memory|Ref):'
SENTENCE_THEN_TAG = re.compile(rf'(?<=[.;)]) +(?={TAG}(?: |$))')


def comment_of(line):
    """Where the comment of a line begins, and its mark; None if there is none. Strings are no comments."""
    bare = re.sub(r'"(?:\\.|[^"\\])*"', lambda m: '"' * len(m.group()), line)
    found = re.search(r'///<|///|//', bare)
    return found and (found.start(), found.group())


def is_block(line):
    found = comment_of(line)
    return bool(found) and not line[:found[0]].strip() and found[1] != '///<'


def text_of(line):
    start, mark = comment_of(line)
    return line[start + len(mark):]


def is_wrong(line):
    found = comment_of(line)
    if not found or re.match(r'\s*#\s*include', line):
        return False
    words = text_of(line).split()
    return len(line) > WIDTH and len(words) > 1 or bool(is_block(line) and SENTENCE_THEN_TAG.search(line))


def begins_paragraph(text):
    """Whether a line of a comment cannot go on with the one before: blank, a tag, an item, a drawing."""
    return not text.strip() or bool(re.match(rf' ?(?:{TAG}|[-*|] |\d+\. )', text))


def breaks_off(lines, k):
    """Whether line k of a comment ends in a sentence although the next word had room."""
    if k + 1 >= len(lines) or not is_block(lines[k]) or not is_block(lines[k + 1]):
        return False
    if lines[k][:comment_of(lines[k])[0]] != lines[k + 1][:comment_of(lines[k + 1])[0]]:
        return False
    text, after = text_of(lines[k]), text_of(lines[k + 1])
    if after.startswith('   ') and not text.startswith('   '):  # the middle of what a tag says
        return 1 <= len(text.split()) <= 2 and not re.match(rf' ?{TAG}', text) and bool(re.match(r' *[a-z]', after))
    if not text.strip() or text.startswith('   ') or not (
            re.search(r'[a-z,]$', text.rstrip()) and re.match(r' *[a-z]', after)):
        return False
    return len(lines[k].rstrip()) + 1 + len(after.split()[0]) <= WIDTH - SLACK


def wrapped(paragraph, prefix):
    """The lines of a paragraph, after `prefix`, each tag on a line of its own."""
    lines = []
    for part in SENTENCE_THEN_TAG.split(' '.join(line.strip() for line in paragraph)):
        head = re.match(rf'(?:{TAG} +|[-*] |\d+\. )?', part).group()
        lines += textwrap.wrap(' '.join(part[len(head):].split()), WIDTH, break_long_words=False, break_on_hyphens=False,
                               initial_indent=f'{prefix} {head}', subsequent_indent=prefix + ' ' * (1 + len(head)))
    return lines


def mended(lines):
    result, k = [], 0
    while k < len(lines):
        if not is_wrong(lines[k]):
            result.append(lines[k])
        elif not is_block(lines[k]):  # behind code: it goes before that
            start, mark = comment_of(lines[k])
            code, paragraph = lines[k][:start].rstrip(), [text_of(lines[k])]
            while k + 1 < len(lines) and comment_of(lines[k + 1]) == (start, mark) and not lines[k + 1][:start].strip():
                k += 1
                paragraph.append(text_of(lines[k]))
            result += wrapped(paragraph, re.match(r'\s*', code).group() + mark.rstrip('<')) + [code]
        else:
            start, mark = comment_of(lines[k])
            prefix, paragraph = lines[k][:start] + mark, [text_of(lines[k])]
            while result and is_block(result[-1]) and not begins_paragraph(paragraph[0]) and text_of(result[-1]).strip():
                paragraph.insert(0, text_of(result.pop()))
            while k + 1 < len(lines) and is_block(lines[k + 1]) and not begins_paragraph(text_of(lines[k + 1])):
                k += 1
                paragraph.append(text_of(lines[k]))
            result += wrapped(paragraph, prefix)
        k += 1
    return result


def main(root, mend):
    files = sorted(path for top in ('libcover', 'apps', 'tests', 'samples') for path in (root / top).rglob('*.[hc]pp'))
    wrong = []
    for path in files:
        lines = path.read_text().split('\n')
        if mend and any(map(is_wrong, lines)):
            path.write_text('\n'.join(mended(lines)))
        wrong += [f'{path.relative_to(root)}:{number}: a comment is too long, or a tag stands inside a line'
                  for number, line in enumerate(lines, 1) if is_wrong(line)]
        wrong += [f'{path.relative_to(root)}:{k + 1}: a line of a comment breaks off'
                  for k in range(len(lines)) if breaks_off(lines, k)]
    print('\n'.join(wrong) or f'{len(files)} files have comments in shape')
    return 1 if wrong and not mend or not files else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), '--mend' in sys.argv))
