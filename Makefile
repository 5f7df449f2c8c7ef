# Rigor in two commands: `make run` and `make test`. Both install what they need (Debian 12), configure and build.
# Everything else: `make help`.
JOBS ?= $(shell nproc)
BUILD := build/release
RIGOR := $(BUILD)/rigor

.PHONY: run test build program package python check check-all bench bench-bulk setup configure clean help

run: program
	@mkdir -p out
	@$(RIGOR) run scenes/turntable.yaml -o out/turntable.html -o out/turntable.png
	@echo
	@$(RIGOR) run scenes/cradle.yaml -o out/cradle.html -o out/cradle.png
	@echo
	@echo "To look at them, open these pages in a browser (no network needed), or the pictures:"
	@echo "  out/turntable.html   out/turntable.png"
	@echo "  out/cradle.html      out/cradle.png"
	@echo
	@echo "What next:"
	@echo "  $(RIGOR) run scenes/bouncing_ball.yaml -o ball.html      any scene in scenes/; output as .html, .png, .csv, .h5 or .json"
	@echo "  $(RIGOR) render scenes/dominoes.yaml -o dominoes.png     pictures of any scene or trajectory"
	@echo "  $(RIGOR) run scenes/cradle.yaml --set materials.steel.restitution=0.5"
	@echo "  $(RIGOR) check scenes/*.yaml                             validate scenes only"
	@echo "  $(RIGOR) methods                                         every method by name, with its source"
	@echo "  docs/scene.md                                            how to write a scene of your own"

build: configure
	@cmake --build --preset release -j $(JOBS)

program: configure
	@cmake --build --preset release -j $(JOBS) --target rigor

package: program
	@cmake --build --preset release -j $(JOBS) --target rigor_library_rigor
	@if [ -d $(BUILD)/python ]; then cmake --build --preset release -j $(JOBS) --target rigor_python; fi
	@cmake --build --preset release --target package

python: setup
	@tools/setup.sh python
	@cmake --preset release >/dev/null
	@cmake --build --preset release -j $(JOBS) --target rigor_wheel

test: build
	@ctest --preset release -j $(JOBS)

setup:
	@tools/setup.sh build

configure: setup
	@[ -f $(BUILD)/build.ninja ] || cmake --preset release

check: program
	@tools/setup.sh check
	@tools/check.sh $(JOBS)

check-all: program
	@tools/setup.sh check
	@tools/check.sh $(JOBS) all

bench:
	@tools/setup.sh build
	@tools/setup.sh bench
	@cmake --preset bench >/dev/null
	@cmake --build --preset bench -j $(JOBS)
	@build/bench/benchmarks/rigor_bench
	@build/bench/benchmarks/rigor_render_bench
	@build/bench/benchmarks/rigor_impact_bench
	@build/bench/benchmarks/rigor_constrained_mass_bench
	@build/bench/benchmarks/rigor_resting_bench
	@build/bench/benchmarks/rigor_heap_bench
	@build/bench/benchmarks/rigor_chain_bench
	@build/bench/benchmarks/rigor_convex_bench
	@build/bench/benchmarks/rigor_coherent_bench
	@build/bench/benchmarks/rigor_broad_phase_bench
	@build/bench/benchmarks/rigor_mesh_bench

bench-bulk:
	@tools/setup.sh build
	@tools/setup.sh bench-bulk
	@cmake --preset bench >/dev/null
	@cmake --build --preset bench -j $(JOBS) --target rigor_bulk_bench
	@build/bench/benchmarks/rigor_bulk_bench

clean:
	rm -rf build

help:
	@echo "make run     build the program, then run two scenes, show their audits and leave their replays as pages and pictures in out/"
	@echo "make test    build, then all tests"
	@echo "make build   build all, the program and its tests (Release, in $(BUILD))"
	@echo "make program  build only the program, $(RIGOR)"
	@echo "make package  a Debian package and a tarball of program, libraries and headers, in $(BUILD)/packages"
	@echo "make python  the Python package as a wheel, in $(BUILD)/wheels; installs pybind11, numpy and pytest of Debian"
	@echo "make check   formatting, headers alone, clang++ with warnings as errors, its ASan and UBSan under the program and some tests, the viewer"
	@echo "make check-all  the same with the tests of all layers under ASan and UBSan"
	@echo "make bench   error and CPU time of the reference scenes, of pictures, impacts, chains, resting contact, heaps, distances and the broad phase, beside the peer engines that are installed"
	@echo "make bench-bulk  scenes of many bodies: time per step with one and two threads and quality, beside Bullet"
	@echo "make clean   remove build/"
