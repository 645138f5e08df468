package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;

/** Where a mission continues in another process, of which the kit's next start is one. */
class SavedMissionTest extends ThreeWaypoints {
  private void nextProcess(MissionManager before) {
    before.kill();
    kit.forget();
    kit.start(MissionManager::new);
  }

  private MissionOrderResult resume() {
    kit.publish(
        Channels.MISSION,
        new MissionOrder().requestId("o").action(MissionAction.RESUME).operator("anna"));
    return (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
  }

  @Test
  void never_anotherProcess_beginsAnew() {
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    nextProcess(before);

    assertThat(current()).containsExactly("1");
    assertThat(resume().accepted()).isFalse();
  }

  @Test
  void always_anotherProcess_goesOnWhereTheFirstEnded() {
    kit.with("RESUME", "ALWAYS");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    nextProcess(before);

    assertThat(current()).containsExactly("2");
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    MissionReport report = (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(report.goals().get(0).completed()).isTrue();
    complete("2");
    complete("3");
    assertThat(logged("mission is over: completed [1, 2, 3]")).isTrue();
  }

  private MissionReport report() {
    kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
    return (MissionReport) kit.latest(Channels.MISSION).orElseThrow();
  }

  private long arrivedAfterMicros() {
    MissionReport report = report();
    return report.goals().get(0).arrivedAt().orElseThrow() - report.began().orElseThrow();
  }

  @Test
  void always_anotherProcessLater_arrivalsAreAsLongAfterTheBeginning() {
    kit.with("RESUME", "ALWAYS");
    MissionManager before = kit.start(MissionManager::new);
    kit.advance(30.0);
    complete("1");
    long arrived = arrivedAfterMicros();
    kit.advance(20.0);
    complete("2");
    double elapsed = report().elapsed();
    kit.advance(200.0);
    nextProcess(before);
    kit.advance(5.0);

    assertThat(arrived).isBetween(29_000_000L, 30_000_000L);
    assertThat(arrivedAfterMicros()).isEqualTo(arrived);
    assertThat(report().elapsed()).isBetween(elapsed + 4.0, elapsed + 5.5);
    complete("3");
    assertThat(kit.latest(Channels.GOALS).orElseThrow().goals()).isEmpty();
  }

  @Test
  void ordered_anotherProcess_beginsAnewAndResumesOnOrder() {
    kit.with("RESUME", "ORDERED");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    complete("2");
    nextProcess(before);
    assertThat(current()).containsExactly("1");
    assertThat(logged("the previous process ended at goal [3]")).isTrue();

    assertThat(resume().outcome()).isEqualTo("resumed at [3]");
    assertThat(current()).containsExactly("3");
  }

  private MissionOrderResult pause() {
    kit.publish(
        Channels.MISSION,
        new MissionOrder().requestId("p").action(MissionAction.PAUSE).operator("anna"));
    return (MissionOrderResult) kit.latest(Channels.MISSION).orElseThrow();
  }

  @Test
  void ordered_pausedInTheNextProcess_resumeEndsThePauseFirst() {
    kit.with("RESUME", "ORDERED");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    complete("2");
    nextProcess(before);
    assertThat(pause().accepted()).isTrue();

    assertThat(resume().outcome()).isEqualTo("resumed at [1]");
    assertThat(current()).containsExactly("1");
  }

  @Test
  void ordered_anotherMissionIsSet_isNotResumed() throws IOException {
    kit.with("RESUME", "ORDERED");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    nextProcess(before);
    Path other =
        Files.writeString(
            directory.resolve("other.xml"),
            "<mission><waypoint><name>other</name><x>1</x></waypoint></mission>");
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName("MissionManager")
            .variableName("MISSION")
            .value(other.toString()));
    assertThat(current()).containsExactly("other");

    assertThat(resume().accepted()).isFalse();
    assertThat(current()).containsExactly("other");
  }

  @Test
  void ordered_processThatDidNothing_leavesWhatItFound() {
    kit.with("RESUME", "ORDERED");
    MissionManager first = kit.start(MissionManager::new);
    complete("1");
    first.kill();
    MissionManager second = kit.start(MissionManager::new);
    nextProcess(second);

    assertThat(resume().outcome()).isEqualTo("resumed at [2]");
  }

  @Test
  void always_missionThatIsOver_beginsAnew() {
    kit.with("RESUME", "ALWAYS");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    complete("2");
    complete("3");
    nextProcess(before);

    assertThat(current()).containsExactly("1");
  }

  @Test
  void always_missionFileWasEdited_beginsAnewAndSaysSo() throws IOException {
    kit.with("RESUME", "ALWAYS");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    Files.writeString(file, Files.readString(file) + "<!-- edited -->");
    nextProcess(before);

    assertThat(current()).containsExactly("1");
    assertThat(logged("belongs to a different mission than")).isTrue();
  }

  @Test
  void always_missionFileWasEditedBeforeTheLastSaving_beginsAnewAndSaysSo() throws IOException {
    kit.with("RESUME", "ALWAYS");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    Files.writeString(file, Files.readString(file) + "<!-- edited -->");
    complete("2");
    nextProcess(before);

    assertThat(current()).containsExactly("1");
    assertThat(logged("belongs to a different mission than")).isTrue();
  }

  @Test
  void always_savedFileIsCut_beginsAnewAndSaysSo() throws IOException {
    kit.with("RESUME", "ALWAYS");
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    var saved = kit.context().logDirectory().resolve("MissionManager.mission");
    String text = Files.readString(saved);
    Files.writeString(saved, text.substring(0, text.length() / 2));
    nextProcess(before);

    assertThat(current()).containsExactly("1");
    assertThat(logged("incomplete")).isTrue();
  }
}
