package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.PointCloud;

class MessageCodecTest {
  private final MessageCodec codec = new MessageCodec(StandardTypes.registry());

  @Test
  void decode_stateInformation_equalsWhatWasSerialized() throws MalformedMessageException {
    StateInformation state = new StateInformation().sensorName("GPS").x(-158.0).y(21.3).psi(1.5);
    state.systemId("cessna");
    state.timestamp(1_234_567L);

    U2SAData read = codec.decode(List.of("StateInformation"), state.serialize());

    assertThat(read).isEqualTo(state).isInstanceOf(StateInformation.class);
    assertThat(state.presenceVector()).isEqualTo(0b11L | 1L << 20);
  }

  @Test
  void decode_listOfGoals_keepsSubclassesAndFields() throws MalformedMessageException {
    Waypoint goal = new Waypoint().uid("1").x(1.0).y(2.0).horizontalThreshold(50.0);
    GoalList list = new GoalList().goals(List.of(goal.next(List.of("2", "3"))));

    U2SAData read = codec.decode(List.of("GoalList"), list.serialize());

    assertThat(read).isEqualTo(list);
    assertThat(((GoalList) read).goals().get(0)).isInstanceOf(Waypoint.class);
  }

  @Test
  void decode_pointCloudInObjectList_equalsWhatWasSerialized() throws MalformedMessageException {
    PointCloud cloud =
        new PointCloud().uid("c").x(1).y(2).referenceFrame(ReferenceFrame.utm(4, true));
    cloud.points(List.of(Point.of(1, 2, 3), Point.polar(0.5, 0.1, 9)));
    ObjectList list = new ObjectList().objects(List.of(cloud, new Circle().uid("o").x(4).y(8)));

    assertThat(codec.decode(List.of("ObjectList"), list.serialize())).isEqualTo(list);
  }

  @Test
  void serialize_requiredFieldMissing_namesIt() {
    assertThatThrownBy(() -> new Waypoint().uid("1").serialize())
        .hasMessage("Waypoint.horizontalThreshold is required and was never set");
  }

  @Test
  void receivedBytes_packedPoints_areAboutTheirMemoryAndNotTheirBytes()
      throws MalformedMessageException {
    PointCloud cloud = new PointCloud().uid("c").x(1).y(2).referenceFrame(ReferenceFrame.BODY);
    cloud.points(Collections.nCopies(1_000, Point.of(1, 2, 3)));
    byte[] halves = // the same points as 16-bit floats (RFC 8746)
        HexFormat.of()
            .parseHex(
                HexFormat.of()
                    .formatHex(cloud.points(List.of()).serialize())
                    .replace(
                        "66706f696e747380",
                        "66706f696e7473"
                            + "d828828219"
                            + "03e803"
                            + "d850591770"
                            + "3c0040004200".repeat(1_000)));

    U2SAData read = codec.decode(cloud.typeChain(), halves);

    assertThat(((PointCloud) read).points()).hasSize(1_000).contains(Point.of(1, 2, 3));
    assertThat(halves.length).isLessThan(6_200);
    assertThat(read.receivedBytes()).isBetween(40_000, 100_000);
    assertThat(cloud.receivedBytes()).isZero();
  }

  @Test
  void receivedBytes_messageInAList_isItsShare() throws MalformedMessageException {
    PointCloud cloud = new PointCloud().uid("c").x(1).y(2).referenceFrame(ReferenceFrame.BODY);
    cloud.points(Collections.nCopies(1_000, Point.of(1, 2, 3)));
    ObjectList list = new ObjectList().objects(List.of(cloud, new Circle().uid("o").x(4).y(8)));

    ObjectList read = (ObjectList) codec.decode(List.of("ObjectList"), list.serialize());

    assertThat(read.objects().get(0).receivedBytes()).isBetween(40_000, 100_000);
    assertThat(read.objects().get(1).receivedBytes()).isBetween(50, 1_000);
    assertThat(read.receivedBytes()).isGreaterThan(read.objects().get(0).receivedBytes());
  }
}
