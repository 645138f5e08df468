package org.u2sa.gcs.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.OptionalDouble;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.shape.Box;

/** The axes and signs of REP 103 and REP 105, against values computed by hand. */
class RosFramesTest {
  private static final Offset<Double> EXACT = within(1e-9);
  private static final double RIGHT = Math.PI / 2;

  private final RosFrames frames = new RosFrames();
  private final RosStates states = new RosStates(frames);

  private static JsonNode json(Object message) throws Exception {
    return new ObjectMapper().readTree(((JsonText) RosSpelling.ROS_2.json(message)).line());
  }

  private static StateInformation eastward() {
    return new StateInformation()
        .x(8.0)
        .y(50.0)
        .z(0.0)
        .psi(RIGHT)
        .xDot(2.0)
        .psiDot(0.1)
        .xSigma(3.0);
  }

  @Test
  void odometry_headingEast_hasYawZeroAndMovesForward() throws Exception {
    JsonNode odometry = json(states.odometry(eastward()).orElseThrow());

    JsonNode pose = odometry.get("pose").get("pose");
    assertThat(Math.abs(pose.get("orientation").get("w").asDouble())).isEqualTo(1.0, EXACT);
    JsonNode twist = odometry.get("twist").get("twist");
    assertThat(twist.get("linear").get("x").asDouble()).isEqualTo(2.0, EXACT);
    assertThat(twist.get("linear").get("y").asDouble()).isEqualTo(0.0, EXACT);
    assertThat(twist.get("angular").get("z").asDouble()).isEqualTo(-0.1, EXACT); // to the right
    assertThat(odometry.get("pose").get("covariance").get(0).asDouble()).isEqualTo(9.0);
    assertThat(odometry.get("pose").get("covariance")).hasSize(36);
  }

  @Test
  void odometry_localNorthEastDown_isEastNorthUpInOdom() throws Exception {
    StateInformation state =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(1.0).y(2.0).z(3.0);

    JsonNode odometry = json(states.odometry(state.psi(0.0).xDot(4.0)).orElseThrow());

    assertThat(odometry.get("header").get("frame_id").asText()).isEqualTo("odom");
    assertThat(odometry.get("pose").get("pose").get("position").toString())
        .isEqualTo("{\"x\":2.0,\"y\":1.0,\"z\":-3.0}");
    assertThat(odometry.get("twist").get("twist").get("linear").get("x").asDouble())
        .isEqualTo(4.0, EXACT);
  }

  @Test
  void odomInMap_composedWithThePoseInOdom_isThePoseInTheMap() {
    RosFrames.Pose inOdom =
        frames
            .pose(
                new StateInformation()
                    .referenceFrame(ReferenceFrame.LOCAL_NED)
                    .x(5.0)
                    .y(-2.0)
                    .z(0.5)
                    .psi(0.7)
                    .theta(0.1))
            .orElseThrow();
    frames.pose(eastward());
    RosFrames.Pose inMap =
        frames
            .pose(new StateInformation().x(8.001).y(50.001).z(2.0).psi(1.1).phi(0.2))
            .orElseThrow();

    RosFrames.Pose odom = frames.odomInMap(inMap).orElseThrow();

    Point composed = odom.position().plus(odom.turn().times(inOdom.position()));
    assertThat(composed.distanceTo(inMap.position())).isLessThan(1e-9);
    Rotation turn = odom.turn().times(inOdom.turn());
    Point ahead = Point.of(1.0, 0.0, 0.0);
    assertThat(turn.times(ahead).distanceTo(inMap.turn().times(ahead))).isLessThan(1e-12);
  }

  @Test
  void imu_levelAndAtRest_measuresGravityUpwards() throws Exception {
    InertialMeasurement measured =
        new InertialMeasurement().specificForceX(0.0).specificForceY(1.0).specificForceZ(-9.81);

    JsonNode imu =
        json(RosStates.imu(measured.yawRate(0.3).rollRate(0.0).pitchRate(0.0)).orElseThrow());

    assertThat(imu.get("linear_acceleration").get("z").asDouble()).isEqualTo(9.81, EXACT);
    assertThat(imu.get("linear_acceleration").get("y").asDouble()).isEqualTo(-1.0, EXACT);
    assertThat(imu.get("angular_velocity").get("z").asDouble()).isEqualTo(-0.3, EXACT);
    assertThat(imu.get("orientation_covariance").get(0).asDouble()).isEqualTo(-1.0);
  }

