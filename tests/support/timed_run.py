"""Runs of a program, with what they took: for scripts that try many."""
import resource
import subprocess


def cpu():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(words, limit):
    """Exit code (None: killed after `limit` seconds of the clock), output, seconds of the processor."""
    before = cpu()
    try:
        done = subprocess.run(list(map(str, words)), text=True, errors='replace', stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=limit)
    except subprocess.TimeoutExpired as late:
        said = (late.stdout or b'').decode(errors='replace')
        return None, f'killed after {limit} s: {said}', cpu() - before
    return done.returncode, done.stdout, cpu() - before
