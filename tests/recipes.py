#!/usr/bin/env python3
"""The recipes of tools/packaging and the files for citation, as far as they can be checked without the tools that read
them: they are evaluated with stand-ins of what EasyBuild and Spack define, and their options must be the build's.
usage: recipes.py SOURCE"""
import json
import os
import re
import shutil
import subprocess
import sys
import types

source = sys.argv[1]
packaging = os.path.join(source, "tools", "packaging")
wrong = []


def text(*path):
    with open(os.path.join(source, *path), encoding="utf-8") as file:
        return file.read()


def need(true, sentence):
    if not true:
        wrong.append(sentence)


def options_are_known(name, options):
    """Each -DOPTION is one of CMakeLists.txt, or the folder of a library that tools/cmake/find.cmake looks for."""
    build = text("CMakeLists.txt")
    libraries = text("tools", "cmake", "dependencies.cmake") + text("tools", "cmake", "find.cmake")
    found = re.findall(r"-D(\w+)(?::\w+)?=", " ".join(options))
    need("FRANA_ARCH" in found, f"{name}: does not set FRANA_ARCH, so -march would be that of the machine that builds")
    for option in found:
        root = re.fullmatch(r"(\w+)_ROOT", option)
        if root:
            known = re.search(rf"\b{root[1]}\b", libraries)
        else:
            known = re.search(rf"(option|set)\({option}\b", build) or option in ("BUILD_SHARED_LIBS", "BUILD_TESTING")
        need(known, f"{name}: -D{option} is no option of the build")


# what EasyBuild demands, and the names that it defines in an easyconfig (docs.easybuild.io)
def easyconfig(path):
    names = {"SYSTEM": {"name": "system", "version": "system"}, "SHLIB_EXT": "so", "ARCH": "x86_64",
             "SOURCE_TAR_GZ": "%(name)s-%(version)s.tar.gz", "SOURCELOWER_TAR_GZ": "%(namelower)s-%(version)s.tar.gz"}
    exec(compile(text("tools", "packaging", "easybuild", path), path, "exec"), names)
    for key in ("easyblock", "name", "version", "homepage", "description", "toolchain", "sources", "moduleclass",
                "sanity_check_paths"):
        need(names.get(key), f"{path}: has no {key}")
    need(set(names["toolchain"]) == {"name", "version"}, f"{path}: a toolchain is a name and a version")
    need(set(names["sanity_check_paths"]) == {"files", "dirs"}, f"{path}: sanity_check_paths are files and dirs")
    for entry in names.get("dependencies", []) + names.get("builddependencies", []):
        need(isinstance(entry, tuple) and len(entry) >= 2 and all(isinstance(word, str) for word in entry[:2]),
             f"{path}: a dependency is a name and a version: {entry}")
    for sum in names.get("checksums", []):
        need(re.fullmatch("[0-9a-f]{64}", sum), f"{path}: not a sha256: {sum}")
    return names


# package.py, with stand-ins that note what it declares
def spack():
    declared = {"depends_on": [], "version": [], "variant": [], "license": []}
    api = types.ModuleType("spack.package")
    for word, list in declared.items():
        setattr(api, word, lambda *a, list=list, **k: list.append((a, k)))
    for word in ("run_after", "on_package_attributes"):
        setattr(api, word, lambda *a, **k: lambda function: function)
    cmake = types.ModuleType("spack_repo.builtin.build_systems.cmake")

    def value(v):
        return "ON" if v is True else "OFF" if v is False else str(v)

    class CMakePackage:
        run_tests = False
        define = staticmethod(lambda name, v: f"-D{name}:STRING={value(v)}")

        class spec(dict):
            def __missing__(self, name):
                names = [a[0].split()[0].split("@")[0].split("+")[0] for a, _ in declared["depends_on"]]
                need(name in names, f"package.py: asks for the place of {name}, on which it does not depend")
                return types.SimpleNamespace(prefix="/" + name)

        spec = spec()

        def define_from_variant(self, option, variant):
            need(variant in [a[0] for a, _ in declared["variant"]], f"package.py: no variant {variant}")
            return self.define(option, False)

    cmake.CMakePackage = CMakePackage
    modules = {"spack": types.ModuleType("spack"), "spack.package": api, cmake.__name__: cmake}
    for name in ("spack_repo", "spack_repo.builtin", "spack_repo.builtin.build_systems"):
        modules[name] = types.ModuleType(name)
    sys.modules.update(modules)
    path = os.path.join(packaging, "spack", "spack_repo", "frana", "packages", "frana", "package.py")
    names = {"__file__": path, "__name__": "package"}
    with open(path, encoding="utf-8") as file:
        exec(compile(file.read(), path, "exec"), names)
    package = names["Frana"]
    need(package.git == "file://" + os.path.realpath(source), f"package.py: its checkout is not {source}: {package.git}")
    need(package.__doc__ and package.homepage and declared["license"], "package.py: no description, homepage or licence")
    options_are_known("package.py", package().cmake_args())
    return declared


# CITATION.cff: the keys of version 1.2.0 of its schema
def citation():
    keys = dict(re.findall(r"^([\w-]+):[ ]*(.*)$", text("CITATION.cff"), re.M))
    for key in ("cff-version", "message", "title", "authors"):
        need(key in keys, f"CITATION.cff: has no {key}")
    allowed = {"abstract", "authors", "cff-version", "commit", "contact", "date-released", "doi", "identifiers",
               "keywords", "license", "license-url", "message", "preferred-citation", "references", "repository",
               "repository-artifact", "repository-code", "title", "type", "url", "version"}
    need(set(keys) <= allowed, f"CITATION.cff: unknown keys {set(keys) - allowed}")
    need(keys["cff-version"] == "1.2.0" and keys.get("type") == "software", "CITATION.cff: version of the format, type")
    need(re.search(r"^authors:\n +- (name|family-names): ", text("CITATION.cff"), re.M), "CITATION.cff: no author")
    about = json.loads(text("codemeta.json"))
    for key in ("@context", "type", "name", "version", "license", "author", "description"):
        need(about.get(key), f"codemeta.json: has no {key}")
    need(about["license"].endswith("/" + keys["license"]), "codemeta.json and CITATION.cff have two licences")


def parsed(path, command):
    if shutil.which(command[0]):
        run = subprocess.run([*command, os.path.join(packaging, "modulefiles", path)], capture_output=True, text=True)
        need(run.returncode == 0, f"{path}: {run.stderr}")


frana = easyconfig("frana.eb")
options_are_known("frana.eb", [frana["configopts"]])
spack()
citation()
parsed("frana.lua", ["luac", "-p"])
parsed("frana.tcl", ["tclsh", os.path.join(source, "tests", "complete.tcl")])

print("\n".join(wrong) or "ok")
sys.exit(bool(wrong))
