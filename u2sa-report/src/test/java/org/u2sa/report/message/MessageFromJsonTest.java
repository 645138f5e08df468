package org.u2sa.report.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

class MessageFromJsonTest {
  private final MessageFromJson reader = new MessageFromJson(MessageTypes.discovered());

  private U2SAData read(MessageType<?> type, String json) {
    return reader.message("JSON", type, JsonReader.object("JSON", json));
  }

  @Test
  void message_whatMessageJsonWrote_isTheSameMessage() {
    GoalList goals =
        new GoalList()
            .goals(
                List.of(
                    new Waypoint()
                        .uid("a")
                        .horizontalThreshold(5.0)
                        .x(1.5)
                        .y(-2.0)
                        .next(List.of("b", "c")),
                    new Waypoint()
                        .uid("b")
                        .horizontalThreshold(5.0)
                        .referenceFrame(ReferenceFrame.LOCAL_ENU)));
    goals.systemId("rover");
    goals.timestamp(123L);
    assertThat(read(GoalList.TYPE, MessageJson.fields(goals).line())).isEqualTo(goals);
    PlannedPath path =
        new PlannedPath()
            .planner("direct")
            .status(PathStatus.values()[0])
            .subsystem("VEHICLE")
            .points(List.of(Point.of(1, 2, 3), Point.of(4, 5, 6)));
    assertThat(read(PlannedPath.TYPE, MessageJson.fields(path).line())).isEqualTo(path);
  }

  @Test
  void message_bytes_areBase64BothWays() {
    CameraImage image =
        new CameraImage()
            .sensorName("Camera")
            .format(CameraImage.JPEG)
            .size(2, 1)
            .data(ByteString.copyOf(new byte[] {(byte) 0xff, (byte) 0xd8, 0}));
    String json = MessageJson.fields(image).line();

    assertThat(json).contains("\"data\":\"/9gA\"");
    assertThat(read(CameraImage.TYPE, json)).isEqualTo(image);
    assertThatThrownBy(() -> read(CameraImage.TYPE, json.replace("/9gA", "a?b")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("field \"data\"")
        .hasMessageContaining("expected bytes in base64");
    assertThatThrownBy(() -> read(CameraImage.TYPE, json.replace("\"/9gA\"", "7")))
        .hasMessageContaining("expected a base64 text");
  }

  @Test
  void message_numbersWithUnits_areConverted() {
    StateInformation state =
        (StateInformation)
            read(
                StateInformation.TYPE,
                "{\"sensorName\": \"a\", \"psi\": \"90 deg\", \"z\": \"1000 ft\"}");
    assertThat(state.psi().getAsDouble()).isCloseTo(Math.PI / 2, within(1e-12));
    assertThat(state.z().getAsDouble()).isCloseTo(304.8, within(1e-9));
  }

  @Test
  void message_coordinatesBeforeTheirFrame_haveTheUnitOfTheFrame() {
    StateInformation local =
        (StateInformation)
            read(
                StateInformation.TYPE,
                "{\"sensorName\": \"a\", \"x\": \"1 km\", \"referenceFrame\": \"LOCAL_ENU\"}");
    assertThat(local.x()).hasValue(1000.0);
    assertThatThrownBy(
            () -> read(StateInformation.TYPE, "{\"sensorName\": \"a\", \"x\": \"1 km\"}"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("field \"x\"")
        .hasMessageContaining("\"km\" measures length");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"actuatorName\": \"a\", \"percent\": 3} | no field \"percent\"; did you mean \"percentage\"?",
        "{\"actuatorName\": \"a\", \"percentage\": 300} | -100.0…100.0 %",
        "{\"actuatorName\": \"a\", \"percentage\": true} | expected a number [%], not true",
        "{\"actuatorName\": \"a\", \"percentage\": \"fast\"} | expected a number [%], not \"fast\"",
        "{\"actuatorName\": \"a\", \"percentage\": null} | expected a number [%], not null",
        "{\"actuatorName\": 7, \"percentage\": 3} | expected a text, not 7",
        "{\"percentage\": 3} | field \"actuatorName\" of PercentageCommand is required",
        "{\"actuatorName\": \"a\", \"timestamp\": 1.5, \"percentage\": 1} | expected a whole number, not 1.5",
        "{\"actuatorName\": \"a\" | line 1, column",
        "[1] | expected a JSON object",
        "{\"percentage\": 1, \"percentage\": 2} | Duplicate field 'percentage'",
        "{\"percentage\": 1} {} | unexpected text after the object"
      })
  void message_wrong_saysWhichFieldAndWhatWasExpected(String json, String expected) {
    assertThatThrownBy(() -> read(PercentageCommand.TYPE, json))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(expected);
  }

  @Test
  void named_unknownType_suggests() {
    assertThatThrownBy(
            () ->
                reader.named(
                    "JSON", JsonReader.object("JSON", "{\"type\": \"Waypont\"}"), Optional.empty()))
        .hasMessageContaining("no message type \"Waypont\"")
        .hasMessageContaining("did you mean \"Waypoint\"?");
  }

  @Test
  void object_longTextThatIsNone_isShortenedInTheError() {
    for (String text : List.of("[".repeat(200_000), "{\"" + "a".repeat(200_000) + "\":}")) {
      assertThatThrownBy(() -> JsonReader.object("schema", text))
          .isInstanceOf(BadInputException.class)
          .message()
          .startsWith("schema")
          .hasSizeLessThan(1_000);
    }
  }

  @Test
  void object_deeplyNested_isRefused() {
    assertThatThrownBy(() -> JsonReader.object("JSON", "{\"a\":" + "[".repeat(100_000)))
        .isInstanceOf(BadInputException.class);
  }

  @Test
  void message_whatReadersWouldRefuse_isRefusedNamingTheField() {
    assertThatThrownBy(() -> read(StateInformation.TYPE, "{\"x\": \"10 deg\", \"y\": 95}"))
        .isInstanceOf(BadInputException.class)
        .hasMessage("JSON: StateInformation, y: the latitude 95.0 deg is outside -90…90 deg");
    assertThat(read(StateInformation.TYPE, "{\"y\": 95, \"referenceFrame\": \"LOCAL_ENU\"}"))
        .isNotNull();
    assertThatThrownBy(
            () ->
                read(
                    CameraImage.TYPE,
                    "{\"sensorName\": \"c\", \"format\": \"image/jpeg\", \"data\": \"\", \"width\":"
                        + " 1000000}"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("a size of 1000000 x 0 px");
  }
}
