package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Sphere;

class U2SADataTest {
  @ParameterizedTest
  @EnumSource(StateField.class)
  void presenceVector_oneNumberSet_hasItsBitAlone(StateField field) {
    StateInformation state = new StateInformation().number(field, 0.0);

    assertThat(state.presenceVector()).isEqualTo(1L << field.ordinal());
    assertThat(state.number(field)).hasValue(0.0);
  }

  @Test
  void toString_longValue_isShortened() {
    OccupancyGrid grid = new OccupancyGrid();
    OccupancyGrid.TYPE.field("cells").orElseThrow().set(grid, List.of("A".repeat(60_000)));

    assertThat(grid.toString()).hasSizeLessThan(1_200).contains("cells=[AAA").contains("…");
  }

  @Test
  void presenceVector_namedSetters_setTheBitsOfFigure6() {
    assertThat(new StateInformation().presenceVector()).isZero();
    assertThat(new StateInformation().x(1).presenceVector()).isEqualTo(1L);
    assertThat(new StateInformation().number(StateField.Z_DOUBLE_DOT_SIGMA, 1).presenceVector())
        .isEqualTo(1L << 17);
    assertThat(new StateInformation().phi(1).presenceVector()).isEqualTo(1L << 18);
    assertThat(new StateInformation().fluidxDot(1).presenceVector()).isEqualTo(1L << 36);
    assertThat(
            new StateInformation().number(StateField.FLUID_Z_DOUBLE_DOT_SIGMA, 1).presenceVector())
        .isEqualTo(1L << 47);
    assertThat(StateField.values()).hasSize(48);
  }

