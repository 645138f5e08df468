package org.u2sa.report.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;

class FieldConditionTest {
  private final StateInformation state =
      new StateInformation().sensorName("GPS left").x(8.0).psi(Math.PI / 2);

  @ParameterizedTest
  @CsvSource({
    "x > 7.9, true",
    "x > 8, false",
    "x >= 8, true",
    "x < 8, false",
    "x <= 8.0, true",
    "x = 8, true",
    "x != 8, false",
    "psi > 89 deg, true",
    "psi > 91 deg, false",
    "psi>1.5, true",
    "sensorName = GPS left, true",
    "sensorName = GPS, false",
    "sensorName != GPS, true",
    "sensorName ~ gps, true",
    "sensorName ~ compass, false",
    "referenceFrame = GLOBAL, true",
    "z > 0, false",
    "z = 0, false",
    "z != 0, true",
    "nothing ~ x, false"
  })
  void holds_eachOperator(String condition, boolean expected) {
    assertThat(FieldCondition.parse(condition).holds(state)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({"y = 0, true", "y < 0, false", "y >= 0, true", "y = -0, true", "x > -0, true"})
  void holds_negativeZero_isZero(String condition, boolean expected) {
    state.y(-0.0);
    assertThat(FieldCondition.parse(condition).holds(state)).isEqualTo(expected);
  }

  @Test
  void holds_unitOfSomethingElse_isRefused() {
    FieldCondition condition = FieldCondition.parse("psi > 3 kg");
    assertThatThrownBy(() -> condition.holds(state)).hasMessageContaining("\"kg\" measures mass");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x", "x >", "> 3", "x > abc", "x ? 3", ".x = 1", "x > NaN"})
  void parse_noCondition_isRefused(String text) {
    assertThatThrownBy(() -> FieldCondition.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("expected");
  }

  @Test
  void path_withinListsAndMessages_isFollowed() {
    GoalList goals =
        new GoalList()
            .goals(List.of(new Waypoint().uid("a").x(1.0), new Waypoint().uid("b").x(2.0)));
    assertThat(FieldPath.parse("goals[1].uid").value(goals)).contains("b");
    assertThat(FieldPath.parse("goals[-1].x").number(goals)).hasValue(2.0);
    assertThat(FieldPath.parse("goals.size").number(goals)).hasValue(2.0);
    assertThat(FieldPath.parse("goals[2].uid").value(goals)).isEmpty();
    assertThat(FieldPath.parse("x").unit(state)).isEqualTo("deg");
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.", "a..b", "[1]", "a[x]", "a b", "a[1", "a.[1]"})
  void path_none_isRefused(String text) {
    assertThatThrownBy(() -> FieldPath.parse(text)).hasMessageContaining("expected a field");
  }
}
