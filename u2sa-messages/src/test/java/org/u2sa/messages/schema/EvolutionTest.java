package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.shape.Circle;

/** Writers and readers of different versions understand each other (3.5.1.2, 8.2.5). */
class EvolutionTest {
  private final MessageCodec old = new MessageCodec(StandardTypes.registry());
  private final MessageCodec extended =
      new MessageCodec(
          StandardTypes.registry().with(List.of(RampedCommand.TYPE, Inspection.TYPE, Tide.TYPE)));

  /** A subclass of a concrete class. */
  static final class RampedCommand extends PercentageCommand {
    private static final Schema<RampedCommand> SCHEMA =
        Schema.of("RampedCommand", RampedCommand.class, RampedCommand::new, PercentageCommand.TYPE);
    private static final NumberField<RampedCommand> RATE = SCHEMA.optionalNumber("rate", "%/s");
    static final MessageType<RampedCommand> TYPE = SCHEMA.build();

    @Override
    public MessageType<RampedCommand> type() {
      return TYPE;
    }

    OptionalDouble rate() {
      return get(RATE);
    }

    RampedCommand rate(double percentPerSecond) {
      put(RATE, percentPerSecond);
      return this;
    }
  }

  /** A subclass of an abstract class. */
  static final class Inspection extends GoalInformation {
    private static final Schema<Inspection> SCHEMA =
        Schema.of("Inspection", Inspection.class, Inspection::new, GoalInformation.TYPE);
    private static final ValueField<Inspection, String> WHAT = SCHEMA.requiredText("what");
    static final MessageType<Inspection> TYPE = SCHEMA.build();

    @Override
    public MessageType<Inspection> type() {
      return TYPE;
    }

    Inspection what(String what) {
      put(WHAT, what);
      return this;
    }
  }

  /** A class that no reader knows an ancestor of. */
  static final class Tide extends U2SAData {
    private static final Schema<Tide> SCHEMA =
        Schema.of("Tide", Tide.class, Tide::new, U2SAData.TYPE);
    private static final NumberField<Tide> HEIGHT = SCHEMA.optionalNumber("height", "m");
    private static final ValueField<Tide, List<String>> HARBOURS = SCHEMA.texts("harbours");
    static final MessageType<Tide> TYPE = SCHEMA.build();

    @Override
    public MessageType<Tide> type() {
      return TYPE;
    }

    Tide height(double metres) {
      put(HEIGHT, metres);
      put(HARBOURS, List.of("Honolulu"));
      return this;
    }
  }

  private static RampedCommand ramped() {
    RampedCommand command = new RampedCommand().rate(20.0);
    command.actuatorName("RUDDER").percentage(5.0);
    return command;
  }

  private static Inspection inspection() {
    Inspection goal = new Inspection().what("hull");
    goal.uid("7").next(List.of("8"));
    return goal;
  }

  @Test
  void decode_unknownSubclass_isItsNearestAncestor() throws MalformedMessageException {
    U2SAData read = old.decode(RampedCommand.TYPE.chain(), ramped().serialize());

    assertThat(read).isInstanceOf(PercentageCommand.class).isNotInstanceOf(RampedCommand.class);
    assertThat(((PercentageCommand) read).percentage()).isEqualTo(5.0);
    assertThat(read.typeChain())
        .containsExactly("ActuatorCommand", "PercentageCommand", "RampedCommand");
  }

  @Test
  void serialize_messageReadAsItsAncestor_losesNothing() throws MalformedMessageException {
    U2SAData relayed = old.decode(RampedCommand.TYPE.chain(), ramped().serialize());

    U2SAData read = extended.decode(relayed.typeChain(), relayed.serialize());

    assertThat(read).isEqualTo(ramped());
    assertThat(old.decode(relayed.typeChain(), relayed.copy().serialize())).isEqualTo(relayed);
  }

  @Test
  void decode_unknownSubclassOfAbstractClass_isOfThatClass() throws MalformedMessageException {
    U2SAData read = old.decode(Inspection.TYPE.chain(), inspection().serialize());

    assertThat(read).isInstanceOf(GoalInformation.class);
    assertThat(((GoalInformation) read).uid()).isEqualTo("7");
    assertThat(read.enumerateFields()).contains(new FieldValue("what", "", Optional.of("hull")));
  }

  @Test
  void decode_unknownGoalInList_keepsItForReadersThatKnowIt() throws MalformedMessageException {
    GoalList list = new GoalList().goals(List.of(inspection()));

    GoalList relayed = (GoalList) old.decode(GoalList.TYPE.chain(), list.serialize());

    assertThat(relayed.goals().get(0).next()).containsExactly("8");
    assertThat(extended.decode(GoalList.TYPE.chain(), relayed.serialize())).isEqualTo(list);
  }

  @Test
  void decode_noKnownAncestor_enumeratesAllAndIsWrittenAsRead() throws MalformedMessageException {
    Tide tide = new Tide().height(1.5);
    tide.systemId("harbour");

    U2SAData read = old.decode(Tide.TYPE.chain(), tide.serialize());

    assertThat(read).isInstanceOf(OpaqueMessage.class);
    assertThat(((OpaqueMessage) read).typeName()).isEqualTo("Tide");
    assertThat(read.systemId()).isEqualTo("harbour");
    assertThat(read.enumerateFields())
        .contains(
            new FieldValue("height", "", Optional.of(1.5)),
            new FieldValue("harbours", "", Optional.of(List.of("Honolulu"))));
    assertThat(read.serialize()).isEqualTo(tide.serialize());
    assertThat(extended.decode(read.typeChain(), read.serialize())).isEqualTo(tide);
  }

  @Test
  void decode_unknownKeysOfEveryKind_areSkipped() throws MalformedMessageException {
    // {"a": {"b": [1, null, h'00']}, "uid": "7", "c": 1.5, "d": undefined, "e": 0("tagged")}
    String hex =
        "a5"
            + "6161"
            + "a16162"
            + "8301f64100"
            + "63756964"
            + "6137"
            + "6163"
            + "f93e00"
            + "6164"
            + "f7"
            + "6165"
            + "c066746167676564";

    U2SAData read = old.decode(List.of("GoalCommand"), HexFormat.of().parseHex(hex));

    assertThat(read).isEqualTo(new org.u2sa.messages.mission.GoalCommand().uid("7"));
  }

  @Test
  void decode_fieldsThatOldWritersDidNotKnow_haveTheirDefaults() throws MalformedMessageException {
    // {"uid": "7", "horizontalThreshold": 1.0}: less than any version writes
    String hex = "a2" + "63756964" + "6137" + "73686f72697a6f6e74616c5468726573686f6c64" + "f93c00";

    Waypoint read = (Waypoint) old.decode(Waypoint.TYPE.chain(), HexFormat.of().parseHex(hex));

    assertThat(read.completed()).isFalse();
    assertThat(read.next()).isEmpty();
    assertThat(read.x()).isEmpty();
  }

  @Test
  void decode_unknownConstantOfAnOptionalEnum_isAbsent() throws MalformedMessageException {
    ObjectDescription buoy = new Circle().radius(1.0).uid("1").x(1.0).y(2.0);
    byte[] bytes = buoy.level(ObjectLevel.HINDRANCE).serialize();
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    bytes[text.indexOf("HINDRANCE")] = 'K';

    ObjectDescription read = (ObjectDescription) old.decode(Circle.TYPE.chain(), bytes);

    assertThat(read.level()).isEmpty();
    assertThat(read.presenceVector()).isZero();
    assertThat(((Circle) read).radius()).isEqualTo(1.0);
  }
}
