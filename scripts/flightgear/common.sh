# Shared by start and stop; sourced, never run. Where an instance keeps its files, and questions to /proc.
# An instance is named by its in-port: no two can have the same one.

cache_dir="${XDG_CACHE_HOME:-$HOME/.cache}/u2sa/flightgear"

run_dir_of() { # in-port
  echo "$cache_dir/run/$1"
}

# True if a TCP socket of this machine listens on the port. Read from /proc: a probing connection would end
# FlightGear's in channel for good.
listening() { # port
  local hex
  hex=$(printf ':%04X' "$1")
  cat /proc/net/tcp /proc/net/tcp6 2>/dev/null \
    | awk -v port="$hex" '$4 == "0A" && substr($2, length($2) - 4) == port { found = 1 } END { exit !found }'
}

# The kernel's start tick of a process: together with the pid it names one process, also after pids were used again.
start_tick() { # pid
  sed 's/.*) //' "/proc/$1/stat" 2>/dev/null | cut -d' ' -f20
}

# True if the process of a pid file's line ("pid tick") still lives.
same_process() { # pid tick
  [ -n "$1" ] && [ -n "$2" ] && [ "$(start_tick "$1")" = "$2" ]
}
