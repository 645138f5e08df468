package org.u2sa.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.mission.GoalClass;
import org.u2sa.messages.registry.StandardTypes;

/** What a ground station learns of the classes of goals. */
class GoalClassesTest {
  private final Map<String, GoalClass> classes =
      GoalClasses.of(StandardTypes.registry(), "MissionManager").stream()
          .collect(Collectors.toMap(GoalClass::className, Function.identity()));

  private ConfigurationVariable field(String className, String name) {
    return classes.get(className).variables().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void of_standardTypes_areTheClassesOfWhichGoalsCanBe() {
    assertThat(classes)
        .containsKeys("Waypoint", "SearchArea", "Station")
        .doesNotContainKeys("GoalInformation", "GoalList");
  }

  @Test
  void variables_haveUnitRangeAndDefault_withoutWhatMissionFilesLack() {
    assertThat(field("Waypoint", "x").unit()).isEqualTo("deg");
    assertThat(field("Waypoint", "x").min()).isEmpty();
    assertThat(field("Waypoint", "referenceFrame").value()).isEqualTo("GLOBAL");
    assertThat(field("SearchArea", "resolution").max()).hasValue(1.27);
    assertThat(field("SearchArea", "corners").variableType()).isEqualTo("points");
    assertThat(classes.get("Waypoint").variables())
        .extracting(ConfigurationVariable::name)
        .contains("uid", "next")
        .doesNotContain("completed", "result", "nextIfDone", "timestamp");
  }

  @Test
  void required_isWhatAFileMustSay() {
    assertThat(classes.get("SearchArea").required()).containsExactly("resolution");
    assertThat(classes.get("Waypoint").required()).isEmpty(); // names and thresholds are set later
  }

  @Test
  void of_everyClass_canBeSent() {
    classes.values().forEach(each -> assertThat(each.serialize()).hasSizeLessThan(16_384));
  }
}
