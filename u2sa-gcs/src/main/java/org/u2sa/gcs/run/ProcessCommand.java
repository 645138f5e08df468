package org.u2sa.gcs.run;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.gcs.Main;
import org.u2sa.interfaces.time.SystemClock;

/**
 * How a process of one service is started: {@code u2sa run --only}, with this program's own Java.
 *
 * @param file the system file
 * @param logs where log files go
 * @param seed the run's seed
 * @param settings the {@code --set} options
 */
record ProcessCommand(Path file, Path logs, long seed, List<String> settings) {
  /**
   * The process of one service.
   *
   * @param restart whether it ran before in this run
   */
  ProcessBuilder of(String service, boolean restart) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-XX:+UseSerialGC");
    command.add("-Du2sa.home=" + System.getProperty("u2sa.home", ""));
    command.add(SystemClock.option());
    command.add("-cp");
    command.add(System.getProperty("java.class.path"));
    command.add(Main.class.getName());
    command.addAll(
        List.of(
            "run",
            file.toString(),
            "--only",
            service,
            "--supervised",
            "--logs",
            logs.toString(),
            "--seed",
            String.valueOf(seed)));
    if (restart) {
      command.add("--restart");
    }
    for (String setting : settings) {
      command.add("--set");
      command.add(setting);
    }
    return new ProcessBuilder(command);
  }
}
