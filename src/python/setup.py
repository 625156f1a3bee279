"""Builds the library and the module with CMake, and packs them. README.md here shows the commands.

ECODS_PYTHON_PACKAGE: a folder with a package that CMake has built (build/release/python); it is packed without a build.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ROOT / "build" / "python"


def version():
    text = (ROOT / "include" / "ecods" / "export.hpp").read_text()
    return ".".join(re.findall(r"#define ECODS_VERSION_\w+ (\d+)", text))


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        given = os.environ.get("ECODS_PYTHON_PACKAGE")
        package = pathlib.Path(given) if given else BUILD / "cmake" / "python"
        if not given:
            self.run_cmake()
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(next((package / "ecods").glob("_ecods.*.so")), target)
        for stub in ("__init__.pyi", "_ecods.pyi"):
            shutil.copy(package / "ecods" / stub, target.parent)

    def run_cmake(self):
        import pybind11

        folder = str(BUILD / "cmake")
        options = ["PROGRAMS", "TESTS", "FUZZ", "BENCH", "INSTALL", "WERROR"]
        subprocess.run(
            ["cmake", "-S", str(ROOT), "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DECODS_PYTHON=ON",
             f"-DPython_EXECUTABLE={sys.executable}", f"-Dpybind11_DIR={pybind11.get_cmake_dir()}",
             *[f"-DECODS_{each}=OFF" for each in options]], check=True)
        subprocess.run(
            ["cmake", "--build", folder, "--target", "ecods_python", "--parallel", str(os.cpu_count())], check=True)


BUILD.mkdir(parents=True, exist_ok=True)
setup(
    name="ecods",
    version=version(),
    description="Exact answers about many moving triangle meshes",
    license="MIT",
    python_requires=">=3.9",
    install_requires=["numpy"],
    packages=["ecods", "ecods.compat", "ecods.compat.fcl"],
    package_data={"ecods": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("ecods._ecods", [])],
    cmdclass={"build_ext": BuildWithCMake},
    # Keeps files that the build writes out of the source folders.
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
    zip_safe=False,
)
