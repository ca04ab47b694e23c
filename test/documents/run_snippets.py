#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_rgbd_planes authors
"""run_snippets.py DOCUMENT SOURCE PREFIX: runs the shell snippets of a document, in a folder with
little more than links to doc and scripts, against the project installed to PREFIX.

Blocks of the language sh are run as they are, and must succeed; to keep this short, a range of
seeds becomes its first one, and evaluations take one frame of each input, at QQVGA unless they say
which size. Blocks of the language console are commands after "$ ", each with what it prints:
numbers may be off by one in their last digit, and "..." stands for anything. Blocks with $DATA are
left out where PCL_RGBD_PLANES_DATA is not set, and those that are marked not-in-tests always: they
install packages and build this project, as the tests' own script does, or take long.

The C++ and CMake of README.md is compiled by test/consumers, that of tutorials by their own
commands, but for blocks of C++ inside of a tutorial: test/documents/snippets/TUTORIAL.cpp.in says
what is around them, with @1@ for the first block."""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

PRELUDE = """set -euo pipefail
evaluate () {
  case "$*" in *--resolution*) ;; *) set -- "$@" --resolution qqvga ;; esac
  command "$@" --frames 1
}
pcl_evaluate_normals () { evaluate pcl_evaluate_normals "$@"; }
pcl_evaluate_planes () { evaluate pcl_evaluate_planes "$@"; }
pcl_evaluate_detection () { evaluate pcl_evaluate_detection "$@"; }
"""


def code_blocks(document):
    """The language and text of each code block of a .md or .rst file."""
    text = document.read_text(encoding="utf-8")
    if document.suffix == ".md":
        if re.search(r"\n\n    \S", text):
            sys.exit(f"{document.name}: a code block without a language")
        return re.findall(r"^```(.*)\n((?s:.*?))^```$", text, re.MULTILINE)
    found = re.findall(r"^\.\. code-block:: (\w+)\n\n((?:(?:   .*)?\n)+)", text, re.MULTILINE)
    return [(language, re.sub(r"^   ", "", body, flags=re.MULTILINE)) for language, body in found]


def check_included_files(document):
    """The files and markers that a tutorial shows must be there."""
    include = r"^\.\. literalinclude:: (\S+)\n((?:   :.*\n)*)"
    for name, options in re.findall(include, document.read_text(encoding="utf-8"), re.MULTILINE):
        source = (document.parent / name).read_text(encoding="utf-8")
        for marker in re.findall(r":(?:start-after|end-before): (.*)", options):
            if source.count(marker) != 1:
                sys.exit(f"{document.name}: {marker!r} is not once in {name}")


def number_pattern(number):
    """Matches the decimal number and those that are off by one in its last digit."""
    digits = len(number.partition(".")[2])
    values = [float(number) + step * 10**-digits for step in (-1, 0, 1)]
    return "(?:" + "|".join(r"[-+]?" + re.escape(f"{abs(value):.{digits}f}") if abs(value) < 10**-digits
                            else re.escape(f"{value:.{digits}f}") for value in values) + ")"


def output_pattern(expected):
    """Matches what a command is said to print."""
    def token_pattern(token):
        if token == "...":
            return r"(?s:.*?)"
        if token.isspace():
            return r"\s*"
        if token[-1].isdigit():
            return (r"\+" if token[0] == "+" else "") + number_pattern(token)
        return re.escape(token)
    tokens = re.findall(r"\.\.\.|(?:(?<![\w)])[-+])?\d+(?:\.\d+)?|\s+|.", expected.strip())
    return "".join(map(token_pattern, tokens)) + r"\s*"


def run(script, folder, environment):
    print(f"$ {script.strip()}", flush=True)
    result = subprocess.run(["bash", "-c", PRELUDE + script], cwd=folder, env=environment,
                            stdout=subprocess.PIPE, text=True, check=False)
    print(result.stdout, flush=True)
    if result.returncode != 0:
        sys.exit(f"exit status {result.returncode}")
    return result.stdout


def run_console(transcript, folder, environment):
    for command, expected in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n?)*)", transcript, re.MULTILINE):
        printed = run(command, folder, environment)
        if not re.fullmatch(output_pattern(expected), printed.strip()):
            sys.exit(f"but the document says\n{expected}")


def write_depth_image(path):
    """A wall at 1 m, for a camera with 5000 units per metre."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    rows = (b"\0" + struct.pack(">H", 5000) * 640) * 480
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", 640, 480, 16, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def make_inputs(folder, environment):
    """What documents call my.pcd, folder_of_pcds, depth.png and tum_rgbd_folder."""
    run("pcl_simulate_rgbd table_single --resolution qvga --output simulated", folder, environment)
    cloud = folder / "simulated" / "table_single_1_kinect_qvga.pcd"
    (folder / "folder_of_pcds").mkdir()
    os.link(cloud, folder / "my.pcd")
    os.link(cloud, folder / "folder_of_pcds" / "1.pcd")
    tum = folder / "tum_rgbd_folder"
    tum.mkdir()
    (tum / "depth.txt").write_text("# timestamp filename\n1.0 1.png\n", encoding="utf-8")
    write_depth_image(folder / "depth.png")
    os.link(folder / "depth.png", tum / "1.png")


def compile_cpp(document, source, folder, environment):
    """Compiles the C++ blocks of a tutorial, with what is around them."""
    blocks = [text for language, text in code_blocks(document) if language == "cpp"]
    if document.suffix != ".rst" or not blocks:
        return
    template = source / "test" / "documents" / "snippets" / f"{document.stem}.cpp.in"
    code = template.read_text(encoding="utf-8")
    for number, block in enumerate(blocks, 1):
        if code.count(f"@{number}@") != 1:
            sys.exit(f"{template.name}: @{number}@ is not there once")
        code = code.replace(f"@{number}@", block)
    (folder / "blocks.cpp").write_text(code, encoding="utf-8")
    run("c++ -std=c++17 -fsyntax-only $(pkg-config --cflags pcl_rgbd_planes) blocks.cpp", folder,
        environment)


def run_document(document, source, folder, environment):
    for name in ("doc", "scripts"):
        (folder / name).symlink_to(source / name)
    compile_cpp(document, source, folder, environment)
    make_inputs(folder, environment)
    for language, text in code_blocks(document):
        if language == "console":
            run_console(text, folder, environment)
        elif language == "sh" and ("$DATA" not in text or environment["DATA"]):
            run(re.sub(r"{(\d+)\.\.\d+}", r"\1", text), folder, environment)
        elif language not in ("sh", "sh not-in-tests", "text", "diff", "cpp", "cmake"):
            sys.exit(f"{document.name}: a code block of the language {language!r}")


def main():
    document, source, prefix = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    check_included_files(document)
    data = os.environ.get("PCL_RGBD_PLANES_DATA", "")
    package = next(prefix.rglob("pcl_rgbd_planes.pc")).parent
    environment = dict(os.environ, PATH=f"{prefix}/bin:{os.environ['PATH']}",
                       CMAKE_PREFIX_PATH=str(prefix), PKG_CONFIG_PATH=str(package), DATA=data,
                       CORRIDOR=f"{data}/kinect")
    with tempfile.TemporaryDirectory() as folder:
        run_document(document, source, pathlib.Path(folder), environment)


main()
