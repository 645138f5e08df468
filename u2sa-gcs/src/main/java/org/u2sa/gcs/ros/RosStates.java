package org.u2sa.gcs.ros;

import static org.u2sa.gcs.ros.RosSpelling.fields;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.schema.U2SAData;

/** States and measurements as standard ROS messages, in the axes of REP 103. */
final class RosStates {
  private static final int POSE_SIDE = 6; // x, y, z, and rotations about them
  private static final long NANOS_PER_MICRO = 1_000L;
  private static final int DIAGONAL_KNOWN = 2; // NavSatFix.COVARIANCE_TYPE_DIAGONAL_KNOWN
  private static final double UNKNOWN = -1.0; // first element of an absent estimate's covariance
  private static final double PERCENT = 100.0;

  private final RosFrames frames;

  RosStates(RosFrames frames) {
    this.frames = frames;
  }

  static RosSpelling.Time stamp(U2SAData message) {
    return new RosSpelling.Time(message.timestamp().orElse(0) * NANOS_PER_MICRO);
  }

  /** A frame name derived from a sensor's: letters, digits and underscores. */
  static String frameOf(String sensorName) {
    return sensorName.isEmpty() ? RosFrames.BASE : sensorName.replaceAll("[^A-Za-z0-9_]", "_");
  }

