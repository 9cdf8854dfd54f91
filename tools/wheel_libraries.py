#!/usr/bin/python3
"""Takes the shared libraries that a wheel needs into it, as auditwheel does: wheel_libraries.py WHEEL FOLDER (needs Debian or Ubuntu, patchelf,
binutils). matrigrate.libs/LIBRARIES has the package and version of each; the licences of these packages lie beside it.

Left out are those that each Linux with the GNU C library has. Each library gets the start of its checksum into its name, so that no other
package of Python takes it for its own. The new wheel's name says which C library it needs. SOURCE_DATE_EPOCH is the time.
"""
import argparse
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import zipfile

import sbom

of_the_system = re.compile(r"(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|stdc\+\+|gcc_s))\.so\.\d+")


def needed(file: pathlib.Path) -> list[str]:
    return [name for name in re.findall(r"^\s+NEEDED\s+(\S+)", sbom.output("objdump", "-p", str(file)), re.MULTILINE) if not of_the_system.fullmatch(name)]


def places(file: pathlib.Path) -> dict[str, pathlib.Path]:
    """All libraries that a file needs, with those that these need."""
    found = sbom.output("ldd", str(file))
    if "not found" in found:
        raise SystemExit(f"{file.name}: {found}")
    named = re.findall(r"^\s*(\S+) => (/\S+)", found, re.MULTILINE)
    return {name: pathlib.Path(path).resolve() for name, path in named if not of_the_system.fullmatch(name)}


def glibc(file: pathlib.Path) -> tuple[int, int]:
    """The newest version of the GNU C library whose symbols a file uses."""
    return max(((int(a), int(b)) for a, b in re.findall(r"GLIBC_(\d+)\.(\d+)", sbom.output("objdump", "-T", str(file)))), default=(2, 17))


def take_in(tree: pathlib.Path) -> list[pathlib.Path]:
    """@return  all compiled files of the wheel"""
    package = tree / "matrigrate"
    compiled = [file for file in (package / "bin" / "matrigrate", *sorted(package.glob("_core*.so"))) if file.exists()]
    if not compiled:
        raise SystemExit("the wheel has neither program nor module")
    libraries: dict[str, pathlib.Path] = {}
    for file in compiled:
        subprocess.run(["strip", "--strip-unneeded", file], check=True)
        libraries |= places(file)
    folder = tree / "matrigrate.libs"
    folder.mkdir()
    renamed = {}
    listed = []
    for name, path in sorted(libraries.items()):
        stem, rest = name.split(".so", 1)
        renamed[name] = f"{stem}-{hashlib.sha256(path.read_bytes()).hexdigest()[:8]}.so{rest}"
        shutil.copyfile(path, folder / renamed[name])
        package = sbom.package_of(str(path))
        listed.append(f"{renamed[name]} {sbom.output('dpkg-query', '-W', '-f', '${Package} ${Version} ${source:Package} ${source:Version}', package)}\n")
        (folder / "licences").mkdir(exist_ok=True)
        shutil.copyfile(f"/usr/share/doc/{package.split(':')[0]}/copyright", folder / "licences" / package.split(":")[0])
    (folder / "LIBRARIES").write_text("file, package of Debian or Ubuntu with its version, its source with its version\n\n" + "".join(listed))
    for file in (*compiled, *(folder / name for name in renamed.values())):
        names = [word for name in needed(file) for word in ("--replace-needed", name, renamed[name])]
        for edit in (names, ["--set-soname", file.name] if file.parent == folder else [],
                     ["--force-rpath", "--set-rpath", os.path.join("$ORIGIN", os.path.relpath(folder, file.parent))]):
            if edit:
                subprocess.run(["patchelf", *edit, file], check=True)  # one thing at a time: several at once mix up their words
        file.chmod(0o755)
    return [*compiled, *(folder / name for name in renamed.values())]


def packed(tree: pathlib.Path, wheel: pathlib.Path) -> None:
    """Writes the list of files with their checksums, and the wheel; its bytes depend on its files alone."""
    stamp = time.gmtime(max(int(os.environ.get("SOURCE_DATE_EPOCH", "0")), 315532800))[:6]
    record = next(tree.glob("*.dist-info")) / "RECORD"
    files = sorted(file for file in tree.rglob("*") if file.is_file() and file != record)
    lines = []
    for file in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=").decode()
        lines.append(f"{file.relative_to(tree)},sha256={digest},{file.stat().st_size}\n")
    record.write_text("".join(lines) + f"{record.relative_to(tree)},,\n")
    with zipfile.ZipFile(wheel, "w") as archive:
        for file in (*files, record):
            entry = zipfile.ZipInfo(str(file.relative_to(tree)), stamp)
            entry.external_attr = (0o100755 if os.access(file, os.X_OK) else 0o100644) << 16
            archive.writestr(entry, file.read_bytes(), zipfile.ZIP_DEFLATED)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("wheel", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        tree = pathlib.Path(temporary)
        with zipfile.ZipFile(given.wheel) as archive:
            for entry in archive.infolist():
                pathlib.Path(archive.extract(entry, tree)).chmod((entry.external_attr >> 16) & 0o777 or 0o644)
        version = max(map(glibc, take_in(tree)))
        *name, platform = given.wheel.stem.split("-")
        new = re.sub(r"^linux", f"manylinux_{version[0]}_{version[1]}", platform)
        about = next(tree.glob("*.dist-info")) / "WHEEL"
        about.write_text(about.read_text().replace(f"-{platform}\n", f"-{new}\n"))
        given.folder.mkdir(exist_ok=True)
        wheel = given.folder / f"{'-'.join([*name, new])}.whl"
        part = wheel.with_suffix(".part")  # so that a wheel that is there is whole
        packed(tree, part)
        part.replace(wheel)


if __name__ == "__main__":
    main()
