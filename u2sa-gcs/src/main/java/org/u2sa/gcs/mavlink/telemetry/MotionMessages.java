package org.u2sa.gcs.mavlink.telemetry;

import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.AttitudeQuaternion;
import io.dronefleet.mavlink.common.EstimatorStatus;
import io.dronefleet.mavlink.common.EstimatorStatusFlags;
import io.dronefleet.mavlink.common.GlobalPositionInt;
import io.dronefleet.mavlink.common.GpsFixType;
import io.dronefleet.mavlink.common.GpsRawInt;
import io.dronefleet.mavlink.common.LocalPositionNed;
import io.dronefleet.mavlink.common.VfrHud;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** Messages about position, velocity and attitude. Messages of unknown quantities are absent. */
final class MotionMessages {
  private static final double E7 = 1.0e7;
  private static final double MILLI = 1000.0;
  private static final double CENTI = 100.0;
  private static final double FULL_TURN_DEG = 360.0;
  private static final int UNKNOWN_16 = 0xFFFF;
  private static final int UNKNOWN_8 = 0xFF;

  private final Placement placement;
  private final Uptime uptime;

  MotionMessages(Placement placement, Uptime uptime) {
    this.placement = placement;
    this.uptime = uptime;
  }

  Optional<Object> globalPosition() {
    return placement
        .global()
        .map(
            state -> {
              Point velocity = placement.velocity().orElse(Point.of(0.0, 0.0, 0.0));
              double altitudeM = state.z().orElse(0.0);
              double homeM = placement.home().map(Geodetic::altitudeM).orElse(altitudeM);
              return GlobalPositionInt.builder()
                  .timeBootMs(uptime.millis())
                  .lat(scaled(state.y().getAsDouble(), E7))
                  .lon(scaled(state.x().getAsDouble(), E7))
                  .alt(scaled(altitudeM, MILLI))
                  .relativeAlt(scaled(altitudeM - homeM, MILLI))
                  .vx(small(velocity.x()))
                  .vy(small(velocity.y()))
                  .vz(small(velocity.z()))
                  .hdg(state.psi().isPresent() ? headingCentiDeg(state) : UNKNOWN_16)
                  .build();
            });
  }

  /** The estimate as a GPS fix, because stations need one to draw the vehicle. */
  Optional<Object> gps() {
    return placement
        .global()
        .map(
            state -> {
              Optional<Point> velocity = placement.velocity();
              return GpsRawInt.builder()
                  .timeUsec(BigInteger.valueOf(uptime.micros()))
                  .fixType(GpsFixType.GPS_FIX_TYPE_3D_FIX)
                  .lat(scaled(state.y().getAsDouble(), E7))
                  .lon(scaled(state.x().getAsDouble(), E7))
                  .alt(scaled(state.z().orElse(0.0), MILLI))
                  .eph(UNKNOWN_16)
                  .epv(UNKNOWN_16)
                  .vel(velocity.map(v -> (int) (speed(v) * CENTI)).orElse(UNKNOWN_16))
                  .cog(velocity.map(MotionMessages::courseCentiDeg).orElse(UNKNOWN_16))
                  .satellitesVisible(UNKNOWN_8)
                  .hAcc(millis(horizontalSigma(state)))
                  .vAcc(millis(state.zSigma()))
                  .build();
            });
  }

  Optional<Object> localPosition() {
    return placement
        .local()
        .map(
            ned ->
                LocalPositionNed.builder()
                    .timeBootMs(uptime.millis())
                    .x((float) ned.x().getAsDouble())
                    .y((float) ned.y().getAsDouble())
                    .z((float) ned.z().orElse(0.0))
                    .vx((float) ned.xDot().orElse(0.0))
                    .vy((float) ned.yDot().orElse(0.0))
                    .vz((float) ned.zDot().orElse(0.0))
                    .build());
  }

  Optional<Object> attitude() {
    return placement
        .attitude()
        .map(
            state ->
                Attitude.builder()
                    .timeBootMs(uptime.millis())
                    .roll((float) state.phi().orElse(0.0))
                    .pitch((float) state.theta().orElse(0.0))
                    .yaw((float) Math.IEEEremainder(state.psi().getAsDouble(), 2.0 * Math.PI))
                    .rollspeed((float) state.phiDot().orElse(0.0))
                    .pitchspeed((float) state.thetaDot().orElse(0.0))
                    .yawspeed((float) state.psiDot().orElse(0.0))
                    .build());
  }

