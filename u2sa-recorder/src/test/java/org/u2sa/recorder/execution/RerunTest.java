package org.u2sa.recorder.execution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.recorder.execution.AmplifierRun.state;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.disk.LoadedFile;
import org.u2sa.messages.StateInformation;
import org.u2sa.recorder.execution.AmplifierRun.Amplifier;
import org.u2sa.service.ServiceContext;

/** Services that depend on nothing but what they are given. */
class RerunTest {
  @TempDir Path folder;

  private AmplifierRun run;

  @BeforeEach
  void begin() {
    run = new AmplifierRun(folder);
  }

  @Test
  void rerun_sameService_isIdentical() throws Exception {
    run.recordInLockstep(Amplifier::new);
    Rerun.Outcome outcome = run.rerun(Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isBetween(45L, 55L);
    assertThat(state(outcome).same()).isEqualTo(state(outcome).recorded());
  }

  @Test
  void rerun_severalFiles_isIdenticalOverAll() throws Exception {
    run.recorderValues.put("SPLIT TIME", 0.3);
    run.recordInLockstep(Amplifier::new);
    assertThat(run.files).hasSizeGreaterThan(2);
    Rerun.Outcome outcome = run.rerun(Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isBetween(45L, 55L);
  }

  @Test
  void rerun_secondOfSeveralFilesAlone_saysThatTheFirstIsMissing() throws Exception {
    run.recorderValues.put("SPLIT TIME", 0.3);
    run.recordInLockstep(Amplifier::new);
    ExecutionStart start = ExecutionStart.all(run.files).get("Amplifier");
    Rerun.Outcome outcome =
        new Rerun(run.files.subList(1, 2), "Amplifier", start).run(Amplifier::new);
    assertThat(outcome.remarks()).anyMatch(remark -> remark.contains("first file"));
  }

  @Test
  void rerun_recordedInRealTime_isIdentical() throws Exception {
    run.recordInRealTime(Amplifier::new);
    Rerun.Outcome outcome = run.rerun(Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isPositive();
  }

  /** Watches its configuration file, as others do with missions and fences. */
  private static final class Watching extends Amplifier {
    private final LoadedFile<Boolean> file;

    Watching(ServiceContext context) {
      super(context);
      Path watched = context.configuration().file().orElseThrow();
      file = new LoadedFile<>(watched, Files::exists, context.clock());
    }

    @Override
    double value(double of) {
      file.fault();
      return of;
    }
  }

  @Test
  void rerun_serviceThatWatchesAFileInRealTime_isIdentical() throws Exception {
    run.recordInRealTime(Watching::new);
    Rerun.Outcome outcome = run.rerun(Watching::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
  }

  @Test
  void rerun_configurationChangedWhileItRan_isChangedAgain() throws Exception {
    run.recordInLockstep(Amplifier::new);
    List<Double> seen = new ArrayList<>();
    run.rerun(
        context ->
            new Amplifier(context) {
              @Override
              double value(double of) {
                double value = super.value(of);
                if (of > 0.0) {
                  seen.add(value / of);
                }
                return value;
              }
            });
    assertThat(seen.get(0)).isEqualTo(1.5);
    assertThat(seen.get(seen.size() - 1)).isEqualTo(2.5);
    assertThat(folder.resolve("changed.xml")).content().contains("2.5"); // the recorded run's
  }

  /** Publishes the number of its thread, as some do to tell their orders from those of others. */
  private static final class Numbered extends Amplifier {
    Numbered(ServiceContext context) {
      super(context);
    }

    @Override
    double value(double of) {
      return getThreadID();
    }
  }

  @Test
  void rerun_numberOfThreadIsPublished_isIdentical() throws Exception {
    run.recordInLockstep(Numbered::new);
    assertThat(run.rerun(Numbered::new).isIdentical()).isTrue();
  }

  /** Publishes whether a message was taken that its channel does not carry. */
  private static final class Refused extends Amplifier {
    Refused(ServiceContext context) {
      super(context);
    }

    @Override
    double value(double of) {
      return publish(Channels.ACTUATION, new StateInformation().sensorName("wrong")) ? 1.0 : 2.0;
    }
  }

  @Test
  void rerun_messageThatWasRefused_isRefusedAgain() throws Exception {
    run.recordInLockstep(Refused::new);
    Rerun.Outcome outcome = run.rerun(Refused::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
  }

  /** Is cut off from all others at its tenth step. */
  private static final class CutOff extends Amplifier {
    private int steps;

    CutOff(ServiceContext context) {
      super(context);
    }

    @Override
    protected void step(double nowS) {
      if (++steps == 10) {
        abandonByOther();
      }
      super.step(nowS);
    }

    private void abandonByOther() {
      Thread other = new Thread(this::abandon);
      other.start();
      boolean interrupted = false;
      while (other.isAlive()) {
        try {
          other.join();
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @Test
  void rerun_serviceThatWasCutOff_isIdenticalUpToThere() throws Exception {
    run.recordInLockstep(CutOff::new);
    Rerun.Outcome outcome = run.rerun(Amplifier::new);
    assertThat(outcome.remarks()).isEmpty();
    assertThat(outcome.isIdentical()).isTrue();
    assertThat(state(outcome).recorded()).isEqualTo(9);
  }

  /** Publishes the path of a file that its configuration names. */
  private static final class Located extends Amplifier {
    private final Path map;

    Located(ServiceContext context) {
      super(context);
      VariableDeclaration<String> file = VariableDeclaration.text("MAP");
      map = context.configuration().resolve(getVariable(file));
    }

    @Override
    protected void step(double nowS) {
      super.step(nowS);
      publish(Channels.STATE, new StateInformation().sensorName(map.toString()));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"map.xml", "../maps/map.xml", "absolute"})
  void rerun_configurationAskedForAndFileOfItPublished_isIdentical(String value) throws Exception {
    Path maps = Files.createDirectories(folder.resolve("maps"));
    Path own = Files.createDirectories(folder.resolve("own"));
    for (Path each : List.of(maps, own)) {
      Files.writeString(each.resolve("map.xml"), "<map/>");
    }
    String path = value.equals("absolute") ? maps.resolve("map.xml").toString() : value;
    run = new AmplifierRun(own);
    run.moreVariables = "<variable name=\"MAP\" type=\"string\" value=\"" + path + "\"/>";
    run.asked = true;
    run.recordInLockstep(Located::new);
    Rerun.Outcome outcome = run.rerun(Located::new);
    assertThat(outcome.channels())
        .allSatisfy(each -> assertThat(each.first()).as(each.name()).isEmpty());
    assertThat(outcome.channels())
        .filteredOn(each -> each.name().equals("configuration"))
        .hasSize(1)
        .allMatch(each -> each.recorded() >= 20 && each.same() == each.recorded());
    assertThat(outcome.isIdentical()).isTrue();
  }
}
