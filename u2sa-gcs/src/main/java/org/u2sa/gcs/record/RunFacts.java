package org.u2sa.gcs.record;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.command.ProgramVersion;
import org.u2sa.gcs.remote.RemoteSystem;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.recorder.RecordingFacts;

/**
 * What a recording says of its run: versions and host, the system file and its configurations, and
 * whatever files these name, such as mission, fence and world.
 */
public final class RunFacts {
  private static final int FOLDERS_IN_NAME = 3;

  private final RecordingFacts facts = new RecordingFacts();
  private final Set<Path> attached = new HashSet<>();

  /** Facts about any recording that this program makes. */
  public RunFacts() {
    facts.say("run", "program", "u2sa " + ProgramVersion.text());
    facts.say("host", "operator", RemoteSystem.operator());
    facts.say("host", "java", System.getProperty("java.version", "unknown"));
    facts.say(
        "host",
        "os",
        System.getProperty("os.name", "unknown") + " " + System.getProperty("os.arch", ""));
    facts.say(
        "host",
        "started",
        Instant.ofEpochSecond(TimeUnit.MICROSECONDS.toSeconds(new SystemClock().micros()))
            .toString());
  }

  /** Says something more of the run. */
  public RunFacts say(String name, String text) {
    facts.say("run", name, text);
    return this;
  }

  /** Says that a variable is set for this run only, and attaches the file that it names, if any. */
  public RunFacts setting(String service, String variable, Object value) {
    String text = String.valueOf(value);
    facts.say("settings", service + ":" + variable, text);
    attachIfFile(Path.of(""), text);
    return this;
  }

  /** Attaches a system file, its configurations, and the files that these name. */
  public RunFacts system(SystemFile system) {
    attach(system.file());
    system.communication().ifPresent(this::attachConfiguration);
    system.services().stream()
        .map(SystemFile.Entry::configuration)
        .flatMap(Optional::stream)
        .forEach(this::attachConfiguration);
    return this;
  }

  /** Attaches the mission that is pursued, which may stand elsewhere than is configured. */
  public RunFacts mission(Path file) {
    attach("pursued-mission/" + file.getFileName(), file);
    return this;
  }

  /** Attaches the file that says what stands and moves around the vehicle. */
  public RunFacts world(Path file) {
    attach("world/" + file.getFileName(), file);
    return this;
  }

  private void attach(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    attach(name(absolute), absolute);
  }

  private void attach(String name, Path file) {
    if (attached.add(file.toAbsolutePath().normalize())) {
      facts.attach(name, file);
    }
  }

  /** Attaches the logs of a folder as they are when the recording ends. */
  public RunFacts logs(Path folder) {
    facts.attachAtEnd(() -> logsIn(folder));
    return this;
  }

  /** All of it, for a recorder. */
  public RecordingFacts facts() {
    return facts;
  }

  private void attachConfiguration(Path file) {
    attach(file);
    XmlElement root = XmlReader.read(file, "configuration");
    for (XmlElement variable : root.children("variable")) {
      variable
          .optionalAttribute("value")
          .ifPresent(value -> attachIfFile(file.toAbsolutePath().getParent(), value));
    }
  }

  /** What a variable names is a file if there is one: only its service knows what it means. */
  private void attachIfFile(Path folder, String value) {
    if (!value.endsWith(".xml")) {
      return; // passwords and keys are files too, and have no place in a recording
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

  /** The file's name with its two folders, such as {@code config/ugv/system.xml}. */
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
