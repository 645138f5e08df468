package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.registry.StandardTypes;

/** A file with as many goals as its size allows is read in seconds, not hours. */
class LargeMissionTest {
  private static final int GOALS = 100_000;

  @TempDir private Path folder;

  private Mission load(String goals) throws Exception {
    Path file = folder.resolve("mission.xml");
    Files.writeString(file, "<mission>" + goals + "</mission>");
    return Mission.load(file, StandardTypes.registry(), 1.0);
  }

  @Test
  @Timeout(120)
  void load_goalsWithoutNames_areNumberedInTimeProportionalToThem() throws Exception {
    Mission mission = load("<waypoint><x>1</x><y>2</y></waypoint>".repeat(GOALS));

    assertThat(mission.goals()).hasSize(GOALS);
    assertThat(mission.goals().get(GOALS - 1).uid()).isEqualTo(String.valueOf(GOALS));
    assertThat(mission.warnings()).isEmpty();
  }
}
