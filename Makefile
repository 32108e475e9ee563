# The commands a person runs. Everything is installed from Debian packages and built with CMake;
# see README.md for the CMake options and presets.
SHELL := /bin/bash

# What the program and its tests need, and what only the rivals of the benchmark need.
PACKAGES := g++ cmake ninja-build libtbb-dev libeigen3-dev libnanoflann-dev libspdlog-dev \
            libcli11-dev nlohmann-json3-dev libboost-dev libgtest-dev libgmp-dev libcgal-dev libsqlite3-dev \
            libtomlplusplus-dev nettle-dev pkg-config \
            zlib1g-dev libzip-dev libmatio-dev libhdf5-dev libshp-dev
BENCH_PACKAGES := libbenchmark-dev libgeos-dev libpolyclipping-dev
# The Python module and what its tests compare it with.
PYTHON_PACKAGES := python3-dev python3-venv python3-setuptools python3-wheel python3-build pybind11-dev python3-numpy \
                   python3-pytest python3-hypothesis python3-shapely python3-sympy python3-numba python3-pandas \
                   python3-matplotlib python3-scipy python3-h5py python3-netcdf4 python3-geopandas \
                   python3-xarray python3-distributed mypy

# The site of the documents: Sphinx, Doxygen, what executes the tutorials, and MathJax, which becomes part of the site.
DOCS_PACKAGES := python3-sphinx furo python3-myst-parser python3-sphinx-copybutton python3-nbclient python3-ipykernel \
                 doxygen libjs-mathjax node-normalize.css

.PHONY: demo test ci build bench bench-build bench-batch python python-debug python-asan python-functions docs docs-deps docs-figures docs-check paper check-readme stress fuzz trust deps bench-deps python-deps format tidy clean

demo:
	@echo "Installs what it needs (root or sudo), builds the program and runs it: about three minutes on two cores, seconds the next time."
	@$(MAKE) --no-print-directory build
	@scripts/demo.sh

# The documents as a site, build/docs/html: some minutes after make build and make python, without the network.
docs: docs-deps
	cmake --preset release -DLOBER_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
	cmake --build --preset release --target lober lober_python
	@scripts/python-install.sh build
	@scripts/site.sh build

# The figures and the numbers of all documents, from the program and from bench/RESULTS.md: some minutes on two cores.
# docs-check makes them elsewhere and fails when a committed one differs; make test does so for those that take seconds.
docs-figures: build
	@scripts/docs.sh make

docs-check: build
	@scripts/docs.sh check

# The figures and tables of Naik, Lekien & Ross (2017), into docs/paper: minutes on two cores, the same bytes each time.
paper: build
	@scripts/paper.sh

# Every command and code block of README.md, executed.
check-readme: build
	@scripts/check-readme.sh

test: deps
	cmake --preset release
	cmake --build --preset release
	@scripts/run-tests.sh build

# What the project's CI runs (.ci/run), and clang, sanitizers, fuzz targets and clang-tidy; see scripts/ci.sh.
ci:
	@LOBER_CI_ALL=1 .ci/run

build: deps
	cmake --preset release
	cmake --build --preset release --target lober

# The Python module, its installation into a virtual environment and its tests.
python: python-deps
	cmake --preset release -DLOBER_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
	@scripts/python.sh build

# The same tests under the debug build of Python, which checks reference counts and the GIL; some minutes.
python-debug: python
	@scripts/install-packages.sh python3-dbg
	@scripts/python-debug.sh build

python-asan: python-deps
	@scripts/python-asan.sh

.PHONY: deb wheel packages-check
# Debian packages in build/packages: another machine needs nothing of this folder.
deb:
	@scripts/packages.sh

# A wheel of the Python package in build/wheel, for this Python.
wheel: python-deps
	@scripts/packages-wheel.sh

# The packages on a clean Debian 12, and built there again: root, the network, a quarter of an hour.
packages-check: deb
	@scripts/packages-check.sh

# The functions of the Python package that follow from the engine's table.
python-functions: python-deps
	cmake --preset release -DLOBER_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
	cmake --build --preset release --target lober_python
	@scripts/python-functions.sh build

# Only whether they compile.
bench-build: bench-deps
	cmake --preset bench
	cmake --build --preset bench

bench: bench-build
	@scripts/bench.sh

# Throughput of the batch engine, against a shell loop and GEOS: a few minutes.
bench-batch: bench-deps
	cmake --preset bench
	cmake --build --preset bench --target bench_batch
	build/bin/bench_batch

# A million random pairs with new seeds, ten times what the tests run, tangles and winding regions, the coverage of the
# error bars, batches that are killed: about eight minutes on two cores.
stress: deps
	cmake --preset release
	cmake --build --preset release
	@scripts/stress.sh

# Each reader under ASan and UBSan for ten minutes.
fuzz: deps
	@scripts/install-packages.sh clang libclang-rt-14-dev
	cmake --preset fuzz
	cmake --build --preset fuzz
	@scripts/fuzz.sh

# docs/trust.md: the cases of public trackers by lober, GEOS, two versions of Boost.Geometry and Clipper.
trust: bench-deps
	@scripts/trust.sh boost
	cmake --preset bench -DLOBER_NEWER_BOOST=$(CURDIR)/build/boost/usr/include
	cmake --build --preset bench --target lober bench_trackers trackers_geos trackers_boost trackers_boost_newer trackers_clipper
	@scripts/trust.sh make

deps:
	@scripts/install-packages.sh $(PACKAGES)

bench-deps: deps
	@scripts/install-packages.sh $(BENCH_PACKAGES)

python-deps: deps
	@scripts/install-packages.sh $(PYTHON_PACKAGES)

docs-deps: python-deps
	@scripts/install-packages.sh $(DOCS_PACKAGES)

format:
	git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

tidy:
	cmake -S . -B build-tidy -G Ninja -DCMAKE_BUILD_TYPE=Release -DLOBER_UNITY=OFF
	git ls-files 'kernels/*.cpp' 'engine/*.cpp' 'cli/*.cpp' | xargs clang-tidy -p build-tidy --quiet --extra-arg=-Wno-unknown-warning-option

clean:
	rm -rf build build-* out
