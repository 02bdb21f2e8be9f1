#!/usr/bin/env bash
# Finds edges and rocks in every scan of a folder, and checks every result that has a record: examples/batch.sh ARCHIVE RESULTS
# Exits with 0 when everything was done, 3 when a result differs from what its record describes, 4 when some scans were refused.
# EDGESCAN_CLI=PROGRAM: another program than the edgescan-cli of the path.
set -euo pipefail
if [ $# -ne 2 ] || [ ! -d "$1" ]; then echo "usage: examples/batch.sh ARCHIVE RESULTS; ARCHIVE is a folder of scans" >&2; exit 2; fi
cli=$(command -v "${EDGESCAN_CLI:-edgescan-cli}") || { echo "examples/batch.sh: edgescan-cli is missing; install it, or give EDGESCAN_CLI its path" >&2; exit 1; }
cli=$(realpath "$cli")
results=$(realpath -m "$2")
cd "$1" # so that the folders of the results have the names of the scans

status=0
"$cli" batch . -o "$results" --results mask,json,rock-table,edges.ply --rocks || status=$?
[ "$status" -eq 0 ] || [ "$status" -eq 4 ] || exit "$status" # 4: some scans were refused; the others have results

# The results of sub/stones.json are in scans/sub/stones.json; verify looks for the scan in the folder sub. In these names % is written %25.
while IFS= read -r -d '' folder; do
  scan=${folder#"$results/scans/"}
  scan=${scan//%25/%}
  code=0
  "$cli" verify "$folder"/*.provenance.json --scans "$(dirname "$scan")" || code=$?
  [ "$code" -eq 0 ] || [ "$status" -eq 3 ] || status=$code
done < <(find "$results" -name '*.provenance.json' -printf '%h\0' | sort -zu)
exit "$status"
