# Rigor in two commands: `make run` and `make test`. Both install what they need (Debian 12), configure and build.
# Everything else: `make help`.
JOBS ?= $(shell nproc)
BUILD := build/release
RIGOR := $(BUILD)/rigor

.PHONY: run test build program package python docs check check-all bench bench-bulk setup configure clean help

# A scene with its page, its sheet of key moments, its film where ffmpeg is there, and its audit as a text: the heart of it
# is shown.
films := $(if $(shell command -v ffmpeg),yes)
define show
@echo; echo "$(2)"
@$(RIGOR) run scenes/$(1).yaml -o out/$(1).html -o out/$(1).png $(if $(films),-o out/$(1).mp4) >out/$(1).txt
@sed -n '1p; /^  events/p; /^  energy/p; /^  penetration/p; /audit/p' out/$(1).txt
endef

run: setup
	@[ -x $(RIGOR) ] || echo "Building the program: some six minutes on two cores, counted below in brackets. Then it runs two scenes."
	@$(MAKE) --no-print-directory program
	@mkdir -p out
	$(call show,chain_reaction,A swing strikes thirteen dominoes and the last one pushes a ball down a slide into a tower:)
	$(call show,newtons_cradle,Newton's cradle on strings; one ball in and one ball out under gravity:)
	@echo
	@echo "Each has left in out/ a page that plays in any browser (no network needed), pictures and its audit:"
	@ls -1 out/chain_reaction.* out/newtons_cradle.* | sed 's/^/  /'
	@echo
	@echo "What next:"
	@echo "  $(RIGOR) view scenes/chain_reaction.yaml --open          live in the browser: pull a domino, change gravity or friction"
	@echo "  $(RIGOR) run scenes/hopper.yaml --duration 1 -o hopper.html    any scene in scenes/; output as .html .png .mp4 .csv .h5 .json"
	@echo "  $(RIGOR) run scenes/newtons_cradle.yaml --set materials.steel.restitution=0.9"
	@echo "  $(RIGOR) help                                            all commands; 'help run' for one"
	@echo "  docs/tutorial.md                                         a scene of your own in ten steps"

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

docs:
	@tools/setup.sh docs
	@tools/make_docs.sh build/docs

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
	@build/bench/benchmarks/rigor_coulomb_bench
	@build/bench/benchmarks/rigor_heap_bench 300
	@benchmarks/scene_bars.py
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
	@echo "make run     build the program, then run two scenes and leave their audits, replays as pages, pictures and films in out/"
	@echo "make test    build, then all tests"
	@echo "make build   build all, the program and its tests (Release, in $(BUILD))"
	@echo "make program  build only the program, $(RIGOR)"
	@echo "make package  a Debian package and a tarball of program, libraries and headers, in $(BUILD)/packages"
	@echo "make python  the Python package as a wheel, in $(BUILD)/wheels; installs pybind11, numpy, matplotlib and pytest of Debian"
	@echo "make docs    the reference of the public C++ headers as a site, build/docs/html/index.html; installs Doxygen of Debian"
	@echo "make check   formatting, headers alone, clang++ with warnings as errors, its ASan and UBSan under the program and some tests, the viewer"
	@echo "make check-all  the same with the tests of all layers under ASan and UBSan"
	@echo "make bench   error and CPU time of the reference scenes, of pictures, impacts, chains, resting contact, heaps, whole scenes, distances and the broad phase, beside the peer engines that are installed"
	@echo "make bench-bulk  scenes of many bodies: time per step with one and two threads and quality, beside Bullet"
	@echo "make clean   remove build/"