  @Test
  void scan_missingEcho_isNullAndPointsAreAroundTheVehicle() throws Exception {
    RangeScan scan =
        new RangeScan()
            .sensorName("Front lidar")
            .x(0.5)
            .z(-1.0)
            .psi(RIGHT)
            .maxRange(10.0)
            .beams(0.0, 0.1, List.of(OptionalDouble.of(2.0), OptionalDouble.empty()));

    JsonNode ros = json(RosScenes.scan(scan).orElseThrow());
    JsonNode transform =
        json(new RosScenes(frames).scanner(scan).orElseThrow()).get("transforms").get(0);

    assertThat(ros.get("ranges").toString()).isEqualTo("[2.0,null]");
    assertThat(ros.get("header").get("frame_id").asText()).isEqualTo("Front_lidar");
    assertThat(transform.get("child_frame_id").asText()).isEqualTo("Front_lidar");
    assertThat(transform.get("transform").get("translation").get("z").asDouble()).isEqualTo(1.0);
    double sin = transform.get("transform").get("rotation").get("z").asDouble();
    double cos = transform.get("transform").get("rotation").get("w").asDouble();
    assertThat(2.0 * Math.atan2(sin, cos)).isEqualTo(RIGHT, EXACT); // to the left is positive
  }

  @Test
  void battery_discharging_hasANegativeCurrentAndAFraction() throws Exception {
    BatteryState state =
        new BatteryState().sensorName("pack").voltage(12.0).current(3.0).remaining(40.0);

    JsonNode battery = json(RosStates.battery(state).orElseThrow());

    assertThat(battery.get("current").asDouble()).isEqualTo(-3.0);
    assertThat(battery.get("percentage").asDouble()).isEqualTo(0.4);
    assertThat(battery.get("temperature").isNull()).isTrue();
  }

  @Test
  void imu_forwardLeftUp_keepsItsAxes() throws Exception {
    InertialMeasurement measured = new InertialMeasurement();
    measured.referenceFrame(ReferenceFrame.BODY_FLU);

    JsonNode imu =
        json(
            RosStates.imu(measured.specificForceY(1.0).specificForceZ(9.81).yawRate(0.3))
                .orElseThrow());

    assertThat(imu.get("linear_acceleration").get("y").asDouble()).isEqualTo(1.0, EXACT);
    assertThat(imu.get("linear_acceleration").get("z").asDouble()).isEqualTo(9.81, EXACT);
    assertThat(imu.get("angular_velocity").get("z").asDouble()).isEqualTo(0.3, EXACT);
  }

  @Test
  void markers_boxInAnyAxes_turnsCounterclockwiseFromX() throws Exception {
    assertThat(yaw(ReferenceFrame.LOCAL_ENU, 0.3)).isEqualTo(0.3, EXACT);
    assertThat(yaw(ReferenceFrame.LOCAL_NED, RIGHT - 0.3)).isEqualTo(0.3, EXACT);
    assertThat(yaw(ReferenceFrame.BODY, 0.3)).isEqualTo(0.3, EXACT);
    assertThat(yaw(ReferenceFrame.BODY_FLU, 0.3)).isEqualTo(0.3, EXACT);
    assertThat(yaw(ReferenceFrame.BODY_FRD, -0.3)).isEqualTo(0.3, EXACT);
  }

  private double yaw(ReferenceFrame frame, double psi) throws Exception {
    Box box = new Box().length(4.0).width(2.0).height(1.0).psi(psi);
    box.uid("hut").referenceFrame(frame).x(1.0).y(2.0);
    JsonNode markers =
        json(new RosMarkers(frames).of(new ObjectList().objects(List.of(box))).orElseThrow());
    JsonNode q = markers.get("markers").get(1).get("pose").get("orientation");
    return 2.0 * Math.atan2(q.get("z").asDouble(), q.get("w").asDouble());
  }
}
