package org.u2sa.trials.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.mission.Mission;

class LapsTest {
  private static final double DEFAULT_M = 3.0;
  private static final String HOME = "<home><x>-81</x><y>29</y><psi>90</psi></home>";
  private static final String TWO =
      "<waypoint><name>door &amp; gate</name><x>-81.001</x><y>29</y><horizontalThreshold>0.5</horizontalThreshold></waypoint>"
          + "<waypoint><x>-81.001</x><y>29.001</y><speed>0.4</speed><psi>1.5</psi></waypoint>";

  @TempDir private Path directory;

  private Mission mission(String text) throws IOException {
    return Mission.load(
        Files.writeString(directory.resolve("given.xml"), "<mission>" + text + "</mission>"),
        MessageTypes.discovered(),
        DEFAULT_M);
  }

  private Mission laps(String text, int laps, double leastThresholdM) throws IOException {
    return Laps.write(mission(text), laps, leastThresholdM, directory.resolve("a/laps.xml"));
  }

  @Test
  void write_twoLaps_goesTwiceRoundWithNamesOfTheirOwn() throws IOException {
    Mission laps = laps(HOME + TWO, 2, 0.0);

    assertThat(laps.goals())
        .extracting(GoalInformation::uid)
        .containsExactly("door & gate", "2", "door & gate, lap 2", "2, lap 2");
    Waypoint last = (Waypoint) laps.goals().get(3);
    assertThat(last.y()).hasValue(29.001);
    assertThat(last.speed()).hasValue(0.4);
    assertThat(last.psi()).hasValue(1.5);
    assertThat(last.horizontalThreshold()).isEqualTo(DEFAULT_M);
    assertThat(laps.home().orElseThrow().headingRad().orElseThrow()).isEqualTo(Math.PI / 2.0);
  }

  @Test
  void write_leastThreshold_widensNarrowerOnesOnly() throws IOException {
    Mission laps = laps(HOME + TWO, 1, 1.5);

    assertThat(((Waypoint) laps.goals().get(0)).horizontalThreshold()).isEqualTo(1.5);
    assertThat(((Waypoint) laps.goals().get(1)).horizontalThreshold()).isEqualTo(DEFAULT_M);
  }

  @Test
  void write_oneLap_keepsBranchesRepetitionsAndLimits() throws IOException {
    String linked =
        "<timeLimit unit='min' next='home'>3</timeLimit>"
            + TWO
            + "<waypoint><name>dock</name><x>-81</x><y>29</y><time>60</time><timeLimit>9</timeLimit><choose>1</choose>"
            + "<next if='failed'>home</next><end if='timed out'/><repeat from='2' times='2'/></waypoint>";
    Mission given = mission(HOME + linked);
    Mission laps = laps(HOME + linked, 1, 1.5);

    assertThat(laps.timeLimit()).hasValue(180.0);
    assertThat(laps.afterTimeLimit()).containsExactly("home");
    for (int i = 1; i < 3; i++) { // the first one's threshold is widened
      assertThat(laps.goals().get(i)).isEqualTo(given.goals().get(i));
    }
    assertThatThrownBy(() -> laps(HOME + linked, 2, 0.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContainingAll("given.xml, line 1, <waypoint>", "expected 1 lap");
  }

  @Test
  void write_missionWithoutHome_isRefused() {
    assertThatThrownBy(() -> laps(TWO, 2, 0.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContainingAll("given.xml", "has no home in Global");
  }

  @Test
  void write_waypointInALocalFrame_isRefusedByName() {
    String local =
        "<waypoint><name>door</name><reference>Local ENU</reference><x>1</x><y>2</y></waypoint>";

    assertThatThrownBy(() -> laps(HOME + local, 2, 0.0))
        .isInstanceOf(BadInputException.class)
        .hasMessageContainingAll("goal \"door\"", "waypoints in Global");
  }
}