  Optional<Object> quaternion() {
    return placement
        .attitude()
        .map(
            state -> {
              // Euler angles z, y, x to a quaternion (Stevens & Lewis, 2nd ed., eq. 1.3-33)
              double r = state.phi().orElse(0.0) / 2.0;
              double p = state.theta().orElse(0.0) / 2.0;
              double y = state.psi().getAsDouble() / 2.0;
              double cr = Math.cos(r);
              double sr = Math.sin(r);
              double cp = Math.cos(p);
              double sp = Math.sin(p);
              double cy = Math.cos(y);
              double sy = Math.sin(y);
              return AttitudeQuaternion.builder()
                  .timeBootMs(uptime.millis())
                  .q1((float) (cr * cp * cy + sr * sp * sy))
                  .q2((float) (sr * cp * cy - cr * sp * sy))
                  .q3((float) (cr * sp * cy + sr * cp * sy))
                  .q4((float) (cr * cp * sy - sr * sp * cy))
                  .rollspeed((float) state.phiDot().orElse(0.0))
                  .pitchspeed((float) state.thetaDot().orElse(0.0))
                  .yawspeed((float) state.psiDot().orElse(0.0))
                  .reprOffsetQ(List.of(0.0f, 0.0f, 0.0f, 0.0f))
                  .build();
            });
  }

  Optional<Object> hud(OptionalDouble throttlePercent) {
    return placement
        .attitude()
        .map(
            state -> {
              Optional<Point> velocity = placement.velocity();
              double ground = velocity.map(MotionMessages::speed).orElse(0.0);
              double air = fluidSpeed(state, velocity).orElse(0.0);
              return VfrHud.builder()
                  .airspeed((float) air)
                  .groundspeed((float) ground)
                  .heading(headingCentiDeg(state) / (int) CENTI)
                  .throttle((int) Math.round(throttlePercent.orElse(0.0)))
                  .alt(
                      (float)
                          placement
                              .global()
                              .flatMap(MotionMessages::altitude)
                              .orElse(0.0)
                              .doubleValue())
                  .climb((float) -velocity.map(Point::z).orElse(0.0).doubleValue())
                  .build();
            });
  }

  /** Calibrated airspeed, or speed through the water, or else over ground [m/s]. */
  static OptionalDouble fluidSpeed(StateInformation state, Optional<Point> velocity) {
    OptionalDouble through =
        state instanceof AircraftState aircraft ? aircraft.calibratedAirspeed() : state.fluidxDot();
    return through.isPresent() || velocity.isEmpty()
        ? through
        : OptionalDouble.of(speed(velocity.get()));
  }

  private static Optional<Double> altitude(StateInformation global) {
    return global.z().isPresent() ? Optional.of(global.z().getAsDouble()) : Optional.empty();
  }

  Optional<Object> estimator() {
    return placement
        .local()
        .map(
            ned -> {
              boolean global = placement.global().isPresent();
              int flags =
                  bit(EstimatorStatusFlags.ESTIMATOR_ATTITUDE, ned.psi().isPresent())
                      | bit(EstimatorStatusFlags.ESTIMATOR_VELOCITY_HORIZ, ned.xDot().isPresent())
                      | bit(EstimatorStatusFlags.ESTIMATOR_VELOCITY_VERT, ned.zDot().isPresent())
                      | bit(EstimatorStatusFlags.ESTIMATOR_POS_HORIZ_REL, true)
                      | bit(EstimatorStatusFlags.ESTIMATOR_POS_HORIZ_ABS, global)
                      | bit(EstimatorStatusFlags.ESTIMATOR_POS_VERT_ABS, global);
              return EstimatorStatus.builder()
                  .timeUsec(BigInteger.valueOf(uptime.micros()))
                  .flags(EnumValue.create(EstimatorStatusFlags.class, flags))
                  .posHorizAccuracy((float) horizontalSigma(ned).orElse(0.0))
                  .posVertAccuracy((float) ned.zSigma().orElse(0.0))
                  .build();
            });
  }

  private static int bit(EstimatorStatusFlags flag, boolean isSet) {
    return isSet ? EnumValue.of(flag).value() : 0;
  }

  private static OptionalDouble horizontalSigma(StateInformation state) {
    return state.xSigma().isPresent() && state.ySigma().isPresent()
        ? OptionalDouble.of(Math.max(state.xSigma().getAsDouble(), state.ySigma().getAsDouble()))
        : OptionalDouble.empty();
  }

  private static long millis(OptionalDouble metres) {
    return Math.min(Integer.MAX_VALUE, Math.round(metres.orElse(0.0) * MILLI));
  }

  private static double speed(Point velocity) {
    return Math.hypot(velocity.x(), velocity.y());
  }

  private static int courseCentiDeg(Point velocity) {
    return centiDeg(Math.atan2(velocity.y(), velocity.x()));
  }

  private static int headingCentiDeg(StateInformation state) {
    return centiDeg(state.psi().orElse(0.0));
  }

  private static int centiDeg(double rad) {
    double deg = Math.toDegrees(rad) % FULL_TURN_DEG;
    return (int) Math.round((deg < 0.0 ? deg + FULL_TURN_DEG : deg) * CENTI)
        % (int) (FULL_TURN_DEG * CENTI);
  }

  static int scaled(double value, double scale) {
    return (int) Math.round(value * scale); // no value exceeds an int's range
  }

  /** Speed [cm/s] in 16 bits. */
  private static int small(double metresPerSecond) {
    return (int)
        Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.round(metresPerSecond * CENTI)));
  }
}
