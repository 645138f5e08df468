package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PointCloud;

/** Fields set from text, as mission and world XML does. */
class MessageFieldTest {
  private static <T extends U2SAData> T fill(MessageType<T> type, String... namesAndTexts) {
    T message = type.create();
    for (int i = 0; i < namesAndTexts.length; i += 2) {
      type.fieldByElementName(namesAndTexts[i])
          .orElseThrow()
          .setText(message, namesAndTexts[i + 1]);
    }
    return message;
  }

  @Test
  void setText_waypointOfTheThesis_fillsIt() {
    Waypoint goal =
        fill(
            Waypoint.TYPE, "name", "1", "next", "2", "reference", "Global", "x", "10", "y", " 15 ");

    assertThat(goal)
        .isEqualTo(
            new Waypoint()
                .uid("1")
                .next(List.of("2"))
                .referenceFrame(ReferenceFrame.GLOBAL)
                .x(10.0)
                .y(15.0));
  }

  @Test
  void setText_circleOfTheThesis_fillsIt() {
    Circle circle = fill(Circle.TYPE, "uid", "Circle1", "x", "4", "y", "8");

    assertThat(circle).isEqualTo(new Circle().uid("Circle1").x(4.0).y(8.0));
    assertThat(circle.serialize()).isNotEmpty();
  }

  @Test
  void setText_everyKind_isParsed() {
    Line line =
        fill(
            Line.TYPE,
            "Type",
            "fence",
            "level",
            "avoid if possible",
            "points",
            "1 2; 3,4,5",
            "reference",
            "utm 4n");
    Waypoint goal = fill(Waypoint.TYPE, "completed", "TRUE", "next", "2, Return home");

    assertThat(line.objectType()).isEqualTo("fence");
    assertThat(line.level()).contains(ObjectLevel.AVOID_IF_POSSIBLE);
    assertThat(line.points()).containsExactly(Point.of(1, 2, 0), Point.of(3, 4, 5));
    assertThat(line.referenceFrame()).isEqualTo(ReferenceFrame.utm(4, true));
    assertThat(goal.completed()).isTrue();
    assertThat(goal.next()).containsExactly("2", "Return home");
  }

  @Test
  void setTexts_elementGivenTwice_takesBothForListsOnly() {
    Waypoint goal = new Waypoint();
    Waypoint.TYPE.field("next").orElseThrow().setTexts(goal, List.of("2", "3"));

    assertThat(goal.next()).containsExactly("2", "3");
    assertThatThrownBy(
            () -> Waypoint.TYPE.field("x").orElseThrow().setTexts(goal, List.of("2", "3")))
        .hasMessage("Waypoint.x: expected one value, not \"[2, 3]\"");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "abc", "NaN", "Infinity", "1d", "0x10", "1,5", "1 2", "1e999"})
  void setText_noNumber_namesFieldTextAndUnit(String text) {
    assertThatThrownBy(() -> fill(StateInformation.TYPE, "psi", text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("StateInformation.psi: expected a ")
        .hasMessageContaining("[rad]");
  }

  @Test
  void setText_wrongText_saysWhatWasExpected() {
    assertThatThrownBy(() -> fill(Waypoint.TYPE, "completed", "yes"))
        .hasMessage("GoalInformation.completed: expected true or false, not \"yes\"");
    assertThatThrownBy(() -> fill(Circle.TYPE, "level", "never"))
        .hasMessageContaining("expected one of [AVOID_ALWAYS, AVOID_IF_POSSIBLE, HINDRANCE]");
    assertThatThrownBy(() -> fill(Circle.TYPE, "reference", "Mars"))
        .hasMessageContaining("is not a reference frame; expected GLOBAL");
    assertThatThrownBy(() -> fill(PointCloud.TYPE, "points", "1"))
        .hasMessageContaining("expected a point: two or three numbers");
    assertThatThrownBy(() -> fill(GoalList.TYPE, "goals", "1"))
        .hasMessageContaining("expected elements of GoalInformation");
  }

  @Test
  void schema_nameTakenOrReserved_isRefused() {
    Schema<Circle> schema = Schema.of("Ring", Circle.class, Circle::new, Circle.TYPE);

    assertThatThrownBy(() -> schema.text("radius", ""))
        .hasMessage("Ring.radius: the name is taken");
    assertThatThrownBy(() -> schema.text("type", "")).hasMessage("Ring.type: the name is taken");
  }

  @Test
  void schema_moreThan64PresenceBits_isRefused() {
    Schema<StateInformation> schema =
        Schema.of("Big", StateInformation.class, StateInformation::new, StateInformation.TYPE);
    for (int i = 48; i < 64; i++) {
      schema.optionalNumber("n" + i, "");
    }

    assertThatThrownBy(() -> schema.optionalNumber("n64", ""))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("at most 64");
  }
}
