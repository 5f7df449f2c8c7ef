"""Makes a wheel of the built package: no network, no other package.

usage: make_wheel.py FOLDER OUT VERSION      FOLDER: the built package, with its module
"""

import base64
import hashlib
import pathlib
import sys
import sysconfig
import zipfile


def digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def main(folder, out, version):
    folder, out = pathlib.Path(folder), pathlib.Path(out)
    abi = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    tag = f"{abi}-{abi}-{platform}"
    info = f"rigor-{version}.dist-info"
    files = {f"rigor/{path.name}": path.read_bytes() for path in sorted(folder.iterdir()) if path.is_file()}
    files[f"{info}/METADATA"] = (f"Metadata-Version: 2.1\nName: rigor\nVersion: {version}\n"
                                 "Summary: Rigid-body dynamics whose answers can be trusted\n"
                                 "License: Apache-2.0\nRequires-Python: >=3.9\nRequires-Dist: numpy\n").encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: rigor\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    record = "".join(f"{name},sha256={digest(data)},{len(data)}\n" for name, data in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()

    out.mkdir(parents=True, exist_ok=True)
    wheel = out / f"rigor-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            # Same files, same bytes.
            entry = zipfile.ZipInfo(name, date_time=(2020, 1, 1, 0, 0, 0))
            entry.external_attr = 0o755 << 16 if name.endswith(".so") else 0o644 << 16
            archive.writestr(entry, data, zipfile.ZIP_DEFLATED)
    print(wheel)


if __name__ == "__main__":
    main(*sys.argv[1:])
