"""The packages; all else is in pyproject.toml, which cannot name one that lies elsewhere."""

from setuptools import find_packages, setup

setup(
    packages=[*find_packages(include=["tsplan*"]), "tsplan.environments"],
    package_dir={"tsplan.environments": "environments"},
)
