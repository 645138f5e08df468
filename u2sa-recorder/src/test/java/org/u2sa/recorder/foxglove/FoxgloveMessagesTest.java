package org.u2sa.recorder.foxglove;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;

class FoxgloveMessagesTest {
  private static final double HALF = Math.sqrt(0.5);
  private static final long NANOS = 3_000_000_007L;

  private final FoxgloveMessages views = new FoxgloveMessages("rover");

  private List<FoxgloveMessages.View> of(Channel<?> channel, U2SAData message) throws IOException {
    List<FoxgloveMessages.View> all = new ArrayList<>();
    views.write(channel, message, NANOS, all::add);
    return all;
  }

  private static ProtobufFields named(List<FoxgloveMessages.View> views, String topic) {
    return views.stream()
        .filter(view -> view.topic().equals(topic))
        .map(view -> new ProtobufFields(view.data()))
        .findFirst()
        .orElseThrow();
  }

  private static StateInformation state() {
    return new StateInformation().x(11.0).y(48.0).z(400.0);
  }

  private static void assertVector(ProtobufFields vector, double x, double y, double z) {
    assertThat(vector.number(1)).isCloseTo(x, within(0.01));
    assertThat(vector.number(2)).isCloseTo(y, within(0.01));
    assertThat(vector.number(3)).isCloseTo(z, within(0.01));
  }

  private static void assertQuaternion(ProtobufFields q, double x, double y, double z, double w) {
    double sign = q.number(4) * w + q.number(3) * z + q.number(2) * y + q.number(1) * x;
    assertThat(Math.abs(sign)).as("the same rotation").isCloseTo(1.0, within(1e-9));
  }

  @Test
  void write_state_givesLatitudeLongitudeAndTime() throws IOException {
    ProtobufFields fix = named(of(Channels.STATE, state()), "/rover/location");
    assertThat(fix.number(1)).isEqualTo(48.0);
    assertThat(fix.number(2)).isEqualTo(11.0);
    assertThat(fix.number(3)).isEqualTo(400.0);
    assertThat(fix.message(6).whole(1)).isEqualTo(3);
    assertThat(fix.message(6).whole(2)).isEqualTo(7);
  }

  @Test
  void write_secondState_isPlacedEastNorthUpOfTheFirst() throws IOException {
    of(Channels.STATE, state());
    StateInformation east = new StateInformation().x(11.001).y(48.0).z(410.0);
    ProtobufFields pose = named(of(Channels.STATE, east), "/rover/pose");
    assertThat(pose.text(2)).isEqualTo("map");
    assertVector(pose.message(3).message(1), 74.63, 0.0, 10.0); // 0.001 deg at 48 deg north
    assertThat(pose.message(3).message(1).number(1)).isGreaterThan(70.0);
  }

  @Test
  void write_attitudes_turnForwardLeftUpIntoEastNorthUp() throws IOException {
    assertQuaternion(attitude(0.0, 0.0, Math.PI / 2), 0, 0, 0, 1); // east: x ahead is x east
    assertQuaternion(attitude(0.0, 0.0, 0.0), 0, 0, HALF, HALF); // north
    assertQuaternion(attitude(0.0, 0.0, Math.PI), 0, 0, -HALF, HALF); // south
    assertQuaternion(attitude(0.0, Math.PI / 2, Math.PI / 2), 0, -HALF, 0, HALF); // nose up
    assertQuaternion(attitude(Math.PI / 2, 0.0, Math.PI / 2), HALF, 0, 0, HALF); // right wing down
    assertQuaternion(attitude(Math.PI, 0.0, Math.PI / 2), 1, 0, 0, 0); // on its back
  }

  private ProtobufFields attitude(double phi, double theta, double psi) throws IOException {
    StateInformation state = state().phi(phi).theta(theta).psi(psi);
    return named(of(Channels.STATE, state), "/rover/transform").message(5);
  }

  @Test
  void write_sensedState_isNotShownAsThePosition() throws IOException {
    assertThat(of(Channels.SENSED_STATE, state())).isEmpty();
  }

  @Test
  void write_scan_hasItsAnglesAndInfinityWhereNothingCame() throws IOException {
    RangeScan scan =
        new RangeScan()
            .sensorName("lidar")
            .maxRange(30.0)
            .x(0.5)
            .z(-0.25)
            .psi(Math.PI / 2)
            .beams(
                -1.0,
                0.5,
                List.of(OptionalDouble.of(3.0), OptionalDouble.empty(), OptionalDouble.of(4.0)));
    ProtobufFields view = named(of(Channels.SCANS, scan), "/rover/scan/lidar");
    assertThat(view.text(2)).isEqualTo("body");
    assertVector(view.message(3).message(1), 0.5, 0.0, 0.25); // BODY's z is down
    assertQuaternion(view.message(3).message(2), 0, 0, HALF, HALF); // to the left
    assertThat(view.number(4)).isEqualTo(-1.0);
    assertThat(view.number(5)).isEqualTo(0.0);
    assertThat(view.numbers(6)).containsExactly(3.0, Double.POSITIVE_INFINITY, 4.0);
  }

  @Test
  void write_image_hasItsBytesFormatAndCamera() throws IOException {
    byte[] file = {(byte) 0xff, (byte) 0xd8, 0, (byte) 0xff, (byte) 0xd9};
    CameraImage image =
        new CameraImage()
            .sensorName("Camera 1")
            .format(CameraImage.JPEG)
            .size(640, 480)
            .data(ByteString.copyOf(file));
    List<FoxgloveMessages.View> all = of(Channels.IMAGES, image);

    ProtobufFields view = named(all, "/rover/image/Camera 1");
    assertThat(view.message(1).whole(1)).isEqualTo(3);
    assertThat(view.data(2)).containsExactly(0xff, 0xd8, 0, 0xff, 0xd9);
    assertThat(view.text(3)).isEqualTo("jpeg");
    assertThat(view.text(4)).isEqualTo("Camera 1");
    assertThat(all.get(0).schemaName()).isEqualTo("foxglove.CompressedImage");
    assertThat(new String(all.get(0).schemaData(), StandardCharsets.ISO_8859_1))
        .contains("foxglove/CompressedImage.proto", "google/protobuf/timestamp.proto");
  }

