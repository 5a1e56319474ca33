# Sourced by the tests of reproducibility: results of every tool, and their comparison.
# shellcheck shell=sh

# results DIR: a result of each tool and of each of its ways into DIR; the tools are those on PATH.
# Ends with a status that is not 0 if one fails.  stderr goes to DIR/said.
# shellcheck disable=SC2154 # top is of tap.sh
results()
{
    mkdir -p "$1" && (
        cd "$1" || exit 1
        cases=$top/scripts/experiments
        cp "$cases/ben-ahin/case.ini" stay.ini
        cp "$cases/seil2-whirl/case.ini" rope.ini
        cp "$cases/lifts/cases.csv" lifts.csv
        cp -R "$cases/nets/mooring" "$cases/nets/current" .
        "$top/scripts/wire/helix" spring
        printf 'motion deck.omega\n8.7\n9.1\n9.5\n' >points.csv
        printf 'cable.area\n8e-3\n8.5e-3\n' >areas.csv
        set -e
        exec 2>said
        catenary -o line.csv stay.ini
        catenary --summary -o summary.csv stay.ini
        catenary --stiffness --set 'load.wind=0 0 50' -o stiffness.csv stay.ini
        modal --solver dense -d model -o modes.csv stay.ini
        modal --solver lanczos --modes 10 --participation --damped -o few.csv \
            --set mesh.elements=400 stay.ini
        diffverf -d model --energy --field field.npy --state state -o response.csv \
            --set time.end=5 stay.ini
        diffverf --set time.scheme=alpha --set time.end=5 -o alpha.csv stay.ini
        diffverf --points points.csv --set time.end=20 -o steady.csv rope.ini || [ $? -eq 1 ]
        stabil --set stability.ratio_step=0.05 -o map.csv rope.ini
        stabil --growth --set stability.method=floquet --set stability.ratio_step=0.1 \
            -o growth.csv rope.ini
        sling --exact -o lifts.exact.csv lifts.csv || [ $? -eq 1 ]
        sling -o lifts.plain.csv lifts.csv || [ $? -eq 1 ]
        gapnet -d mooring.out mooring/system.ini
        gapnet -d current.out current/system.ini
        gapcheck -o proof.csv mooring.out
        wirebeam --modes 3 -d spring.out spring/case.ini
        "$top/scripts/study" --print-table --latin 20 --vary cable.area=8e-3:9e-3 >latin.csv
    )
}

# alike ONE OTHER REL ABS: every table and array of ONE is in OTHER, with the same numbers within
# these tolerances; what is not is printed, and makes the status 1.  The proof of gapcheck is left
# out: its residuals are rounding alone, and it judges them itself.
# shellcheck disable=SC2154 # compare is of tap.sh
alike()
{
    (cd "$1" && find . -name '*.csv' -o -name '*.npy') | sort | grep -v '^./proof.csv$' | {
        bad=0
        while IFS= read -r file; do
            "$compare" -r "$3" -a "$4" "$1/$file" "$2/$file" || bad=1
        done
        exit $bad
    }
}
