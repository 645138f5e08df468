package org.u2sa.recorder;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.recorder.execution.ExecutionStart;

/**
 * Attaches the files of a run to its recording: the system file, its configurations, the XML files
 * they name (mission, fence, world, …) and the logs.
 */
public final class RunFiles {
  private static final int FOLDERS_IN_NAME = 3;

  private final RecordingFacts facts;
  private final Set<Path> attached = new HashSet<>();

  /**
   * @param facts receives the files
   */
  public RunFiles(RecordingFacts facts) {
    this.facts = facts;
  }

  /**
   * Attaches a system file, its configurations and the files they name.
   *
   * @param configurations configurations of its services and of the Communication Manager
   * @throws org.u2sa.interfaces.BadInputException if a configuration is not well-formed
   */
  public RunFiles system(Path file, Collection<Path> configurations) {
    attach(file);
    configurations.forEach(this::configuration);
    return this;
  }

  private void configuration(Path file) {
    attach(file);
    XmlElement root = XmlReader.read(file, "configuration");
    for (XmlElement variable : root.children("variable")) {
      variable
          .optionalAttribute("value")
          .ifPresent(value -> attachIfFile(file.toAbsolutePath().getParent(), value));
    }
  }

  /** Attaches the file named by a variable if it is to be recorded. */
  public void attachIfFile(Path folder, String value) {
    if (!ExecutionStart.isRecorded(value)) {
      return;
    }
    try {
      Path file = folder.resolve(value);
      if (Files.isRegularFile(file)) {
        attach(file);
      }
    } catch (InvalidPathException e) {
      facts.say("not-attached", value, e.getMessage());
    }
  }

  private void attach(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    attach(name(absolute), absolute);
  }

  /** Attaches a file under a unique name, unless already attached. */
  public void attach(String name, Path file) {
    if (attached.add(file.toAbsolutePath().normalize())) {
      facts.attach(name, file);
    }
  }

  /** Attaches the logs of a folder in their state at the end of the recording. */
  public RunFiles logs(Path folder) {
    facts.attachAtEnd(() -> logsIn(folder));
    return this;
  }

  /** File name with its two parent folders, such as {@code config/ugv/system.xml}. */
  private static String name(Path file) {
    int names = file.getNameCount();
    return file.subpath(Math.max(0, names - FOLDERS_IN_NAME), names).toString().replace('\\', '/');
  }

  private static Map<String, Path> logsIn(Path folder) {
    if (!Files.isDirectory(folder)) {
      return Map.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> file.getFileName().toString().endsWith(".log"))
          .collect(
              Collectors.toMap(
                  file -> "logs/" + file.getFileName(), file -> file, (a, b) -> a, TreeMap::new));
    } catch (IOException e) {
      throw new UncheckedIOException("cannot list " + folder, e);
    }
  }
}