  @Test
  void write_grid_hasCornerSizesAndPerCent() throws IOException {
    of(Channels.STATE, state());
    OccupancyGrid grid =
        new OccupancyGrid()
            .anchor(ReferenceFrame.GLOBAL, Point.of(11.0, 48.0, 400.0))
            .corner(-2.0, -1.0)
            .resolution(0.5)
            .cells(3, new byte[] {0, OccupancyGrid.UNKNOWN, 127, -127, 0, 0});
    ProtobufFields view = named(of(Channels.GRID, grid), "/rover/grid");
    assertVector(view.message(3).message(1), -2.0, -1.0, 0.0);
    assertThat(view.whole(4)).isEqualTo(3);
    assertThat(view.message(5).number(1)).isEqualTo(0.5);
    assertThat(view.whole(6)).isEqualTo(3);
    assertThat(view.whole(7)).isEqualTo(1);
    assertThat(view.data(9)).containsExactly(50, 255, 100, 0, 50, 50);
  }

  @Test
  void write_objects_deletesTheEarlierAndPlacesEach() throws IOException {
    of(Channels.STATE, state());
    Cylinder tree = new Cylinder().radius(0.5).height(6.0);
    tree.uid("tree").objectType("Tree").referenceFrame(ReferenceFrame.BODY).x(2.0).y(3.0).z(-1.0);
    ProtobufFields view =
        named(of(Channels.OBJECTS, new ObjectList().objects(List.of(tree))), "/rover/objects");
    assertThat(view.message(1).whole(2)).isEqualTo(1); // all
    ProtobufFields entity = view.messages(2).get(0);
    assertThat(entity.text(2)).isEqualTo("body");
    assertThat(entity.text(3)).isEqualTo("tree");
    ProtobufFields cylinder = entity.message(10);
    assertVector(cylinder.message(1).message(1), 2.0, 3.0, 1.0);
    assertVector(cylinder.message(2), 1.0, 1.0, 6.0);
  }

  @Test
  void write_failsafe_logsEachChangeOnce() throws IOException {
    FailsafeState goesOn = new FailsafeState().action(FailsafeAction.CONTINUE);
    FailsafeState stop =
        new FailsafeState().action(FailsafeAction.STOP).causes(List.of("battery empty"));
    assertThat(of(Channels.FAILSAFE, goesOn)).hasSize(1);
    assertThat(of(Channels.FAILSAFE, goesOn)).isEmpty();
    ProtobufFields log = named(of(Channels.FAILSAFE, stop), "/rover/log");
    assertThat(log.whole(2)).isEqualTo(3); // warning
    assertThat(log.text(3)).contains("STOP").contains("battery empty");
  }

  @Test
  void descriptors_ofEveryType_nameIt() {
    for (FoxgloveSchema schema : FoxgloveSchema.values()) {
      String type = schema.fullName().substring("foxglove.".length());
      assertThat(new String(schema.descriptors(), java.nio.charset.StandardCharsets.ISO_8859_1))
          .contains("foxglove/" + type + ".proto");
    }
  }

  @Test
  void write_boxInLocalOrBodyAxes_turnsCounterclockwiseFromX() throws IOException {
    assertQuaternion(turned(ReferenceFrame.LOCAL_ENU, Math.PI / 2), 0, 0, HALF, HALF);
    assertQuaternion(turned(ReferenceFrame.LOCAL_NED, 0.0), 0, 0, HALF, HALF);
    assertQuaternion(turned(ReferenceFrame.BODY, Math.PI / 2), 0, 0, HALF, HALF);
    assertQuaternion(turned(ReferenceFrame.BODY_FRD, -Math.PI / 2), 0, 0, HALF, HALF);
  }

  private ProtobufFields turned(ReferenceFrame frame, double psi) throws IOException {
    Box box = new Box().length(4.0).width(2.0).height(1.0).psi(psi);
    box.uid("hut").referenceFrame(frame).x(1.0).y(2.0);
    return object(box).message(8).message(1).message(2);
  }

  private ProtobufFields object(ObjectDescription object) throws IOException {
    return named(of(Channels.OBJECTS, new ObjectList().objects(List.of(object))), "/rover/objects")
        .messages(2)
        .get(0);
  }

  @Test
  void write_objectOnAGrid_isPlacedOnTheMap() throws IOException {
    of(Channels.STATE, state());
    Geodetic place = new Geodetic(11.001, 48.0, 400.0);
    ReferenceFrame grid = UtmGrid.frameAt(place);
    Point at = new UtmGrid(grid).grid(place);
    Box box = new Box().length(4.0).width(2.0).height(1.0);
    box.uid("hut").referenceFrame(grid).x(at.x()).y(at.y()).z(at.z());
    assertVector(object(box).message(8).message(1).message(1), 74.63, 0.0, 0.0);
  }

  @Test
  void write_stateOnAGrid_isItsPlaceOnTheEarth() throws IOException {
    StateInformation onGrid = state().in(UtmGrid.frameAt(new Geodetic(11.0, 48.0, 0.0)));
    ProtobufFields fix = named(of(Channels.STATE, onGrid), "/rover/location");
    assertThat(fix.number(1)).isCloseTo(48.0, within(1e-9));
    assertThat(fix.number(2)).isCloseTo(11.0, within(1e-9));
  }
}
