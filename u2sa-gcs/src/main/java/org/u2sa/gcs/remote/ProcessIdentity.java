package org.u2sa.gcs.remote;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;

/**
 * Distinguishes a process from a later one with the same PID, by its start time.
 *
 * <p>On Linux the start time is relative to boot, identified by the boot ID, because the wall-clock
 * start time reported by Java shifts when the clock is set.
 */
final class ProcessIdentity {
  private static final Path BOOT = Path.of("/proc/sys/kernel/random/boot_id");
  private static final int START_FIELD = 22; // of /proc/PID/stat: proc(5)
  private static final int STATE_FIELD = 3; // the first one after the program's name

  private ProcessIdentity() {}

  /** When the process started, as a word without spaces; empty if no such process runs. */
  static Optional<String> startOf(long pid) {
    Optional<ProcessHandle> process = ProcessHandle.of(pid).filter(ProcessHandle::isAlive);
    if (process.isEmpty()) {
      return Optional.empty();
    }
    try {
      String stat = Files.readString(Path.of("/proc", String.valueOf(pid), "stat"));
      // The program's name is in parentheses, and may itself contain spaces and parentheses.
      String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
      return Optional.of(Files.readString(BOOT).trim() + "/" + fields[START_FIELD - STATE_FIELD]);
    } catch (IOException e) { // not Linux, or it ended just now
      return process
          .filter(ProcessHandle::isAlive)
          .map(alive -> alive.info().startInstant().map(Instant::toString).orElse("unknown"));
    }
  }
}
