"""The three checkers of proofs, called many times: each gives whether it accepts, and what it prints."""

import contextlib
import io
import pathlib
import subprocess
import sys


class Checkers:
    def __init__(self, folder, compiled):
        self.compiled = compiled
        sys.path.append(str(folder))  # verify.py imports read_picture.py, which stands beside it
        source = pathlib.Path(folder, "verify.py").read_text(encoding="utf-8")
        self.python_code = compile(source, "verify.py", "exec")
        served = pathlib.Path(__file__).with_name("serve.mjs")
        self.node = subprocess.Popen(["node", served, pathlib.Path(folder, "verify.mjs")], stdin=subprocess.PIPE,
                                     stdout=subprocess.PIPE, text=True)

    def close(self):
        self.node.stdin.close()
        self.node.wait()

    def python(self, files):
        before, sys.argv = sys.argv, ["verify.py", *files]
        try:
            with contextlib.redirect_stdout(io.StringIO()) as said:
                exec(self.python_code, {"__name__": "__main__"})
            return True, said.getvalue()
        except SystemExit as reason:
            return False, str(reason.code)
        except Exception as error:  # input that is no proof ends the checker, too
            return False, repr(error)
        finally:
            sys.argv = before

    def javascript(self, files):
        self.node.stdin.write("\t".join(files) + "\n")
        self.node.stdin.flush()
        status, said = self.node.stdout.readline().rstrip("\n").split("\t", 1)
        return status == "0", said

    def cpp(self, files):
        done = subprocess.run([self.compiled, *files], capture_output=True, text=True)
        return done.returncode == 0, done.stdout + done.stderr

    def verdicts(self, *files):
        files = [str(file) for file in files]
        return {"py": self.python(files), "mjs": self.javascript(files), "cpp": self.cpp(files)}