  @Test
  void presenceVector_waypoint_countsFromX() {
    assertThat(new Waypoint().uid("1").description("d").x(1.0).presenceVector()).isEqualTo(1L);
    assertThat(new Waypoint().time(1.0).presenceVector()).isEqualTo(1L << 6);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void number_setInAnyOrder_eachKeepsItsOwn(long seed) {
    List<StateField> order = new ArrayList<>(List.of(StateField.values()));
    Collections.shuffle(order, new Random(seed));
    StateInformation state = new StateInformation();

    for (int set = 1; set <= order.size(); set++) {
      state.number(order.get(set - 1), -1.0);
      state.number(order.get(set - 1), order.get(set - 1).ordinal()); // replaces the one before

      for (int i = 0; i < order.size(); i++) {
        StateField field = order.get(i);
        assertThat(state.number(field))
            .isEqualTo(i < set ? OptionalDouble.of(field.ordinal()) : OptionalDouble.empty());
      }
    }
  }

  @Test
  void timestamp_setOrNot_isSeenByGetterFieldAndCopy() {
    MessageField<Waypoint> field = Waypoint.TYPE.field("timestamp").orElseThrow();
    Waypoint without = new Waypoint();
    Waypoint zero = new Waypoint();
    zero.timestamp(0L);
    Waypoint byField = new Waypoint();
    field.set(byField, -5L);

    assertThat(without.timestamp()).isEmpty();
    assertThat(field.get(without)).isEmpty();
    assertThat(without.copy().timestamp()).isEmpty();
    assertThat(zero.timestamp()).hasValue(0L);
    assertThat(field.get(zero)).contains(0L);
    assertThat(zero.copy().timestamp()).hasValue(0L);
    assertThat(byField.timestamp()).hasValue(-5L);
    assertThat(zero).isNotEqualTo(without);
  }

  @Test
  void freeze_thenSet_isRefused() {
    Waypoint goal = new Waypoint().uid("1").horizontalThreshold(5.0);
    GoalList list = new GoalList().goals(List.of(goal));
    list.freeze();

    assertThat(goal.isFrozen()).isTrue();
    assertThatThrownBy(() -> goal.x(1.0))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("Waypoint.x cannot be set: the message was frozen");
    assertThatThrownBy(() -> goal.uid("2")).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> list.systemId("s")).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> list.timestamp(1L)).isInstanceOf(IllegalStateException.class);
    Waypoint.TYPE
        .fields()
        .forEach(
            field ->
                field
                    .get(goal)
                    .ifPresent(
                        value ->
                            assertThatThrownBy(() -> field.set(goal, value))
                                .isInstanceOf(IllegalStateException.class)));
  }

  @Test
  void freeze_requiredFieldMissing_isRefused() {
    assertThatThrownBy(() -> new ActuatorCommand().freeze())
        .hasMessage("ActuatorCommand.actuatorName is required and was never set");
  }

  @Test
  void copy_ofFrozenMessage_isEqualAndFree() {
    GoalList list = new GoalList().goals(List.of(new Waypoint().uid("1").horizontalThreshold(5.0)));
    list.freeze();

    GoalList copy = (GoalList) list.copy();

    assertThat(copy).isEqualTo(list);
    copy.goals().get(0).completed(true);
    assertThat(copy).isNotEqualTo(list);
    assertThat(list.goals().get(0).completed()).isFalse();
  }

  @Test
  void lists_givenAndGot_cannotBeChangedFromOutside() {
    List<String> uids = new ArrayList<>(List.of("2"));
    Waypoint goal = new Waypoint().next(uids);
    uids.add("3");

    assertThat(goal.next()).containsExactly("2");
    assertThatThrownBy(() -> goal.next().add("4"))
        .isInstanceOf(UnsupportedOperationException.class);
  }

  @Test
  void set_notFiniteOrOutOfRange_namesFieldValueAndWhatWasExpected() {
    assertThatThrownBy(() -> new StateInformation().z(Double.NaN))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("StateInformation.z: expected a finite number [m], not \"NaN\"");
    assertThatThrownBy(() -> PercentageCommand.of("A", 100.5))
        .hasMessage("PercentageCommand.percentage: expected -100.0…100.0 %, not \"100.5\"");
    assertThatThrownBy(() -> new Circle().radius(-1.0))
        .hasMessage("Circle.radius: expected at least 0.0 m, not \"-1.0\"");
    assertThatThrownBy(() -> new StateInformation().x(1e200))
        .hasMessage("StateInformation.x: expected -1.0E9…1.0E9 m, not \"1.0E200\"");
    assertThatThrownBy(() -> new StateInformation().xDot(-1e200))
        .hasMessage("StateInformation.xDot: expected at least -1.0E15 m/s, not \"-1.0E200\"");
    assertThatThrownBy(() -> new StateInformation().timestamp(Long.MAX_VALUE))
        .hasMessage("expected a time of at most 9223372036854775 µs");
    assertThatThrownBy(() -> new Waypoint().uid("\ud800"))
        .hasMessageContaining("unpaired surrogate");
    assertThatThrownBy(() -> new Waypoint().uid("x".repeat(Limits.TEXT_BYTES + 1)))
        .hasMessageContaining("at most 65536 bytes");
    assertThatThrownBy(() -> new Waypoint().uid(null)).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void serialize_overOneMebibyte_isRefused() {
    String uid = "x".repeat(Limits.ID_CHARS);
    Waypoint goal = new Waypoint().uid("1").horizontalThreshold(1.0);
    goal.next(java.util.Collections.nCopies(1_100, uid));

    assertThatThrownBy(goal::serialize)
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("bytes exceed the 1048576 that readers accept");
  }

  @Test
  void enumerateFields_everyField_hasItsUnitAndMaybeValue() {
    StateInformation state = new StateInformation().x(-157.0).psi(1.0);

    List<FieldValue> fields = state.enumerateFields();

    assertThat(fields).hasSize(52);
    assertThat(fields)
        .contains(
            new FieldValue("x", "deg", Optional.of(-157.0)),
            new FieldValue("y", "deg", Optional.empty()),
            new FieldValue("psi", "rad", Optional.of(1.0)),
            new FieldValue("referenceFrame", "", Optional.of(ReferenceFrame.GLOBAL)));
    assertThat(state.referenceFrame(ReferenceFrame.LOCAL_ENU).enumerateFields())
        .contains(new FieldValue("x", "m", Optional.of(-157.0)));
  }

  @Test
  void toString_message_showsWhatIsSet() {
    assertThat(PercentageCommand.of("RUDDER", 5.0))
        .hasToString("PercentageCommand{actuatorName=RUDDER, percentage=5.0 %}");
  }

  @Test
  void equals_otherTypeOrValue_differs() {
    assertThat(new Sphere().uid("1").radius(1)).isNotEqualTo(new Circle().uid("1").radius(1));
    assertThat(new StateInformation().x(0.0)).isNotEqualTo(new StateInformation());
    assertThat(new Waypoint().completed(false)).isEqualTo(new Waypoint());
  }
}
