#!/usr/bin/python3
"""What the program is made of and linked with, as SPDX 2.3 in JSON: sbom.py PROGRAM --commit HASH [--wheel FILE]

Shared libraries are those that the program names (objdump), with the Debian package of each; libraries that are compiled in and tools of
the build are the packages of tools/setup.sh; packages of npm are those of viewer/package-lock.json; a wheel names the libraries that
it contains itself (tools/wheel_libraries.py). SOURCE_DATE_EPOCH is the time.
"""
import argparse
import base64
import datetime
import hashlib
import json
import os
import pathlib
import re
import subprocess
import uuid
import zipfile

root = pathlib.Path(__file__).resolve().parent.parent
contained_from_npm = {"plotly.js-cartesian-dist-min"}  # NOTICES; all others of npm are tools


def output(*command: str) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def shared_libraries(program: pathlib.Path) -> list[str]:
    """The files of the libraries that the program itself names."""
    needed = re.findall(r"^\s+NEEDED\s+(\S+)", output("objdump", "-p", str(program)), re.MULTILINE)
    paths = dict(re.findall(r"^\s*(\S+) => (\S+)", output("ldd", str(program)), re.MULTILINE))
    return [paths[name] for name in needed]


def package_of(file: str) -> str:
    """Debian records a file below /usr/lib or, from before that merge, below /lib."""
    real = os.path.realpath(file)
    for path in dict.fromkeys((file, real, real.removeprefix("/usr"), file.removeprefix("/usr"))):
        found = subprocess.run(["dpkg-query", "-S", path], capture_output=True, text=True)
        if found.returncode == 0:
            return found.stdout.split(": ")[0].split(",")[0]
    raise SystemExit(f"{file} is of no Debian package")


def packages_to_build() -> list[str]:
    text = (root / "tools" / "setup.sh").read_text(encoding="utf-8")
    return re.findall(r"^([^:\n]+):", re.search(r'packages_to_build="\n(.*?)"', text, re.DOTALL)[1], re.MULTILINE)


def spdx_id(*parts: str) -> str:
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", "-".join(parts))


def of_debian(package: str) -> dict:
    """A package that is installed."""
    fields = "${Package}\t${Version}\t${Architecture}\t${source:Package}\t${source:Version}\t${Homepage}"
    name, version, architecture, source, source_version, home = output("dpkg-query", "-W", "-f", fields, package).split("\t")
    return {"SPDXID": spdx_id("deb", name), "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False, "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION", "copyrightText": "NOASSERTION",
            **({"homepage": home} if home else {}), "sourceInfo": f"Debian source package {source} {source_version}",
            "licenseComments": f"/usr/share/doc/{name}/copyright on Debian",
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                              "referenceLocator": f"pkg:deb/debian/{name.replace('+', '%2B')}@{version.replace('+', '%2B').replace(':', '%3A')}?arch={architecture}&distro=bookworm"}]}


def of_npm(place: str, entry: dict) -> dict:
    """An entry of the lock file."""
    name = entry.get("name", place.rpartition("node_modules/")[2])
    checksums = []
    for algorithm, _, digest in (one.partition("-") for one in entry.get("integrity", "").split()):
        checksums.append({"algorithm": algorithm.upper(), "checksumValue": base64.b64decode(digest).hex()})
    licence = entry.get("license", "NOASSERTION")
    return {"SPDXID": spdx_id("npm", place.removeprefix("node_modules/"), entry["version"]), "name": name, "versionInfo": entry["version"],
            "downloadLocation": entry.get("resolved", "NOASSERTION"), "filesAnalyzed": False,
            **({"checksums": checksums} if checksums else {}), "licenseConcluded": "NOASSERTION", "licenseDeclared": licence,
            "copyrightText": "NOASSERTION",
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                              "referenceLocator": f"pkg:npm/{name.replace('@', '%40')}@{entry['version']}"}]}


def of_wheel(wheel: pathlib.Path, version: str) -> tuple[dict, set[str]]:
    """The wheel, and the Debian packages whose libraries it contains."""
    with zipfile.ZipFile(wheel) as archive:
        listed = archive.read("matrigrate.libs/LIBRARIES").decode().splitlines()[2:]
    digest = hashlib.sha256(wheel.read_bytes()).hexdigest()
    return {"SPDXID": "SPDXRef-wheel", "name": wheel.name, "versionInfo": version, "packageFileName": wheel.name,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "checksums": [{"algorithm": "SHA256", "checksumValue": digest}],
            "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION", "copyrightText": "NOASSERTION"}, {line.split()[1] for line in listed}


def document(program: pathlib.Path, commit: str, wheel: pathlib.Path | None) -> dict:
    version = re.search(r"project\(matrigrate VERSION (\S+)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    ours = {"SPDXID": "SPDXRef-matrigrate", "name": "matrigrate", "versionInfo": version, "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False, "licenseConcluded": "BSD-3-Clause", "licenseDeclared": "BSD-3-Clause",
            "copyrightText": re.search(r"Copyright.*", (root / "LICENSE").read_text(encoding="utf-8"))[0], "primaryPackagePurpose": "APPLICATION",
            "sourceInfo": f"git commit {commit}"}
    packages = {ours["SPDXID"]: ours}
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", ours["SPDXID"])]

    def add(package: dict, relation: str, backwards: bool = False) -> None:
        packages[package["SPDXID"]] = package
        ends = (package["SPDXID"], ours["SPDXID"]) if backwards else (ours["SPDXID"], package["SPDXID"])
        relations.append((ends[0], relation, ends[1]))

    for package in sorted({package_of(file) for file in shared_libraries(program)}):
        add(of_debian(package), "DYNAMIC_LINK")
    for package in sorted(packages_to_build()):
        if subprocess.run(["dpkg-query", "-W", package], capture_output=True).returncode == 0:  # npm may come from elsewhere
            add(of_debian(package), "BUILD_DEPENDENCY_OF" if package.endswith("-dev") else "BUILD_TOOL_OF", backwards=True)
    lock = json.loads((root / "viewer" / "package-lock.json").read_text(encoding="utf-8"))
    for place, entry in sorted(lock["packages"].items()):
        if place:
            package = of_npm(place, entry)
            contained = package["name"] in contained_from_npm
            add(package, "CONTAINS" if contained else "DEV_DEPENDENCY_OF", backwards=not contained)
    if wheel:
        package, inside = of_wheel(wheel, version)
        add(package, "GENERATED_FROM", backwards=True)
        for one in map(of_debian, sorted(inside)):
            packages[one["SPDXID"]] = one
            relations.append((package["SPDXID"], "CONTAINS", one["SPDXID"]))
    content = [packages[key] for key in sorted(packages)]
    created = datetime.datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), datetime.timezone.utc)
    mark = uuid.uuid5(uuid.NAMESPACE_URL, commit + json.dumps(content, sort_keys=True))
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"matrigrate-{version}",
            "documentNamespace": f"https://spdx.org/spdxdocs/matrigrate-{version}-{mark}",
            "creationInfo": {"created": created.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": ["Organization: The Matrigrate authors", "Tool: tools/sbom.py"]},
            "packages": content,
            "relationships": [{"spdxElementId": a, "relationshipType": relation, "relatedSpdxElement": b} for a, relation, b in sorted(relations)]}


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("program", type=pathlib.Path)
    options.add_argument("--commit", required=True)
    options.add_argument("--wheel", type=pathlib.Path)
    given = options.parse_args()
    print(json.dumps(document(given.program, given.commit, given.wheel), indent=1))


if __name__ == "__main__":
    main()