  /** {@code nav_msgs/Odometry}: pose in the map or odom, motion along the vehicle's axes. */
  Optional<Object> odometry(StateInformation any) {
    Optional<StateInformation> placed = RosFrames.placed(any);
    Optional<RosFrames.Pose> pose = frames.pose(any);
    if (placed.isEmpty() || pose.isEmpty()) {
      return Optional.empty();
    }
    StateInformation state = placed.get();
    boolean isLocal = state.referenceFrame().isLocal();
    Attitude attitude = RosFrames.attitude(state);
    Point velocity =
        Point.of(state.xDot().orElse(0.0), state.yDot().orElse(0.0), state.zDot().orElse(0.0));
    Rotation fluFromNed = RosFrames.FLU_FROM_FRD.times(attitude.nedFromFrd().transposed());
    Point ahead = fluFromNed.times(isLocal ? velocity : Rotation.NED_FROM_ENU.times(velocity));
    Point rates =
        RosFrames.FLU_FROM_FRD.times(
            attitude.bodyRates(
                Point.of(
                    state.phiDot().orElse(0.0),
                    state.thetaDot().orElse(0.0),
                    state.psiDot().orElse(0.0))));
    List<OptionalDouble> sigmas =
        List.of(
            isLocal ? state.ySigma() : state.xSigma(),
            isLocal ? state.xSigma() : state.ySigma(),
            state.zSigma(),
            state.phiSigma(),
            state.thetaSigma(),
            state.psiSigma());
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(stamp(any), pose.get().frame()),
            "child_frame_id",
            RosFrames.BASE,
            "pose",
            fields("pose", pose.get().fields(), "covariance", diagonal(sigmas)),
            "twist",
            fields(
                "twist",
                fields("linear", RosFrames.xyz(ahead), "angular", RosFrames.xyz(rates)),
                "covariance",
                zeros(POSE_SIDE * POSE_SIDE))));
  }

  /** {@code sensor_msgs/NavSatFix} of a measured global position. */
  static Optional<Object> fix(StateInformation measured) {
    if (!measured.referenceFrame().isEarth() || measured.x().isEmpty() || measured.y().isEmpty()) {
      return Optional.empty();
    }
    StateInformation state = measured.in(ReferenceFrame.GLOBAL);
    boolean known =
        state.xSigma().isPresent() && state.ySigma().isPresent() && state.zSigma().isPresent();
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(stamp(measured), frameOf(measured.sensorName())),
            "status",
            fields("status", 0, "service", 1), // a fix, by GPS
            "latitude",
            state.y().getAsDouble(),
            "longitude",
            state.x().getAsDouble(),
            "altitude",
            state.z().orElse(Double.NaN),
            "position_covariance",
            diagonal(List.of(state.xSigma(), state.ySigma(), state.zSigma())),
            "position_covariance_type",
            known ? DIAGONAL_KNOWN : 0));
  }

  /** {@code sensor_msgs/Imu} of rates and specific forces. */
  static Optional<Object> imu(InertialMeasurement any) {
    StateInformation frd = any.in(ReferenceFrame.BODY_FRD);
    if (!(frd instanceof InertialMeasurement imu)) {
      return Optional.empty();
    }
    Point rates = flu(imu.rollRate(), imu.pitchRate(), imu.yawRate());
    Point forces = flu(imu.specificForceX(), imu.specificForceY(), imu.specificForceZ());
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(stamp(any), frameOf(any.sensorName())),
            "orientation",
            RosFrames.upright(),
            "orientation_covariance",
            absent(),
            "angular_velocity",
            RosFrames.xyz(rates),
            "angular_velocity_covariance",
            imu.rollRate().isPresent() ? same(imu.angularRateSigma()) : absent(),
            "linear_acceleration",
            RosFrames.xyz(forces),
            "linear_acceleration_covariance",
            imu.specificForceX().isPresent() ? same(imu.specificForceSigma()) : absent()));
  }

  private static Point flu(OptionalDouble x, OptionalDouble y, OptionalDouble z) {
    return Point.of(x.orElse(0.0), -y.orElse(0.0), -z.orElse(0.0));
  }

  /** {@code sensor_msgs/BatteryState}; ROS counts a discharging current as negative. */
  static Optional<Object> battery(BatteryState battery) {
    double nan = Double.NaN;
    OptionalDouble current = battery.current();
    return Optional.of(
        fields(
            "header",
            new RosSpelling.Header(stamp(battery), frameOf(battery.sensorName())),
            "voltage",
            battery.voltage().orElse(nan),
            "temperature",
            nan,
            "current",
            current.isPresent() ? -current.getAsDouble() : nan,
            "charge",
            nan,
            "capacity",
            nan,
            "design_capacity",
            nan,
            "percentage",
            battery.remaining().isPresent() ? battery.remaining().getAsDouble() / PERCENT : nan,
            "power_supply_status",
            0,
            "power_supply_health",
            0,
            "power_supply_technology",
            0,
            "present",
            true,
            "cell_voltage",
            List.of(),
            "cell_temperature",
            List.of(),
            "location",
            battery.sensorName(),
            "serial_number",
            ""));
  }

  /** {@code rosgraph_msgs/Clock}: the run's clock, which a simulation sets. */
  static Optional<Object> clock(U2SAData message) {
    return Optional.of(fields("clock", stamp(message)));
  }

  /** {@code tf2_msgs/TFMessage} of the vehicle. */
  Optional<Object> transforms(StateInformation state) {
    RosSpelling.Time stamp = stamp(state);
    return frames
        .pose(state)
        .map(
            pose -> {
              Optional<RosFrames.Pose> odom =
                  pose.frame().equals(RosFrames.MAP) ? frames.odomInMap(pose) : Optional.empty();
              Map<String, Object> transform =
                  odom.map(each -> each.transform(stamp, RosFrames.ODOM))
                      .orElseGet(() -> pose.transform(stamp, RosFrames.BASE));
              return fields("transforms", List.of(transform));
            });
  }

  private static List<Object> diagonal(List<OptionalDouble> sigmas) {
    List<Object> covariance = zeros(sigmas.size() * sigmas.size());
    for (int i = 0; i < sigmas.size(); i++) {
      double sigma = sigmas.get(i).orElse(0.0);
      covariance.set(i * (sigmas.size() + 1), sigma * sigma);
    }
    return covariance;
  }

  private static List<Object> same(OptionalDouble sigma) {
    return diagonal(List.of(sigma, sigma, sigma));
  }

  private static List<Object> absent() {
    List<Object> covariance = zeros(9);
    covariance.set(0, UNKNOWN);
    return covariance;
  }

  private static List<Object> zeros(int count) {
    return new ArrayList<>(Collections.nCopies(count, 0.0));
  }
}
