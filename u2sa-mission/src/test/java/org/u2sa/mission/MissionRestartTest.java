package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;

/** Where a mission continues when its manager is restarted or swapped. */
class MissionRestartTest extends ThreeWaypoints {
  @Test
  void restart_inTheMiddle_goesOnAtTheGoalItWasAt() {
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    kit.publish(Channels.GOAL_UPDATES, new Waypoint().uid("3").y(7.0).horizontalThreshold(5.0));

    kit.forget();
    kit.restart(before, MissionManager::new);

    assertThat(current()).containsExactly("2");
    complete("2");
    assertThat(((Waypoint) goals().goals().get(0)).y()).hasValue(7.0);
    complete("3");
    assertThat(goals().goals()).isEmpty();
    assertThat(logged("completed [1, 2, 3], given up []")).isTrue();
  }

  @Test
  void restart_again_goesOnFromTheLastRestart() {
    MissionManager first = kit.start(MissionManager::new);
    complete("1");
    MissionManager second = kit.restart(first, MissionManager::new);
    complete("2");

    kit.restart(second, MissionManager::new);

    assertThat(current()).containsExactly("3");
  }

  @Test
  void restart_anotherMissionMeanwhile_beginsIt() throws IOException {
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    Path other = directory.resolve("other.xml");
    Files.writeString(other, "<mission><waypoint><name>A</name><x>1</x></waypoint></mission>");
    kit.with("MISSION", other.toString());

    kit.restart(before, MissionManager::new);

    assertThat(current()).containsExactly("A");
    assertThat(logged("mission changed since the last run")).isTrue();
  }

  @Test
  void restart_savedStateIsLost_isPaused() {
    MissionManager before = kit.start(MissionManager::new);
    kit.loseState("MissionManager");

    kit.restart(before, MissionManager::new);

    assertThat(goals().paused()).isTrue();
    assertThat(current()).containsExactly("1");
    assertThat(logged("restarted without a saved state: paused")).isTrue();
  }

  @Test
  void restart_pausedAndAnotherMissionMeanwhile_staysPaused() throws IOException {
    MissionManager before = kit.start(MissionManager::new);
    kit.publish(
        Channels.MISSION,
        new MissionOrder().requestId("1").operator("Ann").action(MissionAction.PAUSE));
    Path other = directory.resolve("other.xml");
    Files.writeString(other, "<mission><waypoint><name>A</name><x>1</x></waypoint></mission>");
    kit.with("MISSION", other.toString());

    kit.restart(before, MissionManager::new);

    assertThat(current()).containsExactly("A");
    assertThat(goals().paused()).isTrue();
  }

  @Test
  void restart_copyOfTheMissionElsewhere_goesOnAtTheGoalItWasAt() throws IOException {
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    Path copy = directory.resolve("copy.xml");
    Files.copy(Path.of(before.getVariable("MISSION").toString()), copy);
    kit.with("MISSION", copy.toString());

    kit.restart(before, MissionManager::new);

    assertThat(current()).containsExactly("2");
  }

  @Test
  void start_whatAnotherRunLeft_isForgotten() {
    MissionManager before = kit.start(MissionManager::new);
    complete("1");
    before.kill();

    kit.start(MissionManager::new);

    assertThat(current()).containsExactly("1");
  }

  @Test
  void swap_forItsOwnClass_goesOnAtTheGoalItWasAt() {
    MissionManager before = kit.start(MissionManager::new);
    complete("1");

    kit.swap(before, MissionManager::new);
    complete("2");

    assertThat(current()).containsExactly("3");
  }
}
