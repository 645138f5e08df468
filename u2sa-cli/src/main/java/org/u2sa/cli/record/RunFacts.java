package org.u2sa.cli.record;

import java.nio.file.Path;
import java.time.Instant;
import java.util.concurrent.TimeUnit;
import org.u2sa.cli.command.ProgramVersion;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.remote.Operator;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.recorder.RecordingFacts;
import org.u2sa.recorder.RunFiles;

/**
 * Facts about a run for its recording: versions, host, the system file, its configurations, and the
 * files they name, such as mission, fence and world.
 */
public final class RunFacts {
  private final RecordingFacts facts = new RecordingFacts();
  private final RunFiles files = new RunFiles(facts);

  /** Creates the facts common to all recordings made by this program. */
  public RunFacts() {
    facts.say("run", "program", "u2sa " + ProgramVersion.text());
    facts.say("host", "operator", Operator.name());
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

  /** Adds a fact. */
  public RunFacts say(String name, String text) {
    facts.say("run", name, text);
    return this;
  }

  /** Adds a variable overridden for this run, and attaches the file it names, if any. */
  public RunFacts setting(String service, String variable, Object value) {
    String text = String.valueOf(value);
    facts.say("settings", service + ":" + variable, text);
    files.attachIfFile(Path.of(""), text);
    return this;
  }

  /** Attaches a system file, its configurations and the files they name. */
  public RunFacts system(SystemFile system) {
    files.system(system.file(), system.configurations());
    return this;
  }

  /** Attaches the mission in use, which may differ from the configured one. */
  public RunFacts mission(Path file) {
    files.attach("pursued-mission/" + file.getFileName(), file);
    return this;
  }

  /** Attaches the world file, which describes objects around the vehicle. */
  public RunFacts world(Path file) {
    files.attach("world/" + file.getFileName(), file);
    return this;
  }

  /** Attaches the logs of a folder in their state at the end of the recording. */
  public RunFacts logs(Path folder) {
    files.logs(folder);
    return this;
  }

  /** All facts, for a recorder. */
  public RecordingFacts facts() {
    return facts;
  }
}
