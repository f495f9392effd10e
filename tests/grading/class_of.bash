# class_of ROOT FOLDER COUNT: a class as it comes, made up: of ten submissions five are right, three
# have mistakes from tests/misconceptions, one has stubs among right stages, one has a stage that does
# not compile. No two files are the same. Sourced.

class_of() {
  local root=$1 folder=$2 count=$3 i stage file files broken=("$1"/tests/check/broken/*.cpp)
  local -A wrong=() how_many=()
  for file in "$root"/solutions/*/*.cpp; do
    stage=${file##*/} stage=${stage%.cpp}
    files=("$root/tests/misconceptions/submissions/$stage"/*.cpp)
    how_many[$stage]=${#files[@]}
    wrong[$stage]=$(printf '%s\n' "${files[@]}")
  done
  for ((i = 0; i < count; i++)); do
    mkdir -p "$folder/student$i"
    for file in "$root"/solutions/*/*.cpp; do
      stage=${file##*/} stage=${stage%.cpp}
      case $((i % 10)) in
        [5-7]) file=$(sed -n "$((i % how_many[$stage] + 1))p" <<<"${wrong[$stage]}") ;;
        8) [[ $stage == [dp]* ]] && file=$root/labs/${file#"$root"/solutions/} ;;
        9) [[ $stage == point ]] && file=${broken[i % ${#broken[@]}]} ;;
      esac
      { cat "$file" && printf '// %s\n' "$i"; } >"$folder/student$i/$stage.cpp"
    done
  done
}
