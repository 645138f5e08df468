package org.u2sa.spark;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import org.u2sa.trials.campaign.RunBackend;
import org.u2sa.trials.campaign.WorkerProcess;

/** The start-up files of {@link SparkDriver}, in a temporary folder that is deleted on close. */
final class DriverFiles implements AutoCloseable {
  private static final String OURS_FOR_SPARK = "-Dspark.";

  /**
   * The JVM options for Spark's reflective access to the JDK, as in {@code
   * org.apache.spark.launcher.JavaModuleOptions}.
   */
  private static final List<String> OPENED =
      List.of(
          "java.lang",
          "java.lang.invoke",
          "java.lang.reflect",
          "java.io",
          "java.net",
          "java.nio",
          "java.util",
          "java.util.concurrent",
          "java.util.concurrent.atomic",
          "jdk.internal.ref",
          "sun.nio.ch",
          "sun.nio.cs",
          "sun.security.action",
          "sun.util.calendar");

  private final Path folder;

  private DriverFiles(Path folder) {
    this.folder = folder;
  }

  /** Writes the files; requests are one line per run. */
  static DriverFiles prepare(List<String> requests) throws IOException {
    DriverFiles files = new DriverFiles(Files.createTempDirectory("u2sa-spark"));
    Files.write(files.requests(), requests);
    Files.write(
        files.javaOptions(),
        WorkerProcess.javaOptions().stream().filter(DriverFiles::isPortable).toList());
    ProgramArchive.write(
        files.program(),
        System.getProperty("java.class.path"),
        Path.of(System.getProperty("u2sa.home", "")));
    return files;
  }

  /** Whether a JVM option is also valid on another host. */
  private static boolean isPortable(String option) {
    return !option.startsWith(OURS_FOR_SPARK)
        && !option.startsWith("-Du2sa.home=")
        && !option.startsWith("-javaagent:")
        && !option.startsWith("-agent");
  }

  private Path requests() {
    return folder.resolve("requests");
  }

  private Path javaOptions() {
    return folder.resolve("java-options");
  }

  private Path program() {
    return folder.resolve("u2sa.zip");
  }

  List<String> command(SparkHome home, SparkMaster master, String localAddress) throws IOException {
    List<String> ours = new ArrayList<>();
    for (Class<?> type : List.of(SparkDriver.class, RunBackend.class)) {
      ours.add(ProgramArchive.jarOf(type, folder).toString());
    }
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-XX:+IgnoreUnrecognizedVMOptions");
    OPENED.forEach(name -> command.add("--add-opens=java.base/" + name + "=ALL-UNNAMED"));
    command.add("-Dspark.master=" + master.text());
    command.add("-Dspark.app.name=u2sa campaign");
    command.add("-Dspark.jars=" + String.join(",", ours));
    command.add("-Dspark.archives=" + program() + "#" + ExecutorWorkers.PROGRAM);
    command.add("-Dspark.driver.host=" + localAddress);
    command.add("-Dspark.driver.bindAddress=" + localAddress);
    command.add("-Dspark.driver.maxResultSize=0"); // results contain the runs' files
    command.add("-Dspark.ui.enabled=false");
    command.add("-Dspark.log.level=WARN");
    WorkerProcess.javaOptions().stream()
        .filter(option -> option.startsWith(OURS_FOR_SPARK))
        .forEach(command::add); // later options win
    command.add("-cp");
    command.add(String.join(File.pathSeparator, ours) + File.pathSeparator + home.jars() + "/*");
    command.add(SparkDriver.class.getName());
    command.add(requests().toString());
    command.add(javaOptions().toString());
    return command;
  }

  @Override
  public void close() throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }
}
